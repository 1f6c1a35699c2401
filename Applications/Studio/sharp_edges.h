// Shows the edges of a model that is meant to have some, as a cube, although its points have one normal each.
#ifndef oversketch_studio_sharp_edges_h
#define oversketch_studio_sharp_edges_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace oversketch_studio
{

class SharpEdges
{
public:
  // The mesh as it is to be drawn: with points of its own for each side of an edge that its faces meet in at
  // 60 degrees or more, where it has many such edges for its size or they are long and unbroken; else the
  // mesh itself, as any mesh that is too large to ask. Null gives null.
  vtkSmartPointer<vtkPolyData> look(vtkPolyData* mesh);
  // The same mesh moved, as often as the hand moves: as was decided for it.
  vtkSmartPointer<vtkPolyData> lookMoved(vtkPolyData* mesh) const;

private:
  bool Sharp = false;
};

} // namespace oversketch_studio
#endif
