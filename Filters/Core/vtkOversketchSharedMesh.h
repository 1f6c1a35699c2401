/**
 * One kernel mesh, adjacency and vertex normals for all filters that look at the same mesh. Free functions,
 * for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchSharedMesh_h
#define vtkOversketchSharedMesh_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/mesh.h"

#include <memory>
#include <vector>

class vtkPolyData;

namespace oversketch
{

struct MeshData
{
  Mesh Surface;                 // see MeshOf
  Adjacency Neighbours;         // see buildAdjacency
  std::vector<Vector3> Normals; // see NormalsOf
};

/**
 * What MeshOf, buildAdjacency and NormalsOf make of the mesh; throws what they throw. Built once for all
 * callers while one of them keeps it, found again by points, polygons and point normals (MeshKey), so a
 * shallow copy finds it too. The process remembers weak pointers only: memory goes with the last filter that
 * holds the result. Callable from any thread.
 */
OVERSKETCHFILTERSCORE_EXPORT std::shared_ptr<const MeshData> SharedMesh(vtkPolyData* polyData);

} // namespace oversketch
#endif
