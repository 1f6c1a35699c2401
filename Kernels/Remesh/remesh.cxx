#include "Remesh/remesh.h"

#include "Remesh/patch.h"
#include "Remesh/sizing.h"

#include <algorithm>
#include <queue>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double longest = 4.0 / 3.0;
constexpr double shortest = 4.0 / 5.0;
constexpr int checkEvery = 4096; // moves between two looks at whether to stop

struct Steps // the passes of one remeshing, for progress and cancelling
{
  const Context& context;
  double done = 0.0, each = 0.0;
  int moves = 0;

  void tick()
  {
    if (++this->moves % checkEvery == 0)
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

// Longest first, relative to the target; ties by vertex ids.
void splitAll(Patch& patch, Steps& steps)
{
  using Entry = std::tuple<double, int, int>;
  const auto later = [](const Entry& a, const Entry& b)
  {
    return std::get<0>(a) != std::get<0>(b)
             ? std::get<0>(a) < std::get<0>(b)
             : std::tie(std::get<1>(a), std::get<2>(a)) > std::tie(std::get<1>(b), std::get<2>(b));
  };
  std::priority_queue<Entry, std::vector<Entry>, decltype(later)> queue(later);
  const auto consider = [&](int a, int b)
  {
    const double length = patch.relativeLength(a, b);
    if (length > longest)
    {
      queue.push({ length, std::min(a, b), std::max(a, b) });
    }
  };
  for (const std::array<int, 2>& e : patch.edges())
  {
    consider(e[0], e[1]);
  }
  while (!queue.empty())
  {
    const auto [length, a, b] = queue.top();
    queue.pop();
    std::array<int, 4> neighbours;
    const int m = patch.split(a, b, neighbours);
    for (int i = 0; m >= 0 && i < 4; ++i)
    {
      if (neighbours[i] >= 0)
      {
        consider(m, neighbours[i]);
      }
    }
    steps.tick();
  }
  steps.next();
}

// Shortest first. Of the two ends the one that must stay stays; else the one with the lower id, the older.
void collapseAll(Patch& patch, Steps& steps)
{
  std::vector<std::tuple<double, int, int>> short_;
  for (const std::array<int, 2>& e : patch.edges())
  {
    const double length = patch.relativeLength(e[0], e[1]);
    if (length < shortest)
    {
      short_.emplace_back(length, e[0], e[1]);
    }
  }
  std::sort(short_.begin(), short_.end());
  for (const auto& [length, a, b] : short_)
  {
    if (patch.aliveVertex(a) && patch.aliveVertex(b) && !patch.collapse(b, a, longest))
    {
      patch.collapse(a, b, longest);
    }
    steps.tick();
  }
  steps.next();
}

void flipAll(Patch& patch, bool byAngle, Steps& steps)
{
  for (const std::array<int, 2>& e : patch.edges())
  {
    patch.flip(e[0], e[1], byAngle);
    steps.tick();
  }
  steps.next();
}

void relaxAll(Patch& patch, Steps& steps)
{
  const int count = patch.vertexCount();
  std::vector<SurfacePoint> wanted(count);
  steps.context.parallelFor(count,
    [&](int begin, int end)
    {
      for (int v = begin; v < end && !steps.context.cancelled(); ++v)
      {
        if (patch.aliveVertex(v) && !patch.fixed(v))
        {
          wanted[v] = patch.relaxed(v);
        }
      }
    });
  steps.next();
  for (int v = 0; v < count; ++v)
  {
    if (patch.aliveVertex(v) && !patch.fixed(v))
    {
      patch.move(v, wanted[v]);
      steps.tick();
    }
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

// Vertices and edges that carry handles.
void carriers(const std::vector<Binding>& handles,
  std::vector<int>& vertices,
  std::vector<std::array<int, 2>>& edges)
{
  for (const Binding& handle : handles)
  {
    const std::vector<int> used = supportOf(handle);
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

class Assembly
{
public:
  Assembly(const RemeshInput& input,
    const std::vector<char>& active,
    const Surface& surface,
    const Patch& patch)
    : input_(input)
    , active_(active)
    , surface_(surface)
    , patch_(patch)
  {
  }

  RemeshResult run(const Context& context)
  {
    this->addPoints();
    this->addTriangles(context);
    this->rebind();
    return std::move(this->result_);
  }

private:
  void addPoints()
  {
    const int inputCount = this->input_.mesh.vertexCount();
    this->output_.assign(this->patch_.vertexCount(), -1);
    for (const bool region : { false, true })
    {
      for (int v = 0; v < inputCount; ++v)
      {
        if ((this->input_.region[v] != 0) == region && this->patch_.aliveVertex(v))
        {
          this->addPoint(v);
        }
      }
    }
    for (int v = inputCount; v < this->patch_.vertexCount(); ++v)
    {
      if (this->patch_.aliveVertex(v))
      {
        this->addPoint(v);
      }
    }
  }

  void addPoint(int v)
  {
    const SurfacePoint& at = this->patch_.place(v);
    const bool input = v < this->input_.mesh.vertexCount();
    // A vertex that came to lie on another one's old place is not that one: fixed places never move.
    const bool still =
      input && (at.triangle < 0 || (isWhole(at) && this->patch_.point(v) == this->input_.mesh.points[v]));
    this->output_[v] = this->result_.mesh.vertexCount();
    this->result_.mesh.points.push_back(this->patch_.point(v));
    this->result_.pointSource.push_back(still ? v : -1);
    this->result_.places.push_back(at);
  }

  void addTriangles(const Context& context)
  {
    std::vector<int> order;
    for (int t = 0; t < this->input_.mesh.triangleCount(); ++t)
    {
      if (!this->active_[t])
      {
        order.push_back(t);
      }
    }
    for (int t = 0; t < this->patch_.triangleCount(); ++t)
    {
      if (this->patch_.aliveTriangle(t))
      {
        order.push_back(t);
      }
    }
    const int count = static_cast<int>(order.size());
    Mesh& mesh = this->result_.mesh;
    mesh.triangles.resize(count);
    this->result_.triangleSource.resize(count);
    this->result_.corners.resize(count);
    context.parallelFor(count,
      [&](int begin, int end)
      {
        for (int i = begin; i < end && !context.cancelled(); ++i)
        {
          const Triangle& t = this->patch_.triangle(order[i]);
          mesh.triangles[i] = { this->output_[t[0]], this->output_[t[1]], this->output_[t[2]] };
          this->findSource(order[i], i);
        }
      });
    context.checkpoint(1.0);
  }

  void findSource(int slot, int i)
  {
    const Triangle& t = this->patch_.triangle(slot);
    std::array<SurfacePoint, 3>& corners = this->result_.corners[i];
    const auto still = [this](int v) { return this->result_.pointSource[this->output_[v]] == v; };
    if (slot < this->input_.mesh.triangleCount() && t == this->input_.mesh.triangles[slot] && still(t[0]) &&
        still(t[1]) && still(t[2]))
    {
      this->result_.triangleSource[i] = slot;
      corners = { { { slot, { 1.0, 0.0, 0.0 } }, { slot, { 0.0, 1.0, 0.0 } }, { slot, { 0.0, 0.0, 1.0 } } } };
      return;
    }
    const Vector3 middle =
      (this->patch_.point(t[0]) + this->patch_.point(t[1]) + this->patch_.point(t[2])) / 3.0;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->surface_.inChart(this->patch_.place(t[k]), this->patch_.chart(slot), middle);
    }
    this->result_.triangleSource[i] = this->surface_.closest(middle, corners[0].triangle).triangle;
  }

  // As it was where its vertex, edge or triangle is still there; else to the nearest place, walking from
  // where one of its vertices went.
  void rebind()
  {
    const std::vector<int> oneChart;
    const std::vector<char> all(this->result_.mesh.triangles.size(), 1);
    const Surface now(this->result_.mesh, all, oneChart);
    for (const Binding& handle : this->input_.handles)
    {
      std::vector<int> support = supportOf(handle);
      bool kept = true;
      for (int& v : support)
      {
        kept = kept && this->patch_.aliveVertex(v) && this->result_.pointSource[this->output_[v]] == v;
        while (!this->patch_.aliveVertex(v))
        {
          v = this->patch_.mergedInto(v);
        }
        v = this->output_[v];
      }
      Binding bound = handle;
      if (kept && (support.size() == 1 || now.triangleWith(support) >= 0))
      {
        for (int k = 0; k < 3; ++k)
        {
          bound.vertices[k] = this->output_[handle.vertices[k]];
        }
      }
      else
      {
        const int start = now.triangleWith({ support[0] });
        bound = start < 0 ? Binding::vertex(support[0])
                          : this->bindingOf(now.closest(handle.of(this->input_.mesh.points), start));
      }
      this->result_.handles.push_back(bound);
    }
  }

  Binding bindingOf(const SurfacePoint& at) const
  {
    const Triangle& t = this->result_.mesh.triangles[at.triangle];
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

  const RemeshInput& input_;
  const std::vector<char>& active_;
  const Surface& surface_;
  const Patch& patch_;
  std::vector<int> output_; // of a patch vertex
  RemeshResult result_;
};

} // namespace

RemeshResult remesh(const RemeshInput& input, const Context& context)
{
  const std::vector<char> active = regionTriangles(input.mesh, input.region);
  const Surface surface(input.mesh, active, input.charts);
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;
  if (input.protectHandles)
  {
    carriers(input.handles, vertices, edges);
  }
  Patch patch(surface, active, input.targets, vertices, edges);
  Steps steps{ context };
  steps.each = 1.0 / (input.iterations * 5.0 + 1.0);
  for (int i = 0; i < input.iterations; ++i)
  {
    splitAll(patch, steps);
    collapseAll(patch, steps);
    flipAll(patch, false, steps);
    relaxAll(patch, steps);
  }
  flipAll(patch, true, steps);
  return Assembly(input, active, surface, patch).run(context);
}

} // namespace oversketch
