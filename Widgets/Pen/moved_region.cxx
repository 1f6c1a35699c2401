#include "moved_region.h"

#include "vtkActor.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"

namespace oversketch
{

MovedRegion::MovedRegion()
{
  this->Normals->SplittingOff();
  vtkNew<vtkPolyDataMapper> onModel;
  onModel->SetInputConnection(this->Normals->GetOutputPort());
  onModel->ScalarVisibilityOff();
  // Over the surface that it is a part of.
  onModel->SetResolveCoincidentTopologyToPolygonOffset();
  onModel->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -200.0);
  this->Actor->SetMapper(onModel);
  this->Actor->GetProperty()->SetColor(0.98, 0.62, 0.20);
  this->Actor->GetProperty()->SetAmbient(0.12);
  this->Actor->GetProperty()->SetDiffuse(0.85);
  this->Actor->PickableOff();
  this->Actor->VisibilityOff();
}

MovedRegion::~MovedRegion() = default;

void MovedRegion::show(vtkPolyData* region)
{
  const bool any = region && region->GetNumberOfPolys() > 0;
  this->Normals->SetInputData(any ? region : nullptr);
  this->Actor->SetVisibility(any);
}

bool MovedRegion::isShown() const
{
  return this->Actor->GetVisibility() != 0;
}

} // namespace oversketch
