// The part of a mesh that a step moved, orange over the model.
#ifndef oversketch_widgets_pen_moved_region_h
#define oversketch_widgets_pen_moved_region_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkNew.h"

class vtkActor;
class vtkPolyData;
class vtkPolyDataNormals;

namespace oversketch
{

class OVERSKETCHWIDGETSPEN_EXPORT MovedRegion
{
public:
  MovedRegion();
  ~MovedRegion();

  // Null or one without polygons shows none.
  void show(vtkPolyData* region);
  bool isShown() const;
  vtkActor* actor() { return this->Actor; }

private:
  vtkNew<vtkPolyDataNormals> Normals;
  vtkNew<vtkActor> Actor;
};

} // namespace oversketch
#endif
