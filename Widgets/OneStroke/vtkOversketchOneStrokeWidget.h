/**
 * @class vtkOversketchOneStrokeWidget
 * @brief draw a stroke over a mesh and the mesh follows; take hold of the stroke again and it follows on
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 2, Figs. 1 and 2. A pen whose last
 * stroke stays (vtkOversketchHeldStrokeWidget) and the system (vtkOversketchOneStroke) for any
 * vtkRenderWindowInteractor: a mesh goes in, the mesh as it is drawn comes out of GetOutputPort(), to be
 * shown by a mapper.
 *
 * While the pen is down the section of the silhouette that the stroke takes hold of is shown (blue) under the
 * stroke (red), over the last frame. When it goes up the system runs and the mesh follows. The stroke then is
 * the live stroke: there is one. It can be moved, drawn over in part, and the system's parameters changed,
 * and the mesh follows; with the next stroke, or Commit, it is done with, and the mesh that it made is the
 * one that the next stroke is drawn on.
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
 * @sa vtkOversketchHeldStrokeWidget, vtkOversketchOneStroke, vtkOversketchOneStrokeRepresentation
 */
#ifndef vtkOversketchOneStrokeWidget_h
#define vtkOversketchOneStrokeWidget_h

#include "OversketchWidgetsOneStrokeModule.h" // For export macro
#include "vtkNew.h"                           // For the observers
#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkWeakPointer.h" // For Watched, WatchedWindow

class vtkAlgorithmOutput;
class vtkOversketchOneStroke;
class vtkOversketchOneStrokeRepresentation;
class vtkRenderWindow;

class OVERSKETCHWIDGETSONESTROKE_EXPORT vtkOversketchOneStrokeWidget : public vtkOversketchHeldStrokeWidget
{
public:
  static vtkOversketchOneStrokeWidget* New();
  vtkTypeMacro(vtkOversketchOneStrokeWidget, vtkOversketchHeldStrokeWidget);
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

  ///@{
  /**
   * Makes a stroke with its view the live one (GetStroke()), and the mesh follows; null or an empty one is
   * Drop. It stands where it takes hold, whatever place is given.
   */
  void SetStroke(vtkPolyData* stroke);
  void HoldStroke(vtkPolyData* stroke, const double place[3]) override;
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

  void SetRepresentation(vtkOversketchOneStrokeRepresentation* representation);
  vtkOversketchOneStrokeRepresentation* GetOneStrokeRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchOneStrokeWidget();
  ~vtkOversketchOneStrokeWidget() override;

  void LineBegins() override;
  void LineGrows() override { this->Extended = true; }
  void TakeStroke(vtkPolyData* stroke) override;
  void StrokeMoves() override;
  void EndMove(bool keep) override;
  void CameraRests() override { this->MakeCurvesReady(); }
  bool UseKey(const std::string& key) override;
  void Refresh() override;

private:
  vtkOversketchOneStrokeWidget(const vtkOversketchOneStrokeWidget&) = delete;
  void operator=(const vtkOversketchOneStrokeWidget&) = delete;

  void StopWatching();
  void FindSection();
  void MakeCurvesReady();

  bool ShowRegion = false;
  bool Extended = false; // the line, since its section was found
  vtkNew<vtkCallbackCommand> RendererObserver, FrameObserver;
  vtkWeakPointer<vtkRenderer> Watched;
  vtkWeakPointer<vtkRenderWindow> WatchedWindow;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
