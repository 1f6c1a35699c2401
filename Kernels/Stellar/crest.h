// Places along a feature's crest, by which is told how well the mesh holds it.
#ifndef oversketch_kernels_stellar_crest_h
#define oversketch_kernels_stellar_crest_h

#include "Mesh/place.h"
#include "Stellar/crossed_faces.h"

#include <vector>

namespace oversketch
{

// Every twentieth of the radius along a curve, a radius from either end excluded, the place on the mesh that
// is nearest there, sought from faces that the curve passes through.
std::vector<Binding> crestPlaces(const Forest& forest,
  const FeatureCurve& curve,
  double radius,
  const std::vector<int>& passed);

} // namespace oversketch
#endif
