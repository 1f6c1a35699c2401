#include "region_patch.h"

#include "Mesh/context.h"
#include "Ray/projection.h"
#include "vtkOversketchEditArrays.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchSharedMesh.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

namespace oversketch
{

std::array<RegionPatch::Stamp, 4> RegionPatch::shapeOf(vtkPolyData* mesh)
{
  const auto stamp = [](vtkObject* object) { return Stamp(object, object ? object->GetMTime() : 0); };
  return { stamp(mesh->GetPolys()),
    stamp(mesh->GetPointData()->GetArray("DiscCoords")),
    stamp(mesh->GetPointData()->GetArray("CurveDistance")),
    stamp(mesh->GetCellData()->GetArray("EditRegion")) };
}

RegionPatch::RegionPatch(vtkPolyData* mesh)
  : Shape(shapeOf(mesh))
  , Places(mesh->GetPoints(), mesh->GetPoints()->GetMTime())
{
  const auto data = SharedMesh(mesh);
  const Mesh& whole = data->Surface();
  const char* remedy = "vtkOversketchFlatten and vtkOversketchDistanceField make them";
  vtkDataArray* coords =
    RequireArray(mesh->GetPointData(), "DiscCoords", 2, mesh->GetNumberOfPoints(), "mesh", remedy);
  vtkDataArray* distances =
    RequireArray(mesh->GetPointData(), "CurveDistance", 1, mesh->GetNumberOfPoints(), "mesh", remedy);
  vtkDataArray* labels = mesh->GetCellData()->GetArray("EditRegion");
  auto disc = std::make_shared<Mesh>(), model = std::make_shared<Mesh>();
  std::vector<int> number(whole.points.size(), -1);
  for (std::size_t t = 0; t < whole.triangles.size(); ++t)
  {
    const Triangle& corners = whole.triangles[t];
    bool in = !labels || labels->GetComponent(static_cast<vtkIdType>(t), 0) == EditLabel::Inside;
    for (const int v : { corners[0], corners[1], corners[2] })
    {
      in = in && coords->GetComponent(v, 0) >= 0.0;
    }
    if (!in)
    {
      continue;
    }
    Triangle& mine = model->triangles.emplace_back();
    for (int k = 0; k < 3; ++k)
    {
      int& id = number[static_cast<std::size_t>(corners[k])];
      if (id < 0)
      {
        id = static_cast<int>(model->points.size());
        this->Points.push_back(corners[k]);
        model->points.push_back(whole.points[static_cast<std::size_t>(corners[k])]);
        disc->points.emplace_back(2.0 * coords->GetComponent(corners[k], 0) - 1.0,
          2.0 * coords->GetComponent(corners[k], 1) - 1.0,
          0.0);
        this->Shares.push_back(distances->GetComponent(corners[k], 0));
      }
      mine[k] = id;
    }
  }
  if (model->triangles.empty())
  {
    throw Error(Failure::BadRegion, "The mesh has no triangle in the disc; draw a line and a ring first.");
  }
  disc->triangles = model->triangles;
  this->Disc = disc;
  this->Model = model;
}

bool RegionPatch::follow(vtkPolyData* mesh)
{
  if (shapeOf(mesh) != this->Shape)
  {
    return false;
  }
  vtkPoints* points = mesh->GetPoints();
  const Stamp places(points, points->GetMTime());
  if (places != this->Places)
  {
    this->ModelRays = nullptr;
    for (std::size_t v = 0; v < this->Points.size(); ++v)
    {
      points->GetPoint(this->Points[v], this->Model->points[v].data());
    }
    this->Places = places;
  }
  return true;
}

const SurfaceRays& RegionPatch::rays(PatchSide side) const
{
  std::unique_ptr<const SurfaceRays>& rays = side == PatchSide::Disc ? this->DiscRays : this->ModelRays;
  if (!rays)
  {
    rays = std::make_unique<const SurfaceRays>(side == PatchSide::Disc ? this->Disc : this->Model);
  }
  return *rays;
}

SurfaceHit RegionPatch::under(PatchSide side, const View& view, const Vector2& place) const
{
  const SurfaceRays& rays = this->rays(side);
  return rays.nearest(lineOfSight(view, place, rays));
}

double RegionPatch::shareAt(const SurfacePoint& at) const
{
  const Triangle& t = this->Model->triangles[static_cast<std::size_t>(at.triangle)];
  double share = 0.0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    share += at.weights[k] * this->Shares[static_cast<std::size_t>(t[static_cast<int>(k)])];
  }
  return share;
}

Vector2 RegionPatch::discAt(const SurfacePoint& at) const
{
  return positionOf(*this->Disc, at).head<2>();
}

std::optional<Vector3> RegionPatch::placeOf(PatchSide side, const Vector2& disc) const
{
  const SurfaceHit hit =
    this->rays(PatchSide::Disc).nearest({ Vector3(disc[0], disc[1], 1.0), Vector3(0.0, 0.0, -1.0) });
  return hit.found() ? std::optional<Vector3>(positionOf(this->shape(side), hit.at)) : std::nullopt;
}

std::vector<std::array<Vector3, 2>> RegionPatch::level(PatchSide side, double share) const
{
  std::vector<std::array<Vector3, 2>> pieces;
  const Mesh& mesh = this->shape(side);
  for (const Triangle& t : mesh.triangles)
  {
    std::array<Vector3, 2> piece;
    std::size_t count = 0;
    for (int k = 0; k < 3 && count < 2; ++k)
    {
      const auto a = static_cast<std::size_t>(t[k]), b = static_cast<std::size_t>(t[(k + 1) % 3]);
      const double from = this->Shares[a], to = this->Shares[b];
      if ((from < share) != (to < share)) // a corner on it counts as beyond it
      {
        const double u = (share - from) / (to - from);
        piece[count++] = (1.0 - u) * mesh.points[a] + u * mesh.points[b];
      }
    }
    if (count == 2)
    {
      pieces.push_back(piece);
    }
  }
  return pieces;
}

bool followRegion(std::unique_ptr<RegionPatch>& patch, vtkPolyData* mesh)
{
  const bool isThere = mesh && mesh->GetNumberOfPoints() > 0;
  if (isThere && patch && patch->follow(mesh))
  {
    return false;
  }
  patch = nullptr; // so that none is left where making one fails
  if (isThere)
  {
    patch = std::make_unique<RegionPatch>(mesh);
  }
  return true;
}

} // namespace oversketch
