/**
 * @class vtkOversketchStrokeWidget
 * @brief a pen: left drag draws a stroke that carries its view
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 4 (pen), Sec. 4.2
 * (drawing over a stroke). Works with any vtkRenderWindowInteractor; draws in the renderer that it is enabled
 * in, at the same rate whatever the scene is (see vtkOversketchStrokeRepresentation).
 *
 * | event | idle | drawing |
 * |---|---|---|
 * | left press without Shift, Ctrl, Alt | a stroke begins | |
 * | move | | a sample is added |
 * | left release | | the stroke ends |
 * | Escape | an uncommitted stroke is dropped | the stroke is dropped |
 * | BackSpace | the last 20 px of an uncommitted stroke go | the last 20 px go |
 * | Return, KP_Enter | an uncommitted stroke is committed | |
 * | wheel | not looked at | fired as an event of the widget's own |
 * | any other button, any other key | not looked at | swallowed: drawing never moves the camera |
 *
 * Every sample is kept, with its pressure and its time. A press and release without two samples is no stroke.
 * A stroke whose viewport is resized while it is drawn is dropped.
 *
 * Fires StartInteractionEvent when a stroke begins, InteractionEvent for each sample, EndInteractionEvent
 * when it has ended or been dropped, WidgetValueChangedEvent when GetStroke() is a new stroke, and
 * MouseWheelForwardEvent and MouseWheelBackwardEvent when the wheel is turned while it draws.
 *
 * While it is enabled it sets the mode of a vtkOversketchInteractorStyle to Draw, if that is the interactor's
 * style. Other styles do not see the left button; middle drag, wheel and keys between strokes are theirs.
 *
 * @sa vtkOversketchStrokeRepresentation, vtkOversketchInteractorStyle, vtkOversketchOneStroke
 */
#ifndef vtkOversketchStrokeWidget_h
#define vtkOversketchStrokeWidget_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkAbstractWidget.h"
#include "vtkNew.h"         // For Stroke, Producer
#include "vtkWeakPointer.h" // For StyleInDraw

class vtkAlgorithmOutput;
class vtkOversketchInteractorStyle;
class vtkOversketchStrokeRepresentation;
class vtkPolyData;
class vtkTrivialProducer;

class OVERSKETCHWIDGETSPEN_EXPORT vtkOversketchStrokeWidget : public vtkAbstractWidget
{
public:
  static vtkOversketchStrokeWidget* New();
  vtkTypeMacro(vtkOversketchStrokeWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The stroke committed last, empty before the first. One polyline in display coordinates [px from the
   * viewport's lower left corner, y up], point arrays Pressure (float, 0 to 1) and Time (double, s since the
   * stroke began), cell arrays ViewTransform, ProjectionTransform (double, 16 components, row-major) and
   * ViewportSize (int, 2 components). The object stays the same. GetOutputPort() connects filters to it.
   */
  vtkPolyData* GetStroke() { return this->Stroke; }
  vtkAlgorithmOutput* GetOutputPort();
  ///@}

  ///@{
  /**
   * On (default): a stroke is committed when the pen goes up. Off: it waits, and can be drawn over in part
   * any number of times, until Commit, Return or Escape; a stroke drawn elsewhere replaces it
   * (oversketch::resketch). A stroke that waits while the camera moves can be committed, not drawn over.
   * Samples of a run from one stroke into another have times and pressures in between; times count from the
   * first stroke's begin.
   */
  vtkSetMacro(CommitOnRelease, bool);
  vtkGetMacro(CommitOnRelease, bool);
  vtkBooleanMacro(CommitOnRelease, bool);
  ///@}

  ///@{
  /**
   * Steadies the hand: the line follows the pen on a string of this length, so what trembles by less leaves
   * no trace; at the end it is drawn up to the pen [px, 0 to 100, default 0: off].
   */
  vtkSetClampMacro(Stabilizer, double, 0.0, 100.0);
  vtkGetMacro(Stabilizer, double);
  ///@}

  ///@{
  /**
   * Pressure of the samples that mouse events make; a host with a tablet sets it before it passes an event on
   * [0 to 1, default 1].
   */
  vtkSetClampMacro(Pressure, double, 0.0, 1.0);
  vtkGetMacro(Pressure, double);
  ///@}

  ///@{
  /**
   * What the pen does, for hosts that have samples of their own: positions in the window [px, y up], which
   * need not be whole, pressure [0 to 1], time since the stroke began [s]; a negative time is now. Each
   * renders. BeginStroke does nothing, and returns false, while the widget is not enabled or a stroke is
   * being drawn; the others do nothing while none is. BeginOver begins one that is drawn over the stroke
   * drawn last, committed or not, and replaces a part of it; its times go on from there.
   */
  bool BeginStroke(double x, double y, double pressure = 1.0);
  bool BeginOver(double x, double y, double pressure = 1.0);
  void AddSample(double x, double y, double pressure = 1.0, double time = -1.0);
  void RemoveLastSamples();
  void EndStroke();
  void CancelStroke();
  ///@}

  ///@{
  /**
   * Commits or drops the stroke that waits.
   */
  void Commit();
  void Drop();
  ///@}

  ///@{
  /**
   * Whether a stroke is being drawn; whether one waits to be committed; whether the last one was dropped
   * while it was drawn, by Escape for one, and did not end.
   */
  bool IsDrawing();
  bool IsWaiting() const { return this->Waiting; }
  bool WasDropped() const { return this->Dropped; }
  ///@}

  void SetRepresentation(vtkOversketchStrokeRepresentation* representation);
  vtkOversketchStrokeRepresentation* GetStrokeRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchStrokeWidget();
  ~vtkOversketchStrokeWidget() override;

private:
  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void Move(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);
  static void Forward(vtkAbstractWidget* widget);
  static void Backward(vtkAbstractWidget* widget);
  static void Resized(vtkAbstractWidget* widget);

  bool Begin(double x, double y, double pressure, bool over);
  bool DropDrawing();
  void StopDrawing();
  void Wheel(unsigned long event);
  void Publish();

  bool CommitOnRelease = true;
  double Stabilizer = 0.0;
  double Pressure = 1.0;
  bool Waiting = false, Dropped = false;
  double Pen[2] = { 0.0, 0.0 }, Cursor[2] = { 0.0, 0.0 }; // px: the line's end, the pen itself
  double Began = 0.0;                                     // s, when the stroke, or the one drawn over, began
  vtkNew<vtkPolyData> Stroke;
  vtkNew<vtkTrivialProducer> Producer;
  vtkWeakPointer<vtkOversketchInteractorStyle> StyleInDraw;
};

#endif
