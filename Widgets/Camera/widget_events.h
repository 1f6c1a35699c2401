// What the widgets listen to: a hand with a mouse and a keyboard.
#ifndef oversketch_widgets_camera_widget_events_h
#define oversketch_widgets_camera_widget_events_h

#include "OversketchWidgetsCameraModule.h" // For export macro
#include "vtkWidgetCallbackMapper.h"

class vtkAbstractWidget;

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

} // namespace oversketch
#endif
