// A stroke as the pen makes it: samples in the viewport and the view they were drawn in.
#ifndef oversketch_widgets_pen_pen_stroke_h
#define oversketch_widgets_pen_pen_stroke_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "Stroke/polyline.h"
#include "pen_view.h"

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

struct PenStroke
{
  PenView view;
  Polyline points; // px from the viewport's lower left corner
  std::vector<double> pressures, times;
  Vector2 moved = Vector2::Zero(); // px, since it was drawn

  int count() const { return static_cast<int>(this->points.size()); }
  void add(const Vector2& point, double pressure, double time);
  void removeLast(double length);
  // This stroke with the part that `over` was drawn over replaced.
  PenStroke resketched(const PenStroke& over) const;
  void putInto(vtkPolyData* polyData) const;
  // Reads a polydata that holds one stroke with its view; without Pressure it is 1, without Time or Moved 0.
  // Throws Error for others.
  static PenStroke of(vtkPolyData* polyData);
};

// Several strokes into one polydata, which stays the same object.
OVERSKETCHWIDGETSPEN_EXPORT void putInto(vtkPolyData* all,
  const std::vector<vtkSmartPointer<vtkPolyData>>& strokes);

} // namespace oversketch
#endif
