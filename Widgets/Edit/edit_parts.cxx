#include "edit_parts.h"

#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchStepRunner.h"

#include "Mesh/context.h"

#include "vtkAlgorithm.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

namespace oversketch
{

void EditParts::showAreas(vtkRenderer* renderer, bool show)
{
  if (!renderer)
  {
    return;
  }
  vtkOversketchAreaSelectRepresentation* shown = this->areas->GetAreaSelectRepresentation();
  if (show && this->areas->GetAreas()->GetNumberOfLines() > 0)
  {
    shown->SetRenderer(renderer);
    renderer->AddViewProp(shown);
  }
  else if (!this->areas->GetEnabled())
  {
    renderer->RemoveViewProp(shown);
  }
}

std::pair<bool, Message> ranTold(vtkAlgorithm* system)
{
  Message said;
  try
  {
    StepRunner::Listener listener;
    listener.warning = [&](const Message& warning) { said = warning; };
    StepRunner(system, listener).Run();
    return { true, said };
  }
  catch (const Error& error)
  {
    return { false, error.message() };
  }
}

} // namespace oversketch
