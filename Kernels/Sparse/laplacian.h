// Laplacian deformation of a region of a mesh: keep each vertex's Laplacian coordinate as far as possible,
// pull handles to their targets, hold the region's border.
#ifndef oversketch_laplacian_h
#define oversketch_laplacian_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Silhouette/curves.h"

#include <memory>
#include <vector>

namespace oversketch
{

struct LaplacianOptions
{
  double handleWeight = 10.0; // weight wc of a handle's row against a vertex's row, both in units of length
  bool borderRows = true;     // rows of border vertices too: a C1 join
  bool adjustNormals = false; // fit a similarity to each one-ring: one system of 3n unknowns
};

// Cotangent weight (cot A + cot B) / 2 of each edge of the adjacency that has a triangle with a vertex marked
// in `wanted`, 0 elsewhere. |cot| is clamped to 1000, so that slivers and triangles without area stay finite;
// a triangle with a repeated vertex counts for nothing.
std::vector<double> cotangentWeights(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& wanted);

// The system over the vertices that may move: vertices of the region without a neighbour outside it, in those
// of their connected pieces that a handle pulls. Unknowns are displacements u = x' - x; all else has u = 0.
// Minimises
//   sum_i |sum_j w_ij (u_i - u_j) - (T_i - I) delta_i|^2 + wc^2 sum_h |u(binding h) - d_h|^2,
// w cotangent weights, delta_i = sum_j w_ij (x_i - x_j), T_i = I without adjustNormals, else s I + [h]x
// fitted to the one-ring of i, which is linear in u. The factor is made once, by the constructor, and serves
// any number of solves.
class LaplacianSystem
{
public:
  // region has one byte per vertex. Throws Error(Failure::BadRegion) when nothing can move or no handle lies
  // on a vertex that can, Error(Failure::SolveFailed) when the system stays singular after regularisation,
  // Error(Failure::Cancelled).
  LaplacianSystem(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<char>& region,
    const std::vector<Binding>& handles,
    const LaplacianOptions& options,
    const Context& context);
  ~LaplacianSystem();

  // Displacement of every vertex of the mesh for the wanted displacement of each handle; exactly zero for
  // vertices that cannot move, and everywhere when all wanted displacements are zero.
  std::vector<Vector3> solve(const std::vector<Vector3>& displacements, const Context& context) const;

  int movableCount() const;
  // False for a handle all of whose vertices are fixed: it is ignored.
  bool handleActive(int handle) const;

private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

} // namespace oversketch
#endif
