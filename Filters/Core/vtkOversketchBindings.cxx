#include "vtkOversketchBindings.h"

#include "vtkOversketchFilterTools.h"

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

const char* const verticesName = "MeshVertices";
const char* const weightsName = "MeshWeights";

} // namespace

std::vector<Binding> ReadBindings(vtkPolyData* points,
  int vertexCount,
  const std::string& holder,
  const std::string& remedy,
  Unbound unbound)
{
  const vtkIdType count = points->GetNumberOfPoints();
  std::vector<Binding> bindings(static_cast<std::size_t>(count));
  if (count == 0)
  {
    return bindings;
  }
  vtkPointData* data = points->GetPointData();
  vtkDataArray* vertices = RequireArray(data, verticesName, 3, count, holder, remedy);
  vtkDataArray* weights = RequireArray(data, weightsName, 3, count, holder, remedy);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const auto refuse = [&](const char* problem)
    { throw Error(Failure::BadMesh, "Point %1 of the %2 %3: %4.", i, holder, problem, remedy); };
    Binding& binding = bindings[static_cast<std::size_t>(i)];
    weights->GetTuple(i, binding.weights.data());
    for (int k = 0; k < 3; ++k)
    {
      const double v = vertices->GetComponent(i, k);
      if (!(v >= -1.0 && v < vertexCount))
      {
        refuse("names a vertex that the mesh does not have (array MeshVertices)");
      }
      binding.vertices[k] = static_cast<int>(v);
    }
    const auto& v = binding.vertices;
    const auto& w = binding.weights;
    if (unbound == Unbound::Allowed && v[0] == -1 && v[1] == -1 && v[2] == -1)
    {
      continue;
    }
    if (*std::min_element(v.begin(), v.end()) < 0 || !(std::abs(w[0] + w[1] + w[2] - 1.0) < 1e-6))
    {
      refuse("hangs on no vertex of the mesh or has weights that do not sum to 1 (arrays MeshVertices and "
             "MeshWeights)");
    }
  }
  return bindings;
}

void WriteBindings(const std::vector<Binding>& bindings, vtkPolyData* points)
{
  const auto vertices = NewArray<vtkIdTypeArray>(verticesName);
  const auto weights = NewArray<vtkDoubleArray>(weightsName);
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(vertices.Get()), static_cast<vtkDataArray*>(weights.Get()) })
  {
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(bindings.size()));
    points->GetPointData()->AddArray(array);
  }
  vtkIdType* vertex = vertices->GetPointer(0);
  double* weight = weights->GetPointer(0);
  for (const Binding& binding : bindings)
  {
    vertex = std::copy_n(binding.vertices.data(), 3, vertex);
    weight = std::copy_n(binding.weights.data(), 3, weight);
  }
}

} // namespace oversketch
