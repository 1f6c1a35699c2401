#include "vtkOversketchCarriedArrays.h"

#include "vtkOversketchHierarchy.h"
#include "vtkOversketchMixable.h"
#include "vtkOversketchRuns.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace oversketch
{

namespace
{

void normaliseTuple(vtkDataArray* values, vtkIdType tuple)
{
  Vector3 n;
  values->GetTuple(tuple, n.data());
  if (n.norm() > 0.0)
  {
    n.normalize();
    values->SetTuple(tuple, n.data());
  }
}

} // namespace

vtkSmartPointer<vtkAbstractArray> LikeArray(vtkAbstractArray* array, std::size_t tuples)
{
  auto result = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  result->CopyComponentNames(array);
  return result;
}

bool IsNamed(vtkAbstractArray* array, const char* name)
{
  return array->GetName() && std::string(array->GetName()) == name;
}

void SetMix(const Mix& mix, vtkIdList* ids, std::vector<double>& weights)
{
  ids->SetNumberOfIds(static_cast<vtkIdType>(mix.size()));
  weights.clear();
  for (const auto& [id, weight] : mix)
  {
    ids->SetId(static_cast<vtkIdType>(weights.size()), id);
    weights.push_back(weight);
  }
}

vtkSmartPointer<vtkAbstractArray> CarriedPoints::Array(vtkAbstractArray* array, bool normals) const
{
  auto carried = LikeArray(array, this->Sources.size());
  const bool labels = IsNamed(array, this->Labels.c_str()), linear = IsMixable(array) && !labels;
  const PointMix& mixed = labels && this->OfLabels ? this->OfLabels : this->Mixed;
  auto* directions = normals ? vtkDataArray::SafeDownCast(carried) : nullptr;
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  EachRun(
    this->Sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [&](vtkIdType point)
    {
      mixed(point, ids, weights);
      if (linear)
      {
        carried->InterpolateTuple(point, ids, array, weights.data());
      }
      else
      {
        const auto nearest = std::max_element(weights.begin(), weights.end()) - weights.begin();
        carried->SetTuple(point, ids->GetId(nearest), array);
      }
      if (directions && directions->GetNumberOfComponents() == 3)
      {
        normaliseTuple(directions, point);
      }
    });
  return carried;
}

vtkSmartPointer<vtkAbstractArray> CarriedCellArray(vtkAbstractArray* array, const std::vector<int>& sources)
{
  auto carried = LikeArray(array, sources.size());
  EachRun(
    sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [](vtkIdType) {});
  return carried;
}

void CarryArrays(vtkDataSetAttributes* from,
  vtkDataSetAttributes* to,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray*, bool normals)>& made)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int attribute = from->IsArrayAnAttribute(i);
    if (attribute == vtkDataSetAttributes::GLOBALIDS)
    {
      continue;
    }
    const int index =
      to->AddArray(made(from->GetAbstractArray(i), attribute == vtkDataSetAttributes::NORMALS));
    if (attribute >= 0)
    {
      to->SetActiveAttribute(index, attribute);
    }
  }
}

void WriteCarried(const Mesh& mesh,
  const CarriedPoints& points,
  const std::vector<int>& triangleSources,
  vtkPolyData* input,
  vtkPolyData* output)
{
  vtkNew<vtkPoints> places;
  places->SetDataType(input->GetPoints()->GetDataType());
  places->SetNumberOfPoints(mesh.vertexCount());
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    places->SetPoint(v, mesh.points[v].data());
  }
  vtkNew<vtkCellArray> triangles;
  triangles->AllocateExact(mesh.triangleCount(), 3 * static_cast<vtkIdType>(mesh.triangleCount()));
  for (const Triangle& t : mesh.triangles)
  {
    triangles->InsertNextCell({ t[0], t[1], t[2] });
  }
  output->SetPoints(places);
  output->SetPolys(triangles);
  CarryArrays(input->GetPointData(),
    output->GetPointData(),
    [&](vtkAbstractArray* array, bool normals) { return points.Array(array, normals); });
  CarryArrays(input->GetCellData(),
    output->GetCellData(),
    [&](vtkAbstractArray* array, bool) { return CarriedCellArray(array, triangleSources); });
  output->GetFieldData()->PassData(input->GetFieldData());
  DropHierarchy(output);
}

} // namespace oversketch
