#include "vtkOversketchDetailTransfer.h"

#include "Ray/detail_transfer.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchMaskArray.h"
#include "vtkOversketchWeld.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

using namespace oversketch;

vtkStandardNewMacro(vtkOversketchDetailTransfer);

namespace
{

// The proxy before its steps.
std::shared_ptr<const Mesh> restOf(vtkPolyData* proxy, const Mesh& now)
{
  vtkDataArray* origin = RequireArray(
    proxy->GetPointData(), "Origin", 3, proxy->GetNumberOfPoints(), "proxy", "vtkOversketchProxy writes it");
  auto rest = std::make_shared<Mesh>(now);
  for (int v = 0; v < rest->vertexCount(); ++v)
  {
    origin->GetTuple(v, rest->points[v].data());
    if (!rest->points[v].allFinite())
    {
      throw Error(Failure::MissingArray,
        "Array Origin of the proxy is not finite at point %1; vtkOversketchProxy writes it.",
        v);
    }
  }
  return rest;
}

} // namespace

void vtkOversketchDetailTransfer::Execute(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkPolyData* input = vtkPolyData::GetData(inputs[0]);
  RequirePolygonsOnly(input);
  const Mesh now = MeshOf(vtkPolyData::GetData(inputs[1]));
  const std::shared_ptr<const Mesh> rest = restOf(vtkPolyData::GetData(inputs[1]), now);
  vtkNew<vtkPolyData> bare; // of attributes that would have to be told apart at seams
  bare->SetPoints(input->GetPoints());
  bare->SetPolys(input->GetPolys());
  const Weld welding(bare);
  const std::vector<Vector3> before = SharedMesh(welding.Welded())->Surface().points;
  std::vector<Vector3> places = transferDetail(rest, now.points, before, ContextOf(this, 0.1, 0.9));
  vtkNew<vtkPolyData> masked;
  masked->ShallowCopy(welding.Welded());
  welding.PutMask(input, masked);
  const std::vector<char> stays = MaskedPointsOf(masked);
  for (std::size_t v = 0; v < stays.size(); ++v)
  {
    places[v] = stays[v] ? before[v] : places[v];
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(places.size()));
  for (std::size_t v = 0; v < places.size(); ++v)
  {
    points->SetPoint(static_cast<vtkIdType>(v), places[v].data());
  }
  vtkNew<vtkPolyData> moved;
  moved->SetPoints(points);
  welding.Move(input, moved, vtkPolyData::GetData(outputs));
}
