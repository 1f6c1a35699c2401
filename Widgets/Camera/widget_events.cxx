#include "widget_events.h"

#include "vtkAbstractWidget.h"
#include "vtkCommand.h"
#include "vtkEvent.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkWidgetEvent.h"

namespace oversketch
{

void listenToHand(vtkWidgetCallbackMapper* mapper, vtkAbstractWidget* widget, const HandCallbacks& hand)
{
  const HandCallbacks::Callback swallow = [](vtkAbstractWidget*) {};
  mapper->SetCallbackMethod(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select, widget, hand.press);
  mapper->SetCallbackMethod(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move, widget, hand.move);
  mapper->SetCallbackMethod(
    vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect, widget, hand.release);
  mapper->SetCallbackMethod(vtkCommand::KeyPressEvent,
    vtkEvent::AnyModifier,
    0,
    0,
    nullptr,
    vtkWidgetEvent::Completed,
    widget,
    hand.key);
  mapper->SetCallbackMethod(vtkCommand::CharEvent,
    vtkEvent::AnyModifier,
    0,
    0,
    nullptr,
    vtkWidgetEvent::ModifyEvent,
    widget,
    swallow);
  mapper->SetCallbackMethod(
    vtkCommand::MouseWheelForwardEvent, vtkWidgetEvent::Up, widget, hand.forward ? hand.forward : swallow);
  mapper->SetCallbackMethod(vtkCommand::MouseWheelBackwardEvent,
    vtkWidgetEvent::Down,
    widget,
    hand.backward ? hand.backward : swallow);
  for (const unsigned long event : { vtkCommand::MiddleButtonPressEvent,
         vtkCommand::MiddleButtonReleaseEvent,
         vtkCommand::RightButtonPressEvent,
         vtkCommand::RightButtonReleaseEvent })
  {
    mapper->SetCallbackMethod(event, vtkWidgetEvent::ModifyEvent, widget, swallow);
  }
}

void workIn(vtkRenderer* renderer, vtkRenderWindowInteractor* interactor, vtkAbstractWidget* widget)
{
  widget->SetInteractor(interactor);
  widget->SetDefaultRenderer(renderer);
  widget->SetCurrentRenderer(renderer);
}

std::string keyOf(vtkRenderWindowInteractor* interactor)
{
  const char* key = interactor->GetKeySym();
  return key ? key : "";
}

} // namespace oversketch
