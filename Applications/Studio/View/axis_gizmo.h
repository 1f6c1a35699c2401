// The world's axes as the camera sees them, in a corner over the view: a click on an end looks from there, a
// drag turns the model. Qt's, not VTK's vtkCameraOrientationWidget, which picks with each move of the mouse
// and draws its own renderer with each frame: this one is painted when the camera has turned.
#ifndef oversketch_applications_studio_view_axis_gizmo_h
#define oversketch_applications_studio_view_axis_gizmo_h

#include "vtkSmartPointer.h"

#include <QPointF>
#include <QWidget>

#include <array>
#include <optional>

class vtkRenderer;

namespace oversketch_studio
{

class Viewport;

class AxisGizmo : public QWidget
{
  Q_OBJECT

public:
  explicit AxisGizmo(Viewport* view);
  ~AxisGizmo() override;

  // Where an axis ends: its positive end or its negative one.
  QPointF end(int axis, bool negative) const;
  void setDark(bool dark);

signals:
  // The camera is orthographic, or no more.
  void projected(bool parallel);

protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;

private:
  struct End
  {
    int axis;
    bool negative;
    bool operator==(const End& other) const { return axis == other.axis && negative == other.negative; }
  };
  void look(); // after a frame
  std::optional<End> endAt(const QPointF& at) const;
  void setHovered(const std::optional<End>& end);

  Viewport* View;
  vtkSmartPointer<vtkRenderer> Renderer; // it outlives the view that it is in
  unsigned long Observer = 0;
  std::array<std::array<double, 3>, 3> Axes{}; // to the right, up, towards the eye
  std::optional<End> Hovered;
  QPoint Pressed, Last;
  bool Turns = false, Dark = true, Parallel = false;
  bool Passes = false; // what goes on from a press beside the ends is the view's
};

} // namespace oversketch_studio
#endif
