#include "Stellar/curves.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

namespace oversketch
{

void FeatureCurve::measure()
{
  this->arc.assign(this->points.size(), 0.0);
  this->length = 0.0;
  for (int s = 0; s < this->segmentCount(); ++s)
  {
    this->arc[s] = this->length;
    this->length += (this->points[this->segmentEnd(s)] - this->points[s]).norm();
  }
  if (!this->closed && !this->arc.empty())
  {
    this->arc.back() = this->length;
  }
}

std::pair<int, double> FeatureCurve::at(double parameter) const
{
  if (this->closed && this->length > 0.0)
  {
    parameter -= this->length * std::floor(parameter / this->length);
  }
  const int last = this->segmentCount() - 1;
  const auto after = std::upper_bound(this->arc.begin(), this->arc.end(), parameter);
  const int segment = std::clamp(static_cast<int>(after - this->arc.begin()) - 1, 0, last);
  const double end = segment + 1 < static_cast<int>(this->arc.size()) ? this->arc[segment + 1] : this->length;
  const double span = end - this->arc[segment];
  return { segment, span > 0.0 ? std::clamp((parameter - this->arc[segment]) / span, 0.0, 1.0) : 0.0 };
}

Vector3 FeatureCurve::position(double parameter) const
{
  const auto [segment, t] = this->at(parameter);
  return (1.0 - t) * this->points[segment] + t * this->points[this->segmentEnd(segment)];
}

double FeatureCurve::pressureAt(double parameter) const
{
  if (this->pressure.empty())
  {
    return 1.0;
  }
  const auto [segment, t] = this->at(parameter);
  return (1.0 - t) * this->pressure[segment] + t * this->pressure[this->segmentEnd(segment)];
}

double FeatureCurve::taperAt(double parameter, double taper) const
{
  const double whole = std::min(taper, 0.5 * this->length),
               end = std::min(parameter, this->length - parameter);
  if (this->closed || !(whole > 0.0) || end >= whole)
  {
    return 1.0;
  }
  return std::sin(0.5 * static_cast<double>(EIGEN_PI) * std::max(0.0, end) / whole);
}

std::vector<double> FeatureCurve::limits(bool up) const
{
  std::vector<double> limits;
  for (const std::array<double, 2>& both : this->room)
  {
    limits.push_back(roomShare * both[up ? 1 : 0]);
  }
  const int count = static_cast<int>(limits.size());
  const auto lower = [&](int from, int to)
  { limits[to] = std::min(limits[to], limits[from] + (this->points[to] - this->points[from]).norm()); };
  for (int round = 0; round < (this->closed ? 2 : 1); ++round)
  {
    for (int i = this->closed ? 0 : 1; i < count; ++i)
    {
      lower(i > 0 ? i - 1 : count - 1, i);
    }
    for (int i = count - (this->closed ? 1 : 2); i >= 0; --i)
    {
      lower(i + 1 < count ? i + 1 : 0, i);
    }
  }
  return limits;
}

double FeatureCurve::apart(double s, double t) const
{
  const double direct = std::abs(s - t);
  return this->closed ? std::min(direct, this->length - direct) : direct;
}

double FeatureCurve::between(double s, double t) const
{
  const double middle = 0.5 * (s + t);
  if (!this->closed || 2.0 * std::abs(s - t) <= this->length)
  {
    return middle;
  }
  const double half = 0.5 * this->length;
  return middle < half ? middle + half : middle - half;
}

void checkCurves(const FeatureCurves& curves)
{
  for (std::size_t k = 0; k < curves.size(); ++k)
  {
    const FeatureCurve& c = curves[k];
    const auto refuse = [&](const std::string& what)
    { throw Error(Failure::BadStroke, "Feature curve %1 %2.", k, what); };
    if (c.points.size() < 2)
    {
      refuse("has fewer than two points; draw a longer stroke");
    }
    if (c.arc.size() != c.points.size())
    {
      refuse("has no arc length at each point; project the stroke on the mesh again");
    }
    const auto fits = [&](std::size_t size) { return size == 0 || size == c.points.size(); };
    if (!fits(c.normals.size()) || !fits(c.pressure.size()) || !fits(c.cells.size()) ||
        !fits(c.places.size()) || !fits(c.room.size()))
    {
      refuse("has arrays that are not of one value a point; project the stroke on the mesh again");
    }
    const auto finite = [](const Vector3& x) { return x.allFinite(); };
    if (!std::all_of(c.points.begin(), c.points.end(), finite) ||
        !std::all_of(c.normals.begin(), c.normals.end(), finite) || !std::isfinite(c.length) ||
        !std::all_of(c.pressure.begin(), c.pressure.end(), [](double x) { return std::isfinite(x); }) ||
        std::any_of(c.room.begin(),
          c.room.end(),
          [](const std::array<double, 2>& r) { return std::isnan(r[0]) || std::isnan(r[1]); }))
    {
      refuse("has values that are not finite numbers; draw the stroke again");
    }
    if (!(c.length > 0.0))
    {
      refuse("has no length; draw a longer stroke");
    }
    if (c.radius && !(*c.radius > 0.0 && std::isfinite(*c.radius)))
    {
      refuse("has a Radius that is not a positive number");
    }
    if (c.height && !std::isfinite(*c.height))
    {
      refuse("has a Height that is not a finite number");
    }
    if (c.sharpness && !(*c.sharpness >= 0.0 && std::isfinite(*c.sharpness)))
    {
      refuse("has a Sharpness that is not zero or a positive number");
    }
  }
}

void checkRadius(const FeatureCurves& curves, double radius)
{
  if (!(radius > 0.0 && std::isfinite(radius)) &&
      std::any_of(curves.begin(), curves.end(), [](const FeatureCurve& c) { return !c.radius; }))
  {
    throw Error(Failure::BadStroke, "The {radius} must be a positive number.");
  }
}

std::uint64_t digest(const FeatureCurves& curves)
{
  std::uint64_t h = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t bits)
  {
    h = (h ^ bits) * 0x9e3779b97f4a7c15u;
    h ^= h >> 29;
  };
  for (const FeatureCurve& c : curves)
  {
    add(2 * c.points.size() + (c.closed ? 1 : 0));
    for (const Vector3& p : c.points)
    {
      for (int k = 0; k < 3; ++k)
      {
        const double x = p[k] + 0.0; // -0 is 0
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof bits);
        add(bits);
      }
    }
  }
  return h;
}

CurveSearch::CurveSearch(const FeatureCurves& curves)
  : Curves(curves)
  , Trees(curves.size())
{
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const int count = curves[k].segmentCount();
    if (count > 0)
    {
      this->Trees[k].order.resize(count);
      std::iota(this->Trees[k].order.begin(), this->Trees[k].order.end(), 0);
      this->build(k, 0, 0, count);
      Tree& tree = this->Trees[k];
      for (const int s : tree.order)
      {
        const FeatureCurve& c = curves[k];
        const Vector3 &from = c.points[s], &to = c.points[c.segmentEnd(s)], along = to - from;
        const double end = s + 1 < static_cast<int>(c.arc.size()) ? c.arc[s + 1] : c.length;
        tree.segments.push_back({ from, to, along, along.squaredNorm(), c.arc[s], end });
      }
    }
  }
}

void CurveSearch::build(int curve, int node, int begin, int end)
{
  const FeatureCurve& c = this->Curves[curve];
  Tree& tree = this->Trees[curve];
  const auto from = tree.order.begin() + begin, to = tree.order.begin() + end;
  Eigen::AlignedBox3d box;
  std::for_each(from, to, [&](int s) { box.extend(c.points[s]).extend(c.points[c.segmentEnd(s)]); });
  tree.boxes.resize(std::max<std::size_t>(tree.boxes.size(), node + 1));
  tree.boxes[node] = box;
  if (end - begin > leafSize)
  {
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const int middle = (begin + end) / 2;
    std::nth_element(from,
      tree.order.begin() + middle,
      to,
      [&](int a, int b)
      {
        const double x = c.points[a][axis] + c.points[c.segmentEnd(a)][axis],
                     y = c.points[b][axis] + c.points[c.segmentEnd(b)][axis];
        return x != y ? x < y : a < b;
      });
    this->build(curve, 2 * node + 1, begin, middle);
    this->build(curve, 2 * node + 2, middle, end);
  }
}

NearestOnCurve CurveSearch::nearest(int curve, const Vector3& point, double limit) const
{
  NearestOnCurve best;
  best.distance = limit;
  if (!this->Trees[curve].boxes.empty())
  {
    this->search(curve, 0, 0, static_cast<int>(this->Trees[curve].order.size()), point, best);
  }
  if (best.segment < 0)
  {
    best.distance = std::numeric_limits<double>::infinity();
  }
  return best;
}

void CurveSearch::search(int curve, int node, int begin, int end, const Vector3& point, NearestOnCurve& best)
  const
{
  const Tree& tree = this->Trees[curve];
  if (end - begin <= leafSize)
  {
    for (int i = begin; i < end; ++i)
    {
      const Segment& s = tree.segments[i];
      const double t = s.square > 0.0 ? std::clamp(s.along.dot(point - s.from) / s.square, 0.0, 1.0) : 0.0;
      const Vector3 foot = (1.0 - t) * s.from + t * s.to;
      const double distance = (point - foot).norm();
      if (distance < best.distance || (distance == best.distance && best.segment > tree.order[i]))
      {
        best = { distance, s.begin + t * (s.end - s.begin), foot, tree.order[i] };
      }
    }
    return;
  }
  // A box that is exactly as near may hold a lower segment. What rounding could hide is searched too, and
  // what is so near that squares are none.
  const auto away = [&](int child)
  { return (1.0 - 1e-11) * tree.boxes[child].squaredExteriorDistance(point); };
  const int middle = (begin + end) / 2, left = 2 * node + 1, right = 2 * node + 2;
  const double toLeft = away(left), toRight = away(right);
  const bool leftFirst = toLeft <= toRight;
  for (bool isLeft : { leftFirst, !leftFirst })
  {
    if ((isLeft ? toLeft : toRight) <= std::max(best.distance * best.distance, 1e-290))
    {
      this->search(curve, isLeft ? left : right, isLeft ? begin : middle, isLeft ? middle : end, point, best);
    }
  }
}

} // namespace oversketch
