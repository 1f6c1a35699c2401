// Lines of the world as a view shows them, and a line of the picture that grows.
#ifndef oversketch_widgets_pen_seen_line_h
#define oversketch_widgets_pen_seen_line_h

#include "Mesh/view.h"
#include "OversketchWidgetsPenModule.h" // For export macro
#include "Stroke/polyline.h"

#include "vtkNew.h"

#include <vector>

class vtkActor2D;
class vtkPolyData;
class vtkProperty2D;

namespace oversketch
{

// The polylines of a polydata; those that end with the id that they begin with without it.
struct WorldLine
{
  std::vector<Vector3> points;
  bool closed = false;
};
OVERSKETCHWIDGETSPEN_EXPORT std::vector<WorldLine> linesOf(vtkPolyData* lines);

// A line in a view [px], or several, in pieces where they pass behind the eye.
OVERSKETCHWIDGETSPEN_EXPORT std::vector<Polyline> seenIn(const View& view,
  const std::vector<Vector3>& line,
  bool closed = false);
OVERSKETCHWIDGETSPEN_EXPORT std::vector<Polyline> seenIn(const View& view,
  const std::vector<WorldLine>& lines);

// How far a place of the picture is from a line as it is seen [px]; infinite where none is seen.
OVERSKETCHWIDGETSPEN_EXPORT double distanceTo(const View& view,
  const std::vector<Vector3>& line,
  bool closed,
  const Vector2& place);

// A line in the picture that grows by segments.
struct Line2D
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkActor2D> actor;

  explicit Line2D(vtkProperty2D* property);
  void set(const Polyline& points) { this->setAll({ points }); }
  void setAll(const std::vector<Polyline>& lines);
  // Joined to the point before, if there is one.
  void add(const Vector2& point, bool joined = true);
};

} // namespace oversketch
#endif
