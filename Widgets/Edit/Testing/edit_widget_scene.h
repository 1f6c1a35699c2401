// All of the edit over a ball, by one widget. Header-only.
#ifndef oversketch_widgets_edit_testing_edit_widget_scene_h
#define oversketch_widgets_edit_testing_edit_widget_scene_h

#include "Harness/shipped.h"
#include "edit_scene.h"
#include "vtkOversketchAreaSelectRepresentation.h"
#include "vtkOversketchAreaSelectWidget.h"
#include "vtkOversketchAxisHandleRepresentation.h"
#include "vtkOversketchAxisHandleWidget.h"
#include "vtkOversketchEditRepresentation.h"
#include "vtkOversketchEditWidget.h"
#include "vtkOversketchLayerHandleRepresentation.h"
#include "vtkOversketchLayerHandleWidget.h"
#include "vtkOversketchProfilePlaneRepresentation.h"
#include "vtkOversketchProfilePlaneWidget.h"
#include "vtkOversketchProfileRepresentation.h"
#include "vtkOversketchRegionRepresentation.h"
#include "vtkOversketchRegionWidget.h"
#include "vtkOversketchStrokeWidget.h"

namespace oversketch_test
{

struct EditScene : EditWindow
{
  Window flat{ 400, 300 };
  vtkNew<vtkOversketchInteractorStyle> flatStyle;
  vtkSmartPointer<vtkOversketchEditWidget> widget = vtkSmartPointer<vtkOversketchEditWidget>::New();

  EditScene()
    : EditWindow(false)
  {
    this->flat.interactor->SetInteractorStyle(this->flatStyle);
    this->flat.window->Render();
    this->widget->SetInputData(this->mesh);
    this->widget->GetProfilePlaneWidget()->SetProfileRenderer(this->flat.renderer);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->widget->GetOutputPort());
    mapper->ScalarVisibilityOff();
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    this->renderer->AddActor(actor);
    this->widget->SetInteractor(this->interactor);
    this->widget->On();
    this->renderer->ResetCameraClippingRange();
    this->window->Render();
  }
  vtkOversketchEdit* system() { return this->widget->GetEdit(); }
  vtkPolyData* output() { return this->widget->GetOutput(); }
  void drawBoth()
  {
    this->play("region_line.log");
    this->play("region_ring.log");
  }
  // A handle at the middle of the line, selected, in the mode Direct.
  void placeHandle()
  {
    this->widget->SetModeToDirect();
    this->widget->GetAxisHandleWidget()->AddHandle(0.5);
    this->window->Render();
  }
  void reset()
  {
    this->flatStyle->ShowKeysOff();
    this->widget->GetProfilePlaneWidget()->GetPen()->Drop();
    this->widget->SetInputData(nullptr);
    this->widget->Drop();
    this->mesh = editBall();
    this->widget->SetInputData(this->mesh);
    this->widget->SetShowRegion(false);
    this->lookFromFront();
  }
};

} // namespace oversketch_test
#endif
