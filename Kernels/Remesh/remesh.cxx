#include "Remesh/remesh.h"

#include "Remesh/cutout.h"
#include "Remesh/passes.h"
#include "Remesh/relax.h"
#include "Remesh/sizing.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr double longest = 4.0 / 3.0;
constexpr double shortest = 4.0 / 5.0;

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
    context.each(outside,
      [&](int i)
      {
        const Triangle& c = this->Input.mesh.triangles[source[i]];
        mesh.triangles[i] = {
          this->OutputOfInput[c[0]], this->OutputOfInput[c[1]], this->OutputOfInput[c[2]]
        };
      });
    context.parallelFor(count,
      [&](int begin, int end)
      {
        for (int i = begin; i < end && (i % Steps::movesBetweenChecks != 0 || !context.cancelled()); ++i)
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
      corners = wholeTriangle(this->Cut.triangles[slot]);
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
  const std::vector<int> charts = valuesAt(input.charts, cutout.triangles);
  const std::vector<double> targets = valuesAt(input.targets, cutout.vertices);
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
  steps.mostTriangles = input.mostTriangles;
  for (int i = 0; i < input.iterations; ++i)
  {
    splitAll(patch, longest, steps);
    collapseAll(patch, shortest, longest, steps);
    flipAll(patch, false, steps);
    relaxation.run();
    steps.next();
  }
  flipAll(patch, true, steps);
  if (input.takeOutFolds)
  {
    unfold(patch, context);
  }
  return Assembly(input, active, cutout, surface, patch).run(context);
}

} // namespace oversketch
