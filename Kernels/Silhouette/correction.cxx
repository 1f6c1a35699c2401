#include "Silhouette/correction.h"

#include "Silhouette/outline.h"

#include <algorithm>

namespace oversketch
{

std::vector<OutlineCorrection> correctOutline(const Mesh& deformed,
  const std::vector<char>& chosen,
  const Polyline& stroke,
  const View& view,
  double omega,
  double tolerance,
  double reach,
  const Context& context)
{
  constexpr double onOutline = 1.0; // px; the loop runs between pixel centres and cuts sharper corners
  std::vector<NearestPlace> loops;
  const PixelWindow window = strokeWindow(stroke, reach + 2.0 * onOutline + 2.0);
  for (const OutlineLoop& loop : traceOutline(deformed, view, window, context))
  {
    loops.emplace_back(loop.points, loop.closed);
  }
  const NearestPlace pen(stroke);
  const std::vector<double> lengths = arcLengths(stroke);
  std::vector<OutlineCorrection> corrections;
  if (!(lengths.back() > 0.0))
  {
    return corrections;
  }
  for (int v = 0; v < deformed.vertexCount(); ++v)
  {
    if (!chosen[v] || !view.inFront(deformed.points[v]))
    {
      continue;
    }
    const Vector3 display = view.toDisplay(deformed.points[v]);
    const Vector2 place = display.head<2>();
    if (pen(place, reach + onOutline).segment < 0)
    {
      continue;
    }
    NearestPlace::Answer border;
    border.distance = onOutline;
    for (const NearestPlace& loop : loops)
    {
      const NearestPlace::Answer answer = loop(place, border.distance);
      if (answer.segment >= 0 && answer.distance <= border.distance)
      {
        border = answer;
      }
    }
    if (border.segment < 0)
    {
      continue;
    }
    const NearestPlace::Answer goal = pen(border.place, reach);
    if (goal.segment < 0 || goal.distance <= tolerance)
    {
      continue;
    }
    const double along = goal.along(lengths);
    const double relative = along / lengths.back();
    if (relative >= omega && relative <= 1.0 - omega)
    {
      corrections.push_back({ v, relative, view.toWorld(place + goal.place - border.place, display[2]) });
    }
  }
  return corrections;
}

} // namespace oversketch
