/**
 * @class vtkOversketchLiveStrokeWidget
 * @brief a pen over a mesh, and a system that makes of the mesh and its last stroke what is seen
 *
 * What the widgets of the systems share: a pen whose last stroke stays (vtkOversketchHeldStrokeWidget) and a
 * vtkOversketchSystem of a mesh and one stroke, for any vtkRenderWindowInteractor. A mesh goes in, the mesh
 * as it is drawn comes out of GetOutputPort(), to be shown by a mapper.
 *
 * While the pen is down what the stroke would do is shown over the last frame, once a frame. When it goes up
 * the system runs and the mesh follows. The stroke then is the live stroke: there is one. It can be moved,
 * drawn over in part, and the system's parameters changed, and the mesh follows; with the next stroke, or
 * Commit, it is done with, and the mesh that it made is the one that the next stroke is drawn on.
 *
 * | event | idle | moving the stroke |
 * |---|---|---|
 * | left press beside the live stroke, no modifier | a new stroke begins (the pen's) | |
 * | left press on it (GrabDistance) | it is taken hold of; from elsewhere: the camera goes back to it | |
 * | Shift + left press on it | a stroke begins that replaces a part of it | |
 * | move | what is under the cursor shows that it is | the stroke follows, and the mesh as it can |
 * | left release | | the system runs on the moved stroke |
 * | Escape | the live stroke is dropped: the mesh is as before it | it is where it was taken hold of |
 * | Return, KP_Enter | the live stroke is done with (Commit) | |
 * | o | the region that moved is shown (orange), or not | |
 * | any other button, the wheel, any other key | a subclass's, else not looked at | swallowed |
 *
 * The pen's own events are in its header. A stroke that the system refuses leaves the mesh as it was and
 * stays as the live stroke, to be corrected; why is shown in the window (GetMessage) and sent as
 * MessageEvent.
 *
 * What depends on mesh and view alone is made when the cursor first moves in a view, at the latest when the
 * pen goes down.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for a stroke that is drawn and for
 * one that is moved, and WidgetValueChangedEvent when GetStroke() and the output have changed.
 *
 * A mesh that changes at its source, by pipeline, begins anew without a live stroke.
 *
 * @sa vtkOversketchHeldStrokeWidget, vtkOversketchOneStrokeWidget, vtkOversketchAugmentWidget,
 * vtkOversketchLiveStrokeRepresentation
 */
#ifndef vtkOversketchLiveStrokeWidget_h
#define vtkOversketchLiveStrokeWidget_h

#include "OversketchWidgetsLiveModule.h" // For export macro
#include "vtkOversketchHeldStrokeWidget.h"
#include "vtkWeakPointer.h" // For WatchedWindow

class vtkAlgorithmOutput;
class vtkOversketchLiveStrokeRepresentation;
class vtkOversketchSystem;
class vtkRenderWindow;

class OVERSKETCHWIDGETSLIVE_EXPORT vtkOversketchLiveStrokeWidget : public vtkOversketchHeldStrokeWidget
{
public:
  vtkAbstractTypeMacro(vtkOversketchLiveStrokeWidget, vtkOversketchHeldStrokeWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The triangle mesh to be drawn on (the system's input 0).
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
   * Why the live stroke did nothing; empty when it did something or there is none.
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

  void SetRepresentation(vtkOversketchLiveStrokeRepresentation* representation);
  vtkOversketchLiveStrokeRepresentation* GetLiveStrokeRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchLiveStrokeWidget();
  ~vtkOversketchLiveStrokeWidget() override;

  // The system that runs; set in the constructor, or one of the host's later. The widget connects its inputs.
  void SetSystem(vtkOversketchSystem* system);
  vtkOversketchSystem* GetSystem();

  // Shows on the pen what a stroke would do to a mesh. A stroke of one sample makes ready what does not
  // depend on the stroke, and a null mesh takes away what was shown.
  virtual void Look(vtkPolyData* mesh, vtkPolyData* stroke);
  // Looks with the next frame for the stroke that is drawn, or where LooksWhileMoving moved, by now.
  void LookAgain() { this->Extended = true; }
  virtual bool LooksWhileMoving() const { return false; }

  void LineBegins() override;
  void LineGrows() override { this->LookAgain(); }
  void TakeStroke(vtkPolyData* stroke) override;
  void StrokeMoves() override;
  void EndMove(bool keep) override;
  void CameraRests() override { this->MakeReady(); }
  bool UseKey(const std::string& key) override;
  void Refresh() override;

private:
  void StopWatching();
  void LookNow();
  void MakeReady();

  bool ShowRegion = false;
  bool Extended = false; // the line, since what it would do was shown
  vtkWeakPointer<vtkRenderWindow> WatchedWindow;
  unsigned long FrameTag = 0;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
