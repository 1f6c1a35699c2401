#include "vtkOversketchLiveStrokeRepresentation.h"

#include "moved_region.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkOversketchLiveStrokeRepresentation);

vtkOversketchLiveStrokeRepresentation::vtkOversketchLiveStrokeRepresentation()
  : Region(std::make_unique<oversketch::MovedRegion>())
{
}

vtkOversketchLiveStrokeRepresentation::~vtkOversketchLiveStrokeRepresentation() = default;

void vtkOversketchLiveStrokeRepresentation::SetRegion(vtkPolyData* region)
{
  this->Region->show(region);
  this->Modified();
}

vtkProperty* vtkOversketchLiveStrokeRepresentation::GetRegionProperty()
{
  return this->Region->actor()->GetProperty();
}

void vtkOversketchLiveStrokeRepresentation::GetActors(vtkPropCollection* actors)
{
  actors->AddItem(this->Region->actor());
}

void vtkOversketchLiveStrokeRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Region->actor()->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkOversketchLiveStrokeRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return (this->Region->isShown() ? this->Region->actor()->RenderOpaqueGeometry(viewport) : 0) +
         this->Superclass::RenderOpaqueGeometry(viewport);
}

void vtkOversketchLiveStrokeRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << (this->Region->isShown() ? "shown" : "(none)") << "\n";
}
