#include "Silhouette/effect.h"

#include "Mesh/nearest.h"
#include "Mesh/shape.h"
#include "Silhouette/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace oversketch
{

namespace
{

// Anticlockwise; the first point is not repeated.
Polyline convexHull(Polyline points)
{
  const auto before = [](const Vector2& a, const Vector2& b)
  { return a[0] < b[0] || (a[0] == b[0] && a[1] < b[1]); };
  std::sort(points.begin(), points.end(), before);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3)
  {
    return points;
  }
  Polyline hull;
  const auto add = [&hull](const Vector2& p, std::size_t least)
  {
    while (hull.size() > least && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0)
    {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const Vector2& p : points)
  {
    add(p, 1);
  }
  const std::size_t lower = hull.size();
  for (auto p = points.rbegin() + 1; p != points.rend(); ++p)
  {
    add(*p, lower);
  }
  hull.pop_back();
  return hull;
}

// Of a point that is no farther than strayLimit any distance up to that.
double distanceToHull(const Vector2& p, const Polyline& hull)
{
  const auto after = [&hull](std::size_t i) -> const Vector2& { return hull[(i + 1) % hull.size()]; };
  bool inside = hull.size() > 2;
  for (std::size_t i = 0; inside && i < hull.size(); ++i)
  {
    inside = cross(after(i) - hull[i], p - hull[i]) >= 0.0;
  }
  double nearest = inside ? 0.0 : (p - hull[0]).norm();
  for (std::size_t i = 0; nearest > StrokeEffect::strayLimit && i < hull.size(); ++i)
  {
    nearest = std::min(nearest, distanceToSegment(p, hull[i], after(i)));
  }
  return nearest;
}

void measureTriangles(const Mesh& before,
  const Mesh& after,
  const std::vector<char>& region,
  const Context& context,
  StrokeEffect& effect)
{
  std::vector<double> areas(before.triangles.size());
  context.each(before.triangleCount(), [&](int t) { areas[t] = facetArea(before, t); });
  double all = 0.0, moved = 0.0;
  std::vector<double> ratios;
  for (int i = 0; i < before.triangleCount(); ++i)
  {
    const Triangle& t = before.triangles[i];
    all += areas[i];
    if (!region[t[0]] || !region[t[1]] || !region[t[2]])
    {
      continue;
    }
    moved += areas[i];
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      const double was = (before.points[a] - before.points[b]).norm();
      const double is = (after.points[a] - after.points[b]).norm();
      if (was > 0.0)
      {
        constexpr double crushed = 1e-6;
        ratios.push_back(std::max(is, was) / std::max(std::min(is, was), crushed * was));
      }
    }
  }
  effect.movedShare = all > 0.0 ? moved / all : 0.0;
  effect.stretch = 1.0;
  if (!ratios.empty())
  {
    const auto rank = static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(ratios.size() - 1));
    std::nth_element(ratios.begin(), ratios.begin() + rank, ratios.end());
    effect.stretch = ratios[static_cast<std::size_t>(rank)];
  }
}

constexpr double unreached = std::numeric_limits<double>::infinity();

// The places of a loop from one to another, in its own direction.
Polyline wayAlong(const OutlineLoop& loop, const NearestPlace::Answer& from, const NearestPlace::Answer& to)
{
  const int count = static_cast<int>(loop.points.size());
  const bool wraps = to.segment < from.segment || (to.segment == from.segment && to.t < from.t);
  const int points = to.segment - from.segment + (wraps ? count : 0);
  Polyline way{ from.place };
  for (int k = 1; k <= points; ++k)
  {
    way.push_back(loop.points[static_cast<std::size_t>((from.segment + k) % count)]);
  }
  way.push_back(to.place);
  return way;
}

double backAlong(std::vector<OutlineLoop> loops,
  const Polyline& stroke,
  const std::vector<OutlineLoop>& further)
{
  loops.insert(loops.end(), further.begin(), further.end());
  const std::vector<NearestPlace> places = nearestPlaces(loops);
  const std::vector<double> length = arcLengths(stroke);
  // Place of each loop that is nearest to one of the stroke; none where another loop comes 2 px nearer.
  const auto nearestTo = [&](double share)
  {
    constexpr double asNear = 2.0; // px
    const Vector2 point = placeAt(length, static_cast<int>(stroke.size()), share * length.back()).of(stroke);
    std::vector<NearestPlace::Answer> found;
    double nearest = unreached;
    for (const NearestPlace& place : places)
    {
      found.push_back(place(point, nearest + asNear));
      nearest = found.back().segment >= 0 ? std::min(nearest, found.back().distance) : nearest;
    }
    for (NearestPlace::Answer& answer : found)
    {
      answer.segment = answer.distance <= nearest + asNear ? answer.segment : -1;
    }
    return found;
  };
  const std::vector<NearestPlace::Answer> first = nearestTo(0.2), last = nearestTo(0.8);
  double least = unreached;
  const NearestPlace onStroke(stroke);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const bool forward : { true, false })
    {
      const NearestPlace::Answer &from = forward ? first[i] : last[i], &to = forward ? last[i] : first[i];
      const bool inOrder = from.segment < to.segment || (from.segment == to.segment && from.t <= to.t);
      if (from.segment >= 0 && to.segment >= 0 && (inOrder || loops[i].closed))
      {
        constexpr double spacing = 2.0; // px
        least =
          std::min(least, onStroke.meanDistance(uniformPolyline(wayAlong(loops[i], from, to), spacing)));
      }
    }
  }
  return least;
}

// [%], to tenths below ten.
double percent(double share)
{
  const double tenths = std::round(1000.0 * share) / 10.0;
  return tenths < 10.0 ? tenths : std::round(tenths);
}

Message crossing(const StrokeEffect& effect)
{
  return { "the surface passes through itself: %1 pairs of triangles cross", effect.crossings };
}

} // namespace

double outlineBack(const StrokeOutline& outline, const std::vector<OutlineLoop>& further)
{
  // Farther outlines are looked for where none is near.
  const double back = backAlong(outline.nearby(), outline.stroke(), further);
  return std::isfinite(back) ? back : backAlong(outline.whole(), outline.stroke(), further);
}

void measureMovement(const Mesh& before,
  const Mesh& after,
  const std::vector<char>& region,
  const View& view,
  const Polyline& stroke,
  const Polyline& section,
  StrokeEffect& effect,
  const Context& context)
{
  measureTriangles(before, after, region, context, effect);
  effect.strayDistance = effect.strayMovement = 0.0;
  Polyline drawn = stroke;
  const std::vector<double> length = arcLengths(section);
  for (std::size_t i = 0; i < section.size(); ++i)
  {
    if (length[i] >= 0.35 * length.back() && length[i] <= 0.65 * length.back())
    {
      drawn.push_back(section[i]);
    }
  }
  if (drawn.empty())
  {
    return;
  }
  const Polyline hull = convexHull(std::move(drawn));
  struct Step
  {
    double movement = 0.0, distance = 0.0; // px; from the hull
  };
  const std::vector<int> chosen = marked(region);
  std::vector<Step> steps(chosen.size());
  context.each(static_cast<int>(chosen.size()),
    [&](int i)
    {
      const int v = chosen[i];
      if (!view.inFront(before.points[v]) || !view.inFront(after.points[v]))
      {
        return;
      }
      const Vector2 was = view.toDisplay(before.points[v]).head<2>();
      const Vector2 is = view.toDisplay(after.points[v]).head<2>();
      constexpr double seen = 2.5; // px
      steps[i].movement = (is - was).norm();
      steps[i].distance =
        steps[i].movement > seen ? std::max(distanceToHull(was, hull), distanceToHull(is, hull)) : 0.0;
    });
  for (const Step& step : steps)
  {
    if (step.distance > StrokeEffect::strayLimit)
    {
      effect.strayDistance = std::max(effect.strayDistance, step.distance);
      effect.strayMovement = std::max(effect.strayMovement, step.movement);
    }
  }
}

std::vector<Message> remarks(const StrokeEffect& effect)
{
  constexpr double near = 3.0;      // px in the mean: as near as a result has to come to the stroke's middle
  constexpr double large = 0.45;    // of the surface
  constexpr double far = 8.0;       // px at worst
  constexpr double hand = 2.5;      // px at worst: what is missed by more is seen
  constexpr double leftOver = 10.0; // px of outline beside the stroke that the stroke itself does not meet
  std::vector<Message> said;
  if (!std::isfinite(effect.outline.mean))
  {
    said.emplace_back("nothing is seen of the model any more");
  }
  else if (effect.outline.mean > near)
  {
    said.emplace_back("the outline misses the stroke by %1 px in the mean and by %2 px at worst",
      std::lround(effect.outline.mean),
      std::lround(effect.outline.worst));
  }
  else if (effect.outline.worst > far)
  {
    said.emplace_back("the outline misses the stroke by %1 px at worst", std::lround(effect.outline.worst));
  }
  else if (!std::isfinite(effect.outlineBack))
  {
    said.emplace_back("no outline leads from one end of the stroke to the other");
  }
  else if (effect.outlineBack > leftOver)
  {
    said.emplace_back(
      "between the stroke's ends the outline runs %1 px beside it", std::lround(effect.outlineBack));
  }
  else if (effect.missed > hand)
  {
    said.emplace_back("the outline misses the stroke by %1 px at worst", std::lround(effect.missed));
  }
  if (effect.back > Judgement::tolerableBack)
  {
    said.emplace_back("%1 % of what is seen of the model is turned inside out", percent(effect.back));
  }
  if (effect.crossings > StrokeEffect::tolerableCrossings)
  {
    said.push_back(crossing(effect));
  }
  if (effect.strayDistance > 0.0)
  {
    said.emplace_back("what lies up to %1 px beside the stroke moved too, by up to %2 px",
      std::lround(effect.strayDistance),
      std::lround(effect.strayMovement));
  }
  if (effect.movedShare > large)
  {
    said.emplace_back("%1 % of the surface moved", percent(effect.movedShare));
  }
  if (effect.folds > 2 * Judgement::tolerableFolds)
  {
    said.emplace_back("%1 edges are folded over", effect.folds);
  }
  return said;
}

bool crossesWrongly(const StrokeEffect& effect)
{
  StrokeEffect beside = effect;
  beside.movedShare = 0.0;
  beside.crossings = 0;
  return effect.crossings > StrokeEffect::tolerableCrossings && !remarks(beside).empty();
}

Message tornBy(const StrokeEffect& effect)
{
  StrokeEffect beside = effect;
  beside.movedShare = 0.0;
  const bool asDrawn = remarks(beside).empty();
  if (effect.stretch > StrokeEffect::tornStretch && !(effect.remeshed && asDrawn))
  {
    return { "edges are stretched or squeezed %1 times", std::lround(effect.stretch) };
  }
  if (effect.movedShare > StrokeEffect::tornShare && !asDrawn)
  {
    return { "%1 % of the surface moved", percent(effect.movedShare) };
  }
  return crossesWrongly(effect) ? crossing(effect) : Message();
}

bool beyondHelp(const StrokeEffect& effect)
{
  constexpr double hand = 10.0; // px in the mean
  return effect.strayDistance > 0.0 &&
         (effect.movedShare > StrokeEffect::tornShare || effect.outline.mean > hand);
}

} // namespace oversketch
