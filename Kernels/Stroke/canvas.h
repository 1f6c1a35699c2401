// The canvas of a drawing: a rectangle of the world's plane z = 0, and how what the pen drew comes to it.
// Source: image-assisted modelling, sections 0 to 2.
#ifndef oversketch_kernels_stroke_canvas_h
#define oversketch_kernels_stroke_canvas_h

#include "Mesh/view.h"
#include "Stroke/polyline.h"

#include <optional>

namespace oversketch
{

// x right, y up, world units.
struct Canvas
{
  Vector2 corner = Vector2::Zero(); // the lower left one
  Vector2 size = Vector2::Ones();

  // The drawing's unit of length: the paper's "canvas size". Its meaning there is open; here the longest
  // side, never the visible window.
  double longest() const { return this->size.maxCoeff(); }
};

// The rectangle of a picture whose first sample's centre is at `origin`: samples are squares round their
// centres. Throws Error(Failure::BadStroke) for an empty picture or a spacing that is not positive.
Canvas pictureCanvas(const Vector2& origin, const Vector2& spacing, int columns, int rows);

// Where the ray through a display position [px] meets z = 0: p = a + t (b - a), t = -a_z / (b_z - a_z), a and
// b two places of the ray. Nothing when the ray grazes the plane (its angle to it is under 1e-6 rad) or meets
// it behind the eye.
std::optional<Vector2> ontoCanvas(const View& view, const Vector2& display);

// The projected samples of a stroke; those that do not meet the plane are left out.
Polyline ontoCanvas(const View& view, const Polyline& display);

// How many of a drawn stroke's samples, from the first on, go round once; 0 of an open one. It is closed when
// its ends are at most 0.02 longest sides and a fifth of its length apart and it has been farther from its
// first sample than that in between. The length is ours: an eye, smaller than 0.02 longest sides, closes, and
// a short arc stays open. A hand often goes on past its start: what runs beside the stroke's own beginning at
// the end, within half of that distance and a tenth of the stroke, is left out, and so many samples before it
// that the last step leads on to the first sample.
std::size_t samplesRound(const Polyline& points, const Canvas& canvas);

// ---- Where a place of the canvas is in its picture

// Source: image-assisted modelling, section 15 (2.4 of the paper): s = (x - x_o) / w, t = (y - y_o) / h, z
// ignored: front and back have the same; along a wall all are. Not clamped.
inline Vector2 textureCoordinates(const Canvas& canvas, const Vector2& place)
{
  return (place - canvas.corner).cwiseQuotient(canvas.size);
}

// Place in a picture of the back, taken from behind, so that its left is at the canvas's right; it fills
// the canvas.
inline Vector2 backTextureCoordinates(const Canvas& canvas, const Vector2& place)
{
  const Vector2 front = textureCoordinates(canvas, place);
  return { 1.0 - front[0], front[1] };
}

} // namespace oversketch
#endif
