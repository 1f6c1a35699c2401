// Shows the edges of a model that is meant to have some, as a cube, although its points have one normal each;
// and the creases of lines that were drawn on its surface.
#ifndef oversketch_applications_files_sharp_edges_h
#define oversketch_applications_files_sharp_edges_h

#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

class vtkCellArray;
class vtkPolyData;

namespace oversketch_files
{

class SharpEdges
{
public:
  // The mesh as it is to be drawn: with points of its own for each side of an edge that its faces meet in at
  // 60 degrees or more, where it has many such edges for its size or they are long and unbroken; else the
  // mesh itself, as any mesh that is too large to ask. Any mesh is cut so along lines that augment drew on
  // it, where the faces beside them meet in over 30 degrees. Null gives null.
  vtkSmartPointer<vtkPolyData> look(vtkPolyData* mesh);
  // The same mesh moved, as often as the hand moves: as was decided for it, its edges where they were.
  // Another mesh with its own edges, where it is small.
  vtkSmartPointer<vtkPolyData> lookMoved(vtkPolyData* mesh) const;

private:
  vtkSmartPointer<vtkPolyData> Split;  // null: it has no edges
  vtkNew<vtkIdList> From;              // of each of its points, the point of the mesh
  vtkSmartPointer<vtkCellArray> Faces; // of the mesh
  vtkIdType Points = 0;                // of the mesh
  bool IsSolid = false;                // it has edges all over
};

} // namespace oversketch_files
#endif
