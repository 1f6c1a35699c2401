#include "Remesh/retriangulate.h"

#include "Remesh/passes.h"
#include "Remesh/reassemble.h"
#include "Remesh/relax.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <unordered_set>
#include <utility>

namespace oversketch
{
namespace
{

// In mean edges.
constexpr double longestEdge = 4.0 / 3.0;
constexpr double shortestEdge = 0.35;
constexpr double largestSag = 0.03; // of an edge's length
constexpr double smallestChange = 1.01;
constexpr double coincidence = 1e-6; // of two vertices
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

// Places that have a vertex. The middle of an edge that was swapped, brought back to the surface, may be one:
// two vertices at one place would be taken for one by whoever welds the mesh.
class TakenPlaces
{
public:
  explicit TakenPlaces(double apart)
    : Cell(apart)
  {
  }
  // False where the place, or one very near, is taken.
  bool take(const Vector3& p)
  {
    return this->Cells
      .insert({ std::floor(p[0] / this->Cell) + 0.0,
        std::floor(p[1] / this->Cell) + 0.0,
        std::floor(p[2] / this->Cell) + 0.0 }) // + 0.0: there is no -0.0
      .second;
  }
  void reserve(std::size_t count) { this->Cells.reserve(count); }

private:
  using Key = std::array<double, 3>;
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      std::size_t seed = 0;
      for (const double part : key)
      {
        seed = (seed ^ std::hash<double>()(part)) * 0x9e3779b97f4a7c15u;
        seed ^= seed >> 29;
      }
      return seed;
    }
  };
  double Cell;
  std::unordered_set<Key, Hash> Cells;
};

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
    , Taken(coincidence * input.meanEdge)
    , Touched(cutout.active.size(), 0)
    , IsSplit(cutout.active.size(), 0)
  {
    this->Area.moveTo(Cutout::taken(input.moved, cutout.vertices));
    this->Taken.reserve(4 * cutout.vertices.size());
    for (int v = 0; v < this->Area.vertexCount(); ++v)
    {
      this->Taken.take(this->Area.point(v));
    }
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      for (int h = 3 * t; this->Area.aliveTriangle(t) && h < 3 * t + 3; ++h)
      {
        const double now = this->squaredLength(h), before = this->squaredRestLength(h);
        constexpr double change = smallestChange * smallestChange;
        this->Touched[t] |= now > change * before || before > change * now ? 1 : 0;
      }
      this->Area.eachEdge(t,
        [this](int h)
        {
          if (this->Area.inner(h))
          {
            this->addEdge(h);
          }
        });
    }
  }

  void run(Steps& steps, Retriangulated& counts)
  {
    for (int round = 0; round < splitRounds; ++round)
    {
      this->lookAtEdges(steps.context);
      const std::vector<int> split = this->split();
      const int flips = this->flip(split, round == 0);
      counts.splits += static_cast<int>(split.size()) / 4;
      counts.flips += flips;
      steps.next();
      if (this->Wishes.empty() && this->Fresh.empty())
      {
        break;
      }
    }
  }

  const Patch& patch() const { return this->Area; }
  const std::vector<char>& touched() const { return this->Touched; }

private:
  struct Edge
  {
    int a, b, h; // h: a half-edge of it, from a to b, at the time
  };
  struct Wish // to split an edge
  {
    Edge edge;
    double squaredLength;
    SurfacePoint place;
    Vector3 position;
  };

  double squaredLength(int h) const
  {
    return (this->Area.point(this->Area.target(h)) - this->Area.point(this->Area.origin(h))).squaredNorm();
  }
  double squaredRestLength(int h) const
  {
    return (this->AtRest[this->Area.target(h)] - this->AtRest[this->Area.origin(h)]).squaredNorm();
  }

  void addEdge(int h) { this->Fresh.push_back({ this->Area.origin(h), this->Area.target(h), h }); }

  // The middle of an edge before the edit. An edge that was swapped need not lie on the surface there.
  SurfacePoint middleOf(int h) const
  {
    const int a = this->Area.origin(h), b = this->Area.target(h), t = h / 3;
    SurfacePoint place{ t, { 0.0, 0.0, 0.0 } };
    if (t < this->Cut.mesh.triangleCount() && this->Area.triangle(t) == this->Cut.mesh.triangles[t])
    {
      place.weights[h % 3] = place.weights[nextHalfEdge(h) % 3] = 0.5;
      return place;
    }
    const SurfacePoint &from = this->Area.place(a), &to = this->Area.place(b);
    if (this->Rest.middleIn(from.triangle, from, to, place) ||
        this->Rest.middleIn(to.triangle, from, to, place) || this->Rest.middle(from, to, -1, place))
    {
      return place;
    }
    const Vector3 middle = 0.5 * (this->AtRest[a] + this->AtRest[b]);
    const auto nearest = [&](const SurfacePoint& start)
    { return this->Rest.closest(middle, this->Rest.towards(middle, start.triangle)); };
    const SurfacePoint first = nearest(from), second = nearest(to);
    const auto distance = [&](const SurfacePoint& at)
    { return (positionOf(this->Rest.mesh(), at) - middle).squaredNorm(); };
    return distance(second) < distance(first) ? second : first;
  }

  void mixValues(const SurfacePoint& at, double* values) const
  {
    const Triangle& c = this->Cut.mesh.triangles[at.triangle];
    const auto valuesOf = [&](int corner)
    {
      return this->Values.data() + static_cast<std::size_t>(this->Cut.vertices[c[corner]]) *
                                     static_cast<std::size_t>(this->Channels);
    };
    const double *first = valuesOf(0), *second = valuesOf(1), *third = valuesOf(2);
    for (int i = 0; i < this->Channels; ++i)
    {
      values[i] = at.weights[0] * first[i] + at.weights[1] * second[i] + at.weights[2] * third[i];
    }
  }

  // Wishes of the edges that are new. Threaded, by blocks, so that the movement sees the same ones together.
  void lookAtEdges(const Context& context)
  {
    const double shortest = shortestEdge * this->Input.meanEdge;
    std::vector<int> edges;
    edges.reserve(this->Fresh.size());
    for (const Edge& edge : this->Fresh)
    {
      const int h = this->Area.find(edge.a, edge.b, edge.h);
      if (h >= 0 && this->squaredLength(h) > shortest * shortest)
      {
        edges.push_back(h);
      }
    }
    this->Fresh.clear();
    constexpr std::size_t block = 1024;
    std::vector<std::vector<Wish>> chosen((edges.size() + block - 1) / block);
    context.parallelFor(static_cast<int>(chosen.size()),
      [&](int begin, int end)
      {
        for (std::size_t i = begin; i < static_cast<std::size_t>(end); ++i)
        {
          const int* first = edges.data() + i * block;
          this->choose(first, first + std::min(block, edges.size() - i * block), chosen[i]);
        }
      });
    for (const std::vector<Wish>& some : chosen)
    {
      this->Wishes.insert(this->Wishes.end(), some.begin(), some.end());
    }
  }

  // Those of the edges that the edit stretches or bends.
  void choose(const int* begin, const int* end, std::vector<Wish>& chosen) const
  {
    const auto count = static_cast<std::size_t>(end - begin);
    std::vector<SurfacePoint> places;
    std::vector<Vector3> middles;
    std::vector<double> values(count * static_cast<std::size_t>(this->Channels));
    places.reserve(count);
    middles.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      places.push_back(this->middleOf(begin[i]));
      middles.push_back(positionOf(this->Rest.mesh(), places.back()));
      this->mixValues(places.back(), values.data() + i * static_cast<std::size_t>(this->Channels));
    }
    const std::vector<Vector3> moved = this->Moves(middles, values);
    constexpr double change = smallestChange * smallestChange;
    const double longest = longestEdge * this->Input.meanEdge;
    const auto squaredSag = [](const Vector3& a, const Vector3& b, const Vector3& middle)
    { return (middle - 0.5 * (a + b)).squaredNorm(); };
    for (std::size_t i = 0; i < count; ++i)
    {
      const Edge edge{ this->Area.origin(begin[i]), this->Area.target(begin[i]), begin[i] };
      const double length = this->squaredLength(edge.h);
      const bool stretched = length > longest * longest && length > change * this->squaredRestLength(edge.h);
      const double sag = squaredSag(this->Area.point(edge.a), this->Area.point(edge.b), moved[i]);
      const bool bent = sag > largestSag * largestSag * length &&
                        sag > change * squaredSag(this->AtRest[edge.a], this->AtRest[edge.b], middles[i]);
      if (stretched || bent)
      {
        chosen.push_back({ edge, length, places[i], moved[i] });
      }
    }
  }

  // The middle may lie on the line of another edge: a half of the face would have no area.
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

  // Longest first, one of a face: others of it may be swapped and so be well, or else wait for the next
  // round. To halve two at once leaves rows of vertices twice as close as the rows are apart. Returns the
  // faces that came of it, four of each.
  std::vector<int> split()
  {
    std::vector<std::pair<double, std::size_t>> order;
    order.reserve(this->Wishes.size());
    for (std::size_t i = 0; i < this->Wishes.size(); ++i)
    {
      order.emplace_back(-this->Wishes[i].squaredLength, i);
    }
    std::sort(order.begin(), order.end());
    std::vector<int> made;
    std::vector<Wish> later;
    for (const auto& [length, number] : order)
    {
      const Wish& wish = this->Wishes[number];
      const Edge& edge = wish.edge;
      const int h = this->Area.find(edge.a, edge.b, edge.h), g = h >= 0 ? this->Area.twin(h) : -1;
      if (g < 0 || this->Area.origin(previousHalfEdge(h)) == this->Area.origin(previousHalfEdge(g)))
      {
        continue; // swapped, or two faces upon each other
      }
      if (this->IsSplit[h / 3] || this->IsSplit[g / 3])
      {
        later.push_back(wish);
        continue;
      }
      if (this->hasFlatHalf(wish, h) || this->hasFlatHalf(wish, g) || !this->Taken.take(wish.position))
      {
        continue;
      }
      std::array<int, 4> neighbours;
      this->Area.halve(h, wish.place, wish.position, neighbours);
      this->AtRest.push_back(positionOf(this->Rest.mesh(), wish.place));
      const int count = this->Area.triangleCount();
      this->Touched.resize(static_cast<std::size_t>(count), 1);
      this->IsSplit.resize(static_cast<std::size_t>(count), 1);
      for (const int t : { h / 3, g / 3, count - 2, count - 1 })
      {
        this->Touched[t] = this->IsSplit[t] = 1;
        made.push_back(t);
      }
      for (const int spoke : { 3 * (h / 3), 3 * (h / 3) + 1, 3 * (g / 3), 3 * (g / 3) + 1 })
      {
        this->addEdge(spoke);
      }
    }
    for (const int t : made)
    {
      this->IsSplit[t] = 0;
    }
    this->Wishes = std::move(later);
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

  int flip(const std::vector<int>& split, bool all)
  {
    std::vector<int> queue;
    for (int t = 0; all && t < this->Area.triangleCount(); ++t)
    {
      this->Area.eachEdge(t, [&](int h) { queue.push_back(h); });
    }
    for (const int t : split)
    {
      queue.insert(queue.end(), { 3 * t, 3 * t + 1, 3 * t + 2 });
    }
    return flipByAngle(
      this->Area,
      queue,
      [this](int h)
      { return this->Touched[h / 3] && this->Touched[this->Area.twin(h) / 3] && this->liesWellAtRest(h); },
      [this](int h) { this->addEdge(h); });
  }

  const RetriangulateInput& Input;
  const Cutout& Cut;
  const Surface& Rest;
  const Movement& Moves;
  const std::vector<double>& Values;
  const int Channels;
  const std::vector<double> Sizes;
  Patch Area;
  std::vector<Vector3> AtRest; // of the patch's vertices
  TakenPlaces Taken;
  std::vector<char> Touched, IsSplit; // of its triangles: moved or split; split in this round
  std::vector<Edge> Fresh;            // that have not been looked at
  std::vector<Wish> Wishes;
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
    heldCurves(cutout, input, patch.keptSplits()),
    context);
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
  steps.each = 1.0 / (splitRounds + 4.0 * remeshRounds + 2.0);
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
  Relaxation relaxation(patch, context, true);
  for (int round = 0; round < remeshRounds; ++round)
  {
    counts.splits += splitAll(patch, longestEdge, steps);
    counts.collapses += collapseAll(patch, shortestEdge, longestEdge, steps);
    counts.flips += flipAll(patch, false, steps);
    relaxation.run();
    steps.next();
  }
  counts.flips += flipByAngle(patch, steps);
  counts.splits += splitAll(patch, longestEdge, steps);
  onCurves.insert(onCurves.end(), patch.keptSplits().begin(), patch.keptSplits().end());
  Retriangulated result = reassembled(
    input, cutout, rest, { mesh, touched, origins }, patch, heldCurves(cutout, input, onCurves), context);
  result.splits = counts.splits;
  result.collapses = counts.collapses;
  result.flips = counts.flips;
  return result;
}

} // namespace oversketch
