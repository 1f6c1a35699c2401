// Where a place of the canvas is in its picture.
#ifndef oversketch_kernels_inflate_texture_h
#define oversketch_kernels_inflate_texture_h

#include "Stroke/canvas.h"

namespace oversketch
{

// Source: image-assisted modelling, section 15 (2.4 of the paper): s = (x - x_o) / w, t = (y - y_o) / h, z
// ignored: front and back have the same; along a wall all are. Not clamped.
inline Vector2 textureCoordinates(const Canvas& canvas, const Vector2& place)
{
  return (place - canvas.corner).cwiseQuotient(canvas.size);
}

// The same in a picture of the back, taken from behind, so that its left is at the canvas's right; it fills
// the canvas.
inline Vector2 backTextureCoordinates(const Canvas& canvas, const Vector2& place)
{
  const Vector2 front = textureCoordinates(canvas, place);
  return { 1.0 - front[0], front[1] };
}

} // namespace oversketch
#endif
