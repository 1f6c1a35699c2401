// Surfaces from strokes on: approximation, triangulation, refinement and what is made of their mesh.
#include "Harness/refine_runs.h"
#include "Harness/shapes.h"
#include "Harness/solid_shape.h"
#include "Inflate/heights.h"
#include "Inflate/solid.h"
#include "Inflate/swap_edges.h"
#include "Inflate/unstretch.h"
#include "Planar/guard.h"
#include "Raster/grid_smoothing.h"

#include <gtest/gtest.h>

#include <map>

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

// The maps, and the solid made with them.
Solid inflated(const UnitDrawing& drawing, const PlanarMesh& mesh, bool unstretched)
{
  GridSmoothing grid(drawing.maps, 2, Context());
  const CrossSection section;
  const std::vector<float> ratio =
    grid.profileRatio(roundSquares(drawing.maps, Context()), section.smoothing(), Context());
  const std::vector<float> thickness = roundThickness(drawing.maps, ratio);
  const HeightMaps maps{ drawing.maps, thickness, ratio, Inflation::Ratio };
  PlanarMesh moved = unstretched ? unstretch(mesh, maps, Context()) : mesh;
  const std::vector<double> heights = heightsOf(moved, maps, section, 1.0, Context());
  if (unstretched)
  {
    swapEdges(moved, heights, maps, section, 1.0, Context());
  }
  EXPECT_TRUE(invertedFaces(moved, 0.0, Context()).empty());
  return inflate(moved, heights);
}

// The mean angle between faces across the edges of a seam over that across those beside it that end off it:
// of triangles with a corner on it.
double rimBend(const Solid& solid)
{
  const auto onSeam = [&](int v) { return solid.points[v].side == 0; };
  std::map<std::pair<int, int>, std::vector<std::pair<Vector3, bool>>> edges; // normals, whether at the seam
  for (const SolidFace& face : solid.faces)
  {
    const auto& c = face.corners;
    const Vector3& p = solid.points[c[0]].place;
    const Vector3 normal = (solid.points[c[1]].place - p).cross(solid.points[c[2]].place - p).normalized();
    const bool touches = onSeam(c[0]) || onSeam(c[1]) || onSeam(c[2]);
    for (int k = 0; k < 3; ++k)
    {
      edges[std::minmax(c[k], c[(k + 1) % 3])].emplace_back(normal, touches);
    }
  }
  double across = 0.0, beside = 0.0;
  int acrossCount = 0, besideCount = 0;
  for (const auto& [ends, faces] : edges)
  {
    const int on = onSeam(ends.first) + onSeam(ends.second);
    const double angle = std::acos(std::clamp(faces[0].first.dot(faces[1].first), -1.0, 1.0));
    if (on == 2)
    {
      across += angle;
      ++acrossCount;
    }
    else if (on == 0 && (faces[0].second || faces[1].second))
    {
      beside += angle;
      ++besideCount;
    }
  }
  return across / acrossCount / (beside / besideCount);
}

} // namespace

TEST(Drawings, RimsBendNoMoreThanWhatIsBesideThem)
{
  const std::vector<NamedDrawing> all = drawings();
  double plain = 0.0, now = 0.0;
  for (const int i : { 0, 2 })
  {
    const UnitDrawing drawing(all[i].strokes, all[i].treatments);
    PlanarRefineOptions options;
    options.levels = 3;
    const PlanarMesh mesh = rebuilt(drawing, DeltaMode::Adaptive, options).result.mesh;
    plain += 0.5 * rimBend(inflated(drawing, mesh, false));
    now += 0.5 * rimBend(inflated(drawing, mesh, true));
  }
  EXPECT_GT(plain, 1.3);
  EXPECT_LT(now, 1.2);
}

TEST(Drawings, BecomeClosedSurfaces)
{
  for (const NamedDrawing& named : drawings())
  {
    const UnitDrawing drawing(named.strokes, named.treatments);
    for (const bool quads : { false, true })
    {
      PlanarRefineOptions options;
      options.levels = 2;
      options.quads = quads;
      const PlanarMesh mesh = rebuilt(drawing, DeltaMode::Adaptive, options).result.mesh;
      for (const int kind : { 0, 1, 2 })
      {
        const Solid whole =
          kind == 2 ? extrude(mesh, 0.1, WallRows::Refined) : inflated(drawing, mesh, kind == 1);
        const std::vector<char> gone = regionsInTunnels(drawing.classes, drawing.treatments);
        std::vector<char> removed;
        for (const SolidFace& face : whole.faces)
        {
          removed.push_back(gone[mesh.faces[face.source].region]);
        }
        const Shape shape = shapeOf(tunnel(whole, removed, true));
        EXPECT_EQ(shape.loops + shape.odd + shape.pinched, 0) << named.name << kind << quads;
        EXPECT_EQ(shape.chi, 2 - 2 * named.handles) << named.name << kind << quads;
        EXPECT_GT(shape.volume, 0.0);
        EXPECT_EQ(quads ? shape.triangles : shape.quads, 0);
      }
    }
  }
}
