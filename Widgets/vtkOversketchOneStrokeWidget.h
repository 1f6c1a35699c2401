/**
 * @class vtkOversketchOneStrokeWidget
 * @brief draw a stroke over a mesh and the mesh follows; take hold of the stroke again and it follows on
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 2, Figs. 1 and 2. A pen
 * (vtkOversketchStrokeWidget) and the system (vtkOversketchOneStroke) for any vtkRenderWindowInteractor: a
 * mesh goes in, the mesh as it is drawn comes out of GetOutputPort(), to be shown by a mapper.
 *
 * While the pen is down the section of the silhouette that the stroke takes hold of is shown (blue) under the
 * stroke (red), over the last frame. When it goes up the system runs and the mesh follows. The stroke then is
 * the live stroke: there is one. It can be moved, drawn over in part, and the system's parameters changed,
 * and the mesh follows; with the next stroke, or Commit, it is done with, and the mesh that it made is the
 * one that the next stroke is drawn on. It is reached from where it was drawn, at any zoom; from elsewhere it
 * is seen half transparent, and a click on it takes the camera back.
 *
 * | event | idle | moving the stroke |
 * |---|---|---|
 * | left press beside the live stroke, no modifier | a new stroke begins (the pen's) | |
 * | left press on it (GrabDistance) | it is taken hold of; from elsewhere: the camera goes back to it | |
 * | Shift + left press on it | a stroke begins that replaces a part of it | |
 * | move | what is under the cursor shows that it is | stroke and mesh follow, a preview |
 * | left release | | the system runs on the moved stroke |
 * | Escape | the live stroke is dropped: the mesh is as before it | it is where it was taken hold of |
 * | Return, KP_Enter | the live stroke is done with (Commit) | |
 * | o | the region that moved is shown (orange), or not | |
 * | any other button, the wheel, any other key | not looked at | swallowed |
 *
 * The pen's own events are in its header. A stroke that takes hold of nothing leaves the mesh as it was and
 * stays as the live stroke, to be corrected; why is shown in the window (GetMessage) and sent as
 * MessageEvent.
 *
 * The preview is the last deformation with all its targets moved (vtkOversketchOneStroke::Drag); what is
 * shown after the release is the system's own result on the moved stroke. The curves that the section is
 * found on are made when the cursor first moves in a view, at the latest when the pen goes down; the section
 * is found once a frame.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a stroke that is drawn and for
 * one that is moved, and WidgetValueChangedEvent when GetStroke() and the output have changed.
 *
 * A mesh that changes at its source, by pipeline, begins anew without a live stroke.
 *
 * @sa vtkOversketchStrokeWidget, vtkOversketchOneStroke, vtkOversketchOneStrokeRepresentation
 */
#ifndef vtkOversketchOneStrokeWidget_h
#define vtkOversketchOneStrokeWidget_h

#include "OversketchWidgetsModule.h" // For export macro
#include "vtkAbstractWidget.h"
#include "vtkNew.h"         // For Pen
#include "vtkWeakPointer.h" // For Watched, WatchedWindow

#include <memory>
#include <string>

class vtkAlgorithmOutput;
class vtkCallbackCommand;
class vtkOversketchOneStroke;
class vtkOversketchOneStrokeRepresentation;
class vtkOversketchStrokeWidget;
class vtkPolyData;
class vtkRenderWindow;

class OVERSKETCHWIDGETS_EXPORT vtkOversketchOneStrokeWidget : public vtkAbstractWidget
{
public:
  static vtkOversketchOneStrokeWidget* New();
  vtkTypeMacro(vtkOversketchOneStrokeWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The triangle mesh to be drawn on (vtkOversketchOneStroke, input 0).
   */
  void SetInputConnection(vtkAlgorithmOutput* mesh);
  void SetInputData(vtkPolyData* mesh);
  ///@}

  ///@{
  /**
   * The mesh as it is drawn: the input with what all strokes did. The object stays the same. It is brought up
   * to date when the renderer renders, or by Update().
   */
  vtkAlgorithmOutput* GetOutputPort();
  vtkPolyData* GetOutput();
  void Update();
  ///@}

  ///@{
  /**
   * The system that runs, for its parameters: after a change the mesh follows with the next render. One of
   * the host's may be set; the widget connects its inputs.
   */
  void SetOneStroke(vtkOversketchOneStroke* system);
  vtkOversketchOneStroke* GetOneStroke();
  ///@}

  /**
   * The pen, for its stabilizer, pressure and samples of a tablet.
   */
  vtkOversketchStrokeWidget* GetPen();

  ///@{
  /**
   * The live stroke, with its view (vtkOversketchStrokeWidget::GetStroke); empty when there is none. A stroke
   * that is set replaces the live one, and the mesh follows; null or an empty one is Drop.
   */
  vtkPolyData* GetStroke();
  void SetStroke(vtkPolyData* stroke);
  ///@}

  ///@{
  /**
   * Is done with the live stroke: the mesh stays. Drops it: the mesh is as before it.
   */
  void Commit();
  void Drop();
  ///@}

  /**
   * Why the live stroke took hold of nothing; empty when it did or there is none.
   */
  const char* GetMessage();

  ///@{
  /**
   * Whether the region that the live stroke moved is shown. Default off.
   */
  void SetShowRegion(bool show);
  vtkGetMacro(ShowRegion, bool);
  vtkBooleanMacro(ShowRegion, bool);
  ///@}

  ///@{
  /**
   * How near to the live stroke the cursor takes hold of it [px, 0 to 50, default 6].
   */
  vtkSetClampMacro(GrabDistance, double, 0.0, 50.0);
  vtkGetMacro(GrabDistance, double);
  ///@}

  ///@{
  /**
   * Off: the host runs strokes itself, in its own time. The widget then shows sections, draws and moves the
   * stroke, and changes no mesh: the output is the input. Keys Escape, Return and o are the host's. The host
   * takes GetStroke() at WidgetValueChangedEvent (IsNew() tells a new stroke from one that was changed) and
   * GetTranslation() at InteractionEvent, gives the new mesh by SetInputData, and names the stroke that can
   * be taken hold of by SetStrokeAt. Default on.
   */
  vtkSetMacro(RunsStrokes, bool);
  vtkGetMacro(RunsStrokes, bool);
  vtkBooleanMacro(RunsStrokes, bool);
  void SetStrokeAt(vtkPolyData* stroke, const double place[3]);
  bool IsNew() const { return this->NewStroke; }
  ///@}

  ///@{
  /**
   * Off: the host finds sections itself, in its own time, so that the pen never waits for the curves of a
   * large mesh. It looks for the stroke that PutSought writes, with vtkOversketchOneStroke::Preview of a
   * system of its own, and gives what it found to the pen's representation
   * (vtkOversketchStrokeRepresentation::SetSection) while that stroke is drawn. Default on.
   */
  vtkSetMacro(FindsSections, bool);
  vtkGetMacro(FindsSections, bool);
  vtkBooleanMacro(FindsSections, bool);
  ///@}

  /**
   * The stroke whose section is to be shown, with its view: what is drawn so far; before that, one
   * sample in the renderer's view, so that the curves of that view can be made ready; empty while a part of a
   * stroke is drawn anew, which alone says nothing, and without a renderer.
   */
  void PutSought(vtkPolyData* stroke);

  ///@{
  /**
   * Whether the live stroke is being moved, and by how much [world] since it was taken hold of.
   */
  bool IsMoving() const { return this->Moving; }
  double* GetTranslation() VTK_SIZEHINT(3);
  ///@}

  void SetRepresentation(vtkOversketchOneStrokeRepresentation* representation);
  vtkOversketchOneStrokeRepresentation* GetOneStrokeRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

protected:
  vtkOversketchOneStrokeWidget();
  ~vtkOversketchOneStrokeWidget() override;

private:
  vtkOversketchOneStrokeWidget(const vtkOversketchOneStrokeWidget&) = delete;
  void operator=(const vtkOversketchOneStrokeWidget&) = delete;

  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void MoveTo(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);

  void Heard(unsigned long event);
  void Tell(const std::string& message);
  void PenHasDrawn();
  void BeginMove(const int at[2]);
  void EndMove(bool keep);
  void Refresh();
  void FindSection();
  void MakeCurvesReady();
  void Hover(const int at[2]);

  bool ShowRegion = false;
  bool RunsStrokes = true;
  bool FindsSections = true;
  double GrabDistance = 6.0;
  bool Moving = false, Moved = false, Redrawing = false, PressedOver = false, Extended = false,
       NewStroke = false;
  int Grip[2] = { 0, 0 }; // px
  vtkNew<vtkOversketchStrokeWidget> Pen;
  vtkNew<vtkCallbackCommand> Ear, FrameEar;
  vtkWeakPointer<vtkRenderer> Watched;
  vtkWeakPointer<vtkRenderWindow> WatchedWindow;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
