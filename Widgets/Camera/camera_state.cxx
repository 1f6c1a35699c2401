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

} // namespace

CameraState::CameraState(vtkCamera* camera)
  : position(camera->GetPosition())
  , focal(camera->GetFocalPoint())
  , up(camera->GetViewUp())
  , angle(camera->GetViewAngle())
  , scale(camera->GetParallelScale())
{
}

void CameraState::putInto(vtkCamera* camera) const
{
  camera->SetPosition(this->position.data());
  camera->SetFocalPoint(this->focal.data());
  camera->SetViewUp(this->up.data());
  camera->SetViewAngle(this->angle);
  camera->SetParallelScale(this->scale);
}

void CameraState::turn(const Eigen::Quaterniond& rotation)
{
  this->position = this->focal + rotation * (this->position - this->focal);
  this->up = rotation * this->up;
}

void CameraState::move(const Eigen::Vector3d& by)
{
  this->position += by;
  this->focal += by;
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

void FirstView::setZoom(double zoom) const
{
  const double z = std::clamp(zoom, 0.1, 10.0);
  if (this->camera->GetParallelProjection())
  {
    this->camera->SetParallelScale(this->state.scale / z);
  }
  else
  {
    // vtkCamera::Zoom divides the angle, which is not the apparent size.
    this->camera->SetViewAngle(
      2.0 * vtkMath::DegreesFromRadians(std::atan(halfTangent(this->state.angle) / z)));
  }
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
