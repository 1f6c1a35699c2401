#include "both_sides.h"

#include "mirror_image.h"
#include "two_sides.h"

#include "vtkOversketchEdit.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkGenericCell.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkStaticCellLocator.h"

#include <algorithm>
#include <set>

namespace oversketch_studio
{

using oversketch_session::MirrorPlane;

namespace
{

constexpr double farthest = 0.1; // of the region's size: farther off it, in the mirror, a point stays

using Place = std::array<double, 3>;
using Corners = std::array<vtkIdType, 3>;

Place placeOf(vtkPolyData* mesh, vtkIdType i)
{
  Place place;
  mesh->GetPoint(i, place.data());
  return place;
}

Place reflectedNormal(vtkDataArray* normals, vtkIdType i, const MirrorPlane& plane)
{
  Place normal;
  normals->GetTuple(i, normal.data());
  return oversketch_session::reflected(normal, { plane.axis, 0.0 });
}

// Whether a triangle looks to the side of a normal.
bool isAlike(const Place& normal, vtkCell* triangle)
{
  Place corners[3], u, v, own;
  for (int k = 0; k < 3; ++k)
  {
    triangle->GetPoints()->GetPoint(k, corners[k].data());
  }
  vtkMath::Subtract(corners[1].data(), corners[0].data(), u.data());
  vtkMath::Subtract(corners[2].data(), corners[0].data(), v.data());
  vtkMath::Cross(u.data(), v.data(), own.data());
  return vtkMath::Dot(own.data(), normal.data()) > 0.0;
}

// The triangles that have a point strictly inside the region.
vtkSmartPointer<vtkPolyData> insideOf(vtkPolyData* rest)
{
  vtkDataArray* region = rest->GetPointData()->GetArray("EditRegion");
  vtkNew<vtkCellArray> inside;
  eachTriangle(rest,
    [&](const Corners& corners)
    {
      if (std::any_of(
            corners.begin(), corners.end(), [&](vtkIdType id) { return region->GetComponent(id, 0) == 2.0; }))
      {
        inside->InsertNextCell(3, corners.data());
      }
    });
  auto patch = vtkSmartPointer<vtkPolyData>::New();
  patch->SetPoints(rest->GetPoints());
  patch->SetPolys(inside);
  return patch;
}

// Places of the region as it is by now, as points of the shown mesh have them.
std::set<Place> ownPlaces(vtkPolyData* live, vtkPolyData* rest, vtkPolyData* moved)
{
  vtkDataArray* region = rest->GetPointData()->GetArray("EditRegion");
  const auto asShown = vtkSmartPointer<vtkPoints>::New();
  asShown->SetDataType(live->GetPoints()->GetDataType());
  std::set<Place> places;
  for (vtkIdType i = 0; i < rest->GetNumberOfPoints(); ++i)
  {
    if (region->GetComponent(i, 0) == 2.0)
    {
      Place place = placeOf(moved, i);
      asShown->GetPoint(asShown->InsertNextPoint(place.data()), place.data());
      places.insert(place);
    }
  }
  return places;
}

} // namespace

vtkPolyData* BothSides::show(vtkPolyData* live, vtkOversketchEdit* edit, const MirrorPlane& plane)
{
  const bool hasImage = edit->GetNumberOfInputConnections(5) > 0;
  const bool hasProfile = edit->GetNumberOfInputConnections(3) > 0 &&
                          vtkPolyData::SafeDownCast(edit->GetInputDataObject(3, 0))->GetNumberOfPoints() > 0;
  vtkPolyData* rest = hasImage ? edit->GetInnerOutput("Texture") : edit->GetInnerOutput("Shading");
  vtkPolyData* moved = hasProfile ? edit->GetInnerOutput("Bend") : edit->GetInnerOutput("Deform");
  if (!rest || !moved || rest->GetNumberOfPoints() == 0 ||
      moved->GetNumberOfPoints() != rest->GetNumberOfPoints() ||
      !rest->GetPointData()->HasArray("EditRegion"))
  {
    return live;
  }
  const bool isKnown = live->GetPolys() == this->Cells && rest->GetPoints() == this->RestPoints &&
                       plane.axis == this->Plane.axis && plane.offset == this->Plane.offset;
  if (!isKnown)
  {
    vtkNew<vtkPolyData> hold;
    edit->GetHold(hold);
    this->Followers.clear();
    if (!oversketch_session::crossesMirrorPlane(hold, plane, live))
    {
      this->bind(live, rest, moved, plane);
    }
    this->Cells = live->GetPolys();
    this->RestPoints = rest->GetPoints();
    this->Plane = plane;
  }
  if (this->Followers.empty())
  {
    return live;
  }
  copyToMove(live, this->Shown);
  vtkPoints* points = this->Shown->GetPoints();
  for (const Follower& follower : this->Followers)
  {
    Place way{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Place from = placeOf(rest, follower.corners[k]), to = placeOf(moved, follower.corners[k]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        way[c] += follower.weights[k] * (to[c] - from[c]);
      }
    }
    way[static_cast<std::size_t>(plane.axis)] *= -1.0;
    Place place = placeOf(live, follower.point);
    vtkMath::Add(place.data(), way.data(), place.data());
    points->SetPoint(follower.point, place.data());
  }
  if (vtkDataArray* before = live->GetPointData()->GetNormals())
  {
    this->Normals.turn(before, this->Shown);
  }
  return this->Shown;
}

void BothSides::bind(vtkPolyData* live, vtkPolyData* rest, vtkPolyData* moved, const MirrorPlane& plane)
{
  const vtkSmartPointer<vtkPolyData> inside = insideOf(rest);
  vtkBoundingBox box;
  eachTriangle(inside,
    [&](const Corners& corners)
    {
      for (const vtkIdType id : corners)
      {
        box.AddPoint(placeOf(rest, id).data());
      }
    });
  if (!box.IsValid())
  {
    return;
  }
  const double reach = farthest * box.GetDiagonalLength();
  box.Inflate(reach);
  vtkNew<vtkStaticCellLocator> locator;
  locator->SetDataSet(inside);
  locator->BuildLocator();
  const std::set<Place> own = ownPlaces(live, rest, moved);
  vtkDataArray* normals = live->GetPointData()->GetNormals();
  vtkNew<vtkGenericCell> cell;
  for (vtkIdType i = 0; i < live->GetNumberOfPoints(); ++i)
  {
    const Place place = placeOf(live, i), seen = oversketch_session::reflected(place, plane);
    if (!box.ContainsPoint(seen.data()) || own.count(place) > 0)
    {
      continue;
    }
    double nearest[3], squared = 0.0, at[3], weights[3];
    vtkIdType id = -1;
    int part = 0;
    locator->FindClosestPoint(seen.data(), nearest, cell, id, part, squared);
    if (id < 0 || squared > reach * reach)
    {
      continue;
    }
    inside->GetCell(id, cell);
    if (normals && !isAlike(reflectedNormal(normals, i, plane), cell))
    {
      continue; // the back of something thin
    }
    if (cell->EvaluatePosition(nearest, nullptr, part, at, squared, weights) < 0)
    {
      continue; // of no area
    }
    this->Followers.push_back({ i,
      { cell->GetPointId(0), cell->GetPointId(1), cell->GetPointId(2) },
      { weights[0], weights[1], weights[2] } });
  }
  this->Normals.bind(live, oversketch::mapped(this->Followers, &Follower::point));
}

} // namespace oversketch_studio
