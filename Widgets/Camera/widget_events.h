// Events that the widgets listen to: a hand with a mouse and a keyboard.
#ifndef oversketch_widgets_camera_widget_events_h
#define oversketch_widgets_camera_widget_events_h

#include "OversketchWidgetsCameraModule.h" // For export macro
#include "vtkCommand.h"
#include "vtkSmartPointer.h"
#include "vtkWidgetCallbackMapper.h"

#include <initializer_list>
#include <string>

class vtkAbstractWidget;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace oversketch
{

struct HandCallbacks
{
  using Callback = vtkWidgetCallbackMapper::CallbackType;
  Callback press, move, release; // left button
  Callback key;                  // with any modifier
  Callback forward = nullptr;    // the wheel, with any modifier, where a widget makes something of it
  Callback backward = nullptr;
};

// Calls them for the widget. While it holds the focus every other button, a wheel that it makes nothing of
// and characters come to nothing, so that neither the style nor another widget acts on them.
OVERSKETCHWIDGETSCAMERA_EXPORT void listenToHand(vtkWidgetCallbackMapper* mapper,
  vtkAbstractWidget* widget,
  const HandCallbacks& hand);

// The widget that a callback is called for, kept while that runs: an observer may let go of it.
template <typename Widget>
vtkSmartPointer<Widget> called(vtkAbstractWidget* widget)
{
  return static_cast<Widget*>(widget);
}

// A widget is to work in a renderer, by an interactor.
OVERSKETCHWIDGETSCAMERA_EXPORT void workIn(vtkRenderer* renderer,
  vtkRenderWindowInteractor* interactor,
  vtkAbstractWidget* widget);

// The key of an interactor's event; empty where it has none.
OVERSKETCHWIDGETSCAMERA_EXPORT std::string keyOf(vtkRenderWindowInteractor* interactor);

// A widget hears, as long as it lives, what the hand does with another one, and of some further events.
template <typename Widget>
void listenTo(vtkObject* other,
  Widget* widget,
  void (Widget::*heard)(vtkObject*, unsigned long, void*),
  std::initializer_list<unsigned long> further = {})
{
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent,
         vtkCommand::EndInteractionEvent,
         vtkCommand::WidgetValueChangedEvent })
  {
    other->AddObserver(event, widget, heard);
  }
  for (const unsigned long event : further)
  {
    other->AddObserver(event, widget, heard);
  }
}

} // namespace oversketch

// The two methods of a widget that give the representation it is named after: a new one where there is none.
#define oversketchRepresentationMacro(Name)                                                                  \
  vtkOversketch##Name##Representation* vtkOversketch##Name##Widget::Get##Name##Representation()              \
  {                                                                                                          \
    this->CreateDefaultRepresentation();                                                                     \
    return static_cast<vtkOversketch##Name##Representation*>(this->WidgetRep);                               \
  }                                                                                                          \
  void vtkOversketch##Name##Widget::CreateDefaultRepresentation()                                            \
  {                                                                                                          \
    if (!this->WidgetRep)                                                                                    \
    {                                                                                                        \
      this->WidgetRep = vtkOversketch##Name##Representation::New();                                          \
    }                                                                                                        \
  }

#endif
