/**
 * @class vtkOversketchRegionWidget
 * @brief a line on a model, then a ring round it, either drawn anew in part
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.1 and 4.2. A pen over
 * a model, for any vtkRenderWindowInteractor: its first stroke is the line, its second the ring, which is
 * closed from its last sample to its first; then the pen rests. With Shift a stroke over one of them replaces
 * a part of it, by the rules of vtkOversketchResketch; from any view, since both lie on the model. What they
 * are to vtkOversketchEdit: GetReference is its input 1, GetBoundary its input 2, further polylines redraw.
 * One that an earlier edit has put out can be shown, but not redrawn.
 *
 * | event | idle |
 * |---|---|
 * | left press, no modifier | the line begins, then the ring; then not looked at |
 * | Shift + left press | a stroke begins that replaces a part of line or ring, where there is one |
 * | move | the one that Shift would change is shown wider |
 * | Escape | what was drawn last is taken back |
 *
 * The curve that a stroke changes is the one that is nearest to either of its ends, at most 20 px away, and
 * of the same distance the line. The pen's own events are in its header, what is fired in
 * vtkOversketchCurvePenWidget.
 *
 * @sa vtkOversketchEdit vtkOversketchRegionRepresentation
 */
#ifndef vtkOversketchRegionWidget_h
#define vtkOversketchRegionWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkNew.h"                      // For Reference, Boundary
#include "vtkOversketchCurvePenWidget.h"

#include <memory>

class vtkAlgorithmOutput;
class vtkOversketchRegionRepresentation;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchRegionWidget : public vtkOversketchCurvePenWidget
{
public:
  static vtkOversketchRegionWidget* New();
  vtkTypeMacro(vtkOversketchRegionWidget, vtkOversketchCurvePenWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The triangle mesh that curves are laid on to be shown (null, default: none; then they lie in the plane of
   * the camera's focal point).
   */
  void SetModel(vtkPolyData* mesh);
  vtkPolyData* GetModel();
  ///@}

  ///@{
  /**
   * The line and the ring for vtkOversketchEdit: of each the first polyline as it was drawn, then those that
   * redraw it, with their views (vtkOversketchStrokeWidget::GetStroke); empty where there is none. The
   * objects stay the same; the ports connect filters to them.
   */
  vtkPolyData* GetReference() { return this->Reference; }
  vtkPolyData* GetBoundary() { return this->Boundary; }
  vtkAlgorithmOutput* GetReferencePort();
  vtkAlgorithmOutput* GetBoundaryPort();
  ///@}

  /**
   * Takes others in their place; null: none, and no ring without a line. A polyline with point array VertexId
   * is one that an earlier edit has put out. False, and nothing changed, where they are no strokes with
   * views. Fires no event.
   */
  bool SetRegion(vtkPolyData* reference, vtkPolyData* boundary);

  /**
   * The curves as they lie in a model, polylines in the world, to be shown in place of what was drawn, such
   * as outputs 1 and 2 of vtkOversketchEdit (null: what was drawn, by itself). With the next change by the
   * hand what was drawn is shown again.
   */
  void ShowCurves(vtkPolyData* reference, vtkPolyData* boundary);

  ///@{
  /**
   * Whether there is a line and a ring.
   */
  bool HasReference() const;
  bool HasBoundary() const;
  ///@}

  ///@{
  /**
   * On: strokes with Shift alone, which redraw what is there, and Escape takes nothing back. Default off.
   */
  void SetRedrawOnly(bool only);
  vtkGetMacro(RedrawOnly, bool);
  vtkBooleanMacro(RedrawOnly, bool);
  ///@}

  void SetRepresentation(vtkOversketchRegionRepresentation* representation);
  vtkOversketchRegionRepresentation* GetRegionRepresentation();
  void CreateDefaultRepresentation() override;

protected:
  vtkOversketchRegionWidget();
  ~vtkOversketchRegionWidget() override;

  bool Wants(bool over) override;
  bool TakeStroke(vtkPolyData* stroke, bool over) override;
  bool TakeBack() override;
  void ShowText(const std::string& text) override;

private:
  // Callback of the event translator.
  static void Hover(vtkAbstractWidget* widget);

  void Publish();

  bool RedrawOnly = false;
  vtkNew<vtkPolyData> Reference, Boundary;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
