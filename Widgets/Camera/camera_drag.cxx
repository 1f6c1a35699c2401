#include "camera_drag.h"

#include "camera_moves.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

bool turns(CameraDrag::Kind kind)
{
  return kind == CameraDrag::Kind::Trackball || kind == CameraDrag::Kind::Turntable;
}

Eigen::Hyperplane<double, 3> planeThrough(const CameraState& camera, const Eigen::Vector3d& point)
{
  return { camera.direction(), point };
}

// A place that a turn takes with it where the hand begins beside the models: on the ball about them, or where
// the line of sight is nearest to it.
Eigen::Vector3d placeBeside(const Line& sight, const Eigen::Vector3d& centre, double radius)
{
  const Eigen::Vector3d foot = sight.projection(centre);
  const double inside = radius * radius - (foot - centre).squaredNorm();
  return inside > 0.0 ? Eigen::Vector3d(foot - std::sqrt(inside) * sight.direction()) : foot;
}

} // namespace

CameraDrag::CameraDrag(Kind kind,
  int button,
  double x,
  double y,
  vtkRenderer* in,
  MeshPicker& picker,
  const FirstView& first,
  int up)
  : What(kind)
  , Up(up)
  , Button(button)
  , X(x)
  , Y(y)
  , Height(std::max(1, in->GetSize()[1]))
  , Zoom(first.zoom())
  , AtPress(first.camera)
  , From(AtPress)
  , Sight(in)
{
  const double* picked =
    kind == Kind::Zoom ? nullptr : picker.pick(static_cast<int>(x), static_cast<int>(y), in);
  const auto models = turns(kind) ? modelsIn(in) : std::nullopt;
  this->Pivot = kind == Kind::Turntable && picked ? Eigen::Vector3d(picked)
                : models && !picked               ? models->centre
                                                  : this->From.focal;
  if (turns(kind))
  {
    this->From = straightened(this->AtPress, picked ? Eigen::Vector3d(picked) : this->Pivot, in);
    this->From.putInto(first.camera);
    this->Sight = SightLines(in);
    this->Pivot = kind == Kind::Trackball && picked ? this->From.focal : this->Pivot;
  }
  this->Pressed = this->Sight.at(x, y);
  this->Anchor = picked        ? Eigen::Vector3d(this->Pressed.projection(Eigen::Vector3d(picked)))
                 : turns(kind) ? placeBeside(this->Pressed, this->Pivot, models ? models->radius : 0.0)
                               : this->Pressed.intersectionPoint(planeThrough(this->From, this->From.focal));
}

void CameraDrag::move(double x, double y, FirstView& first)
{
  this->Moved = true;
  CameraState camera = this->From;
  const Line now = this->Sight.at(x, y);
  switch (this->What)
  {
    case Kind::Trackball:
      camera.turn(trackballTurn(this->Pivot, this->Anchor, this->Pressed, now).conjugate(), this->Pivot);
      break;
    case Kind::Turntable:
      camera.turn(turntableTurn(camera, Eigen::Vector2d(x - this->X, y - this->Y) / this->Height, this->Up),
        this->Pivot);
      break;
    case Kind::Pan:
      camera.move(this->Anchor - now.intersectionPoint(planeThrough(camera, this->Anchor)));
      break;
    case Kind::Zoom: // the height of the view is one decade
      first.setZoom(this->Zoom * std::pow(10.0, (y - this->Y) / this->Height));
      return;
  }
  camera.putInto(first.camera);
}

} // namespace oversketch
