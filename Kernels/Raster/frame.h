// The raster that a drawing's areas and distances are measured on: lines to pixels, areas to pixels.
#ifndef oversketch_kernels_raster_frame_h
#define oversketch_kernels_raster_frame_h

#include "Stroke/canvas.h"

#include <array>
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

// A polyline [world] in px; empty when a point is not finite or nearest to one of the raster's outermost
// samples or beside them: the polyline leaves the canvas.
Polyline onRaster(const Frame& frame, const Polyline& points);

// The samples of a line of 1 px along a polyline [px], in its order, 8-connected: of each column that a flat
// part passes and each row that a steep one does, the nearest sample, and lines between those that are not
// neighbours. Points are not rounded first: that would put corners on a smooth curve. The same in either
// direction, up to order.
std::vector<Place> linePixels(const Polyline& points, bool closed);

// Sets `value` at the samples inside polygons [px], by the even-odd rule. Where a polygon's line is drawn
// over it, what is left are the samples inside the line.
void fillEvenOdd(const Frame& frame,
  const std::vector<Polyline>& polygons,
  int value,
  std::vector<int>& image);

} // namespace oversketch
#endif
