#include "Silhouette/shape_search.h"

#include "Mesh/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <utility>

namespace oversketch
{

namespace
{

constexpr int sampleCount = 24;   // of the stroke and of a part, where shapes are compared
constexpr int fineCount = 64;     // of both, where a part is scored
constexpr double shiftCost = 1.5; // px of score for a px of shift
constexpr double leastReach = 30.0,
                 reach = 0.25; // px, and of the stroke's length: a hand does not miss by more
constexpr double unlike =
  0.2; // of the stroke's length: a part that is so far from it in the mean is another shape
constexpr std::size_t finalists =
  24; // that are scored, of all parts and of those better than their neighbours

// Places at equal lengths, both ends among them.
Polyline samplesOf(const Polyline& points, int count)
{
  return uniformPolyline(points, arcLengths(points).back() / (count - 1));
}

// A candidate as a row of places at equal lengths.
struct SearchTrack
{
  Polyline places;   // of a closed one three times, so that a part may pass its start either way
  double step = 0.0; // px
  bool closed = false;

  SearchTrack(const MatchCandidate& candidate, const std::vector<double>& lengths, double wanted)
    : closed(candidate.closed)
  {
    const int points = static_cast<int>(candidate.display.size());
    if (points < 2 || !(lengths.back() > 0.0))
    {
      return;
    }
    const int steps = std::max(2, static_cast<int>(std::lround(lengths.back() / wanted)));
    this->step = lengths.back() / steps;
    for (int i = 0; i < steps + (this->closed ? 0 : 1); ++i)
    {
      this->places.push_back(placeAt(lengths, points, i * this->step).of(candidate.display));
    }
    for (std::size_t i = 0, once = this->places.size(); this->closed && i < 2 * once; ++i)
    {
      this->places.push_back(Vector2(this->places[i]));
    }
  }

  int count() const { return static_cast<int>(this->places.size()) / (this->closed ? 3 : 1); }
  // Signed steps a part may take from a place; the whole of a closed one, less its last step.
  bool holds(int begin, int steps) const
  {
    return this->closed ? std::abs(steps) < this->count()
                        : begin + steps >= 0 && begin + steps < this->count();
  }
  // From a whole round before the first place of a closed one.
  const Vector2* from(int i) const { return this->places.data() + (this->closed ? this->count() + i : i); }
};

double scoreOf(const Polyline& section,
  const NearestPlace& onSection,
  const Polyline& stroke,
  const NearestPlace& onStroke,
  const Vector2& shift)
{
  Polyline back = stroke, forth = section;
  for (Vector2& p : back)
  {
    p -= shift;
  }
  for (Vector2& p : forth)
  {
    p += shift;
  }
  const double gaps = (back.front() - section.front()).norm() + (back.back() - section.back()).norm();
  return onSection.meanDistance(back) + onStroke.meanDistance(forth) + 0.5 * gaps + shiftCost * shift.norm();
}

// Answers about one stroke that are asked for again and again.
struct Drawn
{
  Polyline fine;
  NearestPlace nearest;

  explicit Drawn(const Polyline& stroke)
    : fine(samplesOf(stroke, fineCount))
    , nearest(fine)
  {
  }

  void score(const MatchCandidate& candidate, const std::vector<double>& lengths, CandidatePart& part) const
  {
    Polyline& section = part.line;
    section.clear();
    Vector2 mean = Vector2::Zero();
    for (int i = 0; i < fineCount; ++i)
    {
      const double length = part.begin + part.length * i / (fineCount - 1);
      section.push_back(placeOn(candidate, lengths, length).of(candidate.display));
      mean += (this->fine[static_cast<std::size_t>(i)] - section.back()) / fineCount;
    }
    const NearestPlace onSection(section);
    part.shift = Vector2::Zero();
    part.score = scoreOf(section, onSection, this->fine, this->nearest, part.shift);
    const double shifted = scoreOf(section, onSection, this->fine, this->nearest, mean);
    if (shifted < part.score)
    {
      part.score = shifted;
      part.shift = mean;
    }
  }
};

// The steps to each sample of a part.
using Offsets = std::array<int, sampleCount>;

// The sign of the area between a line, at(0) to at(count - 1), and the chord of its ends; 0 where it goes
// round next to nothing.
template <typename At>
int windingOf(int count, const At& at)
{
  constexpr double open = 0.4;   // of its length: its ends are no farther apart
  constexpr double least = 4e-3; // twice the area, of the length squared: of a limb 1 to 500, about
  double area = 0.0, length = 0.0;
  Vector2 last = Vector2::Zero();
  for (int i = 1; i < count; ++i)
  {
    const Vector2 next = at(i) - at(0);
    area += cross(last, next);
    length += (next - last).norm();
    last = next;
  }
  const bool goesRound = last.norm() <= open * length && std::abs(area) >= least * length * length;
  return !goesRound ? 0 : area > 0.0 ? 1 : -1;
}

int windingOf(const Polyline& line)
{
  return windingOf(static_cast<int>(line.size()),
    [&line](int i) -> const Vector2& { return line[static_cast<std::size_t>(i)]; });
}

// Mean distance of the stroke to the part that begins at a place, after the shift, and some of the shift;
// infinite where that is another shape.
double difference(const Polyline& stroke,
  double drawn,
  int winding,
  const Vector2* place,
  const Offsets& offsets)
{
  Vector2 differences[sampleCount], mean = Vector2::Zero();
  for (int i = 0; i < sampleCount; ++i)
  {
    const std::size_t k = static_cast<std::size_t>(i);
    differences[k] = stroke[k] - place[offsets[k]];
    mean += differences[k] / sampleCount;
  }
  double sum = 0.0;
  for (const Vector2& d : differences)
  {
    sum += (d - mean).norm();
  }
  const bool isLike =
    sum / sampleCount <= unlike * drawn && mean.norm() <= std::max(leastReach, reach * drawn) &&
    winding * windingOf(sampleCount,
                [&](int i) -> const Vector2& { return place[offsets[static_cast<std::size_t>(i)]]; }) >=
      0;
  return isLike ? sum / sampleCount + 0.5 * shiftCost * mean.norm() : std::numeric_limits<double>::infinity();
}

bool better(const CandidatePart& a, const CandidatePart& b)
{
  return std::tie(a.score, a.candidate, a.begin, a.length) <
         std::tie(b.score, b.candidate, b.begin, b.length);
}

// Leaves the best of them, in their order.
template <class Value, class Better>
void keepBest(std::vector<Value>& values, std::size_t count, const Better& isBetter)
{
  const auto last = values.begin() + static_cast<std::ptrdiff_t>(std::min(count, values.size()));
  std::partial_sort(values.begin(), last, values.end(), isBetter);
  values.erase(last, values.end());
}

// Findings of the sweeps.
struct Findings
{
  std::vector<CandidatePart> best;   // many beside each other round the best places
  std::vector<CandidatePart> minima; // better than their neighbours: other limbs of that shape are among them
};

// Adds the parts of one candidate, length and direction that are best by their shape.
void sweep(const Polyline& stroke,
  double drawn,
  int candidate,
  const SearchTrack& track,
  int steps,
  Findings& found)
{
  constexpr std::size_t kept = 6;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Offsets offsets;
  for (int i = 0; i < sampleCount; ++i)
  {
    offsets[static_cast<std::size_t>(i)] =
      static_cast<int>(std::lround(static_cast<double>(steps) * i / (sampleCount - 1)));
  }
  const int count = track.count(), winding = windingOf(stroke);
  std::vector<double> scores; // of the parts that begin at each place
  scores.reserve(static_cast<std::size_t>(count));
  for (int begin = 0; begin < count; ++begin)
  {
    scores.push_back(
      track.holds(begin, steps) ? difference(stroke, drawn, winding, track.from(begin), offsets) : infinite);
  }
  using Scored = std::pair<double, int>; // and where the part begins
  std::vector<Scored> parts, minima;
  for (int begin = 0; begin < count; ++begin)
  {
    const double score = scores[static_cast<std::size_t>(begin)];
    if (score == infinite)
    {
      continue;
    }
    parts.push_back({ score, begin });
    if (score <= scores[static_cast<std::size_t>(begin > 0 ? begin - 1 : count - 1)] &&
        score < scores[static_cast<std::size_t>(begin + 1 < count ? begin + 1 : 0)])
    {
      minima.push_back({ score, begin });
    }
  }
  const auto add = [&](std::vector<Scored>& best, std::vector<CandidatePart>& to)
  {
    keepBest(best, kept, std::less<>());
    for (const auto& [score, begin] : best)
    {
      CandidatePart part;
      part.candidate = candidate;
      part.begin = begin * track.step;
      part.length = steps * track.step;
      part.score = score;
      to.push_back(part);
    }
  };
  add(parts, found.best);
  add(minima, found.minima);
}

} // namespace

Blend placeOn(const MatchCandidate& candidate, const std::vector<double>& lengths, double length)
{
  const double whole = lengths.back();
  return placeAt(lengths,
    static_cast<int>(candidate.display.size()),
    candidate.closed ? length - whole * std::floor(length / whole) : length);
}

void scorePart(const std::vector<MatchCandidate>& candidates, const Polyline& stroke, CandidatePart& part)
{
  const MatchCandidate& candidate = candidates[static_cast<std::size_t>(part.candidate)];
  Drawn(stroke).score(candidate, arcLengths(candidate.display, candidate.closed), part);
}

bool woundApart(const Polyline& a, const Polyline& b)
{
  return windingOf(a) * windingOf(b) < 0;
}

double likeness(const CandidatePart& a, const CandidatePart& b)
{
  const auto share = [](const Polyline& of, const Polyline& on)
  {
    constexpr double near = 6.0; // px
    const NearestPlace nearest(on);
    return static_cast<double>(std::count_if(
             of.begin(), of.end(), [&](const Vector2& point) { return nearest(point, near).segment >= 0; })) /
           static_cast<double>(of.size());
  };
  return std::min(share(a.line, b.line), share(b.line, a.line));
}

std::vector<CandidatePart> findShapes(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const Context& context)
{
  std::vector<std::vector<double>> lengths; // along each candidate; empty for one without points
  double all = 0.0;
  for (const MatchCandidate& candidate : candidates)
  {
    lengths.push_back(arcLengths(candidate.display, candidate.closed));
    all += lengths.back().empty() ? 0.0 : lengths.back().back();
  }
  const Polyline samples = samplesOf(stroke, sampleCount);
  const double drawn = arcLengths(stroke).back();
  // Fine enough for the stroke, and no more work than for outlines of many viewports.
  const double spacing = std::max({ 6.0, drawn / 120.0, all / 6000.0 });
  Findings findings;
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    context.checkpoint(static_cast<double>(c) / static_cast<double>(candidates.size()));
    const SearchTrack track(candidates[c], lengths[c], spacing);
    constexpr int ratios = 14;
    for (int k = 0; k < ratios && track.count() > 0; ++k)
    {
      const double length = 0.3 * std::pow(2.2 / 0.3, static_cast<double>(k) / (ratios - 1)) * drawn;
      const int steps = static_cast<int>(std::lround(length / track.step));
      for (const int signedSteps : { steps, -steps })
      {
        if (steps >= 2)
        {
          sweep(samples, drawn, static_cast<int>(c), track, signedSteps, findings);
        }
      }
    }
  }
  keepBest(findings.best, finalists, better);
  keepBest(findings.minima, finalists, better);
  std::vector<CandidatePart> found = std::move(findings.best);
  found.insert(found.end(), findings.minima.begin(), findings.minima.end());
  const Drawn whole(stroke);
  for (CandidatePart& part : found)
  {
    const std::size_t c = static_cast<std::size_t>(part.candidate);
    whole.score(candidates[c], lengths[c], part);
  }
  std::sort(found.begin(), found.end(), better);
  const auto same = [](const CandidatePart& a, const CandidatePart& b)
  { return !better(a, b) && !better(b, a); };
  found.erase(std::unique(found.begin(), found.end(), same), found.end());
  return found;
}

Polyline openStroke(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const Context& context)
{
  const std::vector<double> lengths = arcLengths(stroke, true);
  const double whole = lengths.back();
  const int count = static_cast<int>(stroke.size());
  const auto at = [&](double length)
  { return placeAt(lengths, count, length - whole * std::floor(length / whole)).of(stroke); };
  struct Opening
  {
    double from, left; // where the part that is left out begins, and how long it is [px]
    double score = std::numeric_limits<double>::infinity();
  };
  const auto restOf = [&](const Opening& opening)
  {
    constexpr double spacing = 2.0; // px, as strokes have it
    const double length = whole - opening.left;
    const int steps = std::max(2, static_cast<int>(std::lround(length / spacing)));
    Polyline rest;
    for (int i = 0; i <= steps; ++i)
    {
      rest.push_back(at(opening.from + opening.left + length * i / steps));
    }
    return rest;
  };
  constexpr int starts = 40;
  constexpr double straight = 0.9; // least distance of its ends, of its length, of what is left out
  std::vector<Opening> openings;
  for (int start = 0; start < starts; ++start)
  {
    for (const double share : { 0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4 })
    {
      const Opening opening{ whole * start / starts, share * whole };
      if ((at(opening.from + opening.left) - at(opening.from)).norm() >= straight * opening.left)
      {
        openings.push_back(opening);
      }
    }
  }
  context.checkpoint(0.0);
  context.eachUntilCancelled(static_cast<int>(openings.size()),
    [&](int i)
    {
      Opening& opening = openings[static_cast<std::size_t>(i)];
      const std::vector<CandidatePart> found = findShapes(candidates, restOf(opening));
      if (!found.empty())
      {
        opening.score = found.front().score + 0.05 * opening.left;
      }
    });
  context.checkpoint(1.0);
  const auto best = std::min_element(
    openings.begin(), openings.end(), [](const Opening& a, const Opening& b) { return a.score < b.score; });
  return best == openings.end() || std::isinf(best->score) ? stroke : restOf(*best);
}

} // namespace oversketch
