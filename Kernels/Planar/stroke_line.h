// A stroke as the mesh takes it: its polyline's places, and what the stroke is.
#ifndef oversketch_kernels_planar_stroke_line_h
#define oversketch_kernels_planar_stroke_line_h

#include "Planar/planar_mesh.h"
#include "Raster/distance_maps.h"

namespace oversketch
{

struct StrokeLine
{
  int stroke = -1; // its number
  bool closed = false;
  Polyline places;            // world; the first is not repeated. An end that joins another stroke lies there
  std::vector<double> params; // of each place: arc length along the stroke
  double length = 0.0;        // of the whole stroke, a closed one's way back to its first sample included
  Role role = Role::Unknown;
  int region = -1, childRegion = -1, object = -1; // as StrokeClass says
  Treatment treatment = Treatment::Fill;
};

std::vector<StrokeLine> strokeLines(const std::vector<StrokePolyline>& polylines,
  const std::vector<DrawnStroke>& strokes,
  const std::vector<StrokeClass>& classes,
  const std::vector<Treatment>& treatments);

// Which strokes lie in a hole, and are gone with it: neither its own nor those of islands, which bound
// something in it that is no hole. Numbered as classes are.
std::vector<bool> inHoles(const std::vector<StrokeClass>& classes, const std::vector<Treatment>& treatments);

} // namespace oversketch
#endif
