#include "Ray/known_diameters.h"

#include "Mesh/match.h"
#include "Ray/ray_starts.h"

#include <iterator>
#include <numeric>
#include <utility>

namespace oversketch
{

namespace
{

constexpr int raysBetweenChecks = 1 << 18; // a cancel waits for one at most
constexpr int fewFacets = 4; // a part of all: so few changed ones are tried by rays on them alone

// The facets that one of two meshes has and the other has not.
Mesh changedFacets(const Mesh& before, const Mesh& now, const MeshMatch& match)
{
  Mesh changed;
  changed.triangles.reserve(match.removed.size() + match.added.size());
  const auto add = [&](const Mesh& mesh, const std::vector<int>& facets)
  {
    std::vector<int> number(mesh.points.size(), -1);
    for (const int t : facets)
    {
      Triangle corners;
      for (int k = 0; k < 3; ++k)
      {
        int& id = number[mesh.triangles[t][k]];
        if (id < 0)
        {
          id = changed.vertexCount();
          changed.points.push_back(mesh.points[mesh.triangles[t][k]]);
        }
        corners[k] = id;
      }
      changed.triangles.push_back(corners);
    }
  };
  add(before, match.removed);
  add(now, match.added);
  return changed;
}

// Takes over values of the mesh before.
class Successor
{
public:
  Successor(const KnownDiameters& known,
    const Mesh& mesh,
    const RayScene& scene,
    const std::vector<Vector3>& normals,
    const std::vector<Vector3>& sides,
    const Context& context)
    : Known(known)
    , Model(mesh)
    , Scene(scene)
    , Normals(normals)
    , Sides(sides)
    , Caller(context)
    , Cone(coneDirections(known.options.rayCount, known.options.coneAngle))
    , Match(matchMeshes(*known.mesh, *known.normals, mesh, normals, context))
  {
  }

  // Takes over what still holds.
  TakenOver takeOver(const MakeCaster& makeCaster, ConeMeasures& result) const
  {
    TakenOver taken{
      std::vector<char>(this->Model.points.size(), 0), std::vector<int>(this->Model.points.size(), -1), {}
    };
    std::vector<char>& kept = taken.kept;
    this->Caller.each(this->Model.vertexCount(),
      [&](int v)
      {
        const int before = this->Match.vertices[v];
        kept[v] =
          before >= 0 && this->Normals[v].squaredNorm() > 0.0 && this->Sides[v] == this->Known.sides[before];
      });
    std::vector<int> vertices;
    std::copy_if(this->Scene.order.begin(),
      this->Scene.order.end(),
      std::back_inserter(vertices),
      [&kept](int v) { return kept[v]; });
    Mesh changed = changedFacets(*this->Known.mesh, this->Model, this->Match);
    this->dropCones(changed, vertices, kept);
    this->dropRays(std::move(changed), vertices, makeCaster, taken);
    this->Caller.each(this->Model.vertexCount(),
      [&](int v)
      {
        if (kept[v])
        {
          const int before = this->Match.vertices[v];
          result.diameter[v] = this->Known.measures.diameter[before];
          result.measured[v] = this->Known.measures.measured[before];
          result.reach[v] = this->Known.measures.reach[before];
          const auto lengths = this->lengths(v);
          std::copy(lengths,
            lengths + this->Cone.size(),
            result.lengths.begin() + static_cast<std::ptrdiff_t>(v * this->Cone.size()));
        }
      });
    return taken;
  }

private:
  float reach(int v) const { return this->Known.measures.reach[this->Match.vertices[v]]; }
  std::vector<std::uint8_t>::const_iterator lengths(int v) const
  {
    return this->Known.measures.lengths.begin() +
           static_cast<std::ptrdiff_t>(this->Match.vertices[v] * this->Cone.size());
  }

  // Drops the vertices whose cone as a whole may meet a changed facet; they stay in `vertices`.
  void dropCones(const Mesh& changedMesh, std::vector<int>& vertices, std::vector<char>& kept) const
  {
    this->Caller.checkpoint(0.0);
    std::vector<float> reaches;
    reaches.reserve(vertices.size());
    for (const int v : vertices)
    {
      reaches.push_back(this->reach(v));
    }
    const RayScene changed(changedMesh, this->Scene.frame, this->Caller);
    const std::vector<char> met = conesThatMeet(
      changed, this->Scene, this->Normals, vertices, reaches, std::acos(this->Cone.back()[2]), this->Caller);
    std::size_t count = 0;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (met[i])
      {
        kept[vertices[i]] = 0;
        vertices[count++] = vertices[i];
      }
    }
    vertices.resize(count);
  }

  // Takes back dropped vertices no ray of which leaves through a changed facet within its
  // length.
  void dropRays(Mesh mesh,
    const std::vector<int>& vertices,
    const MakeCaster& makeCaster,
    TakenOver& taken) const
  {
    this->Caller.checkpoint(0.0);
    for (const int v : vertices)
    {
      mesh.points.push_back(this->Model.points[v]); // where the rays start
    }
    if (vertices.empty() || fewFacets * mesh.triangles.size() > this->Model.triangles.size())
    {
      return;
    }
    const RayScene changed(mesh, this->Scene.frame, this->Caller);
    const std::unique_ptr<RayCaster> caster = makeCaster(changed);
    const int rays = static_cast<int>(this->Cone.size());
    const int total = static_cast<int>(vertices.size());
    const int blockSize = std::max(1, raysBetweenChecks / rays);
    std::vector<RayHit> hits;
    for (int first = 0; first < total; first += blockSize)
    {
      this->Caller.checkpoint(0.0);
      const int count = std::min(blockSize, total - first);
      RayBatch batch =
        conesOf(vertices.data() + first, count, this->Normals, this->Sides, this->Cone, this->Caller);
      std::iota(batch.vertices.begin(), batch.vertices.end(), mesh.vertexCount() - total + first);
      batch.bounds.resize(batch.directions.size());
      for (int i = 0; i < count; ++i)
      {
        const int v = vertices[first + i];
        const RayLengths packing(this->reach(v));
        std::transform(this->lengths(v),
          this->lengths(v) + rays,
          batch.bounds.begin() + static_cast<std::ptrdiff_t>(i) * rays,
          [&](std::uint8_t length) {
            return RayBounds{ 0.0f, packing.unpack(length) };
          });
      }
      caster->cast(batch, hits, this->Caller);
      this->Caller.each(count,
        [&](int i)
        {
          const int v = vertices[first + i];
          const auto lengths = this->lengths(v);
          const RayLengths packing(this->reach(v));
          taken.kept[v] = 1;
          for (int k = 0; k < rays; ++k)
          {
            RayHit& hit = hits[static_cast<std::size_t>(i) * rays + k];
            hit.triangle = hit.distance > packing.unpack(lengths[k]) ? -1 : hit.triangle;
            taken.kept[v] = hit.triangle >= 0 ? 0 : taken.kept[v];
          }
        });
      this->addBounds(vertices.data() + first, count, hits, taken);
    }
    this->Caller.checkpoint(0.0);
  }

  // Adds what the lengths before and the hits on changed facets tell of the rays of dropped vertices.
  void addBounds(const int* vertices, int count, const std::vector<RayHit>& hits, TakenOver& taken) const
  {
    constexpr float below = 0.9999f, above = 1.0001f; // far more than rounding
    const std::size_t rays = this->Cone.size();
    const int removed = static_cast<int>(this->Match.removed.size());
    int rows = static_cast<int>(taken.bounds.size() / rays);
    for (int i = 0; i < count; ++i)
    {
      taken.rows[vertices[i]] = taken.kept[vertices[i]] ? -1 : rows++;
    }
    taken.bounds.resize(rows * rays);
    this->Caller.each(count,
      [&](int i)
      {
        const int v = vertices[i];
        const RayLengths packing(this->reach(v));
        for (std::size_t k = 0; k < rays && taken.rows[v] >= 0; ++k)
        {
          const RayHit& hit = hits[i * rays + k];
          const std::uint8_t length = this->lengths(v)[k];
          RayBounds& known = taken.bounds[taken.rows[v] * rays + k];
          known = { below * packing.least(length), above * packing.unpack(length) };
          if (hit.triangle >= 0)
          {
            // What was there before is no nearer than it was; where the changed facet is a new one it ends
            // the ray.
            known.low = std::min(known.low, below * hit.distance);
            known.high = hit.triangle < removed ? RayBounds().high : above * hit.distance;
          }
          else if (length == RayLengths::endless)
          {
            known.high = 0.0f; // still without an end
          }
        }
      });
  }

  const KnownDiameters& Known;
  const Mesh& Model;
  const RayScene& Scene;
  const std::vector<Vector3>& Normals;
  const std::vector<Vector3>& Sides;
  const Context& Caller;
  const std::vector<Vector3> Cone;
  const MeshMatch Match;
};

} // namespace

RayBatch conesOf(const int* vertices,
  int count,
  const std::vector<Vector3>& normals,
  const std::vector<Vector3>& sides,
  const std::vector<Vector3>& cone,
  const Context& context)
{
  const int rays = static_cast<int>(cone.size());
  RayBatch batch;
  batch.raysPerVertex = rays;
  batch.vertices.assign(vertices, vertices + count);
  batch.starts.assign(count, 0.0f);
  batch.directions.resize(static_cast<std::size_t>(count) * rays);
  context.each(count,
    [&](int i)
    {
      const Eigen::Matrix3d frame = frameAround(-normals[vertices[i]], sides[vertices[i]]);
      for (int k = 0; k < rays; ++k)
      {
        const Eigen::Vector3f d = (frame * cone[k]).cast<float>();
        batch.directions[static_cast<std::size_t>(i) * rays + k] = { d[0], d[1], d[2] };
      }
    });
  return batch;
}

TakenOver takeOver(const KnownDiameters& known,
  const Mesh& mesh,
  const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<Vector3>& sides,
  const MakeCaster& makeCaster,
  const Context& context,
  ConeMeasures& result)
{
  return Successor(known, mesh, scene, normals, sides, context).takeOver(makeCaster, result);
}

} // namespace oversketch
