#include "disc_window.h"

#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "widget_events.h"

#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"

namespace oversketch
{

DiscWindow::DiscWindow() = default;

DiscWindow::~DiscWindow()
{
  this->setRenderer(nullptr);
}

void DiscWindow::setRenderer(vtkRenderer* renderer)
{
  this->hold(false, false);
  if (this->Window)
  {
    this->Window->RemoveViewProp(this->Layers->GetLayerHandleRepresentation());
  }
  vtkRenderWindow* window = renderer ? renderer->GetRenderWindow() : nullptr;
  this->Window = window && window->GetInteractor() ? renderer : nullptr;
  for (vtkAbstractWidget* widget :
    { static_cast<vtkAbstractWidget*>(this->Layers), static_cast<vtkAbstractWidget*>(this->Areas) })
  {
    workIn(this->Window, this->Window ? window->GetInteractor() : nullptr, widget);
  }
  this->Layers->GetLayerHandleRepresentation()->SetRenderer(this->Window);
  if (this->Window)
  {
    this->Window->AddViewProp(this->Layers->GetLayerHandleRepresentation()); // whatever the hand has
  }
}

vtkRenderer* DiscWindow::renderer() const
{
  return this->Window;
}

void DiscWindow::hold(bool layers, bool areas)
{
  this->Layers->SetEnabled(layers && this->Window);
  this->Areas->SetEnabled(areas && this->Window);
  if (this->Window && !layers)
  {
    this->Window->AddViewProp(this->Layers->GetLayerHandleRepresentation()); // a widget takes it along
  }
}

void DiscWindow::setRegion(vtkPolyData* mesh)
{
  this->Layers->SetRegion(mesh);
  this->Areas->SetRegion(mesh);
}

void DiscWindow::follow(vtkOversketchLayerHandleWidget* layers, vtkOversketchAreaSelectWidget* areas)
{
  vtkOversketchLayerHandleRepresentation* from = layers->GetLayerHandleRepresentation();
  vtkOversketchLayerHandleRepresentation* shown = this->Layers->GetLayerHandleRepresentation();
  this->Layers->SetLayers(layers->GetLayers());
  shown->SetArea(from->GetArea());
  shown->SetLevels(from->GetLevels());
  shown->SetDisplay(from->GetDisplay());
  if (this->SeenAreas != areas->GetAreas()->GetMTime())
  {
    this->SeenAreas = areas->GetAreas()->GetMTime();
    this->Areas->SetAreas(areas->GetAreas());
  }
  if (this->Window && this->Window->GetRenderWindow())
  {
    this->Window->GetRenderWindow()->GetInteractor()->Render();
  }
}

} // namespace oversketch
