#include "preview.h"

#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch_studio
{

Preview::Preview(vtkPolyData* rest, const Following& following)
  : Rest(rest)
  , Shown(vtkSmartPointer<vtkPolyData>::New())
  , Followed(following)
{
  copyToMove(rest, this->Shown);
  if (rest->GetPointData()->GetNormals())
  {
    this->Normals.bind(rest, following->points);
  }
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
  if (vtkDataArray* normals = this->Rest->GetPointData()->GetNormals())
  {
    this->Normals.turn(normals, this->Shown);
  }
  this->Shown->Modified();
}

} // namespace oversketch_studio
