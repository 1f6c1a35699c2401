#include "Section/follow.h"

#include "Matrix/operations.h"
#include "Mesh/context.h"
#include "Mesh/nearest.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr double nearPlane = 0.25; // of the curve's length

// -1 or 1 where the first or the last point of a polyline is the nearest of its places, 0 elsewhere.
int nearestEnd(const std::vector<Vector3>& curve, const Vector3& point)
{
  const double first = (point - curve.front()).squaredNorm(), last = (point - curve.back()).squaredNorm();
  const double least = std::min(first, last);
  for (std::size_t i = 1; i < curve.size(); ++i)
  {
    const Vector3 step = curve[i] - curve[i - 1], from = point - curve[i - 1];
    const double share = nearestShare(from, step);
    // Off an end itself, rounding would say which is nearer.
    const bool atEnd = (i == 1 && share == 0.0) || (i + 1 == curve.size() && share == 1.0);
    if (!atEnd && (from - share * step).squaredNorm() < least)
    {
      return 0;
    }
  }
  return first <= last ? -1 : 1;
}

Eigen::Matrix3d axesOf(const CurveFrame& frame)
{
  return matrixOf(frame).topLeftCorner<3, 3>();
}

// 1 at 0, 0 from `end` on.
double fading(double x, double end)
{
  const double share = std::clamp(x / end, 0.0, 1.0);
  return 1.0 - share * share * (3.0 - 2.0 * share);
}

// The place of the curve whose frame a vertex follows that lies beside `beside`. Another arm of the curve
// that the plane meets, too, is beside a place far from the plane's.
double frameOf(const Vector3& place, double beside, const CurveFrame& plane, double planeAt, double length)
{
  const double off = (place - plane.origin).dot(plane.along) / length;
  const double own = fading(std::abs(off), nearPlane) *
                     fading(std::max(0.0, std::abs(beside - planeAt) - nearPlane), nearPlane);
  return beside + own * (std::clamp(planeAt + off, 0.0, 1.0) - beside);
}

} // namespace

std::vector<double> sideShares(const std::vector<Vector3>& points,
  const RegionPlaces& region,
  const std::vector<Vector3>& curve,
  const CurveFrames& frames,
  const Context& context)
{
  const CurveFrame ends[2] = { frames.at(0.0), frames.at(1.0) };
  const int count = static_cast<int>(region.vertices.size());
  std::vector<double> shares(region.vertices.size());
  context.eachUntilCancelled(count,
    [&](int i)
    {
      shares[i] = 0.5 * (1.0 + region.side[i]);
      const Vector3& point = points[region.vertices[i]];
      const int which = nearestEnd(curve, point);
      if (which != 0)
      {
        const CurveFrame& frame = ends[which < 0 ? 0 : 1];
        const Vector3 way = point - frame.origin;
        const double beside = way.dot(frame.side), along = way.dot(frame.along);
        const double length = std::hypot(beside, along);
        shares[i] = length > 0.0 ? 0.5 * (1.0 + beside / length) : 0.5;
      }
    });
  context.checkpoint(0.0);
  return shares;
}

PlaneReach::PlaneReach(double plane, const std::vector<double>& handles)
  : Plane(plane)
  , Before(-std::numeric_limits<double>::infinity())
  , After(std::numeric_limits<double>::infinity())
{
  for (const double t : handles)
  {
    this->Before = t < plane ? std::max(this->Before, t) : this->Before;
    this->After = t > plane ? std::min(this->After, t) : this->After;
  }
}

double PlaneReach::at(double t) const
{
  const double end = t < this->Plane ? this->Before : this->After;
  return std::isinf(end) ? 1.0 : std::clamp((t - end) / (this->Plane - end), 0.0, 1.0);
}

std::vector<Vector3> profileMoves(const std::vector<Vector3>& points,
  const RegionPlaces& region,
  const std::vector<double>& shares,
  const ProfileChange& change,
  const Matrix4& flat,
  const CurveFrame& plane,
  const CurveFrames& frames,
  const PlaneReach& reach,
  const std::vector<double>& weights,
  const Context& context)
{
  // From the flat profile to the plane's frame.
  const Eigen::Matrix<double, 3, 2> turn = axesOf(plane).transpose() * flat.topLeftCorner<3, 2>();
  const int count = static_cast<int>(region.vertices.size());
  const auto placeOf = [&](int i)
  { return frameOf(points[region.vertices[i]], region.parameter[i], plane, reach.plane(), frames.length()); };
  std::vector<Vector3> moves(region.vertices.size(), Vector3::Zero());
  std::atomic<int> without{ count }; // the first vertex that has no frame
  context.eachUntilCancelled(count,
    [&](int i)
    {
      const double s = region.distance[i], share = shares[i];
      const Vector2 move = share * change.at(s) + (1.0 - share) * change.at(-s);
      if (move == Vector2::Zero() || i > without)
      {
        return;
      }
      const double factor = reach.at(region.parameter[i]) * (weights.empty() ? 1.0 : weights[i]);
      try
      {
        moves[i] = factor * (axesOf(frames.at(placeOf(i))) * (turn * move));
      }
      catch (const Error&)
      {
        int known = without;
        while (i < known && !without.compare_exchange_weak(known, i))
        {
        }
      }
    });
  context.checkpoint(1.0);
  if (without < count)
  {
    frames.at(placeOf(without)); // says why
  }
  return moves;
}

} // namespace oversketch
