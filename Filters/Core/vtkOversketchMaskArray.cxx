#include "vtkOversketchMaskArray.h"

#include "vtkOversketchFilterTools.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

std::vector<double> MaskOf(vtkPolyData* mesh)
{
  constexpr double whole = 1.0 - 1e-6;
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* array = OptionalArray(mesh->GetPointData(),
    maskName,
    1,
    count,
    "mesh",
    "vtkOversketchMask makes one number a point, from 0 to 1; take the array away where it means another "
    "thing");
  std::vector<double> mask(array ? static_cast<std::size_t>(count) : 0);
  bool any = false;
  for (std::size_t i = 0; i < mask.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!std::isfinite(value))
    {
      throw Error(Failure::MissingArray,
        "Array Mask of the mesh is not finite at point %1: give it numbers from 0, free, to 1, masked.",
        i);
    }
    mask[i] = value >= whole ? 1.0 : std::max(0.0, value);
    any = any || mask[i] > 0.0;
  }
  return any ? mask : std::vector<double>();
}

std::vector<char> MaskedPointsOf(vtkPolyData* mesh)
{
  const std::vector<double> mask = MaskOf(mesh);
  std::vector<char> masked(mask.size());
  std::transform(mask.begin(), mask.end(), masked.begin(), [](double m) { return m >= 1.0 ? 1 : 0; });
  return std::find(masked.begin(), masked.end(), 1) == masked.end() ? std::vector<char>() : masked;
}

MeshKey MaskKey(vtkPolyData* mesh)
{
  return MeshKey(mesh, { mesh->GetPointData()->GetArray(maskName) });
}

void PutMask(const std::vector<double>& mask, vtkPolyData* mesh)
{
  mesh->GetPointData()->RemoveArray(maskName);
  if (!mask.empty())
  {
    mesh->GetPointData()->AddArray(ArrayOf<vtkFloatArray>(maskName, mask));
  }
}

} // namespace oversketch
