// Facts of image-assisted.md, section 10: refinement with Catmull and Clark's masks; and both masks beside
// those of CGAL where it is.
#include "Harness/refine_shapes.h"
#include "Harness/shapes.h"
#include "Planar/guard.h"

#include <gtest/gtest.h>

#ifdef OVERSKETCH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#endif

using namespace oversketch;
using namespace oversketch_test;

namespace
{

PlanarMesh refinedQuads(const CoarseDrawing& drawing, int levels, bool guard = true)
{
  PlanarRefineOptions options;
  options.levels = levels;
  options.guard = guard;
  options.quads = true;
  const PlanarRefineResult result = refinePlanar(drawing.mesh, drawing.strokes, options, Context());
  EXPECT_TRUE(result.splits.empty());
  return result.mesh;
}

std::vector<CoarseDrawing> mixedDrawings()
{
  std::vector<CoarseDrawing> drawings{ squareDrawing(), discDrawing(0.3), bowDrawing() };
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    drawings.push_back(gridDrawing(5, seed == 1 ? Cells::Quads : Cells::Mixed, seed % 2 == 0, seed));
  }
  return drawings;
}

int quadsOf(const PlanarMesh& mesh)
{
  return static_cast<int>(std::count_if(
    mesh.faces.begin(), mesh.faces.end(), [](const PlanarFace& face) { return face.count() == 4; }));
}

} // namespace

TEST(C10_1, OneLevelMakesQuadsOfAll)
{
  int compared = 0;
  for (const CoarseDrawing& drawing : mixedDrawings())
  {
    const int quads = quadsOf(drawing.mesh), triangles = static_cast<int>(drawing.mesh.faces.size()) - quads;
    for (int k = 1; k <= 4; ++k)
    {
      const PlanarMesh mesh = refinedQuads(drawing, k);
      EXPECT_EQ(quadsOf(mesh), static_cast<int>(mesh.faces.size()));
      EXPECT_EQ(quadsOf(mesh), (3 * triangles + 4 * quads) << (2 * (k - 1)));
      EXPECT_EQ(mesh.edges.size(), drawing.mesh.edges.size() << k);
      std::map<int, int> ofBase;
      for (const PlanarFace& face : mesh.faces)
      {
        ++ofBase[face.base];
      }
      for (const auto& [base, count] : ofBase)
      {
        EXPECT_EQ(count, drawing.mesh.faces[base].count() << (2 * (k - 1)));
      }
      EXPECT_TRUE(invertedFaces(mesh, 1e-12, Context()).empty());
      ++compared;
    }
  }
  fact("C10_1",
    std::to_string(compared) + " meshes of levels 1 to 4, mixed: all quads, (3T + 4Q) 4^(k-1) of them");
}

TEST(C10_4, InsertedPointsOfQuadsAreRegular)
{
  int inner = 0, outer = 0, centres = 0;
  for (const CoarseDrawing& drawing : mixedDrawings())
  {
    const int base = static_cast<int>(drawing.mesh.points.size());
    const int edges = static_cast<int>(faceEdges(drawing.mesh).edges.size());
    const PlanarMesh mesh = refinedQuads(drawing, 3);
    const FaceEdges links = faceEdges(mesh);
    for (int p = base; p < static_cast<int>(mesh.points.size()); ++p)
    {
      const int face = p - base - edges; // that it is the centre of, at level 1
      if (face >= 0 && face < static_cast<int>(drawing.mesh.faces.size()) &&
          drawing.mesh.faces[face].count() == 3)
      {
        EXPECT_EQ(links.atPoint.size(p), 3);
        ++centres;
        continue;
      }
      const bool rim = isRim(mesh.points[p].kind);
      EXPECT_EQ(links.atPoint.size(p), rim ? 3 : 4);
      ++(rim ? outer : inner);
    }
  }
  EXPECT_GT(centres, 0);
  fact("C10_4",
    "all " + std::to_string(inner) + " inserted inner points have 4 edges, all " + std::to_string(outer) +
      " on the boundary 3, the centres of " + std::to_string(centres) + " triangles 3");
}

TEST(Quads, KeepStrokesAndAreas)
{
  for (const CoarseDrawing& drawing : mixedDrawings())
  {
    const std::vector<StrokeByLength> curves(drawing.strokes.begin(), drawing.strokes.end());
    for (const PlanarPoint& point : refinedQuads(drawing, 4).points)
    {
      if (point.stroke >= 0)
      {
        EXPECT_LE((point.place - curves[point.stroke].at(point.param)).norm(), 1e-12);
      }
    }
  }
  CoarseDrawing square = squareDrawing();
  square.mesh.points.pop_back();
  square.mesh.faces.clear();
  square.addFace({ 0, 1, 2, 3 });
  for (int k = 0; k <= 6; ++k)
  {
    const PlanarMesh mesh = refinedQuads(square, k);
    EXPECT_EQ(areaOf(mesh), 0.25);
    EXPECT_EQ(mesh.faces.size(), std::size_t(1) << (2 * k));
  }
}

TEST(Quads, AreUprightAtBothDiagonals)
{
  // A quad that is no longer convex at its third corner, though its area is positive.
  PlanarMesh mesh;
  for (const Vector2& place : { Vector2(0, 0), Vector2(1, 0), Vector2(0.3, 0.3), Vector2(0, 1) })
  {
    mesh.points.emplace_back();
    mesh.points.back().place = place;
  }
  mesh.faces.push_back({ { 0, 1, 2, 3 }, 0, 0, 0 });
  EXPECT_GT(areaOf(mesh), 0.0);
  for (int turned = 0; turned < 4; ++turned)
  {
    EXPECT_EQ(invertedFaces(mesh, 1e-12, Context()).size(), 1u);
    std::rotate(
      mesh.faces[0].corners.begin(), mesh.faces[0].corners.begin() + 1, mesh.faces[0].corners.end());
  }
  mesh.points[2].place = Vector2(0.6, 0.6);
  EXPECT_TRUE(invertedFaces(mesh, 1e-12, Context()).empty());
  mesh.points[2].place = Vector2(0.5, 0.5); // a corner of no angle
  EXPECT_EQ(invertedFaces(mesh, 1e-12, Context()).size(), 1u);
}

#ifdef OVERSKETCH_CGAL
namespace
{

using CgalPoint = CGAL::Simple_cartesian<double>::Point_3;
using CgalMesh = CGAL::Surface_mesh<CgalPoint>;

CgalMesh cgalMeshOf(const PlanarMesh& mesh)
{
  CgalMesh made;
  for (const PlanarPoint& point : mesh.points)
  {
    made.add_vertex({ point.place[0], point.place[1], 0.0 });
  }
  for (const PlanarFace& face : mesh.faces)
  {
    std::vector<CgalMesh::Vertex_index> corners;
    corners.reserve(face.count());
    for (int i = 0; i < face.count(); ++i)
    {
      corners.emplace_back(face.corners[i]);
    }
    made.add_face(corners);
  }
  return made;
}

// How far the free points that `reached` accepts are from CGAL's points, at most.
double farthestFrom(const CgalMesh& peer, const PlanarMesh& mesh, double margin, int& compared)
{
  double worst = 0.0;
  for (const PlanarPoint& point : mesh.points)
  {
    const Vector2& p = point.place;
    if (point.stroke >= 0 || std::min({ p[0], p[1], 1.0 - p[0], 1.0 - p[1] }) < margin)
    {
      continue;
    }
    double nearest = 1.0;
    for (const CgalMesh::Vertex_index v : peer.vertices())
    {
      nearest = std::min(nearest, std::hypot(peer.point(v).x() - p[0], peer.point(v).y() - p[1]));
    }
    worst = std::max(worst, nearest);
    ++compared;
  }
  return worst;
}

} // namespace

TEST(Masks, AreThoseOfCgal)
{
  int loop = 0, catmullClark = 0;
  double worst = 0.0;
  for (unsigned seed = 1; seed <= 3; ++seed)
  {
    for (int k = 1; k <= 2; ++k)
    {
      // Border points are moved by CGAL and not by us: what they reach is left out from level 2 on.
      const double margin = k == 1 ? 0.0 : 2.5 / 9;
      const CoarseDrawing triangles = gridDrawing(9, Cells::Triangles, false, seed);
      CgalMesh peer = cgalMeshOf(triangles.mesh);
      CGAL::Subdivision_method_3::Loop_subdivision(peer, CGAL::parameters::number_of_iterations(k));
      PlanarRefineOptions options;
      options.levels = k;
      worst = std::max(worst,
        farthestFrom(
          peer, refinePlanar(triangles.mesh, triangles.strokes, options, Context()).mesh, margin, loop));
      const CoarseDrawing mixed = gridDrawing(9, Cells::Mixed, false, seed);
      peer = cgalMeshOf(mixed.mesh);
      CGAL::Subdivision_method_3::CatmullClark_subdivision(peer, CGAL::parameters::number_of_iterations(k));
      worst = std::max(worst, farthestFrom(peer, refinedQuads(mixed, k), margin, catmullClark));
    }
  }
  EXPECT_GT(loop, 1000);
  EXPECT_GT(catmullClark, 1000);
  EXPECT_LE(worst, 1e-14);
}
#endif
