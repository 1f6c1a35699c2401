#include "vtkOversketchSources.h"

#include "Ray/surface_rays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <map>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace oversketch
{

namespace
{

// One chart of a mesh as a surface of its own.
class ChartSurface
{
public:
  ChartSurface(const Mesh& mesh, const std::vector<int>& triangles, const Context& context)
    : Triangles(triangles)
  {
    auto part = std::make_shared<Mesh>();
    std::unordered_map<int, int> number;
    for (const int t : triangles)
    {
      Triangle corners;
      for (int k = 0; k < 3; ++k)
      {
        const int v = mesh.triangles[t][k];
        const auto [known, isNew] = number.emplace(v, part->vertexCount());
        if (isNew)
        {
          part->points.push_back(mesh.points[v]);
        }
        corners[k] = known->second;
      }
      part->triangles.push_back(corners);
    }
    this->Rays = std::make_unique<SurfaceRays>(part, context);
  }

  SurfacePoint Closest(const Vector3& place) const
  {
    SurfacePoint at = this->Rays->closest(place).at;
    if (at.triangle < 0) // only where no triangle has an area
    {
      at.triangle = 0;
    }
    at.triangle = this->Triangles[at.triangle];
    return at;
  }

private:
  std::vector<int> Triangles;
  std::unique_ptr<SurfaceRays> Rays;
};

class SourceOnCharts
{
public:
  SourceOnCharts(const Mesh& mesh, vtkDataArray* chart, const Context& context)
    : Surface(mesh)
    , Work(context)
    , Of(static_cast<std::size_t>(mesh.triangleCount()), 0)
  {
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      this->Of[t] = chart ? static_cast<int>(chart->GetComponent(t, 0)) : 0;
      this->Triangles[this->Of[t]].push_back(t);
    }
  }

  // Where a vertex of the changed mesh lies, seen from a cell that was made of the triangle.
  SurfacePoint Source(int vertex, const Vector3& place, int triangle)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (this->Surface.points[this->Surface.triangles[triangle][k]] == place)
      {
        SurfacePoint corner{ triangle, { 0.0, 0.0, 0.0 } };
        corner.weights[k] = 1.0;
        return corner;
      }
    }
    const int chart = this->Of[triangle];
    const auto [found, isNew] = this->Known.emplace(std::make_pair(vertex, chart), SurfacePoint());
    if (isNew)
    {
      std::unique_ptr<ChartSurface>& surface = this->Surfaces[chart];
      if (!surface)
      {
        surface = std::make_unique<ChartSurface>(this->Surface, this->Triangles[chart], this->Work);
      }
      found->second = surface->Closest(place);
    }
    return found->second;
  }

private:
  const Mesh& Surface;
  const Context& Work;
  std::vector<int> Of; // per triangle
  std::map<int, std::vector<int>> Triangles;
  std::map<int, std::unique_ptr<ChartSurface>> Surfaces;
  std::map<std::pair<int, int>, SurfacePoint> Known; // by vertex and chart, so that all its cells agree
};

// The array itself where it is of that type.
template <typename Array>
vtkSmartPointer<Array> As(vtkDataArray* array)
{
  vtkSmartPointer<Array> typed = Array::SafeDownCast(array);
  if (!typed)
  {
    typed = vtkSmartPointer<Array>::New();
    typed->DeepCopy(array);
  }
  return typed;
}

} // namespace

Sources::Sources(vtkPolyData* changed)
{
  const char* const remedy = "vtkOversketchRemesh writes it";
  vtkIdType cells = changed->GetNumberOfPolys();
  vtkSmartPointer<vtkDataSetAttributes> from = changed->GetCellData();
  if (!from->HasArray("SourceCell"))
  {
    this->Unchanged = vtkIntArray::SafeDownCast(changed->GetFieldData()->GetArray("UnchangedCell"));
  }
  if (this->Unchanged)
  {
    from = vtkSmartPointer<vtkDataSetAttributes>::New();
    from->AddArray(changed->GetFieldData()->GetAbstractArray("SourceCell"));
    from->AddArray(changed->GetFieldData()->GetAbstractArray("SourceWeights"));
    this->UnchangedCount = this->Unchanged->GetNumberOfTuples();
    cells -= this->UnchangedCount;
  }
  this->Cells = As<vtkIdTypeArray>(RequireArray(from, "SourceCell", 3, cells, "remeshed mesh", remedy));
  this->Weights = As<vtkDoubleArray>(RequireArray(from, "SourceWeights", 9, cells, "remeshed mesh", remedy));
}

void AddPlaces(vtkPolyData* welded)
{
  const auto places = NewArray<vtkDoubleArray>("Place", 3, welded->GetNumberOfPoints());
  for (vtkIdType i = 0; i < welded->GetNumberOfPoints(); ++i)
  {
    double p[3];
    welded->GetPoint(i, p);
    places->SetTypedTuple(i, p);
  }
  welded->GetPointData()->AddArray(places);
}

void AddSources(vtkPolyData* welded, vtkPolyData* changed, const Context& context)
{
  const std::shared_ptr<const MeshData> data = SharedMesh(welded);
  const Mesh& mesh = data->Surface();
  SourceOnCharts onCharts(mesh, welded->GetCellData()->GetArray("Chart"), context);
  const vtkIdType count = changed->GetNumberOfPolys();
  const char* const remedy = "the steps carry it";
  vtkDataArray* places =
    RequireArray(changed->GetPointData(), "Place", 3, changed->GetNumberOfPoints(), "changed mesh", remedy);
  vtkDataArray* cells =
    RequireArray(changed->GetCellData(), "OriginalCell", 1, count, "changed mesh", remedy);
  vtkNew<vtkIdList> ids;
  const auto sources = NewArray<vtkIdTypeArray>("SourceCell", 3, count);
  const auto weights = NewArray<vtkDoubleArray>("SourceWeights", 9, count);
  for (vtkIdType f = 0; f < count; ++f)
  {
    if (f % 4096 == 0)
    {
      context.checkpoint(static_cast<double>(f) / static_cast<double>(count));
    }
    changed->GetPolys()->GetCellAtId(f, ids);
    const int triangle = static_cast<int>(cells->GetComponent(f, 0));
    for (int k = 0; k < 3; ++k)
    {
      Vector3 place;
      places->GetTuple(ids->GetId(k), place.data());
      const SurfacePoint at = onCharts.Source(static_cast<int>(ids->GetId(k)), place, triangle);
      sources->SetTypedComponent(f, k, at.triangle);
      for (int j = 0; j < 3; ++j)
      {
        weights->SetTypedComponent(f, 3 * k + j, at.weights[j]);
      }
    }
  }
  changed->GetCellData()->AddArray(sources);
  changed->GetCellData()->AddArray(weights);
}

} // namespace oversketch
