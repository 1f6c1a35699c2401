// A 4-8 mesh as arrays and back: the leaves alone encode the forest.
#ifndef oversketch_kernels_stellar_leaves_h
#define oversketch_kernels_stellar_leaves_h

#include "Stellar/forest.h"

#include <cstdint>
#include <vector>

namespace oversketch
{

// The forest without unused slots, in the order that depends on the mesh alone and not on how it was made:
// faces by root, then from left to right in its tree; vertices without parents as they were, then by level,
// then by the ids of their parents, the lower first.
struct Canonical
{
  Forest forest;
  std::vector<int> vertexFrom, faceFrom; // slots in the forest that it was made of
};
Canonical canonical(const Forest& forest, const Context& context);

// Points and cells of a 4-8 mesh with the arrays that a data set carries, named as there. Empty where
// optional ones are absent.
struct Leaves
{
  std::vector<Vector3> points;
  std::vector<Triangle> triangles;   // the newest corner first
  std::vector<int> root;             // cells: StellarRoot
  std::vector<std::uint64_t> path;   // cells: StellarPath
  std::vector<std::uint8_t> gen;     // cells: StellarGen
  std::vector<std::uint8_t> moved;   // points: StellarMoved
  std::vector<int> curveId;          // points: CurveId, -1 for none
  std::vector<double> curveParam;    // points: CurveParam [model length]
  std::vector<Vector3> baseNormal;   // points: BaseNormal, optional
  std::vector<Vector3> displacement; // points: Displacement [model length], optional
  std::vector<double> feature;       // points: Feature, optional
};

// Leaves of a canonical forest: point i is vertex i, cell i is face i.
Leaves emit(const Forest& canonical);

// The canonical forest of which these are the leaves, to the bit. Throws Error(MissingArray or BadMesh) that
// names the array, the first cell or point that contradicts the rest, and the likely culprit.
Forest rebuild(const Leaves& leaves, const Context& context);

// Per face of `after` the face of `before` that lies under its middle. Both canonical, of one base mesh.
std::vector<int> facesUnder(const Forest& before, const Forest& after);

} // namespace oversketch
#endif
