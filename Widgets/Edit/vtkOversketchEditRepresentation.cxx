#include "vtkOversketchEditRepresentation.h"

#include "moved_region.h"

#include "vtkActor.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

vtkStandardNewMacro(vtkOversketchEditRepresentation);

vtkOversketchEditRepresentation::vtkOversketchEditRepresentation()
  : Region(std::make_unique<oversketch::MovedRegion>())
{
  this->AddActor(this->Region->actor());
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

void vtkOversketchEditRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Region: " << (this->Region->isShown() ? "shown" : "(none)") << "\n";
}
