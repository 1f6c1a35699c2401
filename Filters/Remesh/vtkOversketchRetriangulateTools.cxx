#include "vtkOversketchRetriangulateTools.h"

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchHierarchy.h"
#include "vtkOversketchRuns.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

namespace oversketch
{

namespace
{

bool isNamed(vtkAbstractArray* array, const char* name)
{
  return array->GetName() && std::strcmp(array->GetName(), name) == 0;
}

// What a mixed point has of an array whose numbers are not mixed.
vtkIdType heaviest(const Mix& mix)
{
  return std::max_element(
    mix.begin(), mix.end(), [](const auto& a, const auto& b) { return a.second < b.second; })
    ->first;
}

vtkSmartPointer<vtkAbstractArray> pointArray(vtkAbstractArray* array,
  bool normals,
  const Retriangulated& result)
{
  auto carried = LikeArray(array, result.pointSource.size());
  auto* labels = isNamed(array, "EditRegion") ? vtkDataArray::SafeDownCast(array) : nullptr;
  auto* directions = normals ? vtkDataArray::SafeDownCast(carried) : nullptr;
  const bool real = IsReal(array) && !labels;
  vtkNew<vtkIdList> ids;
  std::vector<double> weights;
  auto mix = result.mixes.begin();
  EachRun(
    result.pointSource,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [&](vtkIdType point)
    {
      if (real)
      {
        ids->Reset();
        weights.clear();
        for (const auto& [id, weight] : *mix)
        {
          ids->InsertNextId(id);
          weights.push_back(weight);
        }
        carried->InterpolateTuple(point, ids, array, weights.data());
      }
      else
      {
        const auto inside = std::find_if(mix->begin(),
          mix->end(),
          [labels](const auto& entry) { return labels && labels->GetComponent(entry.first, 0) == 2.0; });
        carried->SetTuple(point, inside != mix->end() ? inside->first : heaviest(*mix), array);
      }
      if (directions && directions->GetNumberOfComponents() == 3)
      {
        NormaliseTuple(directions, point);
      }
      ++mix;
    });
  return carried;
}

vtkSmartPointer<vtkAbstractArray> cellArray(vtkAbstractArray* array, const Retriangulated& result)
{
  auto carried = LikeArray(array, result.triangleSource.size());
  EachRun(
    result.triangleSource,
    [&](vtkIdType first, vtkIdType count, vtkIdType source)
    { carried->InsertTuples(first, count, source, array); },
    [](vtkIdType) {});
  return carried;
}

void carry(vtkDataSetAttributes* from,
  vtkDataSetAttributes* to,
  const std::function<vtkSmartPointer<vtkAbstractArray>(vtkAbstractArray*, bool normals)>& made)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    const int attribute = from->IsArrayAnAttribute(i);
    if (attribute != vtkDataSetAttributes::GLOBALIDS)
    {
      const int index =
        to->AddArray(made(from->GetAbstractArray(i), attribute == vtkDataSetAttributes::NORMALS));
      if (attribute >= 0)
      {
        to->SetActiveAttribute(index, attribute);
      }
    }
  }
}

} // namespace

double MeanEdgeOf(vtkPolyData* mesh)
{
  vtkDataArray* array = mesh->GetFieldData()->GetArray("MeanEdge");
  const bool whole = array && array->GetNumberOfTuples() == 1 && array->GetNumberOfComponents() == 1;
  const double value = whole ? array->GetComponent(0, 0) : 0.0;
  if (!(value > 0.0) || !std::isfinite(value))
  {
    throw Error(Failure::MissingArray,
      "Field array MeanEdge of the mesh must hold one positive value: pass the mesh through "
      "vtkOversketchMeanEdge when it is loaded.");
  }
  return value;
}

std::vector<char> EditRegionLabels(vtkPolyData* mesh)
{
  vtkDataArray* array = RequireArray(mesh->GetPointData(),
    "EditRegion",
    1,
    mesh->GetNumberOfPoints(),
    "mesh",
    "find the region with vtkOversketchEnclose");
  std::vector<char> labels(static_cast<std::size_t>(mesh->GetNumberOfPoints()));
  for (vtkIdType v = 0; v < mesh->GetNumberOfPoints(); ++v)
  {
    const double label = array->GetComponent(v, 0);
    if (label != 0.0 && label != 1.0 && label != 2.0)
    {
      throw Error(Failure::BadRegion,
        "EditRegion of vertex " + std::to_string(v) +
          " is not 0, 1 or 2: find the region with vtkOversketchEnclose.");
    }
    labels[static_cast<std::size_t>(v)] = static_cast<char>(label);
  }
  return labels;
}

void WriteRetriangulated(const Retriangulated& result, vtkPolyData* mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataType(mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(result.mesh.vertexCount());
  for (int v = 0; v < result.mesh.vertexCount(); ++v)
  {
    points->SetPoint(v, result.mesh.points[v].data());
  }
  vtkNew<vtkCellArray> polys;
  polys->AllocateExact(result.mesh.triangleCount(), 3 * static_cast<vtkIdType>(result.mesh.triangleCount()));
  for (const Triangle& t : result.mesh.triangles)
  {
    polys->InsertNextCell({ t[0], t[1], t[2] });
  }
  output->SetPoints(points);
  output->SetPolys(polys);
  carry(mesh->GetPointData(),
    output->GetPointData(),
    [&](vtkAbstractArray* array, bool normals) { return pointArray(array, normals, result); });
  carry(mesh->GetCellData(),
    output->GetCellData(),
    [&](vtkAbstractArray* array, bool) { return cellArray(array, result); });
  output->GetFieldData()->PassData(mesh->GetFieldData());
  DropHierarchy(output);
}

void WriteChains(const Retriangulated& result,
  std::size_t first,
  const std::vector<Chain>& chains,
  vtkPolyData* curves,
  vtkPolyData* output)
{
  struct Source // of a point: between two of the input's
  {
    vtkIdType a, b;
    double t;
    bool closes; // b is the first of a closed curve
    int vertex;
  };
  std::vector<Source> sources;
  vtkNew<vtkPoints> points;
  points->SetDataType(curves->GetPoints()->GetDataType());
  vtkNew<vtkCellArray> lines;
  for (std::size_t i = 0; i < chains.size(); ++i)
  {
    const std::vector<CurveVertex>& curve = result.curves[first + i];
    const std::vector<vtkIdType>& ids = chains[i].Ids;
    const bool closed = ids.size() > 2 && ids.front() == ids.back();
    const vtkIdType begin = points->GetNumberOfPoints();
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (std::size_t k = 0; k < curve.size(); ++k)
    {
      if (closed && k + 1 == curve.size())
      {
        lines->InsertCellPoint(begin);
        continue;
      }
      const std::size_t from = static_cast<std::size_t>(curve[k].from);
      const std::size_t to = std::min(from + 1, ids.size() - 1);
      sources.push_back({ ids[from], ids[to], curve[k].t, closed && to + 1 == ids.size(), curve[k].vertex });
      lines->InsertCellPoint(points->InsertNextPoint(result.mesh.points[curve[k].vertex].data()));
    }
  }
  output->SetPoints(points);
  output->SetLines(lines);
  const auto made = [&](vtkAbstractArray* array, bool)
  {
    auto carried = LikeArray(array, sources.size());
    auto* numbers = vtkDataArray::SafeDownCast(carried);
    for (std::size_t k = 0; k < sources.size(); ++k)
    {
      const Source& source = sources[k];
      const vtkIdType point = static_cast<vtkIdType>(k);
      if (isNamed(array, "VertexId"))
      {
        numbers->SetComponent(point, 0, source.vertex);
      }
      else if (IsReal(array) && source.t > 0.0)
      {
        carried->InterpolateTuple(point, source.a, array, source.b, array, source.t);
        if (source.closes && isNamed(array, "CurveT"))
        {
          // The curve's first point, 0, is also its end, 1.
          const double before = vtkDataArray::SafeDownCast(array)->GetComponent(source.a, 0);
          numbers->SetComponent(point, 0, before + source.t * (1.0 - before));
        }
      }
      else
      {
        carried->SetTuple(point, source.t < 0.5 ? source.a : source.b, array);
      }
    }
    return carried;
  };
  carry(curves->GetPointData(), output->GetPointData(), made);
  output->GetCellData()->PassData(curves->GetCellData());
  output->GetFieldData()->PassData(curves->GetFieldData());
}

vtkSmartPointer<vtkAbstractArray> LikeArray(vtkAbstractArray* array, std::size_t tuples)
{
  auto result = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
  result->SetName(array->GetName());
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  result->CopyComponentNames(array);
  return result;
}

bool IsReal(vtkAbstractArray* array)
{
  return array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT;
}

void NormaliseTuple(vtkDataArray* values, vtkIdType tuple)
{
  Vector3 n;
  values->GetTuple(tuple, n.data());
  if (n.norm() > 0.0)
  {
    n.normalize();
    values->SetTuple(tuple, n.data());
  }
}

} // namespace oversketch
