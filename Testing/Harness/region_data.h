// Regions with their arrays and curves as polydata, and regions on models. Header-only.
#ifndef oversketch_test_region_data_h
#define oversketch_test_region_data_h

#include "Harness/polydata.h"
#include "Harness/regions.h"

#include "vtkIdTypeArray.h"

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

inline vtkSmartPointer<vtkPolyData> toCurve(const Mesh& mesh, const std::vector<int>& chain, bool closed)
{
  auto curve = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIdTypeArray> vertices;
  vertices->SetName("VertexId");
  lines->InsertNextCell(static_cast<int>(chain.size()) + (closed ? 1 : 0));
  for (const int v : chain)
  {
    lines->InsertCellPoint(points->InsertNextPoint(mesh.points[v].data()));
    vertices->InsertNextValue(v);
  }
  if (closed)
  {
    lines->InsertCellPoint(0);
  }
  curve->SetPoints(points);
  curve->SetLines(lines);
  curve->GetPointData()->AddArray(vertices);
  return curve;
}

// What the filters of a region have made.
struct EditData
{
  EditScene scene;
  vtkSmartPointer<vtkPolyData> mesh, reference, boundary;

  explicit EditData(EditScene made, bool withNormals = true)
    : scene(std::move(made))
    , reference(toCurve(this->scene.mesh, this->scene.reference, false))
    , boundary(toCurve(this->scene.mesh, this->scene.boundary, true))
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

// A mesh's shortest path along its edges between the vertices nearest to two places, and the region within so
// far of it.
inline EditScene pathScene(const Mesh& mesh, const Vector3& from, const Vector3& to, double reach)
{
  const auto nearest = [&](const Vector3& place)
  {
    int best = 0;
    for (int v = 1; v < mesh.vertexCount(); ++v)
    {
      best = (mesh.points[v] - place).norm() < (mesh.points[best] - place).norm() ? v : best;
    }
    return best;
  };
  const Adjacency links = buildAdjacency(mesh);
  const int end = nearest(to);
  const std::vector<double> left = edgeDistances(mesh, links, { end });
  std::vector<int> chain{ nearest(from) };
  while (chain.back() != end)
  {
    const int v = chain.back();
    const auto further = [&](int a, int b)
    {
      return left[a] + (mesh.points[a] - mesh.points[v]).norm() <
             left[b] + (mesh.points[b] - mesh.points[v]).norm();
    };
    chain.push_back(*std::min_element(links.vertexVertices.begin(v), links.vertexVertices.end(v), further));
  }
  const std::vector<double> distance = edgeDistances(mesh, links, chain, reach);
  std::vector<char> inside;
  for (const double d : distance)
  {
    inside.push_back(d <= reach ? 1 : 0);
  }
  return editScene(mesh, inside, chain);
}

} // namespace oversketch_test
#endif
