#include "Silhouette/match.h"

#include "Silhouette/shape_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

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

// The stroke's samples, and the loops that silhouettes are left to.
struct Drawing
{
  Polyline samples;
  NearestPlace nearest;
  std::vector<NearestPlace> outlines;

  Drawing(const std::vector<MatchCandidate>& candidates, const Polyline& stroke, double spacing)
    : samples(uniformPolyline(stroke, spacing))
    , nearest(samples)
  {
    for (const MatchCandidate& candidate : candidates)
    {
      if (candidate.outline)
      {
        this->outlines.emplace_back(candidate.display, candidate.closed);
      }
    }
  }
};

bool qualifies(const MatchCandidate& candidate,
  const std::vector<Blend>& places,
  const Polyline& section,
  double spacing)
{
  const auto bound = std::count_if(places.begin(),
    places.end(),
    [&](const Blend& place) { return place.from == place.to && candidate.bound[place.from]; });
  return bound >= 2 && arcLengths(section).back() >= spacing;
}

// The section between the places nearest to the stroke's ends. Its candidate is -1 where none qualifies.
MatchedSection nearestSection(const std::vector<MatchCandidate>& candidates,
  const Drawing& drawing,
  const MatchRules& rules,
  const Context& context)
{
  const Polyline& samples = drawing.samples;
  const NearestPlace& onStroke = drawing.nearest;
  const std::vector<NearestPlace>& outlines = drawing.outlines;
  MatchedSection best, shadowed; // shadowed: the best of those left to an outline, should no outline qualify
  best.score = shadowed.score = infinity;
  best.twisted = shadowed.twisted = true;
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
    const auto limit = [](const MatchedSection& rival) { return rival.twisted ? infinity : rival.score; };
    if (rules.amendedScore && gaps >= std::max(limit(best), outlines.empty() ? 0.0 : limit(shadowed)))
    {
      continue;
    }
    const double distance = onCandidate.meanDistance(samples);
    // As published, D chooses the candidate; only its own two arcs compete on the way back.
    if (!rules.amendedScore && distance >= best.score)
    {
      continue;
    }
    const std::vector<double> lengths = arcLengths(candidate.display, candidate.closed);
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
      if (!qualifies(candidate, places, section, rules.spacing))
      {
        continue;
      }
      const Polyline sectionSamples = uniformPolyline(section, rules.spacing);
      const double back = onStroke.meanDistance(sectionSamples);
      MatchedSection match;
      match.candidate = static_cast<int>(c);
      match.places = std::move(places);
      match.begin = start.along(lengths);
      match.length = (forward ? 1.0 : -1.0) * arcLengths(section).back();
      match.distance = match.score = distance;
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
      match.twisted = woundApart(section, samples);
      const bool left = !candidate.outline && !outlines.empty() && runsAlong(sectionSamples, outlines);
      MatchedSection& rival = left ? shadowed : best;
      if (std::tie(match.twisted, match.score) < std::tie(rival.twisted, rival.score))
      {
        rival = std::move(match);
      }
    }
  }
  return best.candidate >= 0 ? best : shadowed;
}

// The section that a part stands for, with its ends settled; its distance is left to who takes it.
MatchedSection sectionOf(const std::vector<MatchCandidate>& candidates,
  const CandidatePart& part,
  const Drawing& drawing)
{
  const MatchCandidate& candidate = candidates[part.candidate];
  const std::vector<double> lengths = arcLengths(candidate.display, candidate.closed);
  const int points = static_cast<int>(candidate.display.size());
  const auto answerAt = [&](double length)
  {
    const Blend place = placeOn(candidate, lengths, length);
    NearestPlace::Answer answer;
    answer.segment = place.from;
    answer.t = place.t;
    if (!candidate.closed && place.from == points - 1) // the last point ends the last segment
    {
      answer.segment = points - 2;
      answer.t = 1.0;
    }
    answer.place = place.of(candidate.display);
    return answer;
  };
  // Within a tenth of the length of where it is, so that the ends cannot leap to another limb; nor may they
  // pass each other on the far side of a closed curve.
  const double rest = candidate.closed ? 0.5 * (lengths.back() - std::abs(part.length)) : infinity;
  const double window = std::min(0.1 * std::abs(part.length), 0.9 * rest);
  const auto settled = [&](double length, const Vector2& end)
  {
    const int steps = std::max(1, static_cast<int>(std::ceil(window)));
    double best = length, least = (answerAt(length).place - end).squaredNorm();
    for (int i = -steps; i <= steps; ++i)
    {
      const double at = length + window * i / steps;
      const double squared = (answerAt(at).place - end).squaredNorm();
      if (squared < least && (candidate.closed || (at >= 0.0 && at <= lengths.back())))
      {
        least = squared;
        best = at;
      }
    }
    return best;
  };
  const double begin = settled(part.begin, drawing.samples.front() - part.shift);
  const double end = settled(part.begin + part.length, drawing.samples.back() - part.shift);
  MatchedSection section;
  section.candidate = part.candidate;
  section.places = part.length > 0.0 ? placesBetween(candidate, answerAt(begin), answerAt(end))
                                     : placesBetween(candidate, answerAt(end), answerAt(begin));
  if (part.length < 0.0)
  {
    std::reverse(section.places.begin(), section.places.end());
  }
  section.begin = begin;
  section.length = end - begin;
  section.score = part.score;
  return section;
}

// The sections that fit, the best first: the one between the nearest places, and those of the stroke's shape.
// Keeps of those that are the same but for their ends only the best, or that between the nearest places.
std::vector<MatchedSection> rankedSections(const std::vector<MatchCandidate>& candidates,
  const Drawing& drawing,
  const MatchedSection& nearest,
  const MatchRules& rules,
  const Context& context)
{
  constexpr double same = 0.6;
  std::vector<CandidatePart> parts = findShapes(candidates, drawing.samples, context);
  std::optional<CandidatePart> own;
  if (nearest.candidate >= 0 && !nearest.twisted)
  {
    own.emplace();
    own->candidate = nearest.candidate;
    own->begin = nearest.begin;
    own->length = nearest.length;
    scorePart(candidates, drawing.samples, *own);
    const auto place = std::find_if(
      parts.begin(), parts.end(), [&](const CandidatePart& part) { return part.score >= own->score; });
    parts.insert(place, *own);
  }
  std::vector<CandidatePart> taken;
  std::vector<MatchedSection> ranked;
  for (const CandidatePart& part : parts)
  {
    if (std::any_of(taken.begin(),
          taken.end(),
          [&](const CandidatePart& other) { return likeness(part, other) > same; }))
    {
      continue;
    }
    const bool isNearest = own && likeness(part, *own) > same;
    MatchedSection section = isNearest ? nearest : sectionOf(candidates, part, drawing);
    const MatchCandidate& candidate = candidates[section.candidate];
    const Polyline line = displayOf(candidate, section.places);
    if (!isNearest && (!qualifies(candidate, section.places, line, rules.spacing) ||
                        (!candidate.outline && !drawing.outlines.empty() &&
                          runsAlong(uniformPolyline(line, rules.spacing), drawing.outlines))))
    {
      continue;
    }
    taken.push_back(isNearest ? *own : part);
    ranked.push_back(std::move(section));
  }
  if (nearest.candidate >= 0 && nearest.twisted)
  {
    ranked.push_back(nearest); // after all that turn no limb inside out
  }
  return ranked;
}

[[noreturn]] void refuse(const Message& message)
{
  throw Error(Failure::NoMatch, message);
}

} // namespace

MatchedSection matchStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const MatchRules& rules,
  const Context& context)
{
  const Drawing drawing(candidates, stroke, rules.spacing);
  if (rules.maximumGap > 0.0)
  {
    double gap = infinity;
    for (const MatchCandidate& candidate : candidates)
    {
      const NearestPlace nearest(candidate.display, candidate.closed);
      for (const Vector2& p : drawing.samples)
      {
        gap = std::min(gap, nearest(p, gap).distance);
      }
    }
    if (gap > rules.maximumGap && std::isfinite(gap))
    {
      refuse({ "The stroke is %1 px from any outline, more than {maximumGap} = %2 px. Draw it along the "
               "outline that it is to replace.",
        std::lround(gap),
        rules.maximumGap });
    }
  }
  const bool comparing = rules.amendedScore && rules.compareShapes;
  const auto part = [&](double from, double to)
  {
    Context shared = context;
    shared.progress = [&context, from, to](double done) { context.progress(from + (to - from) * done); };
    return shared;
  };
  MatchedSection match = nearestSection(candidates, drawing, rules, part(0.0, comparing ? 0.5 : 1.0));
  if (comparing)
  {
    std::vector<MatchedSection> ranked = rankedSections(candidates, drawing, match, rules, part(0.5, 1.0));
    const int count = static_cast<int>(ranked.size());
    if (count > 0 && rules.rank >= count)
    {
      refuse({ count == 1 ? "Only %1 section fits the stroke; there is no number %2. Lower {candidate}."
                          : "Only %1 sections fit the stroke; there is no number %2. Lower {candidate}.",
        count,
        rules.rank + 1 });
    }
    if (count > 0)
    {
      match = std::move(ranked[static_cast<std::size_t>(rules.rank)]);
      match.rivals = count;
      const MatchCandidate& candidate = candidates[match.candidate];
      match.distance = NearestPlace(candidate.display, candidate.closed).meanDistance(drawing.samples);
    }
  }
  context.checkpoint(1.0);
  if (match.candidate < 0)
  {
    refuse(
      "No visible silhouette section fits the stroke: both its ends fall on one place of every curve, or "
      "fewer than two control points lie between them. Draw the stroke along the outline that it is to "
      "replace.");
  }
  if (rules.maximumDistance > 0.0 && match.distance > rules.maximumDistance)
  {
    refuse(
      { "The nearest silhouette section is %1 px from the stroke on average, more than {maximumDistance} = "
        "%2 px. Draw nearer to the outline or raise the limit.",
        match.distance,
        rules.maximumDistance });
  }
  return match;
}

} // namespace oversketch
