// Bodies joined, cut and common, beside what is known of them, and beside CGAL's corefinement.
#include "Join/join.h"
#include "Join/polygon.h"

#include "Harness/shapes.h"
#include "Intersection/crossing_faces.h"

#ifdef OVERSKETCH_CGAL
#include "Harness/cgal_surface.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#endif

#include <gtest/gtest.h>

#include <numeric>

namespace
{

using namespace oversketch;
using namespace oversketch_test;

Body bodyOf(const Mesh& mesh, int firstSource = 0)
{
  Body body;
  body.mesh.points = mesh.points;
  for (const Triangle& t : mesh.triangles)
  {
    body.add(t, firstSource + static_cast<int>(body.source.size()), firstSource > 0 ? 1 : 0);
  }
  return body;
}

double volumeOf(const Mesh& mesh)
{
  double six = 0.0;
  const Vector3 o = mesh.points.empty() ? Vector3::Zero().eval() : mesh.points.front();
  for (const Triangle& t : mesh.triangles)
  {
    six += (mesh.points[t[0]] - o).dot((mesh.points[t[1]] - o).cross(mesh.points[t[2]] - o));
  }
  return six / 6.0;
}

Mesh placed(Mesh mesh, const Vector3& shift, const Eigen::Matrix3d& turn = Eigen::Matrix3d::Identity())
{
  for (Vector3& p : mesh.points)
  {
    p = turn * p + shift;
  }
  return mesh;
}

Eigen::Matrix3d turnBy(double angle, const Vector3& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

// A box from the origin, each side of so many squares.
Mesh box(const Vector3& size, int squares = 1)
{
  Mesh mesh;
  std::map<std::array<int, 3>, int> ids;
  const auto at = [&](const std::array<int, 3>& p)
  {
    const auto found = ids.emplace(p, mesh.vertexCount());
    if (found.second)
    {
      mesh.points.push_back(Vector3(p[0], p[1], p[2]).cwiseProduct(size) / squares);
    }
    return found.first->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const int side : { 0, squares })
    {
      for (int i = 0; i < squares; ++i)
      {
        for (int k = 0; k < squares; ++k)
        {
          const auto corner = [&](int u, int v)
          {
            std::array<int, 3> p;
            p[axis] = side;
            p[(axis + 1) % 3] = i + u;
            p[(axis + 2) % 3] = k + v;
            return at(p);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          for (Triangle t : { Triangle{ a, b, c }, Triangle{ a, c, d } })
          {
            if (side == 0)
            {
              std::swap(t[1], t[2]);
            }
            mesh.triangles.push_back(t);
          }
        }
      }
    }
  }
  return mesh;
}

// What must hold of any closed body; its Euler number.
int expectSound(const Mesh& mesh)
{
  const Adjacency edges = buildAdjacency(mesh);
  int open = 0, turned = 0, split = 0;
  for (int e = 0; e < static_cast<int>(edges.edges.size()); ++e)
  {
    const MeshEdge& edge = edges.edges[e];
    open += edge.triangleCount != 2;
    const auto at = edges.trianglesAt(e);
    turned += edge.triangleCount == 2 && runsAlong(mesh.triangles[at.begin()[0]], edge.v0, edge.v1) ==
                                           runsAlong(mesh.triangles[at.begin()[1]], edge.v0, edge.v1);
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    split += edges.vertexTriangles.size(v) == 0 || !isOneFan(edges, v);
  }
  EXPECT_EQ(open, 0);
  EXPECT_EQ(turned, 0);
  EXPECT_EQ(split, 0);
  const std::vector<FacePair> crossing = crossingFaces(mesh, {});
  EXPECT_EQ(crossing.size(), 0u);
  return mesh.vertexCount() - static_cast<int>(edges.edges.size()) + mesh.triangleCount();
}

double leastOf(const Mesh& a, const Mesh& b)
{
  return 1e-6 * std::max(boundingDiagonal(a), boundingDiagonal(b));
}

Joined joinedOf(const Mesh& a, const Mesh& b, const JoinOptions& options)
{
  const Mesh both = joined(a, b, Vector3::Zero());
  std::vector<int> parts(both.triangles.size(), 0);
  std::fill(parts.begin() + a.triangleCount(), parts.end(), 1);
  return join({ both, parts, parts }, options);
}

// Points of the inputs that lie strictly in what is kept are there, bit for bit.
int keptPoints(const Mesh& of, const Mesh& in)
{
  std::set<std::array<double, 3>> all;
  for (const Vector3& p : in.points)
  {
    all.insert({ p[0], p[1], p[2] });
  }
  int kept = 0;
  for (const Vector3& p : of.points)
  {
    kept += static_cast<int>(all.count({ p[0], p[1], p[2] }));
  }
  return kept;
}

#ifdef OVERSKETCH_CGAL
// Volume and Euler number by CGAL.
std::pair<double, int> peer(const Mesh& a, const Mesh& b, JoinKind kind)
{
  namespace PMP = CGAL::Polygon_mesh_processing;
  CgalSurface one = cgalSurface(a), two = cgalSurface(b), out;
  const bool done = kind == JoinKind::Join  ? PMP::corefine_and_compute_union(one, two, out)
                    : kind == JoinKind::Cut ? PMP::corefine_and_compute_difference(one, two, out)
                                            : PMP::corefine_and_compute_intersection(one, two, out);
  EXPECT_TRUE(done);
  return { CGAL::to_double(PMP::volume(out)), eulerNumber(out) };
}
#endif

void expectAsPeer(const Mesh& a, const Mesh& b)
{
  for (const JoinKind kind : { JoinKind::Join, JoinKind::Cut, JoinKind::Common })
  {
    SCOPED_TRACE(static_cast<int>(kind));
    const United united = unite(bodyOf(a), bodyOf(b, a.triangleCount()), kind, leastOf(a, b), Context());
    const int euler = expectSound(united.body.mesh);
#ifdef OVERSKETCH_CGAL
    const auto [volume, wanted] = peer(a, b, kind);
    EXPECT_NEAR(volumeOf(united.body.mesh), volume, 1e-4 * volume);
    EXPECT_EQ(euler, wanted);
#else
    EXPECT_EQ(euler % 2, 0);
#endif
  }
}

TEST(Unite, TwoBoxesFillWhatEitherDoes)
{
  const Mesh a = box({ 2, 2, 2 }), b = placed(box({ 2, 2, 2 }), { 1, 1, 1 });
  const double volumes[] = { 15.0, 7.0, 1.0 };
  for (const int kind : { 0, 1, 2 })
  {
    const United united =
      unite(bodyOf(a), bodyOf(b, 12), static_cast<JoinKind>(kind), leastOf(a, b), Context());
    EXPECT_TRUE(united.meet);
    EXPECT_EQ(expectSound(united.body.mesh), 2);
    EXPECT_NEAR(volumeOf(united.body.mesh), volumes[kind], 1e-12);
  }
}

TEST(Unite, BoxesWithFacesInOnePlane)
{
  // Side by side, on top of each other off the middle, a bar across a bar, a notch in a corner.
  const Mesh a = box({ 2, 2, 2 });
  const struct
  {
    Mesh b;
    double join, common;
  } cases[] = { { placed(a, { 2, 0, 0 }), 16.0, 0.0 },
    { placed(box({ 1, 1, 1 }), { 0.5, 0.25, 2 }), 9.0, 0.0 },
    { placed(box({ 1, 4, 2 }), { 0.5, -1, 0 }), 12.0, 4.0 },
    { box({ 1, 1, 1 }), 8.0, 1.0 },
    { placed(box({ 2, 2, 1 }), { 0, 0, 1 }), 8.0, 4.0 },
    { a, 8.0, 8.0 } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(testing::PrintToString(&one - cases));
    const double least = leastOf(a, one.b);
    SCOPED_TRACE("all three");
    const United join = unite(bodyOf(a), bodyOf(one.b, 12), JoinKind::Join, least, Context());
    EXPECT_EQ(expectSound(join.body.mesh), 2);
    EXPECT_NEAR(volumeOf(join.body.mesh), one.join, 1e-4);
    const United cut = unite(bodyOf(a), bodyOf(one.b, 12), JoinKind::Cut, least, Context());
    expectSound(cut.body.mesh);
    EXPECT_NEAR(volumeOf(cut.body.mesh), 8.0 - one.common, 1e-4);
    const United common = unite(bodyOf(a), bodyOf(one.b, 12), JoinKind::Common, least, Context());
    expectSound(common.body.mesh);
    EXPECT_NEAR(volumeOf(common.body.mesh), one.common, 1e-4);
  }
}

TEST(Unite, RoundBodiesAsCgalDoes)
{
  const Mesh ball = icosphere(3), ring = torus(1.0, 0.3, 40, 20);
  expectAsPeer(ball, placed(ball, { 0.8, 0.3, 0.1 }));
  expectAsPeer(ball, placed(icosphere(2, 0.5), { 0.9, 0.2, 0.1 }));
  expectAsPeer(ring, placed(ball, { 0.1, 0.05, 0.2 }));
  expectAsPeer(
    ring, placed(box({ 3.2, 0.2, 0.3 }, 4), { -1.6, -0.1, -0.15 }, turnBy(0.1, { 0.2, 0.3, 1.0 })));
  expectAsPeer(ring, placed(ring, { 1.0, 0.0, 0.0 }, turnBy(1.4, { 1.0, 0.1, 0.0 })));
}

TEST(Unite, TheSameMeshShiftedByAHair)
{
  for (const Mesh& mesh : { icosphere(3), torus(1.0, 0.3, 40, 20), box({ 1, 1, 1 }, 5) })
  {
    for (const double shift : { 0.0, 1e-16, 1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3 })
    {
      SCOPED_TRACE(testing::Message() << mesh.triangleCount() << " triangles by " << shift);
      const Mesh b = placed(mesh, Vector3(1.0, 0.3, 0.7) * shift);
      const Joined made = joinedOf(mesh, b, {});
      EXPECT_EQ(expectSound(made.mesh), mesh.triangleCount() == 1600 ? 0 : 2);
      EXPECT_NEAR(volumeOf(made.mesh), volumeOf(mesh), std::max(1e-4, 10.0 * shift));
    }
  }
}

TEST(Unite, BeyondTheCutEveryPointKeepsItsBits)
{
  const Mesh a = icosphere(4), b = placed(icosphere(4), { 0.9, 0.1, 0.2 });
  const United united =
    unite(bodyOf(a), bodyOf(b, a.triangleCount()), JoinKind::Join, leastOf(a, b), Context());
  int outside = 0;
  for (const Vector3& p : a.points)
  {
    outside += (p - Vector3(0.9, 0.1, 0.2)).norm() > 1.0001;
  }
  for (const Vector3& p : b.points)
  {
    outside += p.norm() > 1.0001;
  }
  EXPECT_GE(keptPoints(a, united.body.mesh) + keptPoints(b, united.body.mesh), outside);
}

// The largest angle between normals across an edge [degrees].
double sharpestEdge(const Mesh& mesh)
{
  const Adjacency edges = buildAdjacency(mesh);
  double sharpest = 0.0;
  for (int e = 0; e < static_cast<int>(edges.edges.size()); ++e)
  {
    const auto at = edges.trianglesAt(e);
    const Vector3 a = facetNormal(mesh, at.begin()[0]), b = facetNormal(mesh, at.begin()[1]);
    sharpest = std::max(sharpest, 180.0 / pi * std::atan2(a.cross(b).norm(), a.dot(b)));
  }
  return sharpest;
}

// Edges of the seam bend by less than 12 degrees at 8 triangles over its width, points beyond it keep their
// bits.
TEST(Join, ASeamIsSmooth)
{
  const Mesh ball = icosphere(4);
  const struct
  {
    double radius;
    Vector3 place;
    JoinKind kind;
  } cases[] = { { 1.0, { 1.1, 0.2, 0.3 }, JoinKind::Join },
    { 0.5, { 0.8, 0.3, 0.4 }, JoinKind::Join },
    { 0.5, { 0.8, 0.3, 0.4 }, JoinKind::Cut },
    { 1.0, { 0.5, 0.2, 0.3 }, JoinKind::Common } };
  for (const auto& one : cases)
  {
    SCOPED_TRACE(&one - cases);
    const double width = 0.3;
    const Mesh other = placed(icosphere(4, one.radius), one.place);
    const Joined made = joinedOf(ball, other, { one.kind, width, false }),
                 creased = joinedOf(ball, other, { one.kind, 0.0, false });
    EXPECT_EQ(expectSound(made.mesh), 2);
    EXPECT_LT(sharpestEdge(made.mesh), 12.0); // of the balls' own under 5
    EXPECT_LE(made.sharpest, sharpestEdge(made.mesh) + 1e-9);
    // The angle between the spheres, by the cosine law.
    const double angle =
      180.0 / pi * std::acos((1.0 + one.radius * one.radius - one.place.squaredNorm()) / (2.0 * one.radius));
    EXPECT_NEAR(sharpestEdge(creased.mesh), one.kind == JoinKind::Cut ? 180.0 - angle : angle, 8.0);
    // The crease itself, for where the seam is.
    const Adjacency edges = buildAdjacency(creased.mesh);
    std::vector<Vector3> crease;
    for (int e = 0; e < static_cast<int>(edges.edges.size()); ++e)
    {
      const auto at = edges.trianglesAt(e);
      if ((creased.source[at.begin()[0]] < ball.triangleCount()) !=
          (creased.source[at.begin()[1]] < ball.triangleCount()))
      {
        crease.push_back(creased.mesh.points[edges.edges[e].v0]);
      }
    }
    ASSERT_GT(crease.size(), 20u);
    int beyond = 0, kept = 0;
    std::set<std::array<double, 3>> all;
    for (const Vector3& p : made.mesh.points)
    {
      all.insert({ p[0], p[1], p[2] });
    }
    for (const Vector3& p : creased.mesh.points)
    {
      const auto isNear = [&](const Vector3& q) { return (p - q).norm() < 0.5 * width + 0.01; };
      if (std::none_of(crease.begin(), crease.end(), isNear))
      {
        ++beyond;
        kept += static_cast<int>(all.count({ p[0], p[1], p[2] }));
      }
    }
    EXPECT_GT(beyond, 100);
    EXPECT_EQ(kept, beyond);
  }
}

TEST(Join, SaysWhatItCannotDo)
{
  const Mesh ball = icosphere(2);
  const auto messageOf = [&](const Mesh& b, const JoinOptions& options) -> std::string
  {
    try
    {
      joinedOf(ball, b, options);
    }
    catch (const Error& error)
    {
      return error.what();
    }
    return "";
  };
  const auto has = [](const std::string& text, const char* part)
  { return text.find(part) != std::string::npos; };
  const Mesh apart = placed(ball, { 3, 0, 0 });
  EXPECT_PRED2(has, messageOf(apart, {}), "Part 2 meets none of the others");
  EXPECT_PRED2(has, messageOf(apart, { JoinKind::Common, 0.0, false }), "nothing in common");
  EXPECT_PRED2(has, messageOf(apart, { JoinKind::Join, 0.0, true }), "as thick as the seam");
  EXPECT_PRED2(has,
    messageOf(
      placed(ball, Vector3::Zero(), 2.0 * Eigen::Matrix3d::Identity()), { JoinKind::Cut, 0.0, false }),
    "Nothing is left");
  EXPECT_PRED2(has,
    messageOf(placed(icosphere(2, 0.1), { 1, 0, 0 }), { JoinKind::Join, 0.5, false }),
    "all over what is left of part 2");
  Mesh open = placed(ball, { 1, 0, 0 });
  open.triangles.pop_back();
  EXPECT_PRED2(has, messageOf(open, {}), "Part 2 is not closed");
  std::swap(open.triangles[7][0], open.triangles[7][1]);
  open.triangles.push_back(ball.triangles.back());
  EXPECT_PRED2(has, messageOf(open, {}), "Part 2 is no closed surface");
}

// A bar along the shortest way: one body of no handles.
TEST(Join, ABridgeMeetsBoth)
{
  const Mesh ball = icosphere(4);
  const Joined made = joinedOf(ball, placed(ball, { 2.5, 0.2, 0.3 }), { JoinKind::Join, 0.3, true });
  EXPECT_EQ(expectSound(made.mesh), 2);
  // The bar between the balls alone is a cylinder of 0.15 and the gap; round its ends there is more.
  const double bar = pi * 0.15 * 0.15 * (Vector3(2.5, 0.2, 0.3).norm() - 2.0);
  EXPECT_GT(volumeOf(made.mesh), 2.0 * volumeOf(ball) + bar);
  EXPECT_LT(volumeOf(made.mesh), 2.0 * volumeOf(ball) + 1.5 * bar);
}

// The order in which parts are given makes no difference to whether they meet: the third one joins the
// others.
TEST(Join, PartsWaitForTheOneThatTheyMeet)
{
  const Mesh ball = icosphere(2);
  Mesh all = joined(ball, placed(ball, { 3.2, 0, 0 }), Vector3::Zero());
  all = joined(all, placed(ball, { 1.6, 0, 0 }), Vector3::Zero());
  std::vector<int> parts;
  for (int t = 0; t < all.triangleCount(); ++t)
  {
    parts.push_back(t / ball.triangleCount());
  }
  EXPECT_EQ(expectSound(join({ all, parts, parts }, {}).mesh), 2);
}

// Holes, islands and a point on a border, as rounding may make them: every edge of a loop is one of a
// triangle, and the area is the polygon's.
TEST(Polygon, HasItsArea)
{
  const std::vector<Vector2> points{ { 0, 0 },
    { 4, 0 },
    { 4, 4 },
    { 0, 4 },
    { 1, 1 },
    { 1, 2 },
    { 2, 2 },
    { 2, 1 },
    { 3, 3 },
    { 2.5, 3.5 },
    { 3.5, 3.5 } };
  const auto triangles = triangulatePolygon(points, { { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 8, 9, 10 } });
  double area = 0.0;
  for (const Triangle& t : triangles)
  {
    EXPECT_GT(turnedArea(points, { t[0], t[1], t[2] }), 0.0);
    area += turnedArea(points, { t[0], t[1], t[2] }) / 2.0;
  }
  EXPECT_NEAR(area, 16.0 - 1.0 - 0.25, 1e-12);
  EXPECT_EQ(triangles.size(), 4u + 4u + 3u + 2u);
}

} // namespace
