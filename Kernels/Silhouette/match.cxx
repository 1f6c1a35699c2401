#include "Silhouette/match.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace oversketch
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

// The places from one point of a polyline to another, in its own direction; a closed one may pass its first
// point.
std::vector<Blend> placesBetween(const MatchCandidate& candidate,
  const NearestPlace::Answer& from,
  const NearestPlace::Answer& to)
{
  const int count = static_cast<int>(candidate.display.size());
  const auto next = [count](int i) { return (i + 1) % count; };
  std::vector<Blend> places{ { from.segment, next(from.segment), from.t } };
  const bool wraps =
    candidate.closed && (to.segment < from.segment || (to.segment == from.segment && to.t < from.t));
  const int points = to.segment - from.segment + (wraps ? count : 0);
  for (int k = 1; k <= points; ++k)
  {
    places.push_back(Blend::point((from.segment + k) % count));
  }
  places.push_back({ to.segment, next(to.segment), to.t });
  // An end that falls on a point of the curve is that point, binding and all.
  constexpr double same = 1e-6; // px
  for (const bool first : { true, false })
  {
    Blend& end = first ? places.front() : places.back();
    const Vector2 at = end.of(candidate.display);
    for (const int point : { end.from, end.to })
    {
      if ((candidate.display[point] - at).norm() <= same)
      {
        end = Blend::point(point);
        const Blend& inner = first ? places[1] : places[places.size() - 2];
        if (places.size() > 2 && inner.from == point && inner.to == point)
        {
          places.erase(first ? places.begin() : places.end() - 1);
        }
        break;
      }
    }
  }
  return places;
}

Polyline displayOf(const MatchCandidate& candidate, const std::vector<Blend>& places)
{
  Polyline points;
  for (const Blend& place : places)
  {
    points.push_back(place.of(candidate.display));
  }
  return points;
}

// True where most of the polyline runs along one of the outlines.
bool runsAlong(const Polyline& samples, const std::vector<NearestPlace>& outlines)
{
  constexpr double near = 3.0;  // px, as far as silhouette points are attached to an outline
  constexpr double share = 0.8; // the rest may leave it, towards a cusp inside the picture
  int along = 0;
  for (const Vector2& p : samples)
  {
    along += std::any_of(outlines.begin(),
      outlines.end(),
      [&](const NearestPlace& outline) { return outline(p, near).segment >= 0; });
  }
  return along >= share * static_cast<double>(samples.size());
}

} // namespace

MatchedSection matchStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const MatchRules& rules,
  const Context& context)
{
  const Polyline samples = uniformPolyline(stroke, rules.spacing);
  const NearestPlace onStroke(samples);
  std::vector<NearestPlace> outlines;
  for (const MatchCandidate& candidate : candidates)
  {
    if (candidate.outline)
    {
      outlines.emplace_back(candidate.display, candidate.closed);
    }
  }
  MatchedSection best, shadowed; // shadowed: the best of those left to an outline, should no outline qualify
  best.score = shadowed.score = infinity;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    context.checkpoint(static_cast<double>(c) / static_cast<double>(candidates.size()));
    const MatchCandidate& candidate = candidates[c];
    if (candidate.display.size() < 2)
    {
      continue;
    }
    const NearestPlace onCandidate(candidate.display, candidate.closed);
    const NearestPlace::Answer start = onCandidate(samples.front()), end = onCandidate(samples.back());
    const double gaps = 0.5 * (start.distance + end.distance);
    if (rules.amendedScore && gaps >= std::max(best.score, outlines.empty() ? 0.0 : shadowed.score))
    {
      continue;
    }
    const double distance = onCandidate.meanDistance(samples);
    // As published, D chooses the candidate; only its own two arcs compete on the way back.
    if (!rules.amendedScore && distance >= best.score)
    {
      continue;
    }
    const bool inOrder = start.segment < end.segment || (start.segment == end.segment && start.t <= end.t);
    double leastBack = infinity;
    for (const bool forward : { true, false })
    {
      if (!candidate.closed && forward != inOrder)
      {
        continue;
      }
      std::vector<Blend> places =
        forward ? placesBetween(candidate, start, end) : placesBetween(candidate, end, start);
      if (!forward)
      {
        std::reverse(places.begin(), places.end());
      }
      const Polyline section = displayOf(candidate, places);
      const auto bound = std::count_if(places.begin(),
        places.end(),
        [&](const Blend& place) { return place.from == place.to && candidate.bound[place.from]; });
      if (bound < 2 || arcLengths(section).back() < rules.spacing)
      {
        continue;
      }
      const Polyline sectionSamples = uniformPolyline(section, rules.spacing);
      const double back = onStroke.meanDistance(sectionSamples);
      MatchedSection match{ static_cast<int>(c), std::move(places), distance, distance };
      if (!rules.amendedScore)
      {
        if (back < leastBack)
        {
          leastBack = back;
          best = std::move(match);
        }
        continue;
      }
      match.score = NearestPlace(section).meanDistance(samples) + back + gaps;
      const bool left = !candidate.outline && !outlines.empty() && runsAlong(sectionSamples, outlines);
      MatchedSection& rival = left ? shadowed : best;
      if (match.score < rival.score)
      {
        rival = std::move(match);
      }
    }
  }
  context.checkpoint(1.0);
  MatchedSection& match = best.candidate >= 0 ? best : shadowed;
  if (match.candidate < 0)
  {
    throw Error(Failure::NoMatch,
      "No visible silhouette section fits the stroke: both its ends fall on one place of every curve, or "
      "fewer than two "
      "control points lie between them. Draw the stroke along the outline that it is to replace.");
  }
  if (rules.maximumDistance > 0.0 && match.distance > rules.maximumDistance)
  {
    std::ostringstream message;
    message << "The nearest silhouette section is " << match.distance
            << " px from the stroke on average, more than "
            << "MaximumDistance = " << rules.maximumDistance
            << " px. Draw nearer to the outline or raise the limit.";
    throw Error(Failure::NoMatch, message.str());
  }
  return match;
}

} // namespace oversketch
