#include "vtkOversketchAugmentWidget.h"

#include "vtkOversketchAugment.h"
#include "vtkOversketchLiveStrokeRepresentation.h"
#include "vtkOversketchStrokeRepresentation.h"
#include "vtkOversketchStrokeWidget.h"

#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkOversketchAugmentWidget);

namespace
{

constexpr double radiusStep = 1.1;
constexpr double heightStep = 0.1;        // of the radius
constexpr double radiusOfDiagonal = 0.03; // the system's own
constexpr double leastRadius = 1e-3;      // of the diagonal

} // namespace

vtkOversketchAugmentWidget::vtkOversketchAugmentWidget()
{
  const vtkNew<vtkOversketchAugment> system;
  this->SetSystem(system);
}

vtkOversketchAugmentWidget::~vtkOversketchAugmentWidget() = default;

void vtkOversketchAugmentWidget::SetAugment(vtkOversketchAugment* system)
{
  this->SetSystem(system);
}

vtkOversketchAugment* vtkOversketchAugmentWidget::GetAugment()
{
  return static_cast<vtkOversketchAugment*>(this->GetSystem());
}

void vtkOversketchAugmentWidget::Look(vtkPolyData* mesh, vtkPolyData* stroke)
{
  vtkOversketchAugment* system = this->GetAugment();
  vtkNew<vtkPolyData> crest;
  vtkPolyData* curves = nullptr;
  if (mesh && system->PreviewCrest(mesh, stroke, crest))
  {
    const bool sketches = system->GetSketchMode() == vtkOversketchAugment::Silhouette;
    curves = system->GetInnerOutput(sketches ? "Sketch" : "Curves");
  }
  this->GetPen()->GetStrokeRepresentation()->SetSection(curves);
  this->GetPen()->GetStrokeRepresentation()->SetCrest(crest);
}

void vtkOversketchAugmentWidget::LineBegins()
{
  this->Superclass::LineBegins();
  this->RadiusBefore = this->GetAugment()->GetRadius();
  this->HeightBefore = this->GetAugment()->GetHeight();
  this->StrokeBefore = this->GetPen()->GetStroke()->GetMTime();
}

void vtkOversketchAugmentWidget::LineEnds()
{
  if (this->GetPen()->GetStroke()->GetMTime() == this->StrokeBefore && !this->GetPen()->IsWaiting())
  {
    this->GetAugment()->SetRadius(this->RadiusBefore);
    this->GetAugment()->SetHeight(this->HeightBefore);
  }
}

bool vtkOversketchAugmentWidget::UseWheel(int notches)
{
  vtkOversketchAugment* system = this->GetAugment();
  const bool wide = this->Interactor->GetControlKey() != 0, high = this->Interactor->GetShiftKey() != 0;
  const bool sketches = system->GetSketchMode() == vtkOversketchAugment::Silhouette;
  const double diagonal = this->GetOutput()->GetLength();
  if (wide == high || this->Interactor->GetAltKey() || (high && sketches) || diagonal <= 0.0)
  {
    return false;
  }
  double radius = system->GetRadius() > 0.0 ? system->GetRadius() : radiusOfDiagonal * diagonal;
  double height = system->GetHeight() != 0.0 ? system->GetHeight() : 0.5 * radius;
  if (wide)
  {
    radius = std::clamp(radius * std::pow(radiusStep, notches), leastRadius * diagonal, diagonal);
    height = system->GetHeight() != 0.0 ? height : 0.5 * radius;
    system->SetRadius(radius);
  }
  else
  {
    const double step = heightStep * radius;
    height += notches * step;
    height = std::abs(height) < 0.5 * step ? std::copysign(step, notches) : height;
    height = std::clamp(height, -diagonal, diagonal);
    system->SetHeight(height);
  }
  this->LookAgain(); // while the hand draws or moves
  if (!this->GetPen()->IsDrawing() && !this->IsMoving())
  {
    this->Update();
    if (!*this->GetMessage())
    {
      std::ostringstream text;
      text.precision(3);
      text << "Radius " << radius << (sketches ? "" : height < 0.0 ? ", depth " : ", height ");
      if (!sketches)
      {
        text << std::abs(height);
      }
      this->GetLiveStrokeRepresentation()->SetText(text.str().c_str());
    }
    if (this->GetStroke()->GetNumberOfPoints() > 0)
    {
      this->InvokeEvent(vtkCommand::WidgetValueChangedEvent);
    }
  }
  this->Render();
  return true;
}
