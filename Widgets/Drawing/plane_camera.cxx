#include "plane_camera.h"

#include "vtkCamera.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace oversketch
{

namespace
{

constexpr double margin = 1.1;

// Half the height of what is seen when the canvas fits.
double fittingScale(vtkRenderer* renderer, const Canvas& canvas)
{
  const int* size = renderer->GetSize();
  const double aspect = size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.0;
  return 0.5 * margin * std::max(canvas.size[1], canvas.size[0] / std::max(aspect, 1e-6));
}

void lookAt(vtkRenderer* renderer, const Vector2& middle, double scale)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double away = 10.0 * scale;
  camera->SetParallelProjection(1);
  camera->SetParallelScale(scale);
  camera->SetFocalPoint(middle[0], middle[1], 0.0);
  camera->SetPosition(middle[0], middle[1], away);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(0.5 * away, 1.5 * away);
}

Vector2 middleOf(vtkRenderer* renderer)
{
  double focus[3];
  renderer->GetActiveCamera()->GetFocalPoint(focus);
  return { focus[0], focus[1] };
}

} // namespace

void lookAtCanvas(vtkRenderer* renderer, const Canvas& canvas)
{
  lookAt(renderer, canvas.corner + 0.5 * canvas.size, fittingScale(renderer, canvas));
}

Vector2 placeUnder(vtkRenderer* renderer, const Vector2& position)
{
  const int *size = renderer->GetSize(), *origin = renderer->GetOrigin();
  const Vector2 fromMiddle = position - Vector2(origin[0], origin[1]) - 0.5 * Vector2(size[0], size[1]);
  const double unit =
    2.0 * renderer->GetActiveCamera()->GetParallelScale() / std::max(size[1], 1); // a pixel's
  return middleOf(renderer) + unit * fromMiddle;
}

void pan(vtkRenderer* renderer, const Vector2& from, const Vector2& to)
{
  const Vector2 by = placeUnder(renderer, from) - placeUnder(renderer, to);
  lookAt(renderer, middleOf(renderer) + by, renderer->GetActiveCamera()->GetParallelScale());
}

void zoomAbout(vtkRenderer* renderer, const Canvas& canvas, const Vector2& position, double factor)
{
  const double fits = fittingScale(renderer, canvas), scale = renderer->GetActiveCamera()->GetParallelScale();
  const double next = std::clamp(scale / factor, 1e-3 * fits, 1e3 * fits);
  const Vector2 under = placeUnder(renderer, position);
  lookAt(renderer, under + (middleOf(renderer) - under) * (next / scale), next);
}

} // namespace oversketch
