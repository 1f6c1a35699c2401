// The normals of a mesh whose points follow the hand: its own, of its file perhaps, turned as its surface
// turns.
#ifndef oversketch_applications_studio_tools_turning_normals_h
#define oversketch_applications_studio_tools_turning_normals_h

#include "Mesh/mesh.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataArray;

namespace oversketch_studio
{

template <typename Visit>
void eachTriangle(vtkPolyData* mesh, const Visit& visit)
{
  const auto iterator = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(size, ids);
    visit(std::array<vtkIdType, 3>{ ids[0], ids[1], ids[2] });
  }
}

// Makes one mesh the same as another, with points and normals of its own.
void copyToMove(vtkPolyData* mesh, vtkPolyData* copy);

class TurningNormals
{
public:
  // Looks at a mesh at rest, of which those points will move.
  void bind(vtkPolyData* rest, const std::vector<vtkIdType>& moving);
  // Gives a mesh of copyToMove the normals that it has at rest, turned to where its points are now.
  void turn(vtkDataArray* normals, vtkPolyData* moved);

private:
  std::vector<oversketch::Vector3> seen(vtkPolyData* mesh);

  // All triangles round points whose normals change; its points, those that change first.
  oversketch::Mesh Patch;
  oversketch::Lists Around;
  std::vector<vtkIdType> Points;
  std::vector<oversketch::Vector3> Before; // at rest, as many as change
};

} // namespace oversketch_studio
#endif
