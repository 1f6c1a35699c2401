// A mesh that changes bit by bit: what is known of it spares rays and never shows in the result.
#include "Harness/shapes.h"
#include "Mesh/match.h"
#include "Ray/ray_caster.h"
#include "Ray/shape_diameter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <random>
#include <thread>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Random = std::mt19937;

double uniform(Random& random, double low, double high)
{
  return low + (high - low) * static_cast<double>(random() % 100003) / 100002.0;
}

int anyOf(Random& random, int count)
{
  return static_cast<int>(random() % static_cast<unsigned>(count));
}

// Pulls what lies round a vertex.
void pull(Mesh& mesh, int v, double radius, const Vector3& by)
{
  const Vector3 centre = mesh.points[v];
  for (Vector3& p : mesh.points)
  {
    const double r = (p - centre).norm() / radius;
    if (r < 1.0)
    {
      p += (1.0 - r * r) * by;
    }
  }
}

// The triangles round a vertex are parted at their centres.
void refine(Mesh& mesh, int v, double radius)
{
  const int count = mesh.triangleCount();
  for (int t = 0; t < count; ++t)
  {
    const Triangle corners = mesh.triangles[t];
    const Vector3 centre =
      (mesh.points[corners[0]] + mesh.points[corners[1]] + mesh.points[corners[2]]) / 3.0;
    if ((centre - mesh.points[v]).norm() < radius)
    {
      const int m = mesh.vertexCount();
      mesh.points.push_back(centre);
      mesh.triangles[t] = { corners[0], corners[1], m };
      mesh.triangles.push_back({ corners[1], corners[2], m });
      mesh.triangles.push_back({ corners[2], corners[0], m });
    }
  }
}

void append(Mesh& mesh, const Mesh& other, double scale, const Vector3& by)
{
  const int first = mesh.vertexCount();
  for (const Vector3& p : other.points)
  {
    mesh.points.push_back(scale * p + by);
  }
  for (const Triangle& t : other.triangles)
  {
    mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

void renumber(Mesh& mesh, Random& random)
{
  std::vector<int> order(mesh.points.size());
  std::iota(order.begin(), order.end(), 0);
  std::shuffle(order.begin(), order.end(), random);
  Mesh other = mesh;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    other.points[order[v]] = mesh.points[v];
  }
  for (Triangle& t : other.triangles)
  {
    t = { order[t[0]], order[t[1]], order[t[2]] };
  }
  std::shuffle(other.triangles.begin(), other.triangles.end(), random);
  mesh = other;
}

// Each corner of the triangles round a vertex gets a vertex of its own.
void tear(Mesh& mesh, int v, double radius)
{
  const Vector3 centre = mesh.points[v];
  for (Triangle& t : mesh.triangles)
  {
    for (int& corner : t)
    {
      if ((mesh.points[corner] - centre).norm() < radius)
      {
        mesh.points.push_back(mesh.points[corner]);
        corner = mesh.vertexCount() - 1;
      }
    }
  }
}

// A kind of edit: its name, what it does, and the greatest part of the rays of a plain torus that may be cast
// again for it.
struct Edit
{
  const char* name;
  std::function<void(Mesh&, Random&)> apply;
  double most;
};

std::vector<Edit> edits()
{
  const auto some = [](const Mesh& mesh, Random& random) { return anyOf(random, mesh.vertexCount()); };
  return { { "one vertex moved",
             [=](Mesh& m, Random& r) { m.points[some(m, r)] += Vector3(0.01, uniform(r, -0.01, 0.01), 0); },
             0.2 },
    { "a part pulled",
      [=](Mesh& m, Random& r) { pull(m, some(m, r), 0.2, Vector3(0, uniform(r, -0.05, 0.05), 0.05)); },
      0.6 },
    { "a part refined", [=](Mesh& m, Random& r) { refine(m, some(m, r), 0.15); }, 0.6 },
    { "facets removed",
      [=](Mesh& m, Random& r)
      {
        const auto first = m.triangles.begin() + anyOf(r, m.triangleCount() - 10);
        m.triangles.erase(first, first + 10);
      },
      0.6 },
    { "facets added: a ball in the way",
      [=](Mesh& m, Random& r)
      {
        const Vector3 at = 0.7 * m.points[some(m, r)];
        append(m, icosphere(1), 0.03, at);
      },
      0.6 },
    { "facets turned round",
      [=](Mesh& m, Random& r)
      {
        for (int i = 0; i < 5; ++i)
        {
          Triangle& t = m.triangles[anyOf(r, m.triangleCount())];
          std::swap(t[1], t[2]);
        }
      },
      1.0 },
    { "facets doubled",
      [=](Mesh& m, Random& r)
      {
        for (int i = 0; i < 20; ++i)
        {
          const Triangle t = m.triangles[anyOf(r, m.triangleCount())];
          m.triangles.push_back({ t[1], t[2], t[0] });
        }
      },
      1.0 },
    { "torn", [=](Mesh& m, Random& r) { tear(m, some(m, r), 0.1); }, 0.6 },
    { "renumbered", [=](Mesh& m, Random& r) { renumber(m, r); }, 1.0 }, // sums of normals are rounded anew
    { "nothing", [](Mesh&, Random&) {}, 0.0 },
    { "loose points and a facet without area",
      [=](Mesh& m, Random& r)
      {
        m.points.push_back(0.5 * m.points[0]);
        m.points.insert(m.points.end(), 3, Vector3(0, 0, 0));
        const int v = some(m, r);
        m.triangles.push_back({ v, v, 0 });
      },
      0.6 },
    { "far out: the frame changes",
      [=](Mesh& m, Random& r) { m.points[some(m, r)] *= uniform(r, 3.0, 4.0); },
      1.0 },
    { "and back in",
      [](Mesh& m, Random&)
      {
        for (Vector3& p : m.points)
        {
          p = p.norm() > 2.0 ? Vector3(p / p.norm()) : p;
        }
      },
      1.0 } };
}

std::vector<std::pair<const char*, Mesh>> models()
{
  Mesh spiky = icosphere(4); // intersects itself
  Random random(7);
  for (Vector3& p : spiky.points)
  {
    p *= uniform(random, 0.8, 1.2);
  }
  Mesh flat; // three boxes of axis-parallel sides in one plane, which overlap: many hits at one distance
  for (const double x : { 0.0, 0.25, 0.5 })
  {
    const Mesh grid = gridSurface(8, 8, false, false, [](double u, double v) { return Vector3(u, v, 0); });
    append(flat, grid, 1.0, Vector3(x, x, 1.0));
    Mesh down = grid;
    for (Triangle& t : down.triangles)
    {
      std::swap(t[0], t[1]);
    }
    append(flat, down, 1.0, Vector3(x, 0.5 * x, 0.0));
  }
  return { { "torus", torus(1.0, 0.4, 60, 30) }, { "spiky", spiky }, { "flat", flat } };
}

Context threaded()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    std::vector<std::thread> threads;
    threads.reserve(3);
    for (int i = 0; i < 3; ++i)
    {
      threads.emplace_back([=, &body] { body(count * i / 3, count * (i + 1) / 3); });
    }
    for (std::thread& thread : threads)
    {
      thread.join();
    }
  };
  return context;
}

ShapeDiameter diameters(const Mesh& mesh,
  const ShapeDiameterOptions& options,
  KnownDiameters* known,
  const Context& context = Context())
{
  return computeShapeDiameter(
    mesh, buildAdjacency(mesh), vertexNormals(mesh), options, context, nullptr, known);
}

} // namespace

TEST(KnownDiameters, NeverShowInTheResult)
{
  for (const Backend backend : { Backend::Host, Backend::OpenCL })
  {
    for (const auto& [name, model] : models())
    {
      SCOPED_TRACE(name);
      const bool plain = std::string(name) == "torus";
      Random random(42);
      ShapeDiameterOptions options;
      options.backend = backend;
      KnownDiameters known;
      Mesh mesh = model;
      const auto check = [&](const char* what, double most)
      {
        SCOPED_TRACE(what);
        const ShapeDiameter cold = diameters(mesh, options, nullptr);
        const ShapeDiameter warm = diameters(mesh, options, &known, threaded());
        EXPECT_EQ(cold.diameter, warm.diameter);
        EXPECT_EQ(cold.measured, warm.measured);
        EXPECT_EQ(cold.raysTraced, warm.raysTraced);
        EXPECT_EQ(cold.raysCast, cold.raysTraced);
        if (plain || most == 0.0)
        {
          EXPECT_LE(static_cast<double>(warm.raysCast), most * static_cast<double>(cold.raysTraced));
        }
      };
      check("at first", 1.0);
      for (int round = 0; round < 2; ++round)
      {
        for (const Edit& edit : edits())
        {
          edit.apply(mesh, random);
          check(edit.name, edit.most);
        }
      }
      mesh = icosphere(2);
      check("another mesh", 1.0);
      check("the same again", 0.0);
      options.coneAngle = 80.0;
      check("another cone", 1.0);
      options.coneAngle = 179.5; // too wide for bounds
      check("a half space", 1.0);
      mesh.points[5] *= 1.01;
      check("a half space, one vertex moved", 1.0);
      options.inverseAngleWeights = true;
      options.rayCount = 100;
      check("more rays, weighed", 1.0);
      mesh.triangles.clear();
      check("no facets", 0.0);
      mesh = model;
      check("the first again", 1.0);
    }
  }
}

TEST(KnownDiameters, ALocalChangeCastsFewRays)
{
  // A dent of a fiftieth of the torus: its own cones and those that look at it.
  Mesh mesh = torus(1.0, 0.4, 200, 100);
  KnownDiameters known;
  ShapeDiameterOptions options;
  options.backend = Backend::Host;
  EXPECT_EQ(diameters(mesh, options, &known).raysCast, 32LL * mesh.vertexCount());
  const Mesh before = mesh;
  pull(mesh, 0, 0.3, Vector3(-0.02, 0, 0));
  const int moved = static_cast<int>(std::inner_product(mesh.points.begin(),
    mesh.points.end(),
    before.points.begin(),
    0,
    std::plus<>(),
    [](const Vector3& a, const Vector3& b) { return a != b; }));
  const ShapeDiameter result = diameters(mesh, options, &known);
  EXPECT_GE(result.raysCast, 32LL * moved);
  EXPECT_LT(result.raysCast, 32LL * mesh.vertexCount() / 8);
}

TEST(KnownDiameters, ACancelledRunLeavesThemAsTheyWere)
{
  Mesh mesh = icosphere(4);
  ShapeDiameterOptions options;
  options.backend = Backend::Host;
  KnownDiameters known;
  diameters(mesh, options, &known);
  const std::vector<double> before = known.measures.diameter;
  pull(mesh, 3, 0.5, Vector3(0, 0, 0.1));
  Context context;
  double reached = -1.0;
  context.progress = [&](double done) { reached = done; };
  context.cancelled = [&] { return reached >= 0.0; };
  EXPECT_THROW(diameters(mesh, options, &known, context), Error);
  EXPECT_TRUE(known.filled);
  EXPECT_EQ(known.measures.diameter, before);
  EXPECT_EQ(diameters(mesh, options, &known).diameter, diameters(mesh, options, nullptr).diameter);
}

TEST(KnownDiameters, FramesStandWhileAMeshChangesALittle)
{
  for (const Vector3& at : { Vector3(0, 0, 0), Vector3(0, 0.9, 0), Vector3(700, -3, 1e6) })
  {
    Mesh mesh = icosphere(2);
    for (Vector3& p : mesh.points)
    {
      p += at;
    }
    const RayFrame frame(mesh);
    double longest = 0.0;
    for (const auto& p : RayScene(mesh).points)
    {
      longest = std::max({ longest, std::abs(double(p[0])), std::abs(double(p[1])), std::abs(double(p[2])) });
    }
    EXPECT_LE(longest, 1.0);
    EXPECT_GE(2.0 / frame.scale, 0.88); // the sphere's diameter in the scene
    int exponent;
    EXPECT_EQ(std::frexp(frame.scale, &exponent), 0.5); // a power of two
    mesh.points[3] += 0.05 * (mesh.points[3] - at);
    EXPECT_TRUE(RayFrame(mesh) == frame);
  }
}

TEST(KnownDiameters, MatchFindsWhatIsTheSame)
{
  Random random(3);
  Mesh before = icosphere(2), now = before;
  now.points[7] *= 1.1;
  now.points.push_back(Vector3(0, 0, 0));
  renumber(now, random);
  const std::vector<Vector3> none(before.points.size(), Vector3::Zero()),
    alike(now.points.size(), Vector3::Zero());
  const MeshMatch match = matchMeshes(before, none, now, alike, Context());
  int lost = 0;
  for (int v = 0; v < now.vertexCount(); ++v)
  {
    if (match.vertices[v] < 0)
      ++lost;
    else
      EXPECT_EQ(before.points[match.vertices[v]], now.points[v]);
  }
  EXPECT_EQ(lost, 2);
  const auto ring = buildAdjacency(before).vertexTriangles;
  EXPECT_EQ(match.removed, std::vector<int>(ring.begin(7), ring.end(7)));
  EXPECT_EQ(match.added.size(), match.removed.size());
  // A hundred thousand vertices and facets at one place take no longer than others.
  Mesh pile;
  pile.points.assign(100000, Vector3(1, 2, 3));
  pile.triangles.assign(100000, { 0, 1, 2 });
  const std::vector<Vector3> up(pile.points.size(), Vector3(0, 0, 1));
  const MeshMatch piled = matchMeshes(pile, up, pile, up, Context());
  EXPECT_EQ(std::count(piled.vertices.begin(), piled.vertices.end(), -1), 0);
  EXPECT_TRUE(piled.added.empty() && piled.removed.empty());
}
