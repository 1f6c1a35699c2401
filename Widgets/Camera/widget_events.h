// What the widgets listen to: a hand with a mouse and a keyboard.
#ifndef oversketch_widget_events_h
#define oversketch_widget_events_h

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
};

// Calls them for the widget. While it holds the focus every other button, the wheel and characters come to
// nothing, so that neither the style nor another widget acts on them.
OVERSKETCHWIDGETSCAMERA_EXPORT void listenToHand(vtkWidgetCallbackMapper* mapper,
  vtkAbstractWidget* widget,
  const HandCallbacks& hand);

} // namespace oversketch
#endif
