#include "vtkOversketchCarriedArrays.h"

#include "Mesh/mesh.h"
#include "vtkOversketchRuns.h"

#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstring>

namespace oversketch
{

namespace
{

vtkSmartPointer<vtkAbstractArray> likeArray(vtkAbstractArray* array, std::size_t tuples)
{
  auto result = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  result->CopyComponentNames(array);
  return result;
}

// Whether new points take a mix, or what the nearest point has.
bool mixes(vtkAbstractArray* array)
{
  const bool real = array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
  return real && !(array->GetName() && std::strcmp(array->GetName(), "Region") == 0);
}

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

vtkSmartPointer<vtkAbstractArray> CarriedPointArray(vtkAbstractArray* array,
  bool normals,
  const std::vector<int>& sources,
  const PointMix& mix)
{
  auto carried = likeArray(array, sources.size());
  const bool linear = mixes(array);
  auto* directions = normals ? vtkDataArray::SafeDownCast(carried) : nullptr;
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  EachRun(
    sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [&](vtkIdType point)
    {
      mix(point, ids, weights);
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
  auto carried = likeArray(array, sources.size());
  EachRun(
    sources,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [](vtkIdType) {});
  return carried;
}

} // namespace oversketch
