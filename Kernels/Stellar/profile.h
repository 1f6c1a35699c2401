// How high a feature stands at a distance from its curve: Eq. 1 of "Sketch-based Adaptive Mesh Augmentation
// using Stellar Operators", or a polyline in its place; and what is drawn of it while the pen is down.
#ifndef oversketch_kernels_stellar_profile_h
#define oversketch_kernels_stellar_profile_h

#include "Mesh/graph.h"
#include "Stellar/curves.h"

#include <optional>
#include <string>

namespace oversketch
{

// A share of the height, by x = distance / radius. Zero from x = 1 on; below, (1 - x)^sharpness: 0 a plateau
// with a cliff, under 1 round with an infinitely steep foot, 1 a roof, above 1 a crease with a smooth foot.
// Every sharpness above 0 leaves a crease on the curve; the paper's shape is kept.
class Profile
{
public:
  // A sharpness, not negative. Throws Error(BadStroke) otherwise.
  explicit Profile(double sharpness = 1.5);

  // A polyline through "x y, x y, ...", with x rising from 0 to 1, see Graph; "0 1, 1 0" is sharpness 1.
  static Profile polyline(const std::string& text);

  // x is not negative.
  double operator()(double x) const;

private:
  double Sharpness;
  std::optional<Graph> Line; // in place of Eq. 1
};

// Three lines with a point for each point of a curve.
struct FeaturePreview
{
  std::vector<Vector3> crest;       // C + h n, with the pen's pressure, or the silhouette sketch
  std::vector<Vector3> left, right; // where the feature ends, r to either side in the tangent plane of C
};

// Takes the curve's own radius and height before those given [model length]. A point without a normal (the
// curve has none, or it is zero) has its crest on the curve, and both feet too. `taper` and `sketch`: as in
// DisplaceOptions, of this curve. Throws Error(BadStroke) as displace does.
FeaturePreview previewFeature(const FeatureCurve& curve,
  double radius,
  double height,
  bool usePressure = false,
  double taper = 0.0,
  const std::vector<Vector3>* sketch = nullptr);

} // namespace oversketch
#endif
