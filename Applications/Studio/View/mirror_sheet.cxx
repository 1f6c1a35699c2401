#include "mirror_sheet.h"

#include "vtkActor.h"
#include "vtkFeatureEdges.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace oversketch_studio
{

MirrorSheet::MirrorSheet()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(this->Plane->GetOutputPort());
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetOpacity(0.15);
  vtkNew<vtkFeatureEdges> rim;
  rim->SetInputConnection(this->Plane->GetOutputPort());
  rim->ColoringOff();
  vtkNew<vtkPolyDataMapper> line;
  line->SetInputConnection(rim->GetOutputPort());
  line->ScalarVisibilityOff();
  this->Border->SetMapper(line);
  this->Border->GetProperty()->SetOpacity(0.8);
  for (vtkActor* actor : { this->Actor.Get(), this->Border.Get() })
  {
    actor->GetProperty()->LightingOff();
    actor->PickableOff();
    actor->VisibilityOff();
  }
}

MirrorSheet::~MirrorSheet() = default;

void MirrorSheet::addTo(vtkRenderer* renderer)
{
  renderer->AddActor(this->Actor);
  renderer->AddActor(this->Border);
}

void MirrorSheet::show(const std::optional<oversketch_session::MirrorPlane>& plane, vtkPolyData* mesh)
{
  this->setVisible(plane && mesh);
  if (plane && mesh)
  {
    double box[6];
    mesh->GetBounds(box);
    const int a = (plane->axis + 1) % 3, b = (plane->axis + 2) % 3;
    const double margin = 0.1 * mesh->GetLength();
    double origin[3], first[3], second[3];
    origin[plane->axis] = plane->offset;
    origin[a] = box[2 * a] - margin;
    origin[b] = box[2 * b] - margin;
    std::copy(origin, origin + 3, first);
    std::copy(origin, origin + 3, second);
    first[a] = box[2 * a + 1] + margin;
    second[b] = box[2 * b + 1] + margin;
    this->Plane->SetOrigin(origin);
    this->Plane->SetPoint1(first);
    this->Plane->SetPoint2(second);
  }
}

void MirrorSheet::setVisible(bool visible)
{
  this->Actor->SetVisibility(visible);
  this->Border->SetVisibility(visible);
}

bool MirrorSheet::isVisible() const
{
  return this->Actor->GetVisibility();
}

void MirrorSheet::setDark(bool dark)
{
  for (vtkActor* actor : { this->Actor.Get(), this->Border.Get() })
  {
    dark ? actor->GetProperty()->SetColor(0.6, 0.8, 1.0) : actor->GetProperty()->SetColor(0.2, 0.4, 0.7);
  }
}

} // namespace oversketch_studio
