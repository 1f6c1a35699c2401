// A patch of a surface as a disc, to look at and to paint.
#ifndef oversketch_kernels_shading_flatten_h
#define oversketch_kernels_shading_flatten_h

#include "Mesh/disc.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Context;
struct BlockMatrix;

// max(cotangent weight, 1e-3) of each edge: positive, so that means of neighbours stay between them.
std::vector<double> positiveWeights(const Mesh& mesh, const Adjacency& adjacency);

// The Laplacian of weights on edges among some vertices, plus an amount on the diagonal of each: row i holds
// the sum of the weights of all of its vertex's edges, and minus those to its neighbours in the list.
// `number` is a vertex's place in the list, -1 for others; a fixed neighbour's weight goes to no column.
BlockMatrix weightMatrix(const Adjacency& adjacency,
  const std::vector<double>& weights,
  const std::vector<int>& vertices,
  const std::vector<int>& number,
  const std::vector<double>& diagonal);

// Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.1 and Appendix B,
// which give x and y within -1 and 1, and not the map. Here the border is on a circle by its length, the
// inside at means of neighbours with positive symmetric weights (W. Tutte, "How to Draw a Graph": no triangle
// turns over). Such maps squeeze a limb into a few texels, so then comes balancing, at most `rounds` times:
// with r the root of a vertex's share of the surface over its share of the disc, within 1/4 and 4, g becomes
// g / r, and weights w_ij g_i g_j, until r is off 1 by less than 5 % in the mean, which nobody sees. A round
// that turns a triangle over, by rounding, is not taken and is the last.
//
// Appendix B divides by the largest coordinate after it has lost the smallest; here x and y go from the
// extremes to -1 and 1.
//
// Throws what discBorder throws, Error(Failure::BadRegion) for a border edge without length or a patch
// without area, Error(Failure::SolveFailed), Error(Failure::Cancelled).
std::vector<Vector2> flattened(const Mesh& patch, const Context& context, int rounds = 10);

} // namespace oversketch
#endif
