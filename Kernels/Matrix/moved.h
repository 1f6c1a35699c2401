// The points of a region moved by shares of transformations, each point by its own.
#ifndef oversketch_kernels_matrix_moved_h
#define oversketch_kernels_matrix_moved_h

#include "Matrix/logarithm.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Context;

// Handles along a curve share it by tents: a handle's falls from 1 at its parameter to 0 at its neighbours',
// and stays 1 where it has none. Parameters ascend strictly. One value of each handle at the parameter t.
std::vector<double> tents(const std::vector<double>& handles, double t);

// Point v goes to exp(sum of weights[v * logs.size() + k] * logs[k] over k) v: all transformations at once,
// in no order. A point whose sum is zero keeps its bits. A point's result depends on nothing but itself.
//
// Source: R. Bujans, chapter 8, which says it of one matrix and one grey level. What is made is not the
// exponential of each point's matrix but its product with the point: Taylor's series, as a polynomial of
// degree two in the matrix (its own characteristic equation), over steps short enough for a fixed number of
// terms; the same for points side by side in a register.
//
// Throws Error(Failure::SolveFailed) for a logarithm with anything in its last row (a perspective), a sum
// that is not finite or one larger than 1e4 (its shift than 1e100), Error(Failure::BadMesh) for a point that
// is not finite, Error(Failure::Cancelled).
std::vector<Vector3> moved(const std::vector<Vector3>& points,
  const std::vector<Matrix4>& logs,
  const std::vector<double>& weights,
  const Context& context);

} // namespace oversketch
#endif
