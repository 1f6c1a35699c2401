// Facts of image-assisted.md, section 7.
#include "Harness/planar_shapes.h"
#include "Planar/delaunay.h"
#include "Planar/predicates.h"
#include "Planar/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#ifdef OVERSKETCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#endif

using namespace oversketch;
using namespace oversketch_test;

namespace
{

double areaOf(const Polyline& points)
{
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector2 &a = points[i], &b = points[(i + 1) % points.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return std::abs(area);
}

double areaOf(const PlanarMesh& mesh, const PlanarFace& face)
{
  const Vector2 a = mesh.points[face.corners[0]].place;
  const Vector2 u = mesh.points[face.corners[1]].place - a, v = mesh.points[face.corners[2]].place - a;
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

std::map<int, double> areasOf(const PlanarMesh& mesh)
{
  std::map<int, double> areas;
  for (const PlanarFace& face : mesh.faces)
  {
    areas[face.region] += areaOf(mesh, face);
    EXPECT_GT(areaOf(mesh, face), 0.0);
  }
  return areas;
}

std::set<std::pair<int, int>> edgesOf(const PlanarMesh& mesh)
{
  std::set<std::pair<int, int>> edges;
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(face.corners[k], face.corners[(k + 1) % 3]));
    }
  }
  return edges;
}

// An outline with a limb, a filled child that holds a hole, open features one of which joins the rim, a
// second object.
std::vector<DrawnStroke> menagerie()
{
  return { polarStroke(0.35, 0.5, [](double a) { return 0.25 * (1.0 + 0.25 * std::cos(5 * a)); }),
    circleStroke(0.3, 0.5, 0.1),
    circleStroke(0.3, 0.5, 0.05),
    evenStroke({ { 0.44, 0.4 }, { 0.47, 0.5 }, { 0.44, 0.6 } }, false),
    evenStroke({ { 0.5, 0.5 }, { 0.654, 0.501 } }, false),
    polygonStroke(0.82, 0.5, 0.15, 5) };
}

const Treatment fill = Treatment::Fill, hole = Treatment::Hole, tunnel = Treatment::Tunnel;

// Ascending random points, some of them on a grid, where many lie on one circle.
Polyline randomPoints(int count, std::mt19937& random, bool grid)
{
  std::uniform_real_distribution<double> place(0.0, 1.0);
  std::set<std::pair<double, double>> points;
  while (static_cast<int>(points.size()) < count)
  {
    double x = place(random), y = place(random);
    if (grid)
    {
      x = std::floor(x * 24.0) / 24.0;
      y = std::floor(y * 24.0) / 24.0;
    }
    points.emplace(x, y);
  }
  Polyline result;
  for (const auto& [x, y] : points)
  {
    result.emplace_back(x, y);
  }
  return result;
}

// Constraints between the points that cross no other one and go through no point.
std::vector<Constraint> randomConstraints(const Polyline& points, int tries, std::mt19937& random)
{
  std::vector<Constraint> constraints;
  for (int i = 0; i < tries; ++i)
  {
    const int a = static_cast<int>(random() % points.size()), b = static_cast<int>(random() % points.size());
    const bool ok = a != b && (points[a] - points[b]).norm() < 0.4 &&
                    std::none_of(constraints.begin(),
                      constraints.end(),
                      [&](const Constraint& c)
                      { return segmentsMeet(points[a], points[b], points[c.from], points[c.to]); }) &&
                    std::none_of(points.begin(),
                      points.end(),
                      [&](const Vector2& p) {
                        return orientation(points[a], points[b], p) == 0 && between(points[a], points[b], p);
                      });
    if (ok)
    {
      constraints.push_back({ a, b, static_cast<int>(constraints.size()) });
    }
  }
  return constraints;
}

} // namespace

TEST(C7_1, SegmentsAreEdgesAndAreasThoseOfThePolygons)
{
  double worst = 0.0;
  int segments = 0;
  for (const bool holed : { false, true })
  {
    const UnitDrawing drawing(menagerie(), { fill, fill, holed ? hole : fill, fill, fill, fill });
    const std::vector<StrokeLine> lines = drawing.lines();
    const PlanarMesh mesh = triangulate(lines, {}, Context());
    const auto edges = edgesOf(mesh);
    std::size_t expected = 0;
    for (const StrokeLine& line : lines)
    {
      expected += line.places.size() - (line.closed ? 0 : 1);
    }
    ASSERT_EQ(mesh.edges.size(), expected);
    for (const StrokeEdge& edge : mesh.edges)
    {
      EXPECT_TRUE(edges.count(std::minmax(edge.from, edge.to)));
      EXPECT_LT(edge.start, edge.end);
      ++segments;
    }
    // Regions: what a closed line bounds without what those in it bound.
    std::map<int, double> expectedAreas;
    for (const StrokeLine& line : lines)
    {
      if (line.closed)
      {
        const double area = areaOf(line.places);
        expectedAreas[line.role == Role::Boundary ? line.region : line.childRegion] += area;
        if (line.role != Role::Boundary)
        {
          expectedAreas[line.region] -= area;
        }
        if (line.treatment == hole)
        {
          expectedAreas.erase(line.childRegion);
        }
      }
    }
    const auto areas = areasOf(mesh);
    ASSERT_EQ(areas.size(), expectedAreas.size());
    for (const auto& [region, area] : expectedAreas)
    {
      EXPECT_NEAR(areas.at(region), area, 1e-12);
      worst = std::max(worst, std::abs(areas.at(region) - area));
    }
  }
  fact("C7_1",
    std::to_string(segments) +
      " segments of 6 strokes, with and without a hole, are edges; areas of regions within " +
      digits(worst * 1e15) + "e-15");
}

TEST(C7_2, EdgesAreDelaunayAndThoseOfCgal)
{
  std::mt19937 random(11);
  int tested = 0, tied = 0, compared = 0;
  for (int run = 0; run < 30; ++run)
  {
    const bool grid = run % 2 == 1;
    const Polyline points = randomPoints(grid ? 250 : 400, random, grid);
    const std::vector<Constraint> constraints = randomConstraints(points, 100, random);
    const std::vector<DelaunayFace> faces = constrainedDelaunay(points, constraints, Context());
    std::set<std::pair<int, int>> edges;
    std::set<int> found;
    for (const DelaunayFace& face : faces)
    {
      EXPECT_EQ(orientation(points[face.corners[0]], points[face.corners[1]], points[face.corners[2]]), 1);
      for (int k = 0; k < 3; ++k)
      {
        const int a = face.corners[k], b = face.corners[(k + 1) % 3], c = face.corners[(k + 2) % 3];
        edges.insert(std::minmax(b, c));
        found.insert(face.constraints[k]);
        if (face.constraints[k] >= 0 || face.across[k] < 0)
        {
          continue;
        }
        const DelaunayFace& other = faces[face.across[k]];
        int d = -1;
        for (int j = 0; j < 3; ++j)
        {
          d = other.across[j] == &face - faces.data() ? other.corners[j] : d;
        }
        ASSERT_GE(d, 0);
        const int side = inCircle(points[a], points[b], points[c], points[d]);
        EXPECT_LE(side, 0);
        if (side == 0)
        {
          EXPECT_LT(std::min(b, c), std::min(a, d));
          ++tied;
        }
        ++tested;
      }
    }
    found.erase(-1);
    EXPECT_EQ(found.size(), constraints.size());
#ifdef OVERSKETCH_CGAL
    using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Exact>;
    using Face = CGAL::Constrained_triangulation_face_base_2<Exact>;
    using Peer =
      CGAL::Constrained_Delaunay_triangulation_2<Exact, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
    Peer peer;
    std::vector<Peer::Vertex_handle> handles;
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      handles.push_back(peer.insert(Exact::Point_2(points[i][0], points[i][1])));
      handles.back()->info() = static_cast<int>(i);
    }
    for (const Constraint& c : constraints)
    {
      peer.insert_constraint(handles[c.from], handles[c.to]);
    }
    // Ties as ours: flips until the diagonal holds the least point everywhere.
    for (bool flipped = true; flipped;)
    {
      flipped = false;
      for (const Peer::Edge& edge : peer.finite_edges())
      {
        Peer::Face_handle face = edge.first;
        const int i = edge.second;
        const Peer::Face_handle other = face->neighbor(i);
        if (face->is_constrained(i) || peer.is_infinite(face) || peer.is_infinite(other))
        {
          continue;
        }
        const int a = face->vertex(i)->info(), b = face->vertex(Peer::ccw(i))->info();
        const int c = face->vertex(Peer::cw(i))->info(), d = other->vertex(other->index(face))->info();
        if (inCircle(points[a], points[b], points[c], points[d]) == 0 && std::min(a, d) < std::min(b, c))
        {
          peer.flip(face, i);
          flipped = true;
          break;
        }
      }
    }
    std::set<std::pair<int, int>> theirs;
    for (const Peer::Edge& edge : peer.finite_edges())
    {
      theirs.insert(std::minmax(edge.first->vertex(Peer::ccw(edge.second))->info(),
        edge.first->vertex(Peer::cw(edge.second))->info()));
    }
    EXPECT_EQ(edges, theirs) << run;
    ++compared;
#endif
  }
  EXPECT_GT(tied, 100);
  fact("C7_2",
    std::to_string(tested / 2) + " unconstrained edges are Delaunay, " + std::to_string(tied / 2) +
      " of them by the tie rule; " + std::to_string(compared) +
      " of 30 edge sets compared with CGAL's: the same");
}

TEST(C7_5, CrossingStrokesAreNamed)
{
  // Classification rejects such strokes; lines that cross all the same are refused here.
  const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.4),
    evenStroke({ { 0.3, 0.4 }, { 0.3, 0.6 } }, false),
    evenStroke({ { 0.4, 0.5 }, { 0.6, 0.5 } }, false) });
  const std::vector<StrokeLine> lines = drawing.lines();
  const auto refusal = [&](std::size_t line, const Polyline& places)
  {
    std::vector<StrokeLine> changed = lines;
    changed[line].places = places;
    changed[line].params.resize(places.size(), 1.0);
    try
    {
      triangulate(changed, {}, Context());
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), Failure::BadStroke);
      return std::string(error.what());
    }
    return std::string("no refusal");
  };
  EXPECT_EQ(
    refusal(2, { { 0.25, 0.5 }, { 0.6, 0.5 } }).rfind("stroke 2 meets stroke 1 near (0.3, 0.5)", 0), 0u)
    << refusal(2, { { 0.25, 0.5 }, { 0.6, 0.5 } });
  EXPECT_EQ(
    refusal(2, { { 0.3, 0.45 }, { 0.6, 0.5 }, { 0.3, 0.55 } }).rfind("stroke 1 meets stroke 2", 0), 0u);
  EXPECT_EQ(refusal(2, { { 0.3, 0.4 }, { 0.3, 0.6 } }).rfind("stroke 2 meets stroke 1", 0), 0u);
  EXPECT_EQ(refusal(2, { { 0.4, 0.4 }, { 0.6, 0.6 }, { 0.4, 0.6 }, { 0.6, 0.4 } })
              .rfind("stroke 2 meets itself near (0.5, 0.5)", 0),
    0u);
  EXPECT_EQ(refusal(1, { { 0.3, 0.4 }, { 0.95, 0.6 } }).rfind("stroke 1 meets stroke", 0), 0u);
  EXPECT_EQ(refusal(1, { { 0.95, 0.4 }, { 0.96, 0.6 } }).rfind("stroke 1 is not where its region is", 0), 0u);
  EXPECT_EQ(refusal(0, { { 0.1, 0.1 }, { 0.9, 0.9 } }).rfind("stroke 0 is closed round nothing", 0), 0u);
  fact("C7_5",
    "lines that cross, run over each other or through a vertex, and one across itself: an error names the "
    "strokes");
}

TEST(C7_6, PermutedStrokesGiveTheSameMesh)
{
  const std::vector<DrawnStroke> strokes = menagerie();
  const std::vector<Treatment> treatments{ fill, tunnel, hole, fill, fill, fill };
  const std::vector<Vector2> darts{ { 0.45, 0.33 }, { 0.82, 0.5 }, { 0.4, 0.35 } };
  const auto meshOf = [&](const std::vector<int>& order)
  {
    std::vector<DrawnStroke> drawn;
    std::vector<Treatment> treated;
    for (const int i : order)
    {
      drawn.push_back(strokes[i]);
      treated.push_back(treatments[i]);
    }
    return triangulate(UnitDrawing(drawn, treated).lines(), darts, Context());
  };
  std::vector<int> order{ 0, 1, 2, 3, 4, 5 };
  const PlanarMesh first = meshOf(order);
  EXPECT_GT(first.faces.size(), 50u);
  std::mt19937 random(3);
  for (int run = 0; run < 12; ++run)
  {
    std::shuffle(order.begin(), order.end(), random);
    const PlanarMesh mesh = meshOf(order);
    ASSERT_EQ(mesh.points.size(), first.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      const PlanarPoint &a = mesh.points[i], &b = first.points[i];
      EXPECT_EQ(a.place, b.place);
      EXPECT_EQ(a.kind, b.kind);
      EXPECT_EQ(a.param, b.param);
      EXPECT_EQ(a.stroke < 0 ? -1 : order[a.stroke], b.stroke);
    }
    ASSERT_EQ(mesh.faces.size(), first.faces.size());
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      EXPECT_EQ(mesh.faces[f].corners, first.faces[f].corners);
    }
    EXPECT_EQ(mesh.edges.size(), first.edges.size());
  }
  fact("C7_6",
    "6 strokes and 3 darts in 12 orders: the same " + std::to_string(first.points.size()) + " points and " +
      std::to_string(first.faces.size()) + " triangles to the bit");
}

TEST(Triangulate, KindsRegionsAndObjects)
{
  const UnitDrawing drawing(menagerie(), { fill, tunnel, hole, fill, fill, fill });
  const std::vector<StrokeLine> lines = drawing.lines();
  const PlanarMesh mesh = triangulate(lines, { { 0.45, 0.33 }, { 2.0, 2.0 } }, Context());
  std::map<BoundaryKind, int> kinds;
  for (const PlanarPoint& point : mesh.points)
  {
    ++kinds[point.kind];
    EXPECT_TRUE(point.isBase);
    if (point.stroke >= 0)
    {
      const DrawnStroke& stroke = drawing.strokes[point.stroke];
      const auto lengths = arcLengths(stroke.points, stroke.closed);
      const Vector2 place =
        placeAt(lengths, static_cast<int>(stroke.points.size()), point.param).of(stroke.points);
      EXPECT_NEAR((place - point.place).norm(), 0.0, 1e-12);
    }
  }
  const auto sizeOf = [&](int line) { return static_cast<int>(lines[line].places.size()); };
  EXPECT_EQ(kinds[BoundaryKind::Object], sizeOf(0) + sizeOf(5));
  EXPECT_EQ(kinds[BoundaryKind::TunnelRim], sizeOf(1));
  EXPECT_EQ(kinds[BoundaryKind::Hole], sizeOf(2));
  EXPECT_EQ(kinds[BoundaryKind::Feature], sizeOf(3) + sizeOf(4) - 1); // one end is the rim's
  EXPECT_EQ(kinds[BoundaryKind::Interior], 1);                        // the dart outside is gone
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    EXPECT_EQ(face.base, static_cast<int>(f));
    Vector2 middle = Vector2::Zero();
    for (int k = 0; k < 3; ++k)
    {
      middle += mesh.points[face.corners[k]].place / 3.0;
    }
    EXPECT_EQ(
      face.object, middle[0] > 0.66 ? drawing.classes.strokes[5].object : drawing.classes.strokes[0].object);
    EXPECT_EQ(
      face.region == drawing.classes.strokes[1].childRegion, (middle - Vector2(0.3, 0.5)).norm() < 0.09);
  }
  // Edges have the params of their ends, a closed stroke's whole length in all.
  std::map<int, double> lengths;
  for (const StrokeEdge& edge : mesh.edges)
  {
    lengths[edge.stroke] += edge.end - edge.start;
  }
  for (const StrokeLine& line : lines)
  {
    EXPECT_NEAR(lengths[line.stroke], line.length, 1e-12);
  }
  EXPECT_TRUE(triangulate({}, {}, Context()).points.empty());
  EXPECT_TRUE(triangulate({}, { { 0.1, 0.1 }, { 0.2, 0.2 }, { 0.3, 0.3 } }, Context()).points.empty());
}

TEST(Triangulate, RandomDrawingsAreFilled)
{
  // Bodies with limbs down to 1 % of the canvas, features close along their rims, holes and tunnels.
  std::mt19937 random(17);
  const auto uniform = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(random); };
  int filled = 0, segments = 0, closest = 0;
  for (int run = 0; run < 40; ++run)
  {
    std::array<double, 4> heights{}, phases{};
    for (int k = 0; k < 4; ++k)
    {
      heights[k] = uniform(0.0, 0.5);
      phases[k] = uniform(0.0, turn);
    }
    const auto radius = [&](double a)
    {
      double r = 1.0;
      for (int k = 0; k < 4; ++k)
      {
        r += heights[k] * std::cos((2 * k + 2) * a + phases[k]);
      }
      return 0.02 + 0.14 * std::max(0.0, r);
    };
    std::vector<DrawnStroke> strokes{ polarStroke(0.5, 0.5, radius, phases[0]) };
    Polyline along;
    const double inside = uniform(0.006, 0.012), begin = uniform(0.0, turn);
    for (int i = 0; i < 120; ++i)
    {
      const double a = begin + 0.02 * i, r = radius(a) - inside;
      along.emplace_back(0.5 + r * std::cos(a), 0.5 + r * std::sin(a));
    }
    strokes.push_back(evenStroke(along, false));
    strokes.push_back(circleStroke(0.5, 0.5, 0.008));
    std::unique_ptr<UnitDrawing> drawing;
    try
    {
      drawing = std::make_unique<UnitDrawing>(strokes,
        std::vector<Treatment>{ fill,
          fill,
          run % 3 == 0   ? hole
          : run % 3 == 1 ? tunnel
                         : fill });
    }
    catch (const Error&)
    {
      continue; // strokes that meet
    }
    for (const DeltaMode mode : { DeltaMode::Adaptive, DeltaMode::Fixed })
    {
      ApproximationRules rules;
      rules.mode = mode;
      const std::vector<StrokeLine> lines = drawing->lines(rules);
      const PlanarMesh mesh = triangulate(lines, {}, Context());
      double area = 0.0, expected = areaOf(lines[0].places);
      for (const auto& [region, part] : areasOf(mesh))
      {
        area += part;
      }
      expected -= run % 3 == 0 ? areaOf(lines[2].places) : 0.0;
      EXPECT_NEAR(area, expected, 1e-12) << run;
      closest += lines[1].places.size() > 12;
      segments += static_cast<int>(mesh.edges.size());
      ++filled;
    }
  }
  EXPECT_GT(filled, 30);
  EXPECT_GT(closest, 5);
  EXPECT_GT(segments, 2000);
}

TEST(Triangulate, ManyPointsAndHostileOnes)
{
  std::mt19937 random(5);
  // Points on lines and circles, whose triangulation has any number of ties; nearly flat ones; far ones.
  Polyline points;
  for (int i = 0; i < 60; ++i)
  {
    points.emplace_back(i / 64.0, 0.0);
    points.emplace_back(0.0, (i + 1) / 64.0);
    points.emplace_back(i / 64.0, 1.0 + 1e-16 * i);
    points.emplace_back(0.5 + 0.25 * std::cos(turn * i / 60), 0.5 + 0.25 * std::sin(turn * i / 60));
  }
  points.emplace_back(1e9, 1e9);
  points.emplace_back(-1e9, 0.5);
  std::sort(points.begin(),
    points.end(),
    [](const Vector2& a, const Vector2& b)
    { return std::make_pair(a[0], a[1]) < std::make_pair(b[0], b[1]); });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto faces = constrainedDelaunay(points, {}, Context());
  std::set<std::pair<int, int>> edges;
  for (const DelaunayFace& face : faces)
  {
    EXPECT_EQ(orientation(points[face.corners[0]], points[face.corners[1]], points[face.corners[2]]), 1);
    for (int k = 0; k < 3; ++k)
    {
      edges.insert(std::minmax(face.corners[k], face.corners[(k + 1) % 3]));
    }
  }
  EXPECT_EQ(points.size() - edges.size() + faces.size(), 1u); // Euler, of a disc
  EXPECT_TRUE(constrainedDelaunay({ { 0, 0 }, { 1, 1 }, { 2, 2 } }, {}, Context()).empty());
  EXPECT_TRUE(constrainedDelaunay({}, {}, Context()).empty());
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(constrainedDelaunay(randomPoints(2000, random, false), {}, cancelled), Error);
}
