#include "Remesh/passes.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

struct Candidate
{
  int a, b, h; // an edge, and a half-edge of it, from a to b, at the time
};

// Edges by how far they are from being right, in steps of a fourth root of 2; within a step as they lie in
// memory: several times quicker than strictly in turn, since neighbours come one after the other and what
// splits add lies beside each other too.
class Ranks
{
public:
  // ratio: squared; how many times too long or too short.
  void add(const Patch& patch, int h, double ratio)
  {
    const int rank = std::clamp(std::ilogb(ratio * ratio), 0, this->Highest);
    this->Edges[rank].push_back({ patch.origin(h), patch.target(h), h });
  }

  // Calls visit(edge) from the highest rank down; it may add others.
  template <typename Visit>
  void run(Visit&& visit)
  {
    for (; this->Highest >= 0; --this->Highest)
    {
      // NOLINTNEXTLINE(modernize-loop-convert): visit may lengthen this very list
      for (std::size_t i = 0; i < this->Edges[this->Highest].size(); ++i)
      {
        visit(Candidate(this->Edges[this->Highest][i]));
      }
    }
  }

private:
  int Highest = 15;
  std::array<std::vector<Candidate>, 16> Edges;
};

// The edges of the patch, by one half-edge each, for which test(h) is true; as they lie in memory. Threaded.
template <typename Test>
std::vector<int> edgesWhere(const Patch& patch, const Context& context, Test&& test)
{
  std::vector<char> found(3 * static_cast<std::size_t>(patch.triangleCount()), 0);
  context.parallelFor(patch.triangleCount(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        patch.eachEdge(t, [&](int h) { found[h] = test(h) ? 1 : 0; });
      }
    });
  std::vector<int> edges;
  for (auto next = std::find(found.begin(), found.end(), 1); next != found.end();
       next = std::find(next + 1, found.end(), 1))
  {
    edges.push_back(static_cast<int>(next - found.begin()));
  }
  return edges;
}

} // namespace

int splitAll(Patch& patch, double longest, Steps& steps)
{
  int made = 0;
  const auto ratio = [&](int h)
  { return patch.relativeSquared(patch.origin(h), patch.target(h)) / (longest * longest); };
  const auto tooLong = [&](int h) { return patch.splittable(h) && ratio(h) > 1.0; };
  Ranks ranks;
  for (const int h : edgesWhere(patch, steps.context, tooLong))
  {
    ranks.add(patch, h, ratio(h));
  }
  ranks.run(
    [&](const Candidate& edge)
    {
      std::array<int, 4> neighbours;
      const int found = patch.triangleCount() < steps.mostTriangles ? patch.find(edge.a, edge.b, edge.h) : -1;
      const int m = found >= 0 ? patch.split(found, neighbours) : -1;
      made += m >= 0 ? 1 : 0;
      for (int i = 0; m >= 0 && i < 4; ++i)
      {
        const int h = neighbours[i] >= 0 ? patch.find(m, neighbours[i]) : -1;
        if (h >= 0 && tooLong(h))
        {
          ranks.add(patch, h, ratio(h));
        }
      }
      steps.tick();
    });
  steps.next();
  return made;
}

// Of the two ends the one that must stay stays; else the one with the lower id, the older.
int collapseAll(Patch& patch, double shortest, double longest, Steps& steps)
{
  int made = 0;
  const auto ratio = [&](int h)
  { return shortest * shortest / patch.relativeSquared(patch.origin(h), patch.target(h)); };
  const auto tooShort = [&](int h)
  {
    return patch.inner(h) && ratio(h) > 1.0 &&
           !(patch.fixed(patch.origin(h)) && patch.fixed(patch.target(h)));
  };
  Ranks ranks;
  for (const int h : edgesWhere(patch, steps.context, tooShort))
  {
    ranks.add(patch, h, ratio(h));
  }
  ranks.run(
    [&](const Candidate& edge)
    {
      const bool alive = patch.aliveVertex(edge.a) && patch.aliveVertex(edge.b);
      const int h = alive ? patch.find(edge.a, edge.b, edge.h) : -1;
      if (h >= 0 && patch.inner(h))
      {
        const int younger = edge.a > edge.b ? h : patch.twin(h);
        const int other = patch.twin(younger);
        made += patch.collapse(younger, longest) || patch.collapse(other, longest) ? 1 : 0;
      }
      steps.tick();
    });
  steps.next();
  return made;
}

int flipAll(Patch& patch, bool byAngle, Steps& steps)
{
  int made = 0;
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    patch.eachEdge(t, [&](int h) { made += patch.flip(h, byAngle) ? 1 : 0; });
    steps.tick();
  }
  steps.next();
  return made;
}

int flipByAngle(Patch& patch, Steps& steps)
{
  std::vector<int> queue = edgesWhere(patch, steps.context, [&](int h) { return patch.inner(h); });
  const int made = flipByAngle(
    patch, queue, [](int) { return true; }, [&](int) { steps.tick(); });
  steps.next();
  return made;
}

} // namespace oversketch
