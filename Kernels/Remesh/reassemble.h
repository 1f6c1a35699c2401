// A patch of a mesh, retriangulated, put back into it.
#ifndef oversketch_kernels_remesh_reassemble_h
#define oversketch_kernels_remesh_reassemble_h

#include "Remesh/cutout.h"
#include "Remesh/patch.h"
#include "Remesh/retriangulate.h"

#include <array>
#include <vector>

namespace oversketch
{

// Parts of a cut-out that keep their places: vertices that the edit does not move, and the curves.
struct Held
{
  std::vector<int> vertices;
  std::vector<std::array<int, 2>> edges;
};
Held heldIn(const Cutout& cutout, const RetriangulateInput& input);

// A curve's vertices while the mesh changes.
struct HeldVertex
{
  int whole = -1; // the input vertex that it is, or -1
  int own = -1;   // its number in the cut-out and its patches, or -1 for one outside
  int from = 0;   // see CurveVertex
  double t = 0.0;
};
// The curves with the vertices that came onto them: the ends of edges and what lies between them, see
// Patch::keptSplits.
std::vector<std::vector<HeldVertex>> heldCurves(const Cutout& cutout,
  const RetriangulateInput& input,
  const std::vector<std::array<int, 3>>& splits);

// The mesh that a patch was made of, which has the cut-out's vertices and triangles first.
struct Stage
{
  const Mesh& mesh;
  const std::vector<char>& active;          // of its triangles, those of the patch
  const std::vector<SurfacePoint>& origins; // of its further vertices, places in the cut-out
};

// rest: the cut-out as a surface.
Retriangulated reassembled(const RetriangulateInput& input,
  const Cutout& cutout,
  const Surface& rest,
  const Stage& stage,
  const Patch& patch,
  const std::vector<std::vector<HeldVertex>>& curves,
  const Context& context);

// The input as it was moved, when nothing is to be done.
Retriangulated untouched(const RetriangulateInput& input);

} // namespace oversketch
#endif
