/**
 * @class vtkOversketchDrawingWidget
 * @brief a canvas or a picture that is drawn over: outlines and features that make a model
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.1 and 2.2.1. Strokes are drawn on the plane z = 0,
 * with or without a picture on it, at any zoom; magnetic ones move to the picture's edges when the pen goes
 * up. What each is, boundary, feature or of no use, is found at once and seen by its colour
 * (vtkOversketchDrawingRepresentation); why one is of no use is said in words on the picture. For any
 * vtkRenderWindowInteractor and its style; it looks straight at the canvas and does not turn.
 *
 * | event | idle | drawing |
 * |---|---|---|
 * | left press, no modifier | a stroke begins | |
 * | Shift + left press | a stroke begins that replaces a part of the one that it is drawn over | |
 * | move, left release | | samples; the stroke ends |
 * | left click in a closed feature | fill, hole, tunnel, in turn | |
 * | left click in a picture, in no closed stroke | traces what is there: Trace | |
 * | wheel | zooms about the cursor | swallowed |
 * | middle drag | pans | swallowed |
 * | Escape, BackSpace | not looked at | the pen's |
 *
 * The paper gives no way to correct a stroke: Kernels/Stroke/correct.h says what happens. A press and release
 * within 3 px is a click.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a stroke, WidgetValueChangedEvent
 * when the hand has changed GetDrawing(), and MessageEvent, with the text that is shown, when there is
 * something to be said.
 *
 * @sa vtkOversketchStrokeWidget vtkOversketchInflateDrawing
 */
#ifndef vtkOversketchDrawingWidget_h
#define vtkOversketchDrawingWidget_h

#include "OversketchWidgetsDrawingModule.h" // For export macro
#include "vtkNew.h"                         // For Drawing
#include "vtkOversketchCurvePenWidget.h"

#include <memory>
#include <string>

namespace oversketch
{
class Message;
}

class vtkAlgorithmOutput;
class vtkImageData;
class vtkOversketchDrawingRepresentation;
class vtkPolyData;

class OVERSKETCHWIDGETSDRAWING_EXPORT vtkOversketchDrawingWidget : public vtkOversketchCurvePenWidget
{
public:
  static vtkOversketchDrawingWidget* New();
  vtkTypeMacro(vtkOversketchDrawingWidget, vtkOversketchCurvePenWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is drawn on: a picture (null: none; 8 bits, one slice, no direction), or an empty canvas from its
   * lower left corner [world; default 0, 0, 1024, 768]. The view is set to show all of it. Strokes stay.
   */
  void SetPicture(vtkImageData* picture);
  vtkImageData* GetPicture();
  void SetCanvas(double x, double y, double width, double height);
  ///@}

  ///@{
  /**
   * The strokes, in the order they were drawn, for vtkOversketchInflateDrawing: polylines in display
   * coordinates, each with its view, cell arrays Magnetic, SnapRadius and Treatment; without a picture, field
   * array Canvas. Empty at first. The object stays the same; GetOutputPort() connects filters to it.
   * SetDrawing takes others in their place (null: none); false, and nothing changed, where they are no
   * strokes. It fires no event.
   */
  vtkPolyData* GetDrawing() { return this->Drawing; }
  vtkAlgorithmOutput* GetOutputPort();
  bool SetDrawing(vtkPolyData* drawing);
  ///@}

  /**
   * The strokes on the canvas, snapped and classified, each layer's among themselves (cell array Depth of
   * strokes); where that failed (GetText), as far as it came. Their cell array StrokeId says which strokes
   * they are.
   */
  vtkPolyData* GetCurves();

  /**
   * Takes the last stroke away. Fires no event.
   */
  void RemoveLastStroke();

  /**
   * Fill becomes hole, hole tunnel, tunnel fill, of the smallest closed feature round a place [world]. False
   * where there is none.
   */
  bool CycleTreatment(double x, double y);

  /**
   * Adds the outline of what the picture shows at a place [world], or beside it, as strokes, and those of its
   * holes as tunnels: see vtkOversketchTrace. False where there is none, or it has a stroke round it already;
   * GetText says which. Fires no event.
   */
  bool Trace(double x, double y);

  ///@{
  /**
   * Whether strokes drawn from now on move to the picture's edges [default on].
   */
  vtkSetMacro(Magnetic, bool);
  vtkGetMacro(Magnetic, bool);
  vtkBooleanMacro(Magnetic, bool);
  ///@}

  ///@{
  /**
   * How far, as the window shows it when a stroke is drawn [px, 1 to 100, default 10].
   */
  vtkSetClampMacro(SnapRadius, double, 1.0, 100.0);
  vtkGetMacro(SnapRadius, double);
  ///@}

  ///@{
  /**
   * Whether strokes may cross, span what they lie in, and bound an object together, as Arrange of
   * vtkOversketchInflateDrawing lets them: curves are then parts of strokes [default off].
   */
  void SetArrange(bool arrange);
  vtkGetMacro(Arrange, bool);
  vtkBooleanMacro(Arrange, bool);
  ///@}

  /**
   * Shows all of the canvas.
   */
  void ResetView();

  /**
   * What is to be said of the drawing, in words and as data; empty where there is nothing.
   */
  const char* GetText();
  const oversketch::Message& GetSaid() const;

  void SetRepresentation(vtkOversketchDrawingRepresentation* representation);
  vtkOversketchDrawingRepresentation* GetDrawingRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchDrawingWidget();
  ~vtkOversketchDrawingWidget() override;

  bool Wants(bool) override { return true; }
  bool TakeStroke(vtkPolyData* stroke, bool over) override;
  bool TakeBack() override { return false; }    // keys are the pen's
  void ShowText(const std::string&) override {} // it is of the drawing, not of what the pen does
  void Heard(vtkObject* pen, unsigned long event, void* data) override;

private:
  // Callbacks of the event translator.
  static void MoveTo(vtkAbstractWidget* widget);
  static void PanBegins(vtkAbstractWidget* widget);
  static void PanEnds(vtkAbstractWidget* widget);
  static void Forward(vtkAbstractWidget* widget);
  static void Backward(vtkAbstractWidget* widget);

  void LineGrows();
  bool Click();
  void Publish();
  void Show();
  void Classify();
  void Tell(const oversketch::Message& message);
  void ShowFault(const oversketch::Message& message);
  void Zoom(double factor);

  bool Magnetic = true, Arrange = false;
  double SnapRadius = 10.0;
  bool Panning = false;
  bool PenDraws = false; // what has changed is drawn with the pen's own change, once all have heard of it
  int At[2] = { 0, 0 };  // window px, where the cursor was
  double Begun[2] = { 0.0, 0.0 }; // px from the viewport's lower left corner, where the stroke began
  vtkNew<vtkPolyData> Drawing;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
