#include "mirror_image.h"

#include "vtkOversketchCarriedArrays.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

namespace oversketch_session
{

namespace
{

using Place = std::array<double, 3>;
using Numbers = std::vector<vtkIdType>;
using Triangle = std::array<vtkIdType, 3>;

Place placeOf(vtkPoints* points, vtkIdType i)
{
  Place place;
  points->GetPoint(i, place.data());
  return place;
}

Numbers inOrder(vtkIdType count)
{
  Numbers numbers(static_cast<std::size_t>(count));
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

// The points of a mesh by where they are.
class Register
{
public:
  explicit Register(vtkPoints* points)
    : Points(points)
    , Sorted(inOrder(points->GetNumberOfPoints()))
  {
    std::sort(this->Sorted.begin(),
      this->Sorted.end(),
      [points](vtkIdType a, vtkIdType b)
      { return std::pair(placeOf(points, a), a) < std::pair(placeOf(points, b), b); });
  }

  // The first in that place that is taken, or -1.
  template <typename Take>
  vtkIdType find(const Place& place, const Take& take) const
  {
    auto at = std::lower_bound(this->Sorted.begin(),
      this->Sorted.end(),
      place,
      [this](vtkIdType i, const Place& wanted) { return placeOf(this->Points, i) < wanted; });
    for (; at != this->Sorted.end() && placeOf(this->Points, *at) == place; ++at)
    {
      if (take(*at))
      {
        return *at;
      }
    }
    return -1;
  }

private:
  vtkPoints* Points;
  Numbers Sorted;
};

// For each point the one that lies where it is reflected to, else itself.
Numbers pointPairs(vtkPoints* points, const MirrorPlane& plane)
{
  const Register there(points);
  Numbers pairs = inOrder(points->GetNumberOfPoints());
  std::vector<char> paired(pairs.size(), 0);
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    if (paired[i])
    {
      continue;
    }
    const vtkIdType other =
      there.find(reflected(placeOf(points, i), plane), [&](vtkIdType j) { return !paired[j]; });
    if (other >= 0)
    {
      std::swap(pairs[i], pairs[other]);
      paired[i] = paired[other] = 1;
    }
  }
  return pairs;
}

// Empty where it has other polygons than triangles.
std::vector<Triangle> trianglesOf(vtkPolyData* mesh)
{
  std::vector<Triangle> triangles;
  if (mesh->GetPolys()->IsHomogeneous() == 3)
  {
    triangles.resize(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
    vtkNew<vtkIdList> ids;
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      mesh->GetPolys()->GetCellAtId(static_cast<vtkIdType>(t), ids);
      std::copy(ids->begin(), ids->end(), triangles[t].begin());
    }
  }
  return triangles;
}

// The other way round, with those numbers of its points.
Triangle turned(const Triangle& triangle, const Numbers& points)
{
  return { points[triangle[2]], points[triangle[1]], points[triangle[0]] };
}

// From its least point on.
Triangle begun(Triangle triangle)
{
  std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
  return triangle;
}

// For each triangle the one that its points' pairs make, else itself.
Numbers trianglePairs(const std::vector<Triangle>& triangles, const Numbers& points)
{
  const auto count = static_cast<vtkIdType>(triangles.size());
  std::vector<std::pair<Triangle, vtkIdType>> sorted(triangles.size());
  for (vtkIdType t = 0; t < count; ++t)
  {
    sorted[t] = { begun(triangles[t]), t };
  }
  std::sort(sorted.begin(), sorted.end());
  Numbers pairs = inOrder(count);
  std::vector<char> paired(triangles.size(), 0);
  for (vtkIdType t = 0; t < count; ++t)
  {
    const Triangle wanted = begun(turned(triangles[t], points));
    auto at = std::lower_bound(sorted.begin(), sorted.end(), std::pair(wanted, vtkIdType(0)));
    while (at != sorted.end() && at->first == wanted && paired[at->second])
    {
      ++at;
    }
    if (!paired[t] && at != sorted.end() && at->first == wanted)
    {
      std::swap(pairs[t], pairs[at->second]);
      paired[t] = paired[at->second] = 1;
    }
  }
  return pairs;
}

vtkSmartPointer<vtkCellArray> turnedPolygons(vtkCellArray* polygons)
{
  auto turned = vtkSmartPointer<vtkCellArray>::New();
  turned->DeepCopy(polygons);
  for (vtkIdType t = 0; t < turned->GetNumberOfCells(); ++t)
  {
    turned->ReverseCellAtId(t);
  }
  return turned;
}

// The arrays, of the tuples with those numbers where they are not in order.
void passArrays(vtkDataSetAttributes* from, vtkDataSetAttributes* to, const Numbers& numbers, int axis)
{
  if (std::is_sorted(numbers.begin(), numbers.end()))
  {
    to->ShallowCopy(from);
  }
  else
  {
    to->Initialize();
    to->CopyAllOn();
    oversketch::CopyElements(from, numbers, to);
  }
  if (to->GetNormals())
  {
    auto normals = vtkSmartPointer<vtkDataArray>::Take(to->GetNormals()->NewInstance());
    normals->DeepCopy(to->GetNormals());
    for (vtkIdType i = 0; i < normals->GetNumberOfTuples(); ++i)
    {
      normals->SetComponent(i, axis, -normals->GetComponent(i, axis));
    }
    to->SetNormals(normals);
  }
}

} // namespace

Point reflected(Point place, const MirrorPlane& plane)
{
  double& height = place[static_cast<std::size_t>(plane.axis)];
  height = 2.0 * plane.offset - height;
  return place;
}

bool sameCells(vtkPolyData* a, vtkPolyData* b)
{
  if (a->GetNumberOfPoints() != b->GetNumberOfPoints() || a->GetNumberOfPolys() != b->GetNumberOfPolys())
  {
    return false;
  }
  vtkNew<vtkIdList> p, q;
  for (vtkIdType t = 0; a->GetPolys() != b->GetPolys() && t < a->GetNumberOfPolys(); ++t)
  {
    a->GetPolys()->GetCellAtId(t, p);
    b->GetPolys()->GetCellAtId(t, q);
    if (!std::equal(p->begin(), p->end(), q->begin(), q->end()))
    {
      return false;
    }
  }
  return true;
}

MirrorImage::MirrorImage(vtkPolyData* mesh, const MirrorPlane& plane)
  : Mesh(mesh)
  , Image(vtkSmartPointer<vtkPolyData>::New())
  , Plane(plane)
{
  const vtkIdType count = mesh->GetNumberOfPoints();
  const std::vector<Triangle> triangles = trianglesOf(mesh);
  this->Points = triangles.empty() ? inOrder(count) : pointPairs(mesh->GetPoints(), plane);
  this->Polygons =
    triangles.empty() ? inOrder(mesh->GetNumberOfPolys()) : trianglePairs(triangles, this->Points);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    points->SetPoint(this->Points[i], reflected(placeOf(mesh->GetPoints(), i), plane).data());
  }
  this->Image->ShallowCopy(mesh);
  this->Image->SetPoints(points);
  if (triangles.empty())
  {
    this->Image->SetPolys(turnedPolygons(mesh->GetPolys()));
  }
  else
  {
    std::vector<Triangle> faces(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
    {
      const auto slot = static_cast<std::size_t>(this->Polygons[t]);
      const Triangle face = turned(triangles[t], this->Points);
      faces[slot] = begun(face) == begun(triangles[slot]) ? triangles[slot] : face;
    }
    vtkNew<vtkCellArray> polygons;
    for (const Triangle& face : faces)
    {
      polygons->InsertNextCell(3, face.data());
    }
    this->Image->SetPolys(polygons);
  }
  passArrays(mesh->GetPointData(), this->Image->GetPointData(), this->Points, plane.axis);
  passArrays(mesh->GetCellData(), this->Image->GetCellData(), this->Polygons, plane.axis);
}

vtkSmartPointer<vtkPolyData> MirrorImage::back(vtkPolyData* made) const
{
  const bool kept = sameCells(this->Image, made);
  const vtkIdType count = made->GetNumberOfPoints();
  const Numbers numbers = kept ? this->Points : inOrder(count);
  const Numbers cells = kept ? this->Polygons : inOrder(made->GetNumberOfPolys());
  std::optional<Register> there;
  if (!kept)
  {
    there.emplace(this->Image->GetPoints());
  }
  vtkNew<vtkPoints> points;
  points->SetDataType(this->Mesh->GetPoints()->GetDataType());
  points->SetNumberOfPoints(count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    const Place place = placeOf(made->GetPoints(), numbers[i]);
    vtkIdType stayed = numbers[i];
    if (there)
    {
      stayed = there->find(place, [](vtkIdType) { return true; });
    }
    else if (place != placeOf(this->Image->GetPoints(), stayed))
    {
      stayed = -1;
    }
    const Place where =
      stayed < 0 ? reflected(place, this->Plane) : placeOf(this->Mesh->GetPoints(), this->Points[stayed]);
    points->SetPoint(i, where.data());
  }
  auto result = shallowCopyOf(made);
  result->SetPoints(points);
  result->SetPolys(kept ? this->Mesh->GetPolys() : turnedPolygons(made->GetPolys()).Get());
  passArrays(made->GetPointData(), result->GetPointData(), numbers, this->Plane.axis);
  passArrays(made->GetCellData(), result->GetCellData(), cells, this->Plane.axis);
  return result;
}

std::shared_ptr<const Details> MirrorImage::back(vtkPolyData* made, const Details& details) const
{
  auto result = std::make_shared<Details>();
  result->region = MirrorImage(details.region, this->Plane).get();
  if (details.following)
  {
    const bool kept = sameCells(this->Image, made);
    auto following = std::make_shared<Following>(*details.following);
    for (vtkIdType& point : following->points)
    {
      point = kept ? this->Points[point] : point;
    }
    for (auto& moves : following->moves)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        float& part = moves[3 * axis + static_cast<std::size_t>(this->Plane.axis)];
        part = -part;
      }
    }
    result->following = following;
  }
  return result;
}

} // namespace oversketch_session
