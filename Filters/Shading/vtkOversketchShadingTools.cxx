#include "vtkOversketchShadingTools.h"

#include "vtkOversketchEditArrays.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace oversketch
{
namespace
{

const char *const regionName = "EditRegion", *const vertexName = "VertexId",
                  *const enclose = "take the mesh from vtkOversketchEnclose";

} // namespace

InsidePatch InsideOf(vtkPolyData* mesh, bool withRing)
{
  const std::vector<int> within = ReadInside(mesh);
  const auto shared = SharedMesh(mesh);
  const Mesh& whole = shared->Surface();
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
  const auto markAt = [&](const std::vector<char>& vertices)
  {
    mark(
      [&](int t)
      {
        const Triangle& c = whole.triangles[t];
        return vertices[c[0]] != 0 || vertices[c[1]] != 0 || vertices[c[2]] != 0;
      });
  };
  if (mesh->GetCellData()->HasArray(regionName))
  {
    vtkDataArray* cells =
      RequireArray(mesh->GetCellData(), regionName, 1, mesh->GetNumberOfCells(), "mesh's cells", enclose);
    mark([cells](int t) { return cells->GetComponent(t, 0) == 2.0; });
  }
  else
  {
    std::vector<char> strictly = marksAt(within, whole.points.size());
    markAt(strictly);
  }
  if (withRing)
  {
    markAt(used);
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

MeshKey InsideKey(vtkPolyData* mesh)
{
  return MeshKey(mesh,
    { mesh->GetPointData()->GetArray(regionName),
      mesh->GetCellData()->GetArray(regionName),
      mesh->GetPointData()->GetArray(vertexName) });
}

std::vector<Vector2> DiscCoordsOf(vtkPolyData* mesh, const std::vector<char>& labels)
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
          "DiscCoords of vertex %1 are not finite; take the mesh from vtkOversketchFlatten anew.",
          v);
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
      "The %1 image has no samples or several slices; give one of one slice in x and y.",
      which);
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

void DescribeDiscImage(vtkInformation* output, int size, int scalarType)
{
  const int extent[6] = { 0, size - 1, 0, size - 1, 0, 0 };
  const double origin[3] = { 1.0 / size - 1.0, 1.0 / size - 1.0, 0.0 };
  const double spacing[3] = { 2.0 / size, 2.0 / size, 2.0 / size };
  output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  output->Set(vtkDataObject::ORIGIN(), origin, 3);
  output->Set(vtkDataObject::SPACING(), spacing, 3);
  vtkDataObject::SetPointDataActiveScalarInfo(output, scalarType, 1);
}

} // namespace oversketch
