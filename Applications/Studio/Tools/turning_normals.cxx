#include "turning_normals.h"

#include "vtkOversketchFilterTools.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>

namespace oversketch_studio
{

void copyToMove(vtkPolyData* mesh, vtkPolyData* copy)
{
  copy->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->DeepCopy(mesh->GetPoints());
  copy->SetPoints(points);
  if (vtkDataArray* normals = mesh->GetPointData()->GetNormals())
  {
    const auto own = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
    own->DeepCopy(normals);
    copy->GetPointData()->SetNormals(own);
  }
}

void TurningNormals::bind(vtkPolyData* rest, const std::vector<vtkIdType>& moving)
{
  *this = {};
  const auto count = static_cast<std::size_t>(rest->GetNumberOfPoints());
  std::vector<char> moves(count, 0);
  for (const vtkIdType point : moving)
  {
    moves[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<int> places(count, -1);
  const auto numberOf = [&](vtkIdType id)
  {
    int& place = places[static_cast<std::size_t>(id)];
    if (place < 0)
    {
      place = static_cast<int>(this->Points.size());
      this->Points.push_back(id);
    }
    return place;
  };
  // The points that move and those that share a triangle with one turn.
  eachTriangle(rest,
    [&](const auto& ids)
    {
      if (std::any_of(
            ids.begin(), ids.end(), [&](vtkIdType id) { return moves[static_cast<std::size_t>(id)] != 0; }))
      {
        std::for_each(ids.begin(), ids.end(), numberOf);
      }
    });
  const auto turning = static_cast<int>(this->Points.size());
  const auto turns = [&](vtkIdType id)
  {
    const int place = places[static_cast<std::size_t>(id)];
    return place >= 0 && place < turning;
  };
  eachTriangle(rest,
    [&](const auto& ids)
    {
      if (std::any_of(ids.begin(), ids.end(), turns))
      {
        this->Patch.triangles.push_back({ numberOf(ids[0]), numberOf(ids[1]), numberOf(ids[2]) });
      }
    });
  this->Patch.points.resize(this->Points.size());
  this->Around = oversketch::trianglesAround(this->Patch);
  this->Before = this->seen(rest);
  this->Before.resize(static_cast<std::size_t>(turning));
}

std::vector<oversketch::Vector3> TurningNormals::seen(vtkPolyData* mesh)
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    mesh->GetPoint(this->Points[i], this->Patch.points[i].data());
  }
  return oversketch::vertexNormals(this->Patch, this->Around, oversketch::ThreadsOnly());
}

void TurningNormals::turn(vtkDataArray* normals, vtkPolyData* moved)
{
  const std::vector<oversketch::Vector3> now = this->seen(moved);
  vtkDataArray* turned = moved->GetPointData()->GetNormals();
  for (std::size_t i = 0; i < this->Before.size(); ++i)
  {
    oversketch::Vector3 normal;
    normals->GetTuple(this->Points[i], normal.data());
    normal += now[i] - this->Before[i];
    vtkMath::Normalize(normal.data());
    turned->SetTuple(this->Points[i], normal.data());
  }
  turned->Modified();
}

} // namespace oversketch_studio
