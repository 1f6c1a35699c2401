/**
 * @class vtkOversketchEditWidget
 * @brief a line and a ring on a mesh, and every way to change what lies between: system B by hand
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 4 to 7. The five widgets
 * of the edit over one mesh and one vtkOversketchEdit, for any vtkRenderWindowInteractor. A mesh goes in, the
 * mesh as it is edited comes out of GetOutputPort(), to be shown by a mapper. Which of them the hand has is
 * the Mode; the region, and what was done to it, stay from one to the other:
 *
 * | mode | widget | what it changes |
 * |---|---|---|
 * | Region (default) | vtkOversketchRegionWidget | the line, the ring |
 * | Direct | vtkOversketchAxisHandleWidget | Operations |
 * | Shade | vtkOversketchLayerHandleWidget | Layers |
 * | Areas | vtkOversketchAreaSelectWidget | areas; layers are then those of the last one |
 * | Profile | vtkOversketchProfilePlaneWidget | ProfileAt and the profile, in a window of its own |
 *
 * While something is dragged the whole region follows, without new triangles; they come with the release.
 * A key: Return, KP_Enter are done with the edit (Commit), o shows what moved, orange, or not.
 *
 * An edit that the system refuses leaves the mesh as it was, and a line without a ring may be one already;
 * why is shown in the window (GetMessage) and sent as MessageEvent. A mesh that changes at its source, by
 * pipeline, begins anew without an edit.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for what is drawn or dragged, and
 * WidgetValueChangedEvent when the edit and the output have changed.
 *
 * @sa vtkOversketchEdit vtkOversketchEditRepresentation
 */
#ifndef vtkOversketchEditWidget_h
#define vtkOversketchEditWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkAbstractWidget.h"

#include <memory>

namespace oversketch
{
class Message;
}

class vtkAlgorithmOutput;
class vtkOversketchAreaSelectWidget;
class vtkOversketchAxisHandleWidget;
class vtkOversketchEdit;
class vtkOversketchEditRepresentation;
class vtkOversketchLayerHandleWidget;
class vtkOversketchProfilePlaneWidget;
class vtkOversketchRegionWidget;
class vtkPolyData;
class vtkRenderer;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchEditWidget : public vtkAbstractWidget
{
public:
  static vtkOversketchEditWidget* New();
  vtkTypeMacro(vtkOversketchEditWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The triangle mesh to be edited (the system's input 0).
   */
  void SetInputConnection(vtkAlgorithmOutput* mesh);
  void SetInputData(vtkPolyData* mesh);
  ///@}

  ///@{
  /**
   * The mesh as it is edited: the input with what all edits did. The object stays the same. It is brought up
   * to date when the renderer renders, or by Update().
   */
  vtkAlgorithmOutput* GetOutputPort();
  vtkPolyData* GetOutput();
  void Update();
  ///@}

  /**
   * The system that runs, for its parameters, those that the hand changes too: after a change the mesh
   * follows with the next render. The widget connects its inputs 0 to 4.
   */
  vtkOversketchEdit* GetEdit();

  enum ModeType
  {
    Region = 0,
    Direct = 1,
    Shade = 2,
    Areas = 3,
    Profile = 4
  };
  ///@{
  /**
   * Which widget the hand has: that of the Region (default), of the axes (Direct), the layers (Shade), the
   * Areas or the Profile.
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  void SetModeToRegion() { this->SetMode(Region); }
  void SetModeToDirect() { this->SetMode(Direct); }
  void SetModeToShade() { this->SetMode(Shade); }
  void SetModeToAreas() { this->SetMode(Areas); }
  void SetModeToProfile() { this->SetMode(Profile); }
  ///@}

  ///@{
  /**
   * On: line and ring are seen, and redrawn with Shift, in every mode, where Escape takes none of them back;
   * the line where it was drawn, while the ring is there. Default off: in the mode Region alone.
   */
  void SetRegionInAllModes(bool all);
  vtkGetMacro(RegionInAllModes, bool);
  vtkBooleanMacro(RegionInAllModes, bool);
  ///@}

  ///@{
  /**
   * The widgets, to set what is theirs: the profile's window, for one.
   */
  vtkOversketchRegionWidget* GetRegionWidget();
  vtkOversketchAxisHandleWidget* GetAxisHandleWidget();
  vtkOversketchLayerHandleWidget* GetLayerHandleWidget();
  vtkOversketchAreaSelectWidget* GetAreaSelectWidget();
  vtkOversketchProfilePlaneWidget* GetProfilePlaneWidget();
  ///@}

  ///@{
  ///@{
  /**
   * A window for the disc, by its renderer, whose window has an interactor; null (default): none. Layers and
   * areas are changed there, too, in the modes Shade and Areas. The host looks after its camera: the disc is
   * x and y from -1 to 1, z = 0.
   */
  void SetDiscRenderer(vtkRenderer* renderer);
  vtkRenderer* GetDiscRenderer();
  vtkOversketchLayerHandleWidget* GetDiscLayerWidget();
  vtkOversketchAreaSelectWidget* GetDiscAreaWidget();
  ///@}

  /**
   * Is done with the edit: the mesh stays, and is the one that the next line is drawn on. Drops it: the mesh
   * is as before it. Both begin anew in the mode Region.
   */
  void Commit();
  void Drop();
  ///@}

  ///@{
  /**
   * Whether there is a line and a ring that the system takes; why not, or what a widget has to say, empty
   * where there is nothing.
   */
  bool HasRegion() const;
  const char* GetMessage();
  const oversketch::Message& GetSaid() const; // as data
  ///@}

  ///@{
  /**
   * Whether what moved is shown. Default off.
   */
  void SetShowRegion(bool show);
  vtkGetMacro(ShowRegion, bool);
  vtkBooleanMacro(ShowRegion, bool);
  ///@}

  /**
   * Whether something is dragged, and the mesh so a preview.
   */
  bool IsPreviewing() const { return this->Previewing; }

  void SetRepresentation(vtkOversketchEditRepresentation* representation);
  vtkOversketchEditRepresentation* GetEditRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

protected:
  vtkOversketchEditWidget();
  ~vtkOversketchEditWidget() override;

private:
  // Callback of the event translator.
  static void Key(vtkAbstractWidget* widget);

  void Heard(vtkObject* from, unsigned long event, void* text);
  void TakeUp();
  void ReadHand();
  void Connect();
  void Preview();
  void Run();
  void ShowMoved();
  void FeedWidgets();
  void Begin();
  void Say(const oversketch::Message& message);

  int Mode = Region;
  bool RegionInAllModes = false, ShowRegion = false, Previewing = false;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
