#include "pen_stroke.h"

#include "Stroke/resketch.h"
#include "camera_state.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
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

bool alike(const std::array<double, 16>& a, const std::array<double, 16>& b)
{
  constexpr double rounding = 1e-9;
  const auto large = [](double x, double y) { return std::abs(x) < std::abs(y); };
  const double scale = std::abs(*std::max_element(a.begin(), a.end(), large));
  return std::equal(a.begin(),
    a.end(),
    b.begin(),
    [scale](double x, double y) { return std::abs(x - y) <= rounding * scale; });
}

} // namespace

PenView PenView::of(vtkRenderer* renderer)
{
  PenView result;
  const auto camera = unclippedCamera(renderer);
  std::copy_n(camera->GetViewTransformMatrix()->GetData(), 16, result.view.begin());
  std::copy_n(camera->GetProjectionTransformMatrix(renderer->GetTiledAspectRatio(), -1.0, 1.0)->GetData(),
    16,
    result.projection.begin());
  std::copy_n(renderer->GetSize(), 2, result.size.begin());
  return result;
}

View PenView::kernelView() const
{
  using Matrix = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;
  return View(Matrix(this->view.data()), Matrix(this->projection.data()), this->size[0], this->size[1]);
}

bool PenView::operator==(const PenView& other) const
{
  return this->size == other.size && alike(this->view, other.view) &&
         alike(this->projection, other.projection);
}

bool PenView::fromTheSamePlace(const PenView& other) const
{
  return alike(this->view, other.view) && (this->projection[15] == 0.0) == (other.projection[15] == 0.0);
}

void PenView::putInto(vtkRenderer* renderer) const
{
  double toWorld[16];
  vtkMatrix4x4::Invert(this->view.data(), toWorld);
  vtkCamera* camera = renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  const double position[3] = { toWorld[3], toWorld[7], toWorld[11] };
  camera->SetPosition(position);
  camera->SetFocalPoint(position[0] - distance * toWorld[2],
    position[1] - distance * toWorld[6],
    position[2] - distance * toWorld[10]);
  camera->SetViewUp(toWorld[1], toWorld[5], toWorld[9]);
  // The last row of a perspective takes the depth, that of a parallel projection is 0 0 0 1.
  const bool perspective = this->projection[15] == 0.0;
  camera->SetParallelProjection(!perspective);
  if (perspective)
  {
    camera->SetViewAngle(2.0 * vtkMath::DegreesFromRadians(std::atan(1.0 / this->projection[5])));
  }
  else
  {
    camera->SetParallelScale(1.0 / this->projection[5]);
  }
  renderer->ResetCameraClippingRange();
}

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
}

PenStroke PenStroke::of(vtkPolyData* polyData)
{
  PenStroke result;
  const View view = ViewOf(polyData);
  using Matrix = Eigen::Map<Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>;
  Matrix(result.view.view.data()) = view.viewTransform();
  Matrix(result.view.projection.data()) = view.projectionTransform();
  result.view.size = { view.width(), view.height() };
  result.points = StrokeOf(polyData);
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

} // namespace oversketch
