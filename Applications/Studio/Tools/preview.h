// The mesh under the hand while a stroke is moved: points that follow, and the normals that change with them.
#ifndef oversketch_applications_studio_tools_preview_h
#define oversketch_applications_studio_tools_preview_h

#include "evaluator.h"

#include "vtkSmartPointer.h"

#include <array>
#include <memory>
#include <vector>

class vtkPolyData;

namespace oversketch_studio
{

class Preview
{
public:
  using Following = std::shared_ptr<const oversketch_session::Following>;

  // Of a mesh with as many points as `following` says, which stays as it is.
  Preview(vtkPolyData* rest, const Following& following);

  // The mesh with the stroke moved by a vector [world].
  void moveTo(const double by[3]);
  vtkPolyData* mesh() const { return this->Shown; }
  vtkPolyData* rest() const { return this->Rest; }

private:
  using Vector = std::array<double, 3>;
  struct Face
  {
    std::array<vtkIdType, 3> points;
    std::array<int, 3> turned; // places in Turned, or -1
  };
  void findTurned();
  std::vector<Vector> normals() const;

  vtkSmartPointer<vtkPolyData> Rest, Shown;
  Following Followed;
  std::vector<vtkIdType> Turned; // points whose normals change
  std::vector<Face> Faces;       // round them
  std::vector<Vector> Before;    // normals of the surface at rest
};

} // namespace oversketch_studio
#endif
