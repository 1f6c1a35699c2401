#include "Stroke/fit.h"

#include "Mesh/context.h"
#include "Mesh/shape.h"
#include "Stroke/resample.h"
#include "Stroke/stroke.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// Whether two segments cross each other between their ends.
bool crosses(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  return cross(b - a, c - a) * cross(b - a, d - a) < 0.0 && cross(d - c, a - c) * cross(d - c, b - c) < 0.0;
}

double lengthOf(const Polyline& points, const std::vector<int>& ids, std::size_t from, std::size_t to)
{
  double length = 0.0;
  for (std::size_t i = from + 1; i <= to; ++i)
  {
    length += (points[ids[i]] - points[ids[i - 1]]).norm();
  }
  return length;
}

// The first segment of the path, of those before `end`, that the segment crosses; `end` where none does.
std::size_t firstCrossed(const Polyline& points,
  const std::vector<int>& path,
  std::size_t begin,
  std::size_t end,
  const Vector2& a,
  const Vector2& b)
{
  for (std::size_t k = begin; k < end; ++k)
  {
    if (crosses(points[path[k]], points[path[k + 1]], a, b))
    {
      return k;
    }
  }
  return end;
}

// Where a place of the spline is seen [px].
Vector2 seenAt(const SplinePlace& place, const FittedStroke& fitted, const SpaceSamples* space)
{
  if (!space)
  {
    return place.of(fitted.controls);
  }
  const Vector3 world = place.of(fitted.spaceControls);
  if (!space->view.inFront(world))
  {
    throw Error(Failure::BadStroke, "its spline in space leads behind the eye; fit it in the picture.");
  }
  return space->view.toDisplay(world).head<2>();
}

// Control points of the spline through these.
template <typename Value>
void interpolate(const Nurbs& curve, std::vector<Value>& controls)
{
  const int count = static_cast<int>(controls.size());
  Eigen::MatrixXd values(count, Value::RowsAtCompileTime);
  for (int i = 0; i < count; ++i)
  {
    values.row(i) = controls[i].transpose();
  }
  values = curve.interpolating(values);
  for (int i = 0; i < count; ++i)
  {
    controls[i] = values.row(i).transpose();
  }
}

// Parameters at equal lengths along the curve, from a table that is finer than its pieces.
std::vector<double> evenParameters(const Nurbs& curve,
  const FittedStroke& fitted,
  const SpaceSamples* space,
  double step)
{
  constexpr int perPiece = 32;
  const int count = perPiece * static_cast<int>(fitted.controls.size());
  Polyline table;
  for (int i = 0; i <= count; ++i)
  {
    table.push_back(seenAt(curve.at(static_cast<double>(i) / count), fitted, space));
  }
  const std::vector<double> lengths = arcLengths(table);
  const int steps = std::max(fitted.closed ? 3 : 1, static_cast<int>(std::ceil(lengths.back() / step)));
  std::vector<double> parameters;
  for (int i = 0; i < steps + !fitted.closed; ++i)
  {
    const Blend place = placeAt(lengths, count + 1, lengths.back() * i / steps);
    parameters.push_back((place.from + place.t * (place.to - place.from)) / count);
  }
  return parameters;
}

// Knots as everybody writes them, and the control points that go with them.
void writeKnots(const Nurbs& curve, int controls, bool periodic, FittedStroke& fitted)
{
  const int degree = curve.degree(), pieces = periodic ? controls : controls - degree;
  const bool shifted = periodic && degree % 2 == 0; // as Nurbs::at has it
  const int first = curve.at(0.0).points[0];
  for (int i = -degree; i <= pieces + degree + shifted; ++i)
  {
    fitted.knots.push_back((periodic ? i - 0.5 * shifted : std::clamp(i, 0, pieces)) / pieces);
  }
  for (int i = 0; i < pieces + degree + shifted; ++i)
  {
    fitted.order.push_back((first + i) % controls);
  }
}

} // namespace

std::vector<int> withoutLoops(const Polyline& polygon)
{
  const int count = static_cast<int>(polygon.size());
  std::vector<int> path;
  double total = arcLengths(polygon, true).back();
  for (int next = 0; next < count; ++next)
  {
    while (path.size() > 2)
    {
      // The segment to `next` against all but the one before it.
      const std::size_t last = path.size() - 1;
      const std::size_t k = firstCrossed(polygon, path, 0, last - 1, polygon[path[last]], polygon[next]);
      if (k == last - 1)
      {
        break;
      }
      const double loop = lengthOf(polygon, path, k + 1, last);
      if (loop > 0.5 * total)
      {
        path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
        next = count; // all that would follow is the shorter part
        break;
      }
      total -= loop;
      path.resize(k + 1);
    }
    if (next < count)
    {
      path.push_back(next);
    }
  }
  // The segment that closes it.
  while (path.size() > 3)
  {
    const std::size_t last = path.size() - 1;
    const std::size_t k =
      firstCrossed(polygon, path, 1, last - 1, polygon[path.back()], polygon[path.front()]);
    if (k == last - 1)
    {
      break;
    }
    if (lengthOf(polygon, path, 0, k) < lengthOf(polygon, path, k + 1, last))
    {
      path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(k) + 1);
    }
    else
    {
      path.resize(k + 1);
    }
  }
  return path;
}

FittedStroke fitStroke(const Polyline& samples, bool closed, const FitRules& rules, const SpaceSamples* space)
{
  if (!allFinite(samples))
  {
    throw Error(Failure::BadStroke, "it has a sample that is not finite; record the stroke again.");
  }
  FittedStroke fitted;
  fitted.closed = closed;
  fitted.kept = thinEvenly(samples, rules.spacing, closed);
  fitted.controls = valuesAt(samples, fitted.kept);
  const bool point = !differs(fitted.controls);
  if (point || arcLengths(fitted.controls, closed).back() > longestStroke)
  {
    throw Error(Failure::BadStroke,
      point ? "it has fewer than two samples that differ; draw a longer one."
            : "it is longer than 100000 px; record the stroke again.");
  }
  if (closed && rules.cutLoops)
  {
    const std::vector<int> stay = withoutLoops(fitted.controls);
    fitted.kept = valuesAt(fitted.kept, stay);
    fitted.controls = valuesAt(fitted.controls, stay);
  }
  const bool periodic = closed && rules.periodic;
  if (closed && !periodic)
  {
    if (fitted.controls.size() < 3)
    {
      Nurbs(static_cast<int>(fitted.controls.size()), true); // says so
    }
    fitted.kept.push_back(fitted.kept.front());
    fitted.controls.push_back(fitted.controls.front());
  }
  const int count = static_cast<int>(fitted.controls.size());
  const Nurbs curve(count, periodic);
  fitted.degree = curve.degree();
  writeKnots(curve, count, periodic, fitted);
  if (space)
  {
    fitted.spaceControls = valuesAt(space->points, fitted.kept);
  }
  if (rules.interpolate)
  {
    interpolate(curve, fitted.controls);
    if (space)
    {
      interpolate(curve, fitted.spaceControls);
    }
  }
  fitted.parameters = evenParameters(curve, fitted, space, rules.step);
  for (const double t : fitted.parameters)
  {
    fitted.places.push_back(curve.at(t));
    fitted.seen.push_back(seenAt(fitted.places.back(), fitted, space));
  }
  return fitted;
}

} // namespace oversketch
