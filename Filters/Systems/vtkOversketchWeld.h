// A mesh as a system computes on it: points that share a position are one vertex, whatever attributes a
// reader split them for. And the way back: the user's arrays on the deformed and on the remeshed result.
#ifndef vtkOversketchWeld_h
#define vtkOversketchWeld_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "vtkOversketchSharedMesh.h"

#include "vtkNew.h"
#include "vtkPolyData.h"

#include <memory>
#include <vector>

namespace oversketch
{

// The rotation that takes one surface normal to another, applied to a normal of the user's.
OVERSKETCHFILTERSSYSTEMS_EXPORT Vector3 Turned(const Vector3& normal,
  const Vector3& before,
  const Vector3& after);

// Active cell normals, where there are any, of triangles with a point that changed, computed anew.
OVERSKETCHFILTERSSYSTEMS_EXPORT void RefreshCellNormals(vtkPolyData* output,
  const std::vector<char>& changedPoint);

class OVERSKETCHFILTERSSYSTEMS_EXPORT Weld
{
public:
  // Throws Error(BadMesh) as MeshOf does. The mesh is kept, not copied.
  explicit Weld(vtkPolyData* mesh);
  ~Weld();

  // Geometry only: welded points (those of the mesh, the same object, where nothing was to weld), its
  // triangles in its order, their numbers as cell array OriginalCell, so that the remesher hands them on,
  // and, where the reader split points along seams of an attribute, cell array Chart: neighbours in one chart
  // agree in all attributes of their common points.
  vtkPolyData* Welded() const { return this->Geometry; }

  // The welded vertex of a point of the mesh.
  vtkIdType VertexOf(vtkIdType point) const
  {
    return this->Vertices.empty() ? point : this->Vertices[static_cast<std::size_t>(point)];
  }

  // Gives the welded mesh the mask of the mesh that was welded (vtkOversketchMaskArray.h), of points that are
  // one vertex the largest; takes it away where that has none.
  void PutMask(vtkPolyData* mesh, vtkPolyData* welded) const;

  // mesh with the points of moved, which has the welded mesh's connectivity. Everything else is passed; point
  // normals turn as the surface does, and are not touched where it did not move.
  void Move(vtkPolyData* mesh, vtkPolyData* moved, vtkPolyData* output) const;

  // The last of the remeshings in the user's terms: the first was remeshed from the welded mesh, each further
  // one from the one before it, which may have been moved in between; all carry SourceCell and SourceWeights
  // (vtkOversketchRemesh). Point arrays are interpolated from mesh, once per chart along seams; cell arrays
  // come from OriginalCell, the cell that lay under a triangle's middle. Returns the vertex of the last
  // remeshing that each point of the output is.
  // Where a vertex comes from several places it is as many points where it was before (AsBefore), in any
  // mesh (Split), or in none (Shared): then it takes its arrays from one of them.
  enum class Seams
  {
    AsBefore,
    Split,
    Shared
  };
  std::vector<int> Transfer(vtkPolyData* mesh,
    const std::vector<vtkPolyData*>& remeshings,
    vtkPolyData* output,
    Seams seams = Seams::AsBefore) const;

private:
  class Origins;
  class Split;

  const std::vector<Triangle>& CornersOf() const
  {
    return this->Vertices.empty() ? this->Data->Surface().triangles : this->Corners;
  }
  int ClassOf(int point) const { return this->Vertices.empty() ? point : this->Classes[point]; }
  std::vector<int> LoosePoints() const;
  void CarryPoints(vtkPolyData* mesh, const Split& split, const MeshData& result, vtkPolyData* output) const;
  void CarryNormals(vtkPolyData* mesh, const Split& split, const MeshData& result, vtkPolyData* output) const;

  std::vector<int> Vertices; // welded vertex per point; empty when that is the identity
  std::vector<int> Classes; // points that agree in position and all attributes share one; empty like Vertices
  std::vector<Triangle> Corners; // points of the mesh per triangle; empty like Vertices
  vtkNew<vtkPolyData> Geometry;
  std::shared_ptr<const MeshData> Data; // of Geometry
};

} // namespace oversketch
#endif
