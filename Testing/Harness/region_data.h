// Regions with their arrays and curves as polydata, and regions on models. Header-only.
#ifndef oversketch_testing_harness_region_data_h
#define oversketch_testing_harness_region_data_h

#include "Harness/chains.h"
#include "Harness/regions.h"

namespace oversketch_test
{

inline vtkSmartPointer<vtkDoubleArray> arrayOf(const char* name, const std::vector<double>& values)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// A closed chain by its vertices.
inline std::vector<int> closed(std::vector<int> chain)
{
  chain.push_back(chain.front());
  return chain;
}

// What the filters of a region have made.
struct EditData
{
  EditScene scene;
  vtkSmartPointer<vtkPolyData> mesh, reference, boundary;

  explicit EditData(EditScene made, bool withNormals = true)
    : scene(std::move(made))
    , reference(toChain(this->scene.mesh, this->scene.reference))
    , boundary(toChain(this->scene.mesh, closed(this->scene.boundary)))
  {
    const std::vector<Vector3> normals = vertexNormals(this->scene.mesh);
    this->mesh = toPolyData(this->scene.mesh, withNormals ? &normals : nullptr);
    vtkNew<vtkDoubleArray> faces;
    faces->SetName("Normals");
    faces->SetNumberOfComponents(3);
    for (int t = 0; t < this->scene.mesh.triangleCount(); ++t)
    {
      faces->InsertNextTuple(facetNormal(this->scene.mesh, t).data());
    }
    this->mesh->GetCellData()->SetNormals(faces);
    vtkPointData* data = this->mesh->GetPointData();
    data->AddArray(
      arrayOf("EditRegion", std::vector<double>(this->scene.region.begin(), this->scene.region.end())));
    data->AddArray(arrayOf("CurveDistance", this->scene.distance));
    data->AddArray(arrayOf("CurveParameter", this->scene.parameter));
    data->AddArray(arrayOf("CurveSide", this->scene.side));
    data->AddArray(arrayOf("EditWeight", this->scene.weight));
  }

  // The mesh with one value of an array changed.
  vtkSmartPointer<vtkPolyData> with(const char* name, int vertex, double value) const
  {
    auto changed = vtkSmartPointer<vtkPolyData>::New();
    changed->DeepCopy(this->mesh);
    changed->GetPointData()->GetArray(name)->SetComponent(vertex, 0, value);
    return changed;
  }
  vtkSmartPointer<vtkPolyData> without(const char* name) const
  {
    auto changed = vtkSmartPointer<vtkPolyData>::New();
    changed->DeepCopy(this->mesh);
    changed->GetPointData()->RemoveArray(name);
    return changed;
  }
  int insideVertex() const
  {
    int v = 0;
    while (this->scene.region[v] != 2 || this->scene.weight[v] <= 0.0)
    {
      ++v;
    }
    return v;
  }
};

inline std::vector<Vector3> pointsOf(vtkPolyData* data)
{
  std::vector<Vector3> points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

} // namespace oversketch_test
#endif
