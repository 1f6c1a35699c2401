#include "vtkOversketchEditArrays.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <functional>
#include <unordered_map>

namespace oversketch
{

namespace
{

const char* const vertexName = "VertexId";
const char* const chainRemedy = "lay the curve into the mesh with vtkOversketchInsertCurve";

// The vertex by a value of VertexId, -1 where there is none.
using VertexOf = std::function<int(double value)>;

VertexOf vertexBelow(vtkIdType count)
{
  return [count](double value)
  {
    const bool there = value >= 0.0 && value < static_cast<double>(count) && value == std::floor(value);
    return there ? static_cast<int>(value) : -1;
  };
}

std::vector<Chain> readChains(vtkPolyData* curves, const VertexOf& vertexOf, const std::string& holder)
{
  const vtkIdType count = curves->GetNumberOfLines(), points = curves->GetNumberOfPoints();
  if (count == 0 || count != curves->GetNumberOfCells())
  {
    throw Error(
      Failure::BadStroke, "The " + holder + " must be polylines and no other cells: " + chainRemedy + ".");
  }
  vtkDataArray* vertices = RequireArray(curves->GetPointData(), vertexName, 1, points, holder, chainRemedy);
  std::vector<Chain> chains(static_cast<std::size_t>(count));
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    Chain& chain = chains[static_cast<std::size_t>(cell)];
    curves->GetLines()->GetCellAtId(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const vtkIdType id = ids->GetId(i);
      const int vertex = id >= 0 && id < points ? vertexOf(vertices->GetComponent(id, 0)) : -1;
      if (vertex < 0)
      {
        throw Error(Failure::BadStroke,
          "Point %1 of the %2 is no vertex of the mesh (array VertexId): %3.",
          i,
          holder,
          chainRemedy);
      }
      chain.Vertices.push_back(vertex);
      chain.Ids.push_back(id);
    }
  }
  return chains;
}

Chain readChain(vtkPolyData* curve, const VertexOf& vertexOf, const std::string& holder)
{
  if (curve->GetNumberOfLines() > 1)
  {
    throw Error(Failure::BadStroke,
      "There are %1 polylines where the %2 is one: give that one.",
      curve->GetNumberOfLines(),
      holder);
  }
  return readChains(curve, vertexOf, holder).front();
}

} // namespace

std::vector<Chain> ReadChains(vtkPolyData* curves, int vertexCount, const std::string& holder)
{
  return readChains(curves, vertexBelow(vertexCount), holder);
}

Chain ReadChain(vtkPolyData* curve, int vertexCount, const std::string& holder)
{
  return readChain(curve, vertexBelow(vertexCount), holder);
}

Chain ReadChain(vtkPolyData* curve, vtkPolyData* mesh, const std::string& holder)
{
  vtkDataArray* ids = mesh->GetPointData()->GetArray(vertexName);
  if (!ids)
  {
    return readChain(curve, vertexBelow(mesh->GetNumberOfPoints()), holder);
  }
  std::unordered_map<double, int> own;
  for (vtkIdType v = 0; v < ids->GetNumberOfTuples(); ++v)
  {
    own.emplace(ids->GetComponent(v, 0), static_cast<int>(v));
  }
  const auto vertexOf = [&own](double value)
  {
    const auto found = own.find(value);
    return found == own.end() ? -1 : found->second;
  };
  return readChain(curve, vertexOf, holder);
}

std::vector<int> VerticesOnce(Chain chain)
{
  std::vector<int>& vertices = chain.Vertices;
  if (vertices.size() > 2 && vertices.front() == vertices.back())
  {
    vertices.pop_back();
  }
  return std::move(vertices);
}

MeshKey ChainsKey(vtkPolyData* curves)
{
  return MeshKey(curves, { curves->GetPointData()->GetArray(vertexName) });
}

std::vector<char> ReadEditRegion(vtkPolyData* mesh)
{
  const std::string remedy = "find the region with vtkOversketchEnclose";
  const vtkIdType count = mesh->GetNumberOfPoints();
  vtkDataArray* array = RequireArray(mesh->GetPointData(), "EditRegion", 1, count, "mesh", remedy);
  std::vector<char> labels;
  labels.reserve(static_cast<std::size_t>(count));
  for (vtkIdType v = 0; v < count; ++v)
  {
    const double label = array->GetComponent(v, 0);
    if (label != EditLabel::Outside && label != EditLabel::Rim && label != EditLabel::Inside)
    {
      throw Error(Failure::BadRegion,
        "EditRegion of vertex %1 is not 0 (outside), 1 (on the rim) or 2 (inside): %2.",
        v,
        remedy);
    }
    labels.push_back(static_cast<char>(label));
  }
  return labels;
}

std::vector<int> ReadInside(vtkPolyData* mesh)
{
  const std::vector<char> labels = ReadEditRegion(mesh);
  std::vector<int> inside;
  for (std::size_t v = 0; v < labels.size(); ++v)
  {
    if (labels[v] == EditLabel::Inside)
    {
      inside.push_back(static_cast<int>(v));
    }
  }
  if (inside.empty())
  {
    throw Error(Failure::BadRegion,
      "No vertex lies strictly inside {the boundary}; draw it larger, or refine the mesh there.");
  }
  return inside;
}

} // namespace oversketch
