#include "vtkOversketchEditRepresentation.h"

#include "edit_overlay.h"
#include "moved_region.h"

#include "Mesh/view.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkOversketchEditRepresentation);

vtkOversketchEditRepresentation::vtkOversketchEditRepresentation()
  : Region(std::make_unique<oversketch::MovedRegion>())
{
}

vtkOversketchEditRepresentation::~vtkOversketchEditRepresentation() = default;

void vtkOversketchEditRepresentation::SetRegion(vtkPolyData* region)
{
  this->Region->show(region);
  this->Modified();
}

vtkProperty* vtkOversketchEditRepresentation::GetRegionProperty()
{
  return this->Region->actor()->GetProperty();
}

void vtkOversketchEditRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Region->actor()->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

int vtkOversketchEditRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  return (this->Region->isShown() ? this->Region->actor()->RenderOpaqueGeometry(viewport) : 0) +
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
  os << indent << "Region: " << (this->Region->isShown() ? "shown" : "(none)") << "\n";
}
