// Rays of one mesh's shape diameter that need not be traced for the next mesh.
#ifndef oversketch_kernels_ray_known_diameters_h
#define oversketch_kernels_ray_known_diameters_h

#include "Ray/ray_caster.h"
#include "Ray/shape_diameter.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace oversketch
{

// Lengths of a vertex's rays in a byte each, never less than they are.
struct RayLengths
{
  static constexpr std::uint8_t endless = 255;
  static constexpr float longest = 3.5f; // within [-1, 1]

  explicit RayLengths(float reach)
    : unit(std::min(reach, longest) / 254.0f)
  {
  }
  std::uint8_t pack(const RayHit& hit) const
  {
    return hit.triangle < 0
             ? endless
             : static_cast<std::uint8_t>(std::min(254.0f, std::ceil(hit.distance / this->unit)));
  }
  float unpack(std::uint8_t packed) const
  {
    return packed == endless ? longest : 1.00001f * static_cast<float>(packed) * this->unit;
  }

  // The length is not less than this.
  float least(std::uint8_t packed) const
  {
    return packed == endless ? longest : static_cast<float>(std::max<int>(packed - 1, 0)) * this->unit;
  }

  float unit;
};

// A batch of the cones of some vertices; rays start at the vertices.
RayBatch conesOf(const int* vertices,
  int count,
  const std::vector<Vector3>& normals,
  const std::vector<Vector3>& sides,
  const std::vector<Vector3>& cone,
  const Context& context);

using MakeCaster = std::function<std::unique_ptr<RayCaster>(const RayScene&)>;

// Knowledge of this mesh's rays from another one.
struct TakenOver
{
  std::vector<char> kept; // per vertex 1 where its values hold
  // Places of the bounds of rays that are the same though their vertex's values do not hold.
  std::vector<int> rows; // per vertex, -1: there are none
  std::vector<RayBounds> bounds;
};

// Copies to `result`, which has its sizes, what holds of another mesh in the same frame, with the same
// options and kind of caster.
TakenOver takeOver(const KnownDiameters& known,
  const Mesh& mesh,
  const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<Vector3>& sides,
  const MakeCaster& makeCaster,
  const Context& context,
  ConeMeasures& result);

} // namespace oversketch
#endif
