#include "Planar/stroke_line.h"

#include <set>

namespace oversketch
{

std::vector<StrokeLine> strokeLines(const std::vector<StrokePolyline>& polylines,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments)
{
  std::vector<StrokeLine> lines;
  for (const StrokePolyline& polyline : polylines)
  {
    const DrawnStroke& stroke = strokes[polyline.stroke];
    const StrokeClass& which = classes[polyline.stroke];
    const std::vector<double> lengths = arcLengths(stroke.points, stroke.closed);
    StrokeLine line;
    line.stroke = polyline.stroke;
    line.closed = polyline.closed;
    line.length = lengths.back();
    line.role = which.role;
    line.region = which.region;
    line.childRegion = which.childRegion;
    line.object = which.object;
    line.treatment = treatments[polyline.stroke];
    for (const int sample : polyline.samples)
    {
      line.places.push_back(stroke.points[sample]);
      line.params.push_back(lengths[sample]);
    }
    for (const int end : { 0, 1 })
    {
      const StrokeJoin& join = polyline.joins[end];
      if (join.stroke >= 0)
      {
        (end == 0 ? line.places.front() : line.places.back()) = strokes[join.stroke].points[join.sample];
      }
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<bool> inHoles(const std::vector<StrokeClass>& classes, const std::vector<Treatment>& treatments)
{
  std::set<int> holes; // regions
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    if (classes[i].childRegion >= 0 && treatments[i] == Treatment::Hole)
    {
      holes.insert(classes[i].childRegion);
    }
  }
  std::vector<bool> result(classes.size());
  for (std::size_t i = 0; i < classes.size(); ++i)
  {
    const bool island = classes[i].childRegion >= 0 && treatments[i] != Treatment::Hole;
    result[i] = !island && holes.count(classes[i].region) > 0;
  }
  return result;
}

} // namespace oversketch
