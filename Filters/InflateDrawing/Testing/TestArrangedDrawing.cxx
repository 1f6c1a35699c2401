// Strokes that cross, span and bound together, through the whole of system C.
#include "DrawingRuns.h"

#include "vtkOversketchArrange.h"
#include "vtkOversketchDistance.h"

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Line segment(const Vector2& from, const Vector2& to)
{
  Line line;
  line.closed = false;
  for (int i = 0; i <= 60; ++i)
  {
    line.points.push_back(from + (to - from) * i / 60.0);
  }
  return line;
}

Line part(const Vector2& centre, double radius, double from, double to)
{
  Line line;
  line.closed = false;
  for (int i = 0; i <= 100; ++i)
  {
    const double angle = from + (to - from) * i / 100.0;
    line.points.push_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return line;
}

std::set<int> cellValuesOf(vtkPolyData* mesh, const char* name)
{
  std::set<int> values;
  vtkDataArray* array = mesh->GetCellData()->GetArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.insert(static_cast<int>(array->GetComponent(i, 0)));
  }
  return values;
}

void expectClosedObject(System& system, int regions, int chi = 2)
{
  vtkPolyData* mesh = system.mesh();
  const Topology topology = topologyOf(mesh);
  EXPECT_TRUE(topology.closed);
  EXPECT_EQ(topology.chi, chi);
  EXPECT_EQ(cellValuesOf(mesh, "ObjectId").size(), 1u);
  EXPECT_EQ(static_cast<int>(cellValuesOf(mesh, "RegionId").size()), regions);
}

} // namespace

TEST(C17_2, ASpanningFeatureMakesTwoRegionsOfOneObject)
{
  // Drawn past both rims, to 4 px from them, and up to them with the ends joined as they always are.
  int runs = 0;
  for (const double reach : { 212.0, 196.0, -195.0 })
  {
    SCOPED_TRACE(reach);
    const double y = std::abs(reach);
    System system(drawn({ circle(400, 300, 200), segment({ 400, 300 - y }, { 430, 300 + y }) }));
    system.filter->SetArrange(reach > 0.0);
    for (const int levels : { 0, 1, 3 })
    {
      SCOPED_TRACE(levels);
      system.filter->SetLevels(levels);
      expectClosedObject(system, 2);
      ++runs;
    }
    system.filter->SetQuads(true);
    expectClosedObject(system, 2);
    system.filter->SetQuads(false);
    system.filter->SetExtrudeDepth(30.0);
    expectClosedObject(system, 2);
    system.filter->SetExtrudeDepth(0.0);
    system.filter->SetAsPublished(true);
    expectClosedObject(system, 2);
    runs += 3;
  }
  fact("C17_2",
    "a line through a disc, past its rim, short of it, up to it: " + std::to_string(runs) +
      " surfaces of levels 0 to 3, of triangles, of quads, extruded and as published: two regions, one "
      "object, closed, chi 2");
}

TEST(InflateDrawing, WhatSticksOutIsSaid)
{
  System system(drawn({ circle(400, 300, 200), segment({ 400, 300 }, { 720, 310 }) }));
  system.filter->SetArrange(true);
  Ear ear(system.filter);
  system.filter->Update();
  ASSERT_EQ(ear.errors.size(), 0u);
  ASSERT_EQ(ear.warnings.size(), 1u);
  EXPECT_NE(ear.warnings[0].find("Stroke 1 sticks out of the outline to (720, 310)"), std::string::npos)
    << ear.warnings[0];
  EXPECT_TRUE(topologyOf(system.filter->GetOutput()).closed);
}

TEST(InflateDrawing, OverlappingBodiesAreOne)
{
  System system(drawn({ circle(300, 300, 150), circle(500, 300, 150), segment({ 300, 300 }, { 520, 310 }) }));
  system.filter->SetArrange(true);
  expectClosedObject(system, 4); // the line divides what both cover
  const auto box = boxOf(system.filter->GetOutput());
  EXPECT_NEAR(box[0], 150.0, 1.0);
  EXPECT_NEAR(box[1], 650.0, 1.0);
  // Off, it is an error as before.
  system.filter->SetArrange(false);
  expectRefusal(system.filter, Failure::BadStroke, "crosses");
}

TEST(InflateDrawing, AnOutlineMayBeDrawnInParts)
{
  const Vector2 centre(400, 300);
  System whole(drawn({ circle(400, 300, 200), circle(400, 300, 60) }));
  System parts(drawn({ part(centre, 200, 0.0, 2.0),
    circle(400, 300, 60),
    part(centre, 200, 4.1, 6.3),
    part(centre, 200, 1.98, 4.05) }));
  for (System* system : { &whole, &parts })
  {
    system->filter->SetArrange(true);
    system->filter->SetHoles("1");
    expectClosedObject(*system, 1, 0);
  }
  const auto a = boxOf(whole.filter->GetOutput()), b = boxOf(parts.filter->GetOutput());
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_NEAR(a[k], b[k], 2.0) << k;
  }
}

TEST(InflateDrawing, WhatADividedTunnelLeavesIsClosed)
{
  System system(drawn({ circle(400, 300, 220), circle(400, 300, 80), segment({ 400, 215 }, { 400, 385 }) }));
  system.filter->SetArrange(true);
  expectClosedObject(system, 3);
  system.filter->SetTunnels("1");
  expectClosedObject(system, 1, 0);
  system.filter->SetTunnels("");
  system.filter->SetHoles("1");
  expectClosedObject(system, 1, 0);
}

TEST(InflateDrawing, ArrangedStrokesAreMadeAnewOnlyWhereTheyChange)
{
  const auto strokes = drawn({ circle(400, 300, 200), segment({ 400, 90 }, { 430, 510 }) });
  System system(strokes);
  system.filter->SetArrange(true);
  system.mesh();
  auto* arrange = system.step<vtkOversketchArrange>("Arrange");
  auto* distance = system.step<vtkOversketchDistance>("Distance");
  EXPECT_EQ(arrange->GetArrangementCount(), 1);
  system.filter->SetHeight(0.5);
  system.mesh();
  EXPECT_EQ(arrange->GetArrangementCount(), 1);
  EXPECT_EQ(distance->GetDistanceCount(), 1);
  vtkNew<vtkPolyData> warm;
  warm->DeepCopy(system.filter->GetOutput());
  System cold(strokes);
  cold.filter->SetArrange(true);
  cold.filter->SetHeight(0.5);
  EXPECT_TRUE(identical(cold.mesh(), warm));
}
