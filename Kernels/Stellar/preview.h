// What a stroke would make, drawn from its curves alone while the pen is down.
#ifndef oversketch_kernels_stellar_preview_h
#define oversketch_kernels_stellar_preview_h

#include "Stellar/curves.h"

namespace oversketch
{

// Three lines with a point for each point of a curve.
struct FeaturePreview
{
  std::vector<Vector3> crest;       // C + h n, with the pen's pressure, or the silhouette sketch
  std::vector<Vector3> left, right; // where the feature ends, r to either side in the tangent plane of C
};

// Takes the curve's own radius and height before those given [model length]. A point without a normal (the
// curve has none, or it is zero) has its crest on the curve, and both feet too. `sketch`: as in
// DisplaceOptions, of this curve. Throws Error(BadStroke) as displace does.
FeaturePreview previewFeature(const FeatureCurve& curve,
  double radius,
  double height,
  bool usePressure = false,
  const std::vector<Vector3>* sketch = nullptr);

} // namespace oversketch
#endif
