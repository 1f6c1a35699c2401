// Outlines that system C finds in the picture: alone, and with strokes that were drawn.
#include "DrawingRuns.h"

#include "vtkOversketchTrace.h"

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector2 ringAt(220.0, 300.0), discAt(580.0, 300.0); // middles of a ring and of a disc

vtkSmartPointer<vtkImageData> ringAndDisc()
{
  return picture(800,
    600,
    3,
    [](int x, int y, int)
    {
      const double fromLeft = (Vector2(x, y) - ringAt).norm(), fromRight = (Vector2(x, y) - discAt).norm();
      return (fromLeft < 150.0 && fromLeft > 50.0) || fromRight < 120.0 ? 60 : 235;
    });
}

// A system without strokes, or with some.
struct TracedSystem : System
{
  explicit TracedSystem(const char* places, vtkPolyData* strokes = nullptr)
    : System(strokes)
  {
    this->filter->SetInputData(1, ringAndDisc());
    this->filter->SetTrace(places);
    this->filter->SetLevels(2);
  }
};

} // namespace

TEST(TracedDrawing, APictureAloneBecomesAModel)
{
  TracedSystem largest("auto"); // the ring, of 62,800 px; the disc has 45,200
  const Topology ring = topologyOf(largest.mesh());
  EXPECT_TRUE(ring.closed);
  EXPECT_EQ(ring.chi, 0) << "its hole is a tunnel";
  double bounds[6];
  largest.filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], ringAt[0] - 150.0, 3.0);
  EXPECT_NEAR(bounds[1], ringAt[0] + 150.0, 3.0);
  EXPECT_NEAR(bounds[3], ringAt[1] + 150.0, 3.0);
  EXPECT_TRUE(largest.filter->GetOutput()->GetPointData()->GetTCoords());
  TracedSystem placed("580.5,300.5");
  EXPECT_EQ(topologyOf(placed.mesh()).chi, 2);
  placed.filter->GetOutput()->GetBounds(bounds);
  EXPECT_NEAR(bounds[0], discAt[0] - 120.0, 3.0);
  for (const char* both : { "auto 580 300", "auto, 580,300", "220 180; 580 300" })
  {
    TracedSystem two(both);
    const Topology pair = topologyOf(two.mesh());
    EXPECT_EQ(pair.pieces, 2) << both;
    EXPECT_EQ(pair.chi, 2) << both;
  }
}

TEST(TracedDrawing, OutlinesComeBeforeTheStrokesWhichKeepWhatTheySay)
{
  const auto strokes = drawn({ circle(580, 300, 40) });
  strokes->GetCellData()->AddArray(arrayOf<vtkIntArray>("Treatment", { 1 }));
  strokes->GetCellData()->AddArray(arrayOf<vtkIntArray>("Closed", { 1 }));
  TracedSystem system("580 300", strokes);
  EXPECT_EQ(topologyOf(system.mesh()).chi, 0) << "a hole was drawn in it";
  vtkPolyData* curves = system.filter->GetInnerOutput("Treatment");
  ASSERT_EQ(curves->GetNumberOfLines(), 2);
  EXPECT_EQ(curves->GetCellData()->GetArray("Role")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(curves->GetCellData()->GetArray("Treatment")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(system.filter->GetInnerOutput("Trace")->GetNumberOfLines(), 1);
  // The drawing is as it was, and nothing is traced twice.
  EXPECT_EQ(strokes->GetNumberOfLines(), 1);
  auto* trace = system.step<vtkOversketchTrace>("Trace");
  EXPECT_EQ(trace->GetTraceCount(), 1);
  system.filter->SetHeight(0.5);
  system.mesh();
  EXPECT_EQ(trace->GetTraceCount(), 1);
}

TEST(TracedDrawing, WhatCannotBeTracedIsSaid)
{
  for (const char* text : { "largest", "120", "120,", "-3 5", "1 2 3", " ", "nan 2" })
  {
    TracedSystem system(text);
    expectRefusal(system.filter, Failure::BadStroke, "give auto, or places");
  }
  TracedSystem outside("900 20");
  expectRefusal(outside.filter, Failure::BadStroke, "beyond the picture");
  TracedSystem unpictured("auto");
  unpictured.filter->SetInputData(1, nullptr);
  expectRefusal(unpictured.filter, Failure::BadStroke, "there is none; give the picture");
  TracedSystem nothing("");
  expectRefusal(nothing.filter, Failure::BadStroke, "There are no strokes");
}
