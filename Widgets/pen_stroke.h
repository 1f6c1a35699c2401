// A stroke as the pen makes it: samples in the viewport and the view they were drawn in.
#ifndef oversketch_pen_stroke_h
#define oversketch_pen_stroke_h

#include "Stroke/polyline.h"

#include <array>

class vtkPolyData;
class vtkRenderer;

namespace oversketch
{

struct PenView
{
  std::array<double, 16> view{}, projection{}; // row-major
  std::array<int, 2> size{};                   // px

  static PenView of(vtkRenderer* renderer);
  bool operator==(const PenView& other) const
  {
    return this->size == other.size && this->view == other.view && this->projection == other.projection;
  }
};

struct PenStroke
{
  PenView view;
  Polyline points; // px from the viewport's lower left corner
  std::vector<double> pressures, times;

  int count() const { return static_cast<int>(this->points.size()); }
  void add(const Vector2& point, double pressure, double time);
  void removeLast(double length);
  // This stroke with the part that `over` was drawn over replaced.
  PenStroke resketched(const PenStroke& over) const;
  void putInto(vtkPolyData* polyData) const;
};

} // namespace oversketch
#endif
