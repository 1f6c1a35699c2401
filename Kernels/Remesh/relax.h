// Tangential relaxation of a patch: all vertices at once, and back where that is unsafe.
#ifndef oversketch_kernels_remesh_relax_h
#define oversketch_kernels_remesh_relax_h

#include "Mesh/context.h"
#include "Remesh/patch.h"

#include <vector>

namespace oversketch
{

// Every step writes to the vertices or triangles that it names only, so the result does not depend on the
// number of threads. One object serves all relaxations of a patch, for its memory's sake.
class Relaxation
{
public:
  // quick: small steps are not taken to the surface first, and the others walk over edges towards it, which
  // at a fold may end on its other side: not what recorded results of remeshing were made with.
  Relaxation(Patch& patch, const Context& context, bool quick = false)
    : Area(patch)
    , Caller(context)
    , Quick(quick)
  {
  }

  // Moves all free vertices within the tangent plane and back to the surface, but for those whose move is
  // unsafe. When cancelled it stops half done.
  void run();

private:
  struct Change // of a triangle with a corner that moves
  {
    float narrowest, narrowestBefore;
    bool turned, folded, sharp;
  };

  template <typename Body>
  void parallel(int count, const Body& body) const;
  template <typename Visit>
  void eachSpoke(int v, Visit&& visit) const;
  void want(int v);
  void see(int t);
  void seeFolds(int t);
  bool changes(int t) const;
  int foldsAround(int v, const std::vector<Vector3>& at) const;
  double turnAround(int v, const std::vector<Vector3>& at) const;
  bool safe(int v) const;
  void settle();

  Patch& Area;
  const Context& Caller;
  const bool Quick;
  std::vector<Vector3> Points; // the new ones
  std::vector<SurfacePoint> Places;
  std::vector<char> Moves, Unsafe;
  std::vector<Vector3> Crosses; // of the triangles with the new points
  std::vector<Change> Changes;
};

} // namespace oversketch
#endif
