#include "Intersection/crossing_faces.h"

#include "Harness/shapes.h"
#include "Harness/threads.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Pairs = std::vector<FacePair>;

Pairs crossings(const Mesh& mesh)
{
  return crossingFaces(mesh, {});
}

// A triangle in the plane z = 0, and a second one.
Mesh twoTriangles(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return { { { 0, 0, 0 }, { 4, 0, 0 }, { 0, 4, 0 }, a, b, c }, { { 0, 1, 2 }, { 3, 4, 5 } } };
}

bool cross(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return !crossings(twoTriangles(a, b, c)).empty();
}

// Whole numbers: what follows is exact.
using Whole = std::array<std::int64_t, 3>;

Whole whole(const Vector3& p)
{
  return { std::int64_t(p[0]), std::int64_t(p[1]), std::int64_t(p[2]) };
}
Whole operator-(const Whole& a, const Whole& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}
std::int64_t dot(const Whole& a, const Whole& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Whole cross(const Whole& a, const Whole& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

// Two convex polygons in space have no common point where they keep apart along a normal of one, a product of
// two edges, or an edge's normal in one's plane.
bool separated(const std::array<Whole, 3>& a, const std::array<Whole, 3>& b)
{
  std::vector<Whole> axes;
  const auto edge = [](const std::array<Whole, 3>& t, int k) { return t[(k + 1) % 3] - t[k]; };
  for (const auto& t : { a, b })
  {
    const Whole normal = cross(edge(t, 0), edge(t, 1));
    axes.push_back(normal);
    for (int k = 0; k < 3; ++k)
    {
      axes.push_back(cross(normal, edge(t, k)));
      for (int j = 0; j < 3; ++j)
      {
        axes.push_back(cross(edge(a, k), edge(b, j)));
      }
    }
  }
  return std::any_of(axes.begin(),
    axes.end(),
    [&](const Whole& axis)
    {
      const auto range = [&](const std::array<Whole, 3>& t) {
        return std::minmax({ dot(axis, t[0]), dot(axis, t[1]), dot(axis, t[2]) });
      };
      const auto [lowA, highA] = range(a);
      const auto [lowB, highB] = range(b);
      return highA < lowB || highB < lowA;
    });
}

// Whether a way w from the corner runs in the angle between u and v, whose normal is n.
bool inAngle(const Whole& w, const Whole& u, const Whole& v, const Whole& n)
{
  return dot(w, n) == 0 && dot(cross(u, w), n) >= 0 && dot(cross(w, v), n) >= 0;
}

// Whether the angles of two triangles at a common corner hold a common way.
bool anglesMeet(const Whole& a, const Whole& b, const Whole& c, const Whole& d)
{
  const Whole n = cross(a, b), m = cross(c, d), line = cross(n, m), back = Whole{ 0, 0, 0 } - line;
  if (line == Whole{ 0, 0, 0 })
  {
    return inAngle(a, c, d, m) || inAngle(b, c, d, m) || inAngle(c, a, b, n) || inAngle(d, a, b, n);
  }
  return (inAngle(line, a, b, n) && inAngle(line, c, d, m)) ||
         (inAngle(back, a, b, n) && inAngle(back, c, d, m));
}

// The pairs by trying all, on meshes of whole coordinates.
Pairs slowCrossings(const Mesh& mesh)
{
  Pairs pairs;
  const auto corners = [&](int t) -> std::array<Whole, 3>
  {
    const Triangle& c = mesh.triangles[t];
    return { whole(mesh.points[c[0]]), whole(mesh.points[c[1]]), whole(mesh.points[c[2]]) };
  };
  const auto flat = [](const std::array<Whole, 3>& t) {
    return cross(t[1] - t[0], t[2] - t[0]) == Whole{ 0, 0, 0 };
  };
  for (int i = 0; i < mesh.triangleCount(); ++i)
  {
    for (int k = i + 1; k < mesh.triangleCount(); ++k)
    {
      std::array<Whole, 3> a = corners(i), b = corners(k);
      if (flat(a) || flat(b))
      {
        continue;
      }
      const auto isCommon = [&b](const Whole& p) { return std::find(b.begin(), b.end(), p) != b.end(); };
      const auto common = std::count_if(a.begin(), a.end(), isCommon);
      if (common == 1) // to the front
      {
        std::rotate(a.begin(), std::find_if(a.begin(), a.end(), isCommon), a.end());
        std::rotate(b.begin(), std::find(b.begin(), b.end(), a[0]), b.end());
      }
      const bool meets = common == 0
                           ? !separated(a, b)
                           : common == 1 && anglesMeet(a[1] - a[0], a[2] - a[0], b[1] - b[0], b[2] - b[0]);
      if (meets)
      {
        pairs.push_back({ i, k });
      }
    }
  }
  return pairs;
}

// Triangles over points of a small grid: many touch, lie in one plane or share corners.
Mesh randomMesh(std::mt19937& random, int points, int triangles, int size)
{
  Mesh mesh;
  const auto below = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  for (int i = 0; i < points; ++i)
  {
    mesh.points.emplace_back(below(size), below(size), below(size));
  }
  for (int i = 0; i < triangles; ++i)
  {
    mesh.triangles.push_back({ below(points), below(points), below(points) });
  }
  return mesh;
}

// Two spheres of radius 1 whose centres are `apart` along x.
Mesh twoSpheres(double apart)
{
  const Mesh one = icosphere(4);
  return joined(one, one, { apart, 0, 0 });
}

} // namespace

TEST(CrossingFaces, throughAndBeside)
{
  EXPECT_TRUE(cross({ 1, 1, -1 }, { 1, 1, 1 }, { 9, 9, 0 })) << "an edge through the face";
  EXPECT_TRUE(cross({ -9, 1, -9 }, { 9, 1, -9 }, { 1, 1, 9 })) << "the other one's edges through it";
  EXPECT_FALSE(cross({ 3, 3, -1 }, { 3, 3, 1 }, { 9, 9, 0 })) << "past the face, through its box";
  EXPECT_FALSE(cross({ 1, 1, 1 }, { 2, 1, 1 }, { 1, 2, 1 })) << "above it";
}

TEST(CrossingFaces, touching)
{
  EXPECT_TRUE(cross({ 1, 1, 0 }, { 1, 1, 1 }, { 2, 1, 1 })) << "a corner on the face";
  EXPECT_TRUE(cross({ 2, 2, 0 }, { 5, 5, 1 }, { 5, 5, -1 })) << "a corner on an edge";
  EXPECT_TRUE(cross({ 2, 0, -1 }, { 2, 0, 1 }, { 2, -3, 0 })) << "an edge on an edge";
  EXPECT_TRUE(cross({ 1, 1, 0 }, { 2, 1, 0 }, { 1, 1, 5 })) << "an edge in the face";
  EXPECT_FALSE(cross({ 2, 2, std::numeric_limits<double>::denorm_min() }, { 5, 5, 1 }, { 5, 5, 2 }));
}

// Faces that touch at a side of their boxes, which lie askew: no rounding may part them.
TEST(CrossingFaces, touchingAtASideOfTheirBoxes)
{
  const Vector3 u(1, 2, 2), v(2, 1, -2), far(1e5, -3e5, 7e5);
  for (int half = 2; half < 40; ++half)
  {
    for (int at = 1 - half; at < half; ++at)
    {
      const Vector3 corner = far + at * v;
      const Mesh mesh{
        { far - half * v, far + half * v, far - 9 * u, corner, corner + 9 * u + v, corner + 9 * u - v },
        { { 0, 1, 2 }, { 3, 4, 5 } }
      };
      EXPECT_EQ(crossings(mesh).size(), 1u) << half << ", " << at;
    }
  }
}

TEST(CrossingFaces, inOnePlane)
{
  EXPECT_TRUE(cross({ 1, 1, 0 }, { 9, 1, 0 }, { 1, 9, 0 })) << "they lap over";
  EXPECT_TRUE(cross({ 0.5, 0.5, 0 }, { 1, 0.5, 0 }, { 0.5, 1, 0 })) << "one in the other";
  EXPECT_TRUE(cross({ -4, -4, 0 }, { 40, -4, 0 }, { -4, 40, 0 })) << "the other one in it";
  EXPECT_TRUE(cross({ -1, 0, 0 }, { 5, 0, 0 }, { 2, -3, 0 })) << "edges on one line";
  EXPECT_FALSE(cross({ 5, 0, 0 }, { 6, 0, 0 }, { 2, -3, 0 })) << "beside each other on one line";
  EXPECT_FALSE(cross({ 3, 3, 0 }, { 9, 3, 0 }, { 3, 9, 0 }));
}

TEST(CrossingFaces, corneredFaces)
{
  const Vector3 corner(0, 0, 0);
  EXPECT_FALSE(cross(corner, { -4, 0, 0 }, { 0, -4, 0 })) << "they share a corner in one plane";
  EXPECT_FALSE(cross(corner, { -1, 0, 4 }, { 1, 1, 4 }));
  EXPECT_TRUE(cross(corner, { 1, 1, 4 }, { 1, 1, -4 })) << "the other's far edge through the face";
  EXPECT_TRUE(cross(corner, { 1, 1, 0 }, { 1, 2, 0 })) << "one in the other";
  EXPECT_TRUE(cross(corner, { 9, 0, 0 }, { 0, -4, 0 })) << "edges on one line";
  EXPECT_FALSE(cross(corner, { 4, 0, 0 }, { 1, 1, 0 })) << "folded over: two corners in common";
  EXPECT_FALSE(cross(corner, { 4, 0, 0 }, { 0, 4, 0 })) << "the same face twice";
}

TEST(CrossingFaces, whatCutsNothing)
{
  EXPECT_FALSE(cross({ 1, 1, -1 }, { 1, 1, 1 }, { 1, 1, 3 })) << "no area";
  EXPECT_FALSE(cross({ 1, 1, -1 }, { 1, 1, -1 }, { 1, 1, 3 }));
  EXPECT_FALSE(cross({ 1, 1, -1 }, { 1, 1, 1 }, { 9, std::nan(""), 0 }));
  EXPECT_TRUE(crossings({}).empty());
}

// The spheres cut each other along a circle: the faces that the plane in the middle meets, and no other.
TEST(CrossingFaces, spheres)
{
  EXPECT_TRUE(crossings(icosphere(4)).empty());
  EXPECT_TRUE(crossings(torus(1.0, 0.3, 60, 30)).empty());
  EXPECT_TRUE(crossings(twoSpheres(2.01)).empty());
  const Mesh mesh = twoSpheres(1.0);
  const int half = mesh.triangleCount() / 2;
  const Pairs pairs = crossings(mesh);
  std::set<int> met;
  for (const FacePair& pair : pairs)
  {
    EXPECT_TRUE(pair[0] < half && pair[1] >= half);
    for (const int f : pair)
    {
      met.insert(f);
      double least = 1.0, most = 0.0;
      for (const int v : mesh.triangles[f])
      {
        least = std::min(least, mesh.points[v][0]);
        most = std::max(most, mesh.points[v][0]);
      }
      EXPECT_TRUE(least < 0.51 && most > 0.49) << f;
    }
  }
  // A closed ring of faces in each: round the circle of radius 0.866, edges are some 0.07 long.
  EXPECT_GT(met.size(), 2 * 75u);
  EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
}

// As readers leave it that split points for their texture coordinates: each face has corners of its own.
TEST(CrossingFaces, pointsOfOnePosition)
{
  Mesh mesh = icosphere(3), split;
  for (const Triangle& t : mesh.triangles)
  {
    const int first = split.vertexCount();
    for (const int v : t)
    {
      split.points.push_back(mesh.points[v]);
    }
    split.triangles.push_back({ first, first + 1, first + 2 });
  }
  EXPECT_TRUE(crossings(split).empty());
}

TEST(CrossingFaces, changedFacesAlone)
{
  const Mesh mesh = twoSpheres(1.0);
  const Pairs all = crossings(mesh);
  std::vector<char> changed(mesh.triangles.size(), 0);
  EXPECT_TRUE(crossingFaces(mesh, changed).empty());
  std::mt19937 random(7);
  for (char& one : changed)
  {
    one = random() % 4 == 0;
  }
  Pairs some;
  std::copy_if(all.begin(),
    all.end(),
    std::back_inserter(some),
    [&](const FacePair& pair) { return changed[pair[0]] || changed[pair[1]]; });
  ASSERT_FALSE(some.empty());
  EXPECT_LT(some.size(), all.size());
  EXPECT_EQ(crossingFaces(mesh, changed), some);
}

TEST(CrossingFaces, asByTryingAllPairs)
{
  std::mt19937 random(36);
  std::size_t found = 0, tried = 0;
  for (int run = 0; run < 600; ++run)
  {
    // A grid of 2 to 13 a side: from nearly all degenerate to few.
    const Mesh mesh = randomMesh(random, 4 + run % 40, 60, 2 + run % 12);
    const Pairs pairs = slowCrossings(mesh);
    ASSERT_EQ(crossings(mesh), pairs) << run;
    std::vector<char> changed(mesh.triangles.size());
    for (std::size_t f = 0; f < changed.size(); ++f)
    {
      changed[f] = (f + run) % 3 == 0;
    }
    Pairs some;
    std::copy_if(pairs.begin(),
      pairs.end(),
      std::back_inserter(some),
      [&](const FacePair& pair) { return changed[pair[0]] || changed[pair[1]]; });
    ASSERT_EQ(crossingFaces(mesh, changed), some) << run;
    found += pairs.size();
    tried += mesh.triangles.size() * (mesh.triangles.size() - 1) / 2;
  }
  EXPECT_GT(found, tried / 50);
  EXPECT_LT(found, tried / 2);
}

TEST(CrossingFaces, sameOnTwoThreads)
{
  const Mesh mesh = twoSpheres(1.2);
  EXPECT_EQ(crossingFaces(mesh, {}, twoThreads()), crossings(mesh));
}

TEST(CrossingFaces, cancel)
{
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(crossingFaces(icosphere(3), {}, context), Error);
}
