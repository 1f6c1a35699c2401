// Curves on a mesh: the silhouette and what becomes of it.
#ifndef oversketch_kernels_silhouette_curves_h
#define oversketch_kernels_silhouette_curves_h

#include "Mesh/place.h"

#include <vector>

namespace oversketch
{

struct CurvePoint
{
  Binding binding;
  Vector3 position = Vector3::Zero();
  Vector3 normal = Vector3::Zero(); // interpolated and re-normalised
};

struct Curve
{
  std::vector<CurvePoint> points; // the first is not repeated at the end of a closed curve
  bool closed = false;
};

} // namespace oversketch
#endif
