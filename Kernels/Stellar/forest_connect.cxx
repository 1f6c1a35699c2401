#include "Stellar/forest.h"

#include "Mesh/context.h"

#include <algorithm>
#include <atomic>

namespace oversketch
{

namespace
{

// An edge of one face, kept with the lower of its points: where it goes to, and which corner of the face is
// opposite, 4 face + corner, or the complement of that where it runs from the higher point to the lower.
struct Edge
{
  int to, opposite;

  int place() const { return this->opposite < 0 ? ~this->opposite : this->opposite; }
  int face() const { return this->place() >> 2; }
  int corner() const { return this->place() & 3; }
  bool runsAs(const Edge& other) const { return (this->opposite < 0) == (other.opposite < 0); }
};

// All edges by their lower points: those of point v from first[v] to first[v + 1].
struct Edges
{
  std::vector<int> first;
  std::vector<Edge> all;
};

Edges edgesOf(const Forest& forest)
{
  const int points = static_cast<int>(forest.vertices.size()), faces = static_cast<int>(forest.faces.size());
  Edges edges;
  std::vector<int>& first = edges.first;
  first.assign(points + 2, 0); // one place too far on until all are in
  for (const Forest::Face& face : forest.faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      ++first[std::min(face.v[(i + 1) % 3], face.v[(i + 2) % 3]) + 2];
    }
  }
  for (int v = 0; v < points; ++v)
  {
    first[v + 2] += first[v + 1];
  }
  edges.all.resize(3 * forest.faces.size());
  for (int f = 0; f < faces; ++f)
  {
    const int* v = forest.faces[f].v;
    for (int i = 0; i < 3; ++i)
    {
      const int from = v[(i + 1) % 3], to = v[(i + 2) % 3], opposite = 4 * f + i;
      edges.all[first[std::min(from, to) + 1]++] = { std::max(from, to), from < to ? opposite : ~opposite };
    }
  }
  return edges;
}

// Findings at the edges of some points.
struct Found
{
  bool open = false; // an edge of one face
  bool bad = false;  // one that is there twice in one direction
};

// Tells the faces at a point's edges of each other; puts the two edges of each pair side by side.
void pairUp(Forest& forest, Edge* edge, Edge* const end, Found& found)
{
  const bool sorted = end - edge > 32; // of a hub: an edge is looked for among its like only
  if (sorted)
  {
    std::sort(edge, end, [](const Edge& a, const Edge& b) { return a.to < b.to; });
  }
  while (edge != end)
  {
    Edge* twin = nullptr;
    for (Edge* other = edge + 1; other != end && (!sorted || other->to == edge->to); ++other)
    {
      if (other->to == edge->to)
      {
        found.bad = found.bad || twin || other->runsAs(*edge);
        twin = other;
      }
    }
    forest.faces[edge->face()].n[edge->corner()] = twin ? twin->face() : -1;
    found.open = found.open || !twin;
    if (twin)
    {
      forest.faces[twin->face()].n[twin->corner()] = edge->face();
      std::swap(*twin, *++edge);
    }
    ++edge;
  }
}

} // namespace

void Forest::connect(const Context& context)
{
  const int points = static_cast<int>(this->vertices.size()), count = static_cast<int>(this->faces.size());
  for (int f = 0; f < count; ++f)
  {
    for (int v : this->faces[f].v)
    {
      this->vertices[v].face = f;
    }
  }
  Edges edges = edgesOf(*this);
  const auto of = [&](int v) { return edges.all.data() + edges.first[v]; };
  std::atomic<int> bad{ points }; // the lowest point with such an edge
  std::atomic<bool> bounded{ false };
  context.parallelFor(points,
    [&](int begin, int end)
    {
      Found found;
      int v = begin;
      for (; v < end && !found.bad; ++v)
      {
        pairUp(*this, of(v), of(v + 1), found);
      }
      if (found.open)
      {
        bounded = true;
      }
      for (int known = bad; found.bad && v - 1 < known && !bad.compare_exchange_weak(known, v - 1);)
      {
      }
    });
  if (bad < points)
  {
    const auto twice = [&](const Edge& edge)
    {
      return std::count_if(of(bad),
               of(bad + 1),
               [&](const Edge& other) { return other.to == edge.to && other.runsAs(edge); }) > 1;
    };
    throw Error(Failure::BadMesh,
      "The edge of points %1 and %2 belongs to two triangles that run the same way along it",
      bad,
      std::find_if(of(bad), of(bad + 1), twice)->to);
  }
  this->closed = !bounded;
}

} // namespace oversketch
