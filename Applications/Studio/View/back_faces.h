// Faces that look away from the eye. Those of a body are behind its others, but for slivers at its outline,
// so that the processor need not draw them, which is up to two fifths of a frame's work. Where a body reaches
// through itself, turned inside out, one sees through it meanwhile.
#ifndef oversketch_applications_studio_view_back_faces_h
#define oversketch_applications_studio_view_back_faces_h

#include "vtkType.h"

class vtkCellArray;
class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class BackFaces
{
public:
  // Whether other faces hide them: of a body that the near plane does not cut open.
  bool areHidden(vtkPolyData* mesh, vtkRenderer* renderer);

  // Whether the faces bound a body: along each edge they cancel out, and each part holds a volume.
  static bool boundBody(vtkPolyData* mesh);

private:
  const vtkCellArray* Seen = nullptr; // told by its time as well
  vtkMTimeType Time = 0;
  bool Body = false;
};

} // namespace oversketch_studio
#endif
