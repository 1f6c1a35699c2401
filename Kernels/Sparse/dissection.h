// Nested dissection: an order for the elimination of a sparse symmetric matrix that keeps its factor small.
//
// Why not a library: METIS looks for separators in the bare graph, which takes four times as long as our
// whole factorisation (the benchmark "Laplacian order"); minimum degree (AMD) takes more than half of that,
// and its tree has no large independent parts for threads. A mesh has coordinates: a cut through them takes a
// tenth of METIS's time, for a factor with half as many entries again, zeros of its panels included.
#ifndef oversketch_kernels_sparse_dissection_h
#define oversketch_kernels_sparse_dissection_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"

#include <vector>

namespace oversketch
{

struct Dissection
{
  // A separator, or a piece too small to cut. Its nodes are neighbours of no node outside the part but those
  // of its descendants and ancestors.
  struct Part
  {
    int first = 0, count = 0; // its nodes in the new order are first .. first + count - 1
    int parent = -1;          // the part that separates it from its sibling; after it in the list
  };
  std::vector<Part> parts;  // children before parents
  std::vector<int> inverse; // node at each new place
};

// Halves the graph again and again by the longest extent of its nodes' positions, or by the distance from an
// end of the graph where positions cut badly. pattern lists each node's neighbours (with or without itself).
// Pieces of at most `smallest` nodes are left whole. The result does not depend on the number of threads.
Dissection dissect(const Lists& pattern,
  const std::vector<Vector3>& positions,
  int smallest,
  const Context& context);

} // namespace oversketch
#endif
