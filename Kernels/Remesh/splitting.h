// Edges are split where an edit is to stretch or bend them, before it does.
#ifndef oversketch_kernels_remesh_splitting_h
#define oversketch_kernels_remesh_splitting_h

#include "Remesh/cutout.h"
#include "Remesh/keep_apart.h"
#include "Remesh/passes.h"
#include "Remesh/reassemble.h"
#include "Remesh/retriangulate.h"

#include <vector>

namespace oversketch
{

// The mean edge that is to be at each vertex of a cut-out.
std::vector<double> sizesIn(const Cutout& cutout, const RetriangulateInput& input);

// The patch as the edit moves it, while its edges are split before the edit.
class Splitting
{
public:
  static constexpr int rounds = 6;
  static constexpr double longestEdge = 4.0 / 3.0, shortestEdge = 0.35; // in mean edges

  Splitting(const RetriangulateInput& input,
    const Cutout& cutout,
    const Surface& rest,
    const Held& held,
    const Motion& motion);

  void run(Steps& steps, Retriangulated& counts);

  const Patch& patch() const { return this->Area; }
  const std::vector<char>& touched() const { return this->Touched; }

private:
  struct Edge
  {
    int a, b, h; // h: a half-edge of it, from a to b, at the time
  };
  struct Wish // to split an edge
  {
    Edge edge;
    double squaredLength;
    SurfacePoint place;
    Vector3 position;
  };

  double squaredLength(int h) const
  {
    return (this->Area.point(this->Area.target(h)) - this->Area.point(this->Area.origin(h))).squaredNorm();
  }
  // Over the mean edge that is to be there.
  double relativeSquared(int h) const
  {
    return this->Area.relativeSquared(this->Area.origin(h), this->Area.target(h));
  }
  double squaredRestLength(int h) const
  {
    return (this->AtRest[this->Area.target(h)] - this->AtRest[this->Area.origin(h)]).squaredNorm();
  }

  void addEdge(int h) { this->Fresh.push_back({ this->Area.origin(h), this->Area.target(h), h }); }

  // The middle of an edge before the edit. An edge that was swapped need not lie on the surface there.
  SurfacePoint middleOf(int h) const;
  void mixValues(const SurfacePoint& at, double* values) const;

  // Wishes of the edges that are new. Threaded, by blocks, so that the movement sees the same ones together.
  void lookAtEdges(const Context& context);

  // Chooses edges that the edit stretches or bends.
  void choose(const int* begin, const int* end, std::vector<Wish>& chosen) const;

  // The middle may lie on the line of another edge: a half of the face would have no area.
  bool hasFlatHalf(const Wish& wish, int h) const;

  // Longest first, one of a face: others of it may be swapped and so be well, or else wait for the next
  // round. To halve two at once leaves rows of vertices twice as close as the rows are apart. Returns the
  // faces that came of it, four of each.
  std::vector<int> split();

  // Two faces that would lie well before the edit, too: what comes between them is placed there.
  bool liesWellAtRest(int h) const;

  int flip(const std::vector<int>& split, bool all);

  const Cutout& Cut;
  const Surface& Rest;
  const Motion& Moves;
  const std::vector<double> Sizes;
  Patch Area;
  std::vector<Vector3> AtRest; // of the patch's vertices
  TakenPlaces Taken;
  std::vector<char> Touched, IsSplit; // of its triangles: moved or split; split in this round
  std::vector<Edge> Fresh;            // that have not been looked at
  std::vector<Wish> Wishes;
};

} // namespace oversketch
#endif
