#include "Section/profile.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double pinned = 0.1; // share of the length over which a new profile is drawn to the old one's ends
constexpr double leastTurn = 0.02;
constexpr double leastMove = 1e-12; // of the profile's longer side: less is rounding, and nothing moves

[[noreturn]] void refuse(const Message& what)
{
  throw Error(Failure::BadStroke, what);
}

double smoothStep(double x)
{
  const double c = std::clamp(x, 0.0, 1.0);
  return c * c * (3.0 - 2.0 * c);
}

// The place of the new profile that came from t; of several from the same, the last.
Vector2 partnerOf(const Polyline& drawn, const std::vector<double>& source, double t)
{
  const auto after = std::upper_bound(source.begin(), source.end(), t);
  if (after == source.begin())
  {
    return drawn.front();
  }
  const auto i = static_cast<std::size_t>(after - source.begin()) - 1;
  if (after == source.end() || source[i] == t)
  {
    return drawn[i];
  }
  return drawn[i] + (t - source[i]) / (source[i + 1] - source[i]) * (drawn[i + 1] - drawn[i]);
}

// Whether values grow from left to right of a place, as far about it as it takes to tell.
bool risesAt(const std::vector<double>& values, int place)
{
  const int last = static_cast<int>(values.size()) - 1;
  double difference = 0.0;
  for (int k = 1; k <= last && std::abs(difference) < 0.1; ++k)
  {
    difference = values[std::min(place + k, last)] - values[std::max(place - k, 0)];
  }
  return difference > 0.0;
}

void checkDrawn(const Polyline& drawn, const std::vector<double>& source)
{
  if (drawn.size() < 2 || source.size() != drawn.size())
  {
    refuse("The new profile has fewer than two points; draw a longer one.");
  }
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    const Message point("Point %1 of the new profile", i);
    if (!drawn[i].allFinite())
    {
      refuse({ "%1 is not finite; draw it anew.", point });
    }
    if (!(source[i] >= 0.0 && source[i] <= 1.0))
    {
      refuse({ "%1 comes from a place outside 0 and 1 of the old one; redraw the profile by a re-sketch.",
        point });
    }
    if (i > 0 && source[i] < source[i - 1])
    {
      refuse({ "%1 comes from a place before that of the point before it; redraw the profile by a re-sketch, "
               "which gives them in order.",
        point });
    }
  }
}

} // namespace

FlatProfile ProfileFit::flat(const std::vector<Vector3>& section,
  const std::vector<double>& beside,
  const Vector3& normal,
  const Vector3& outward)
{
  const std::vector<double> along = arcLengths(section);
  const double length = section.empty() ? 0.0 : along.back();
  const Vector3 chord = length > 0.0 ? Vector3(section.back() - section.front()) : Vector3(Vector3::Zero());
  if (!(chord.norm() > 1e-9 * length))
  {
    refuse("The cross-section has no length, or its ends meet; slide the plane along the curve.");
  }
  // Control points at equal lengths.
  const int count = std::clamp(2 * static_cast<int>(section.size()), 32, 1024) + 1;
  std::vector<Vector3> control;
  std::vector<double> controlBeside;
  control.reserve(count);
  controlBeside.reserve(count);
  for (const Blend& place : evenPlaces(along, static_cast<int>(section.size()), count - 1))
  {
    control.push_back(place.of(section));
    controlBeside.push_back(place.of(beside));
  }
  if (static_cast<int>(this->Places.size()) != count)
  {
    const Nurbs spline(count);
    this->Places.clear();
    for (int i = 0; i < count; ++i)
    {
      this->Places.push_back(spline.at(spline.parameterOf(i)));
    }
  }
  std::vector<Vector3> fitted;
  FlatProfile profile;
  for (const SplinePlace& place : this->Places)
  {
    const Vector3 point = place.of(control);
    if (fitted.empty() || point != fitted.back())
    {
      fitted.push_back(point);
      profile.beside.push_back(place.of(controlBeside));
    }
  }
  const std::vector<double> lengths = arcLengths(fitted);
  const Vector3 x = (chord - chord.dot(normal) * normal).normalized(), up = normal.cross(x);
  const Vector3 y = up.dot(outward) < 0.0 ? Vector3(-up) : up;
  for (std::size_t i = 0; i < fitted.size(); ++i)
  {
    const Vector3 step = fitted[i] - fitted.front();
    profile.points.emplace_back(step.dot(x), step.dot(y));
    profile.t.push_back(lengths[i] / lengths.back());
  }
  const double size = boxRound(profile.points).sizes().maxCoeff();
  for (Vector2& point : profile.points)
  {
    point /= size;
  }
  profile.toWorld.col(0).head<3>() = size * x;
  profile.toWorld.col(1).head<3>() = size * y;
  profile.toWorld.col(2).head<3>() = size * x.cross(y);
  profile.toWorld.col(3).head<3>() = fitted.front();
  return profile;
}

ProfileChange::ProfileChange(const FlatProfile& profile,
  const Vector2& middle,
  const Polyline& drawn,
  const std::vector<double>& source)
{
  checkDrawn(drawn, source);
  const int last = static_cast<int>(profile.points.size()) - 1;
  std::vector<Vector2> moves;
  int nearest = 0;
  for (int i = 0; i <= last; ++i)
  {
    const Vector2 move = partnerOf(drawn, source, profile.t[i]) - profile.points[i];
    moves.push_back(move.norm() > leastMove ? move : Vector2(Vector2::Zero()));
    if ((profile.points[i] - middle).squaredNorm() < (profile.points[nearest] - middle).squaredNorm())
    {
      nearest = i;
    }
  }
  const Vector2 first = moves.front(), final = moves.back();
  for (int i = 0; i <= last; ++i)
  {
    moves[i] -= (1.0 - smoothStep(profile.t[i] / pinned)) * first +
                (1.0 - smoothStep((1.0 - profile.t[i]) / pinned)) * final;
    this->Target.push_back(profile.points[i] + moves[i]);
  }

  // To either side as far as `beside` grows.
  const double rises = risesAt(profile.beside, nearest) ? 1.0 : -1.0;
  const auto walk = [&](int step)
  {
    std::vector<int> samples;
    const double sign = rises * step;
    double most = sign * profile.beside[nearest];
    for (int i = nearest + step; i >= 0 && i <= last && sign * profile.beside[i] >= most - leastTurn;
         i += step)
    {
      if (sign * profile.beside[i] > most)
      {
        most = sign * profile.beside[i];
        samples.push_back(i);
      }
    }
    return samples;
  };
  std::vector<int> samples = walk(rises > 0.0 ? -1 : 1);
  std::reverse(samples.begin(), samples.end());
  samples.push_back(nearest);
  for (const int i : walk(rises > 0.0 ? 1 : -1))
  {
    samples.push_back(i);
  }
  for (const int i : samples)
  {
    if (std::abs(profile.beside[i]) < 1.0)
    {
      this->Beside.push_back(profile.beside[i]);
      this->Displacements.push_back(moves[i]);
    }
  }
  this->Beside.insert(this->Beside.begin(), -1.0);
  this->Displacements.insert(this->Displacements.begin(), Vector2::Zero());
  this->Beside.push_back(1.0);
  this->Displacements.emplace_back(Vector2::Zero());
}

Vector2 ProfileChange::at(double beside) const
{
  const auto after = std::upper_bound(this->Beside.begin(), this->Beside.end(), beside);
  if (after == this->Beside.begin() || after == this->Beside.end())
  {
    return Vector2::Zero();
  }
  const auto i = static_cast<std::size_t>(after - this->Beside.begin());
  const double share = (beside - this->Beside[i - 1]) / (this->Beside[i] - this->Beside[i - 1]);
  return this->Displacements[i - 1] + share * (this->Displacements[i] - this->Displacements[i - 1]);
}

} // namespace oversketch
