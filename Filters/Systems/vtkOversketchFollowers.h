// How the points of a system's output follow while the deformation that they were made of is dragged.
#ifndef vtkOversketchFollowers_h
#define vtkOversketchFollowers_h

#include "OversketchFiltersSystemsModule.h" // For export macro

#include "Mesh/place.h"

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <vector>

class vtkPolyData;

namespace oversketch
{

class Weld;

class OVERSKETCHFILTERSSYSTEMS_EXPORT Followers
{
public:
  // Follows an output that Weld::Move made of a deformation.
  Followers(vtkPolyData* output, const Weld& welding, vtkPolyData* deformed);
  // Follows an output whose points are the given vertices of restored, a mesh that was remeshed from a
  // deformation (vtkOversketchRemesh: SourceCell, SourceWeights): each stays where it lies in its triangle of
  // that.
  Followers(vtkPolyData* output, std::vector<int> vertices, vtkPolyData* deformed, vtkPolyData* restored);

  bool Fits(vtkPoints* points) const;
  // How the step whose output `deformed` was places its points: writes where the translation takes them into
  // a copy of its output's points, double; false where it cannot.
  using Drag = std::function<bool(const double translation[3], vtkPoints* points)>;
  // Writes the places of the output's points under that drag; false where it cannot.
  bool Place(const Drag& drag, const double translation[3], vtkPoints* points);

private:
  void Bind();

  vtkSmartPointer<vtkPoints> Rest, Before;         // of the output, of the deformation
  vtkSmartPointer<vtkPolyData> Deformed, Restored; // shallow copies, null where nothing was remeshed
  vtkNew<vtkPoints> Dragged;                       // of the deformation; empty until the first drag
  std::vector<int> Vertices;                       // per point of the output, of what it was made from
  std::vector<Binding> Bindings;                   // per vertex of the remeshed mesh, to the deformation
};

} // namespace oversketch
#endif
