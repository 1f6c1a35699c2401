/**
 * One kernel mesh, adjacency and vertex normals for all filters that look at the same mesh. For use in the
 * .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchSharedMesh_h
#define vtkOversketchSharedMesh_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/mesh.h"

#include <memory>
#include <mutex>
#include <vector>

class vtkPolyData;

namespace oversketch
{

class MeshData;

/**
 * The mesh as MeshOf makes it; throws what that throws, and Error(BadMesh) when the polydata has point
 * normals that are not finite. Built once for all callers while one of them keeps it, found again by points,
 * polygons and point normals (MeshKey), so a shallow copy finds it too. The process remembers weak pointers
 * only: memory goes with the last filter that holds the result. Callable from any thread.
 */
OVERSKETCHFILTERSCORE_EXPORT std::shared_ptr<const MeshData> SharedMesh(vtkPolyData* polyData);

/**
 * A mesh and, made when somebody first asks for them, its adjacency and its vertex normals. Meshes with the
 * same polygons, such as one before and after a deformation, have one adjacency. Callable from any thread.
 */
class OVERSKETCHFILTERSCORE_EXPORT MeshData
{
public:
  /**
   * See MeshOf.
   */
  const Mesh& Surface() const { return *this->Shape; }
  /**
   * See buildAdjacency.
   */
  const Adjacency& Neighbours() const;
  /**
   * Whether both have one adjacency.
   */
  bool HasLinksOf(const MeshData& other) const { return this->Linked == other.Linked; }
  /**
   * Unit vertex normals: the active point normals where the polydata has them with the right size
   * (re-normalised), else computed (angle-weighted). Absent normals are no error.
   */
  const std::vector<Vector3>& Normals() const;
  /**
   * Surface and Normals for who keeps them and needs no links.
   */
  std::shared_ptr<const Mesh> KeptSurface() const { return this->Shape; }
  std::shared_ptr<const std::vector<Vector3>> KeptNormals() const;

private:
  struct Links;
  MeshData() = default;
  friend std::shared_ptr<const MeshData> SharedMesh(vtkPolyData* polyData);

  std::shared_ptr<const Mesh> Shape;
  std::shared_ptr<Links> Linked;
  mutable std::once_flag NormalsOnce;
  mutable std::shared_ptr<const std::vector<Vector3>> VertexNormals;
};

} // namespace oversketch
#endif
