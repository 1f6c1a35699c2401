#include "pen_view.h"

#include "Mesh/context.h"
#include "camera_state.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

bool alike(const std::array<double, 16>& a, const std::array<double, 16>& b)
{
  constexpr double rounding = 1e-9;
  const auto large = [](double x, double y) { return std::abs(x) < std::abs(y); };
  const double scale = std::abs(*std::max_element(a.begin(), a.end(), large));
  return std::equal(a.begin(),
    a.end(),
    b.begin(),
    [scale](double x, double y) { return std::abs(x - y) <= rounding * scale; });
}

} // namespace

PenView PenView::of(vtkRenderer* renderer)
{
  PenView result;
  const auto camera = unclippedCamera(renderer);
  std::copy_n(camera->GetViewTransformMatrix()->GetData(), 16, result.view.begin());
  std::copy_n(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(),
    16,
    result.projection.begin());
  std::copy_n(renderer->GetSize(), 2, result.size.begin());
  return result;
}

PenView PenView::of(vtkPolyData* stroke)
{
  const View view = ViewOf(stroke);
  PenView result;
  using Matrix = Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;
  Matrix(result.view.data()) = view.viewTransform();
  Matrix(result.projection.data()) = view.projectionTransform();
  result.size = { view.width(), view.height() };
  return result;
}

View PenView::kernelView() const
{
  using Matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;
  return View(Matrix(this->view.data()), Matrix(this->projection.data()), this->size[0], this->size[1]);
}

std::optional<View> PenView::sight() const
{
  try
  {
    return this->kernelView();
  }
  catch (const Error&)
  {
    return std::nullopt;
  }
}

Vector2 inViewport(vtkRenderer* renderer, double x, double y)
{
  const int* origin = renderer->GetOrigin();
  return { x - origin[0], y - origin[1] };
}

bool PenView::operator==(const PenView& other) const
{
  return this->size == other.size && alike(this->view, other.view) &&
         alike(this->projection, other.projection);
}

bool PenView::fromTheSamePlace(const PenView& other) const
{
  return alike(this->view, other.view) && (this->projection[15] == 0.0) == (other.projection[15] == 0.0);
}

void PenView::putInto(vtkRenderer* renderer) const
{
  double toWorld[16];
  vtkMatrix4x4::Invert(this->view.data(), toWorld);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  const double position[3] = { toWorld[3], toWorld[7], toWorld[11] };
  camera->SetPosition(position);
  camera->SetFocalPoint(position[0] - distance * toWorld[2],
    position[1] - distance * toWorld[6],
    position[2] - distance * toWorld[10]);
  camera->SetViewUp(toWorld[1], toWorld[5], toWorld[9]);
  // The last row of a perspective takes the depth, that of a parallel projection is 0 0 0 1.
  const bool perspective = this->projection[15] == 0.0;
  camera->SetParallelProjection(!perspective);
  if (perspective)
  {
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(1.0 / this->projection[5])));
    camera->SetWindowCenter(this->projection[2], this->projection[6]);
  }
  else
  {
    camera->SetParallelScale(1.0 / this->projection[5]);
    camera->SetWindowCenter(-this->projection[3], -this->projection[7]);
  }
  CameraState state(camera);
  state.fit(this->size.data(), renderer->GetSize());
  // The stroke tells nothing of the other projection.
  perspective ? state.scale = camera->GetParallelScale() : state.angle = camera->GetViewAngle();
  state.putInto(camera);
  renderer->ResetCameraClippingRange();
}

} // namespace oversketch
