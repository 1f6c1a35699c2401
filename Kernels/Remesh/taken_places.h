// Places that have a vertex, so that no other one comes there. Header-only.
#ifndef oversketch_kernels_remesh_taken_places_h
#define oversketch_kernels_remesh_taken_places_h

#include "Mesh/mesh.h"

#include <array>
#include <cmath>
#include <functional>
#include <unordered_set>

namespace oversketch
{

// The middle of an edge that was swapped, brought back to the surface, may be one: two vertices at one place
// would be taken for one by whoever welds the mesh.
class TakenPlaces
{
public:
  explicit TakenPlaces(double apart)
    : Cell(apart)
  {
  }
  // False where the place, or one very near, is taken.
  bool take(const Vector3& p)
  {
    return this->Cells
      .insert({ std::floor(p[0] / this->Cell) + 0.0,
        std::floor(p[1] / this->Cell) + 0.0,
        std::floor(p[2] / this->Cell) + 0.0 }) // + 0.0: there is no -0.0
      .second;
  }
  void reserve(std::size_t count) { this->Cells.reserve(count); }

private:
  using Key = std::array<double, 3>;
  struct Hash
  {
    std::size_t operator()(const Key& key) const
    {
      std::size_t seed = 0;
      for (const double part : key)
      {
        seed = (seed ^ std::hash<double>()(part)) * 0x9e3779b97f4a7c15u;
        seed ^= seed >> 29;
      }
      return seed;
    }
  };
  double Cell;
  std::unordered_set<Key, Hash> Cells;
};

} // namespace oversketch
#endif
