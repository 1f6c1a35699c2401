// Laplacian deformation of a region of a mesh: keep each vertex's Laplacian coordinate as far as possible,
// pull handles to their targets, hold the region's border.
#ifndef oversketch_kernels_sparse_laplacian_h
#define oversketch_kernels_sparse_laplacian_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/place.h"
#include "Sparse/elimination.h"
#include "Sparse/memory.h"

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

// Cotangent weight (cot A + cot B) / 2 of an edge. |cot| is clamped to 1000, so that slivers and triangles
// without area stay finite; a triangle with a repeated vertex counts for nothing.
double cotangentWeight(const Mesh& mesh, const Adjacency& adjacency, int edge);

// The vertices that may move, one byte per vertex: in the region, without a neighbour outside it, in a
// connected piece with a handle. Throws Error(Failure::BadRegion) when there is none.
std::vector<char> movableVertices(const Adjacency& adjacency,
  const std::vector<char>& region,
  const std::vector<Binding>& handles);

// Keeps a part of a mesh in shape, without the handles: minimises sum_i |sum_j w_ij (u_i - u_j) - (T_i -
// I) delta_i|^2 over the displacements u = x' - x of the vertices that may move; all others have u = 0. w are
// cotangent weights, delta_i = sum_j w_ij (x_i - x_j), T_i = I without adjustNormals, else s I + [h]x fitted
// to the one-ring of i, which is linear in u. Serves any handles on these vertices.
class LaplacianShape
{
public:
  // Throws Error(Failure::Cancelled).
  LaplacianShape(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<char>& movable,
    bool borderRows,
    bool adjustNormals,
    const Context& context);

  // The normal matrix with the handles' rows, times handleWeight. It has the shape's pattern unless a handle
  // lies on vertices that are not neighbours.
  BlockMatrix normalMatrix(const std::vector<Binding>& handles, double handleWeight) const;

  std::vector<int> number;        // of a vertex's unknown, -1 where it cannot move
  std::vector<int> vertices;      // of each unknown
  std::vector<Vector3> positions; // of these
  BlockMatrix normal;             // without handles; 3x3 blocks with adjustNormals
  std::shared_ptr<const Elimination> elimination;
};

// A shape with handles: minimises the shape's sum + wc^2 sum_h |u(binding h) - d_h|^2. The factor is made
// once, by the constructor, and serves any number of solves.
class LaplacianSystem
{
public:
  // Throws Error(Failure::SolveFailed) when the system stays singular after regularisation,
  // Error(Failure::Cancelled). memory: that of a system which is not used any more.
  LaplacianSystem(std::shared_ptr<const LaplacianShape> shape,
    const std::vector<Binding>& handles,
    double handleWeight,
    const Context& context,
    std::shared_ptr<FactorMemory> memory = std::make_shared<FactorMemory>());
  // Makes a shape of its own, of what may move in the region (one byte per vertex); throws what
  // movableVertices throws, too.
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

  // Moves of the unknowns when the wanted displacement of each handle grows by its share of one vector: of
  // each, one factor, or a 3x3 matrix (column-major) with adjustNormals; in the order of shape().vertices.
  std::vector<double> response(const std::vector<double>& shares, const Context& context) const;

  const LaplacianShape& shape() const;
  int movableCount() const;
  // False for a handle all of whose vertices are fixed: it is ignored.
  bool handleActive(int handle) const;

private:
  struct Parts;
  std::unique_ptr<Parts> Pieces;
};

// Handles that move together by one vector d move everything else in proportion, so that one solve serves all
// places of the hand: vertices that may move lie at rest + response d.
struct Drag
{
  std::vector<int> vertices;    // of the mesh, ascending
  std::vector<Vector3> rest;    // their places for d = 0
  std::vector<double> response; // of each: one factor, or nine of a 3x3 matrix, column-major

  // Writes the places for d into the points of the whole mesh (three numbers each); the others are left
  // alone. Real is float or double.
  template <class Real>
  void place(const Vector3& d, Real* points, const Context& context) const;
};

} // namespace oversketch
#endif
