#include "Pose/pose.h"

#include "Mesh/context.h"
#include "Mesh/shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double still = 1e-7;    // an angle, or a share of a length
constexpr double leastBone = 5.0; // px: a shorter one has no direction in the picture
constexpr double degrees = 180.0 / static_cast<double>(EIGEN_PI);

// A turn of what lies beyond a place of the bone.
struct Turn
{
  Vector2 centre;              // in the plane of the picture, from the joint [model length]
  double angle;                // to the left
  double begin, width, middle; // lengths along the bone; the share of the width up to the place

  // The share of the angle at a length along the bone: its slope is even round the place, and falls to 0 over
  // the last two fifths of the way to either end. A steeper one folds the inside of a right angle, a longer
  // even one thins the limb.
  double shareAt(double along) const
  {
    constexpr double slope = 1.25;
    const double x = (along - this->begin) / this->width;
    const double rise = 0.4 * this->middle, fall = 0.4 * (1.0 - this->middle);
    if (!(x > 0.0))
    {
      return 0.0;
    }
    if (x >= 1.0)
    {
      return 1.0;
    }
    if (x < rise)
    {
      return slope * x * x / (2.0 * rise);
    }
    return x > 1.0 - fall ? 1.0 - slope * (1.0 - x) * (1.0 - x) / (2.0 * fall) : slope * (x - 0.5 * rise);
  }
};

// Moves a line's begin to a place; the rest less and less, its end not.
Polyline begunAt(const Polyline& line, const Vector2& place)
{
  const std::vector<double> lengths = arcLengths(line);
  Polyline moved;
  for (std::size_t i = 0; i < line.size(); ++i)
  {
    moved.push_back(line[i] + (1.0 - lengths[i] / lengths.back()) * (place - line.front()));
  }
  return moved;
}

Polyline seenFrom(const View& view, const std::vector<Vector3>& places)
{
  Polyline seen;
  for (const Vector3& place : places)
  {
    if (!view.inFront(place))
    {
      throw Error(Failure::BadStroke,
        "The bone lies behind the eye in the view of its new course; draw that where the bone is seen.");
    }
    seen.push_back(view.toDisplay(place).head<2>());
  }
  return seen;
}

std::vector<double> stepsOf(const Polyline& line)
{
  std::vector<double> steps;
  for (std::size_t i = 1; i < line.size(); ++i)
  {
    steps.push_back((line[i] - line[i - 1]).norm());
  }
  return steps;
}

// The angles by which a line bends more than another at each of its places but the last; at the first, that
// between both.
std::vector<double> anglesBetween(const Polyline& from, const Polyline& to)
{
  const auto step = [](const Polyline& line, std::size_t i) { return Vector2(line[i + 1] - line[i]); };
  std::vector<double> angles{ turnAngle(step(from, 0), step(to, 0)) };
  for (std::size_t i = 1; i + 1 < from.size(); ++i)
  {
    angles.push_back(turnAngle(step(to, i - 1), step(to, i)) - turnAngle(step(from, i - 1), step(from, i)));
  }
  return angles;
}

} // namespace

Posed posed(const std::vector<Vector3>& points,
  const Limb& limb,
  const Bone& bone,
  const View& view,
  const Polyline& course,
  const PoseOptions& options,
  const Context& context)
{
  const Polyline seen = seenFrom(view, bone.places);
  std::vector<double> steps = stepsOf(seen);
  if (!(arcLengths(seen).back() >= leastBone))
  {
    throw Error(Failure::BadStroke,
      "The bone is seen from its end in the view of its new course; turn the model, and draw that again.");
  }
  const Polyline line = begunAt(course, seen.front());
  double scale = options.stretch ? scaleToEnd(line, steps) : 1.0;
  scale = std::abs(scale - 1.0) > still ? scale : 1.0;
  for (double& step : steps)
  {
    step *= scale;
  }
  const std::vector<double> angles = anglesBetween(seen, stepped(line, steps));

  // The plane of the picture: the rows of the view, made orthonormal.
  const Vector3 joint = bone.places.front(), outward = view.normal();
  const Vector3 row = view.viewTransform().row(0).head<3>().transpose();
  const Vector3 right = (row - row.dot(outward) * outward).normalized(), up = outward.cross(right);
  const auto flat = [&](const Vector3& p) { return Vector2(right.dot(p - joint), up.dot(p - joint)); };

  Posed result;
  const double whole = bone.along.back();
  std::vector<Turn> turns; // of the tip first
  double sum = 0.0;
  for (std::size_t i = 0; i < angles.size(); ++i)
  {
    sum += angles[i];
    result.bend = std::max(result.bend, std::abs(sum) * degrees);
    result.joints += std::abs(angles[i]) * degrees > 1.0;
    if (std::abs(angles[i]) <= still)
    {
      continue;
    }
    const double thickness = std::max(bone.thickness[i], 0.5 * bone.thickness.front());
    const double width = std::min(options.softness * thickness, whole);
    const double begin = std::clamp(bone.along[i] - 0.5 * width, 0.0, whole - width);
    turns.insert(turns.begin(),
      { flat(joint + scale * (bone.places[i] - joint)),
        angles[i],
        begin,
        width,
        std::clamp((bone.along[i] - begin) / width, 0.0, 1.0) });
  }

  result.places = points;
  context.each(static_cast<int>(points.size()),
    [&](int i)
    {
      const double along = limb.parameter[i];
      Vector3& p = result.places[i];
      if (scale != 1.0 && along > 0.0)
      {
        const Blend at = placeAt(bone.along, static_cast<int>(bone.places.size()), along);
        p += (scale - 1.0) * (at.of(bone.places) - joint);
      }
      const Vector2 before = flat(p);
      Vector2 after = before;
      for (const Turn& turn : turns)
      {
        if (const double share = turn.shareAt(along); share > 0.0)
        {
          after = turn.centre + Eigen::Rotation2Dd(share * turn.angle) * (after - turn.centre);
        }
      }
      if (after != before)
      {
        p += (after - before)[0] * right + (after - before)[1] * up;
      }
    });
  context.checkpoint(1.0);
  return result;
}

} // namespace oversketch
