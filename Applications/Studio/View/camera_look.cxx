#include "camera_look.h"

#include "viewport.h"

#include "camera_state.h"

#include "vtkCamera.h"
#include "vtkOversketchInteractorStyle.h"
#include "vtkRenderer.h"

namespace oversketch_studio
{

using oversketch_session::Look;

Look lookOf(Viewport& view)
{
  vtkCamera* camera = view.renderer()->GetActiveCamera();
  Look look;
  camera->GetPosition(look.position.data());
  camera->GetFocalPoint(look.focus.data());
  camera->GetViewUp(look.up.data());
  look.angle = camera->GetViewAngle();
  look.height = camera->GetParallelScale();
  look.parallel = camera->GetParallelProjection() != 0;
  camera->GetWindowCenter(look.shift.data());
  look.size = view.fittedSize();
  look.upAxis = view.camera()->GetUpAxis();
  return look;
}

void lookAs(const Look& look, Viewport& view)
{
  vtkCamera* camera = view.renderer()->GetActiveCamera();
  camera->SetPosition(look.position.data());
  camera->SetFocalPoint(look.focus.data());
  camera->SetViewUp(look.up.data());
  camera->SetViewAngle(look.angle);
  camera->SetParallelScale(look.height);
  camera->SetParallelProjection(look.parallel);
  camera->SetWindowCenter(look.shift[0], look.shift[1]);
  if (look.size)
  {
    oversketch::CameraState state(camera);
    state.fit(look.size->data(), view.fittedSize().data());
    state.putInto(camera);
  }
  view.renderer()->ResetCameraClippingRange();
  view.renderSoon();
}

} // namespace oversketch_studio
