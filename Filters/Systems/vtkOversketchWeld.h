// A mesh as a system computes on it: points that share a position are one vertex, whatever attributes a
// reader split them for. And the way back: the user's arrays on the deformed and on the remeshed result. Not
// installed.
#ifndef vtkOversketchWeld_h
#define vtkOversketchWeld_h

#include "Mesh/mesh.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

class Weld
{
public:
  // Throws Error(BadMesh) as MeshOf does. The mesh is kept, not copied.
  explicit Weld(vtkPolyData* mesh);
  ~Weld();
  Weld(const Weld&) = delete;
  void operator=(const Weld&) = delete;

  // Geometry only: welded points (those of the mesh, the same object, where nothing was to weld), its
  // triangles in its order, their numbers as cell array OriginalCell, so that the remesher hands them on,
  // and, where the reader split points along seams of an attribute, cell array Chart: neighbours in one chart
  // agree in all attributes of their common points.
  vtkPolyData* Welded() const { return this->Inner; }

  // The welded vertex of a point of the mesh.
  vtkIdType VertexOf(vtkIdType point) const
  {
    return this->Vertices.empty() ? point : this->Vertices[static_cast<std::size_t>(point)];
  }

  // mesh with the points of moved, which has the welded mesh's connectivity. Everything else is passed; point
  // normals turn as the surface does, and are not touched where it did not move.
  void Move(vtkPolyData* mesh, vtkPolyData* moved, vtkPolyData* output) const;

  // restored in the user's terms: restored was remeshed from deformed, whose connectivity is that of
  // stretched, which was remeshed from the welded mesh; both carry SourceCell and SourceWeights. Point arrays
  // are interpolated from mesh, once per chart along seams; cell arrays come from OriginalCell, the cell that
  // lay under a triangle's middle. Returns the vertex of restored that each point of the output is.
  std::vector<int> Transfer(vtkPolyData* mesh,
    vtkPolyData* stretched,
    vtkPolyData* restored,
    vtkPolyData* output) const;

private:
  void FindVertices();
  void FindAttributeClasses(vtkPolyData* mesh);
  void FindCharts();

  std::vector<vtkIdType> Vertices;         // welded vertex per point; empty when that is the identity
  std::vector<vtkIdType> AttributeClasses; // points that agree in position and all attributes share one
  Mesh Surface;                            // of the welded mesh
  std::vector<Triangle> Corners;           // points of the mesh per triangle
  vtkNew<vtkPolyData> Inner;
};

} // namespace oversketch
#endif
