#include "Remesh/remesh.h"

#include "Remesh/cutout.h"
#include "Remesh/patch.h"
#include "Remesh/relax.h"
#include "Remesh/sizing.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double longest = 4.0 / 3.0;
constexpr double shortest = 4.0 / 5.0;
constexpr int movesBetweenChecks = 4096; // moves between two looks at whether to stop

struct Steps // the passes of one remeshing, for progress and cancelling
{
  const Context& context;
  double done = 0.0, each = 0.0;
  int moves = 0;

  void tick()
  {
    if (++this->moves % movesBetweenChecks == 0)
    {
      this->context.checkpoint(std::min(1.0, this->done));
    }
  }
  void next()
  {
    this->done += this->each;
    this->context.checkpoint(std::min(1.0, this->done));
  }
};

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

// Longest first, relative to the target.
void splitAll(Patch& patch, Steps& steps)
{
  const auto ratio = [&patch](int h)
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
      const int found = patch.find(edge.a, edge.b, edge.h);
      const int m = found >= 0 ? patch.split(found, neighbours) : -1;
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
}

// Shortest first. Of the two ends the one that must stay stays; else the one with the lower id, the older.
void collapseAll(Patch& patch, Steps& steps)
{
  const auto ratio = [&patch](int h)
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
        if (!patch.collapse(younger, longest))
        {
          patch.collapse(patch.twin(younger), longest);
        }
      }
      steps.tick();
    });
  steps.next();
}

void flipAll(Patch& patch, bool byAngle, Steps& steps)
{
  for (int t = 0; t < patch.triangleCount(); ++t)
  {
    patch.eachEdge(t, [&](int h) { patch.flip(h, byAngle); });
    steps.tick();
  }
  steps.next();
}

// The vertices a handle hangs on, each once.
std::vector<int> supportOf(const Binding& handle)
{
  std::vector<int> used;
  for (int k = 0; k < 3; ++k)
  {
    if (handle.weights[k] != 0.0 && std::find(used.begin(), used.end(), handle.vertices[k]) == used.end())
    {
      used.push_back(handle.vertices[k]);
    }
  }
  return used;
}

// Vertices and edges of the cut-out that carry handles.
void carriers(const std::vector<Binding>& handles,
  const Cutout& cutout,
  std::vector<int>& vertices,
  std::vector<std::array<int, 2>>& edges)
{
  for (const Binding& handle : handles)
  {
    std::vector<int> used = supportOf(handle);
    for (int& v : used)
    {
      v = cutout.vertexOf[v];
    }
    used.erase(std::remove(used.begin(), used.end(), -1), used.end());
    vertices.insert(vertices.end(), used.begin(), used.end());
    for (std::size_t i = 0; i < used.size(); ++i)
    {
      for (std::size_t j = i + 1; j < used.size(); ++j)
      {
        edges.push_back({ used[i], used[j] });
      }
    }
  }
}

bool isWhole(const SurfacePoint& at)
{
  return at.weights[0] == 1.0 || at.weights[1] == 1.0 || at.weights[2] == 1.0;
}

// Puts the patch back into the mesh that it was cut out of.
class Assembly
{
public:
  Assembly(const RemeshInput& input,
    const std::vector<char>& active,
    const Cutout& cutout,
    const Surface& surface,
    const Patch& patch)
    : Input(input)
    , Active(active)
    , Cut(cutout)
    , Original(surface)
    , Area(patch)
  {
  }

  RemeshResult run(const Context& context)
  {
    this->addPoints();
    this->addTriangles(context);
    this->rebind();
    return std::move(this->Result);
  }

private:
  void addPoints()
  {
    const std::size_t most = this->Input.mesh.points.size() + this->Area.vertexCount();
    this->Result.mesh.points.reserve(most);
    this->Result.pointSource.reserve(most);
    this->OutputOfInput.assign(this->Input.mesh.points.size(), -1);
    this->Output.assign(this->Area.vertexCount(), -1);
    for (const bool region : { false, true })
    {
      for (int v = 0; v < this->Input.mesh.vertexCount(); ++v)
      {
        if ((this->Input.region[v] != 0) == region)
        {
          this->addInputPoint(v);
        }
      }
      this->Result.outsidePoints = region ? this->Result.outsidePoints : this->Result.mesh.vertexCount();
    }
    // New ones as the triangles meet them.
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      for (int h = 3 * t; this->Area.aliveTriangle(t) && h < 3 * t + 3; ++h)
      {
        const int v = this->Area.origin(h);
        if (this->Output[v] < 0)
        {
          this->Output[v] = this->addPoint(this->Area.point(v), -1);
          this->Result.places.push_back(this->inInput(this->Area.place(v)));
        }
      }
    }
  }

  void addInputPoint(int v)
  {
    const Vector3& old = this->Input.mesh.points[v];
    const int own = this->Cut.vertexOf[v];
    SurfacePoint at;
    if (own < 0)
    {
      this->OutputOfInput[v] = this->addPoint(old, v);
    }
    else if (this->Area.aliveVertex(own))
    {
      at = this->Area.place(own);
      // A vertex that came to lie on another one's old place is not that one: fixed places never move.
      const bool still = at.triangle < 0 || (isWhole(at) && this->Area.point(own) == old);
      this->OutputOfInput[v] = this->Output[own] = this->addPoint(this->Area.point(own), still ? v : -1);
    }
    if (this->Input.region[v] && this->OutputOfInput[v] >= 0)
    {
      this->Result.places.push_back(this->inInput(at));
    }
  }

  int addPoint(const Vector3& point, int source)
  {
    this->Result.mesh.points.push_back(point);
    this->Result.pointSource.push_back(source);
    return this->Result.mesh.vertexCount() - 1;
  }

  SurfacePoint inInput(SurfacePoint at) const
  {
    at.triangle = at.triangle < 0 ? -1 : this->Cut.triangles[at.triangle];
    return at;
  }

  void addTriangles(const Context& context)
  {
    Mesh& mesh = this->Result.mesh;
    std::vector<int>& source = this->Result.triangleSource;
    const std::size_t all = this->Input.mesh.triangles.size();
    const auto changed = static_cast<std::size_t>(std::count(this->Active.begin(), this->Active.end(), 1));
    std::vector<int> order;
    for (int t = 0; t < this->Area.triangleCount(); ++t)
    {
      if (this->Area.aliveTriangle(t))
      {
        order.push_back(t);
      }
    }
    const int count = static_cast<int>(order.size()), outside = static_cast<int>(all - changed);
    this->Result.outsideTriangles = outside;
    source.reserve(outside + order.size());
    for (std::size_t t = 0; t < all; ++t)
    {
      if (!this->Active[t])
      {
        source.push_back(static_cast<int>(t));
      }
    }
    source.resize(outside + order.size());
    mesh.triangles.resize(outside + order.size());
    this->Result.insideCorners.resize(order.size());
    context.parallelFor(outside,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          const Triangle& c = this->Input.mesh.triangles[source[i]];
          mesh.triangles[i] = {
            this->OutputOfInput[c[0]], this->OutputOfInput[c[1]], this->OutputOfInput[c[2]]
          };
        }
      });
    context.parallelFor(count,
      [&](int begin, int end)
      {
        for (int i = begin; i < end && (i % movesBetweenChecks != 0 || !context.cancelled()); ++i)
        {
          const Triangle t = this->Area.triangle(order[i]);
          mesh.triangles[outside + i] = { this->Output[t[0]], this->Output[t[1]], this->Output[t[2]] };
          this->findSource(order[i], outside + i);
        }
      });
    context.checkpoint(1.0);
  }

  void findSource(int slot, int i)
  {
    const Triangle t = this->Area.triangle(slot);
    std::array<SurfacePoint, 3>& corners = this->Result.insideCorners[i - this->Result.outsideTriangles];
    const auto still = [this](int v) { return this->Result.pointSource[this->Output[v]] >= 0; };
    if (slot < this->Cut.mesh.triangleCount() && t == this->Cut.mesh.triangles[slot] && still(t[0]) &&
        still(t[1]) && still(t[2]))
    {
      this->Result.triangleSource[i] = this->Cut.triangles[slot];
      corners = RemeshResult::wholeTriangle(this->Cut.triangles[slot]);
      return;
    }
    const Vector3 middle = (this->Area.point(t[0]) + this->Area.point(t[1]) + this->Area.point(t[2])) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Original.inChart(this->Area.place(t[k]), this->Area.chart(slot), middle);
    }
    const int source = this->Original.closest(middle, corners[0].triangle).triangle;
    this->Result.triangleSource[i] = this->Cut.triangles[source];
    for (SurfacePoint& corner : corners)
    {
      corner = this->inInput(corner);
    }
  }

  // As it was where its vertex, edge or triangle is still there; else to the nearest place, walking from
  // where one of its vertices went.
  void rebind()
  {
    if (this->Input.handles.empty())
    {
      return;
    }
    const Surface now(this->Result.mesh);
    for (const Binding& handle : this->Input.handles)
    {
      std::vector<int> support = supportOf(handle);
      bool kept = true;
      for (int& v : support)
      {
        const int output = this->OutputOfInput[v];
        kept = kept && output >= 0 && this->Result.pointSource[output] == v;
        int own = this->Cut.vertexOf[v];
        while (output < 0 && !this->Area.aliveVertex(own))
        {
          own = this->Area.mergedInto(own);
        }
        v = output >= 0 ? output : this->Output[own];
      }
      Binding bound = handle;
      if (kept && (support.size() == 1 || now.triangleWith(support) >= 0))
      {
        for (int k = 0; k < 3; ++k)
        {
          // Vertices without weight may be gone.
          const int v = this->OutputOfInput[handle.vertices[k]];
          bound.vertices[k] = handle.weights[k] != 0.0 ? v : support[0];
        }
      }
      else
      {
        const int start = now.triangleWith({ support[0] });
        bound = start < 0 ? Binding::vertex(support[0])
                          : this->bindingOf(now.closest(handle.of(this->Input.mesh.points), start));
      }
      this->Result.handles.push_back(bound);
    }
  }

  Binding bindingOf(const SurfacePoint& at) const
  {
    const Triangle& t = this->Result.mesh.triangles[at.triangle];
    Binding bound;
    int count = 0;
    for (int k = 0; k < 3; ++k)
    {
      if (at.weights[k] != 0.0)
      {
        bound.vertices[count] = t[k];
        bound.weights[count++] = at.weights[k];
      }
    }
    for (; count < 3; ++count)
    {
      bound.vertices[count] = bound.vertices[0];
    }
    return bound;
  }

  const RemeshInput& Input;
  const std::vector<char>& Active;
  const Cutout& Cut;
  const Surface& Original;
  const Patch& Area;
  std::vector<int> Output;        // of a patch vertex
  std::vector<int> OutputOfInput; // of an input vertex
  RemeshResult Result;
};

} // namespace

RemeshResult remesh(const RemeshInput& input, const Context& context)
{
  const std::vector<char> active = regionTriangles(input.mesh, input.region);
  const Cutout cutout(input.mesh, active);
  const std::vector<int> charts = Cutout::taken(input.charts, cutout.triangles);
  const std::vector<double> targets = Cutout::taken(input.targets, cutout.vertices);
  const Surface surface(cutout.mesh, cutout.active, charts);
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;
  if (input.protectHandles)
  {
    carriers(input.handles, cutout, vertices, edges);
  }
  Patch patch(surface, cutout.active, targets, vertices, edges, input.keepSmooth);
  Relaxation relaxation(patch, context);
  Steps steps{ context };
  steps.each = 1.0 / (input.iterations * 4.0 + 1.0);
  for (int i = 0; i < input.iterations; ++i)
  {
    splitAll(patch, steps);
    collapseAll(patch, steps);
    flipAll(patch, false, steps);
    relaxation.run();
    steps.next();
  }
  flipAll(patch, true, steps);
  return Assembly(input, active, cutout, surface, patch).run(context);
}

} // namespace oversketch
