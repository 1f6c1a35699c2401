// Meshes with a region and a reference curve, as vtkOversketchEnclose and vtkOversketchInsertCurve hand them
// on, and the steps of this room over them. Header-only.
#ifndef oversketch_filters_shading_testing_shading_scenes_h
#define oversketch_filters_shading_testing_shading_scenes_h

#include "Harness/chains.h"
#include "Harness/edges.h"
#include "Harness/patches.h"
#include "Harness/promises.h"
#include "vtkOversketchDistanceField.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchScanFill.h"
#include "vtkOversketchShadingLevels.h"
#include "vtkOversketchTextureToWeight.h"

#include "vtkImageData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

namespace oversketch_test
{

struct Scene
{
  Mesh mesh;
  std::vector<char> inside; // per triangle
  std::vector<int> labels;  // EditRegion
  std::vector<int> reference;
};

// The triangles for which `chosen` holds, the ring of triangles round them, and a reference curve.
inline Scene sceneOf(const Mesh& mesh,
  const std::function<bool(const Triangle&)>& chosen,
  const std::vector<int>& reference)
{
  Scene scene{ mesh, {}, std::vector<int>(mesh.points.size(), 0), reference };
  const Adjacency adjacency = buildAdjacency(mesh);
  std::vector<char> core(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    scene.inside.push_back(chosen(t));
    for (int k = 0; scene.inside.back() && k < 3; ++k)
      core[t[k]] = 1;
  }
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& c = mesh.triangles[t];
    if (core[c[0]] || core[c[1]] || core[c[2]])
      for (const int v : c)
        scene.labels[v] = 1;
  }
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    bool within = core[v] && !adjacency.borderVertex[v];
    for (const int* t = adjacency.vertexTriangles.begin(v); t != adjacency.vertexTriangles.end(v); ++t)
      within = within && scene.inside[*t];
    if (within)
      scene.labels[v] = 2;
  }
  return scene;
}

inline Scene sceneOf(const Drawn& drawn)
{
  return sceneOf(
    drawn.patch, [](const Triangle&) { return true; }, drawn.reference);
}

// A sphere, what lies above z = 0.3, a curve over the pole.
inline Scene capScene(int levels = 4)
{
  const Mesh mesh = icosphere(levels);
  return sceneOf(
    mesh,
    [&](const Triangle& t) {
      return std::min({ mesh.points[t[0]][2], mesh.points[t[1]][2], mesh.points[t[2]][2] }) > 0.3;
    },
    edgeWay(mesh, nearestVertex(mesh, { -0.6, 0.0, 0.8 }), nearestVertex(mesh, { 0.6, 0.0, 0.8 })));
}

inline vtkSmartPointer<vtkPolyData> meshOf(const Scene& scene, bool cells = true)
{
  auto mesh = toPolyData(scene.mesh);
  vtkNew<vtkUnsignedCharArray> points, faces;
  points->SetName("EditRegion");
  for (const int label : scene.labels)
    points->InsertNextValue(static_cast<unsigned char>(label));
  mesh->GetPointData()->AddArray(points);
  faces->SetName("EditRegion");
  for (const char inside : scene.inside)
    faces->InsertNextValue(inside ? 2 : 0);
  if (cells)
    mesh->GetCellData()->AddArray(faces);
  return mesh;
}

// Areas drawn on the disc itself.
inline vtkSmartPointer<vtkPolyData> areasOnDisc(const std::vector<std::vector<Vector2>>& outlines)
{
  auto areas = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const std::vector<Vector2>& outline : outlines)
  {
    lines->InsertNextCell(static_cast<int>(outline.size()));
    for (const Vector2& p : outline)
      lines->InsertCellPoint(points->InsertNextPoint(p[0], p[1], 0.0));
  }
  areas->SetPoints(points);
  areas->SetLines(lines);
  return areas;
}

inline std::vector<double> pointValues(vtkDataSet* data, const char* name)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
    values.push_back(array->GetComponent(
      i / array->GetNumberOfComponents(), static_cast<int>(i % array->GetNumberOfComponents())));
  return values;
}

inline bool sameBits(vtkDataArray* a, vtkDataArray* b)
{
  return a && b && a->GetDataType() == b->GetDataType() && a->GetNumberOfValues() == b->GetNumberOfValues() &&
         std::memcmp(a->GetVoidPointer(0),
           b->GetVoidPointer(0),
           static_cast<std::size_t>(a->GetNumberOfValues()) * a->GetDataTypeSize()) == 0;
}

// The steps one after the other; areas may be set.
struct ShadingChain
{
  Scene scene;
  vtkSmartPointer<vtkPolyData> mesh, reference;
  vtkNew<vtkOversketchFlatten> flatten;
  vtkNew<vtkOversketchDistanceField> field;
  vtkNew<vtkOversketchScanFill> fill;
  vtkNew<vtkOversketchShadingLevels> levels;

  explicit ShadingChain(const Scene& from)
    : scene(from)
    , mesh(meshOf(from))
    , reference(toChain(from.mesh, from.reference))
  {
    this->flatten->SetInputData(this->mesh);
    this->flatten->SetReferenceData(this->reference);
    this->field->SetInputConnection(this->flatten->GetOutputPort());
    this->field->SetReferenceData(this->reference);
    this->levels->SetInputConnection(this->field->GetOutputPort());
    this->levels->SetDiscConnection(this->flatten->GetOutputPort(1));
  }
  void select(const std::vector<std::vector<Vector2>>& outlines)
  {
    this->fill->SetInputData(areasOnDisc(outlines));
    this->levels->SetAreasConnection(this->fill->GetOutputPort(1));
  }
  std::vector<double> weights()
  {
    this->levels->Update();
    return pointValues(this->levels->GetOutput(), "EditWeight");
  }
  std::vector<double> greys()
  {
    this->levels->Update();
    return pointValues(this->levels->GetDisplayOutput(), "Grey");
  }
};

} // namespace oversketch_test
#endif
