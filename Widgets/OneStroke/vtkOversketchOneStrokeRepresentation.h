/**
 * @class vtkOversketchOneStrokeRepresentation
 * @brief the stroke of vtkOversketchOneStrokeWidget that can be taken hold of, the region that it moved, a
 * line of text
 *
 * The stroke and the text are those of vtkOversketchHeldStrokeRepresentation; the stroke's plane goes through
 * the middle of the section that it took hold of. The region is drawn orange over the model.
 *
 * @sa vtkOversketchOneStrokeWidget
 */
#ifndef vtkOversketchOneStrokeRepresentation_h
#define vtkOversketchOneStrokeRepresentation_h

#include "OversketchWidgetsOneStrokeModule.h" // For export macro
#include "vtkNew.h"                           // For RegionNormals, RegionActor
#include "vtkOversketchHeldStrokeRepresentation.h"

class vtkActor;
class vtkPolyDataNormals;
class vtkProperty;

class OVERSKETCHWIDGETSONESTROKE_EXPORT vtkOversketchOneStrokeRepresentation
  : public vtkOversketchHeldStrokeRepresentation
{
public:
  static vtkOversketchOneStrokeRepresentation* New();
  vtkTypeMacro(vtkOversketchOneStrokeRepresentation, vtkOversketchHeldStrokeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The part of the mesh to be drawn orange; null none.
   */
  void SetRegion(vtkPolyData* region);

  /**
   * Looks of the region.
   */
  vtkProperty* GetRegionProperty();

  ///@{
  /**
   * As a prop.
   */
  void GetActors(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  ///@}

protected:
  vtkOversketchOneStrokeRepresentation();
  ~vtkOversketchOneStrokeRepresentation() override;

private:
  vtkOversketchOneStrokeRepresentation(const vtkOversketchOneStrokeRepresentation&) = delete;
  void operator=(const vtkOversketchOneStrokeRepresentation&) = delete;

  vtkNew<vtkPolyDataNormals> RegionNormals;
  vtkNew<vtkActor> RegionActor;
};

#endif
