#include "Matrix/frames.h"

#include "Mesh/context.h"

#include <Eigen/Eigenvalues>

#include <algorithm>

namespace oversketch
{
namespace
{

constexpr int places = 101;

void smooth(std::vector<Vector3>& values, int times)
{
  std::vector<Vector3> before;
  const int last = static_cast<int>(values.size()) - 1;
  for (int time = 0; time < times; ++time)
  {
    before = values;
    for (int i = 0; i <= last; ++i)
    {
      values[i] = 0.25 * before[std::max(i - 1, 0)] + 0.5 * before[i] + 0.25 * before[std::min(i + 1, last)];
    }
  }
}

Vector3 valueAt(const std::vector<Vector3>& values, double t)
{
  const double place = std::clamp(t, 0.0, 1.0) * (places - 1);
  const int i = std::min(static_cast<int>(place), places - 2);
  return values[i] + (place - i) * (values[i + 1] - values[i]);
}

// The place at a share of the lengths.
Vector3 interpolated(const std::vector<Vector3>& values, const std::vector<double>& lengths, double t)
{
  const double length = std::clamp(t, 0.0, 1.0) * lengths.back();
  const auto after = std::upper_bound(lengths.begin(), lengths.end() - 1, length);
  const std::size_t i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - lengths.begin(), 1));
  const double step = lengths[i] - lengths[i - 1];
  const double share = step > 0.0 ? (length - lengths[i - 1]) / step : 0.0;
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

// A frame whose first two axes are these as far as possible.
CurveFrame frame(const Vector3& origin, const Vector3& along, const Vector3& outward, double t)
{
  const Vector3 unit = along.normalized(), across = outward - outward.dot(unit) * unit;
  if (!(along.norm() > 1e-6) || !(across.norm() > 1e-6 * outward.norm()))
  {
    throw Error(Failure::BadStroke,
      "The curve has no frame at %1 of its length: it turns back on itself or runs along the surface's "
      "normal. Draw it smoother.",
      t);
  }
  const Vector3 normal = across.normalized();
  return { origin, unit, normal.cross(unit), normal };
}

} // namespace

CurveFrames::CurveFrames(const std::vector<Vector3>& points, const std::vector<Vector3>& normals)
  : Points(points)
{
  const auto finite = [](const Vector3& p) { return p.allFinite(); };
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    this->Lengths.push_back(i == 0 ? 0.0 : this->Lengths.back() + (points[i] - points[i - 1]).norm());
  }
  if (normals.size() != points.size() || !std::all_of(points.begin(), points.end(), finite) ||
      !std::all_of(normals.begin(), normals.end(), finite) || points.empty() || !(this->Lengths.back() > 0.0))
  {
    throw Error(
      Failure::BadStroke, "The curve has fewer than two distinct points or is not finite; draw it anew.");
  }
  std::vector<Vector3> even;
  for (int i = 0; i < places; ++i)
  {
    const double t = static_cast<double>(i) / (places - 1);
    even.push_back(interpolated(points, this->Lengths, t));
    this->Normals.push_back(interpolated(normals, this->Lengths, t));
  }
  for (int i = 0; i < places; ++i)
  {
    this->Tangents.push_back(
      (even[std::min(i + 1, places - 1)] - even[std::max(i - 1, 0)]).stableNormalized());
  }

  Vector3 middle = Vector3::Zero(), normal = Vector3::Zero();
  for (int i = 0; i < places; ++i)
  {
    middle += even[i] / places;
    normal += this->Normals[i];
  }
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vector3& p : even)
  {
    const Vector3 d = (p - middle) / this->Lengths.back();
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> extents(spread); // ascending
  smooth(this->Tangents, 20);
  smooth(this->Normals, 40);
  const bool straight = extents.eigenvalues()[1] < 1e-6 * extents.eigenvalues()[2];
  this->Outward = straight ? extents.eigenvectors().col(2).cross(normal).stableNormalized()
                           : Vector3(extents.eigenvectors().col(0));
  int greatest = 0;
  this->Outward.cwiseAbs().maxCoeff(&greatest);
  if (this->Outward[greatest] < 0.0)
  {
    this->Outward = -this->Outward;
  }
}

Vector3 CurveFrames::originAt(double t) const
{
  return interpolated(this->Points, this->Lengths, t);
}

CurveFrame CurveFrames::at(double t) const
{
  return frame(this->originAt(t), valueAt(this->Tangents, t), valueAt(this->Normals, t), t);
}

CurveFrame CurveFrames::planesAt(double t) const
{
  const Vector3 along = valueAt(this->Tangents, t);
  return frame(this->originAt(t), along - along.dot(this->Outward) * this->Outward, this->Outward, t);
}

} // namespace oversketch
