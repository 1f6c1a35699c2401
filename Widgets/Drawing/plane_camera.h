// A camera that looks straight at a canvas, moved and brought nearer over it.
#ifndef oversketch_widgets_drawing_plane_camera_h
#define oversketch_widgets_drawing_plane_camera_h

#include "Stroke/canvas.h"

class vtkRenderer;

namespace oversketch
{

// Orthographic along -z, upright, the whole canvas and a twentieth of it on every side in the viewport.
void lookAtCanvas(vtkRenderer* renderer, const Canvas& canvas);

// The place of the plane z = 0 under a position of the window [px].
Vector2 placeUnder(vtkRenderer* renderer, const Vector2& position);

// Moves what is seen at one position to another one.
void pan(vtkRenderer* renderer, const Vector2& from, const Vector2& to);

// `factor` times as large, the place under the position stays there; F' = c + (F - c) s' / s. Between a
// thousandth and a thousand times the size at which the canvas fits the viewport.
void zoomAbout(vtkRenderer* renderer, const Canvas& canvas, const Vector2& position, double factor);

} // namespace oversketch
#endif
