#include "camera_moves.h"

#include "Mesh/rotation.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

using Eigen::Vector3d;

constexpr double stepDegrees = 5.0, stepOfHeight = 0.05, stepOfZoom = 1.1;

} // namespace

Eigen::Quaterniond trackballTurn(const Eigen::Vector3d& centre,
  const Eigen::Vector3d& picked,
  const Line& press,
  const Line& now)
{
  const Eigen::Vector3d from = picked - centre;
  const double radius = from.norm();
  if (!(radius > 0.0))
  {
    return Eigen::Quaterniond::Identity();
  }
  // The picked point lies beyond the foot of the perpendicular from the centre when it is on the far side.
  const double side = press.direction().dot(from) > 0.0 ? 1.0 : -1.0;
  const Eigen::Vector3d foot = now.projection(centre) - centre;
  const double inside = radius * radius - foot.squaredNorm();
  const Eigen::Vector3d to =
    inside > 0.0 ? Eigen::Vector3d(foot + side * std::sqrt(inside) * now.direction()) : foot;
  return rotationBetween(from, to);
}

Eigen::Quaterniond turntableTurn(const CameraState& camera, const Eigen::Vector2d& moved, int up)
{
  const Vector3d direction = camera.direction();
  const double upright =
    camera.up[up] < -1e-9 ? -1.0 : 1.0; // hanging head down the model turns with the hand
  double pitch = vtkMath::Pi() * moved[1];
  if (upright > 0.0)
  {
    constexpr double quarter = 0.5 * vtkMath::Pi();
    const double elevation = std::asin(std::clamp(-direction[up], -1.0, 1.0));
    pitch = elevation - std::clamp(elevation - pitch, -quarter, quarter);
  }
  const Eigen::AngleAxisd yaw(-vtkMath::Pi() * moved[0] * upright, Vector3d::Unit(up));
  return yaw * Eigen::AngleAxisd(pitch, direction.cross(camera.up).normalized());
}

CameraState straightened(const CameraState& camera, const Vector3d& point, vtkRenderer* in)
{
  CameraState straight = camera;
  const Vector3d direction = camera.direction(), right = direction.cross(camera.up).normalized();
  const double half =
    in->GetActiveCamera()->GetParallelProjection()
      ? camera.scale
      : direction.dot(point - camera.position) * std::tan(0.5 * vtkMath::RadiansFromDegrees(camera.angle));
  straight.move(half * (camera.centre[0] * in->GetTiledAspectRatio() * right +
                         camera.centre[1] * right.cross(direction)));
  straight.centre.setZero();
  return straight;
}

void lookFromSide(CameraState& camera, const Vector3d& point, int axis, bool negative, int up)
{
  const double distance = (camera.position - camera.focal).norm(), side = negative ? -1.0 : 1.0;
  camera.focal = point;
  camera.position = point + side * distance * Vector3d::Unit(axis);
  const Vector3d back = up == 1 ? Vector3d(-Vector3d::UnitZ()) : Vector3d::UnitY();
  camera.up = axis == up ? Vector3d(side * back) : Vector3d::Unit(up);
  camera.centre.setZero();
}

std::optional<Box> modelsIn(vtkRenderer* renderer)
{
  vtkBoundingBox box;
  vtkActorCollection* actors = renderer->GetActors();
  vtkCollectionSimpleIterator at;
  actors->InitTraversal(at);
  while (vtkActor* actor = actors->GetNextActor(at))
  {
    const double* bounds = actor->GetVisibility() && actor->GetPickable() ? actor->GetBounds() : nullptr;
    if (bounds && vtkMath::AreBoundsInitialized(bounds))
    {
      box.AddBounds(bounds);
    }
  }
  if (!box.IsValid())
  {
    return std::nullopt;
  }
  Box models;
  box.GetCenter(models.centre.data());
  models.radius = 0.5 * box.GetDiagonalLength();
  return models;
}

bool moveByKey(const CameraAction& action, FirstView& first)
{
  const double degrees = stepDegrees * action.sign;
  switch (action.kind)
  {
    case CameraAction::Spin:
      first.roll(degrees);
      return true;
    case CameraAction::Turn:
    {
      CameraState camera(first.camera);
      camera.turn(Eigen::Quaterniond(
        Eigen::AngleAxisd(-vtkMath::RadiansFromDegrees(degrees), Vector3d::Unit(action.axis))));
      camera.putInto(first.camera);
      return true;
    }
    case CameraAction::Orbit:
      action.axis == 0 ? first.camera->Azimuth(degrees) : first.camera->Elevation(degrees);
      first.camera->OrthogonalizeViewUp();
      return true;
    case CameraAction::Pan:
    {
      first.camera->OrthogonalizeViewUp();
      CameraState camera(first.camera);
      const Vector3d axes[] = { camera.direction().cross(camera.up), camera.up, camera.direction() };
      camera.move(action.sign * stepOfHeight * viewHeight(first.camera) * axes[action.axis]);
      camera.putInto(first.camera);
      return true;
    }
    case CameraAction::Zoom:
      first.setZoom(first.zoom() * std::pow(stepOfZoom, action.sign));
      return true;
    default:
      return false;
  }
}

} // namespace oversketch
