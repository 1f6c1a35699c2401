// A coarser skin in place of a large mesh while the hand moves. Its triangles are between some of the mesh's
// own points: it wears what those wear, and follows where they are moved.
#ifndef oversketch_applications_studio_view_coarse_skin_h
#define oversketch_applications_studio_view_coarse_skin_h

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkCellArray;

namespace oversketch_studio
{

class CoarseSkin
{
public:
  // Makes one of so many triangles at most, where it is not known for these faces, which takes about as long
  // as a frame. There is none where so few show no form.
  void make(vtkPolyData* mesh, vtkIdType most);
  void clear();
  // The skin that stands in for a mesh; null where none was made of its faces.
  vtkPolyData* of(vtkPolyData* mesh);

private:
  bool isOf(vtkPolyData* mesh) const;

  vtkSmartPointer<vtkCellArray> Whole; // that it was made of
  vtkSmartPointer<vtkCellArray> Faces; // null: none
  vtkNew<vtkPolyData> Shown;
  vtkMTimeType Time = 0; // of the mesh that it is shown for
};

} // namespace oversketch_studio
#endif
