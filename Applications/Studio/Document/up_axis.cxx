#include "up_axis.h"

#include "vtkCellArray.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace oversketch_studio
{

namespace
{

constexpr double sole = 0.04; // of the height: what so low a part of it stands on
constexpr double steady =
  0.02; // of the footprint's diagonal: the middle is so far inside of what it stands on
constexpr double broad = 0.12;  // of the footprint: what it stands on spans so much
constexpr double broader = 2.0; // times as much as the other way up
using FlatPlace = std::array<double, 2>;

double sideOf(const FlatPlace& a, const FlatPlace& b, const FlatPlace& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Counter-clockwise.
std::vector<FlatPlace> hullOf(std::vector<FlatPlace> places)
{
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  std::vector<FlatPlace> hull;
  for (const bool isUpper : { false, true })
  {
    const std::size_t first = hull.size();
    for (const FlatPlace& place : places)
    {
      while (hull.size() > first + 1 && sideOf(hull[hull.size() - 2], hull.back(), place) <= 0.0)
      {
        hull.pop_back();
      }
      hull.push_back(place);
    }
    hull.pop_back();
    if (!isUpper)
    {
      std::reverse(places.begin(), places.end());
    }
  }
  return hull;
}

std::array<double, 3> middleOf(vtkPolyData* mesh)
{
  std::array<double, 3> sum{};
  double area = 0.0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetPolys()->GetNumberOfCells(); ++cell)
  {
    mesh->GetPolys()->GetCellAtId(cell, ids);
    double p[3][3];
    mesh->GetPoint(ids->GetId(0), p[0]);
    for (vtkIdType i = 2; i < ids->GetNumberOfIds(); ++i)
    {
      mesh->GetPoint(ids->GetId(i - 1), p[1]);
      mesh->GetPoint(ids->GetId(i), p[2]);
      const double one = vtkTriangle::TriangleArea(p[0], p[1], p[2]);
      area += one;
      for (std::size_t k = 0; k < 3; ++k)
      {
        sum[k] += one * (p[0][k] + p[1][k] + p[2][k]) / 3.0;
      }
    }
  }
  for (double& one : sum)
  {
    one /= area > 0.0 ? area : 1.0;
  }
  return sum;
}

// The ground that it stands on along an axis.
struct Stand
{
  double inside =
    -std::numeric_limits<double>::infinity(); // of the middle [footprint's diagonal], negative outside
  double area = 0.0;                          // a share of the footprint
};

Stand standOn(vtkPolyData* mesh, int axis, const std::array<double, 3>& middle)
{
  const double* box = mesh->GetBounds();
  const int a = axis == 1 ? 2 : 0, b = axis == 1 ? 0 : 1; // so that the two and the axis are right-handed
  const double sides[2] = { box[2 * a + 1] - box[2 * a], box[2 * b + 1] - box[2 * b] };
  const double low = box[2 * axis] + sole * (box[2 * axis + 1] - box[2 * axis]);
  std::vector<FlatPlace> places;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* p = mesh->GetPoint(i);
    if (p[axis] <= low)
    {
      places.push_back({ p[a], p[b] });
    }
  }
  const std::vector<FlatPlace> hull = hullOf(std::move(places));
  Stand stand;
  if (hull.size() < 3 || !(sides[0] > 0.0 && sides[1] > 0.0))
  {
    return stand;
  }
  stand.inside = std::numeric_limits<double>::infinity();
  const FlatPlace at{ middle[static_cast<std::size_t>(a)], middle[static_cast<std::size_t>(b)] };
  for (std::size_t i = 0; i < hull.size(); ++i)
  {
    const FlatPlace &from = hull[i], &to = hull[(i + 1) % hull.size()];
    const double length = std::hypot(to[0] - from[0], to[1] - from[1]);
    stand.inside = std::min(stand.inside, sideOf(from, to, at) / length / std::hypot(sides[0], sides[1]));
    stand.area += 0.5 * (from[0] * to[1] - to[0] * from[1]) / (sides[0] * sides[1]);
  }
  return stand;
}

} // namespace

int upAxisOf(vtkPolyData* mesh)
{
  if (!mesh || mesh->GetNumberOfPoints() == 0 || mesh->GetNumberOfPolys() == 0)
  {
    return 1;
  }
  const std::array<double, 3> middle = middleOf(mesh);
  const Stand y = standOn(mesh, 1, middle), z = standOn(mesh, 2, middle);
  const bool onY = y.inside > 0.0 && (y.inside >= z.inside || y.area * broader > z.area);
  return z.inside > steady && z.area > broad && !onY ? 2 : 1;
}

} // namespace oversketch_studio
