#include "Planar/trim.h"

#include "Harness/refine_runs.h"
#include "Harness/refine_shapes.h"
#include "Planar/guard.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A body with two filled children, a grandchild in the first; regions 0 to 3 in this order.
UnitDrawing nested()
{
  return UnitDrawing({ circleStroke(0.5, 0.5, 0.4),
    circleStroke(0.4, 0.5, 0.2),
    circleStroke(0.4, 0.5, 0.1),
    circleStroke(0.75, 0.5, 0.08) });
}

double areaOfRegion(const PlanarMesh& mesh, int region)
{
  PlanarMesh part = mesh;
  part.faces.erase(
    std::remove_if(
      part.faces.begin(), part.faces.end(), [&](const PlanarFace& face) { return face.region != region; }),
    part.faces.end());
  return areaOf(part);
}

} // namespace

TEST(Trim, AHoleGoesButNoIslandInIt)
{
  const Treatment fill = Treatment::Fill, hole = Treatment::Hole, tunnel = Treatment::Tunnel;
  const UnitDrawing drawing = nested();
  using Flags = std::vector<char>;
  EXPECT_EQ(regionsInHoles(drawing.classes, { fill, fill, fill, fill }), (Flags{ 0, 0, 0, 0 }));
  EXPECT_EQ(regionsInHoles(drawing.classes, { hole, tunnel, fill, tunnel }), (Flags{ 0, 0, 0, 0 }));
  EXPECT_EQ(regionsInHoles(drawing.classes, { fill, hole, fill, fill }), (Flags{ 0, 1, 0, 0 }))
    << "an island";
  EXPECT_EQ(regionsInHoles(drawing.classes, { fill, hole, hole, fill }), (Flags{ 0, 1, 1, 0 }));
  EXPECT_EQ(regionsInHoles(drawing.classes, { fill, fill, hole, hole }), (Flags{ 0, 0, 1, 1 }));

  const PlanarMesh mesh = rebuilt(drawing, DeltaMode::Adaptive, {}).result.mesh;
  ASSERT_FALSE(mesh.faces.empty());
  for (const Flags& gone : { Flags{ 0, 1, 1, 0 }, Flags{ 0, 0, 1, 1 }, Flags{ 0, 0, 0, 0 } })
  {
    const PlanarMesh trimmed = withoutRegions(mesh, gone);
    const FaceEdges links = faceEdges(trimmed); // which is sound
    int rims = 1;
    for (int r = 0; r < 4; ++r)
    {
      EXPECT_EQ(areaOfRegion(trimmed, r), gone[r] ? 0.0 : areaOfRegion(mesh, r)) << r;
      rims += gone[r] && !gone[drawing.classes.regions[r].parent];
    }
    // Euler's characteristic of a disc with so many holes.
    EXPECT_EQ(static_cast<int>(trimmed.points.size() + trimmed.faces.size() - links.edges.size()), 2 - rims);
    for (int p = 0; p < static_cast<int>(trimmed.points.size()); ++p)
    {
      const bool border = std::any_of(
        links.atPoint.begin(p), links.atPoint.end(p), [&](int e) { return links.edges[e].faces[1] < 0; });
      EXPECT_EQ(isRim(trimmed.points[p].kind), border);
      EXPECT_EQ(trimmed.points[p].kind == BoundaryKind::Object, trimmed.points[p].stroke == 0);
    }
    const auto onKeptStroke = [&](const StrokeEdge& edge)
    {
      const int region = edge.stroke == 0 ? 0 : drawing.classes.strokes[edge.stroke].region;
      return !gone[region];
    };
    EXPECT_EQ(static_cast<long>(trimmed.edges.size()),
      std::count_if(mesh.edges.begin(), mesh.edges.end(), onKeptStroke));
  }
  PlanarMesh wrong = mesh;
  wrong.faces[5].region = 4;
  EXPECT_THROW(withoutRegions(wrong, { 0, 0, 0, 0 }), Error);
}
