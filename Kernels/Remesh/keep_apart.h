// Vertices that come, or have come, to lie at one place: whoever welds a mesh would take them for one, and
// their edges for edges of more than two triangles.
#ifndef oversketch_kernels_remesh_keep_apart_h
#define oversketch_kernels_remesh_keep_apart_h

#include "Mesh/mesh.h"

#include <array>
#include <cmath>
#include <functional>
#include <unordered_set>
#include <vector>

namespace oversketch
{

// Places that have a vertex, so that no other one comes there: the middle of an edge that was swapped,
// brought back to the surface, may be one.
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

// Moves each vertex that lies where another one does and may move towards the middle of its
// neighbours, by as little as tells them apart: as floats where the mesh will be stored in such. Of those at
// one place the one that is least movable stays: 0 may not move. Returns how many are left together, because
// none of them may move or their neighbours lie there as well.
int keepApart(Mesh& mesh, const std::vector<char>& movable, bool asFloats);

} // namespace oversketch
#endif
