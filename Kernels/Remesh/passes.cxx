#include "Remesh/passes.h"

#include "Remesh/patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>
#include <vector>

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
  context.each(
    patch.triangleCount(), [&](int t) { patch.eachEdge(t, [&](int h) { found[h] = test(h) ? 1 : 0; }); });
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

// An end that must stay stays; else the one with the lower id, the older.
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

// In turn, as if each edge were looked at when its turn comes: what it was at the start, threaded, holds
// until a flip at one of the corners of its triangles.
int flipAll(Patch& patch, bool byAngle, Steps& steps)
{
  std::vector<char> open(3 * static_cast<std::size_t>(patch.triangleCount()), 0); // half-edges to look at
  for (const int h :
    edgesWhere(patch, steps.context, [&](int edge) { return patch.flippable(edge, byAngle); }))
  {
    open[h] = 1;
  }
  const auto reopen = [&](int t)
  {
    for (int h = 3 * t; h < 3 * t + 3; ++h)
    {
      open[h] = 1;
      if (patch.inner(h))
      {
        open[patch.twin(h)] = 1;
      }
    }
  };
  int made = 0;
  for (auto next = std::find(open.begin(), open.end(), 1); next != open.end();
       next = std::find(next + 1, open.end(), 1))
  {
    const int h = static_cast<int>(next - open.begin());
    if (patch.aliveTriangle(h / 3) && patch.twin(h) < h && patch.flippable(h, byAngle))
    {
      const Triangle one = patch.triangle(h / 3);
      const int opposite = patch.origin(previousHalfEdge(patch.twin(h)));
      patch.flip(h);
      for (const int v : { one[0], one[1], one[2], opposite })
      {
        patch.eachTriangleAt(v, reopen);
      }
      ++made;
    }
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

namespace
{

constexpr int unfoldingRounds = 20;
constexpr double unfoldedNarrowest = 0.0076; // sine squared of 5 degrees

class Unfolding
{
public:
  Unfolding(Patch& patch, const Context& context)
    : Area(patch)
    , Caller(context)
  {
  }

  void run()
  {
    for (int v = 0; v < this->Area.vertexCount(); ++v)
    {
      this->Points.push_back(this->Area.point(v));
    }
    for (int round = 0; round < unfoldingRounds; ++round)
    {
      const std::vector<int> vertices = this->atFolds();
      this->findFans(vertices);
      bool moved = false;
      for (const int v : vertices)
      {
        this->Caller.checkpoint(1.0);
        moved = this->improve(v) || moved;
      }
      if (!moved)
      {
        break;
      }
    }
    this->Area.moveTo(this->Points);
  }

private:
  Vector3 cross(int t) const
  {
    const Triangle c = this->Area.triangle(t);
    return (this->Points[c[1]] - this->Points[c[0]]).cross(this->Points[c[2]] - this->Points[c[0]]);
  }

  // The corners of all triangles at a folded edge, ascending.
  std::vector<int> atFolds() const
  {
    std::vector<Vector3> normals(this->Area.triangleCount());
    this->Caller.each(this->Area.triangleCount(),
      [&](int t) { normals[t] = this->Area.aliveTriangle(t) ? this->cross(t) : Vector3::Zero(); });
    std::vector<int> vertices;
    for (int h = 0; h < 3 * this->Area.triangleCount(); ++h)
    {
      if (this->Area.aliveTriangle(h / 3) && this->Area.inner(h) &&
          folded(normals[h / 3], normals[this->Area.twin(h) / 3]))
      {
        const Triangle c = this->Area.triangle(h / 3);
        vertices.insert(vertices.end(), c.begin(), c.end());
      }
    }
    sortUnique(vertices);
    return vertices;
  }

  // The triangles of the patch round each.
  void findFans(const std::vector<int>& vertices)
  {
    this->Fans.clear();
    for (const int v : vertices)
    {
      this->Fans[v];
    }
    for (int t = 0; !vertices.empty() && t < this->Area.triangleCount(); ++t)
    {
      for (const int v : this->Area.triangle(t))
      {
        const auto fan = this->Area.aliveTriangle(t) ? this->Fans.find(v) : this->Fans.end();
        if (fan != this->Fans.end())
        {
          fan->second.push_back(t);
        }
      }
    }
  }

  bool isFree(int v) const
  {
    const std::vector<int>& fan = this->Fans.at(v);
    return std::all_of(fan.begin(),
      fan.end(),
      [&](int t)
      {
        bool free = this->Area.chart(t) == this->Area.chart(fan[0]);
        for (int h = 3 * t; h < 3 * t + 3; ++h)
        {
          free = free && (this->Area.inner(h) || (this->Area.origin(h) != v && this->Area.target(h) != v));
        }
        return free;
      });
  }

  struct Fan
  {
    int folds = 0; // weights of all edges of its triangles
    double narrowest = 1.0;
  };
  Fan look(int v) const
  {
    Fan seen;
    for (const int t : this->Fans.at(v))
    {
      const Vector3 own = this->cross(t);
      const Triangle c = this->Area.triangle(t);
      seen.narrowest =
        std::min(seen.narrowest, narrowness(this->Points[c[0]], this->Points[c[1]], this->Points[c[2]], own));
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        seen.folds += this->Area.inner(h) ? foldWeight(own, this->cross(this->Area.twin(h) / 3)) : 0;
      }
    }
    return seen;
  }

  bool improve(int v)
  {
    const Fan before = this->look(v);
    if (before.folds == 0 || !this->isFree(v))
    {
      return false;
    }
    const Vector3 old = this->Points[v];
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (const int t : this->Fans.at(v))
    {
      for (const int corner : this->Area.triangle(t))
      {
        sum += corner == v ? Vector3(Vector3::Zero()) : this->Points[corner];
        count += corner != v;
      }
    }
    for (const double share : { 1.0, 0.5, 0.25 })
    {
      this->Points[v] = old + share * (sum / count - old);
      const Fan after = this->look(v);
      if (after.folds < before.folds && after.narrowest >= std::min(before.narrowest, unfoldedNarrowest))
      {
        return true;
      }
    }
    this->Points[v] = old;
    return false;
  }

  Patch& Area;
  const Context& Caller;
  std::vector<Vector3> Points;
  std::unordered_map<int, std::vector<int>> Fans;
};

} // namespace

void unfold(Patch& patch, const Context& context)
{
  Unfolding(patch, context).run();
}

} // namespace oversketch
