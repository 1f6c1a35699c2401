#include "Pose/bone.h"

#include "Ray/projection.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace oversketch
{

namespace
{

constexpr double stepPixels = 6.0;
constexpr int fewestSteps = 2, mostSteps = 48;
constexpr int depthRounds = 8;

struct Steps
{
  Polyline places;
  bool onLine = true; // all of them
};

Steps stepsOn(const Polyline& line, const std::vector<double>& steps, double scale)
{
  Steps made;
  made.places.push_back(line.front());
  std::size_t next = 1; // the first point of the line beyond the last place
  for (const double given : steps)
  {
    const double step = scale * given;
    const Vector2 from = made.places.back();
    while (next < line.size() && (line[next] - from).norm() < step)
    {
      ++next;
    }
    if (next == line.size())
    {
      const Vector2 rest = line.back() - from;
      const std::size_t count = made.places.size();
      const bool leads = made.onLine && rest.norm() > 0.25 * step; // else it says little of the direction
      const Vector2 on = leads || count < 2 ? rest : Vector2(from - made.places[count - 2]);
      made.onLine = false;
      made.places.push_back(from + step * on.normalized());
      continue;
    }
    const Vector2 begin = line[next - 1] - from, way = line[next] - line[next - 1];
    const double square = way.squaredNorm(), half = begin.dot(way);
    const double root = std::sqrt(std::max(0.0, half * half - square * (begin.squaredNorm() - step * step)));
    const double share = square > 0.0 ? std::clamp((root - half) / square, 0.0, 1.0) : 1.0;
    made.places.push_back(line[next - 1] + share * way);
  }
  return made;
}

struct Crossing
{
  SurfaceHit entry, exit;
};

// Finds where a ray enters the model first, and where it leaves what it has entered.
std::optional<Crossing> crossingOf(const SurfaceRays& surface, const Ray& ray)
{
  Crossing found;
  const double together = 1e-9 * surface.diagonal(); // both triangles at an edge
  int depth = 0;
  bool facesAway = false, lastIsEntry = false; // of a mesh turned inside out all triangles do
  double last = 0.0;
  for (const SurfaceHit& hit : surface.all(ray))
  {
    const double side = facetNormal(surface.mesh(), hit.at.triangle).dot(ray.direction);
    if (hit.distance < 0.0 || side == 0.0)
    {
      continue;
    }
    if (!found.entry.found())
    {
      facesAway = side > 0.0;
    }
    const bool isEntry = (side > 0.0) == facesAway;
    if (found.entry.found() && isEntry == lastIsEntry && hit.distance - last <= together)
    {
      continue;
    }
    lastIsEntry = isEntry;
    last = hit.distance;
    found.entry = found.entry.found() ? found.entry : hit;
    depth += isEntry ? 1 : -1;
    if (depth == 0)
    {
      found.exit = hit;
      return found;
    }
  }
  return std::nullopt;
}

// Values without spikes, where other parts cross a limb, and smooth; the first and the last one stay.
void smooth(std::vector<double>& values)
{
  const int count = static_cast<int>(values.size());
  const std::vector<double> rough = values;
  for (int i = 0; i < count; ++i)
  {
    const int reach = std::min({ 2, i, count - 1 - i });
    std::vector<double> near(rough.begin() + i - reach, rough.begin() + i + reach + 1);
    std::nth_element(near.begin(), near.begin() + reach, near.end());
    values[i] = near[reach];
  }
  for (int round = 0; round < depthRounds; ++round)
  {
    const std::vector<double> before = values;
    for (int i = 1; i + 1 < count; ++i)
    {
      values[i] = 0.25 * before[i - 1] + 0.5 * before[i] + 0.25 * before[i + 1];
    }
  }
}

// The normal of the plane at the joint: it holds the line of sight, so that it cuts the limb where the bone
// begins in front and behind, and is across the bone in the picture.
Vector3 acrossOf(const Bone& bone, const View& view)
{
  std::size_t k = 1;
  while (k + 1 < bone.places.size() && bone.along[k] < 0.5 * bone.thickness.front())
  {
    ++k;
  }
  const Vector3 sight = view.towardsViewer(bone.places.front()).normalized();
  const Vector3 direction = bone.places[k] - bone.places.front();
  return (direction - direction.dot(sight) * sight).normalized();
}

} // namespace

Polyline stepped(const Polyline& line, const std::vector<double>& steps)
{
  return stepsOn(line, steps, 1.0).places;
}

double scaleToEnd(const Polyline& line, const std::vector<double>& steps)
{
  double sum = 0.0;
  for (const double step : steps)
  {
    sum += step;
  }
  double least = 0.0, most = arcLengths(line).back() / sum;
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (least + most);
    (stepsOn(line, steps, middle).onLine ? least : most) = middle;
  }
  return least;
}

Bone boneUnder(const SurfaceRays& surface, const View& view, const Polyline& line, const Context& context)
{
  const int count =
    std::clamp(static_cast<int>(std::lround(arcLengths(line).back() / stepPixels)), fewestSteps, mostSteps);
  const std::vector<double> even(static_cast<std::size_t>(count), 1.0);
  const Polyline places = stepsOn(line, even, scaleToEnd(line, even)).places;
  std::vector<std::optional<Crossing>> crossings(places.size());
  context.eachUntilCancelled(static_cast<int>(places.size()),
    [&](int i) { crossings[i] = crossingOf(surface, lineOfSight(view, places[i], surface)); });
  context.checkpoint(0.2);
  std::vector<int> met;
  for (int i = 0; i <= count; ++i)
  {
    if (crossings[i])
    {
      met.push_back(i);
    }
  }
  if (met.size() < 2)
  {
    throw Error(Failure::BadStroke,
      "The bone lies beside the model, or over a part of it that has no back; draw it along a limb, from the "
      "joint that stays to the tip.");
  }
  Bone bone;
  bone.beside = 1.0 - static_cast<double>(met.back() - met.front()) / count;
  bone.joint = { crossings[met.front()]->entry.at.triangle, crossings[met.front()]->exit.at.triangle };
  std::vector<double> depths;
  for (std::size_t k = 0; k < met.size(); ++k)
  {
    const Crossing& crossing = *crossings[met[k]];
    const double depth = view.depth(0.5 * (crossing.entry.position + crossing.exit.position));
    const double thickness = crossing.exit.distance - crossing.entry.distance;
    for (int i = k == 0 ? met[k] : met[k - 1] + 1; i < met[k]; ++i)
    {
      const double share = 1.0 / (met[k] - i + 1);
      depths.push_back(depths.back() + share * (depth - depths.back()));
      bone.thickness.push_back(bone.thickness.back() + share * (thickness - bone.thickness.back()));
    }
    depths.push_back(depth);
    bone.thickness.push_back(thickness);
    bone.seen.push_back(crossing.entry.position);
  }
  smooth(depths);
  smooth(bone.thickness);
  for (std::size_t i = 0; i < depths.size(); ++i)
  {
    bone.places.push_back(view.toWorld(places[met.front() + i], depths[i]));
  }
  bone.along = arcLengths(bone.places);
  bone.across = acrossOf(bone, view);
  return bone;
}

} // namespace oversketch
