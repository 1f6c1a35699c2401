#include "preview.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <cmath>

namespace oversketch_studio
{

Preview::Preview(vtkPolyData* rest, const Following& following)
  : Rest(rest)
  , Shown(vtkSmartPointer<vtkPolyData>::New())
  , Followed(following)
{
  this->Shown->ShallowCopy(rest);
  vtkNew<vtkPoints> points;
  points->SetDataType(rest->GetPoints()->GetDataType());
  points->DeepCopy(rest->GetPoints());
  this->Shown->SetPoints(points);
  if (vtkDataArray* normals = rest->GetPointData()->GetNormals())
  {
    const auto own = vtkSmartPointer<vtkDataArray>::Take(normals->NewInstance());
    own->DeepCopy(normals);
    this->Shown->GetPointData()->SetNormals(own);
    this->findTurned();
    this->Before = this->normals();
  }
}

// The points that move and those that share a triangle with one, and all triangles round these.
void Preview::findTurned()
{
  const auto count = static_cast<std::size_t>(this->Rest->GetNumberOfPoints());
  std::vector<char> moves(count, 0);
  for (const vtkIdType point : this->Followed->points)
  {
    moves[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<int> place(count, -1);
  const auto iterator = vtkSmartPointer<vtkCellArrayIterator>::Take(this->Rest->GetPolys()->NewIterator());
  const auto eachFace = [&](const auto& visit)
  {
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      visit(std::array<vtkIdType, 3>{ ids[0], ids[1], ids[2] });
    }
  };
  const auto any = [](const std::array<vtkIdType, 3>& ids, const auto& has)
  { return has(ids[0]) || has(ids[1]) || has(ids[2]); };
  eachFace(
    [&](const std::array<vtkIdType, 3>& ids)
    {
      if (any(ids, [&](vtkIdType id) { return moves[static_cast<std::size_t>(id)] != 0; }))
      {
        for (const vtkIdType id : ids)
        {
          int& at = place[static_cast<std::size_t>(id)];
          if (at < 0)
          {
            at = static_cast<int>(this->Turned.size());
            this->Turned.push_back(id);
          }
        }
      }
    });
  eachFace(
    [&](const std::array<vtkIdType, 3>& ids)
    {
      if (any(ids, [&](vtkIdType id) { return place[static_cast<std::size_t>(id)] >= 0; }))
      {
        Face face{ ids, {} };
        for (std::size_t k = 0; k < 3; ++k)
        {
          face.turned[k] = place[static_cast<std::size_t>(ids[k])];
        }
        this->Faces.push_back(face);
      }
    });
}

// Of the surface as it is shown, weighted by the angles of the triangles at the point.
std::vector<Preview::Vector> Preview::normals() const
{
  std::vector<Vector> sums(this->Turned.size(), Vector{});
  for (const Face& face : this->Faces)
  {
    double at[3][3], side[3][3], normal[3];
    for (int k = 0; k < 3; ++k)
    {
      this->Shown->GetPoint(face.points[static_cast<std::size_t>(k)], at[k]);
    }
    for (int k = 0; k < 3; ++k)
    {
      vtkMath::Subtract(at[(k + 1) % 3], at[k], side[k]);
      vtkMath::Normalize(side[k]);
    }
    vtkMath::Cross(side[0], side[1], normal);
    if (vtkMath::Normalize(normal) == 0.0)
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      const int point = face.turned[static_cast<std::size_t>(k)];
      if (point >= 0)
      {
        const double angle =
          std::acos(vtkMath::ClampValue(-vtkMath::Dot(side[k], side[(k + 2) % 3]), -1.0, 1.0));
        Vector& sum = sums[static_cast<std::size_t>(point)];
        for (std::size_t c = 0; c < 3; ++c)
        {
          sum[c] += angle * normal[c];
        }
      }
    }
  }
  for (Vector& sum : sums)
  {
    vtkMath::Normalize(sum.data());
  }
  return sums;
}

void Preview::moveTo(const double by[3])
{
  for (std::size_t i = 0; i < this->Followed->points.size(); ++i)
  {
    double place[3];
    this->Rest->GetPoint(this->Followed->points[i], place);
    const std::array<float, 9>& moves = this->Followed->moves[i];
    for (std::size_t k = 0; k < 3; ++k)
    {
      place[k] += by[0] * moves[k] + by[1] * moves[3 + k] + by[2] * moves[6 + k];
    }
    this->Shown->GetPoints()->SetPoint(this->Followed->points[i], place);
  }
  this->Shown->GetPoints()->Modified();
  if (!this->Turned.empty())
  {
    // The mesh's own normals, of its file perhaps, turned as those of the surface are.
    const std::vector<Vector> now = this->normals();
    vtkDataArray* before = this->Rest->GetPointData()->GetNormals();
    vtkDataArray* shown = this->Shown->GetPointData()->GetNormals();
    for (std::size_t i = 0; i < this->Turned.size(); ++i)
    {
      double normal[3];
      before->GetTuple(this->Turned[i], normal);
      for (std::size_t c = 0; c < 3; ++c)
      {
        normal[c] += now[i][c] - this->Before[i][c];
      }
      vtkMath::Normalize(normal);
      shown->SetTuple(this->Turned[i], normal);
    }
    shown->Modified();
  }
  this->Shown->Modified();
}

} // namespace oversketch_studio
