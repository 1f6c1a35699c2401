/**
 * @class vtkOversketchCurvePenWidget
 * @brief what the widgets with a pen share: its strokes are taken over, while there is one to be drawn
 *
 * A pen (vtkOversketchStrokeWidget, whose header says what the hand does while it draws) for any
 * vtkRenderWindowInteractor. What becomes of a stroke is the heir's. While there is nothing to be drawn the
 * pen rests and the left button is the camera's, or another widget's.
 *
 * | event | idle |
 * |---|---|
 * | left press, no modifier | a stroke begins, where there is one to be drawn |
 * | Shift + left press | a stroke begins that changes what is there, where an heir lets it |
 * | Escape | what was drawn last is taken back |
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a stroke, WidgetValueChangedEvent
 * when the hand has changed what was drawn, and MessageEvent, with the text that is shown, when it cannot do
 * what it was asked.
 *
 * @sa vtkOversketchRegionWidget vtkOversketchAreaSelectWidget vtkOversketchDrawingWidget
 */
#ifndef vtkOversketchCurvePenWidget_h
#define vtkOversketchCurvePenWidget_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkAbstractWidget.h"
#include "vtkNew.h" // For Pen

#include <string>

class vtkOversketchStrokeWidget;
class vtkPolyData;

class OVERSKETCHWIDGETSPEN_EXPORT vtkOversketchCurvePenWidget : public vtkAbstractWidget
{
public:
  vtkAbstractTypeMacro(vtkOversketchCurvePenWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The pen, for its stabilizer, pressure and samples of a tablet.
   */
  vtkOversketchStrokeWidget* GetPen();

  void SetEnabled(int enabling) override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

protected:
  vtkOversketchCurvePenWidget();
  ~vtkOversketchCurvePenWidget() override;

  // Whether a stroke may begin; `over`: with Shift.
  virtual bool Wants(bool over) = 0;
  // The hand has drawn a stroke, with its view. Returns whether it was of use.
  virtual bool TakeStroke(vtkPolyData* stroke, bool over) = 0;
  // Takes back what was drawn last. Returns whether there was something.
  virtual bool TakeBack() = 0;
  virtual void ShowText(const std::string& text) = 0;

  // The pen rests or is ready, by what is wanted now.
  void ReadyPen();
  void Tell(const std::string& message);
  // Hears what the pen does.
  virtual void Heard(vtkObject* pen, unsigned long event, void* data);
  // Whether its stroke began with Shift.
  bool IsOver() const { return this->Over; }

private:
  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);

  bool PressedOver = false, Over = false;
  vtkNew<vtkOversketchStrokeWidget> Pen;
};

#endif
