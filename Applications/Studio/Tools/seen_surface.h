// Surfaces that a line of sight meets: of what is shown of a model, of what is round a part.
#ifndef oversketch_applications_studio_tools_seen_surface_h
#define oversketch_applications_studio_tools_seen_surface_h

#include "Mesh/view.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <optional>

namespace oversketch_studio
{

class SeenSurface
{
public:
  explicit SeenSurface(vtkSmartPointer<vtkPolyData> mesh);

  struct Hit
  {
    oversketch::Vector3 place;
    vtkIdType face;
  };
  // The nearest to the eye through a pixel.
  std::optional<Hit> at(const oversketch::View& view, const oversketch::Vector2& display);
  // The number of a face's part (cell array PartId); 0 where the mesh does not say.
  int partOf(vtkIdType face) const;

private:
  vtkSmartPointer<vtkPolyData> Mesh;
  vtkNew<vtkStaticCellLocator> Locator;
};

} // namespace oversketch_studio
#endif
