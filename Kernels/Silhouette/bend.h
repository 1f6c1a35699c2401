// How much a curve bends at a point, and whether that matters. A part of the snake.
#ifndef oversketch_kernels_silhouette_bend_h
#define oversketch_kernels_silhouette_bend_h

#include "Silhouette/curves.h"
#include "Silhouette/edge_smoothness.h"

#include <cmath>

namespace oversketch
{

constexpr double straight = 3.14159265358979323846;
constexpr double leastGain = 1e-4; // [rad] of a relocation

inline double angleOf(double cross, double dot)
{
  return cross == 0.0 && dot == 0.0 ? 0.0 : std::atan2(cross, dot);
}

inline double angleBetween(const Vector3& a, const Vector3& b)
{
  return angleOf(a.cross(b).norm(), a.dot(b));
}

// Bend: what E_smth of a point lacks to pi. Most questions to it need no arc tangent; whether they do is
// decided far outside of rounding errors, so the answers are those of angle().
class Bend
{
public:
  static constexpr double nothing = 1e-7; // [rad]

  Bend(const Triple& before, const Triple& at, const Triple& normal, const Triple& after)
  {
    const Triple toBefore = before - at, toAfter = after - at;
    const Triple a = toBefore - normal.dot(toBefore) * normal, b = toAfter - normal.dot(toAfter) * normal;
    this->Cross = a.cross(b).norm();
    this->Dot = a.dot(b);
  }
  Bend(const CurvePoint& before, const CurvePoint& at, const CurvePoint& after)
    : Bend(Triple(before.position), Triple(at.position), Triple(at.normal), Triple(after.position))
  {
  }

  double smoothness() const { return angleOf(this->Cross, this->Dot); }
  double angle() const { return straight - this->smoothness(); }

  bool matters() const
  {
    constexpr double margin = 1e-6; // the tangent of leastGain is itself to 1e-8
    if (this->Dot >= 0.0 || this->Cross > -this->Dot * leastGain * (1.0 + margin))
    {
      return true;
    }
    return this->Cross >= -this->Dot * leastGain * (1.0 - margin) && this->angle() > leastGain;
  }

  // Whether it is larger than another by more than leastGain.
  bool matters(const Bend& other) const
  {
    if (other.isNone() && (this->Dot >= 0.0 || this->Cross > -this->Dot * (leastGain + 2.0 * nothing)))
    {
      return true;
    }
    return !(other.angle() >= this->angle() - leastGain);
  }

  bool isNone() const { return this->Dot < 0.0 && this->Cross < -this->Dot * nothing; }

private:
  double Cross, Dot;
};

} // namespace oversketch
#endif
