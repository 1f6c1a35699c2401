// What the whole of system C makes of drawings.
#include "DrawingRuns.h"

#include "vtkOversketchInflate.h"
#include "vtkOversketchPlanarRefine.h"

#include <map>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Faces of a flat mesh that are turned over.
int inverted(vtkPolyData* flat)
{
  int count = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < flat->GetNumberOfPolys(); ++face)
  {
    flat->GetPolys()->GetCellAtId(face, ids);
    const Vector3 a(flat->GetPoint(ids->GetId(0))), b(flat->GetPoint(ids->GetId(1))),
      c(flat->GetPoint(ids->GetId(2)));
    count += (b - a).cross(c - a)[2] <= 0.0;
  }
  return count;
}

// The faces by the places of their corners, each from its least one on, so that turning one over shows.
std::multiset<std::vector<std::array<double, 3>>> placesOf(vtkPolyData* mesh)
{
  std::multiset<std::vector<std::array<double, 3>>> faces;
  for (const std::vector<vtkIdType>& corners : cornersOf(mesh))
  {
    std::vector<std::array<double, 3>> places;
    for (const vtkIdType corner : corners)
    {
      const double* p = mesh->GetPoint(corner);
      places.push_back({ p[0], p[1], p[2] });
    }
    std::rotate(places.begin(), std::min_element(places.begin(), places.end()), places.end());
    faces.insert(std::move(places));
  }
  return faces;
}

vtkOversketchInflate* inflateOf(const System& system)
{
  return vtkOversketchInflate::SafeDownCast(system.filter->GetStep("Inflate"));
}

} // namespace

TEST(InflateDrawing, ADiscBecomesABall)
{
  System system(drawn({ circle(400, 300, 200) }));
  vtkPolyData* mesh = system.mesh();
  ASSERT_GT(mesh->GetNumberOfPoints(), 100);
  double least = 1e9, most = 0.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double radius = (Vector3(mesh->GetPoint(i)) - Vector3(400, 300, 0)).norm();
    least = std::min(least, radius);
    most = std::max(most, radius);
  }
  const double px = 800.0 / 1024.0; // of the raster
  EXPECT_GT(least, 200.0 - 4.0 * px);
  EXPECT_LT(most, 200.0 + 3.0 * px);
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, 2);
  EXPECT_EQ(system.filter->GetRebuilds(), 0);
  // Texture coordinates are places on the canvas.
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  ASSERT_NE(coordinates, nullptr);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 7)
  {
    EXPECT_NEAR(coordinates->GetComponent(i, 0), mesh->GetPoint(i)[0] / 800.0, 1e-6);
    EXPECT_NEAR(coordinates->GetComponent(i, 1), mesh->GetPoint(i)[1] / 600.0, 1e-6);
  }
}

TEST(InflateDrawing, HolesAndTunnelsCutThrough)
{
  System system(drawn({ circle(400, 300, 200), circle(400, 300, 90) }));
  EXPECT_EQ(topologyOf(system.mesh()).chi, 2) << "filled";
  const double filled = boxOf(system.filter->GetOutput())[5];
  system.filter->SetHoles("1");
  const Topology ringed = topologyOf(system.mesh());
  EXPECT_TRUE(ringed.closed);
  EXPECT_EQ(ringed.chi, 0) << "a torus";
  EXPECT_NEAR(boxOf(system.filter->GetOutput())[5], 55.0, 3.0) << "half of what is left between the rims";
  system.filter->SetHoles("");
  system.filter->SetTunnels("1");
  const Topology cut = topologyOf(system.mesh());
  EXPECT_TRUE(cut.closed);
  EXPECT_EQ(cut.chi, 0);
  EXPECT_NEAR(boxOf(system.filter->GetOutput())[5], std::sqrt(200.0 * 200.0 - 90.0 * 90.0), 4.0)
    << "its rim stands where it would without";
  EXPECT_LT(boxOf(system.filter->GetOutput())[5], filled);
}

TEST(InflateDrawing, ExtrudedItIsASlab)
{
  System system(drawn({ { { { 200, 150 }, { 600, 150 }, { 600, 450 }, { 200, 450 } }, true } }));
  system.filter->SetExtrudeDepth(40.0);
  system.filter->SetLevels(2);
  vtkPolyData* mesh = system.mesh();
  EXPECT_EQ(boxOf(mesh)[4], -40.0);
  EXPECT_EQ(boxOf(mesh)[5], 40.0);
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, 2);
  EXPECT_NEAR(volumeOf(mesh), 400.0 * 300.0 * 80.0, 1e-9 * volumeOf(mesh));
}

TEST(InflateDrawing, UnstretchedRimsAreEven)
{
  // Along the equator's normal a ball's triangles grow towards the rim; evened out the longest are shorter.
  System system(drawn({ circle(400, 300, 250) }));
  const auto longest = [](vtkPolyData* mesh)
  {
    double most = 0.0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
    {
      mesh->GetPolys()->GetCellAtId(face, ids);
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 a(mesh->GetPoint(ids->GetId(k))), b(mesh->GetPoint(ids->GetId((k + 1) % 3)));
        most = std::max(most, (a - b).norm());
      }
    }
    return most;
  };
  EXPECT_TRUE(inflateOf(system)->GetUnstretchedRims());
  const double even = longest(system.mesh());
  EXPECT_TRUE(topologyOf(system.filter->GetOutput()).closed);
  inflateOf(system)->SetUnstretchedRims(false);
  EXPECT_LT(even, 0.8 * longest(system.mesh()));
}

namespace
{

// Means [degrees] of the angles between faces: over the rim, and over edges of the row of faces beside it
// that have no point on the rim.
std::pair<double, double> anglesAtRim(vtkPolyData* mesh)
{
  const auto place = [&](vtkIdType i) { return Vector3(mesh->GetPoint(i)); };
  std::map<std::pair<vtkIdType, vtkIdType>, std::vector<vtkIdType>> edges;
  std::vector<Vector3> normals;
  std::vector<char> touches;
  vtkDataArray* sides = mesh->GetPointData()->GetArray("Side");
  const auto onRim = [&](vtkIdType i) { return sides->GetComponent(i, 0) == 0.0; };
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    bool touch = false;
    for (int k = 0; k < 3; ++k)
    {
      const vtkIdType a = ids->GetId(k), b = ids->GetId((k + 1) % 3);
      edges[{ std::min(a, b), std::max(a, b) }].push_back(face);
      touch = touch || onRim(ids->GetId(k));
    }
    touches.push_back(touch);
    const Vector3 a = place(ids->GetId(0));
    normals.push_back((place(ids->GetId(1)) - a).cross(place(ids->GetId(2)) - a).normalized());
  }
  double sums[2] = { 0.0, 0.0 };
  int counts[2] = { 0, 0 };
  for (const auto& [edge, faces] : edges)
  {
    const bool a = onRim(edge.first), b = onRim(edge.second);
    const bool beside = !a && !b && touches[faces[0]] != touches[faces[1]];
    if ((a && b) || beside)
    {
      sums[beside] += std::acos(std::clamp(normals[faces[0]].dot(normals[faces[1]]), -1.0, 1.0)) * 180.0 / pi;
      ++counts[beside];
    }
  }
  return { sums[0] / counts[0], sums[1] / counts[1] };
}

} // namespace

TEST(InflateDrawing, RimsHaveNoKeel)
{
  std::vector<Vector2> pear;
  for (int i = 0; i < 300; ++i)
  {
    const double a = 2.0 * pi * i / 300.0, r = 150.0 * (1.0 + 0.25 * std::sin(a));
    pear.emplace_back(400.0 + r * std::cos(a), 300.0 + 1.2 * r * std::sin(a));
  }
  for (const Line& line : { circle(400, 300, 250), circle(400, 300, 60), Line{ pear, true } })
  {
    System system(drawn({ line }));
    const auto [over, beside] = anglesAtRim(system.mesh());
    // Rows would be of one height: what is more at the rim is the raster's half a pixel.
    EXPECT_LE(over, 1.5 * beside);
    EXPECT_LE(over, 15.0);
    inflateOf(system)->SetUnstretchedRims(false);
    const auto [keel, row] = anglesAtRim(system.mesh());
    EXPECT_GT(keel, 1.35 * row) << "as it was";
  }
}

TEST(InflateDrawing, LargeFacesAreRefinedOnceMore)
{
  for (const double radius : { 250.0, 40.0 })
  {
    System system(drawn({ circle(400, 300, radius) }));
    system.mesh();
    EXPECT_EQ(system.filter->GetLevelsMade(), radius > 100.0 ? 4 : 3);
    system.filter->SetLevels(1);
    system.mesh();
    EXPECT_EQ(system.filter->GetLevelsMade(), radius > 100.0 ? 2 : 1);
    system.filter->SetLevels(0);
    system.mesh();
    EXPECT_EQ(system.filter->GetLevelsMade(), 0);
  }
}

TEST(InflateDrawing, AFeatureBesideTheRimLeavesEvenTriangles)
{
  // A line 4 px inside, all the way round or a part of it.
  for (const double last : { 60.0, 360.0 })
  {
    Line feature;
    feature.closed = last == 360.0;
    for (double angle = 0.0; angle < last; angle += 1.0)
    {
      feature.points.emplace_back(
        400.0 + 246.0 * std::cos(angle * pi / 180.0), 300.0 + 246.0 * std::sin(angle * pi / 180.0));
    }
    System system(drawn({ circle(400, 300, 250), feature }));
    vtkPolyData* mesh = system.mesh();
    std::vector<double> least;
    vtkNew<vtkIdList> ids;
    for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
    {
      mesh->GetPolys()->GetCellAtId(face, ids);
      double angle = pi;
      for (int k = 0; k < 3; ++k)
      {
        const Vector3 at(mesh->GetPoint(ids->GetId(k)));
        const Vector3 u = Vector3(mesh->GetPoint(ids->GetId((k + 1) % 3))) - at;
        const Vector3 v = Vector3(mesh->GetPoint(ids->GetId((k + 2) % 3))) - at;
        angle = std::min(angle, std::atan2(u.cross(v).norm(), u.dot(v)));
      }
      least.push_back(angle * 180.0 / pi);
    }
    std::nth_element(least.begin(), least.begin() + least.size() / 2, least.end());
    EXPECT_GE(least[least.size() / 2], 25.0) << last;
  }
}

TEST(InflateDrawing, ARingThatRunsPastItsStartIsClosed)
{
  Line ring = circle(400, 300, 200);
  ring.points.clear();
  ring.closed = false;
  for (int i = 0; i <= 200; ++i)
  {
    const double a = (2.0 * pi + 0.12) * i / 200.0, r = 200.0 + 5.0 * i / 200.0;
    ring.points.emplace_back(400.0 + r * std::cos(a), 300.0 + r * std::sin(a));
  }
  System system(drawn({ ring }));
  const Topology topology = topologyOf(system.mesh());
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, 2);
}

TEST(InflateDrawing, TheSketchSaysHowFineItIs)
{
  // The same outline on the canvas of 800 x 600, large and small: no rim's edge is 0.02 of 800 long.
  for (const double radius : { 250.0, 60.0 })
  {
    System system(drawn({ circle(400, 300, radius) }));
    vtkOversketchPlanarRefine::SafeDownCast(system.filter->GetStep("Refine"))->LevelsFromSketchOn();
    const Topology topology = topologyOf(system.mesh());
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.chi, 2);
    const int levels = system.filter->GetLevelsMade();
    EXPECT_TRUE(radius > 100.0 ? levels > 3 : levels <= 3) << levels;
    vtkPolyData* edges = vtkPolyData::SafeDownCast(system.filter->GetStep("Refine")->GetOutputDataObject(1));
    vtkDataArray* starts = edges->GetCellData()->GetArray("ParamStart");
    vtkDataArray* ends = edges->GetCellData()->GetArray("ParamEnd");
    ASSERT_GT(edges->GetNumberOfCells(), 20);
    for (vtkIdType i = 0; i < edges->GetNumberOfCells(); ++i)
    {
      EXPECT_LT(ends->GetComponent(i, 0) - starts->GetComponent(i, 0), 16.0) << i;
    }
    system.filter->AsPublishedOn();
    system.mesh();
    EXPECT_EQ(system.filter->GetLevelsMade(), 3);
  }
}

TEST(InflateDrawing, QuadsAreQuads)
{
  System system(drawn({ circle(400, 300, 200), { { { 300, 300 }, { 400, 330 }, { 500, 300 } }, false } }));
  system.filter->QuadsOn();
  vtkPolyData* mesh = system.mesh();
  vtkNew<vtkIdList> ids;
  for (vtkIdType face = 0; face < mesh->GetNumberOfPolys(); ++face)
  {
    mesh->GetPolys()->GetCellAtId(face, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 4);
  }
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, 2);
}

TEST(InflateDrawing, OrderOfStrokesDoesNotMatter)
{
  const std::vector<Line> lines = { circle(400, 300, 200),
    circle(330, 320, 50),
    { { { 450, 250 }, { 480, 300 }, { 470, 350 } }, false },
    circle(120, 120, 60) };
  System one(drawn(lines));
  const auto before = placesOf(one.mesh());
  EXPECT_GT(before.size(), 1000u);
  EXPECT_EQ(topologyOf(one.filter->GetOutput()).chi, 4) << "two objects";
  System other(drawn({ lines[2], lines[3], lines[1], lines[0] }));
  EXPECT_TRUE(placesOf(other.mesh()) == before) << "not the same faces";
}

TEST(InflateDrawing, CleftsAreFollowedMoreCloselyUntilNothingTurnsOver)
{
  std::vector<Vector2> star;
  for (int i = 0; i < 720; ++i)
  {
    const double angle = 2.0 * pi * i / 720.0, radius = 190.0 * (1.0 + 0.4 * std::cos(7.0 * angle));
    star.emplace_back(400.0 + radius * std::cos(angle), 300.0 + radius * std::sin(angle));
  }
  System system(drawn({ { star, true } }));
  const Topology topology = topologyOf(system.mesh());
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, 2);
  EXPECT_EQ(inverted(system.filter->GetInnerOutput("Refine")), 0);
  system.filter->AsPublishedOn();
  system.mesh();
  EXPECT_GT(inverted(system.filter->GetInnerOutput("Refine")), 0) << "as published some do";
}

TEST(InflateDrawing, TheShippedDrawingsBecomeSoundModels)
{
  const struct
  {
    const char* name;
    double depth;
    bool quads;
    int chi;
  } drawings[] = { { "fish", 0.0, false, 2 },
    { "mug", 0.0, false, 0 },
    { "padlock", 30.0, false, -2 },
    { "heron", 0.0, false, 2 },
    { "leaf", 0.0, true, 2 },
    { "figure_body", 0.0, false, 2 } };
  for (const auto& drawing : drawings)
  {
    SCOPED_TRACE(drawing.name);
    Shipped shipped(drawing.name);
    shipped.filter->SetExtrudeDepth(drawing.depth);
    shipped.filter->SetQuads(drawing.quads);
    Ear ear(shipped.filter);
    shipped.filter->Update();
    ASSERT_TRUE(ear.errors.empty()) << ear.errors[0];
    EXPECT_TRUE(ear.warnings.empty()) << ear.warnings[0];
    vtkPolyData* mesh = shipped.filter->GetOutput();
    const Topology topology = topologyOf(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_EQ(topology.chi, drawing.chi);
    std::cout << drawing.name << ": " << mesh->GetNumberOfPolys() << " faces, "
              << shipped.filter->GetRebuilds() << " rebuilds\n";
  }
}

TEST(InflateDrawing, MagneticStrokesKeepToThePicture)
{
  const auto picture = discPicture(512, 180.5, { 256.0, 256.0 });
  std::vector<Vector2> points = ring({ 256.5, 256.5 }, 187.0, 300); // display px, from the picture's corner
  points.push_back(points[0]);
  const auto stroke = toStroke(points, viewOfPicture(picture));
  vtkNew<vtkOversketchInflateDrawing> filter;
  filter->SetInputData(0, stroke);
  filter->SetInputData(1, picture);
  filter->Update();
  EXPECT_NEAR(boxOf(filter->GetOutput())[1] - 256.0, 187.0, 1.0);
  filter->MagneticOn();
  filter->Update();
  const auto box = boxOf(filter->GetOutput());
  EXPECT_NEAR(box[1] - 256.0, 181.0, 1.0);
  EXPECT_NEAR(256.0 - box[0], 181.0, 1.0);
  EXPECT_NEAR(box[3] - 256.0, 181.0, 1.0);
  EXPECT_EQ(filter->GetErrorCode(), 0u);
  EXPECT_EQ(stroke->GetCellData()->GetArray("Magnetic"), nullptr) << "the input is untouched";
}
