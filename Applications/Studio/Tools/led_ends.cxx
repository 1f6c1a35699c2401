#include "led_ends.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <Eigen/Core>

#include <algorithm>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr double share = 0.15; // of the line's length
constexpr double least = 0.5;  // px that an end misses its place by

using Place = Eigen::Vector2d;

// Moves points, from the first one on, by an offset that fades along them.
template <typename Iterator>
void lead(Iterator begin, Iterator end, const Place& offset, double length)
{
  const std::vector<Place> drawn(begin, end);
  double from = 0.0;
  for (std::size_t i = 0; i < drawn.size() && from < length; ++i)
  {
    const double t = from / length;
    *(begin + static_cast<std::ptrdiff_t>(i)) += (1.0 - t) * (1.0 - t) * (1.0 + 2.0 * t) * offset;
    from += i + 1 < drawn.size() ? (drawn[i + 1] - drawn[i]).norm() : 0.0;
  }
}

} // namespace

vtkSmartPointer<vtkPolyData> withLedEnds(vtkPolyData* stroke, vtkPolyData* section, double reach)
{
  vtkDataArray* places = section->GetPointData()->GetArray("Display");
  if (!places || places->GetNumberOfTuples() < 2 || stroke->GetNumberOfPoints() < 2)
  {
    return stroke;
  }
  std::vector<Place> points;
  double length = 0.0;
  for (vtkIdType i = 0; i < stroke->GetNumberOfPoints(); ++i)
  {
    const double* at = stroke->GetPoint(i);
    points.emplace_back(at[0], at[1]);
    length += i > 0 ? (points[points.size() - 1] - points[points.size() - 2]).norm() : 0.0;
  }
  const auto offset = [&](vtkIdType place, const Place& end)
  { return Place(Place(places->GetComponent(place, 0), places->GetComponent(place, 1)) - end); };
  const Place first = offset(0, points.front()),
              last = offset(places->GetNumberOfTuples() - 1, points.back());
  const auto isNear = [&](const Place& miss) { return miss.norm() > least && miss.norm() < reach; };
  if (!isNear(first) && !isNear(last))
  {
    return stroke;
  }
  if (isNear(first))
  {
    lead(points.begin(), points.end(), first, share * length);
  }
  if (isNear(last))
  {
    lead(points.rbegin(), points.rend(), last, share * length);
  }
  auto led = vtkSmartPointer<vtkPolyData>::New();
  led->DeepCopy(stroke);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    led->GetPoints()->SetPoint(static_cast<vtkIdType>(i), points[i][0], points[i][1], 0.0);
  }
  return led;
}

} // namespace oversketch_studio
