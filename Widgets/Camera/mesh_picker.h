// The point of the mesh under the cursor, soon enough for a press on a million triangles.
#ifndef oversketch_widgets_camera_mesh_picker_h
#define oversketch_widgets_camera_mesh_picker_h

#include "OversketchWidgetsCameraModule.h" // For export macro

#include "vtkCellPicker.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkRenderer;
class vtkStaticCellLocator;

namespace oversketch
{

class OVERSKETCHWIDGETSCAMERA_EXPORT MeshPicker
{
public:
  MeshPicker() { this->Picker->SetTolerance(0.0); }

  // The visible point at a display position [px], null where there is nothing. Meshes that the picker would
  // walk through cell by cell get a locator, which is kept while their actor shows them.
  const double* pick(int x, int y, vtkRenderer* renderer);
  // The actor that is seen there.
  vtkActor* actorAt(int x, int y, vtkRenderer* renderer);

private:
  vtkNew<vtkCellPicker> Picker;
  std::vector<vtkSmartPointer<vtkStaticCellLocator>> Locators;
};

} // namespace oversketch
#endif
