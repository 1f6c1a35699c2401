// Lines on the ground under the model, a round number apart.
#ifndef oversketch_applications_studio_view_ground_grid_h
#define oversketch_applications_studio_view_ground_grid_h

#include "vtkNew.h"

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class GroundGrid
{
public:
  explicit GroundGrid(vtkRenderer* renderer);
  ~GroundGrid();
  GroundGrid(const GroundGrid&) = delete;
  GroundGrid& operator=(const GroundGrid&) = delete;

  // Under the box of a model, and wider than it.
  void place(const double box[6], int up); // the axis that is: 1 for y, 2 for z
  void setVisible(bool visible);
  void setDark(bool dark);

private:
  vtkNew<vtkPolyData> Lines, Middle; // the middle lines: along x and z
  vtkNew<vtkActor> LineActor, MiddleActor;
};

} // namespace oversketch_studio
#endif
