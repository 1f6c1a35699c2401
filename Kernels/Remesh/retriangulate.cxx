#include "Remesh/retriangulate.h"

#include "Remesh/passes.h"
#include "Remesh/reassemble.h"
#include "Remesh/relax.h"
#include "Remesh/splitting.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr int remeshRounds = 3;
// Triangles that an edit may ask for: more than any model needs, and made within a minute.
constexpr double mostTriangles = 250000.0, mostPerTriangle = 16.0;
// As published, in mean edges.
constexpr double roundEdge = 0.35; // times the radius of curvature
constexpr double finest = 0.25, coarsest = 1.5;
constexpr double splitOver = 1.5, collapseUnder = 0.5;
constexpr int curvatureRounds = 5;

// Faces that may change: those at a vertex strictly inside, but for those that are left.
std::vector<char> facesInside(const RetriangulateInput& input)
{
  const Mesh& mesh = input.rest;
  std::vector<char> active(mesh.triangles.size(), 0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    const bool isLeft = !input.left.empty() && (input.left[c[0]] || input.left[c[1]] || input.left[c[2]]);
    const bool whole = c[0] != c[1] && c[1] != c[2] && c[2] != c[0] && !isLeft;
    active[t] =
      whole && (input.region[c[0]] == 2 || input.region[c[1]] == 2 || input.region[c[2]] == 2) ? 1 : 0;
  }
  return active;
}

void requireMeanEdge(const RetriangulateInput& input)
{
  if (!(input.meanEdge > 0.0) || !std::isfinite(input.meanEdge))
  {
    throw Error(
      Failure::BadRegion, "The mean edge length is not above 0: take that of the mesh as it was loaded.");
  }
}

// Refuses what a stretched region would take to be covered, before it is tried: there would be no end of it.
void requireBounded(const Mesh& moved, const std::vector<char>& active, const std::vector<double>& sizes)
{
  double before = 0.0, wanted = 0.0;
  for (int t = 0; t < moved.triangleCount(); ++t)
  {
    if (active[t])
    {
      const Triangle& c = moved.triangles[t];
      const Vector3 &p = moved.points[c[0]], &q = moved.points[c[1]], &r = moved.points[c[2]];
      const double size = (sizes[c[0]] + sizes[c[1]] + sizes[c[2]]) / 3.0;
      const double longest = std::max({ (q - p).norm(), (r - q).norm(), (p - r).norm() });
      before += 1.0;
      wanted += 0.5 * (q - p).cross(r - p).norm() / (0.4330127 * size * size) + longest / size; // even ones
    }
  }
  if (!(wanted <= std::max(mostTriangles, mostPerTriangle * before)))
  {
    throw Error(Failure::Torn,
      "The edit stretches %1 triangles to what takes %2 as large as the model's: make a smaller edit, or "
      "none of them anew ({Rule Off}).",
      before,
      wanted);
  }
}

// The largest curvature of a vertex: of the form that fits the normal curvatures of its edges best, which of
// a sphere are all those of the sphere.
double largestCurvature(const Mesh& mesh, const Adjacency& adjacency, int v, const Vector3& normal)
{
  const Vector3 side = normal.unitOrthogonal(), other = normal.cross(side);
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  Vector3 sums = Vector3::Zero();
  double largest = 0.0;
  for (const int n : adjacency.vertexVertices[v])
  {
    const Vector3 edge = mesh.points[n] - mesh.points[v];
    const Vector2 flat(side.dot(edge), other.dot(edge));
    if (!(flat.squaredNorm() > 0.0))
    {
      continue;
    }
    const double curvature = 2.0 * normal.dot(edge) / edge.squaredNorm();
    const Vector2 d = flat.normalized();
    const Vector3 row(d[0] * d[0], 2.0 * d[0] * d[1], d[1] * d[1]);
    squares += row * row.transpose();
    sums += curvature * row;
    largest = std::max(largest, std::abs(curvature));
  }
  const Eigen::FullPivLU<Eigen::Matrix3d> solver(squares);
  if (!solver.isInvertible())
  {
    return largest; // fewer than three directions
  }
  const Vector3 form = solver.solve(sums);
  const double mean = 0.5 * (form[0] + form[2]);
  return std::abs(mean) + std::hypot(0.5 * (form[0] - form[2]), form[1]);
}

std::vector<double> curvatureSizes(const Mesh& mesh, double meanEdge, const Context& context)
{
  const Adjacency adjacency = buildAdjacency(mesh);
  const std::vector<Vector3> normals = vertexNormals(mesh);
  std::vector<double> sizes(mesh.points.size());
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      const double bend =
        normals[v] == Vector3::Zero() ? 0.0 : largestCurvature(mesh, adjacency, v, normals[v]) * meanEdge;
      sizes[v] = meanEdge * (bend > 0.0 ? std::clamp(roundEdge / bend, finest, coarsest) : coarsest);
    });
  return sizes;
}

} // namespace

Retriangulated retriangulateByCurvature(const RetriangulateInput& input, const Context& context)
{
  requireMeanEdge(input);
  const Cutout cutout({ input.moved, input.rest.triangles }, facesInside(input));
  const std::vector<int> oneChart;
  const Surface surface(cutout.mesh, cutout.active, oneChart);
  const Held held = heldIn(cutout, input);
  const std::vector<double> sizes = curvatureSizes(cutout.mesh, input.meanEdge, context);
  requireBounded(cutout.mesh, cutout.active, sizes);
  Patch patch(surface, cutout.active, sizes, held.vertices, held.edges, false);
  Steps steps{ context };
  steps.each = 1.0 / (3.0 * curvatureRounds);
  Retriangulated counts;
  for (int round = 0, moves = 1; round < curvatureRounds && moves > 0; ++round)
  {
    const int splits = splitAll(patch, splitOver, steps);
    const int collapses = collapseAll(patch, collapseUnder, splitOver, steps);
    const int flips = flipAll(patch, true, steps);
    counts.splits += splits;
    counts.collapses += collapses;
    counts.flips += flips;
    moves = splits + collapses + flips;
  }
  const std::vector<SurfacePoint> none;
  Retriangulated result = reassembled(input,
    cutout,
    surface,
    { cutout.mesh, cutout.active, none },
    patch,
    heldCurves(cutout, input, patch.keptSplits()),
    context);
  result.splits = counts.splits;
  result.collapses = counts.collapses;
  result.flips = counts.flips;
  return result;
}

Retriangulated retriangulateEdit(const RetriangulateInput& input,
  const Motion& motion,
  const Context& context)
{
  requireMeanEdge(input);
  const Cutout cutout(input.rest, facesInside(input));
  requireBounded(
    { valuesAt(input.moved, cutout.vertices), cutout.mesh.triangles }, cutout.active, sizesIn(cutout, input));
  const std::vector<int> oneChart;
  const Surface rest(cutout.mesh, cutout.active, oneChart);
  Held held = heldIn(cutout, input);
  Steps steps{ context };
  steps.each = 1.0 / (Splitting::rounds + 4.0 * remeshRounds + 2.0);
  Retriangulated counts;
  Splitting splitting(input, cutout, rest, held, motion);
  splitting.run(steps, counts);
  const Patch& split = splitting.patch();
  const std::vector<char>& touched = splitting.touched();
  if (std::find(touched.begin(), touched.end(), 1) == touched.end())
  {
    return untouched(input);
  }

  Mesh mesh;
  for (int v = 0; v < split.vertexCount(); ++v)
  {
    mesh.points.push_back(split.point(v));
  }
  for (int t = 0; t < split.triangleCount(); ++t)
  {
    mesh.triangles.push_back(split.triangle(t));
  }
  std::vector<SurfacePoint> origins;
  std::vector<double> sizes = sizesIn(cutout, input);
  for (int v = cutout.mesh.vertexCount(); v < split.vertexCount(); ++v)
  {
    const SurfacePoint& place = split.place(v);
    const Triangle& c = cutout.mesh.triangles[place.triangle];
    origins.push_back(place);
    sizes.push_back(input.sizes.empty() ? input.meanEdge
                                        : place.weights[0] * sizes[c[0]] + place.weights[1] * sizes[c[1]] +
                                            place.weights[2] * sizes[c[2]]);
  }
  std::vector<std::array<int, 3>> onCurves = split.keptSplits();
  held.edges.clear();
  for (const std::vector<HeldVertex>& curve : heldCurves(cutout, input, onCurves))
  {
    for (std::size_t i = 1; i < curve.size(); ++i)
    {
      if (curve[i - 1].own >= 0 && curve[i].own >= 0)
      {
        held.edges.push_back({ curve[i - 1].own, curve[i].own });
      }
    }
  }
  const Surface surface(mesh, touched, oneChart);
  Patch patch(surface, touched, sizes, held.vertices, held.edges, true);
  Relaxation relaxation(patch, context, true);
  for (int round = 0; round < remeshRounds; ++round)
  {
    counts.splits += splitAll(patch, Splitting::longestEdge, steps);
    counts.collapses += collapseAll(patch, Splitting::shortestEdge, Splitting::longestEdge, steps);
    counts.flips += flipAll(patch, false, steps);
    relaxation.run();
    steps.next();
  }
  counts.flips += flipByAngle(patch, steps);
  counts.splits += splitAll(patch, Splitting::longestEdge, steps);
  onCurves.insert(onCurves.end(), patch.keptSplits().begin(), patch.keptSplits().end());
  Retriangulated result = reassembled(
    input, cutout, rest, { mesh, touched, origins }, patch, heldCurves(cutout, input, onCurves), context);
  result.splits = counts.splits;
  result.collapses = counts.collapses;
  result.flips = counts.flips;
  return result;
}

namespace
{

// How the displacement changes from a vertex on along the surface.
Eigen::Matrix3d slopeAt(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Vector3& normal,
  int v)
{
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero(), products = Eigen::Matrix3d::Zero();
  const Vector3 own = moved[v] - rest.points[v];
  for (const int n : adjacency.vertexVertices[v])
  {
    const Vector3 edge = rest.points[n] - rest.points[v];
    const Vector3 along = edge - normal * normal.dot(edge);
    const Vector3 change = moved[n] - rest.points[n] - own;
    squares += along * along.transpose();
    products += change * along.transpose();
  }
  // Across the surface nothing is known, and nothing changes.
  squares += 0.5 * squares.trace() * normal * normal.transpose();
  Eigen::Matrix3d inverse;
  bool isInvertible = false;
  squares.computeInverseWithCheck(inverse, isInvertible, 1e-12 * std::pow(squares.trace(), 3));
  return isInvertible ? Eigen::Matrix3d(products * inverse) : Eigen::Matrix3d::Zero();
}

} // namespace

Motion motionBetween(const Mesh& rest,
  const Adjacency& adjacency,
  const std::vector<Vector3>& moved,
  const Context& context)
{
  constexpr std::size_t channels = 15;
  Motion motion;
  motion.channels = channels;
  motion.values.resize(channels * rest.points.size(), 0.0);
  // Elsewhere there is no displacement, and no slope of it.
  std::vector<char> concerned(rest.points.size(), 0);
  for (int v = 0; v < rest.vertexCount(); ++v)
  {
    if (moved[v] != rest.points[v])
    {
      concerned[v] = 1;
      for (const int n : adjacency.vertexVertices[v])
      {
        concerned[n] = 1;
      }
    }
  }
  context.each(rest.vertexCount(),
    [&](int v)
    {
      if (!concerned[v])
      {
        return;
      }
      double* values = motion.values.data() + channels * static_cast<std::size_t>(v);
      const Vector3 own = moved[v] - rest.points[v];
      const Eigen::Matrix3d slope =
        slopeAt(rest, adjacency, moved, vertexNormal(rest, adjacency.vertexTriangles, v), v);
      const Vector3 atOrigin = own - slope * rest.points[v];
      std::copy_n(own.data(), 3, values);
      std::copy_n(atOrigin.data(), 3, values + 3);
      std::copy_n(slope.data(), 9, values + 6);
    });
  motion.movement = [](const std::vector<Vector3>& points, const std::vector<double>& values)
  {
    std::vector<Vector3> result;
    result.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double* at = values.data() + channels * i;
      const Eigen::Map<const Vector3> flat(at), atOrigin(at + 3);
      const Eigen::Map<const Eigen::Matrix3d> slope(at + 6);
      const Vector3 expected = atOrigin + slope * points[i];
      result.emplace_back(points[i] + 0.5 * flat + 0.5 * expected);
    }
    return result;
  };
  return motion;
}

} // namespace oversketch
