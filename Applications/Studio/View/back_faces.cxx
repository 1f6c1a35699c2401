#include "back_faces.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkMath.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

namespace oversketch_studio
{

namespace
{

// A number as good as drawn by lot (splitmix64).
std::uint64_t scattered(std::uint64_t key)
{
  key += 0x9e3779b97f4a7c15U;
  key = (key ^ (key >> 30U)) * 0xbf58476d1ce4e5b9U;
  key = (key ^ (key >> 27U)) * 0x94d049bb133111ebU;
  return key ^ (key >> 31U);
}

// The first point of a part.
vtkIdType rootOf(std::vector<vtkIdType>& parents, vtkIdType point)
{
  while (parents[point] != point)
  {
    point = parents[point] = parents[parents[point]];
  }
  return point;
}

bool isCut(const double box[6], vtkCamera* camera)
{
  double eye[3], ahead[3], corner[3];
  camera->GetPosition(eye);
  camera->GetDirectionOfProjection(ahead);
  const vtkBoundingBox bounds(box);
  for (int i = 0; bounds.IsValid() && i < 8; ++i)
  {
    bounds.GetCorner(i, corner);
    vtkMath::Subtract(corner, eye, corner);
    if (!(vtkMath::Dot(corner, ahead) >= camera->GetClippingRange()[0]))
    {
      return true;
    }
  }
  return !bounds.IsValid();
}

} // namespace

bool BackFaces::areHidden(vtkPolyData* mesh, vtkRenderer* renderer)
{
  vtkCellArray* cells = mesh->GetPolys();
  if (cells != this->Seen || cells->GetMTime() != this->Time)
  {
    this->Seen = cells;
    this->Time = cells->GetMTime();
    this->Body = boundBody(mesh);
  }
  return this->Body && !isCut(mesh->GetBounds(), renderer->GetActiveCamera());
}

bool BackFaces::boundBody(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() == 0 || mesh->GetNumberOfStrips() > 0)
  {
    return false;
  }
  std::vector<vtkIdType> parents(mesh->GetNumberOfPoints());
  std::iota(parents.begin(), parents.end(), vtkIdType{ 0 });
  std::uint64_t left = 0; // of all edges there and back
  double centre[3];
  mesh->GetCenter(centre);
  std::vector<std::array<double, 3>> places(parents.size());
  for (std::size_t point = 0; point < places.size(); ++point)
  {
    mesh->GetPoint(static_cast<vtkIdType>(point), places[point].data());
    vtkMath::Subtract(places[point], centre, places[point]);
  }
  std::vector<double> volumes(parents.size(), 0.0); // by a face's first point, then by a part's
  const auto faces = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (faces->GoToFirstCell(); !faces->IsDoneWithTraversal(); faces->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* points = nullptr;
    faces->GetCurrentCell(count, points);
    for (vtkIdType i = 0; i < count; ++i)
    {
      const vtkIdType a = points[i], b = points[i + 1 < count ? i + 1 : 0];
      const auto low = static_cast<std::uint64_t>(std::min(a, b)),
                 high = static_cast<std::uint64_t>(std::max(a, b));
      const std::uint64_t edge =
        a == b ? 0 : scattered(low * static_cast<std::uint64_t>(parents.size()) + high);
      left += a < b ? edge : ~edge + 1U;
      if (i > 0)
      {
        parents[rootOf(parents, a)] = rootOf(parents, points[0]);
      }
    }
    for (vtkIdType i = 2; i < count; ++i)
    {
      double cross[3];
      vtkMath::Cross(places[points[i - 1]].data(), places[points[i]].data(), cross);
      volumes[points[0]] += vtkMath::Dot(places[points[0]].data(), cross);
    }
  }
  if (left != 0)
  {
    return false;
  }
  std::vector<char> isPart(parents.size(), 0);
  for (std::size_t point = 0; point < parents.size(); ++point)
  {
    const vtkIdType root = rootOf(parents, static_cast<vtkIdType>(point));
    isPart[root] = isPart[root] || root != static_cast<vtkIdType>(point);
    volumes[root] += root != static_cast<vtkIdType>(point) ? volumes[point] : 0.0;
  }
  for (std::size_t point = 0; point < parents.size(); ++point)
  {
    if (isPart[point] && !(volumes[point] > 0.0))
    {
      return false;
    }
  }
  return true;
}

} // namespace oversketch_studio
