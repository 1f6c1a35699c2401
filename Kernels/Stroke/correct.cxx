#include "Stroke/correct.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

// A closed curve by its length from the first point on.
struct Ring
{
  const Polyline& points;
  std::vector<double> lengths;

  explicit Ring(const Polyline& curve)
    : points(curve)
    , lengths(arcLengths(curve, true))
  {
  }
  int count() const { return static_cast<int>(this->points.size()); }
  double length() const { return this->lengths.back(); }
  // The places nearest to the points of another curve.
  std::vector<double> feet(const Polyline& other) const
  {
    const NearestPlace nearest(this->points, true);
    return mapped(other, [&](const Vector2& point) { return nearest(point).along(this->lengths); });
  }
  // How far round the other curve has come at each of its points: the way from foot to foot, each time the
  // shorter one, negative against the curve's direction.
  std::vector<double> travel(const std::vector<double>& feet) const
  {
    std::vector<double> way{ 0.0 };
    for (std::size_t i = 1; i < feet.size(); ++i)
    {
      way.push_back(way.back() + std::remainder(feet[i] - feet[i - 1], this->length()));
    }
    return way;
  }
  Vector2 at(double place) const
  {
    const double wrapped = place >= this->length() ? place - this->length() : place;
    return placeAt(this->lengths, this->count(), wrapped).of(this->points);
  }
  // Length of the arc from one place on to another, passing the start where it lies between.
  double span(double from, double to) const { return to >= from ? to - from : to - from + this->length(); }
  double meanDistance(double from, double to, const NearestPlace& other) const
  {
    const double whole = this->span(from, to);
    const int steps = 64;
    double sum = 0.0;
    for (int i = 0; i <= steps; ++i)
    {
      sum += other(this->at(from + whole * i / steps)).distance;
    }
    return sum / (steps + 1);
  }
  // The sample on the arc that is nearest to its middle; -1 when none lies inside it.
  int middle(double from, double to) const
  {
    const double whole = this->span(from, to);
    int best = -1;
    double least = 0.5 * whole;
    for (int i = 0; i < this->count(); ++i)
    {
      const double along = this->span(from, this->lengths[i]);
      if (along < whole && std::abs(along - 0.5 * whole) < least)
      {
        least = std::abs(along - 0.5 * whole);
        best = i;
      }
    }
    return best;
  }
};

// A curve drawn all the way round another one, without what it goes over twice, in that one's direction.
Resketched onceRound(const Polyline& fresh, const std::vector<double>& travel, double length)
{
  const auto end = std::find_if(
    travel.begin() + 1, travel.end(), [&](double way) { return std::abs(way) >= length * (1.0 - 1e-9); });
  Resketched result = unchanged(Polyline(fresh.begin(), fresh.begin() + (end - travel.begin())), true);
  if (travel.back() < 0.0)
  {
    std::reverse(result.points.begin(), result.points.end());
    std::reverse(result.origins.begin(), result.origins.end());
  }
  return result;
}

// The open part of a curve that stays, up to a place, as a curve of its own: the rest of it is what a stroke
// with one end near replaces.
Resketched extended(const Polyline& old, const Polyline& fresh, bool fromFront, const ResketchRules& rules)
{
  const NearestPlace nearest(old);
  const NearestPlace::Answer foot = nearest(fromFront ? fresh.front() : fresh.back());
  const std::vector<double> lengths = arcLengths(old);
  const double place = foot.along(lengths);
  const Vector2 away = fromFront ? fresh.back() : fresh.front();
  const bool atBack = (old.back() - away).norm() <= (old.front() - away).norm();
  // Drawn and old curve are walked so that the new end comes last.
  Polyline before = old, after = fresh;
  if (!atBack)
  {
    std::reverse(before.begin(), before.end());
  }
  if (!fromFront)
  {
    std::reverse(after.begin(), after.end());
  }
  const int oldCount = static_cast<int>(old.size()), freshCount = static_cast<int>(fresh.size());
  const double cut = atBack ? place : lengths.back() - place;
  const std::vector<double> walked = arcLengths(before);
  Polyline kept;
  for (int i = 0; i < oldCount && walked[i] < cut; ++i)
  {
    kept.push_back(before[i]);
  }
  const Blend end = placeAt(walked, oldCount, cut);
  kept.push_back(end.of(before));
  const int keptCount = static_cast<int>(kept.size());
  // The foot is the kept part's end, so that the new curve extends it.
  Resketched result = continued(kept, after, rules);
  const auto mirrored = [](Blend& blend, int count)
  {
    blend.from = count - 1 - blend.from;
    blend.to = count - 1 - blend.to;
  };
  for (Origin& origin : result.origins)
  {
    // A place on the kept part's last segment is one on the old segment that was cut.
    Blend& at = origin.before;
    if (std::max(at.from, at.to) == keptCount - 1 && keptCount > 1)
    {
      const double start = walked[keptCount - 2];
      const double t = at.from == at.to ? 1.0 : at.t;
      at = placeAt(walked, oldCount, start + t * (cut - start));
    }
    if (!atBack)
    {
      mirrored(at, oldCount);
    }
    if (!fromFront)
    {
      mirrored(origin.after, freshCount);
    }
  }
  if (!atBack)
  {
    std::reverse(result.points.begin(), result.points.end());
    std::reverse(result.origins.begin(), result.origins.end());
  }
  return result;
}

} // namespace

Resketched resketchClosed(const Polyline& old, const Polyline& fresh, const ResketchRules& rules)
{
  if (!differs(old) || !differs(fresh))
  {
    return unchanged(old, false);
  }
  const Ring ring(old);
  const std::vector<double> feet = ring.feet(fresh), travel = ring.travel(feet);
  double from = feet.front(), to = feet.back();
  if (std::abs(travel.back()) >= ring.length() * (1.0 - 1e-9))
  {
    return onceRound(fresh, travel, ring.length());
  }
  if (from == to)
  {
    return unchanged(old, false);
  }
  // Both arcs are near a curve that goes most of the way round: it goes over one of them.
  const NearestPlace nearFresh(fresh);
  const bool most = std::abs(travel.back()) >= 0.5 * ring.length();
  if (most ? travel.back() < 0.0
           : ring.meanDistance(from, to, nearFresh) > ring.meanDistance(to, from, nearFresh))
  {
    std::swap(from, to);
  }
  // From `from` to `to` in the old curve's direction is replaced; what is kept is opened in its middle.
  const int seam = ring.middle(to, from);
  if (seam < 0)
  {
    return unchanged(fresh, true);
  }
  const int count = ring.count();
  Polyline opened(old.begin() + seam, old.end());
  opened.insert(opened.end(), old.begin(), old.begin() + seam + 1);
  const double start = ring.lengths[seam];
  const double first = ring.span(start, from), last = ring.span(start, to), whole = ring.length();
  // resketch drops a blend that would begin before the curve does, so the reach is what the seam leaves room
  // for.
  const NearestPlace nearOld(old, true);
  const double farthest = std::max(nearOld(fresh.front()).distance, nearOld(fresh.back()).distance);
  const double room = std::min(first, whole - last) * (1.0 - 1e-9);
  ResketchRules fitting = rules;
  if (farthest > 0.0)
  {
    fitting.reach = std::min(rules.reach, room / farthest);
  }
  Resketched result = resketch(opened, fresh, fitting);
  // The seam's sample is there twice.
  result.points.pop_back();
  result.origins.pop_back();
  const int size = static_cast<int>(result.points.size());
  int begin = 0;
  for (int i = 0; i < size; ++i)
  {
    Origin& origin = result.origins[i];
    origin.before.from = (origin.before.from + seam) % count;
    origin.before.to = (origin.before.to + seam) % count;
    if (origin.weight == 0.0 && origin.before.from == 0 && origin.before.to == 0)
    {
      begin = i;
    }
  }
  std::rotate(result.points.begin(), result.points.begin() + begin, result.points.end());
  std::rotate(result.origins.begin(), result.origins.begin() + begin, result.origins.end());
  return result;
}

Correction corrected(const std::vector<CanvasStroke>& strokes,
  const Polyline& fresh,
  double radius,
  double spacing)
{
  if (!allFinite(fresh) || !differs(fresh))
  {
    throw Error(Failure::BadStroke, "a correction needs two distinct points, all finite; draw a longer one");
  }
  ResketchRules rules;
  rules.spacing = spacing;
  Correction answer;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    if (strokes[i].points.size() < 2)
    {
      continue;
    }
    const double mean = NearestPlace(strokes[i].points, strokes[i].closed).meanDistance(fresh);
    if (mean < least)
    {
      least = mean;
      answer.stroke = static_cast<int>(i);
    }
  }
  if (answer.stroke < 0)
  {
    return answer;
  }
  const CanvasStroke& stroke = strokes[answer.stroke];
  const NearestPlace nearest(stroke.points, stroke.closed);
  const bool front = nearest(fresh.front()).distance <= radius;
  const bool back = nearest(fresh.back()).distance <= radius;
  if (front && back)
  {
    answer.kind = Correction::Replacement;
    answer.result =
      stroke.closed ? resketchClosed(stroke.points, fresh, rules) : resketch(stroke.points, fresh, rules);
  }
  else if ((front || back) && !stroke.closed)
  {
    answer.kind = Correction::Extension;
    answer.result = extended(stroke.points, fresh, front, rules);
  }
  else
  {
    answer.stroke = -1;
  }
  return answer;
}

} // namespace oversketch
