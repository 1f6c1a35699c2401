/**
 * @class vtkOversketchLiveStrokeRepresentation
 * @brief the stroke of vtkOversketchLiveStrokeWidget that can be taken hold of, the region that it moved, a
 * line of text
 *
 * The stroke and the text are those of vtkOversketchHeldStrokeRepresentation; the stroke's plane goes through
 * the middle of the section that it took hold of. The region is drawn orange over the model.
 *
 * @sa vtkOversketchLiveStrokeWidget
 */
#ifndef vtkOversketchLiveStrokeRepresentation_h
#define vtkOversketchLiveStrokeRepresentation_h

#include "OversketchWidgetsLiveModule.h" // For export macro
#include "vtkOversketchHeldStrokeRepresentation.h"

#include <memory> // For Region

class vtkProperty;

namespace oversketch
{
class MovedRegion;
}

class OVERSKETCHWIDGETSLIVE_EXPORT vtkOversketchLiveStrokeRepresentation
  : public vtkOversketchHeldStrokeRepresentation
{
public:
  static vtkOversketchLiveStrokeRepresentation* New();
  vtkTypeMacro(vtkOversketchLiveStrokeRepresentation, vtkOversketchHeldStrokeRepresentation);
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
  vtkOversketchLiveStrokeRepresentation();
  ~vtkOversketchLiveStrokeRepresentation() override;

private:
  std::unique_ptr<oversketch::MovedRegion> Region;
};

#endif
