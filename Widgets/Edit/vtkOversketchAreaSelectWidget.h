/**
 * @class vtkOversketchAreaSelectWidget
 * @brief a lasso round a part of a region, on the disc or on the model
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.4, Fig. 5.5. A pen
 * for any vtkRenderWindowInteractor: each of its strokes is an area, closed from its last sample to its
 * first, which may cross itself (vtkOversketchScanFill says what lies in it). An area has layers of its own
 * where vtkOversketchLayerHandleWidget gives them, whose representation's Area says in which.
 *
 * | event | idle |
 * |---|---|
 * | left press, no modifier | a lasso begins, where there is a region |
 * | Escape | the area that was drawn last is taken back |
 *
 * The pen's own events are in its header, what is fired in vtkOversketchCurvePenWidget. A lasso that holds
 * nothing of the region is refused in words.
 *
 * @sa vtkOversketchScanFill vtkOversketchAreaSelectRepresentation
 */
#ifndef vtkOversketchAreaSelectWidget_h
#define vtkOversketchAreaSelectWidget_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkNew.h"                      // For Areas
#include "vtkOversketchCurvePenWidget.h"

#include <memory>

class vtkAlgorithmOutput;
class vtkOversketchAreaSelectRepresentation;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchAreaSelectWidget : public vtkOversketchCurvePenWidget
{
public:
  static vtkOversketchAreaSelectWidget* New();
  vtkTypeMacro(vtkOversketchAreaSelectWidget, vtkOversketchCurvePenWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh with point arrays DiscCoords and CurveDistance (vtkOversketchEdit's inner output Distance);
   * null: none. False, with an error, for another one. Areas stay: they are on the disc.
   */
  bool SetRegion(vtkPolyData* mesh);

  ///@{
  /**
   * The areas for vtkOversketchEdit's input 4: polylines on the disc, in the order they were drawn; empty at
   * first. The object stays the same; the port connects filters to it. SetAreas takes others in their place
   * (null: none) and fires no event.
   */
  vtkPolyData* GetAreas() { return this->Areas; }
  vtkAlgorithmOutput* GetAreasPort();
  void SetAreas(vtkPolyData* areas);
  ///@}

  void SetRepresentation(vtkOversketchAreaSelectRepresentation* representation);
  vtkOversketchAreaSelectRepresentation* GetAreaSelectRepresentation();
  void CreateDefaultRepresentation() override;

protected:
  vtkOversketchAreaSelectWidget();
  ~vtkOversketchAreaSelectWidget() override;

  bool Wants(bool over) override;
  bool TakeStroke(vtkPolyData* stroke, bool over) override;
  bool TakeBack() override;
  void ShowText(const std::string& text) override;

private:
  void Publish(vtkPolyData* areas);

  vtkNew<vtkPolyData> Areas;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
