#include "Remesh/retriangulate.h"

#include "Remesh/passes.h"
#include "Remesh/reassemble.h"
#include "Remesh/relax.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <sstream>

namespace oversketch
{
namespace
{

// In mean edges.
constexpr double longestEdge = 4.0 / 3.0;
constexpr double shortestEdge = 0.35;
constexpr double largestSag = 0.03; // of an edge's length
constexpr double smallestChange = 1.01;
constexpr double coincidence = 1e-6; // of an edge's length
// Twice the area of a triangle over the sum of two squared sides: one that is not greater than this has none.
constexpr double flattest = 1e-6;
constexpr int splitRounds = 6;
constexpr int remeshRounds = 3;
// Triangles that an edit may ask for: more than any model needs, and made within a minute.
constexpr double mostTriangles = 250000.0, mostPerTriangle = 16.0;
// As published, in mean edges.
constexpr double roundEdge = 0.35; // times the radius of curvature
constexpr double finest = 0.25, coarsest = 1.5;
constexpr double splitOver = 1.5, collapseUnder = 0.5;
constexpr int curvatureRounds = 5;

// Faces that may change: those at a vertex strictly inside.
std::vector<char> facesInside(const RetriangulateInput& input)
{
  const Mesh& mesh = input.rest;
  std::vector<char> active(mesh.triangles.size(), 0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    const bool whole = c[0] != c[1] && c[1] != c[2] && c[2] != c[0];
    active[t] =
      whole && (input.region[c[0]] == 2 || input.region[c[1]] == 2 || input.region[c[2]] == 2) ? 1 : 0;
  }
  return active;
}

void requireMeanEdge(const RetriangulateInput& input)
{
  if (!(input.meanEdge > 0.0) || !std::isfinite(input.meanEdge))
  {
    throw Error(Failure::BadRegion,
      "The mean edge length is not above 0: take it from vtkOversketchMeanEdge when the mesh is loaded.");
  }
}

// What a stretched region would take to be covered, before it is tried: there would be no end of it.
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
    std::ostringstream message;
    message << "The edit stretches " << before << " triangles to what takes " << wanted
            << " as large as the model's: make a smaller edit, or none of them anew (Rule Off, --rule off).";
    throw Error(Failure::Torn, message.str());
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
  for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
  {
    const Vector3 edge = mesh.points[*n] - mesh.points[v];
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
  context.parallelFor(mesh.vertexCount(),
    [&](int begin, int end)
    {
      for (int v = begin; v < end; ++v)
      {
        const double bend =
          normals[v] == Vector3::Zero() ? 0.0 : largestCurvature(mesh, adjacency, v, normals[v]) * meanEdge;
        sizes[v] = meanEdge * (bend > 0.0 ? std::clamp(roundEdge / bend, finest, coarsest) : coarsest);
      }
    });
  return sizes;
}

// The patch as the edit moves it, while its edges are split before the edit.
class Splitting
{
public:
  Splitting(const RetriangulateInput& input,
    const Cutout& cutout,
    const Surface& rest,
    const Held& held,
    const Movement& movement,
    const std::vector<double>& values,
    int channels)
    : Input(input)
    , Cut(cutout)
    , Rest(rest)
    , Moves(movement)
    , Values(values)
    , Channels(channels)
    , Sizes(cutout.vertices.size(), input.meanEdge)
    , Area(rest, cutout.active, Sizes, held.vertices, held.edges, false)
    , AtRest(cutout.mesh.points)
    , Touched(cutout.active.size(), 0)
    , Fresh(cutout.active)
  {
    this->Area.moveTo(Cutout::taken(input.moved, cutout.vertices));
    for (int v = 0; v < this->Area.vertexCount(); ++v)
    {
      this->Taken.insert(keyOf(this->Area.point(v)));
    }
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      for (int h = 3 * t; this->Area.aliveTriangle(t) && h < 3 * t + 3; ++h)
      {
        const double now = this->lengthOf(h), before = this->restLength(h);
        this->Touched[t] |= now > smallestChange * before || before > smallestChange * now ? 1 : 0;
      }
    }
  }

  void run(Steps& steps, Retriangulated& counts)
  {
    for (int round = 0; round < splitRounds; ++round)
    {
      std::vector<Wish> wishes = this->wishes();
      std::fill(this->Fresh.begin(), this->Fresh.end(), 0);
      counts.splits += this->split(wishes);
      const int flips = this->flip();
      counts.flips += flips;
      steps.next();
      if (wishes.empty() && flips == 0)
      {
        break;
      }
    }
  }

  const Patch& patch() const { return this->Area; }
  const std::vector<char>& touched() const { return this->Touched; }

private:
  struct Wish // to split an edge
  {
    int a, b, h;
    SurfacePoint place;
    double length;
    Vector3 position;
  };

  double lengthOf(int h) const
  {
    return (this->Area.point(this->Area.target(h)) - this->Area.point(this->Area.origin(h))).norm();
  }
  double restLength(int h) const
  {
    return (this->AtRest[this->Area.target(h)] - this->AtRest[this->Area.origin(h)]).norm();
  }

  // The middle of an edge before the edit. An edge that was swapped need not lie on the surface there.
  SurfacePoint middleOf(int h) const
  {
    const int a = this->Area.origin(h), b = this->Area.target(h);
    SurfacePoint place;
    if (this->Rest.middle(this->Area.place(a), this->Area.place(b), -1, place))
    {
      return place;
    }
    const Vector3 middle = 0.5 * (this->AtRest[a] + this->AtRest[b]);
    const SurfacePoint first = this->Rest.closest(middle, this->Area.place(a).triangle);
    const SurfacePoint second = this->Rest.closest(middle, this->Area.place(b).triangle);
    const auto distance = [&](const SurfacePoint& at)
    { return (positionOf(this->Rest.mesh(), at) - middle).squaredNorm(); };
    return distance(second) < distance(first) ? second : first;
  }

  void addValues(const SurfacePoint& at, std::vector<double>& values) const
  {
    const Triangle& c = this->Cut.mesh.triangles[at.triangle];
    for (int i = 0; i < this->Channels; ++i)
    {
      double sum = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        sum += at.weights[k] * this->Values[static_cast<std::size_t>(this->Cut.vertices[c[k]]) *
                                              static_cast<std::size_t>(this->Channels) +
                                            static_cast<std::size_t>(i)];
      }
      values.push_back(sum);
    }
  }

  // Of the edges at faces that are new.
  std::vector<Wish> wishes() const
  {
    std::vector<Wish> all;
    std::vector<Vector3> middles;
    std::vector<double> values;
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      this->Area.eachEdge(t,
        [&](int h)
        {
          if (!this->Area.inner(h) || !(this->Fresh[t] || this->Fresh[this->Area.twin(h) / 3]) ||
              this->lengthOf(h) <= shortestEdge * this->Input.meanEdge)
          {
            return;
          }
          all.push_back(
            { this->Area.origin(h), this->Area.target(h), h, this->middleOf(h), 0.0, Vector3::Zero() });
          middles.push_back(positionOf(this->Rest.mesh(), all.back().place));
          this->addValues(all.back().place, values);
        });
    }
    const std::vector<Vector3> moved = this->Moves(middles, values);
    std::vector<Wish> chosen;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      Wish& wish = all[i];
      wish.position = moved[i];
      wish.length = this->lengthOf(wish.h);
      const auto sagOf = [](const Vector3& a, const Vector3& b, const Vector3& middle)
      { return (middle - 0.5 * (a + b)).norm(); };
      const double sag = sagOf(this->Area.point(wish.a), this->Area.point(wish.b), moved[i]);
      const bool stretched = wish.length > longestEdge * this->Input.meanEdge &&
                             wish.length > smallestChange * this->restLength(wish.h);
      const bool bent = sag > largestSag * wish.length &&
                        sag > smallestChange * sagOf(this->AtRest[wish.a], this->AtRest[wish.b], middles[i]);
      if (stretched || bent)
      {
        chosen.push_back(wish);
      }
    }
    return chosen;
  }

  // The middle of an edge that was swapped, brought back to the surface, may be a place that has a vertex, at
  // the faces or elsewhere: two at one place would be taken for one by whoever welds the mesh.
  static std::array<double, 3> keyOf(const Vector3& p) { return { p[0], p[1], p[2] }; }
  bool meetsCorner(const Wish& wish, int h) const
  {
    const Triangle corners = this->Area.triangle(h / 3);
    return std::any_of(corners.begin(),
      corners.end(),
      [&](int v) { return (this->Area.point(v) - wish.position).norm() <= coincidence * wish.length; });
  }

  // It may lie on the line of another edge, too: a half of the face would have no area.
  bool hasFlatHalf(const Wish& wish, int h) const
  {
    const Vector3& apex = this->Area.point(this->Area.origin(previousHalfEdge(h)));
    const auto isFlat = [&](int v)
    {
      const Vector3 a = this->Area.point(v) - wish.position, b = apex - wish.position;
      return !(a.cross(b).norm() > flattest * (a.squaredNorm() + b.squaredNorm()));
    };
    return isFlat(this->Area.origin(h)) || isFlat(this->Area.target(h));
  }

  // Longest first.
  int split(std::vector<Wish>& wishes)
  {
    std::stable_sort(
      wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.length > b.length; });
    int made = 0;
    for (const Wish& wish : wishes)
    {
      const int h = this->Area.find(wish.a, wish.b, wish.h), g = h >= 0 ? this->Area.twin(h) : -1;
      if (g < 0 || this->Area.origin(previousHalfEdge(h)) == this->Area.origin(previousHalfEdge(g)))
      {
        continue; // two faces upon each other
      }
      if (this->meetsCorner(wish, h) || this->meetsCorner(wish, g) || this->hasFlatHalf(wish, h) ||
          this->hasFlatHalf(wish, g) || !this->Taken.insert(keyOf(wish.position)).second)
      {
        continue;
      }
      std::array<int, 4> neighbours;
      this->Area.halve(h, wish.place, wish.position, neighbours);
      this->AtRest.push_back(positionOf(this->Rest.mesh(), wish.place));
      const std::size_t count = static_cast<std::size_t>(this->Area.triangleCount());
      this->Touched.resize(count, 1);
      this->Fresh.resize(count, 1);
      this->Touched[h / 3] = this->Touched[g / 3] = this->Fresh[h / 3] = this->Fresh[g / 3] = 1;
      ++made;
    }
    return made;
  }

  // Two faces that would lie well before the edit, too: what comes between them is placed there.
  bool liesWellAtRest(int h) const
  {
    const int g = this->Area.twin(h);
    const Vector3 &a = this->AtRest[this->Area.origin(h)], &b = this->AtRest[this->Area.target(h)];
    const Vector3& c = this->AtRest[this->Area.origin(previousHalfEdge(h))];
    const Vector3& d = this->AtRest[this->Area.origin(previousHalfEdge(g))];
    const Vector3 whole = (b - a).cross(c - a) + (d - a).cross(b - a);
    return (d - a).cross(c - a).dot(whole) > 0.0 && (b - d).cross(c - d).dot(whole) > 0.0;
  }

  int flip()
  {
    int made = 0;
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      this->Area.eachEdge(t,
        [&](int h)
        {
          const int other = this->Area.inner(h) ? this->Area.twin(h) / 3 : t;
          if (other != t && this->Touched[t] && this->Touched[other] && this->liesWellAtRest(h) &&
              this->Area.flip(h, true))
          {
            this->Fresh[t] = this->Fresh[other] = 1;
            ++made;
          }
        });
    }
    return made;
  }

  const RetriangulateInput& Input;
  const Cutout& Cut;
  const Surface& Rest;
  const Movement& Moves;
  const std::vector<double>& Values;
  const int Channels;
  const std::vector<double> Sizes;
  Patch Area;
  std::vector<Vector3> AtRest;           // of the patch's vertices
  std::set<std::array<double, 3>> Taken; // where they are
  std::vector<char> Touched, Fresh;      // of its triangles: moved or split; new since edges were looked at
};

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
    heldCurves(cutout, input, patch.keptSplits()));
  result.splits = counts.splits;
  result.collapses = counts.collapses;
  result.flips = counts.flips;
  return result;
}

Retriangulated retriangulateEdit(const RetriangulateInput& input,
  const Movement& movement,
  const std::vector<double>& values,
  int channels,
  const Context& context)
{
  requireMeanEdge(input);
  const Cutout cutout(input.rest, facesInside(input));
  requireBounded({ Cutout::taken(input.moved, cutout.vertices), cutout.mesh.triangles },
    cutout.active,
    std::vector<double>(cutout.vertices.size(), input.meanEdge));
  const std::vector<int> oneChart;
  const Surface rest(cutout.mesh, cutout.active, oneChart);
  Held held = heldIn(cutout, input);
  Steps steps{ context };
  steps.each = 1.0 / (splitRounds + 3.0 * remeshRounds + 2.0);
  Retriangulated counts;
  Splitting splitting(input, cutout, rest, held, movement, values, channels);
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
  for (int v = cutout.mesh.vertexCount(); v < split.vertexCount(); ++v)
  {
    origins.push_back(split.place(v));
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
  const std::vector<double> sizes(mesh.points.size(), input.meanEdge);
  Patch patch(surface, touched, sizes, held.vertices, held.edges, true);
  Relaxation relaxation(patch, context);
  for (int round = 0; round < remeshRounds; ++round)
  {
    counts.collapses += collapseAll(patch, shortestEdge, longestEdge, steps);
    counts.flips += flipAll(patch, true, steps);
    relaxation.run();
    steps.next();
  }
  counts.flips += flipAll(patch, true, steps);
  counts.splits += splitAll(patch, longestEdge, steps);
  onCurves.insert(onCurves.end(), patch.keptSplits().begin(), patch.keptSplits().end());
  Retriangulated result =
    reassembled(input, cutout, rest, { mesh, touched, origins }, patch, heldCurves(cutout, input, onCurves));
  result.splits = counts.splits;
  result.collapses = counts.collapses;
  result.flips = counts.flips;
  return result;
}

} // namespace oversketch
