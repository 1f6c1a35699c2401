#include "pen_stroke.h"

#include "Stroke/resketch.h"
#include "vtkOversketchFilterTools.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace oversketch
{
namespace
{

template <typename Array, typename Values>
void addArray(vtkFieldData* to, const char* name, int components, const Values& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::transform(values.begin(),
    values.end(),
    array->GetPointer(0),
    [](auto v) { return static_cast<typename Array::ValueType>(v); });
  to->AddArray(array);
}

} // namespace

void PenStroke::add(const Vector2& point, double pressure, double time)
{
  this->points.push_back(point);
  this->pressures.push_back(pressure);
  this->times.push_back(time);
}

void PenStroke::removeLast(double length)
{
  if (this->points.empty())
  {
    return;
  }
  const std::vector<double> lengths = arcLengths(this->points);
  const auto keep = std::min<size_t>(this->points.size() - 1,
    std::lower_bound(lengths.begin(), lengths.end(), lengths.back() - length) - lengths.begin());
  this->points.resize(keep);
  this->pressures.resize(keep);
  this->times.resize(keep);
}

PenStroke PenStroke::resketched(const PenStroke& over) const
{
  const Resketched merged = resketch(this->points, over.points);
  PenStroke result;
  result.view = this->view;
  result.moved = this->moved;
  for (size_t i = 0; i < merged.points.size(); ++i)
  {
    const Origin& origin = merged.origins[i];
    result.add(
      merged.points[i], origin.of(this->pressures, over.pressures), origin.of(this->times, over.times));
  }
  return result;
}

void PenStroke::putInto(vtkPolyData* polyData) const
{
  polyData->Initialize();
  if (this->points.empty())
  {
    return;
  }
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Vector2& p : this->points)
  {
    places->InsertNextPoint(p[0], p[1], 0.0);
  }
  std::vector<vtkIdType> ids(this->points.size());
  std::iota(ids.begin(), ids.end(), 0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(this->count(), ids.data());
  polyData->SetPoints(places);
  polyData->SetLines(lines);
  addArray<vtkFloatArray>(polyData->GetPointData(), "Pressure", 1, this->pressures);
  addArray<vtkDoubleArray>(polyData->GetPointData(), "Time", 1, this->times);
  addArray<vtkDoubleArray>(polyData->GetCellData(), "ViewTransform", 16, this->view.view);
  addArray<vtkDoubleArray>(polyData->GetCellData(), "ProjectionTransform", 16, this->view.projection);
  addArray<vtkIntArray>(polyData->GetCellData(), "ViewportSize", 2, this->view.size);
  if (!this->moved.isZero())
  {
    addArray<vtkDoubleArray>(
      polyData->GetCellData(), "Moved", 2, std::array<double, 2>{ this->moved[0], this->moved[1] });
  }
}

PenStroke PenStroke::of(vtkPolyData* polyData)
{
  PenStroke result;
  result.view = PenView::of(polyData);
  result.points = StrokeOf(polyData);
  result.moved = MovedOf(polyData);
  vtkNew<vtkIdList> ids;
  polyData->GetCellPoints(0, ids);
  vtkDataArray* pressures = polyData->GetPointData()->GetArray("Pressure");
  vtkDataArray* times = polyData->GetPointData()->GetArray("Time");
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    result.pressures.push_back(pressures ? pressures->GetComponent(ids->GetId(i), 0) : 1.0);
    result.times.push_back(times ? times->GetComponent(ids->GetId(i), 0) : 0.0);
  }
  return result;
}

void putInto(vtkPolyData* all, const std::vector<vtkSmartPointer<vtkPolyData>>& strokes)
{
  vtkNew<vtkPolyData> joined;
  if (!strokes.empty())
  {
    vtkNew<vtkAppendPolyData> append;
    append->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
    for (vtkPolyData* stroke : strokes)
    {
      append->AddInputData(stroke);
    }
    append->Update();
    joined->ShallowCopy(append->GetOutput());
  }
  all->ShallowCopy(joined);
  all->Modified();
}

} // namespace oversketch
