#include "vtkOversketchEditRepresentation.h"

#include "edit_overlay.h"

#include "Mesh/view.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkOversketchEditRepresentation);

vtkOversketchEditRepresentation::vtkOversketchEditRepresentation()
{
  this->RegionNormals->SplittingOff();
  vtkNew<vtkPolyDataMapper> onModel;
  onModel->SetInputConnection(this->RegionNormals->GetOutputPort());
  onModel->ScalarVisibilityOff();
  // Over the surface that it is a part of.
  onModel->SetResolveCoincidentTopologyToPolygonOffset();
  onModel->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -200.0);
  this->RegionActor->SetMapper(onModel);
  this->RegionActor->GetProperty()->SetColor(0.98, 0.62, 0.20);
  this->RegionActor->GetProperty()->SetAmbient(0.12);
  this->RegionActor->GetProperty()->SetDiffuse(0.85);
  this->RegionActor->PickableOff();
  this->RegionActor->VisibilityOff();
}

vtkOversketchEditRepresentation::~vtkOversketchEditRepresentation() = default;

void vtkOversketchEditRepresentation::SetRegion(vtkPolyData* region)
{
  const bool any = region && region->GetNumberOfPolys() > 0;
  this->RegionNormals->SetInputData(any ? region : nullptr);
  this->RegionActor->SetVisibility(any);
  this->Modified();
}

vtkProperty* vtkOversketchEditRepresentation::GetRegionProperty()
{
  return this->RegionActor->GetProperty();
}

void vtkOversketchEditRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->RegionActor->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkOversketchEditRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return (this->RegionActor->GetVisibility() ? this->RegionActor->RenderOpaqueGeometry(viewport) : 0) +
         this->Superclass::RenderOpaqueGeometry(viewport);
}

int vtkOversketchEditRepresentation::FindGrip(const oversketch::View&, double, double)
{
  return 0;
}

void vtkOversketchEditRepresentation::Paint(const oversketch::View&, oversketch::Overlay&) {}

void vtkOversketchEditRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << (this->RegionActor->GetVisibility() ? "shown" : "(none)") << "\n";
}
