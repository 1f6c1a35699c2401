#include "Stellar/profile.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

Profile::Profile(double sharpness)
  : Sharpness(sharpness)
{
  if (!(sharpness >= 0.0) || !std::isfinite(sharpness))
  {
    throw Error(
      Failure::BadStroke, "The sharpness is %1; it must be a number that is not negative.", sharpness);
  }
}

Profile Profile::polyline(const std::string& text)
{
  Profile profile;
  profile.Line = Graph::parse(text, "0 1, 0.5 0.8, 1 0");
  return profile;
}

double Profile::operator()(double x) const
{
  if (!(x < 1.0))
  {
    return 0.0;
  }
  return this->Line ? (*this->Line)(x) : std::pow(1.0 - x, this->Sharpness);
}

FeaturePreview previewFeature(const FeatureCurve& curve,
  double radius,
  double height,
  bool usePressure,
  double taper,
  const std::vector<Vector3>* sketch)
{
  checkCurves({ curve });
  const double r = curve.radius.value_or(radius), h = curve.height.value_or(height);
  const std::size_t count = curve.points.size();
  if (!(r > 0.0) || !std::isfinite(r) || !std::isfinite(h) || (sketch && sketch->size() != count))
  {
    throw Error(Failure::BadStroke,
      "A feature needs a radius above 0, a height that is a number, and of a sketch a point for each point "
      "of "
      "the curve.");
  }
  const std::vector<double> limits = curve.limits(h > 0.0);
  FeaturePreview preview;
  for (std::size_t i = 0; i < count; ++i)
  {
    const Vector3& p = curve.points[i];
    const bool first = i == 0 && !curve.closed, last = i + 1 == count && !curve.closed;
    const Vector3 along =
      curve.points[last ? i : (i + 1) % count] - curve.points[first ? i : (i + count - 1) % count];
    const Vector3 normal = curve.normals.empty() ? Vector3::Zero() : curve.normals[i].normalized();
    const double share = curve.taperAt(curve.arc[i], taper);
    const Vector3 side = share * r * normal.cross(along).normalized();
    const double pressure = usePressure && !curve.pressure.empty() ? curve.pressure[i] : 1.0;
    const double limit = limits.empty() ? std::numeric_limits<double>::infinity() : limits[i];
    const double height = std::clamp(pressure * h, -limit, limit);
    preview.crest.push_back(
      p + share * share * (sketch ? Vector3((*sketch)[i] - p) : Vector3(height * normal)));
    preview.left.push_back(p + side);
    preview.right.push_back(p - side);
  }
  return preview;
}

} // namespace oversketch
