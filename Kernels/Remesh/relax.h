// Tangential relaxation of a patch: all vertices at once, and back where that is unsafe.
#ifndef oversketch_relax_h
#define oversketch_relax_h

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
  Relaxation(Patch& patch, const Context& context)
    : patch_(patch)
    , context_(context)
  {
  }

  // Moves all free vertices within the tangent plane and back to the surface, but for those whose move is
  // unsafe. When cancelled it stops half done.
  void run();

private:
  struct Change // of a triangle with a corner that moves
  {
    float narrowest, narrowestBefore;
    bool turned, folded;
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
  bool safe(int v) const;
  void settle();

  Patch& patch_;
  const Context& context_;
  std::vector<Vector3> points_; // the new ones
  std::vector<SurfacePoint> places_;
  std::vector<char> moves_, unsafe_;
  std::vector<Vector3> crosses_; // of the triangles with the new points
  std::vector<Change> changes_;
};

} // namespace oversketch
#endif
