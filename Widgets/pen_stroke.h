// A stroke as the pen makes it: samples in the viewport and the view they were drawn in.
#ifndef oversketch_pen_stroke_h
#define oversketch_pen_stroke_h

#include "Mesh/view.h"
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
  // Throws Error for matrices that make no view.
  View kernelView() const;
  // The same to the eye: a camera that was turned away and back differs by rounding.
  bool operator==(const PenView& other) const;
  // The same eye and direction, whatever the zoom and the size of the window.
  bool fromTheSamePlace(const PenView& other) const;
  // Puts the renderer's camera where the view was seen from.
  void putInto(vtkRenderer* renderer) const;
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
  // Of a polydata that holds one stroke with its view; without Pressure it is 1, without Time 0. Throws Error
  // for others.
  static PenStroke of(vtkPolyData* polyData);
};

} // namespace oversketch
#endif
