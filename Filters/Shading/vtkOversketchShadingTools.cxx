#include "vtkOversketchShadingTools.h"

#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace oversketch
{
namespace
{

const char *const regionName = "EditRegion", *const vertexName = "VertexId",
                  *const enclose = "take the mesh from vtkOversketchEnclose";

} // namespace

std::vector<EditLabel> EditRegionOf(vtkPolyData* mesh)
{
  vtkDataArray* array =
    RequireArray(mesh->GetPointData(), regionName, 1, mesh->GetNumberOfPoints(), "mesh", enclose);
  std::vector<EditLabel> labels(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(v), 0);
    if (value != 0.0 && value != 1.0 && value != 2.0)
    {
      throw Error(Failure::BadRegion,
        "EditRegion of vertex " + std::to_string(v) + " is none: 0 is outside, 1 on the rim, 2 inside.");
    }
    labels[v] = static_cast<EditLabel>(static_cast<signed char>(value));
  }
  return labels;
}

InsidePatch InsideOf(vtkPolyData* mesh, bool withRing)
{
  const std::vector<EditLabel> labels = EditRegionOf(mesh);
  const auto shared = SharedMesh(mesh);
  const Mesh& whole = shared->Surface();
  if (std::find(labels.begin(), labels.end(), EditLabel::Inside) == labels.end())
  {
    throw Error(Failure::BadRegion,
      "No vertex lies strictly inside the boundary; draw it larger, or refine the mesh there.");
  }
  std::vector<char> inside(whole.triangles.size(), 0), used(whole.points.size(), 0);
  const auto mark = [&](const auto& chosen)
  {
    for (int t = 0; t < whole.triangleCount(); ++t)
    {
      inside[t] = chosen(t) ? 1 : 0;
    }
    for (int t = 0; t < whole.triangleCount(); ++t)
    {
      for (int k = 0; inside[t] && k < 3; ++k)
      {
        used[whole.triangles[t][k]] = 1;
      }
    }
  };
  const auto anyCorner = [&](int t, const auto& is)
  {
    const Triangle& c = whole.triangles[t];
    return is(c[0]) || is(c[1]) || is(c[2]);
  };
  if (mesh->GetCellData()->HasArray(regionName))
  {
    vtkDataArray* cells =
      RequireArray(mesh->GetCellData(), regionName, 1, mesh->GetNumberOfCells(), "mesh's cells", enclose);
    mark([cells](int t) { return cells->GetComponent(t, 0) == 2.0; });
  }
  else
  {
    mark([&](int t) { return anyCorner(t, [&](int v) { return labels[v] == EditLabel::Inside; }); });
  }
  if (withRing)
  {
    const std::vector<char> core = used;
    mark([&](int t) { return anyCorner(t, [&](int v) { return core[v] != 0; }); });
  }

  InsidePatch result;
  result.Numbers.assign(whole.points.size(), -1);
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    if (used[v])
    {
      result.Numbers[v] = static_cast<int>(result.Vertices.size());
      result.Vertices.push_back(v);
      result.Patch.points.push_back(whole.points[v]);
    }
  }
  for (int t = 0; t < whole.triangleCount(); ++t)
  {
    if (inside[t])
    {
      const Triangle& c = whole.triangles[t];
      result.Patch.triangles.push_back({ result.Numbers[c[0]], result.Numbers[c[1]], result.Numbers[c[2]] });
    }
  }
  return result;
}

std::vector<int> ChainOf(vtkPolyData* curve, const std::string& which, vtkPolyData* mesh)
{
  const std::string remedy = "lay it into the mesh by vtkOversketchInsertCurve";
  if (curve->GetNumberOfCells() != 1 || curve->GetNumberOfLines() != 1)
  {
    throw Error(Failure::BadStroke,
      "The " + which + " curve is " + std::to_string(curve->GetNumberOfLines()) + " polylines and " +
        std::to_string(curve->GetNumberOfCells() - curve->GetNumberOfLines()) +
        " other cells; exactly one polyline is needed.");
  }
  vtkDataArray* array =
    RequireArray(curve->GetPointData(), vertexName, 1, curve->GetNumberOfPoints(), which + " curve", remedy);
  // Of a patch, its own vertices by those of the mesh that it was taken from.
  std::unordered_map<double, int> own;
  if (vtkDataArray* ids = mesh->GetPointData()->GetArray(vertexName))
  {
    for (vtkIdType v = 0; v < ids->GetNumberOfTuples(); ++v)
    {
      own.emplace(ids->GetComponent(v, 0), static_cast<int>(v));
    }
  }
  const auto vertexOf = [&](double id)
  {
    if (!own.empty())
    {
      const auto found = own.find(id);
      return found == own.end() ? -1 : found->second;
    }
    return id >= 0.0 && id < static_cast<double>(mesh->GetNumberOfPoints()) && id == std::floor(id)
             ? static_cast<int>(id)
             : -1;
  };
  vtkNew<vtkIdList> points;
  curve->GetLines()->GetCellAtId(0, points);
  std::vector<int> chain;
  for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
  {
    const vtkIdType point = points->GetId(i);
    const bool there = point >= 0 && point < curve->GetNumberOfPoints();
    chain.push_back(there ? vertexOf(array->GetComponent(point, 0)) : -1);
    if (chain.back() < 0)
    {
      throw Error(Failure::BadStroke,
        "Point " + std::to_string(i) + " of the " + which + " curve names no vertex of the mesh; " + remedy +
          " anew.");
    }
  }
  if (chain.size() > 1 && chain.front() == chain.back())
  {
    chain.pop_back();
  }
  return chain;
}

MeshKey InsideKey(vtkPolyData* mesh)
{
  return MeshKey(mesh,
    { mesh->GetPointData()->GetArray(regionName),
      mesh->GetCellData()->GetArray(regionName),
      mesh->GetPointData()->GetArray(vertexName) });
}

MeshKey ChainKey(vtkPolyData* curve)
{
  return MeshKey(curve, { curve->GetPointData()->GetArray(vertexName) });
}

std::vector<Vector2> DiscCoordsOf(vtkPolyData* mesh, const std::vector<EditLabel>& labels)
{
  vtkDataArray* array = RequireArray(mesh->GetPointData(),
    "DiscCoords",
    2,
    mesh->GetNumberOfPoints(),
    "mesh",
    "take it from vtkOversketchFlatten");
  std::vector<Vector2> coordinates(labels.size(), Vector2::Zero());
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    if (labels[v] == EditLabel::Inside)
    {
      array->GetTuple(static_cast<vtkIdType>(v), coordinates[v].data());
      if (!coordinates[v].allFinite())
      {
        throw Error(Failure::BadMesh,
          "DiscCoords of vertex " + std::to_string(v) +
            " are not finite; take the mesh from vtkOversketchFlatten anew.");
      }
    }
  }
  return coordinates;
}

MeshKey ArraysKey(const std::vector<vtkDataArray*>& arrays)
{
  vtkNew<vtkPolyData> none;
  return MeshKey(none, arrays);
}

std::pair<int, int> SidesOf(vtkImageData* image, const std::string& which)
{
  int sides[3];
  image->GetDimensions(sides);
  if (image->GetNumberOfPoints() < 1 || sides[2] != 1)
  {
    throw Error(Failure::BadStroke,
      "The " + which + " image has no samples or several slices; give one of one slice in x and y.");
  }
  return { sides[0], sides[1] };
}

void RequestWholeImage(vtkInformationVector* input)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  for (int i = 0; i < input->GetNumberOfInformationObjects(); ++i)
  {
    vtkInformation* information = input->GetInformationObject(i);
    if (information->Has(Pipeline::WHOLE_EXTENT()))
    {
      information->Set(Pipeline::UPDATE_EXTENT(), information->Get(Pipeline::WHOLE_EXTENT()), 6);
    }
  }
}

void LayOnDisc(vtkImageData* image, int size)
{
  image->SetDimensions(size, size, 1);
  image->SetOrigin(1.0 / size - 1.0, 1.0 / size - 1.0, 0.0);
  image->SetSpacing(2.0 / size, 2.0 / size, 2.0 / size);
}

void DescribeDiscImage(vtkInformation* output, int size, int scalarType, int components)
{
  const int extent[6] = { 0, size - 1, 0, size - 1, 0, 0 };
  const double origin[3] = { 1.0 / size - 1.0, 1.0 / size - 1.0, 0.0 };
  const double spacing[3] = { 2.0 / size, 2.0 / size, 2.0 / size };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(output, scalarType, components);
}

} // namespace oversketch
