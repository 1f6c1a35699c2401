// The plane that a step acts on both sides of, through the model.
#ifndef oversketch_applications_studio_view_mirror_sheet_h
#define oversketch_applications_studio_view_mirror_sheet_h

#include "step.h"

#include "vtkNew.h"

#include <optional>

class vtkActor;
class vtkPlaneSource;
class vtkPolyData;
class vtkRenderer;

namespace oversketch_studio
{

class MirrorSheet
{
public:
  MirrorSheet();
  ~MirrorSheet();

  void addTo(vtkRenderer* renderer);
  // A little larger than the mesh; none hides it, and so does null.
  void show(const std::optional<oversketch_session::MirrorPlane>& plane, vtkPolyData* mesh);
  void setVisible(bool visible);
  bool isVisible() const;
  void setDark(bool dark);

private:
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Actor, Border; // the border is a line, which is seen edge-on too
};

} // namespace oversketch_studio
#endif
