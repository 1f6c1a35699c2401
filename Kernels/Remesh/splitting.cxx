#include "Remesh/splitting.h"

#include <algorithm>
#include <array>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double largestSag = 0.03; // of an edge's length
constexpr double smallestChange = 1.01;
constexpr double coincidence = 1e-6; // of two vertices, in mean edges
// Twice the area of a triangle over the sum of two squared sides: one that is not greater than this has none.
constexpr double flattest = 1e-6;

} // namespace

std::vector<double> sizesIn(const Cutout& cutout, const RetriangulateInput& input)
{
  return input.sizes.empty() ? std::vector<double>(cutout.vertices.size(), input.meanEdge)
                             : valuesAt(input.sizes, cutout.vertices);
}

Splitting::Splitting(const RetriangulateInput& input,
  const Cutout& cutout,
  const Surface& rest,
  const Held& held,
  const Motion& motion)
  : Cut(cutout)
  , Rest(rest)
  , Moves(motion)
  , Sizes(sizesIn(cutout, input))
  , Area(rest, cutout.active, Sizes, held.vertices, held.edges, false)
  , AtRest(cutout.mesh.points)
  , Taken(coincidence * input.meanEdge)
  , Touched(cutout.active.size(), 0)
  , IsSplit(cutout.active.size(), 0)
{
  this->Area.moveTo(valuesAt(input.moved, cutout.vertices));
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

void Splitting::run(Steps& steps, Retriangulated& counts)
{
  for (int round = 0; round < rounds; ++round)
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

SurfacePoint Splitting::middleOf(int h) const
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

void Splitting::mixValues(const SurfacePoint& at, double* values) const
{
  const Triangle& c = this->Cut.mesh.triangles[at.triangle];
  const auto valuesOf = [&](int corner)
  {
    return this->Moves.values.data() + static_cast<std::size_t>(this->Cut.vertices[c[corner]]) *
                                         static_cast<std::size_t>(this->Moves.channels);
  };
  const double *first = valuesOf(0), *second = valuesOf(1), *third = valuesOf(2);
  for (int i = 0; i < this->Moves.channels; ++i)
  {
    values[i] = at.weights[0] * first[i] + at.weights[1] * second[i] + at.weights[2] * third[i];
  }
}

void Splitting::lookAtEdges(const Context& context)
{
  std::vector<int> edges;
  edges.reserve(this->Fresh.size());
  for (const Edge& edge : this->Fresh)
  {
    const int h = this->Area.find(edge.a, edge.b, edge.h);
    if (h >= 0 && this->relativeSquared(h) > shortestEdge * shortestEdge)
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

void Splitting::choose(const int* begin, const int* end, std::vector<Wish>& chosen) const
{
  const auto count = static_cast<std::size_t>(end - begin);
  std::vector<SurfacePoint> places;
  std::vector<Vector3> middles;
  std::vector<double> values(count * static_cast<std::size_t>(this->Moves.channels));
  places.reserve(count);
  middles.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    places.push_back(this->middleOf(begin[i]));
    middles.push_back(positionOf(this->Rest.mesh(), places.back()));
    this->mixValues(places.back(), values.data() + i * static_cast<std::size_t>(this->Moves.channels));
  }
  const std::vector<Vector3> moved = this->Moves.movement(middles, values);
  constexpr double change = smallestChange * smallestChange;
  const auto squaredSag = [](const Vector3& a, const Vector3& b, const Vector3& middle)
  { return (middle - 0.5 * (a + b)).squaredNorm(); };
  for (std::size_t i = 0; i < count; ++i)
  {
    const Edge edge{ this->Area.origin(begin[i]), this->Area.target(begin[i]), begin[i] };
    const double length = this->squaredLength(edge.h);
    const bool stretched = this->relativeSquared(edge.h) > longestEdge * longestEdge &&
                           length > change * this->squaredRestLength(edge.h);
    const double sag = squaredSag(this->Area.point(edge.a), this->Area.point(edge.b), moved[i]);
    const bool bent = sag > largestSag * largestSag * length &&
                      sag > change * squaredSag(this->AtRest[edge.a], this->AtRest[edge.b], middles[i]);
    if (stretched || bent)
    {
      chosen.push_back({ edge, length, places[i], moved[i] });
    }
  }
}

bool Splitting::hasFlatHalf(const Wish& wish, int h) const
{
  const Vector3& apex = this->Area.point(this->Area.origin(previousHalfEdge(h)));
  const auto isFlat = [&](int v)
  {
    const Vector3 a = this->Area.point(v) - wish.position, b = apex - wish.position;
    return !(a.cross(b).norm() > flattest * (a.squaredNorm() + b.squaredNorm()));
  };
  return isFlat(this->Area.origin(h)) || isFlat(this->Area.target(h));
}

std::vector<int> Splitting::split()
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
    if (this->hasFlatHalf(wish, h) || this->hasFlatHalf(wish, g) ||
        this->Area.foldsHalved(h, wish.position) || !this->Taken.take(wish.position))
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

bool Splitting::liesWellAtRest(int h) const
{
  const int g = this->Area.twin(h);
  const Vector3 &a = this->AtRest[this->Area.origin(h)], &b = this->AtRest[this->Area.target(h)];
  const Vector3& c = this->AtRest[this->Area.origin(previousHalfEdge(h))];
  const Vector3& d = this->AtRest[this->Area.origin(previousHalfEdge(g))];
  const Vector3 whole = (b - a).cross(c - a) + (d - a).cross(b - a);
  return (d - a).cross(c - a).dot(whole) > 0.0 && (b - d).cross(c - d).dot(whole) > 0.0;
}

int Splitting::flip(const std::vector<int>& split, bool all)
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

} // namespace oversketch
