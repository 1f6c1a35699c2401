/**
 * @class vtkOversketchHeldStrokeWidget
 * @brief a pen whose last stroke stays: it can be taken hold of, moved, and drawn over in part
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 2, Fig. 2: a stroke stays and can
 * be changed. A pen (vtkOversketchStrokeWidget) and the one stroke that it holds, for any
 * vtkRenderWindowInteractor. It knows neither mesh nor system: what a stroke does is the host's or a
 * subclass's. The stroke stands in the world; it is reached from where it was drawn, at any zoom; from
 * elsewhere it is seen half transparent, and a click on it takes the camera back.
 *
 * | event | idle | moving the stroke |
 * |---|---|---|
 * | left press beside the held stroke, no modifier | a new stroke begins (the pen's) | |
 * | left press on it (GrabDistance) | it is taken hold of; from elsewhere: the camera goes back to it | |
 * | Shift + left press on it | a stroke begins that replaces a part of it | |
 * | move | what is under the cursor shows that it is | the stroke follows |
 * | left release | | it stays where it is |
 * | Escape | not looked at | it is where it was taken hold of |
 * | wheel | a subclass's (UseWheel), else not looked at | a subclass's, else swallowed; so while the pen
 * draws | | any other button, any other key | not looked at | swallowed |
 *
 * The pen's own events are in its header. While the pen draws a new stroke the held one is not shown.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a stroke that is drawn and for
 * one that is moved, WidgetValueChangedEvent when the hand has changed GetStroke(), and MessageEvent, with
 * the text that is shown, when it cannot do what it was asked.
 *
 * @sa vtkOversketchStrokeWidget, vtkOversketchHeldStrokeRepresentation, vtkOversketchOneStrokeWidget
 */
#ifndef vtkOversketchHeldStrokeWidget_h
#define vtkOversketchHeldStrokeWidget_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkAbstractWidget.h"
#include "vtkNew.h" // For Pen, Stroke

#include <memory>
#include <string>

class vtkOversketchHeldStrokeRepresentation;
class vtkOversketchStrokeWidget;
class vtkPolyData;

class OVERSKETCHWIDGETSPEN_EXPORT vtkOversketchHeldStrokeWidget : public vtkAbstractWidget
{
public:
  static vtkOversketchHeldStrokeWidget* New();
  vtkTypeMacro(vtkOversketchHeldStrokeWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The pen, for its stabilizer, pressure and samples of a tablet.
   */
  vtkOversketchStrokeWidget* GetPen();

  /**
   * The stroke that is held, with its view (vtkOversketchStrokeWidget::GetStroke); empty when there is none.
   * The object stays the same.
   */
  vtkPolyData* GetStroke() { return this->Stroke; }

  /**
   * Holds another stroke, in the plane parallel to its picture through a place [world]; null or an empty one:
   * none. A stroke that the hand has drawn stands in the plane of the camera's focal point until then. Fires
   * no event.
   */
  virtual void HoldStroke(vtkPolyData* stroke, const double place[3]);

  ///@{
  /**
   * Whether the held stroke was drawn beside the one before; false: it is that one, changed. Whether the pen,
   * while it draws, replaces a part of the held stroke.
   */
  bool IsNew() const { return this->NewStroke; }
  bool IsRedrawing() const { return this->Redrawing; }
  ///@}

  ///@{
  /**
   * Whether the held stroke is being moved, and by how much [world] since it was taken hold of.
   */
  bool IsMoving() const { return this->Moving; }
  double* GetTranslation() VTK_SIZEHINT(3);
  ///@}

  ///@{
  /**
   * Whether the held stroke took hold of something. A move then keeps that: it adds up in the stroke's cell
   * array Moved. One that did not is, moved, a stroke drawn there [default on; a drawn stroke switches it
   * on].
   */
  vtkSetMacro(TookHold, bool);
  vtkGetMacro(TookHold, bool);
  vtkBooleanMacro(TookHold, bool);
  ///@}

  ///@{
  /**
   * How near to the held stroke the cursor takes hold of it [px, 0 to 50, default 6; 0: nowhere does
   * it].
   */
  vtkSetClampMacro(GrabDistance, double, 0.0, 50.0);
  vtkGetMacro(GrabDistance, double);
  ///@}

  void SetRepresentation(vtkOversketchHeldStrokeRepresentation* representation);
  vtkOversketchHeldStrokeRepresentation* GetHeldStrokeRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

protected:
  vtkOversketchHeldStrokeWidget();
  ~vtkOversketchHeldStrokeWidget() override;

  // For a widget that does something with its strokes: what the hand does, before an event tells of it. The
  // pen has gone down; the line has grown.
  virtual void LineBegins() {}
  virtual void LineGrows() {}
  // The pen is up; a line that has become a stroke is given to TakeStroke after this.
  virtual void LineEnds() {}
  // The hand has made a stroke (IsNew), or changed the held one. Keep makes it that of GetStroke.
  virtual void TakeStroke(vtkPolyData* stroke);
  void Keep(vtkPolyData* stroke);
  // The held stroke has been moved; it is let go of, which keeps the move or takes it back.
  virtual void StrokeMoves() {}
  virtual void EndMove(bool keep);
  // The cursor has moved and the camera has not.
  virtual void CameraRests() {}
  // A key while neither pen nor stroke moves. Returns whether it was of use.
  virtual bool UseKey(const std::string&) { return false; }
  // The wheel, a notch away from the hand (1) or towards it (-1), also while pen or stroke move. Returns
  // whether it was of use; then it is not the camera's.
  virtual bool UseWheel(int) { return false; }
  // Brings what is drawn up to what is.
  virtual void Refresh();

  void Tell(const std::string& message);

  double Place[3] = { 0.0, 0.0, 0.0 };

private:
  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void MoveTo(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);
  static void Forward(vtkAbstractWidget* widget);
  static void Backward(vtkAbstractWidget* widget);

  void Heard(vtkObject* pen, unsigned long event, void* data);
  void Wheel(int notches);
  void PenHasDrawn();
  bool IsOver(const int at[2]);
  void BeginMove(const int at[2]);
  void Hover(const int at[2]);

  double GrabDistance = 6.0;
  bool TookHold = true;
  bool Moving = false, Moved = false, Redrawing = false, PressedOver = false, NewStroke = false;
  int Grip[2] = { 0, 0 }; // px
  vtkNew<vtkOversketchStrokeWidget> Pen;
  vtkNew<vtkPolyData> Stroke;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
