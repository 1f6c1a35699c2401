// The gizmo of the tool that places: arrows, boxes, rings and a square over the model, as large at any zoom.
#ifndef oversketch_applications_studio_tools_place_gizmo_h
#define oversketch_applications_studio_tools_place_gizmo_h

#include "gizmo_drag.h"

#include "vtkNew.h"

#include <array>

class vtkActor2D;
class vtkPoints;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace oversketch_studio
{

class Viewport;

class PlaceGizmo
{
public:
  explicit PlaceGizmo(Viewport* view);
  ~PlaceGizmo();
  PlaceGizmo(const PlaceGizmo&) = delete;
  PlaceGizmo& operator=(const PlaceGizmo&) = delete;

  // What it stands on: the middle before the pose, and the pose.
  struct Stand
  {
    oversketch::Vector3 middle;
    oversketch::Pose pose;
  };
  void show(const std::optional<Stand>& stand);
  const std::optional<Stand>& stand() const { return this->Shown; }
  // A frame begins: where it is seen in it.
  void follow();
  // The handle at a place of the screen [px]; the one that is painted stronger, under the cursor or in the
  // hand.
  std::optional<GizmoGrip> at(const oversketch::Vector2& place) const;
  void light(const std::optional<GizmoGrip>& grip);
  // For a picture without it.
  void setVisible(bool visible) { this->Visible = visible; }
  void setPixelRatio(double ratio);

private:
  using Colour = std::array<unsigned char, 3>;
  void add(const std::vector<oversketch::Vector2>& places, const Colour& colour, bool isFilled);
  void paint();

  Viewport* View;
  std::optional<Stand> Shown;
  std::optional<GizmoShape> Seen;
  std::optional<GizmoGrip> Lit;
  double Ratio = 1.0;
  bool Visible = true;
  vtkNew<vtkPolyData> Data;
  vtkNew<vtkActor2D> Actor;
};

} // namespace oversketch_studio
#endif
