// Facts of image-assisted.md, sections 7 and 10: terminal triangles and merged ones.
#include "Harness/planar_shapes.h"
#include "Planar/coarse_faces.h"
#include "Planar/darts.h"
#include "Planar/predicates.h"
#include "Planar/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Concave outlines with limbs, one with a hole and a feature, one with a feature from rim to rim.
std::vector<UnitDrawing> bodies()
{
  std::vector<UnitDrawing> result;
  for (int petals = 2; petals < 9; ++petals)
  {
    for (const double amplitude : { 0.1, 0.35, 0.6 })
    {
      result.emplace_back(std::vector<DrawnStroke>{ polarStroke(
        0.5, 0.5, [=](double a) { return 0.28 * (1.0 + amplitude * std::cos(petals * a)); }, 0.1) });
    }
  }
  result.emplace_back(std::vector<DrawnStroke>{ circleStroke(0.5, 0.5, 0.4),
                        circleStroke(0.55, 0.5, 0.2),
                        evenStroke({ { 0.2, 0.4 }, { 0.2, 0.6 } }, false) },
    std::vector<Treatment>{ Treatment::Fill, Treatment::Hole, Treatment::Fill });
  result.emplace_back(std::vector<DrawnStroke>{
    circleStroke(0.5, 0.5, 0.4), evenStroke({ { 0.106, 0.5 }, { 0.894, 0.5 } }, false) });
  return result;
}

double twiceTheArea(const PlanarMesh& mesh, const PlanarFace& face)
{
  double area = 0.0;
  for (int k = 0; k < face.count(); ++k)
  {
    const Vector2 a = mesh.points[face.corners[k]].place - mesh.points[face.corners[0]].place;
    const Vector2 b =
      mesh.points[face.corners[(k + 1) % face.count()]].place - mesh.points[face.corners[0]].place;
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area;
}

// Faces of each edge.
std::map<std::pair<int, int>, std::vector<int>> facesOfEdges(const PlanarMesh& mesh)
{
  std::map<std::pair<int, int>, std::vector<int>> faces;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int k = 0; k < face.count(); ++k)
    {
      faces[std::minmax(face.corners[k], face.corners[(k + 1) % face.count()])].push_back(
        static_cast<int>(f));
    }
  }
  return faces;
}

int terminals(const PlanarMesh& mesh)
{
  std::vector<int> borders(mesh.faces.size(), 0);
  for (const auto& [edge, faces] : facesOfEdges(mesh))
  {
    EXPECT_LE(faces.size(), 2u);
    borders[faces[0]] += faces.size() == 1;
  }
  return static_cast<int>(std::count_if(borders.begin(), borders.end(), [](int count) { return count > 1; }));
}

double areaOf(const PlanarMesh& mesh)
{
  double area = 0.0;
  for (const PlanarFace& face : mesh.faces)
  {
    const double here = 0.5 * twiceTheArea(mesh, face);
    EXPECT_GT(here, 0.0);
    area += here;
  }
  return area;
}

} // namespace

TEST(C7_3, ASquareHasFiveVerticesAndFourTriangles)
{
  const UnitDrawing drawing({ squareStroke(0.1, 0.9) });
  const PlanarMesh bare = triangulate(drawing.lines(), {}, Context());
  EXPECT_EQ(bare.faces.size(), 2u);
  const PlanarMesh mesh = repairTerminals(bare, TerminalRule::TwoBoundaryEdges);
  EXPECT_EQ(mesh.points.size(), 5u);
  EXPECT_EQ(mesh.faces.size(), 4u);
  EXPECT_NEAR((mesh.points[4].place - Vector2(0.5, 0.5)).norm(), 0.0, 1e-15);
  EXPECT_EQ(mesh.points[4].kind, BoundaryKind::Interior);
  fact("C7_3", "square: 5 vertices, 4 triangles");
}

TEST(C7_4, NoTriangleKeepsTwoBoundaryEdges)
{
  int before = 0, meshes = 0, kept = 0;
  double least = 1.0;
  for (const UnitDrawing& drawing : bodies())
  {
    const PlanarMesh bare = triangulate(drawing.lines(), {}, Context());
    before += terminals(bare);
    const PlanarMesh mesh = repairTerminals(bare, TerminalRule::TwoBoundaryEdges);
    EXPECT_EQ(terminals(mesh), 0);
    EXPECT_NEAR(areaOf(mesh), areaOf(bare), 1e-14);
    for (const PlanarFace& face : mesh.faces)
    {
      least = std::min(least, 0.5 * twiceTheArea(mesh, face));
    }
    // Strokes' edges stay, and the doubled mesh's edges at level 0 but chords have two faces.
    const auto faces = facesOfEdges(mesh);
    for (const StrokeEdge& edge : mesh.edges)
    {
      EXPECT_TRUE(faces.count(std::minmax(edge.from, edge.to)));
      ++kept;
    }
    EXPECT_EQ(mesh.edges.size(), bare.edges.size());
    for (std::size_t i = 0; i < bare.points.size(); ++i)
    {
      EXPECT_EQ(mesh.points[i].place, bare.points[i].place);
    }
    ++meshes;
  }
  EXPECT_GT(before, 40);
  fact("C7_4",
    std::to_string(meshes) + " bodies, most of them concave: " + std::to_string(before) +
      " triangles with two boundary edges before, 0 after; least signed area " + digits(least * 1e5) +
      "e-5, " + std::to_string(kept) + " edges of strokes kept");
}

TEST(Terminal, ThreeBoundaryVerticesIsTheLiteralRule)
{
  int before = 0, after = 0;
  for (const UnitDrawing& drawing : bodies())
  {
    const PlanarMesh bare = triangulate(drawing.lines(), {}, Context());
    const PlanarMesh mesh = repairTerminals(bare, TerminalRule::ThreeBoundaryVertices);
    const auto onRims = [](const PlanarMesh& m)
    {
      return std::count_if(m.faces.begin(),
        m.faces.end(),
        [&](const PlanarFace& face)
        {
          return std::all_of(
            face.corners.begin(), face.corners.begin() + 3, [&](int c) { return isRim(m.points[c].kind); });
        });
    };
    before += static_cast<int>(onRims(bare));
    after += static_cast<int>(onRims(mesh));
    EXPECT_EQ(terminals(mesh), 0);
    EXPECT_NEAR(areaOf(mesh), areaOf(bare), 1e-14);
  }
  EXPECT_GT(before, 100);
  EXPECT_EQ(after, 0);
}

TEST(Terminal, ATriangleAloneAndOneAtAFeature)
{
  const PlanarMesh alone =
    repairTerminals(triangulate(UnitDrawing({ polygonStroke(0.5, 0.5, 0.3, 3) }).lines(), {}, Context()),
      TerminalRule::TwoBoundaryEdges);
  EXPECT_EQ(alone.points.size(), 4u);
  EXPECT_EQ(alone.faces.size(), 3u);
  // The square's diagonal is a feature: each half gets a point of its own.
  UnitDrawing square(
    { squareStroke(0.1, 0.9), evenStroke({ { 0.1008, 0.1008 }, { 0.8992, 0.8992 } }, false) });
  std::vector<StrokeLine> lines = square.lines();
  ASSERT_GE(lines[1].places.size(), 3u) << "a line from rim to rim has a point between them";
  lines[1].places.erase(lines[1].places.begin() + 1, lines[1].places.end() - 1);
  lines[1].params.erase(lines[1].params.begin() + 1, lines[1].params.end() - 1);
  const PlanarMesh bare = triangulate(lines, {}, Context());
  ASSERT_EQ(bare.faces.size(), 2u);
  const PlanarMesh mesh = repairTerminals(bare, TerminalRule::TwoBoundaryEdges);
  EXPECT_EQ(mesh.points.size(), 6u);
  EXPECT_EQ(mesh.faces.size(), 6u);
  EXPECT_EQ(mesh.edges.size(), 5u);
  EXPECT_EQ(terminals(mesh), 0);
  EXPECT_TRUE(repairTerminals({}, TerminalRule::TwoBoundaryEdges).faces.empty());
}

TEST(Terminal, AFlatEarIsDividedAtItsEdge)
{
  // The mean of the four corners does not see the edge from the second to the third.
  PlanarMesh mesh;
  for (const Vector2& place : { Vector2(0.0, 0.0), Vector2(8.0, -0.5), Vector2(1.0, 0.0), Vector2(0.5, 0.2) })
  {
    PlanarPoint point;
    point.place = place;
    point.kind = BoundaryKind::Object;
    mesh.points.push_back(point);
  }
  PlanarFace ear, body;
  ear.corners = { 0, 1, 2, -1 };
  body.corners = { 0, 2, 3, -1 };
  mesh.faces = { ear, body };
  const PlanarMesh repaired = repairTerminals(mesh, TerminalRule::TwoBoundaryEdges);
  EXPECT_EQ(repaired.faces.size(), 4u);
  EXPECT_EQ(repaired.points[4].place, Vector2(0.5, 0.0));
  EXPECT_NEAR(areaOf(repaired), areaOf(mesh), 1e-15);
  // No point lies in a triangle of no area.
  mesh.points[1].place = { 2.0, 0.0 };
  try
  {
    repairTerminals(mesh, TerminalRule::TwoBoundaryEdges);
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_NE(std::string(error.what()).find("too thin near (0.5, 0)"), std::string::npos);
  }
}

TEST(Relax, TrianglesAreOfBetterShapeAndNothingElseChanges)
{
  double was = 0.0, is = 0.0;
  for (const UnitDrawing& drawing : bodies())
  {
    const std::vector<StrokeLine> lines = drawing.lines();
    const std::vector<Vector2> darts = throwDarts(drawing.maps, lines, DartMode::Local, 1, Context());
    const PlanarMesh before =
      repairTerminals(triangulate(lines, darts, Context()), TerminalRule::TwoBoundaryEdges);
    const PlanarMesh after = relaxed(before);
    EXPECT_NEAR(areaOf(after), areaOf(before), 1e-14);
    ASSERT_EQ(after.points.size(), before.points.size());
    for (std::size_t p = 0; p < before.points.size(); ++p)
    {
      EXPECT_TRUE(
        before.points[p].kind == BoundaryKind::Interior || after.points[p].place == before.points[p].place);
    }
    const auto narrow = [](const PlanarMesh& mesh)
    {
      std::vector<double> least;
      for (const PlanarFace& face : mesh.faces)
      {
        double angle = 10.0;
        for (int k = 0; k < 3; ++k)
        {
          const Vector2& at = mesh.points[face.corners[k]].place;
          const Vector2 u = mesh.points[face.corners[(k + 1) % 3]].place - at,
                        v = mesh.points[face.corners[(k + 2) % 3]].place - at;
          angle = std::min(angle, std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)));
        }
        EXPECT_GT(angle, 0.0);
        least.push_back(angle);
      }
      std::sort(least.begin(), least.end());
      return least[least.size() / 20];
    };
    was += narrow(before);
    is += narrow(after);
  }
  EXPECT_GT(is, 1.15 * was);
}

TEST(C10_2, ASquareIsOneQuadButNotAtItsRim)
{
  // An inner one, whose edges are a feature's, is merged; a rim's corners keep their two faces.
  const PlanarMesh bare =
    triangulate(UnitDrawing({ squareStroke(0.1, 0.9), squareStroke(0.3, 0.7) }).lines(), {}, Context());
  const PlanarMesh mesh = mergeQuads(repairTerminals(bare, TerminalRule::TwoBoundaryEdges));
  int inner = 0, ears = 0;
  const auto faces = facesOfEdges(mesh);
  for (const PlanarFace& face : mesh.faces)
  {
    const int n = face.count();
    int features = 0;
    for (int k = 0; k < n; ++k)
    {
      const int a = face.corners[k], b = face.corners[(k + 1) % n], c = face.corners[(k + 2) % n];
      features += mesh.points[a].kind == BoundaryKind::Feature;
      ears += faces.at(std::minmax(a, b)).size() == 1 && faces.at(std::minmax(b, c)).size() == 1;
    }
    inner += n == 4 && features == 4;
  }
  EXPECT_EQ(inner, 1);
  EXPECT_EQ(ears, 0);
  const PlanarMesh whole =
    mergeQuads(repairTerminals(triangulate(UnitDrawing({ squareStroke(0.1, 0.9) }).lines(), {}, Context()),
      TerminalRule::TwoBoundaryEdges));
  EXPECT_EQ(whole.faces.size(), 4u);
  EXPECT_EQ(whole.points.size(), 5u);
  EXPECT_NEAR(areaOf(whole), 0.64, 1e-15);
  fact("C10_2",
    "square of a feature: its base is one quad; of a rim: four triangles, so that none has two edges of it");
}

TEST(C10_3, NoStrokesEdgeIsMergedAway)
{
  int edges = 0, quads = 0, triangles = 0;
  for (const UnitDrawing& drawing : bodies())
  {
    const PlanarMesh bare = triangulate(drawing.lines(), {}, Context());
    const PlanarMesh mesh = mergeQuads(bare);
    EXPECT_NEAR(areaOf(mesh), areaOf(bare), 1e-14);
    const auto faces = facesOfEdges(mesh);
    for (const StrokeEdge& edge : mesh.edges)
    {
      EXPECT_TRUE(faces.count(std::minmax(edge.from, edge.to)));
      ++edges;
    }
    EXPECT_EQ(mesh.edges.size(), bare.edges.size());
    for (const PlanarFace& face : mesh.faces)
    {
      const int n = face.count();
      (n == 4 ? quads : triangles) += 1;
      std::array<Vector2, 4> places;
      for (int k = 0; k < n; ++k)
      {
        places[k] = mesh.points[face.corners[k]].place;
        EXPECT_EQ(orientation(mesh.points[face.corners[k]].place,
                    mesh.points[face.corners[(k + 1) % n]].place,
                    mesh.points[face.corners[(k + 2) % n]].place),
          1);
      }
      EXPECT_TRUE(n == 3 || quadQuality(places) > 0.1);
    }
    // Of two triangles that stayed, none could have been merged.
    std::set<std::pair<int, int>> onStrokes;
    for (const StrokeEdge& edge : mesh.edges)
    {
      onStrokes.insert(std::minmax(edge.from, edge.to));
    }
    for (const auto& [edge, sides] : faces)
    {
      if (sides.size() == 2 && !onStrokes.count(edge) && mesh.faces[sides[0]].count() == 3 &&
          mesh.faces[sides[1]].count() == 3)
      {
        std::array<int, 2> far{ -1, -1 };
        for (int i = 0; i < 2; ++i)
        {
          for (int k = 0; k < 3; ++k)
          {
            const int c = mesh.faces[sides[i]].corners[k];
            far[i] = c != edge.first && c != edge.second ? c : far[i];
          }
        }
        std::array<int, 4> quad{ far[0], edge.first, far[1], edge.second };
        if (orientation(mesh.points[quad[0]].place, mesh.points[quad[1]].place, mesh.points[quad[3]].place) <
            0)
        {
          std::swap(quad[1], quad[3]);
        }
        std::array<Vector2, 4> places;
        std::transform(quad.begin(), quad.end(), places.begin(), [&](int c) { return mesh.points[c].place; });
        const bool convex = orientation(places[0], places[1], places[2]) > 0 &&
                            orientation(places[2], places[3], places[0]) > 0;
        const auto isBorder = [&](int a, int b) { return faces.at(std::minmax(a, b)).size() == 1; };
        const bool ear = (isBorder(far[0], edge.first) && isBorder(edge.first, far[1])) ||
                         (isBorder(far[0], edge.second) && isBorder(edge.second, far[1]));
        EXPECT_FALSE(convex && !ear && quadQuality(places) > 0.1);
      }
    }
  }
  EXPECT_GT(quads, triangles);
  fact("C10_3",
    std::to_string(edges) + " edges of strokes stay; " + std::to_string(quads) + " quads, " +
      std::to_string(triangles) + " triangles");
}
