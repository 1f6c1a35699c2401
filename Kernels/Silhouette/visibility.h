// Hidden-part removal of silhouette curves (SEED, Sec. 3.2, Fig. 6).
#ifndef oversketch_kernels_silhouette_visibility_h
#define oversketch_kernels_silhouette_visibility_h

#include "Mesh/view.h"
#include "OpenCL/device.h"
#include "Silhouette/curves.h"

namespace oversketch
{

struct VisibilityOptions
{
  double cuspAngle = 90.0; // [degrees], on the image plane
  bool rejoin = true;      // neighbouring visible segments of one curve
  Backend backend = Backend::Auto;
};

struct VisibilitySegment
{
  Curve curve;
  int source; // index of the curve it is a part of
  bool visible;
};

struct VisibilityResult
{
  std::vector<VisibilitySegment> segments; // curve by curve, along each
  Backend used = Backend::Host;
  Message warning; // why the host stood in for the device, else empty
};

// Cuts curves at cusps (three consecutive points that form an angle below cuspAngle on the image plane) and
// where they cross themselves or each other on the image plane; a crossing becomes a point of both curves,
// each at its own depth, bound to the triangle that its neighbours share. A segment is visible if at least
// one of its points is, cut points left out, for they lie on the contour that hides; one without other points
// is tested at the middles of its edges. Parts at or behind the eye of a perspective view are cut off and
// hidden. Throws Error(BadMesh) where two consecutive points share no triangle.
VisibilityResult findVisible(const std::vector<Curve>& curves,
  const Mesh& mesh,
  const std::vector<Vector3>& normals,
  const View& view,
  const VisibilityOptions& options,
  const Context& context = Context());

} // namespace oversketch
#endif
