#include "Stroke/resketch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace oversketch
{
namespace
{

Blend reversed(const Blend& place, int count)
{
  return { count - 1 - place.from, count - 1 - place.to, place.t };
}

// A curve with its lengths, walked in either direction.
struct Walk
{
  Polyline points;
  std::vector<double> lengths;

  explicit Walk(Polyline curve)
    : points(std::move(curve))
    , lengths(arcLengths(this->points))
  {
  }
  int count() const { return static_cast<int>(this->points.size()); }
  double length() const { return this->lengths.back(); }
  Blend at(double length) const { return placeAt(this->lengths, this->count(), length); }
  // The step in which the curve arrives at a length; in which it leaves where there is nothing before.
  Vector2 arriving(double length) const
  {
    const Vector2 here = this->at(length).of(this->points);
    for (int i = this->count() - 1; i >= 0; --i)
    {
      if (this->lengths[i] < length && this->points[i] != here)
      {
        return here - this->points[i];
      }
    }
    return this->leaving();
  }
  Vector2 leaving() const
  {
    const auto other = std::find_if(
      this->points.begin(), this->points.end(), [&](const Vector2& p) { return p != this->points.front(); });
    return *other - this->points.front();
  }
  double nearest(const Vector2& to) const { return NearestPlace(this->points)(to).along(this->lengths); }
};

// Part before the new curve: the old one up to S', then the run into the new one's first point, which
// is left out. `place` is S in px along the old curve.
Resketched lead(const Walk& old, const Walk& fresh, double place, const ResketchRules& rules)
{
  Resketched result;
  const auto add = [&](const Vector2& point, const Origin& origin)
  {
    result.points.push_back(point);
    result.origins.push_back(origin);
  };
  const Vector2 end = fresh.points.front();
  const double start = place - rules.reach * (old.at(place).of(old.points) - end).norm();
  if (start < 0.0)
  {
    return result;
  }
  for (int i = 0; i < old.count() && old.lengths[i] < start; ++i)
  {
    add(old.points[i], { Blend::point(i), Blend::point(0), 0.0 });
  }
  if (start == place)
  {
    return result;
  }
  const Vector2 from = old.at(start).of(old.points);
  const double chord = (end - from).norm();
  Vector2 t0 = old.arriving(start), t1 = fresh.leaving();
  if (!rules.rawTangents)
  {
    t0 = chord * t0.normalized();
    t1 = chord * t1.normalized();
  }
  const int steps = std::max(2, static_cast<int>(std::ceil(std::max(chord, place - start) / rules.spacing)));
  for (int i = 0; i < steps; ++i)
  {
    const double u = static_cast<double>(i) / steps, u2 = u * u, u3 = u2 * u;
    const double c = 3.0 * u2 - 2.0 * u3;
    const Vector2 hermite = (1.0 - c) * from + (u3 - 2.0 * u2 + u) * t0 + c * end + (u3 - u2) * t1;
    const Blend before = old.at(start + u * (place - start));
    add((1.0 - c) * before.of(old.points) + c * hermite, { before, Blend::point(0), c });
  }
  return result;
}

// The new curve between the ways in and out, which takes the place of the old one's part from one length to
// another.
void addMiddle(const Walk& old,
  const Walk& fresh,
  double from,
  double to,
  ResketchRules::Middle middle,
  Resketched& result)
{
  const auto add = [&](const Blend& place, const Blend& at)
  {
    result.points.push_back(at.of(fresh.points));
    result.origins.push_back({ place, at, 1.0 });
  };
  const int last = fresh.count() - 1;
  if (middle == ResketchRules::Middle::ArcLength)
  {
    for (int i = 0; i <= last; ++i)
    {
      add(old.at(from + fresh.lengths[i] / fresh.length() * (to - from)), Blend::point(i));
    }
    return;
  }
  add(old.at(from), Blend::point(0));
  const NearestPlace nearest(fresh.points);
  for (int i = 0; i < old.count(); ++i)
  {
    if (old.lengths[i] > from && old.lengths[i] < to)
    {
      const NearestPlace::Answer answer = nearest(old.points[i]);
      add(Blend::point(i), { answer.segment, answer.segment + 1, answer.t });
    }
  }
  add(old.at(to), Blend::point(last));
}

// The share of the curve's length at a place between two neighbours, in whichever order they are named.
double shareAt(const Blend& place, const std::vector<double>& lengths)
{
  // A closed curve's first sample is also the one after the last.
  const bool wraps = std::abs(place.from - place.to) > 1;
  const std::size_t end = lengths.size() - 1;
  const double from = lengths[wraps && place.from == 0 ? end : static_cast<std::size_t>(place.from)];
  const double to = lengths[wraps && place.to == 0 ? end : static_cast<std::size_t>(place.to)];
  return ((1.0 - place.t) * from + place.t * to) / lengths.back();
}

} // namespace

Resketched unchanged(const Polyline& points, bool isFresh)
{
  Resketched result{ points, {} };
  for (int i = 0; i < static_cast<int>(points.size()); ++i)
  {
    const Blend place = Blend::point(i), none = Blend::point(0);
    result.origins.push_back(isFresh ? Origin{ none, place, 1.0 } : Origin{ place, none, 0.0 });
  }
  return result;
}

Resketched resketch(const Polyline& old, const Polyline& fresh, const ResketchRules& rules)
{
  if (!differs(old) || !differs(fresh))
  {
    return unchanged(old, false);
  }
  const Walk before(old);
  const double length = before.length();
  double s = before.nearest(fresh.front()), e = before.nearest(fresh.back());
  const bool atEnd = s == e && (s == 0.0 || s == length);
  if (s == e && !atEnd)
  {
    return unchanged(old, false);
  }
  const auto gap = [&](const Vector2& p, double place) { return (before.at(place).of(old) - p).norm(); };
  // An extension has its nearer end at the old curve.
  const bool nearerFirst = gap(fresh.front(), s) <= gap(fresh.back(), e);
  const bool turned = atEnd ? nearerFirst != (s == length) : s > e;
  Polyline drawn = fresh;
  if (turned)
  {
    std::reverse(drawn.begin(), drawn.end());
    std::swap(s, e);
  }
  const Walk after(drawn);
  const int oldCount = before.count(), freshCount = after.count();

  // The way out is the way in, walked from the other end.
  const Walk oldBack(Polyline(old.rbegin(), old.rend())), freshBack(Polyline(drawn.rbegin(), drawn.rend()));
  const Resketched out = lead(oldBack, freshBack, length - e, rules);
  Resketched result = lead(before, after, s, rules);
  // Without a way in the new curve takes the old one's place from its start on.
  const double from = result.points.empty() ? 0.0 : s, to = out.points.empty() ? length : e;
  addMiddle(before, after, from, to, rules.middle, result);
  for (int i = static_cast<int>(out.points.size()) - 1; i >= 0; --i)
  {
    const Origin& origin = out.origins[i];
    result.points.push_back(out.points[i]);
    result.origins.push_back(
      { reversed(origin.before, oldCount), reversed(origin.after, freshCount), origin.weight });
  }
  if (turned)
  {
    for (Origin& origin : result.origins)
    {
      origin.after = reversed(origin.after, freshCount);
    }
  }
  return result;
}

Resketched continued(const Polyline& old, const Polyline& fresh, const ResketchRules& rules)
{
  Resketched result;
  if (differs(old) && differs(fresh))
  {
    const Walk before(old), after(fresh);
    const double gap = (old.back() - fresh.front()).norm();
    // A blend that began before the curve would be left out.
    ResketchRules fitting = rules;
    if (gap > 0.0)
    {
      fitting.reach = std::min(rules.reach, before.length() / gap * (1.0 - 1e-9));
    }
    result = lead(before, after, before.length(), fitting);
  }
  const Resketched rest = unchanged(fresh, true);
  result.points.insert(result.points.end(), rest.points.begin(), rest.points.end());
  result.origins.insert(result.origins.end(), rest.origins.begin(), rest.origins.end());
  return result;
}

std::vector<double> sourcesOf(const std::vector<Origin>& origins, const Polyline& old, bool closed)
{
  const std::vector<double> lengths = arcLengths(old, closed);
  std::vector<double> sources;
  sources.reserve(origins.size());
  for (const Origin& origin : origins)
  {
    const double share = shareAt(origin.before, lengths);
    // The way out is measured from the other end: where it begins, the last bits may fall behind the
    // middle's.
    sources.push_back(closed || sources.empty() ? share : std::max(share, sources.back()));
  }
  return sources;
}

} // namespace oversketch
