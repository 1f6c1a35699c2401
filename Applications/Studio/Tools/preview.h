// The mesh under the hand while a stroke is moved: points that follow, and the normals that change with them.
#ifndef oversketch_applications_studio_tools_preview_h
#define oversketch_applications_studio_tools_preview_h

#include "evaluator.h"
#include "turning_normals.h"

#include "vtkSmartPointer.h"

#include <memory>

namespace oversketch_studio
{

class Preview
{
public:
  using Following = std::shared_ptr<const oversketch_session::Following>;

  // Moves points of a mesh with as many points as `following` says, which stays as it is.
  Preview(vtkPolyData* rest, const Following& following);

  // The mesh with the stroke moved by a vector [world].
  void moveTo(const double by[3]);
  vtkPolyData* mesh() const { return this->Shown; }
  vtkPolyData* rest() const { return this->Rest; }

private:
  vtkSmartPointer<vtkPolyData> Rest, Shown;
  Following Followed;
  TurningNormals Normals;
};

} // namespace oversketch_studio
#endif
