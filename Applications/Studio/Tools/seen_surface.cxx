#include "seen_surface.h"

#include "gizmo_drag.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"

#include <utility>

namespace oversketch_studio
{

using oversketch::Vector2;
using oversketch::Vector3;
using oversketch::View;

SeenSurface::SeenSurface(vtkSmartPointer<vtkPolyData> mesh)
  : Mesh(std::move(mesh))
{
  if (this->Mesh->GetNumberOfPolys() > 0)
  {
    this->Locator->SetDataSet(this->Mesh);
    this->Locator->BuildLocator();
  }
}

std::optional<SeenSurface::Hit> SeenSurface::at(const View& view, const Vector2& display)
{
  if (this->Mesh->GetNumberOfPolys() == 0)
  {
    return std::nullopt;
  }
  const Vector3 middle(this->Mesh->GetCenter());
  const double reach = this->Mesh->GetLength();
  const Sight sight = sightAt(view, display, middle);
  const double far = reach + (sight.origin() - middle).norm();
  const Vector3 from = view.perspective() ? view.eye() : Vector3(sight.pointAt(-far)),
                to = view.perspective()
                       ? Vector3(view.eye() + ((middle - view.eye()).norm() + reach) * sight.direction())
                       : Vector3(sight.pointAt(far));
  double along = 0.0, coordinates[3];
  Vector3 place;
  int part = 0;
  vtkIdType face = -1;
  const bool isMet = this->Locator->IntersectWithLine(
                       from.data(), to.data(), 0.0, along, place.data(), coordinates, part, face) != 0;
  return isMet ? std::optional<Hit>({ place, face }) : std::nullopt;
}

int SeenSurface::partOf(vtkIdType face) const
{
  auto* numbers = vtkIntArray::SafeDownCast(this->Mesh->GetCellData()->GetAbstractArray("PartId"));
  return numbers ? numbers->GetValue(face) : 0;
}

} // namespace oversketch_studio
