// Incremental remeshing of a region to target edge lengths, with where every corner came from.
#ifndef oversketch_kernels_remesh_remesh_h
#define oversketch_kernels_remesh_remesh_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "Mesh/place.h"

#include <array>
#include <limits>
#include <vector>

namespace oversketch
{

struct RemeshInput
{
  const Mesh& mesh;
  std::vector<char> region;     // per vertex
  std::vector<double> targets;  // target edge length per vertex, see targetLengths()
  std::vector<int> charts;      // per triangle, or empty
  std::vector<Binding> handles; // rebound to the result
  bool protectHandles = true;   // what carries handles stays where it is, and is only split
  int iterations = 5;
  // Edges over 50 degrees stay where they are, and are only split; no move makes the surface turn more
  // sharply.
  bool keepSmooth = true;
  bool takeOutFolds = false;                           // see unfold()
  int mostTriangles = std::numeric_limits<int>::max(); // that are ever made, see limitTriangles()
};

struct RemeshResult
{
  Mesh mesh;
  // Points outside the region come first, in their order; then those of the region that stayed; then new
  // ones.
  std::vector<int> pointSource; // the input point it is, or -1 for one that moved or is new
  // Triangles outside the region come first, in their order.
  std::vector<int> triangleSource; // the input triangle under its middle
  std::vector<Binding> handles;

  // Where on the input a point is, and each corner of a triangle, in the triangle's own chart. Of points that
  // are input points and triangles that are input triangles nothing is stored.
  SurfacePoint place(int point) const
  {
    return this->pointSource[point] >= 0 ? SurfacePoint() : this->places[point - this->outsidePoints];
  }
  std::array<SurfacePoint, 3> corners(int triangle) const
  {
    return triangle < this->outsideTriangles ? wholeTriangle(this->triangleSource[triangle])
                                             : this->insideCorners[triangle - this->outsideTriangles];
  }

  int outsidePoints = 0, outsideTriangles = 0; // those outside the region
  std::vector<SurfacePoint> places;            // of the others
  std::vector<std::array<SurfacePoint, 3>> insideCorners;
};

// Botsch and Kobbelt's loop: split edges over 4/3 of the target, collapse those under 4/5, flip towards
// valence 6, relax within the tangent plane and go back to the input surface. Only triangles with three
// region vertices change; see Patch for what stays. Throws Error(Cancelled).
RemeshResult remesh(const RemeshInput& input, const Context& context);

} // namespace oversketch
#endif
