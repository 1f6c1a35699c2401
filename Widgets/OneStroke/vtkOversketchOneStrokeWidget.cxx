#include "vtkOversketchOneStrokeWidget.h"

#include "vtkOversketchOneStroke.h"

#include "vtkNew.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkOversketchOneStrokeWidget);

vtkOversketchOneStrokeWidget::vtkOversketchOneStrokeWidget()
{
  const vtkNew<vtkOversketchOneStroke> system;
  this->SetSystem(system);
}

vtkOversketchOneStrokeWidget::~vtkOversketchOneStrokeWidget() = default;

void vtkOversketchOneStrokeWidget::SetOneStroke(vtkOversketchOneStroke* system)
{
  this->SetSystem(system);
}

vtkOversketchOneStroke* vtkOversketchOneStrokeWidget::GetOneStroke()
{
  return static_cast<vtkOversketchOneStroke*>(this->GetSystem());
}
