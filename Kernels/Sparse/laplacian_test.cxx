#include "Sparse/laplacian.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <fstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A strip of length 1 and width 0.1 in the plane z = 0, its region between x = 0 and x = 1, with a fixed
// margin of some columns beyond each end, and a handle on each vertex of the middle column.
struct Strip
{
  static constexpr int inner = 200, margin = 3, across = 4;
  Mesh mesh = gridSurface(inner + 2 * margin,
    across,
    false,
    false,
    [](double u, double v) { return Vector3((u * (inner + 2 * margin) - margin) / inner, 0.02 * v, 0.0); });
  Adjacency adjacency = buildAdjacency(this->mesh);
  std::vector<char> region;
  std::vector<Binding> handles;

  Strip()
  {
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      const double x = this->mesh.points[v][0];
      this->region.push_back(x > -1e-9 && x < 1.0 + 1e-9);
      if (std::abs(x - 0.5) < 1e-9)
      {
        this->handles.push_back(Binding::vertex(v));
      }
    }
  }

  // Largest distance of the strip's displacement in z from the profile, for a handle raised by h.
  double worst(const LaplacianOptions& options, double h, const std::function<double(double)>& profile) const
  {
    const LaplacianSystem system(
      this->mesh, this->adjacency, this->region, this->handles, options, Context());
    const auto u = system.solve(std::vector<Vector3>(this->handles.size(), Vector3(0.0, 0.0, h)), Context());
    double worst = 0.0;
    for (int v = 0; v < this->mesh.vertexCount(); ++v)
    {
      const double x = this->mesh.points[v][0];
      if (this->region[v])
      {
        worst = std::max(worst, std::abs(u[v][2] - h * profile(2.0 * std::min(x, 1.0 - x))));
      }
      else
      {
        EXPECT_EQ(u[v], Vector3(Vector3::Zero()));
      }
    }
    return worst;
  }
};

double clampedBeam(double s)
{
  return 3.0 * s * s - 2.0 * s * s * s;
}
double hingedBeam(double s)
{
  return (3.0 * s - s * s * s) / 2.0;
}

} // namespace

TEST(A10_3, StripBendsLikeAClampedOrAHingedBeam)
{
  const Strip strip;
  LaplacianOptions options;
  options.handleWeight = 1000.0; // a firm handle: the profile is the beam's alone
  const double h = 0.3;
  const double clamped = strip.worst(options, h, clampedBeam) / h;
  EXPECT_LT(clamped, 0.01);
  EXPECT_GT(strip.worst(options, h, hingedBeam) / h, 0.05); // the two profiles are told apart
  options.borderRows = false;
  const double hinged = strip.worst(options, h, hingedBeam) / h;
  EXPECT_LT(hinged, 0.01);
  fact("A10_3",
    "profile within " + std::to_string(100 * clamped) + " % of h (clamped), " + std::to_string(100 * hinged) +
      " % (hinged)");
}

TEST(A10_3, MeanHandleResidualIsBelowTwoPerCent)
{
  const Strip strip;
  const LaplacianSystem system(
    strip.mesh, strip.adjacency, strip.region, strip.handles, LaplacianOptions(), Context());
  const Vector3 d(0.0, 0.0, 0.3);
  const auto u = system.solve(std::vector<Vector3>(strip.handles.size(), d), Context());
  double mean = 0.0;
  for (const Binding& handle : strip.handles)
  {
    mean += (handle.of(u) - d).norm() / d.norm() / static_cast<double>(strip.handles.size());
  }
  EXPECT_LT(mean, 0.02);
  fact("A10_3", "mean handle residual " + std::to_string(100 * mean) + " % on the strip");
}

TEST(CotangentWeights, EquilateralAndRightTriangles)
{
  const Mesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, std::sqrt(0.75), 0 }, { 0.5, -0.5, 0 } },
    { { 0, 1, 2 }, { 1, 0, 3 } } };
  const Adjacency adjacency = buildAdjacency(mesh);
  const auto weight = [&](int a, int b)
  { return cotangentWeight(mesh, adjacency, adjacency.findEdge(a, b)); };
  EXPECT_NEAR(weight(0, 1), 0.5 * (1 / std::sqrt(3.0) + 0.0), 1e-14);
  EXPECT_NEAR(weight(1, 2), 0.5 / std::sqrt(3.0), 1e-14);
  EXPECT_NEAR(weight(0, 3), 0.5, 1e-14);
}

TEST(CotangentWeights, TrianglesWithoutAreaStayFinite)
{
  // Collinear, two coincident corners, all three coincident, and a repeated vertex.
  const Mesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 }, { 0, 0, 0 }, { 0, 0, 0 } },
    { { 0, 1, 2 }, { 0, 3, 1 }, { 0, 3, 4 }, { 1, 1, 2 } } };
  const Adjacency adjacency = buildAdjacency(mesh);
  for (int e = 0; e < static_cast<int>(adjacency.edges.size()); ++e)
  {
    EXPECT_LE(std::abs(cotangentWeight(mesh, adjacency, e)), 1000.0);
  }
}

TEST(LaplacianSystem, PiecesWithoutAHandleAndFixedHandlesAreLeftAlone)
{
  const Strip strip;
  std::vector<char> region = strip.region;
  for (int v = 0; v < strip.mesh.vertexCount(); ++v)
  {
    const double x = strip.mesh.points[v][0];
    region[v] = region[v] && std::abs(x - 0.3) > 0.012; // a gap: two pieces
  }
  std::vector<Binding> handles = strip.handles;
  handles.push_back(Binding::vertex(0)); // outside the region
  const LaplacianSystem system(strip.mesh, strip.adjacency, region, handles, LaplacianOptions(), Context());
  EXPECT_TRUE(system.handleActive(0));
  EXPECT_FALSE(system.handleActive(static_cast<int>(handles.size()) - 1));
  const auto u = system.solve(std::vector<Vector3>(handles.size(), Vector3(0, 1, 1)), Context());
  for (int v = 0; v < strip.mesh.vertexCount(); ++v)
  {
    if (strip.mesh.points[v][0] < 0.3)
    {
      EXPECT_EQ(u[v], Vector3(Vector3::Zero()));
    }
  }
  try
  {
    const LaplacianSystem free(
      strip.mesh, strip.adjacency, region, { Binding::vertex(0) }, LaplacianOptions(), Context());
    FAIL() << free.movableCount() << " vertices move";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadRegion);
  }
}

TEST(LaplacianSystem, AnUnderdeterminedAdjustedSystemIsSolvedWithLeastMotion)
{
  // One handle cannot fix a free sphere's rotation and scale; pulled, it follows without anything blowing up.
  const Mesh mesh = icosphere(2);
  LaplacianOptions options;
  options.adjustNormals = true;
  const LaplacianSystem system(mesh,
    buildAdjacency(mesh),
    std::vector<char>(mesh.points.size(), 1),
    { Binding::vertex(7) },
    options,
    Context());
  const auto u = system.solve({ Vector3(0.5, 0, 0) }, Context());
  EXPECT_LT((u[7] - Vector3(0.5, 0, 0)).norm(), 1e-3);
  for (const Vector3& d : u)
  {
    EXPECT_LT(d.norm(), 1.0);
  }
}

TEST(LaplacianSystem, DegenerateTrianglesGiveAFiniteResult)
{
  Mesh mesh = gridSurface(20, 20, false, false, [](double u, double v) { return Vector3(u, v, 0.0); });
  const int middle = 10 * 21 + 10;
  mesh.points[middle + 1] = mesh.points[middle]; // zero-length edge
  mesh.points[middle + 21] =
    0.5 * (mesh.points[middle + 20] + mesh.points[middle + 42]); // collinear neighbours
  mesh.triangles.push_back({ middle, middle, middle + 1 });
  std::vector<char> region;
  for (const Vector3& p : mesh.points)
  {
    region.push_back((p - Vector3(0.5, 0.5, 0)).norm() < 0.4);
  }
  for (const bool adjust : { false, true })
  {
    LaplacianOptions options;
    options.adjustNormals = adjust;
    const LaplacianSystem system(
      mesh, buildAdjacency(mesh), region, { Binding::edge(middle, middle + 1, 0.4) }, options, Context());
    for (const Vector3& d : system.solve({ Vector3(0, 0, 0.2) }, Context()))
    {
      EXPECT_TRUE(d.allFinite());
      EXPECT_LT(d.norm(), 0.5);
    }
  }
}

TEST(LaplacianSystem, ScaleOfTheModelChangesNothing)
{
  for (const bool adjust : { false, true })
  {
    LaplacianOptions options;
    options.adjustNormals = adjust;
    std::vector<Vector3> reference;
    for (const double scale : { 1.0, 1e-6, 1e6 })
    {
      const Mesh mesh = icosphere(3, scale);
      std::vector<char> region;
      for (const Vector3& p : mesh.points)
      {
        region.push_back(p[2] > 0.1 * scale);
      }
      const LaplacianSystem system(
        mesh, buildAdjacency(mesh), region, { Binding::vertex(5), Binding::vertex(9) }, options, Context());
      auto u = system.solve({ Vector3(0, 0.3, 0.5) * scale, Vector3(0, 0.1, 0.2) * scale }, Context());
      for (Vector3& d : u)
      {
        d /= scale;
      }
      if (reference.empty())
      {
        reference = u;
      }
      for (std::size_t v = 0; v < u.size(); ++v)
      {
        EXPECT_LT((u[v] - reference[v]).norm(), 1e-9);
      }
    }
  }
}

TEST(LaplacianSystem, CancelStopsIt)
{
  const Strip strip;
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(
    LaplacianSystem(strip.mesh, strip.adjacency, strip.region, strip.handles, LaplacianOptions(), context),
    Error);
}

TEST(LaplacianSystem, OneShapeServesOtherHandlesAndWeights)
{
  const Strip strip;
  for (const bool adjust : { false, true })
  {
    LaplacianOptions options;
    options.adjustNormals = adjust;
    const auto movable = movableVertices(strip.adjacency, strip.region, strip.handles);
    const auto shape =
      std::make_shared<LaplacianShape>(strip.mesh, strip.adjacency, movable, true, adjust, Context());
    std::vector<Binding> handles = strip.handles;
    for (const double weight : { 10.0, 3.0 })
    {
      options.handleWeight = weight;
      const std::vector<Vector3> wanted(handles.size(), Vector3(0.0, 0.1, 0.3));
      const LaplacianSystem fresh(strip.mesh, strip.adjacency, strip.region, handles, options, Context());
      EXPECT_EQ(fresh.solve(wanted, Context()),
        LaplacianSystem(shape, handles, weight, Context()).solve(wanted, Context()));
      handles.pop_back();
    }
  }
}

TEST(LaplacianSystem, AHandleMayHangOnVerticesThatAreFarApart)
{
  const Strip strip;
  const std::vector<Binding> handles{ { { 500, 700, 520 }, { 0.25, 0.25, 0.5 } } };
  LaplacianOptions options;
  options.handleWeight = 1e3;
  const LaplacianSystem system(strip.mesh, strip.adjacency, strip.region, handles, options, Context());
  const Vector3 wanted(0.0, 0.0, 0.2);
  EXPECT_LT((handles[0].of(system.solve({ wanted }, Context())) - wanted).norm(), 1e-3);
}

TEST(LaplacianSystem, TheResponseIsWhatASolveForMovedTargetsAdds)
{
  const Strip strip;
  for (const bool adjust : { false, true })
  {
    LaplacianOptions options;
    options.adjustNormals = adjust;
    const LaplacianSystem system(
      strip.mesh, strip.adjacency, strip.region, strip.handles, options, Context());
    const Vector3 base(0.01, 0.0, 0.2), d(0.1, -0.2, 0.05);
    std::vector<double> shares;
    std::vector<Vector3> moved;
    for (std::size_t h = 0; h < strip.handles.size(); ++h)
    {
      shares.push_back(h % 2 == 0 ? 1.0 : 0.3);
      moved.emplace_back(base + shares.back() * d);
    }
    const auto from = system.solve(std::vector<Vector3>(strip.handles.size(), base), Context());
    const auto to = system.solve(moved, Context());
    Drag drag{ system.shape().vertices, {}, system.response(shares, Context()) };
    std::vector<Vector3> points = strip.mesh.points;
    for (const int v : drag.vertices)
    {
      drag.rest.push_back(points[v] + from[v]);
    }
    drag.place(d, points.front().data(), Context());
    double worst = 0.0;
    for (int v = 0; v < strip.mesh.vertexCount(); ++v)
    {
      worst = std::max(worst, (points[v] - strip.mesh.points[v] - to[v]).norm());
    }
    EXPECT_LT(worst, 1e-10);
  }
}
