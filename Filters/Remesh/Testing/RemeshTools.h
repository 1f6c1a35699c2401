// What the tests of vtkOversketchRemesh share: inputs with a region, handles, runs and their contents.
#ifndef oversketch_filters_remesh_testing_remesh_tools_h
#define oversketch_filters_remesh_testing_remesh_tools_h

#include "Harness/promises.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRemesh.h"

#include "vtkIdTypeArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace oversketch_test
{

using namespace oversketch;
using Inside = std::function<bool(const Vector3&)>;

inline vtkSmartPointer<vtkDoubleArray> doubles(const char* name,
  const std::vector<double>& values,
  int components = 1)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (const double value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

// The mesh with its Region and a ShapeDiameter that limits nothing, unless told.
inline vtkSmartPointer<vtkPolyData> withRegion(const Mesh& mesh, const Inside& inside, double diameter = 1e9)
{
  auto input = toPolyData(mesh);
  vtkNew<vtkUnsignedCharArray> region;
  region->SetName("Region");
  for (const Vector3& p : mesh.points)
  {
    region->InsertNextValue(inside(p) ? 1 : 0);
  }
  input->GetPointData()->AddArray(region);
  input->GetPointData()->AddArray(
    doubles("ShapeDiameter", std::vector<double>(mesh.points.size(), diameter)));
  return input;
}

// Handles on the region's edges that cross the plane x = 0.013 at y > 0, with k = section / target.
inline vtkSmartPointer<vtkPolyData> handlesOn(vtkPolyData* input, double section, double target)
{
  const Mesh mesh = MeshOf(input);
  const Adjacency adjacency = buildAdjacency(mesh);
  auto handles = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> verts;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("MeshVertices");
  vertices->SetNumberOfComponents(3);
  std::vector<double> weights, targets;
  vtkDataArray* region = input->GetPointData()->GetArray("Region");
  for (const MeshEdge& e : adjacency.edges)
  {
    const Vector3 &a = mesh.points[e.v0], &b = mesh.points[e.v1];
    if ((a[0] - 0.013) * (b[0] - 0.013) >= 0.0 || a[1] + b[1] < 0.0 || region->GetComponent(e.v0, 0) == 0.0 ||
        region->GetComponent(e.v1, 0) == 0.0)
    {
      continue;
    }
    const double alpha = (b[0] - 0.013) / (b[0] - a[0]);
    const Vector3 p = alpha * a + (1.0 - alpha) * b;
    const vtkIdType id = points->InsertNextPoint(p.data());
    verts->InsertNextCell(1, &id);
    for (const int v : { e.v0, e.v1, e.v0 })
    {
      vertices->InsertNextValue(v);
    }
    weights.insert(weights.end(), { alpha, 1.0 - alpha, 0.0 });
    targets.insert(targets.end(), { p[0], p[1] + 1.0, p[2] });
  }
  handles->SetPoints(points);
  handles->SetVerts(verts);
  handles->GetPointData()->AddArray(vertices);
  handles->GetPointData()->AddArray(doubles("MeshWeights", weights, 3));
  handles->GetPointData()->AddArray(doubles("Target", targets, 3));
  handles->GetFieldData()->AddArray(doubles("SectionLength", { section }));
  handles->GetFieldData()->AddArray(doubles("TargetLength", { target }));
  return handles;
}

struct Remeshed
{
  vtkNew<vtkOversketchRemesh> filter;
  Remeshed(vtkPolyData* input, int stage, vtkPolyData* handles = nullptr)
  {
    this->filter->SetInputData(input);
    this->filter->SetStage(stage);
    if (handles)
    {
      this->filter->SetHandlesData(handles);
    }
  }
  vtkSmartPointer<vtkPolyData> run()
  {
    this->filter->Update();
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->DeepCopy(this->filter->GetOutput());
    return result;
  }
};

inline void expectOutsideUntouched(vtkPolyData* input, vtkPolyData* output)
{
  vtkDataArray* region = input->GetPointData()->GetArray("Region");
  vtkIdType next = 0;
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    if (region->GetComponent(i, 0) == 0.0)
    {
      for (int k = 0; k < 3; ++k)
      {
        ASSERT_EQ(input->GetPoint(i)[k], output->GetPoint(next)[k]) << "point " << i;
      }
      ASSERT_EQ(output->GetPointData()->GetArray("Region")->GetComponent(next, 0), 0.0);
      ++next;
    }
  }
  for (; next < output->GetNumberOfPoints(); ++next)
  {
    ASSERT_EQ(output->GetPointData()->GetArray("Region")->GetComponent(next, 0), 1.0);
  }
}

// Everything the filter gives, for comparison bit by bit.
inline std::vector<double> contentOf(vtkPolyData* data)
{
  std::vector<double> content;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    content.insert(content.end(), data->GetPoint(i), data->GetPoint(i) + 3);
  }
  for (const Triangle& t : MeshOf(data).triangles)
  {
    content.insert(content.end(), t.begin(), t.end());
  }
  for (vtkDataSetAttributes* attributes : { static_cast<vtkDataSetAttributes*>(data->GetPointData()),
         static_cast<vtkDataSetAttributes*>(data->GetCellData()) })
  {
    for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      for (vtkIdType k = 0; k < array->GetNumberOfTuples() * array->GetNumberOfComponents(); ++k)
      {
        content.push_back(array->GetVariantValue(k).ToDouble());
      }
    }
  }
  return content;
}

inline const Inside upperHalf = [](const Vector3& p) { return p[2] > -0.05; };

} // namespace oversketch_test
#endif
