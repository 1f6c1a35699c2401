#include "mask_sheet.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace oversketch_studio
{

namespace
{

vtkDataArray* maskOf(vtkPolyData* mesh)
{
  vtkDataArray* mask = mesh ? mesh->GetPointData()->GetArray("Mask") : nullptr;
  const bool fits =
    mask && mask->GetNumberOfComponents() == 1 && mask->GetNumberOfTuples() == mesh->GetNumberOfPoints();
  return fits ? mask : nullptr;
}

vtkSmartPointer<vtkCellArray> maskedFaces(vtkCellArray* faces, vtkDataArray* mask)
{
  constexpr double whole = 1.0 - 1e-6; // interpolated ones are ones
  auto chosen = vtkSmartPointer<vtkCellArray>::New();
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < faces->GetNumberOfCells(); ++i)
  {
    faces->GetCellAtId(i, ids);
    if (std::all_of(ids->begin(), ids->end(), [&](vtkIdType v) { return mask->GetComponent(v, 0) >= whole; }))
    {
      chosen->InsertNextCell(ids);
    }
  }
  return chosen;
}

} // namespace

MaskSheet::MaskSheet()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Faces);
  mapper->ScalarVisibilityOff();
  // Over the surface that it is a part of.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-1.0, -100.0);
  this->Actor->SetMapper(mapper);
  this->Actor->GetProperty()->SetColor(0.05, 0.06, 0.10);
  this->Actor->GetProperty()->SetOpacity(0.5);
  this->Actor->GetProperty()->LightingOff();
  this->Actor->PickableOff();
  this->Actor->VisibilityOff();
}

MaskSheet::~MaskSheet() = default;

void MaskSheet::addTo(vtkRenderer* renderer)
{
  renderer->AddActor(this->Actor);
}

void MaskSheet::show(vtkPolyData* mesh)
{
  vtkDataArray* mask = maskOf(mesh);
  if (!mask)
  {
    this->Seen = {};
    this->Faces->Initialize();
  }
  else
  {
    vtkCellArray* faces = mesh->GetPolys();
    const std::array<Key, 2> now{ Key{ faces, faces->GetMTime() }, Key{ mask, mask->GetMTime() } };
    if (this->Seen != now)
    {
      this->Faces->SetPolys(maskedFaces(faces, mask));
      this->Seen = now;
    }
    this->Faces->SetPoints(mesh->GetPoints());
  }
  this->setVisible(this->Visible);
}

void MaskSheet::setVisible(bool visible)
{
  this->Visible = visible;
  this->Actor->SetVisibility(visible && this->isShown());
}

bool MaskSheet::isShown() const
{
  return this->Faces->GetNumberOfPolys() > 0;
}

} // namespace oversketch_studio
