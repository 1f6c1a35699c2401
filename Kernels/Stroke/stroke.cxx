#include "Stroke/stroke.h"

#include "Mesh/context.h"

#include <cmath>

namespace oversketch
{

namespace
{

template <typename... Arguments>
[[noreturn]] void refuse(const char* text, const Arguments&... arguments)
{
  throw Error(Failure::BadStroke, text, arguments...);
}

} // namespace

bool isClosedStroke(const Polyline& samples, const StrokeRules& rules)
{
  const std::vector<double> lengths = arcLengths(samples);
  const double length = lengths.back();
  const double gap = (samples.back() - samples.front()).norm();
  if (gap < 2.0 * rules.minimumSpacing)
  {
    return true;
  }
  const int count = static_cast<int>(samples.size());
  const auto at = [&](double r) { return placeAt(lengths, count, r * length).of(samples); };
  const Vector2 leaves = at(0.1) - samples.front();
  const Vector2 arrives = samples.back() - at(0.9);
  return gap < rules.closedFraction * length && leaves.dot(arrives) > 0.0;
}

bool comesBack(const Polyline& samples, double gap)
{
  if (samples.size() < 3)
  {
    return false;
  }
  const double between = (samples.back() - samples.front()).norm();
  return between < gap && between < 0.5 * arcLengths(samples).back();
}

std::vector<Blend> cleanStroke(const Polyline& samples, const StrokeRules& rules)
{
  if (samples.size() < 2)
  {
    refuse("it has %1%2; at least 2 are needed: draw a longer stroke.",
      samples.size(),
      samples.size() == 1 ? " sample" : " samples");
  }
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (!samples[i].allFinite())
    {
      refuse("sample %1 is not finite; remove it or record the stroke again.", i);
    }
  }
  const bool limited = rules.maximumLength > 0.0 && rules.viewport.minCoeff() > 0.0;
  for (std::size_t i = 0; limited && i < samples.size(); ++i)
  {
    const Vector2 beside = (samples[i] - 0.5 * rules.viewport).cwiseAbs().cwiseQuotient(rules.viewport);
    if (!(beside.maxCoeff() <= 1.5))
    {
      refuse("sample %1 lies at (%2, %3) px, farther beside the viewport of %4 x %5 px than that is large: "
             "remove it or record the stroke again.",
        i,
        samples[i][0],
        samples[i][1],
        rules.viewport[0],
        rules.viewport[1]);
    }
  }
  std::vector<int> kept{ 0 };
  const int last = static_cast<int>(samples.size()) - 1;
  for (int i = 1; i <= last; ++i)
  {
    const double step = (samples[i] - samples[kept.back()]).norm();
    if (step > 0.0 && step >= rules.minimumSpacing)
    {
      kept.push_back(i);
    }
  }
  if (kept.back() != last && kept.size() > 1)
  {
    kept.back() = last; // the pen's lift counts, the jitter before it does not
  }
  const Polyline clean = valuesAt(samples, kept);
  const double length = arcLengths(clean).back();
  if (!(length >= rules.minimumLength) || !(length > 0.0))
  {
    refuse("it is %1 px long; at least %2 px are needed: draw a longer stroke.", length, rules.minimumLength);
  }
  if (!(length <= longestStroke))
  {
    refuse("it is %1 px long; at most %2 px are taken: record the stroke again.", length, longestStroke);
  }
  if (limited && length > rules.maximumLength * rules.viewport.norm())
  {
    refuse("it is %1 px long, %2 times the diagonal of its viewport; at most %3 times are taken: draw one "
           "line along the outline that it is to replace, not a scribble.",
      std::lround(length),
      std::lround(length / rules.viewport.norm()),
      rules.maximumLength);
  }
  if (rules.refuseClosed && isClosedStroke(clean, rules))
  {
    refuse("it is closed: its ends are %1 px apart and it is %2 px long; draw an open stroke.",
      (clean.back() - clean.front()).norm(),
      length);
  }
  std::vector<Blend> places = uniformPlaces(clean, rules.spacing);
  for (Blend& place : places)
  {
    place.from = kept[place.from];
    place.to = kept[place.to];
  }
  return places;
}

} // namespace oversketch
