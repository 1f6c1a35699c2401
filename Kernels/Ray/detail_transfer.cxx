#include "Ray/detail_transfer.h"

#include "Ray/surface_rays.h"

#include <cmath>

namespace oversketch
{

namespace
{

using Turn = Eigen::Quaterniond;

// A triangle as a frame, and its corners in it, seen from the first one.
struct Flat
{
  Eigen::Matrix3d axes; // the third is the normal; zero where the triangle has no area
  Vector2 second, third;

  Flat(const std::vector<Vector3>& points, const Triangle& t)
  {
    const Vector3 along = points[t[1]] - points[t[0]], other = points[t[2]] - points[t[0]];
    this->axes.col(0) = along.normalized();
    this->axes.col(2) = along.cross(other).normalized();
    this->axes.col(1) = this->axes.col(2).cross(this->axes.col(0));
    this->second = { along.norm(), 0.0 };
    this->third = { other.dot(this->axes.col(0)), other.dot(this->axes.col(1)) };
  }
  bool hasArea() const { return this->axes.col(2).squaredNorm() > 0.5; }
  double area() const { return this->second[0] * this->third[1]; }
};

// The rotation of a triangle that may be stretched as well: of its normal, and in its plane the nearest one
// to what becomes of both sides. Zero where it is none.
Turn turnOf(const Flat& rest, const Flat& now)
{
  if (!rest.hasArea() || !now.hasArea())
  {
    return Turn(0.0, 0.0, 0.0, 0.0);
  }
  Eigen::Matrix2d from, to;
  from << rest.second, rest.third;
  to << now.second, now.third;
  const Eigen::Matrix2d stretch = to * from.inverse();
  const double angle = std::atan2(stretch(1, 0) - stretch(0, 1), stretch(0, 0) + stretch(1, 1));
  const Turn inPlane(Eigen::AngleAxisd(angle, Vector3::UnitZ()));
  return Turn(now.axes) * inPlane * Turn(rest.axes).conjugate();
}

// Adds to a sum of rotations; a rotation and its negative are the same.
void add(const Turn& turn, double weight, Turn& sum)
{
  sum.coeffs() += (turn.coeffs().dot(sum.coeffs()) < 0.0 ? -weight : weight) * turn.coeffs();
}

Turn unit(const Turn& sum)
{
  const double length = sum.norm();
  return length > 0.0 ? Turn(sum.coeffs() / length) : Turn::Identity();
}

class Motion
{
public:
  Motion(const std::shared_ptr<const Mesh>& rest, const std::vector<Vector3>& now, const Context& context)
    : Rest(*rest)
    , Now(now)
    , Rays(rest, context)
    , Moved(rest->triangles.size())
    , Turns(rest->points.size())
  {
    context.each(rest->triangleCount(),
      [this](int t)
      {
        const Triangle& corners = this->Rest.triangles[t];
        this->Moved[t] = std::any_of(
          corners.begin(), corners.end(), [this](int v) { return this->Rest.points[v] != this->Now[v]; });
      });
    const Lists around = trianglesAround(*rest);
    context.each(rest->vertexCount(), [&](int v) { this->Turns[v] = this->turnAt(around[v]); });
  }

  bool any() const { return std::find(this->Moved.begin(), this->Moved.end(), 1) != this->Moved.end(); }

  Vector3 placeOf(const Vector3& point) const
  {
    const SurfaceHit hit = this->Rays.closest(point);
    if (!hit.found() || !this->Moved[hit.at.triangle])
    {
      return point;
    }
    const Triangle& corners = this->Rest.triangles[hit.at.triangle];
    Vector3 place = Vector3::Zero();
    Turn sum(0.0, 0.0, 0.0, 0.0);
    for (int k = 0; k < 3; ++k)
    {
      place += hit.at.weights[k] * this->Now[corners[k]];
      add(this->Turns[corners[k]], hit.at.weights[k], sum);
    }
    return place + unit(sum) * (point - hit.position);
  }

private:
  // Beside what has not moved nothing turns, so that no gap opens there.
  Turn turnAt(const Lists::Range& triangles) const
  {
    Turn sum(0.0, 0.0, 0.0, 0.0);
    for (const int t : triangles)
    {
      if (!this->Moved[t])
      {
        return Turn::Identity();
      }
      const Flat rest(this->Rest.points, this->Rest.triangles[t]);
      add(turnOf(rest, Flat(this->Now, this->Rest.triangles[t])), rest.area(), sum);
    }
    return unit(sum);
  }

  const Mesh& Rest;
  const std::vector<Vector3>& Now;
  SurfaceRays Rays;
  std::vector<char> Moved; // per triangle
  std::vector<Turn> Turns; // per vertex
};

} // namespace

std::vector<Vector3> transferDetail(const std::shared_ptr<const Mesh>& rest,
  const std::vector<Vector3>& now,
  const std::vector<Vector3>& points,
  const Context& context)
{
  constexpr int block = 65536;
  context.checkpoint(0.0);
  std::vector<Vector3> places = points;
  Context quiet = context; // the tree tells that it is done, which is not all
  quiet.progress = [](double) {};
  const Motion motion(rest, now, quiet);
  const int count = static_cast<int>(motion.any() ? points.size() : 0);
  for (int begin = 0; begin < count; begin += block)
  {
    context.checkpoint(static_cast<double>(begin) / count);
    context.each(
      std::min(block, count - begin), [&](int i) { places[begin + i] = motion.placeOf(points[begin + i]); });
  }
  return places;
}

} // namespace oversketch
