#include "look.h"

#include "vtkCamera.h"

namespace oversketch_session
{

Look lookOf(vtkCamera* camera)
{
  Look look;
  camera->GetPosition(look.position.data());
  camera->GetFocalPoint(look.focus.data());
  camera->GetViewUp(look.up.data());
  look.angle = camera->GetViewAngle();
  look.height = camera->GetParallelScale();
  look.parallel = camera->GetParallelProjection() != 0;
  camera->GetWindowCenter(look.shift.data());
  return look;
}

void lookAs(const Look& look, vtkCamera* camera)
{
  camera->SetPosition(look.position.data());
  camera->SetFocalPoint(look.focus.data());
  camera->SetViewUp(look.up.data());
  camera->SetViewAngle(look.angle);
  camera->SetParallelScale(look.height);
  camera->SetParallelProjection(look.parallel);
  camera->SetWindowCenter(look.shift[0], look.shift[1]);
}

} // namespace oversketch_session
