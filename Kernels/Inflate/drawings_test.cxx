// Surfaces from strokes on: approximation, triangulation, refinement and what is made of their mesh.
#include "Harness/shapes.h"
#include "Inflate/extrude.h"
#include "Inflate/heights.h"
#include "Inflate/inflate.h"
#include "Inflate/solid_shape.h"
#include "Inflate/tunnel.h"
#include "Inflate/unstretch.h"
#include "Planar/guard.h"
#include "Planar/refine_runs.h"
#include "Planar/terminal.h"
#include "Raster/grid_smoothing.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct NamedDrawing
{
  std::string name;
  std::vector<DrawnStroke> strokes;
  std::vector<Treatment> treatments;
  int handles; // holes and tunnels
};

std::vector<NamedDrawing> drawings()
{
  const auto star = [](double a, int n)
  { return polarStroke(0.5, 0.5, [=](double t) { return 0.3 * (1.0 + a * std::cos(n * t)); }); };
  const auto bow = evenStroke({ { 0.45, 0.42 }, { 0.5, 0.38 }, { 0.56, 0.43 } }, false);
  const Treatment fill = Treatment::Fill, hole = Treatment::Hole, through = Treatment::Tunnel;
  return { { "star of five", { star(0.3, 5) }, {}, 0 },
    { "star of seven with a bow", { star(0.4, 7), bow }, {}, 0 },
    { "body with a hole and a tunnel",
      { circleStroke(0.5, 0.5, 0.4), circleStroke(0.35, 0.5, 0.1), circleStroke(0.68, 0.5, 0.12), bow },
      { fill, hole, through, fill },
      2 },
    { "tunnel with a filled part, a hole in it",
      { circleStroke(0.5, 0.5, 0.4), circleStroke(0.5, 0.5, 0.25), circleStroke(0.5, 0.5, 0.1) },
      { fill, through, hole },
      1 } };
}

// Terminal triangles divided, as what is to be sealed must be.
PlanarMesh meshOf(const UnitDrawing& drawing)
{
  PlanarRefineOptions options;
  options.levels = 2;
  std::vector<StrokeSplit> splits;
  for (int round = 0; round <= 24; ++round)
  {
    const std::vector<StrokeLine> lines = strokeLines(
      drawing.polylines({}, splits), drawing.strokes, drawing.classes.strokes, drawing.treatments);
    const PlanarMesh coarse =
      repairTerminals(triangulate(lines, {}, Context()), TerminalRule::TwoBoundaryEdges);
    PlanarRefineResult result = refinePlanar(coarse, drawing.strokes, options, Context());
    if (result.splits.empty())
    {
      return std::move(result.mesh);
    }
    addSplits(splits, result.splits);
  }
  throw Error(Failure::BadStroke, "24 rounds were not enough");
}

// The maps, and the solid made with them.
Solid inflated(const UnitDrawing& drawing, const PlanarMesh& mesh, bool unstretched)
{
  GridSmoothing grid(drawing.maps, 2, Context());
  const CrossSection section;
  const std::vector<float> thickness = grid.thickness(0.5, Context());
  const std::vector<float> ratio = grid.profileRatio(
    thickness, sectionSquares(drawing.maps, thickness, section, Context()), section.smoothing(), Context());
  const HeightMaps maps{ drawing.maps, thickness, ratio };
  const PlanarMesh moved = unstretched ? unstretch(mesh, maps, Context()) : mesh;
  EXPECT_TRUE(invertedFaces(moved, 0.0, Context()).empty());
  return inflate(moved, heightsOf(moved, maps, section, 1.0, Context()));
}

} // namespace

TEST(Drawings, BecomeClosedSurfaces)
{
  for (const NamedDrawing& named : drawings())
  {
    const UnitDrawing drawing(named.strokes, named.treatments);
    const PlanarMesh mesh = meshOf(drawing);
    for (const int kind : { 0, 1, 2 })
    {
      const Solid whole =
        kind == 2 ? extrude(mesh, 0.1, WallRows::Refined) : inflated(drawing, mesh, kind == 1);
      std::vector<char> removed;
      for (const SolidFace& face : whole.faces)
      {
        bool gone = false;
        for (int r = mesh.faces[face.source].region; r >= 0; r = drawing.classes.regions[r].parent)
        {
          const Region& region = drawing.classes.regions[r];
          gone |= region.parent >= 0 && drawing.treatments[region.stroke] == Treatment::Tunnel;
        }
        removed.push_back(gone);
      }
      const Shape shape = shapeOf(tunnel(whole, removed, true));
      EXPECT_EQ(shape.loops + shape.odd + shape.pinched, 0) << named.name << kind;
      EXPECT_EQ(shape.chi, 2 - 2 * named.handles) << named.name << kind;
      EXPECT_GT(shape.volume, 0.0);
    }
  }
}
