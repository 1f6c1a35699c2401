// The region of an edit by itself, on the model and on the disc, and from the one to the other.
#ifndef oversketch_widgets_edit_region_patch_h
#define oversketch_widgets_edit_region_patch_h

#include "Mesh/view.h"
#include "Ray/surface_rays.h"
#include "Stroke/polyline.h"

#include "vtkType.h"

#include <array>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

class vtkObject;
class vtkPolyData;

namespace oversketch
{

enum class PatchSide
{
  Disc,
  Model
};

// 0 the disc, 1 the model.
inline PatchSide patchSide(int side)
{
  return side == 0 ? PatchSide::Disc : PatchSide::Model;
}

class RegionPatch
{
public:
  // Takes, of a mesh with point arrays DiscCoords and CurveDistance (vtkOversketchDistanceField): the
  // triangles all of whose corners are in the disc, and that are the region's by cell array EditRegion where
  // there is one. Throws Error(MissingArray), Error(BadRegion) where there is none.
  explicit RegionPatch(vtkPolyData* mesh);

  // True for the mesh that it is of, and for one with other places alone, which it takes.
  bool follow(vtkPolyData* mesh);

  const Mesh& shape(PatchSide side) const { return side == PatchSide::Disc ? *this->Disc : *this->Model; }
  // Share of the way from the line, 0, to the ring, 1, of each vertex.
  const std::vector<double>& shares() const { return this->Shares; }

  // The point that is seen first at a place of the picture [px].
  SurfaceHit under(PatchSide side, const View& view, const Vector2& place) const;
  double shareAt(const SurfacePoint& at) const;
  Vector2 discAt(const SurfacePoint& at) const;
  // A place of the disc, x and y from -1 to 1, on the disc or the model; absent beside it.
  std::optional<Vector3> placeOf(PatchSide side, const Vector2& disc) const;

  // Where the share has a value, in pieces of two points.
  std::vector<std::array<Vector3, 2>> level(PatchSide side, double share) const;

private:
  const SurfaceRays& rays(PatchSide side) const;

  using Stamp = std::pair<const vtkObject*, vtkMTimeType>;
  static std::array<Stamp, 4> shapeOf(vtkPolyData* mesh); // of all that it is made of but the places

  std::array<Stamp, 4> Shape;
  Stamp Places;
  std::vector<vtkIdType> Points; // of the mesh
  std::shared_ptr<Mesh> Disc, Model;
  std::vector<double> Shares;
  mutable std::unique_ptr<const SurfaceRays> DiscRays, ModelRays; // once they are asked
};

// Makes the patch that of a mesh, null where there is none, by the one that it is where that can follow.
// Returns false where it did. Throws as the constructor does, and leaves none.
bool followRegion(std::unique_ptr<RegionPatch>& patch, vtkPolyData* mesh);

} // namespace oversketch
#endif
