// The part of the model that is masked, dark over it.
#ifndef oversketch_applications_studio_view_mask_sheet_h
#define oversketch_applications_studio_view_mask_sheet_h

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <utility>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class MaskSheet
{
public:
  MaskSheet();
  ~MaskSheet();

  void addTo(vtkRenderer* renderer);
  // Shows the faces of the mesh with all corners masked (point array Mask, 1); null: none. They are looked
  // for where faces or array are others than last time.
  void show(vtkPolyData* mesh);
  void setVisible(bool visible);
  bool isShown() const;

private:
  using Key = std::pair<const void*, vtkMTimeType>;
  std::array<Key, 2> Seen{};
  vtkNew<vtkPolyData> Faces;
  vtkNew<vtkActor> Actor;
  bool Visible = true;
};

} // namespace oversketch_studio
#endif
