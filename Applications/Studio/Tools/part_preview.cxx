#include "part_preview.h"

#include "turning_normals.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <numeric>

namespace oversketch_studio
{

using oversketch::Vector3;

std::vector<vtkIdType> pointsOfPart(vtkPolyData* mesh, int part)
{
  std::vector<vtkIdType> points;
  auto* numbers = vtkIntArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("PartId"));
  if (part < 0 || (part == 0 && !numbers))
  {
    points.resize(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
    std::iota(points.begin(), points.end(), vtkIdType{ 0 });
    return points;
  }
  for (vtkIdType f = 0; numbers && f < mesh->GetNumberOfPolys(); ++f)
  {
    if (numbers->GetValue(f) == part)
    {
      vtkIdType corners = 0;
      const vtkIdType* ids = nullptr;
      mesh->GetPolys()->GetCellAtId(f, corners, ids);
      points.insert(points.end(), ids, ids + corners);
    }
  }
  oversketch::sortUnique(points);
  return points;
}

Eigen::AlignedBox3d boxOfPoints(vtkPolyData* mesh, const std::vector<vtkIdType>& points)
{
  Eigen::AlignedBox3d box;
  for (const vtkIdType point : points)
  {
    box.extend(Vector3(mesh->GetPoint(point)));
  }
  return box;
}

PartPreview::PartPreview(vtkPolyData* rest, int part)
  : Rest(rest)
  , Shown(vtkSmartPointer<vtkPolyData>::New())
  , Points(pointsOfPart(rest, part))
{
  copyToMove(rest, this->Shown);
}

void PartPreview::moveTo(const Eigen::Affine3d& by)
{
  vtkPoints* points = this->Shown->GetPoints();
  vtkDataArray* from = this->Rest->GetPointData()->GetNormals();
  vtkDataArray* normals = this->Shown->GetPointData()->GetNormals();
  const Eigen::Matrix3d turn = by.linear().inverse().transpose();
  for (const vtkIdType i : this->Points)
  {
    const Vector3 at = by * Vector3(this->Rest->GetPoint(i));
    points->SetPoint(i, at.data());
    if (normals)
    {
      const Vector3 normal = (turn * Vector3(from->GetTuple(i))).normalized();
      normals->SetTuple(i, normal.data());
    }
  }
  points->Modified();
  if (normals)
  {
    normals->Modified();
  }
  this->Shown->Modified();
}

} // namespace oversketch_studio
