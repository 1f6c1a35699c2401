/**
 * @class vtkOversketchProfilePlaneWidget
 * @brief a plane that slides along the line, the section that it cuts, and the section drawn anew by a pen
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 6, Fig. 6.1 and 6.2,
 * App. A, Table 1. For any vtkRenderWindowInteractor: the planes and the section are in its window, the
 * profile, flat, in another one with a pen of its own (SetProfileRenderer). Its strokes are
 * vtkOversketchEdit's input 3: each replaces a part of what is there, by the rules of vtkOversketchResketch.
 *
 * | event in the model's window | what it does |
 * |---|---|
 * | left drag of the b-plane: its knob, its border or the section | it slides along the line |
 * | 6, 0 | all planes are shown, or none |
 * | 7, 8, 9 | the n-, the t- or the b-plane alone is shown |
 * | Escape | while dragging: as before |
 *
 * | event in the profile's window | what it does |
 * |---|---|
 * | left drag | a stroke, which waits and can be drawn over (the pen's header says how) |
 * | Return, KP_Enter | it counts |
 * | Escape | the stroke that waits is dropped; without one the last that counted is taken back |
 *
 * StartInteractionEvent, InteractionEvent and EndInteractionEvent are fired for a plane that slides,
 * WidgetValueChangedEvent when the hand has changed ProfileAt or GetProfile, MessageEvent, with the text that
 * is shown, where no section can be cut.
 *
 * @sa vtkOversketchGripWidget vtkOversketchProfilePlanes vtkOversketchCrossSection
 */
#ifndef vtkOversketchProfilePlaneWidget_h
#define vtkOversketchProfilePlaneWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkNew.h"                      // For Profile, Pen, the observers
#include "vtkOversketchGripWidget.h"

#include <memory>

class vtkAlgorithmOutput;
class vtkOversketchProfilePlaneRepresentation;
class vtkOversketchProfileRepresentation;
class vtkOversketchStrokeWidget;
class vtkPolyData;
class vtkRenderer;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchProfilePlaneWidget : public vtkOversketchGripWidget
{
public:
  static vtkOversketchProfilePlaneWidget* New();
  vtkTypeMacro(vtkOversketchProfilePlaneWidget, vtkOversketchGripWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh with point arrays CurveDistance and CurveSide (vtkOversketchEdit's inner output Distance), and
   * the line and the ring on it, with point array VertexId; null: none. A drag ends, strokes stay. False, and
   * a message, where no section can be cut.
   */
  bool SetRegion(vtkPolyData* mesh, vtkPolyData* reference, vtkPolyData* boundary);

  ///@{
  /**
   * Where the plane is: share of the line's length [0 to 1, default 0.5], for vtkOversketchEdit. Setting it
   * ends a drag and fires no event.
   */
  void SetProfileAt(double t);
  vtkGetMacro(ProfileAt, double);
  ///@}

  ///@{
  /**
   * The strokes for vtkOversketchEdit's input 3, in the order they were drawn, each with its view onto the
   * profile's plane; empty at first. The object stays the same; the port connects filters to it. SetProfile
   * takes others in their place (null: none) and fires no event.
   */
  vtkPolyData* GetProfile() { return this->Profile; }
  vtkAlgorithmOutput* GetProfilePort();
  void SetProfile(vtkPolyData* strokes);
  ///@}

  ///@{
  /**
   * The section as it is: flat, and on the model (vtkOversketchCrossSection's outputs). Empty where there is
   * none.
   */
  vtkPolyData* GetSectionProfile();
  vtkPolyData* GetSection();
  ///@}

  /**
   * The mesh of the region after the edit, with the same vertices, for the section to be shown on; null
   * (default): as it was before. The section is cut before the edit all the same.
   */
  void ShowSectionOn(vtkPolyData* moved);

  ///@{
  /**
   * The profile's window, by its renderer, whose window has an interactor; null (default): none. The pen
   * draws there while this widget is enabled.
   */
  void SetProfileRenderer(vtkRenderer* renderer);
  vtkRenderer* GetProfileRenderer();
  vtkOversketchProfileRepresentation* GetProfileRepresentation();
  vtkOversketchStrokeWidget* GetPen();
  ///@}

  void SetRepresentation(vtkOversketchProfilePlaneRepresentation* representation);
  vtkOversketchProfilePlaneRepresentation* GetProfilePlaneRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchProfilePlaneWidget();
  ~vtkOversketchProfilePlaneWidget() override;

  bool Grasp(int grip, const int at[2]) override;
  void Pull(const int at[2]) override;
  bool LetGo(bool keep) override;
  bool UseKey(const std::string& key) override;

private:
  void ShowRegion();
  bool Cut();
  void ShowProfile();
  void ShowSection(vtkPolyData* planes);
  void TakeStroke();
  void TakeBack();
  void ReadyPen();

  double ProfileAt = 0.5, Before = 0.5;
  int From[2] = { 0, 0 };
  vtkNew<vtkPolyData> Profile;
  vtkNew<vtkOversketchStrokeWidget> Pen;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
