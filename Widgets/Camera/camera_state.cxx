#include "camera_state.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

double halfTangent(double degrees)
{
  return std::tan(0.5 * vtkMath::RadiansFromDegrees(degrees));
}

double angleOf(double halfTangent)
{
  return 2.0 * vtkMath::DegreesFromRadians(std::atan(halfTangent));
}

// How far a view of that size is seen to the right and up, in halves of its smaller side.
Eigen::Vector2d reach(const int size[2])
{
  const double wide = std::max(size[0], 1), high = std::max(size[1], 1);
  return { std::max(1.0, wide / high), std::max(1.0, high / wide) };
}

} // namespace

CameraState::CameraState(vtkCamera* camera)
  : position(camera->GetPosition())
  , focal(camera->GetFocalPoint())
  , up(camera->GetViewUp())
  , angle(camera->GetViewAngle())
  , scale(camera->GetParallelScale())
  , centre(camera->GetWindowCenter())
{
}

void CameraState::putInto(vtkCamera* camera) const
{
  camera->SetPosition(this->position.data());
  camera->SetFocalPoint(this->focal.data());
  camera->SetViewUp(this->up.data());
  camera->SetViewAngle(this->angle);
  camera->SetParallelScale(this->scale);
  camera->SetWindowCenter(this->centre[0], this->centre[1]);
}

void CameraState::turn(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& about)
{
  this->position = about + rotation * (this->position - about);
  this->focal = about + rotation * (this->focal - about);
  this->up = rotation * this->up;
}

void CameraState::move(const Eigen::Vector3d& by)
{
  this->position += by;
  this->focal += by;
}

void CameraState::fit(const int before[2], const int now[2])
{
  const Eigen::Vector2d had = reach(before), has = reach(now);
  if (has != had) // to the bit as it was
  {
    this->centre = this->centre.cwiseProduct(had).cwiseQuotient(has);
    this->angle = angleOf(has[1] / had[1] * halfTangent(this->angle));
    this->scale *= has[1] / had[1];
  }
}

vtkSmartPointer<vtkCamera> unclippedCamera(vtkRenderer* renderer)
{
  auto camera = vtkSmartPointer<vtkCamera>::New();
  camera->DeepCopy(renderer->GetActiveCamera());
  camera->SetClippingRange(camera->GetDistance(), 2.0 * camera->GetDistance());
  return camera;
}

double viewHeight(vtkCamera* camera)
{
  return 2.0 * (camera->GetParallelProjection()
                   ? camera->GetParallelScale()
                   : camera->GetDistance() * halfTangent(camera->GetViewAngle()));
}

double FirstView::zoom() const
{
  return this->camera->GetParallelProjection()
           ? this->state.scale / this->camera->GetParallelScale()
           : halfTangent(this->state.angle) / halfTangent(this->camera->GetViewAngle());
}

void FirstView::setZoom(double zoom, const Eigen::Vector2d& at) const
{
  const double z = std::clamp(zoom, 0.1, 10.0);
  const Eigen::Vector2d centre =
    z / this->zoom() * (at + Eigen::Vector2d(this->camera->GetWindowCenter())) - at;
  this->camera->SetWindowCenter(centre[0], centre[1]);
  if (this->camera->GetParallelProjection())
  {
    this->camera->SetParallelScale(this->state.scale / z);
  }
  else
  {
    // vtkCamera::Zoom divides the angle, which is not the apparent size.
    this->camera->SetViewAngle(angleOf(halfTangent(this->state.angle) / z));
  }
}

void FirstView::setParallel(bool parallel)
{
  if (parallel == (this->camera->GetParallelProjection() != 0))
  {
    return;
  }
  const double distance = (this->state.focal - this->state.position).norm();
  if (parallel)
  {
    this->state.scale = distance * halfTangent(this->state.angle);
    this->camera->SetParallelScale(0.5 * viewHeight(this->camera));
  }
  else
  {
    this->state.angle = angleOf(this->state.scale / distance);
    this->camera->SetViewAngle(angleOf(this->camera->GetParallelScale() / this->camera->GetDistance()));
  }
  this->camera->SetParallelProjection(parallel);
}

void FirstView::roll(double degrees)
{
  this->camera->Roll(degrees);
  this->spin = std::fmod(std::fmod(this->spin + degrees, 360.0) + 360.0, 360.0);
}

SightLines::SightLines(vtkRenderer* renderer)
  : Renderer(renderer)
{
  const auto camera = unclippedCamera(renderer);
  vtkMatrix4x4* viewFromWorld =
    camera->GetCompositeProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0);
  this->WorldFromView =
    Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(viewFromWorld->GetData()).inverse();
}

Line SightLines::at(double x, double y) const
{
  this->Renderer->SetDisplayPoint(x, y, 0.0);
  this->Renderer->DisplayToView();
  const double* view = this->Renderer->GetViewPoint();
  const Eigen::Vector4d near = this->WorldFromView * Eigen::Vector4d(view[0], view[1], -1.0, 1.0);
  const Eigen::Vector4d far = this->WorldFromView * Eigen::Vector4d(view[0], view[1], 1.0, 1.0);
  return Line::Through(near.hnormalized(), far.hnormalized());
}

} // namespace oversketch
