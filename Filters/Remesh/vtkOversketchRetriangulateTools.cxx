#include "vtkOversketchRetriangulateTools.h"

#include "vtkOversketchCarriedArrays.h"
#include "vtkOversketchEditRegion.h"

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

namespace oversketch
{

namespace
{

const char* const regionName = "EditRegion";

} // namespace

void WriteRetriangulated(const Retriangulated& result, vtkPolyData* mesh, vtkPolyData* output)
{
  std::vector<std::size_t> numbers(result.pointSource.size(), 0); // of the mixes
  std::size_t count = 0;
  for (std::size_t v = 0; v < numbers.size(); ++v)
  {
    numbers[v] = count;
    count += result.pointSource[v] < 0;
  }
  const auto mixOf = [&](vtkIdType point) -> const Mix&
  { return result.mixes[numbers[static_cast<std::size_t>(point)]]; };
  vtkDataArray* labels = mesh->GetPointData()->GetArray(regionName);
  const auto inside = [&](vtkIdType point)
  {
    const Mix& mix = mixOf(point);
    const auto found = std::find_if(mix.begin(),
      mix.end(),
      [labels](const auto& entry) { return labels->GetComponent(entry.first, 0) == EditLabel::Inside; });
    return found != mix.end() ? Mix{ *found } : mix;
  };
  WriteCarried(
    result.mesh, { result.pointSource, mixOf, regionName, inside }, result.triangleSource, mesh, output);
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
      if (IsNamed(array, "VertexId"))
      {
        numbers->SetComponent(point, 0, source.vertex);
      }
      else if (IsMixable(array) && source.t > 0.0)
      {
        carried->InterpolateTuple(point, source.a, array, source.b, array, source.t);
        if (source.closes && IsNamed(array, "CurveT"))
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
  CarryArrays(curves->GetPointData(), output->GetPointData(), made);
  output->GetCellData()->PassData(curves->GetCellData());
  output->GetFieldData()->PassData(curves->GetFieldData());
}

} // namespace oversketch
