#include "Silhouette/shape_search.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr int sampleCount = 24;   // of the stroke and of a part, where shapes are compared
constexpr int fineCount = 64;     // of both, where a part is scored
constexpr double shiftCost = 1.5; // px of score for a px of shift
constexpr std::size_t finalists = 24;

Polyline samplesOf(const Polyline& points, const std::vector<double>& lengths, int count)
{
  Polyline samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    samples.push_back(
      placeAt(lengths, static_cast<int>(points.size()), lengths.back() * i / (count - 1)).of(points));
  }
  return samples;
}

// A candidate as a row of places at equal lengths.
struct SearchTrack
{
  Polyline places;
  double step = 0.0; // px
  bool closed = false;

  SearchTrack(const MatchCandidate& candidate, double wanted)
    : closed(candidate.closed)
  {
    const std::vector<double> lengths = arcLengths(candidate.display, candidate.closed);
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
  }

  int count() const { return static_cast<int>(this->places.size()); }
  // Signed steps a part may take from a place; the whole of a closed one, less its last step.
  bool holds(int begin, int steps) const
  {
    return this->closed ? std::abs(steps) < this->count()
                        : begin + steps >= 0 && begin + steps < this->count();
  }
  const Vector2& at(int i) const
  {
    return this->places[static_cast<std::size_t>(
      this->closed ? (i % this->count() + this->count()) % this->count() : i)];
  }
};

Polyline polylineOf(const std::vector<MatchCandidate>& candidates, const CandidatePart& part, int count)
{
  const MatchCandidate& candidate = candidates[static_cast<std::size_t>(part.candidate)];
  const std::vector<double> lengths = arcLengths(candidate.display, candidate.closed);
  Polyline samples;
  samples.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
  {
    double length = part.begin + part.length * i / (count - 1);
    if (candidate.closed)
    {
      length -= lengths.back() * std::floor(length / lengths.back());
    }
    samples.push_back(
      placeAt(lengths, static_cast<int>(candidate.display.size()), length).of(candidate.display));
  }
  return samples;
}

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

// What is asked again and again of one stroke.
struct Drawn
{
  Polyline fine;
  NearestPlace nearest;

  explicit Drawn(const Polyline& stroke)
    : fine(samplesOf(stroke, arcLengths(stroke), fineCount))
    , nearest(fine)
  {
  }

  void score(const std::vector<MatchCandidate>& candidates, CandidatePart& part) const
  {
    const Polyline section = polylineOf(candidates, part, fineCount);
    const NearestPlace onSection(section);
    Vector2 mean = Vector2::Zero();
    for (int i = 0; i < fineCount; ++i)
    {
      mean += (this->fine[static_cast<std::size_t>(i)] - section[static_cast<std::size_t>(i)]) / fineCount;
    }
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

// The parts that begin at every place of one candidate, of one length and direction, by their shape.
class Sweep
{
public:
  Sweep(const Polyline& strokeSamples, std::size_t keep)
    : Stroke(strokeSamples)
    , Keep(keep)
  {
  }

  // Adds the best to `found`.
  void run(int candidate, const SearchTrack& track, int steps, std::vector<CandidatePart>& found)
  {
    std::vector<CandidatePart> parts;
    for (int begin = 0; begin < track.count(); begin += this->Stride)
    {
      if (track.holds(begin, steps))
      {
        parts.push_back({ candidate, begin * track.step, steps * track.step, Vector2::Zero(), 0.0 });
        parts.back().score = this->difference(track, begin, steps);
      }
    }
    const auto last = parts.begin() + static_cast<std::ptrdiff_t>(std::min(this->Keep, parts.size()));
    std::partial_sort(parts.begin(), last, parts.end(), better);
    found.insert(found.end(), parts.begin(), last);
  }

  static bool better(const CandidatePart& a, const CandidatePart& b)
  {
    return std::tie(a.score, a.candidate, a.begin, a.length) <
           std::tie(b.score, b.candidate, b.begin, b.length);
  }

  int Stride = 1;

private:
  // Mean distance after the shift, and some of the shift.
  double difference(const SearchTrack& track, int begin, int steps) const
  {
    Vector2 differences[sampleCount], mean = Vector2::Zero();
    for (int i = 0; i < sampleCount; ++i)
    {
      const int at =
        begin + static_cast<int>(std::lround(static_cast<double>(steps) * i / (sampleCount - 1)));
      differences[i] = this->Stroke[static_cast<std::size_t>(i)] - track.at(at);
      mean += differences[i] / sampleCount;
    }
    double sum = 0.0;
    for (const Vector2& d : differences)
    {
      sum += (d - mean).norm();
    }
    return sum / sampleCount + 0.5 * shiftCost * mean.norm();
  }

  const Polyline& Stroke;
  const std::size_t Keep;
};

} // namespace

void scorePart(const std::vector<MatchCandidate>& candidates, const Polyline& stroke, CandidatePart& part)
{
  Drawn(stroke).score(candidates, part);
}

double likeness(const std::vector<MatchCandidate>& candidates, const CandidatePart& a, const CandidatePart& b)
{
  constexpr double near = 6.0; // px
  const Polyline p = polylineOf(candidates, a, fineCount), q = polylineOf(candidates, b, fineCount);
  const auto share = [](const Polyline& of, const Polyline& on)
  {
    const NearestPlace nearest(on);
    return static_cast<double>(std::count_if(
             of.begin(), of.end(), [&](const Vector2& point) { return nearest(point, near).segment >= 0; })) /
           static_cast<double>(of.size());
  };
  return std::min(share(p, q), share(q, p));
}

std::vector<CandidatePart> findShapes(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const Context& context)
{
  const std::vector<double> lengths = arcLengths(stroke);
  const Polyline samples = samplesOf(stroke, lengths, sampleCount);
  double all = 0.0;
  for (const MatchCandidate& candidate : candidates)
  {
    all += arcLengths(candidate.display, candidate.closed).back();
  }
  // Fine enough for the stroke, and no more work than for outlines of many viewports.
  const double spacing = std::max({ 6.0, lengths.back() / 120.0, all / 6000.0 });
  std::vector<CandidatePart> found;
  Sweep sweep(samples, 6);
  for (std::size_t c = 0; c < candidates.size(); ++c)
  {
    context.checkpoint(static_cast<double>(c) / static_cast<double>(candidates.size()));
    const SearchTrack track(candidates[c], spacing);
    constexpr int ratios = 14;
    for (int k = 0; k < ratios && track.count() > 0; ++k)
    {
      const double length = 0.3 * std::pow(2.2 / 0.3, static_cast<double>(k) / (ratios - 1)) * lengths.back();
      const int steps = static_cast<int>(std::lround(length / track.step));
      if (steps >= 2)
      {
        sweep.run(static_cast<int>(c), track, steps, found);
        sweep.run(static_cast<int>(c), track, -steps, found);
      }
    }
  }
  const auto last = found.begin() + static_cast<std::ptrdiff_t>(std::min(finalists, found.size()));
  std::partial_sort(found.begin(), last, found.end(), Sweep::better);
  found.erase(last, found.end());
  const Drawn drawn(stroke);
  for (CandidatePart& part : found)
  {
    drawn.score(candidates, part);
  }
  std::sort(found.begin(), found.end(), Sweep::better);
  return found;
}

} // namespace oversketch
