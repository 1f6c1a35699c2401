// How far a patch's vertices are from its reference curve on the way to its boundary, and beside which place
// of the curve they lie.
#ifndef oversketch_kernels_shading_fields_h
#define oversketch_kernels_shading_fields_h

#include "Mesh/mesh.h"
#include "Shading/front.h"

#include <vector>

namespace oversketch
{

struct Context;

struct FieldRules
{
  bool straight = false;           // distances through space instead of over the surface
  double smoothing = 0.15;         // of the share; 0 as published
  double parameterSmoothing = 0.3; // of the parameter; 0 as published
};

struct CurveFields
{
  std::vector<double> share;     // 0 on the reference curve, 1 on the boundary, between them elsewhere
  std::vector<double> parameter; // share of the reference curve's length, 0 to 1
  std::vector<signed char>
    side; // 1 left of the reference curve as it goes, seen from outside, -1 right, 0 on it
};

// On which side of a chain of two or more vertices inside, whose segments are edges, the others lie, as
// CurveFields has it: that of the neighbour of the chain from which the shortest way over edges comes. Beyond
// an end the chain counts as gone on straight. Vertices that no way leads to have 0.
std::vector<signed char> chainSides(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& chain);

// The distance of each vertex from a chain of vertices whose segments are edges: the length of a front's way
// over the surface, never less than the straight one; or that.
ChainDistances chainDistances(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& chain,
  bool closed,
  bool straight,
  const Context& context);

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.2: by each vertex's
// distance to the reference curve, white there and black at the boundary. Share: d / (d + e) with the
// distances d from the reference curve and e from the boundary. Parameter: the place of the reference curve
// that is nearest.
//
// Departures: distances go over the surface, since straight ones cut through thin parts. The share has
// creases where the nearest place leaps, the parameter is torn there by as much as the whole curve; so both
// are smoothed, the farther the more room there is: f' - div((c (d + e))^2 grad f') = f, with f' held at 0
// and 1 on the two curves for the share, and on the reference curve alone for the parameter; in linear
// elements, and cut off at 0 and 1. The disc's positive weights of edges would keep that range too, but bend
// f' beside long diagonals, which stands as ribs on a raised flank.
//
// Throws what discBorder throws, Error(Failure::BadStroke) for a reference curve of fewer than two vertices
// or one that is not a chain of edges inside the patch, Error(Failure::SolveFailed),
// Error(Failure::Cancelled).
CurveFields curveFields(const Mesh& patch,
  const std::vector<int>& reference,
  const FieldRules& rules,
  const Context& context);

} // namespace oversketch
#endif
