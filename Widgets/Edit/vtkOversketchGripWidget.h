/**
 * @class vtkOversketchGripWidget
 * @brief what the widgets with grips share: a grip is taken hold of, dragged and let go of
 *
 * For any vtkRenderWindowInteractor. What a grip is, and what dragging it changes, is the heir's.
 *
 * | event | idle | dragging |
 * |---|---|---|
 * | left press on a grip, no modifier | it is taken hold of | |
 * | left press beside them | an heir's, else not looked at | |
 * | move | what is under the cursor shows that it is | the grip follows |
 * | left release | | it stays where it is |
 * | Escape | an heir's, else not looked at | all is as when it was taken hold of |
 * | Delete, BackSpace | an heir's, else not looked at | swallowed |
 * | any other button, the wheel, any other key | not looked at | swallowed |
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a drag, WidgetValueChangedEvent
 * when the hand has changed a value for good, and MessageEvent, with the text that is shown, when it cannot
 * do what it was asked.
 *
 * @sa vtkOversketchGripRepresentation
 */
#ifndef vtkOversketchGripWidget_h
#define vtkOversketchGripWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkAbstractWidget.h"

#include <string>

class vtkOversketchGripRepresentation;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchGripWidget : public vtkAbstractWidget
{
public:
  vtkAbstractTypeMacro(vtkOversketchGripWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Whether a grip is being dragged.
   */
  bool IsDragging() const { return this->Dragging; }

  /**
   * What it paints.
   */
  vtkOversketchGripRepresentation* GetGripRepresentation();

  void SetEnabled(int enabling) override;

protected:
  vtkOversketchGripWidget();
  ~vtkOversketchGripWidget() override;

  // A grip is taken hold of at a place of the window [px]; 0 is a place beside all grips. Returns whether
  // there is something to drag.
  virtual bool Grasp(int grip, const int at[2]) = 0;
  virtual void Pull(const int at[2]) = 0;
  // It is let go of: the change stays, or is taken back. Returns whether a value is another one than before.
  virtual bool LetGo(bool keep) = 0;
  // A key while nothing is dragged. Returns whether it was of use.
  virtual bool UseKey(const std::string&) { return false; }

  // Ends a drag without a render, such as before what it drags goes.
  void StopDragging(bool keep);
  void Tell(const std::string& message);
  void ValueChanged();

private:
  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void MoveTo(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);

  bool Dragging = false;
};

#endif
