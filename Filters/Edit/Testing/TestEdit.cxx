// The edit system: what comes out, what stays as it was, what runs again.
#include "EditSystem.h"

#include "Harness/shapes.h"
#include "vtkOversketchDistanceField.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchInsertCurve.h"
#include "vtkOversketchMatrixDeform.h"
#include "vtkOversketchNurbsFit.h"
#include "vtkOversketchResketch.h"
#include "vtkOversketchScanFill.h"
#include "vtkOversketchShadingLevels.h"

#include "vtkFeatureEdges.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkImplicitPolyDataDistance.h"
#include "vtkIntArray.h"
#include "vtkMassProperties.h"
#include "vtkSMPTools.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <string>

using namespace oversketch_test;
using oversketch::Failure;

namespace
{

const char* const models[] = { "bear", "dog", "hand", "octopus" };

// A profile over the whole section.
vtkSmartPointer<vtkPolyData> archOfSection()
{
  auto drawn = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(101);
  for (int i = 0; i <= 100; ++i)
  {
    const double t = i / 100.0;
    lines->InsertCellPoint(points->InsertNextPoint(t, 0.5 * std::sin(pi * t), 0.0));
  }
  drawn->SetPoints(points);
  drawn->SetLines(lines);
  return drawn;
}

double distanceToSurface(vtkPolyData* mesh, const Vector3& p)
{
  vtkNew<vtkImplicitPolyDataDistance> distance;
  distance->SetInput(mesh);
  return std::abs(distance->EvaluateFunction(p[0], p[1], p[2]));
}

double volumeOf(vtkPolyData* mesh)
{
  vtkNew<vtkMassProperties> mass;
  mass->SetInputData(mesh);
  return mass->GetVolume();
}

} // namespace

// Bits outside: a vertex farther from the region than its ring and two mean edges is there as it was.
TEST(EditSystem, ALineIsDraggedAndWhatLiesOutsideStays)
{
  for (const std::string model : models)
  {
    EditSystem s(shippedModel(model), lineOver(40.0), ringOver(35.0));
    s.operate("move 0.5 n %.9g", 0.03);
    vtkPolyData* output = s.run();
    ASSERT_GT(output->GetNumberOfPolys(), 0) << model;
    EXPECT_GT(s.filter->GetMovedPoints(), 0);
    EXPECT_EQ(eulerNumber(output), eulerNumber(s.mesh)) << model;
    const double meanEdge = output->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);

    std::set<std::array<double, 3>> places;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(output, i);
      places.insert({ p[0], p[1], p[2] });
    }
    vtkPolyData* patch = vtkPolyData::SafeDownCast(s.filter->GetStep("Enclose")->GetOutputDataObject(1));
    vtkIdType far = 0;
    for (vtkIdType i = 0; i < s.mesh->GetNumberOfPoints(); ++i)
    {
      const Vector3 p = placeOf(s.mesh, i);
      if (distanceTo(patch, p) > 2.0 * meanEdge)
      {
        ++far;
        EXPECT_TRUE(places.count({ p[0], p[1], p[2] })) << model << " point " << i;
      }
    }
    EXPECT_GT(far, s.mesh->GetNumberOfPoints() / 2);

    // The line's middle has gone outward by the length, all of it.
    vtkNew<vtkPolyData> hold, region;
    s.filter->GetHold(hold);
    s.filter->GetRegion(region);
    EXPECT_GT(region->GetNumberOfPolys(), 0);
    for (vtkIdType i = 0; i < hold->GetNumberOfPoints(); ++i)
    {
      EXPECT_NEAR(distanceTo(s.filter->GetReferenceOutput(), placeOf(hold, i)),
        0.03 * s.diagonal(),
        0.015 * s.diagonal());
    }
    // Curves are chains of vertices of the output.
    for (vtkPolyData* curve : { s.filter->GetReferenceOutput(), s.filter->GetBoundaryOutput() })
    {
      vtkDataArray* ids = curve->GetPointData()->GetArray("VertexId");
      ASSERT_GT(curve->GetNumberOfPoints(), 2);
      for (vtkIdType i = 0; i < curve->GetNumberOfPoints(); ++i)
      {
        EXPECT_EQ(
          (placeOf(curve, i) - placeOf(output, static_cast<vtkIdType>(ids->GetComponent(i, 0)))).norm(), 0.0);
      }
    }
  }
}

TEST(EditSystem, AnEditThatMovesNothingPutsOutItsInput)
{
  EditSystem s(shippedModel("bear"));
  const auto before = deepCopy(s.mesh);
  for (const char* operations : { "", "pin 0.5", "move 0.5 n 0", "rotate 0.2 t 0; scale 0.8 w 1" })
  {
    s.filter->SetOperations(operations);
    vtkPolyData* output = s.run();
    EXPECT_EQ(output->GetPoints(), s.mesh->GetPoints()) << operations;
    EXPECT_EQ(output->GetPolys(), s.mesh->GetPolys()) << operations;
    expectSameBits(output, before);
    EXPECT_EQ(s.filter->GetMovedPoints(), 0);
    EXPECT_GT(s.filter->GetReferenceOutput()->GetNumberOfPoints(), 1);
    EXPECT_EQ(s.filter->GetReferenceOutput()->GetPointData()->GetArray("VertexId")->GetRange()[1], -1.0);
  }
  // Black all over.
  vtkNew<vtkImageData> black;
  black->SetDimensions(8, 8, 1);
  black->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::memset(black->GetScalarPointer(), 0, 64);
  s.filter->SetWeightsData(black);
  s.operate("move 0.5 n %.9g", 0.05);
  expectSameBits(s.run(), before);
}

TEST(B13_2, RunsWhatDependsAndNothingElse)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.02);
  s.run();
  Executions count(s.filter);
  s.run();
  EXPECT_EQ(count.Ran(), Steps{});
  s.operate("move 0.5 n %.9g", 0.03);
  s.run();
  EXPECT_EQ(count.Ran(), (Steps{ "Handles", "Deform", "Retriangulate" }));
  s.filter->SetLayers("handle 0.4 0.6");
  s.run();
  const Steps layer = count.Ran();
  EXPECT_EQ(layer.count("Flatten") + layer.count("Distance") + layer.count("Enclose"), 0u);
  EXPECT_EQ(layer.count("Shading") + layer.count("Deform"), 2u);
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.run();
  EXPECT_EQ(count.Ran().count("Deform"), 0u);
  s.filter->SetRule(vtkOversketchEdit::Edit);
  // A ring drawn anew leaves the line's part alone, where the mesh is fine enough for both.
  EditSystem fine(toPolyData(icosphere(6)), lineOver(), ringOver(85.0));
  fine.run();
  Executions again(fine.filter);
  fine.filter->SetBoundaryData(toStroke(ringOver(90.0), fine.view));
  fine.run();
  const Steps ring = again.Ran();
  EXPECT_EQ(ring.count("ReferenceProject") + ring.count("ReferenceInsert"), 0u);
  EXPECT_EQ(ring.count("BoundaryInsert") + ring.count("Distance") + ring.count("Deform"), 3u);
  // K of the re-sketch: that and what comes after it; of a slid plane nothing is flattened.
  s.filter->SetOperations("");
  s.filter->SetProfileData(archOfSection());
  s.run();
  count.Ran();
  vtkOversketchResketch::SafeDownCast(s.filter->GetStep("Redraw"))->SetK(3.0);
  s.filter->Modified();
  s.run();
  EXPECT_EQ(count.Ran(), (Steps{ "Redraw", "Bend", "Retriangulate" }));
  s.filter->SetProfileAt(0.4);
  s.run();
  EXPECT_EQ(count.Ran(), (Steps{ "Planes", "Section", "Redraw", "Bend", "Retriangulate" }));
  fact("B13_2",
    "an operation runs handles and deformation, a layer shading and on, K the re-sketch and on, a slid plane "
    "planes and on: no region is grown, no disc or field solved; a second update runs nothing");
}

TEST(EditSystem, ARaisedLineLeavesNoPointAtItsEndsAndNoEdgeAtTheRing)
{
  EditSystem s(toPolyData(icosphere(6)), lineOver(), ringOver(85.0));
  s.operate("move 0.5 n %.9g", 0.05);
  const auto sharp = [&]
  {
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(s.run());
    edges->BoundaryEdgesOff();
    edges->NonManifoldEdgesOff();
    edges->SetFeatureAngle(15.0);
    edges->Update();
    return edges->GetOutput()->GetNumberOfCells();
  };
  EXPECT_EQ(sharp(), 0);
  s.filter->SetFalloffToLinear();
  EXPECT_GT(sharp(), 0); // as published
}

TEST(EditSystem, SameBitsForAnyNumberOfThreadsAndColdAsCached)
{
  EditSystem warm(shippedModel("hand"), lineOver(40.0), ringOver(35.0));
  warm.operate("rotate 0.5 t 20; move 0.3 n %.9g", 0.01);
  warm.run();
  warm.operate("move 0.7 n %.9g; rotate 0.2 t 25", 0.02);
  const auto cached = deepCopy(warm.run());
  for (const int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(threads),
      [&]
      {
        EditSystem cold(shippedModel("hand"), lineOver(40.0), ringOver(35.0));
        cold.operate("move 0.7 n %.9g; rotate 0.2 t 25", 0.02);
        expectSameBits(cold.run(), cached);
      });
  }
}

// The last preview is the result without new triangles: {Deform}'s places, bit for bit.
TEST(EditSystem, WithoutNewTrianglesItIsWhatTheDeformationMakes)
{
  EditSystem s(shippedModel("dog"), lineOver(40.0), ringOver(35.0));
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.operate("move 0.5 n %.9g", 0.02);
  vtkPolyData* output = s.run();
  vtkPolyData* inner = s.filter->GetInnerOutput("Deform");
  ASSERT_EQ(output->GetNumberOfPoints(), inner->GetNumberOfPoints());
  std::set<std::array<double, 3>> places;
  for (vtkIdType i = 0; i < inner->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = placeOf(inner, i);
    places.insert({ p[0], p[1], p[2] });
  }
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const Vector3 p = placeOf(output, i);
    EXPECT_TRUE(places.count({ p[0], p[1], p[2] }));
  }
}

// An edit takes the curves of the one before it: the region is the same, and nothing is cut anew.
TEST(EditSystem, AnEditTakesTheCurvesOfTheOneBefore)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.02);
  vtkPolyData* first = s.run();
  vtkNew<vtkOversketchEdit> next;
  next->SetInputData(0, first);
  next->SetReferenceData(s.filter->GetReferenceOutput());
  next->SetBoundaryData(s.filter->GetBoundaryOutput());
  next->SetOperations("rotate 0.5 t 10");
  Ear ear(next);
  next->Update();
  ASSERT_TRUE(ear.errors.empty()) << ear.errors[0];
  EXPECT_GT(next->GetMovedPoints(), 0);
  EXPECT_EQ(eulerNumber(next->GetOutput()), eulerNumber(s.mesh));
  EXPECT_EQ(next->GetOutput()->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0),
    first->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0));
  // After an edit that moved nothing, whose curves are of no vertices.
  s.filter->SetOperations("");
  s.run();
  next->SetInputData(0, s.filter->GetOutput());
  next->SetReferenceData(s.filter->GetReferenceOutput());
  next->SetBoundaryData(s.filter->GetBoundaryOutput());
  next->Update();
  ASSERT_EQ(next->GetErrorCode(), 0u);
  EXPECT_GT(next->GetMovedPoints(), 0);
}

TEST(EditSystem, KeepsSeamsAndArrays)
{
  EditSystem s(shippedModel("bear"));
  // Each point twice, right of the middle with other texture coordinates: a seam through the line.
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetName("Wrap");
  coordinates->SetNumberOfComponents(2);
  vtkNew<vtkPoints> points;
  points->SetDataType(s.mesh->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> triangles;
  vtkNew<vtkIdTypeArray> numbers;
  numbers->SetName("Triangle");
  double box[6];
  s.mesh->GetBounds(box);
  std::map<std::pair<vtkIdType, bool>, vtkIdType> known;
  vtkNew<vtkIdList> ids;
  for (vtkIdType t = 0; t < s.mesh->GetNumberOfPolys(); ++t)
  {
    s.mesh->GetPolys()->GetCellAtId(t, ids);
    double middle = 0.0;
    for (const vtkIdType id : *ids)
    {
      middle += placeOf(s.mesh, id)[0] / 3.0;
    }
    const bool right = middle > 0.5 * (box[0] + box[1]);
    triangles->InsertNextCell(3);
    for (const vtkIdType id : *ids)
    {
      const auto [found, isNew] = known.emplace(std::make_pair(id, right), points->GetNumberOfPoints());
      if (isNew)
      {
        const Vector3 p = placeOf(s.mesh, id);
        points->InsertNextPoint(p.data());
        coordinates->InsertNextTuple2(p[0] + (right ? 100.0 : 0.0), p[1]);
      }
      triangles->InsertCellPoint(found->second);
    }
    numbers->InsertNextValue(t);
  }
  vtkNew<vtkPolyData> seamed;
  seamed->SetPoints(points);
  seamed->SetPolys(triangles);
  seamed->GetPointData()->SetTCoords(coordinates);
  seamed->GetCellData()->AddArray(numbers);
  s.filter->SetInputData(0, seamed);
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.operate("move 0.5 n %.9g", 0.02);
  vtkPolyData* output = s.run();
  vtkDataArray* carried = output->GetPointData()->GetTCoords();
  ASSERT_TRUE(carried);
  ASSERT_TRUE(output->GetCellData()->HasArray("Triangle"));
  EXPECT_FALSE(output->GetPointData()->HasArray("Place"));
  // Nothing is mixed over the seam: all corners of a triangle are of one side.
  for (vtkIdType t = 0; t < output->GetNumberOfPolys(); ++t)
  {
    output->GetPolys()->GetCellAtId(t, ids);
    int sides = 0;
    for (const vtkIdType id : *ids)
    {
      const double u = carried->GetComponent(id, 0);
      EXPECT_TRUE(u < box[1] + 1.0 || u > box[0] + 99.0) << u;
      sides += u > 50.0;
    }
    EXPECT_TRUE(sides == 0 || sides == 3) << t;
  }
  // And with the geometry alone all is where it is without a seam.
  EditSystem plain(s.mesh);
  plain.filter->SetRule(vtkOversketchEdit::Off);
  plain.operate("move 0.5 n %.9g", 0.02);
  EXPECT_EQ(plain.run()->GetNumberOfPolys(), output->GetNumberOfPolys());
}

// A 4-8 mesh is none once its triangles are cut: what says so is gone, whatever else it carries stays.
TEST(EditSystem, StellarArraysAreDropped)
{
  const char* const ofPoints[] = {
    "StellarMoved", "CurveId", "CurveParam", "BaseNormal", "Displacement", "Feature"
  };
  const char* const ofCells[] = { "StellarRoot", "StellarPath", "StellarGen" };
  const char* const ofFields[] = { "StellarVersion", "CurveDigest" };
  const auto add = [](vtkFieldData* data, const char* name, vtkIdType count)
  {
    vtkNew<vtkIntArray> array; // VTK mixes no ids
    array->SetName(name);
    for (vtkIdType i = 0; i < count; ++i)
    {
      array->InsertNextValue(static_cast<int>(i));
    }
    data->AddArray(array);
  };
  for (const bool isHierarchy : { true, false }) // without StellarPath the names mean something else
  {
    for (const int rule : { vtkOversketchEdit::Edit, vtkOversketchEdit::Off })
    {
      EditSystem s(shippedModel("bear"));
      const vtkIdType points = s.mesh->GetNumberOfPoints(), cells = s.mesh->GetNumberOfPolys();
      for (const char* name : ofPoints)
      {
        add(s.mesh->GetPointData(), name, points);
      }
      for (const char* name : ofCells)
      {
        if (isHierarchy || std::string(name) != "StellarPath")
        {
          add(s.mesh->GetCellData(), name, cells);
        }
      }
      for (const char* name : ofFields)
      {
        add(s.mesh->GetFieldData(), name, 1);
      }
      add(s.mesh->GetPointData(), "Own", points);
      add(s.mesh->GetCellData(), "Own", cells);
      s.filter->SetRule(rule);
      s.operate("move 0.5 n %.9g", 0.02);
      vtkPolyData* output = s.run();
      ASSERT_GT(s.filter->GetMovedPoints(), 0);
      for (const char* name : ofPoints)
      {
        EXPECT_NE(bool(output->GetPointData()->HasArray(name)), isHierarchy) << name << ' ' << rule;
      }
      EXPECT_FALSE(output->GetCellData()->HasArray("StellarPath")) << rule;
      for (const char* name : { "StellarRoot", "StellarGen" })
      {
        EXPECT_NE(bool(output->GetCellData()->HasArray(name)), isHierarchy) << name << ' ' << rule;
      }
      for (const char* name : ofFields)
      {
        EXPECT_NE(bool(output->GetFieldData()->HasArray(name)), isHierarchy) << name << ' ' << rule;
      }
      EXPECT_TRUE(output->GetPointData()->HasArray("Own")) << rule;
      EXPECT_TRUE(output->GetCellData()->HasArray("Own")) << rule;
      EXPECT_TRUE(s.mesh->GetPointData()->HasArray("BaseNormal")) << "the input is touched";
    }
  }
}

// White where the image is painted, still elsewhere.
TEST(B7_9, AWhiteBlobMovesTheVerticesInItAndNoOther)
{
  EditSystem s(shippedModel("bear"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 64, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::memset(image->GetScalarPointer(), 0, 64 * 64);
  for (int y = 36; y < 46; ++y)
  {
    for (int x = 36; x < 46; ++x)
    {
      image->SetScalarComponentFromDouble(x, y, 0, 0, 255.0);
    }
  }
  s.filter->SetWeightsData(image);
  s.operate("move 0.5 n %.9g", 0.02);
  s.run();
  vtkPolyData* rest = s.filter->GetInnerOutput("Texture");
  vtkPolyData* moved = s.filter->GetInnerOutput("Deform");
  vtkDataArray* disc = rest->GetPointData()->GetArray("DiscCoords");
  ASSERT_TRUE(disc);
  int blob = 0, others = 0;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    const double u = 64.0 * disc->GetComponent(i, 0), v = 64.0 * disc->GetComponent(i, 1);
    const bool inside = u > 36.5 && u < 45.5 && v > 36.5 && v < 45.5;
    const bool outside = u < 35.5 || u > 46.5 || v < 35.5 || v > 46.5;
    const bool still = placeOf(rest, i) == placeOf(moved, i);
    blob += inside;
    EXPECT_TRUE(!inside || !still) << i;
    EXPECT_TRUE(!outside || still) << i;
    others += outside;
  }
  EXPECT_GT(blob, 0);
  fact("B7_9",
    std::to_string(blob) + " vertices under a white blob of the image move, " + std::to_string(others) +
      " beside it stay to the bit");
}

// A profile drawn anew is met by the surface; with operations it is refused; one that is the section moves
// nothing.
TEST(EditSystem, AProfileIsFollowed)
{
  EditSystem s(shippedModel("bear"));
  s.filter->SetRule(vtkOversketchEdit::Off);
  s.filter->SetProfileData(archOfSection());
  vtkPolyData* output = s.run();
  EXPECT_GT(s.filter->GetMovedPoints(), 0);
  // Its top, which stands far off the bear, is on the surface now, and the bear has grown by what lies below.
  vtkPolyData* section = s.filter->GetInnerOutput("Section");
  Eigen::Matrix4d toWorld;
  for (int k = 0; k < 16; ++k)
  {
    toWorld(k / 4, k % 4) = section->GetFieldData()->GetArray("ProfileMatrix")->GetComponent(0, k);
  }
  const Vector3 top = (toWorld * Vector3(0.5, 0.5, 0.0).homogeneous()).head<3>();
  const double edge = output->GetFieldData()->GetArray("MeanEdge")->GetComponent(0, 0);
  EXPECT_LT(distanceToSurface(output, top), 0.3 * edge);
  EXPECT_GT(distanceToSurface(s.mesh, top), 5.0 * edge);
  EXPECT_GT(volumeOf(output), volumeOf(s.mesh));
  Executions count(s.filter);
  s.filter->SetProfileAt(0.6);
  s.run();
  EXPECT_EQ(count.Ran(), (Steps{ "Planes", "Section", "Redraw", "Bend" }));
  s.filter->SetOperations("move 0.5 n 1");
  expectRefusal(s.filter, Failure::BadStroke, "profile");
  s.filter->SetOperations("");
  s.filter->SetRule(vtkOversketchEdit::Edit);
  EXPECT_EQ(eulerNumber(s.run()), eulerNumber(s.mesh));
  for (const double place : { 0.6, 0.3 })
  {
    s.filter->SetProfileAt(place);
    s.run();
    s.filter->SetProfileData(deepCopy(s.filter->GetInnerOutput("Section")));
    expectSameBits(s.run(), s.mesh);
    EXPECT_EQ(s.filter->GetMovedPoints(), 0);
    s.filter->SetProfileData(archOfSection());
  }
}

TEST(EditSystem, RefusesWhatIsNone)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.02);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPolyData> none;
  s.filter->SetReferenceData(none);
  expectRefusal(s.filter, Failure::BadStroke, "no reference");
  s.filter->SetReferenceData(toStroke(lineOver(60.0, 400.0), s.view));
  expectRefusal(s.filter, Failure::BadStroke, "draw it over the model");
  s.filter->SetReferenceData(toStroke({ { 380, 300 }, { nan, 300 }, { 420, 300 } }, s.view));
  expectRefusal(s.filter, Failure::BadStroke, "troke");
  s.filter->SetReferenceData(toStroke(lineOver(300.0), s.view));
  Ear ear(s.filter);
  s.filter->Update();
  EXPECT_EQ(ear.errors.size(), 1u); // across the ring
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
  s.filter->SetReferenceData(s.reference);
  s.filter->SetBoundaryData(none);
  expectRefusal(s.filter, Failure::BadStroke, "no boundary");
  s.filter->SetBoundaryData(s.boundary);
  for (const char* operations : { "lift 0.5 n 1", "move 1.5 n 1", "scale 0.5 n 0", "rotate 0.5 t 180" })
  {
    s.filter->SetOperations(operations);
    expectRefusal(s.filter, Failure::BadStroke, "peration");
  }
  s.operate("move 0.5 n %.9g", 0.02);
  s.filter->SetLayers("handle 2");
  expectRefusal(s.filter, Failure::BadStroke, "handle 2");
  s.filter->SetLayers("");
  expectCancel(s.filter, 0.3);
  EXPECT_GT(s.run()->GetNumberOfPoints(), 0);
  s.filter->SetInputData(0, none);
  s.run();
  EXPECT_EQ(s.filter->GetOutput()->GetNumberOfPoints(), 0);
}

TEST(EditSystem, AsPublishedTurnsEveryStep)
{
  EditSystem s(shippedModel("bear"));
  s.operate("move 0.5 n %.9g", 0.01);
  const auto amended = deepCopy(s.run());
  s.filter->AsPublishedOn();
  s.filter->SetRule(vtkOversketchEdit::Off);
  EXPECT_TRUE(vtkOversketchInsertCurve::SafeDownCast(s.filter->GetStep("BoundaryInsert"))->GetJoinRuns());
  auto* fit = vtkOversketchNurbsFit::SafeDownCast(s.filter->GetStep("ReferenceFit"));
  EXPECT_EQ(fit->GetFitSpace(), vtkOversketchNurbsFit::World);
  vtkPolyData* mesh = s.run();
  EXPECT_GT(mesh->GetNumberOfPolys(), 0);
  EXPECT_EQ(fit->GetOutput()->GetFieldData()->GetArray("NurbsPoints")->GetNumberOfComponents(), 3);
  vtkPolyData* weighted = s.filter->GetInnerOutput("Shading");
  vtkDataArray* weight = weighted->GetPointData()->GetArray("EditWeight");
  vtkDataArray* share = weighted->GetPointData()->GetArray("CurveDistance");
  for (vtkIdType i = 0; i < weight->GetNumberOfTuples(); ++i)
  {
    if (weight->GetComponent(i, 0) > 0.0)
    {
      EXPECT_NEAR(weight->GetComponent(i, 0), 1.0 - share->GetComponent(i, 0), 1e-9);
    }
  }
  s.filter->AsPublishedOff();
  s.filter->SetRule(vtkOversketchEdit::Edit);
  expectSameBits(s.run(), amended);
  EXPECT_EQ(fit->GetNumberOfInputConnections(1), 0); // another mesh does not run it again
}
