// How long the edges of a remeshed region shall be.
#ifndef oversketch_kernels_remesh_sizing_h
#define oversketch_kernels_remesh_sizing_h

#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

// 1 for the triangles a region's remeshing may change: all three vertices, distinct, in the region.
std::vector<char> regionTriangles(const Mesh& mesh, const std::vector<char>& region);

// L, the mean length of the edges of the active triangles; 0 if there is none.
double guideLength(const Mesh& mesh, const std::vector<char>& active);

// Per vertex the edge length of even triangles that are as wide as those round it (two rings): long thin ones
// ask for shorter edges than their mean, since it is their width that makes a tube round. Where there is no
// area, and away from active triangles, 0.
std::vector<double> fittingLengths(const Mesh& mesh, const std::vector<char>& active);

struct Sizing
{
  double length = 0.0;    // the wanted length, L k
  double gradation = 0.5; // the target grows by at most this much per unit of way along edges
  // Diameters below 2 * minimumFactor * length ask for no more: with it a sheet of no thickness stays finite.
  double minimumFactor = 0.2;
};

// Target length per vertex, min(length, diameter / 2, fitting), made smooth. diameters and fitting: one per
// vertex, or empty for none; values that are not positive and finite limit nothing. The limit by diameter may
// raise the number of
// triangles to four times the input's (or as many as `length` alone would give, if that is more) and is
// raised evenly where it would ask for more. Next to edges that cannot change (outside the region,
// non-manifold) targets go over to the lengths of those edges, so that no fan of needles leads from a coarse
// border to a fine inside.
std::vector<double> targetLengths(const Mesh& mesh,
  const std::vector<char>& active,
  const std::vector<double>& diameters,
  const std::vector<double>& fitting,
  const Sizing& sizing);

struct TriangleLimit
{
  double wanted = 0.0; // triangles that were asked for, where that is too many; else 0
  int most = 0;        // that a remeshing to the targets may ever make, the gone ones, too
};

// Raises the targets from below, so that no triangle that is far larger than those round it costs minutes,
// evenly, where by area and longest edge of the active triangles they ask for more than 64 times as many and
// 20,000, or 500,000 (but four times as many as there are always pass).
TriangleLimit limitTriangles(const Mesh& mesh, const std::vector<char>& active, std::vector<double>& targets);

} // namespace oversketch
#endif
