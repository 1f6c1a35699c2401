// The view that a stroke is drawn in: the one reading of it from a camera or a stroke, and the way back.
#ifndef oversketch_widgets_camera_pen_view_h
#define oversketch_widgets_camera_pen_view_h

#include "Mesh/view.h"
#include "OversketchWidgetsCameraModule.h" // For export macro

#include <array>
#include <optional>

class vtkPolyData;
class vtkRenderer;

namespace oversketch
{

struct OVERSKETCHWIDGETSCAMERA_EXPORT PenView
{
  std::array<double, 16> view{}, projection{}; // row-major
  std::array<int, 2> size{};                   // px

  static PenView of(vtkRenderer* renderer);
  // The view of a stroke that carries it. Throws Error for others.
  static PenView of(vtkPolyData* stroke);
  // Throws Error for matrices that make no view.
  View kernelView() const;
  std::optional<View> sight() const; // absent for those
  // Whether it is the same to the eye: a camera that was turned away and back differs by rounding.
  bool operator==(const PenView& other) const;
  // Whether eye and direction are the same, whatever the zoom and the size of the window.
  bool fromTheSamePlace(const PenView& other) const;
  // Puts the renderer's camera where the view was seen from (CameraState::fit where the renderer has another
  // size).
  void putInto(vtkRenderer* renderer) const;
};

// A place of the window [px], from the lower left corner of the renderer's viewport.
OVERSKETCHWIDGETSCAMERA_EXPORT Vector2 inViewport(vtkRenderer* renderer, double x, double y);

} // namespace oversketch
#endif
