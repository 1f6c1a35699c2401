#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Ray/bvh.h"
#include "Ray/ray_caster.h"
#include "Ray/shape_diameter.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

ShapeDiameterOptions on(Backend backend)
{
  ShapeDiameterOptions options;
  options.backend = backend;
  return options;
}

std::vector<ConeHit> hitsOf(const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options)
{
  std::vector<ConeHit> hits;
  const ShapeDiameter result =
    computeShapeDiameter(mesh, buildAdjacency(mesh), normals, options, Context(), &hits);
  if (options.backend == Backend::OpenCL && Device::instance())
  {
    EXPECT_EQ(result.used, Backend::OpenCL) << result.warning;
  }
  return hits;
}

// Every triangle tried, in double precision.
ConeHit bruteForce(const Mesh& mesh, int origin, const Vector3& direction)
{
  ConeHit best;
  for (int i = 0; i < mesh.triangleCount(); ++i)
  {
    const Triangle& t = mesh.triangles[i];
    if (std::count(t.begin(), t.end(), origin) > 0 || !(facetNormal(mesh, i).dot(direction) > 0.0))
    {
      continue;
    }
    // Cramer's rule for origin + x direction = a + y ab + z ac.
    const Vector3 a = mesh.points[t[0]] - mesh.points[origin];
    const Vector3 ab = mesh.points[t[1]] - mesh.points[t[0]], ac = mesh.points[t[2]] - mesh.points[t[0]];
    const double determinant = direction.dot(ab.cross(ac));
    const double x = a.dot(ab.cross(ac)) / determinant;
    const double y = -direction.dot(a.cross(ac)) / determinant;
    const double z = -direction.dot(ab.cross(a)) / determinant;
    if (y >= 0.0 && z >= 0.0 && y + z <= 1.0 && x > 0.0 && (best.triangle < 0 || x < best.length))
    {
      best = { x, i };
    }
  }
  return best;
}

// Spiky and self-intersecting: random displacements along the normals of a sphere.
Mesh spikySphere(int levels, double amount)
{
  Mesh mesh = icosphere(levels);
  std::mt19937 random(7);
  for (Vector3& p : mesh.points)
  {
    p *= 1.0 + amount * (static_cast<double>(random() % 1001) / 500.0 - 1.0);
  }
  return mesh;
}

// A unit box of n x n quads a side, whose corners are not shared between sides: cracks of no width.
Mesh box(int n)
{
  Mesh mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { -0.5, 0.5 })
    {
      const Mesh face = gridSurface(n,
        n,
        false,
        false,
        [&](double u, double v)
        {
          Vector3 p;
          p[axis] = side;
          p[(axis + 1) % 3] = side > 0 ? u - 0.5 : 0.5 - u;
          p[(axis + 2) % 3] = v - 0.5;
          return p;
        });
      const int first = mesh.vertexCount();
      mesh.points.insert(mesh.points.end(), face.points.begin(), face.points.end());
      for (const Triangle& t : face.triangles)
      {
        mesh.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
      }
    }
  }
  return mesh;
}

std::vector<Mesh> shapes()
{
  // Turned, so that no ray runs along a side from edge to edge, where hit and miss are both right.
  Mesh turned = box(6);
  for (Vector3& p : turned.points)
  {
    p = Eigen::AngleAxisd(0.7, Vector3(1, 2, 3).normalized()) * p;
  }
  return { icosphere(3), torus(1.0, 0.4, 60, 30), cylinder(0.5, 4.0, 40, 40), spikySphere(3, 0.3), turned };
}

} // namespace

TEST(Ray, FramesAreRightHandedAndOrthonormal)
{
  for (const Mesh& mesh : { icosphere(2), box(1) })
  {
    for (const Vector3& p : mesh.points)
    {
      const Vector3 axis = p.normalized();
      const Eigen::Matrix3d frame = frameAround(axis);
      EXPECT_LT((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm(), 1e-14);
      EXPECT_NEAR(frame.determinant(), 1.0, 1e-14);
      EXPECT_EQ(Vector3(frame.col(2)), axis);
    }
  }
}

TEST(Ray, TheShapeDiameterOfATurnedModelIsTheSame)
{
  const Mesh mesh = spikySphere(4, 0.3);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  Mesh turned = mesh;
  for (Vector3& p : turned.points)
  {
    p = turn * p;
  }
  const auto diameters = [](const Mesh& of)
  {
    return computeShapeDiameter(of, buildAdjacency(of), vertexNormals(of), on(Backend::Host), Context())
      .diameter;
  };
  const auto here = diameters(mesh), there = diameters(turned);
  int apart = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    apart += std::abs(here[v] - there[v]) > 1e-5 * here[v];
  }
  EXPECT_LT(apart, mesh.vertexCount() / 200); // rays through edges
}

TEST(Ray, TreeHoldsEveryTriangleOnceWithinItsBounds)
{
  std::vector<Mesh> meshes = shapes();
  meshes.push_back(icosphere(0));
  Mesh pile; // all centres coincide: the heuristic cannot part them
  pile.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  pile.triangles.assign(1000, { 0, 1, 2 });
  meshes.push_back(pile);
  for (const Mesh& mesh : meshes)
  {
    const RayScene scene(mesh);
    const Bvh bvh = buildBvh(scene, Context());
    std::multiset<int> seen;
    int deepest = 0;
    // Returns the bounds of the normals below.
    using Normals = std::array<std::array<float, 3>, 2>;
    const std::function<Normals(int, int)> walk = [&](int at, int waiting)
    {
      const Bvh::Node& node = bvh.nodes[at];
      const auto children = std::count_if(node.child, node.child + Bvh::width, [](int c) { return c != -1; });
      deepest = std::max(deepest, waiting + static_cast<int>(children));
      Normals all{ { { 9, 9, 9 }, { -9, -9, -9 } } };
      for (int i = 0; i < Bvh::width; ++i)
      {
        Normals below{ { { 9, 9, 9 }, { -9, -9, -9 } } };
        const auto add = [&](Normals& to, const std::array<float, 3>& low, const std::array<float, 3>& high)
        {
          for (int k = 0; k < 3; ++k)
          {
            to[0][k] = std::min(to[0][k], low[k]);
            to[1][k] = std::max(to[1][k], high[k]);
          }
        };
        if (node.child[i] >= 0)
        {
          EXPECT_GT(node.child[i], at);
          below = walk(node.child[i], waiting + static_cast<int>(children) - 1);
        }
        else if (node.child[i] < -1)
        {
          const Bvh::Pack& pack = bvh.packs[-2 - node.child[i]];
          for (int k = 0; k < Bvh::width; ++k)
          {
            const int t = pack.triangle[k];
            if (t < 0)
            {
              continue;
            }
            seen.insert(t);
            add(below, scene.facets[t].normal, scene.facets[t].normal);
            for (int corner = 0; corner < 3; ++corner)
            {
              for (int axis = 0; axis < 3; ++axis)
              {
                const float x = pack.corner[corner][axis][k];
                EXPECT_EQ(x, scene.points[mesh.triangles[t][corner]][axis]);
                EXPECT_LE(node.lower[axis][i], x);
                EXPECT_GE(node.upper[axis][i], x);
              }
            }
          }
        }
        else
        {
          EXPECT_GT(node.lower[0][i], node.upper[0][i]);
          continue;
        }
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_LE(static_cast<float>(node.normalLower[k][i]), Bvh::normalScale * below[0][k]);
          EXPECT_GE(static_cast<float>(node.normalUpper[k][i]), Bvh::normalScale * below[1][k]);
        }
        add(all, below[0], below[1]);
      }
      return all;
    };
    walk(0, 0);
    EXPECT_EQ(static_cast<int>(seen.size()), mesh.triangleCount());
    EXPECT_EQ(static_cast<int>(std::set<int>(seen.begin(), seen.end()).size()), mesh.triangleCount());
    EXPECT_LE(deepest, bvh.stackSize);
  }
}

TEST(Ray, BothBackendsFindWhatTryingEveryTriangleFinds)
{
  for (const Mesh& mesh : { icosphere(2), torus(1.0, 0.4, 24, 12), spikySphere(2, 0.3) })
  {
    const auto normals = vertexNormals(mesh);
    const auto sides = coneSides(mesh, RayScene(mesh), trianglesAround(mesh), normals, Context());
    const auto cone = coneDirections(32, 60.0);
    const std::array hits{ hitsOf(mesh, normals, on(Backend::OpenCL)),
      hitsOf(mesh, normals, on(Backend::Host)) };
    std::array<int, 2> differing{};
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      const Eigen::Matrix3d frame = frameAround(-normals[v], sides[v]);
      for (int k = 0; k < 32; ++k)
      {
        const ConeHit expected = bruteForce(mesh, v, frame * cone[k]);
        for (int backend = 0; backend < 2; ++backend)
        {
          const ConeHit& hit = hits[backend][v * 32 + k];
          // A ray through an edge may land on either side of it.
          differing[backend] += (hit.triangle < 0) != (expected.triangle < 0) ||
                                std::abs(hit.length - expected.length) > 1e-5 * expected.length;
        }
      }
    }
    EXPECT_EQ(differing, (std::array<int, 2>{}));
  }
}

TEST(Ray, CurveVisitsEveryPointOnceAndKeepsNeighboursTogether)
{
  const int n = 16;
  std::vector<std::array<float, 4>> points;
  for (int i = 0; i < n * n * n; ++i)
  {
    const auto along = [](int k) { return (static_cast<float>(k) + 0.5f) / (0.5f * n) - 1.0f; };
    points.push_back({ along(i % n), along(i / n % n), along(i / n / n), 0.0f });
  }
  const std::vector<int> order = curveOrder(points, Context()).indices;
  EXPECT_EQ(std::set<int>(order.begin(), order.end()).size(), points.size());
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    float step = 0.0f; // to a neighbour in the grid, always
    for (int k = 0; k < 3; ++k)
    {
      step += std::abs(points[order[i]][k] - points[order[i - 1]][k]);
    }
    EXPECT_NEAR(step, 2.0f / n, 1e-6f);
  }
}

TEST(Ray, FramesStandWhileAMeshChangesALittle)
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

TEST(Ray, SeamsChangeNothing)
{
  // The same box with its sides joined: rays from an edge pass through the side that they start on.
  Mesh split = box(6), joined = split;
  for (Triangle& t : joined.triangles)
  {
    for (int& corner : t)
    {
      const auto same = [&](const Vector3& p) { return p == split.points[corner]; };
      corner =
        static_cast<int>(std::find_if(split.points.begin(), split.points.end(), same) - split.points.begin());
    }
  }
  const auto normals = vertexNormals(split);
  for (const Backend backend : { Backend::OpenCL, Backend::Host })
  {
    const auto a = hitsOf(split, normals, on(backend)), b = hitsOf(joined, normals, on(backend));
    for (std::size_t i = 0; i < a.size(); ++i)
    {
      EXPECT_EQ(a[i].triangle, b[i].triangle);
    }
  }
}

TEST(Ray, HitsDoNotDependOnThreadsOrOrder)
{
  const Mesh mesh = spikySphere(4, 0.2);
  const auto normals = vertexNormals(mesh);
  const Adjacency adjacency = buildAdjacency(mesh);
  for (const Backend backend : { Backend::OpenCL, Backend::Host })
  {
    const auto one = computeShapeDiameter(mesh, adjacency, normals, on(backend), Context());
    const auto three = computeShapeDiameter(mesh, adjacency, normals, on(backend), withThreads(3));
    EXPECT_EQ(one.diameter, three.diameter);
  }
}

TEST(A6_4, DeviceHitLengthsEqualEmbrees)
{
  const auto device = Device::instance();
  if (!device)
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  // What the casters themselves say, in single precision, before lengths are refined.
  double worst = 0.0;
  long long rays = 0, hitCount = 0, apart = 0;
  const auto cone = coneDirections(32, 60.0);
  for (const Mesh& mesh : shapes())
  {
    const auto normals = vertexNormals(mesh);
    const RayScene scene(mesh);
    RayBatch batch;
    batch.raysPerVertex = 32;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      batch.vertices.push_back(v);
      const Eigen::Matrix3d frame = frameAround(-normals[v]);
      for (const Vector3& d : cone)
      {
        const Eigen::Vector3f f = (frame * d).cast<float>();
        batch.directions.push_back({ f[0], f[1], f[2] });
      }
    }
    std::vector<RayHit> onDevice, onHost;
    makeOpenCLCaster(scene, device, Context())->cast(batch, onDevice, Context());
    makeEmbreeCaster(scene)->cast(batch, onHost, Context());
    ASSERT_EQ(onDevice.size(), mesh.points.size() * 32);
    ASSERT_EQ(onHost.size(), mesh.points.size() * 32);
    rays += static_cast<long long>(onDevice.size());
    for (std::size_t i = 0; i < onDevice.size(); ++i)
    {
      ASSERT_EQ(onDevice[i].triangle < 0, onHost[i].triangle < 0) << "ray " << i;
      hitCount += onDevice[i].triangle >= 0;
      apart += onDevice[i].triangle != onHost[i].triangle;
      if (onDevice[i].triangle >= 0)
      {
        worst = std::max(worst, std::abs(double(onDevice[i].distance) / double(onHost[i].distance) - 1.0));
      }
    }
  }
  EXPECT_GT(hitCount, rays / 2);
  EXPECT_LT(worst, 1e-4);
  fact("A6_4",
    "device against Embree, " + std::to_string(rays) +
      " rays (32 a vertex) on 5 meshes: same misses, lengths within " + std::to_string(worst * 1e6) +
      "e-6, other facet (on a shared edge) " + std::to_string(apart) + " times");
}

TEST(Ray, UnmeasuredVerticesTakeTheirNeighboursValues)
{
  // An open sheet beside a sphere: no ray from the sheet finds a facet to leave through.
  Mesh mesh = icosphere(2);
  const int sphere = mesh.vertexCount();
  const Mesh sheet = gridSurface(3, 3, false, false, [](double u, double v) { return Vector3(u, v, 5.0); });
  mesh.points.insert(mesh.points.end(), sheet.points.begin(), sheet.points.end());
  mesh.points.push_back({ 9, 9, 9 }); // a loose point
  for (const Triangle& t : sheet.triangles)
  {
    mesh.triangles.push_back({ t[0] + sphere, t[2] + sphere, t[1] + sphere }); // its back to the sphere
  }
  const auto normals = vertexNormals(mesh);
  const auto result = computeShapeDiameter(mesh, buildAdjacency(mesh), normals, on(Backend::Host), Context());
  double mean = 0.0;
  for (int v = 0; v < sphere; ++v)
  {
    EXPECT_TRUE(result.measured[v]);
    mean += result.diameter[v] / sphere;
  }
  for (int v = sphere; v < mesh.vertexCount(); ++v)
  {
    EXPECT_FALSE(result.measured[v]);
    EXPECT_NEAR(result.diameter[v], mean, 1e-12);
  }
  EXPECT_EQ(result.raysCast, 32 * (mesh.vertexCount() - 1)); // the loose point has no normal
  // The sheet alone.
  const auto alone =
    computeShapeDiameter(sheet, buildAdjacency(sheet), vertexNormals(sheet), on(Backend::Host), Context());
  EXPECT_EQ(alone.diameter, std::vector<double>(16, boundingDiagonal(sheet)));
  // Points without a triangle, and nothing at all.
  const Mesh points{ { { 0, 0, 0 }, { 3, 4, 0 } }, {} };
  EXPECT_EQ(
    computeShapeDiameter(points, buildAdjacency(points), vertexNormals(points), on(Backend::Auto), Context())
      .diameter,
    std::vector<double>(2, 5.0));
}

TEST(Ray, FillingGoesRingByRing)
{
  const Mesh mesh = spikySphere(2, 0.2);
  const Adjacency adjacency = buildAdjacency(mesh);
  auto normals = vertexNormals(mesh);
  const auto ringOf = [&](int v)
  { return std::vector<int>(adjacency.vertexVertices.begin(v), adjacency.vertexVertices.end(v)); };
  const int centre = 100;
  std::set<int> hole{ centre };
  for (const int n : ringOf(centre))
  {
    hole.insert(n);
  }
  for (const int v : hole)
  {
    normals[v].setZero(); // no normal, no axis, no ray
  }
  const auto result = computeShapeDiameter(mesh, adjacency, normals, on(Backend::Host), Context());
  EXPECT_EQ(result.raysCast, 32 * (mesh.vertexCount() - static_cast<int>(hole.size())));
  for (const int v : hole)
  {
    EXPECT_FALSE(result.measured[v]);
    double sum = 0.0;
    int count = 0;
    for (const int n : ringOf(v))
    {
      if (v == centre || hole.count(n) == 0) // the inner ring knows only what was measured
      {
        sum += result.diameter[n];
        ++count;
      }
    }
    EXPECT_DOUBLE_EQ(result.diameter[v], sum / count);
  }
}

TEST(Ray, CancelStopsBetweenBlocksOnBothBackends)
{
  const Mesh mesh = icosphere(5); // 10242 vertices: two blocks
  const auto normals = vertexNormals(mesh);
  for (const Backend backend : { Backend::OpenCL, Backend::Host })
  {
    Context context;
    double reached = 0.0;
    context.progress = [&](double done) { reached = done; };
    context.cancelled = [&] { return reached > 0.0; };
    EXPECT_THROW(computeShapeDiameter(mesh, buildAdjacency(mesh), normals, on(backend), context), Error);
    EXPECT_LT(reached, 1.0);
  }
}
