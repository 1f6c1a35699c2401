// What is shown while something is dragged, curves and profiles redrawn in part, areas, handles.
#include "EditSystem.h"

#include "Harness/shapes.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkPolyDataNormals.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <string>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

vtkSmartPointer<vtkPolyData> withNormals(vtkPolyData* mesh)
{
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputData(mesh);
  normals->SplittingOff();
  normals->ComputeCellNormalsOn();
  normals->Update();
  vtkSmartPointer<vtkPolyData> result = normals->GetOutput();
  return result;
}

// The points, and the normals where the mesh has some, to the bit.
void expectShown(vtkPolyData* shown, vtkPolyData* output)
{
  ASSERT_GT(output->GetNumberOfPoints(), 0);
  EXPECT_TRUE(sameValues(shown->GetPoints()->GetData(), output->GetPoints()->GetData()));
  EXPECT_TRUE(identical(shown, output));
  if (vtkDataArray* normals = output->GetPointData()->GetNormals())
  {
    EXPECT_TRUE(sameValues(shown->GetPointData()->GetNormals(), normals));
  }
  if (vtkDataArray* normals = output->GetCellData()->GetNormals())
  {
    EXPECT_TRUE(sameValues(shown->GetCellData()->GetNormals(), normals));
  }
}

// The view turned about the vertical through the model's middle.
View turnedView(vtkPolyData* mesh, const View& view, double degrees)
{
  const Vector3 middle(mesh->GetCenter());
  Eigen::Affine3d turn = Eigen::Translation3d(middle) *
                         Eigen::AngleAxisd(degrees * pi / 180.0, Vector3::UnitY()) *
                         Eigen::Translation3d(-middle);
  return View(view.viewTransform() * turn.matrix(), view.projectionTransform(), view.width(), view.height());
}

std::vector<Vector2> arc(double radius, double from, double to)
{
  std::vector<Vector2> samples;
  for (int i = 0; i <= 40; ++i)
  {
    const double a = (from + (to - from) * i / 40.0) * pi / 180.0;
    samples.emplace_back(400.0 + 1.2 * radius * std::cos(a), 300.0 + radius * std::sin(a));
  }
  return samples;
}

// The sine of half a turn over the section, `height` high; only the part from `begin` to `end` of its way.
vtkSmartPointer<vtkPolyData> profileOf(const std::vector<std::array<double, 3>>& strokes)
{
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const auto& [begin, end, height] : strokes)
  {
    lines->InsertNextCell(101);
    for (int i = 0; i <= 100; ++i)
    {
      const double t = begin + (end - begin) * i / 100.0;
      lines->InsertCellPoint(points->InsertNextPoint(t, height * std::sin(pi * t), 0.0));
    }
  }
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  return drawn;
}

vtkSmartPointer<vtkPolyData> squareOnDisc(double half)
{
  auto area = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(4);
  for (const auto& [x, y] : { std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1) })
  {
    lines->InsertCellPoint(points->InsertNextPoint(half * x, half * y, 0.0));
  }
  area->SetPoints(points);
  area->SetLines(lines);
  return area;
}

} // namespace

// Whatever was shown before, also of another edit.
TEST(EditPreview, TheLastOneIsTheResultWithoutNewTriangles)
{
  for (const bool hasNormals : { false, true })
  {
    const auto model = shippedModel("bear");
    EditSystem s(hasNormals ? withNormals(model) : model);
    EXPECT_TRUE(s.filter->Prepare());
    vtkNew<vtkPolyData> shown;
    for (const double share : { 0.01, 0.03, 0.02 })
    {
      s.operate("move 0.5 n %.9g; rotate 0.3 t 10", share);
      ASSERT_TRUE(s.filter->PreviewEdit(shown));
    }
    EXPECT_EQ(shown->GetPointData()->GetNormals()->GetNumberOfTuples(), shown->GetNumberOfPoints());
    const auto last = deepCopy(shown);
    s.filter->SetRule(vtkOversketchEdit::Off);
    vtkPolyData* output = s.run();
    EXPECT_NE(output->GetPoints(), shown->GetPoints());
    expectShown(shown, output);
    s.filter->SetRule(vtkOversketchEdit::Edit);
    s.run(); // new triangles leave it
    expectShown(last, shown);

    // A further one leaves what came out.
    const auto before = deepCopy(s.filter->GetOutput());
    s.filter->SetLayers("handle 0.4 0.7");
    ASSERT_TRUE(s.filter->PreviewEdit(shown));
    expectSameBits(s.filter->GetOutput(), before);
    EXPECT_FALSE(sameValues(shown->GetPoints()->GetData(), last->GetPoints()->GetData()));
    s.filter->SetRule(vtkOversketchEdit::Off);
    expectShown(shown, s.run());

    // Cold, and of a profile.
    s.filter->SetOperations("");
    s.filter->SetProfileData(profileOf({ { 0.0, 1.0, 0.4 } }));
    EditSystem cold(s.mesh);
    cold.filter->SetLayers("handle 0.4 0.7");
    cold.filter->SetProfileData(profileOf({ { 0.0, 1.0, 0.4 } }));
    vtkNew<vtkPolyData> fresh;
    ASSERT_TRUE(s.filter->PreviewEdit(shown));
    ASSERT_TRUE(cold.filter->PreviewEdit(fresh));
    expectShown(shown, s.run());
    expectShown(fresh, shown);
  }
}

// Normals shown are those of the surface shown.
TEST(EditPreview, NormalsAreOfTheMovedSurface)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.03);
  vtkNew<vtkPolyData> shown;
  ASSERT_TRUE(s.filter->PreviewEdit(shown));
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(shown->GetPoints());
  bare->SetPolys(shown->GetPolys());
  const auto data = oversketch::SharedMesh(bare);
  double worst = 0.0;
  for (vtkIdType i = 0; i < shown->GetNumberOfPoints(); ++i)
  {
    const Vector3 shownNormal(shown->GetPointData()->GetNormals()->GetTuple3(i));
    worst = std::max(worst, (shownNormal - data->Normals()[static_cast<std::size_t>(i)]).norm());
  }
  EXPECT_LT(worst, 1e-5);
}

// What is prepared before there is a line spares those of the whole mesh with line and ring.
TEST(EditPreview, NormalsArePreparedOnce)
{
  const oversketch::MeshWork& work = oversketch::MeshWorkDone();
  for (const bool isPrepared : { false, true })
  {
    EditSystem s(toPolyData(icosphere(6)), lineOver(60.0), ringOver(90.0)); // fine enough for both
    if (isPrepared)
    {
      s.filter->SetReferenceData(nullptr);
      s.filter->SetBoundaryData(nullptr);
      EXPECT_TRUE(s.filter->Prepare());
      s.filter->SetReferenceData(s.reference);
      EXPECT_TRUE(s.filter->Prepare());
      s.filter->SetBoundaryData(s.boundary);
    }
    const int normals = work.Normals;
    s.run();
    EXPECT_EQ(work.Normals - normals, isPrepared ? 0 : 1);
  }
}

TEST(EditPreview, ADragRunsNoSolveAndGrowsNoRegion)
{
  EditSystem s(shippedModel("bear"));
  ASSERT_TRUE(s.filter->Prepare());
  Executions count(s.filter);
  vtkNew<vtkPolyData> shown;
  const auto start = deepCopy(s.mesh);
  vtkPoints* points = nullptr;
  vtkCellArray* cells = nullptr;
  for (int i = 1; i <= 5; ++i)
  {
    ASSERT_TRUE(s.filter->DragLine(3.0 * i, -2.0 * i, shown));
    EXPECT_EQ(count.Ran(), (Steps{ "Handles", "Deform" })) << i;
    EXPECT_TRUE(i == 1 || shown->GetPoints() == points); // written over
    EXPECT_TRUE(i == 1 || shown->GetPolys() == cells);
    points = shown->GetPoints();
    cells = shown->GetPolys();
  }
  EXPECT_STREQ(s.filter->GetOperations(), "");
  expectSameBits(s.mesh, start);
  s.filter->SetOperations("drag 15 -10");
  s.filter->SetRule(vtkOversketchEdit::Off);
  expectShown(shown, s.run());
  // A layer runs no solve either.
  count.Ran();
  s.filter->SetLayers("handle 0.5 0.3");
  ASSERT_TRUE(s.filter->PreviewEdit(shown));
  EXPECT_EQ(count.Ran(), (Steps{ "Shading", "Deform" }));
}

// The curve follows whole, handles or not; a pin does not hold it.
TEST(EditPreview, ADraggedLineFollowsTheHandInItsView)
{
  for (const char* operations : { "drag 12 -5", "drag 7 -3; pin 0.3; drag 5 -2; pin 0.8" })
  {
    EditSystem s(shippedModel("bear"));
    s.filter->SetRule(vtkOversketchEdit::Off);
    s.filter->SetOperations(operations);
    s.run();
    vtkNew<vtkPolyData> hold;
    s.filter->GetHold(hold);
    vtkPolyData* line = s.filter->GetReferenceOutput();
    ASSERT_EQ(hold->GetNumberOfPoints(), line->GetNumberOfPoints());
    for (vtkIdType i = 0; i < hold->GetNumberOfPoints(); ++i)
    {
      const Vector3 from = s.view.toDisplay(placeOf(hold, i)), to = s.view.toDisplay(placeOf(line, i));
      EXPECT_LT((to - from - Vector3(12.0, -5.0, 0.0)).norm(), 1e-3) << operations << " point " << i; // float
    }
  }
}

TEST(EditPreview, WhatCannotBeShownSaysWhy)
{
  EditSystem s(shippedModel("bear"));
  vtkNew<vtkPolyData> shown;
  vtkNew<vtkOversketchEdit> bare;
  EXPECT_FALSE(bare->Prepare());
  EXPECT_FALSE(bare->PreviewEdit(shown));
  bare->SetInputData(0, s.mesh);
  EXPECT_TRUE(bare->Prepare());
  EXPECT_FALSE(bare->PreviewEdit(shown));
  bare->SetReferenceData(s.reference);
  EXPECT_TRUE(bare->Prepare());
  EXPECT_GT(bare->GetInnerOutput("ReferenceInsert")->GetNumberOfPoints(), 0);
  EXPECT_FALSE(bare->PreviewEdit(shown));
  EXPECT_EQ(shown->GetNumberOfPoints(), 0);
  s.filter->SetOperations("rotate 0.5 t 180");
  EXPECT_FALSE(s.filter->PreviewEdit(shown));
  EXPECT_EQ(
    s.filter->GetErrorCode(), vtkErrorCode::UserError + static_cast<unsigned long>(Failure::BadStroke));
  EXPECT_EQ(shown->GetNumberOfPoints(), 0);
  s.operate("move 0.5 n %.9g", 0.01);
  EXPECT_TRUE(s.filter->PreviewEdit(shown));
  EXPECT_GT(shown->GetNumberOfPoints(), 0);
}

// B 4: the part that the stroke was drawn over is where the stroke is, the rest keeps its vertices.
TEST(EditRedrawn, ARingIsRedrawnInPart)
{
  for (const double turned : { 0.0, 15.0 })
  {
    EditSystem s(shippedModel("bear"), lineOver(40.0), ringOver(45.0));
    s.operate("move 0.5 n %.9g", 0.02);
    s.run();
    vtkPolyData* first =
      vtkPolyData::SafeDownCast(s.filter->GetStep("BoundaryInsert")->GetOutputDataObject(1));
    const auto old = deepCopy(first);
    Executions count(s.filter);
    const View view = turnedView(s.mesh, s.view, turned);
    const std::vector<Vector2> fresh = arc(52.0, -35.0, 35.0);
    s.filter->SetBoundaryData(toStrokes({ { ringOver(45.0), s.view }, { fresh, view } }));
    s.run();
    const Steps ran = count.Ran();
    EXPECT_EQ(ran.count("BoundaryInsert") + ran.count("BoundaryProject") + ran.count("ReferenceInsert"), 0u);
    EXPECT_EQ(ran.count("Resketch") + ran.count("Reproject") + ran.count("Reinsert"), 3u);
    vtkPolyData* ring = vtkPolyData::SafeDownCast(s.filter->GetStep("Reinsert")->GetOutputDataObject(1));

    // On the left it is the old one, but that the mesh's points are floats.
    int left = 0;
    for (vtkIdType i = 0; i < old->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(old, i);
      if (s.view.toDisplay(p)[0] < 390.0)
      {
        ++left;
        EXPECT_LT(distanceTo(ring, p), 1e-7 * s.diagonal()) << i;
      }
    }
    EXPECT_GT(left, 5);
    // The stroke has the ring under it, and at its middle the old one is gone.
    double worst = 0.0;
    for (std::size_t k = 5; k + 5 < fresh.size(); ++k)
    {
      double least = HUGE_VAL;
      for (vtkIdType i = 0; i < ring->GetNumberOfPoints(); ++i)
      {
        const Vector2 a = view.toDisplay(placeOf(ring, i)).head<2>();
        const Vector2 b = view.toDisplay(placeOf(ring, (i + 1) % ring->GetNumberOfPoints())).head<2>();
        const double t = std::clamp((fresh[k] - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        least = std::min(least, (a + t * (b - a) - fresh[k]).norm());
      }
      worst = std::max(worst, least);
    }
    EXPECT_LT(worst, 4.0) << turned;
    if (turned == 0.0)
    {
      for (vtkIdType i = 0; i < ring->GetNumberOfPoints(); ++i)
      {
        const Vector2 p = s.view.toDisplay(placeOf(ring, i)).head<2>() - Vector2(400.0, 300.0);
        EXPECT_FALSE(p[0] > 0.0 && std::abs(p[1]) < 15.0 && p[0] < 1.2 * 48.0) << p.transpose();
      }
    }
    EXPECT_GT(s.filter->GetMovedPoints(), 0);
    EXPECT_EQ(eulerNumber(s.filter->GetOutput()), eulerNumber(s.mesh));
  }
}

TEST(EditRedrawn, ALineIsDrawnOnAndStrokesActInTheirOrder)
{
  EditSystem s(shippedModel("bear"), straight({ 370, 300 }, { 410, 300 }, 30), ringOver(55.0));
  const std::vector<Vector2> on = straight({ 404, 301 }, { 436, 312 }, 20);
  const std::vector<Vector2> bump = { { 380, 300 }, { 390, 312 }, { 400, 300 } };
  s.operate("move 0.5 n %.9g", 0.01);
  s.filter->SetReferenceData(
    toStrokes({ { straight({ 370, 300 }, { 410, 300 }, 30), s.view }, { on, s.view }, { bump, s.view } }));
  s.run();
  vtkNew<vtkPolyData> line;
  s.filter->GetHold(line);
  const vtkIdType last = line->GetNumberOfPoints() - 1;
  const auto seen = [&](vtkIdType i) { return Vector2(s.view.toDisplay(placeOf(line, i)).head<2>()); };
  EXPECT_LT((seen(0) - Vector2(370, 300)).norm(), 4.0); // its direction stays
  EXPECT_LT((seen(last) - Vector2(436, 312)).norm(), 4.0);
  double highest = 0.0;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    highest = seen(i)[0] < 405.0 ? std::max(highest, seen(i)[1]) : highest;
  }
  EXPECT_GT(highest, 303.5); // the spline stays in its control points' hull
  // It can be dragged in its first view.
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.filter->SetOperations("drag 10 0");
  s.run();
  EXPECT_NEAR(s.view.toDisplay(placeOf(s.filter->GetReferenceOutput(), last))[0] - seen(last)[0], 10.0, 1e-3);
  // What is the second now was the third, and the second is not drawn.
  Executions count(s.filter);
  s.filter->SetReferenceData(
    toStrokes({ { straight({ 370, 300 }, { 410, 300 }, 30), s.view }, { bump, s.view } }));
  s.run();
  EXPECT_EQ(count.Ran().count("ReferenceInsert"), 0u);
  vtkNew<vtkPolyData> shorter;
  s.filter->GetHold(shorter);
  const Vector2 end = s.view.toDisplay(placeOf(shorter, shorter->GetNumberOfPoints() - 1)).head<2>();
  EXPECT_LT((end - Vector2(410, 300)).norm(), 4.0);
}

TEST(EditRedrawn, SameBitsForAnyNumberOfThreadsAndHowItCameThere)
{
  const auto rings = [](const View& view)
  {
    return toStrokes(
      { { ringOver(45.0), view }, { arc(52.0, -35.0, 35.0), view }, { arc(48.0, 150.0, 210.0), view } });
  };
  EditSystem warm(shippedModel("bear"), lineOver(40.0), ringOver(45.0));
  warm.operate("move 0.5 n %.9g", 0.02);
  warm.run();
  warm.filter->SetBoundaryData(
    toStrokes({ { ringOver(45.0), warm.view }, { arc(52.0, -35.0, 35.0), warm.view } }));
  warm.run();
  warm.filter->SetBoundaryData(rings(warm.view));
  const auto came = deepCopy(warm.run());
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
      [&]
      {
        EditSystem cold(warm.mesh, lineOver(40.0), ringOver(45.0));
        cold.filter->SetBoundaryData(rings(cold.view));
        cold.operate("move 0.5 n %.9g", 0.02);
        expectSameBits(cold.run(), came);
      });
  }
}

// The second profile is drawn over a part of the first: what it leaves is as the first alone has it.
TEST(EditRedrawn, AProfileIsRedrawnInPart)
{
  EditSystem s(shippedModel("bear"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.filter->SetProfileData(profileOf({ { 0.0, 1.0, 0.4 } }));
  s.run();
  const auto once = deepCopy(s.filter->GetInnerOutput("Bend"));
  s.filter->SetProfileData(profileOf({ { 0.0, 1.0, 0.4 }, { 0.7, 0.9, 0.42 } }));
  s.run();
  vtkPolyData* twice = s.filter->GetInnerOutput("Bend");
  vtkPolyData* rest = s.filter->GetInnerOutput("Distance");
  ASSERT_EQ(once->GetNumberOfPoints(), twice->GetNumberOfPoints());
  double changed = 0.0;
  for (vtkIdType i = 0; i < once->GetNumberOfPoints(); ++i)
  {
    changed = std::max(changed, (placeOf(once, i) - placeOf(twice, i)).norm());
  }
  EXPECT_GT(changed, 1e-3 * s.diagonal());
  // The profile runs to the side of the frame, which is left of the line: what is on its right, before the
  // middle, is left alone.
  vtkDataArray* side = rest->GetPointData()->GetArray("CurveSide");
  vtkDataArray* distance = rest->GetPointData()->GetArray("CurveDistance");
  vtkDataArray* along = rest->GetPointData()->GetArray("CurveParameter");
  int same = 0, other = 0;
  for (vtkIdType i = 0; i < once->GetNumberOfPoints(); ++i)
  {
    const double tau = along->GetComponent(i, 0);
    if (distance->GetComponent(i, 0) < 1.0 && distance->GetComponent(i, 0) > 0.0 && tau > 0.3 && tau < 0.7)
    {
      const double moved = (placeOf(once, i) - placeOf(twice, i)).norm();
      if (side->GetComponent(i, 0) < 0.0)
      {
        ++same;
        EXPECT_LT(moved, 1e-6 * s.diagonal()) << i;
      }
      other += side->GetComponent(i, 0) > 0.0 && moved > 1e-4 * s.diagonal();
    }
  }
  EXPECT_GT(same, 0);
  EXPECT_GT(other, 0);
}

// What is outside an area has the weights that it had, to the bit.
TEST(EditAreas, AnAreaHasLayersOfItsOwn)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.02);
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.run();
  const auto plain = deepCopy(s.filter->GetInnerOutput("Shading"));
  const auto moved = deepCopy(s.filter->GetInnerOutput("Deform"));
  constexpr double half = 0.6;
  s.filter->SetAreasData(squareOnDisc(half));
  s.filter->SetLayers("area 0 9; handle 0.5 0.2");
  s.run();
  vtkPolyData* shaded = s.filter->GetInnerOutput("Shading");
  vtkPolyData* deformed = s.filter->GetInnerOutput("Deform");
  vtkDataArray* disc = shaded->GetPointData()->GetArray("DiscCoords");
  vtkDataArray* before = plain->GetPointData()->GetArray("EditWeight");
  vtkDataArray* after = shaded->GetPointData()->GetArray("EditWeight");
  int inside = 0, outside = 0;
  for (vtkIdType i = 0; i < shaded->GetNumberOfPoints(); ++i)
  {
    const double x = 2.0 * disc->GetComponent(i, 0) - 1.0, y = 2.0 * disc->GetComponent(i, 1) - 1.0;
    const double reach = std::max(std::abs(x), std::abs(y));
    const double was = before->GetComponent(i, 0), is = after->GetComponent(i, 0);
    if (reach > half + 2.0 / 512.0)
    {
      EXPECT_EQ(was, is) << i;
      EXPECT_EQ(placeOf(moved, i), placeOf(deformed, i)) << i;
      outside += was > 0.0;
    }
    else if (reach < half - 0.06 && was > 0.02 && was < 0.98)
    {
      EXPECT_LT(is, was) << i; // the layers were drawn inward
      ++inside;
    }
  }
  EXPECT_GT(inside, 0);
  EXPECT_GT(outside, 0);
  // Strokes that carry a view onto the disc are the same there.
  const Eigen::Matrix4d upright =
    (Eigen::Matrix4d() << 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -5, 0, 0, 0, 1).finished();
  Eigen::Matrix4d flat = Eigen::Matrix4d::Identity();
  flat(2, 2) = -0.1;
  const View onDisc(upright, flat, 800, 800);
  std::vector<Vector2> seen;
  for (const Vector2& corner :
    { Vector2(-half, -half), Vector2(half, -half), Vector2(half, half), Vector2(-half, half) })
  {
    seen.push_back(onDisc.toDisplay({ corner[0], corner[1], 0.0 }).head<2>());
  }
  const auto weights = deepCopy(shaded);
  s.filter->SetAreasData(toStroke(seen, onDisc));
  s.run();
  EXPECT_TRUE(sameValues(s.filter->GetInnerOutput("Shading")->GetPointData()->GetArray("EditWeight"),
    weights->GetPointData()->GetArray("EditWeight")));
  s.filter->SetLayers("area 3 9");
  expectRefusal(s.filter, Failure::BadStroke, "area");
}

// A handle of a matrix in its own axes is the operation that makes the same of it.
TEST(EditHandles, AreOperationsByTheirMatrices)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g; pin 0.9", 0.02);
  const auto written = deepCopy(s.run());
  vtkNew<vtkPolyData> handles;
  vtkNew<vtkPoints> points;
  vtkNew<vtkDoubleArray> places, matrices;
  places->SetName("CurveT");
  matrices->SetName("Matrix");
  matrices->SetNumberOfComponents(16);
  const double length = std::strtod(std::string(s.filter->GetOperations()).substr(11).c_str(), nullptr);
  for (const auto& [place, outward] : { std::pair(0.5, length), std::pair(0.9, 0.0) })
  {
    points->InsertNextPoint(0.0, 0.0, 0.0);
    places->InsertNextValue(place);
    const double matrix[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, outward, 0, 0, 0, 1 };
    matrices->InsertNextTuple(matrix);
  }
  handles->SetPoints(points);
  handles->GetPointData()->AddArray(places);
  handles->GetPointData()->AddArray(matrices);
  s.filter->SetOperations("");
  s.filter->SetHandlesData(handles);
  expectSameBits(s.run(), written);
  // Of a profile they say how far it reaches: beyond the nearest ones nothing moves.
  s.filter->SetProfileData(profileOf({ { 0.0, 1.0, 0.4 } }));
  places->SetValue(0, 0.1);
  places->Modified();
  handles->Modified();
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.run();
  vtkPolyData* rest = s.filter->GetInnerOutput("Distance");
  vtkPolyData* bent = s.filter->GetInnerOutput("Bend");
  vtkDataArray* along = rest->GetPointData()->GetArray("CurveParameter");
  int beyond = 0;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    const double tau = along->GetComponent(i, 0);
    if (tau < 0.1 || tau > 0.9)
    {
      EXPECT_EQ(placeOf(rest, i), placeOf(bent, i)) << i;
      ++beyond;
    }
  }
  EXPECT_GT(beyond, 0);
  EXPECT_GT(s.filter->GetMovedPoints(), 0);
}
