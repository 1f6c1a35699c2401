/**
 * @class vtkOversketchEditRepresentation
 * @brief what vtkOversketchEditWidget adds to the pictures of its widgets: what moved, a line of text
 *
 * What moved is orange over the model, as by a live stroke.
 *
 * @sa vtkOversketchEditWidget
 */
#ifndef vtkOversketchEditRepresentation_h
#define vtkOversketchEditRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory> // For Region

class vtkPolyData;
class vtkProperty;

namespace oversketch
{
class MovedRegion;
}

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchEditRepresentation : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchEditRepresentation* New();
  vtkTypeMacro(vtkOversketchEditRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The part of the mesh to be drawn orange; null none.
   */
  void SetRegion(vtkPolyData* region);

  /**
   * Looks of it.
   */
  vtkProperty* GetRegionProperty();

protected:
  vtkOversketchEditRepresentation();
  ~vtkOversketchEditRepresentation() override;

private:
  std::unique_ptr<oversketch::MovedRegion> Region;
};

#endif
