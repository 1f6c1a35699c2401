#include "preview.h"

#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

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
    this->findPatch();
    this->Before = this->normals();
  }
}

// Round the points that move and those that share a triangle with one.
void Preview::findPatch()
{
  const auto count = static_cast<std::size_t>(this->Rest->GetNumberOfPoints());
  std::vector<char> moves(count, 0), turns(count, 0);
  for (const vtkIdType point : this->Followed->points)
  {
    moves[static_cast<std::size_t>(point)] = 1;
  }
  std::vector<int> place(count, -1);
  const auto iterator = vtkSmartPointer<vtkCellArrayIterator>::Take(this->Rest->GetPolys()->NewIterator());
  // Those that have a point that is marked.
  const auto eachFace = [&](const std::vector<char>& marked, const auto& visit)
  {
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      iterator->GetCurrentCell(size, ids);
      if (std::any_of(ids, ids + 3, [&](vtkIdType id) { return marked[static_cast<std::size_t>(id)] != 0; }))
      {
        visit(ids);
      }
    }
  };
  eachFace(moves,
    [&](const vtkIdType* ids)
    { std::for_each(ids, ids + 3, [&](vtkIdType id) { turns[static_cast<std::size_t>(id)] = 1; }); });
  eachFace(turns,
    [&](const vtkIdType* ids)
    {
      oversketch::Triangle triangle;
      for (std::size_t k = 0; k < 3; ++k)
      {
        int& at = place[static_cast<std::size_t>(ids[k])];
        if (at < 0)
        {
          at = static_cast<int>(this->Points.size());
          this->Points.push_back(ids[k]);
        }
        triangle[k] = at;
      }
      this->Patch.triangles.push_back(triangle);
    });
  this->Patch.points.resize(this->Points.size());
  this->Around = oversketch::trianglesAround(this->Patch);
}

// Those of its outer points do not change.
std::vector<oversketch::Vector3> Preview::normals()
{
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->Shown->GetPoint(this->Points[i], this->Patch.points[i].data());
  }
  return oversketch::vertexNormals(this->Patch, this->Around, oversketch::ThreadsOnly());
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
  if (!this->Points.empty())
  {
    // The mesh's own normals, of its file perhaps, turned as those of the surface are.
    const std::vector<oversketch::Vector3> now = this->normals();
    vtkDataArray* before = this->Rest->GetPointData()->GetNormals();
    vtkDataArray* shown = this->Shown->GetPointData()->GetNormals();
    for (std::size_t i = 0; i < this->Points.size(); ++i)
    {
      oversketch::Vector3 normal;
      before->GetTuple(this->Points[i], normal.data());
      normal += now[i] - this->Before[i];
      vtkMath::Normalize(normal.data());
      shown->SetTuple(this->Points[i], normal.data());
    }
    shown->Modified();
  }
  this->Shown->Modified();
}

} // namespace oversketch_studio
