// The mesh that a system is given, as kernels compute on it: repeated points welded, with what rays meet of
// it, and the way back to the output.
#ifndef vtkOversketchWeldedInput_h
#define vtkOversketchWeldedInput_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "vtkOversketchFilterTools.h"
#include "vtkOversketchWeld.h"

namespace oversketch
{

class SurfaceRays;

class OVERSKETCHFILTERSSYSTEMS_EXPORT WeldedInput
{
public:
  // Takes a mesh; what is kept is made anew only where its points or triangles have changed. Throws
  // Error(BadMesh) as RequirePolygonsOnly and MeshOf do.
  void Feed(vtkPolyData* mesh);
  // Those of the last Feed. The geometry is always the same object, as input of steps.
  vtkPolyData* Geometry() const { return this->Welded; }
  const MeshData& Data() const { return *this->Shared; }
  const MeshKey& Key() const { return this->Seen; }
  vtkIdType VertexOf(vtkIdType point) const { return this->Welding->VertexOf(point); }
  const SurfaceRays& Rays(const Context& context);
  // The mask of each vertex (vtkOversketchMaskArray.h); empty where the mesh has none.
  std::vector<double> MaskOfVertices(vtkPolyData* mesh) const;
  // Writes the mesh with some vertices at other places.
  void Move(vtkPolyData* mesh,
    const std::vector<int>& vertices,
    const std::vector<Vector3>& places,
    vtkPolyData* output) const;

private:
  vtkNew<vtkPolyData> Welded;
  std::unique_ptr<Weld> Welding;
  std::shared_ptr<const MeshData> Shared;
  std::shared_ptr<const SurfaceRays> Scene; // null: not asked for yet
  MeshKey Seen;
};

} // namespace oversketch
#endif
