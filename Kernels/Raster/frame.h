// The raster that a drawing's areas and distances are measured on: lines to pixels, areas to pixels.
#ifndef oversketch_raster_frame_h
#define oversketch_raster_frame_h

#include "Stroke/canvas.h"

#include <array>
#include <cstdint>
#include <vector>

namespace oversketch
{

// Sample (i, j) lies at origin + spacing * (i, j), as vtkImageData has it; row 0 is the lowest. "px" is one
// spacing.
struct Frame
{
  Vector2 origin = Vector2::Zero();
  double spacing = 1.0; // world units per px
  int width = 0, height = 0;

  std::size_t count() const { return static_cast<std::size_t>(this->width) * this->height; }
  std::size_t index(int x, int y) const { return static_cast<std::size_t>(y) * this->width + x; }
  Vector2 toPixels(const Vector2& world) const { return (world - this->origin) / this->spacing; }
  Vector2 toWorld(const Vector2& pixels) const { return this->origin + this->spacing * pixels; }
};

// Source: image-assisted modelling, section 0: `resolution` px (1024) along the canvas's longest side and two
// more on every side, so that no line on the canvas touches the raster's border. Throws
// Error(Failure::BadStroke) for a canvas that is not finite or has no extent, or a resolution outside 16 to
// 16384.
Frame frameOf(const Canvas& canvas, int resolution = 1024);

using Place = std::array<int, 2>; // (i, j) of a sample

// The samples nearest to a polyline's points [world]; none when one of them is not finite or falls on the
// raster's outermost samples or beside it: the polyline leaves the canvas.
std::vector<Place> rounded(const Frame& frame, const Polyline& points);

// The samples of a line of 1 px through the given ones, 8-connected, in their order; equal ones in a row
// once. The line between two samples does not depend on its direction.
std::vector<Place> linePixels(const std::vector<Place>& corners, bool closed);

// Sets `value` at the samples inside polygons through samples, by the even-odd rule, those on their sides
// left out or not as rounding has it: the polygons' own lines go over them. A sample inside that is on no
// line is inside the lines as well.
void fillEvenOdd(const Frame& frame,
  const std::vector<std::vector<Place>>& polygons,
  int value,
  std::vector<int>& image);

} // namespace oversketch
#endif
