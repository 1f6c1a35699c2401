#include "Remesh/reassemble.h"

#include "Mesh/context.h"
#include "Remesh/keep_apart.h"

#include <algorithm>
#include <map>
#include <utility>

namespace oversketch
{
namespace
{

using Between = std::map<std::pair<int, int>, int>;

std::pair<int, int> ends(int a, int b)
{
  return std::minmax(a, b);
}

// Adds what came between two vertices of a curve, without either, in their order.
void addBetween(const Between& between,
  const HeldVertex& a,
  const HeldVertex& b,
  std::vector<HeldVertex>& chain)
{
  const auto found = a.own >= 0 && b.own >= 0 ? between.find(ends(a.own, b.own)) : between.end();
  if (found == between.end())
  {
    return;
  }
  const HeldVertex middle{ -1, found->second, a.from, 0.5 * (a.t + b.t) };
  addBetween(between, a, middle, chain);
  chain.push_back(middle);
  addBetween(between, middle, b, chain);
}

class Reassembly
{
public:
  Reassembly(const RetriangulateInput& input,
    const Cutout& cutout,
    const Surface& rest,
    const Stage& stage,
    const Patch& patch,
    const Context& context)
    : Input(input)
    , Cut(cutout)
    , Rest(rest)
    , Base(stage)
    , Area(patch)
    , Caller(context)
    , Output(patch.vertexCount(), -1)
  {
  }

  Retriangulated run(const std::vector<std::vector<HeldVertex>>& curves)
  {
    this->addPoints();
    this->addTriangles();
    for (const std::vector<HeldVertex>& curve : curves)
    {
      std::vector<CurveVertex>& chain = this->Result.curves.emplace_back();
      for (const HeldVertex& v : curve)
      {
        chain.push_back({ v.own >= 0 ? this->Output[v.own] : this->OutputOfInput[v.whole], v.from, v.t });
      }
    }
    return std::move(this->Result);
  }

private:
  int cutVertices() const { return this->Cut.mesh.vertexCount(); }

  // One value of each, threaded.
  template <typename Value, typename Make>
  std::vector<Value> each(int count, const Make& make) const
  {
    std::vector<Value> values(static_cast<std::size_t>(count));
    this->Caller.each(count, [&](int i) { values[i] = make(i); });
    return values;
  }

  void addPoints()
  {
    const int count = this->Input.rest.vertexCount();
    const std::size_t most = this->Input.rest.points.size() + this->Area.vertexCount();
    this->Result.mesh.points.reserve(most);
    this->Result.pointSource.reserve(most);
    std::vector<Mix> mixes = this->each<Mix>(
      this->Area.vertexCount(), [this](int own) { return this->isStill(own) ? Mix() : this->mixOf(own); });
    this->OutputOfInput.assign(static_cast<std::size_t>(count), -1);
    for (int v = 0; v < count; ++v)
    {
      const int own = this->Cut.vertexOf[v];
      if (own < 0)
      {
        this->OutputOfInput[v] = this->addPoint(this->Input.moved[v], v);
      }
      else if (this->Area.aliveVertex(own))
      {
        const bool still = this->isStill(own);
        this->OutputOfInput[v] = this->Output[own] = this->addPoint(this->Area.point(own), still ? v : -1);
        if (!still)
        {
          this->Result.mixes.push_back(std::move(mixes[own]));
        }
      }
    }
    for (int own = this->cutVertices(); own < this->Area.vertexCount(); ++own)
    {
      if (this->Area.aliveVertex(own))
      {
        this->Output[own] = this->addPoint(this->Area.point(own), -1);
        this->Result.mixes.push_back(std::move(mixes[own]));
      }
    }
  }

  int addPoint(const Vector3& point, int source)
  {
    this->Result.mesh.points.push_back(point);
    this->Result.pointSource.push_back(source);
    return this->Result.mesh.vertexCount() - 1;
  }

  // Gone, or a vertex of the input where it was.
  bool isStill(int own) const
  {
    return !this->Area.aliveVertex(own) || (own < this->cutVertices() && this->isOfBase(own));
  }

  // Adds `share` of a vertex of the stage's mesh.
  void addOrigin(int base, double share, Mix& mix) const
  {
    if (base < this->cutVertices())
    {
      mix.emplace_back(this->Cut.vertices[base], share);
      return;
    }
    const SurfacePoint& at = this->Base.origins[base - this->cutVertices()];
    for (int k = 0; k < 3; ++k)
    {
      mix.emplace_back(this->Cut.vertices[this->Cut.mesh.triangles[at.triangle][k]], share * at.weights[k]);
    }
  }

  bool isOfBase(int own) const
  {
    return own < this->Base.mesh.vertexCount() && this->Area.point(own) == this->Base.mesh.points[own];
  }

  Mix mixOf(int own) const
  {
    Mix mix;
    mix.reserve(9);
    if (this->isOfBase(own))
    {
      this->addOrigin(own, 1.0, mix);
    }
    else
    {
      const SurfacePoint& at = this->Area.place(own);
      for (int k = 0; k < 3; ++k)
      {
        this->addOrigin(this->Base.mesh.triangles[at.triangle][k], at.weights[k], mix);
      }
    }
    return normalisedMix(std::move(mix));
  }

  // The place of a vertex of the stage's mesh in the cut-out.
  Vector3 baseAtRest(int base) const
  {
    return base < this->cutVertices()
             ? this->Cut.mesh.points[base]
             : positionOf(this->Cut.mesh, this->Base.origins[base - this->cutVertices()]);
  }

  void addTriangles()
  {
    const int count = this->Input.rest.triangleCount();
    std::vector<int> slots(static_cast<std::size_t>(count), -1);
    for (int slot = 0; slot < this->Cut.mesh.triangleCount(); ++slot)
    {
      slots[this->Cut.triangles[slot]] = slot;
    }
    const std::size_t most = this->Input.rest.triangles.size() + this->Area.triangleCount();
    this->Result.mesh.triangles.reserve(most);
    this->Result.triangleSource.reserve(most);
    const std::vector<int> sources = this->sourcesOfSlots();
    for (int t = 0; t < count; ++t)
    {
      if (slots[t] >= 0)
      {
        this->addSlot(slots[t], sources);
        continue;
      }
      const Triangle& c = this->Input.rest.triangles[t];
      this->addTriangle(
        { this->OutputOfInput[c[0]], this->OutputOfInput[c[1]], this->OutputOfInput[c[2]] }, t);
    }
    for (int slot = this->Cut.mesh.triangleCount(); slot < this->Area.triangleCount(); ++slot)
    {
      this->addSlot(slot, sources);
    }
  }

  bool isThere(int slot) const
  {
    const bool changes = slot >= this->Base.mesh.triangleCount() || this->Base.active[slot];
    return !changes || this->Area.aliveTriangle(slot);
  }

  void addSlot(int slot, const std::vector<int>& sources)
  {
    if (this->isThere(slot))
    {
      const Triangle c = this->Area.triangle(slot);
      this->addTriangle({ this->Output[c[0]], this->Output[c[1]], this->Output[c[2]] }, sources[slot]);
    }
  }

  void addTriangle(const Triangle& triangle, int source)
  {
    this->Result.mesh.triangles.push_back(triangle);
    this->Result.triangleSource.push_back(source);
  }

  std::vector<int> sourcesOfSlots() const
  {
    const std::vector<Vector3> base =
      this->each<Vector3>(this->Base.mesh.vertexCount(), [this](int v) { return this->baseAtRest(v); });
    const std::vector<Vector3> rests = this->each<Vector3>(this->Area.vertexCount(),
      [&](int own)
      {
        if (!this->Area.aliveVertex(own) || this->isOfBase(own))
        {
          return own < this->Base.mesh.vertexCount() ? base[own] : Vector3(Vector3::Zero());
        }
        const SurfacePoint& at = this->Area.place(own);
        const Triangle& c = this->Base.mesh.triangles[at.triangle];
        return Vector3(at.weights[0] * base[c[0]] + at.weights[1] * base[c[1]] + at.weights[2] * base[c[2]]);
      });
    return this->each<int>(this->Area.triangleCount(),
      [&](int slot)
      {
        const Triangle c = this->Area.triangle(slot);
        if (!this->isThere(slot))
        {
          return -1;
        }
        if (slot < this->Cut.mesh.triangleCount() && c == this->Cut.mesh.triangles[slot] &&
            this->isOfBase(c[0]) && this->isOfBase(c[1]) && this->isOfBase(c[2]))
        {
          return this->Cut.triangles[slot];
        }
        const Vector3 middle = (rests[c[0]] + rests[c[1]] + rests[c[2]]) / 3.0;
        return this->Cut.triangles[this->Rest.towards(middle, this->startNear(c[0]))];
      });
  }

  // A triangle of the cut-out at a vertex or near it.
  int startNear(int own) const
  {
    const int base = own < this->Base.mesh.vertexCount()
                       ? own
                       : this->Base.mesh.triangles[this->Area.place(own).triangle][0];
    return base < this->cutVertices() ? this->Rest.triangleWith({ base })
                                      : this->Base.origins[base - this->cutVertices()].triangle;
  }

  const RetriangulateInput& Input;
  const Cutout& Cut;
  const Surface& Rest;
  const Stage& Base;
  const Patch& Area;
  const Context& Caller;
  std::vector<int> Output;        // of a patch vertex
  std::vector<int> OutputOfInput; // of an input vertex
  Retriangulated Result;
};

} // namespace

Held heldIn(const Cutout& cutout, const RetriangulateInput& input)
{
  Held held;
  for (int own = 0; own < cutout.mesh.vertexCount(); ++own)
  {
    if (input.region[cutout.vertices[own]] != 2)
    {
      held.vertices.push_back(own);
    }
  }
  for (const std::vector<int>& curve : input.curves)
  {
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const int own = cutout.vertexOf[curve[i]], last = i > 0 ? cutout.vertexOf[curve[i - 1]] : -1;
      if (own >= 0)
      {
        held.vertices.push_back(own);
      }
      if (own >= 0 && last >= 0)
      {
        held.edges.push_back({ last, own });
      }
    }
  }
  return held;
}

std::vector<std::vector<HeldVertex>> heldCurves(const Cutout& cutout,
  const RetriangulateInput& input,
  const std::vector<std::array<int, 3>>& splits)
{
  Between between;
  for (const auto& [a, b, middle] : splits)
  {
    between.emplace(ends(a, b), middle);
  }
  std::vector<std::vector<HeldVertex>> curves;
  for (const std::vector<int>& curve : input.curves)
  {
    std::vector<HeldVertex>& chain = curves.emplace_back();
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      const HeldVertex next{ curve[i], cutout.vertexOf[curve[i]], static_cast<int>(i), 0.0 };
      if (i > 0)
      {
        HeldVertex end = next;
        end.t = 1.0;
        addBetween(between, HeldVertex(chain.back()), end, chain);
      }
      chain.push_back(next);
    }
  }
  return curves;
}

namespace
{

// Vertices that have met go apart, but those that the curves had; one that was of the input is none of it any
// more.
void part(Retriangulated& result, const RetriangulateInput& input)
{
  std::vector<char> free(input.region.size(), 0);
  std::transform(
    input.region.begin(), input.region.end(), free.begin(), [](char label) { return label == 2 ? 1 : 0; });
  for (const std::vector<int>& curve : input.curves)
  {
    for (const int v : curve)
    {
      free[v] = 0;
    }
  }
  const auto movable =
    mapped(result.pointSource, [&](int source) { return source < 0 ? char(2) : free[source]; });
  const std::vector<Vector3> before = result.mesh.points;
  keepApart(result.mesh, movable, input.asFloats);
  std::vector<Mix> mixes;
  auto mix = result.mixes.begin();
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    int& source = result.pointSource[v];
    if (source < 0)
    {
      mixes.push_back(std::move(*mix++));
    }
    else if (result.mesh.points[v] != before[v])
    {
      mixes.push_back({ { source, 1.0 } });
      source = -1;
    }
  }
  result.mixes = std::move(mixes);
}

} // namespace

Retriangulated reassembled(const RetriangulateInput& input,
  const Cutout& cutout,
  const Surface& rest,
  const Stage& stage,
  const Patch& patch,
  const std::vector<std::vector<HeldVertex>>& curves,
  const Context& context)
{
  Retriangulated result = Reassembly(input, cutout, rest, stage, patch, context).run(curves);
  part(result, input);
  return result;
}

Retriangulated untouched(const RetriangulateInput& input)
{
  Retriangulated result;
  result.mesh = { input.moved, input.rest.triangles };
  for (int v = 0; v < input.rest.vertexCount(); ++v)
  {
    result.pointSource.push_back(v);
  }
  for (int t = 0; t < input.rest.triangleCount(); ++t)
  {
    result.triangleSource.push_back(t);
  }
  for (const std::vector<int>& curve : input.curves)
  {
    std::vector<CurveVertex>& chain = result.curves.emplace_back();
    for (std::size_t i = 0; i < curve.size(); ++i)
    {
      chain.push_back({ curve[i], static_cast<int>(i), 0.0 });
    }
  }
  return result;
}

} // namespace oversketch
