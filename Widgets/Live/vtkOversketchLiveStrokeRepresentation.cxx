#include "vtkOversketchLiveStrokeRepresentation.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkOversketchLiveStrokeRepresentation);

vtkOversketchLiveStrokeRepresentation::vtkOversketchLiveStrokeRepresentation()
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

vtkOversketchLiveStrokeRepresentation::~vtkOversketchLiveStrokeRepresentation() = default;

void vtkOversketchLiveStrokeRepresentation::SetRegion(vtkPolyData* region)
{
  const bool any = region && region->GetNumberOfPolys() > 0;
  this->RegionNormals->SetInputData(any ? region : nullptr);
  this->RegionActor->SetVisibility(any);
  this->Modified();
}

vtkProperty* vtkOversketchLiveStrokeRepresentation::GetRegionProperty()
{
  return this->RegionActor->GetProperty();
}

void vtkOversketchLiveStrokeRepresentation::GetActors(vtkPropCollection* actors)
{
  actors->AddItem(this->RegionActor);
}

void vtkOversketchLiveStrokeRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->RegionActor->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkOversketchLiveStrokeRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return (this->RegionActor->GetVisibility() ? this->RegionActor->RenderOpaqueGeometry(viewport) : 0) +
         this->Superclass::RenderOpaqueGeometry(viewport);
}

void vtkOversketchLiveStrokeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << (this->RegionActor->GetVisibility() ? "shown" : "(none)") << "\n";
}
