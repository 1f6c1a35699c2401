// How the points of a system's output follow while the deformation that they were made of is dragged. Not
// installed.
#ifndef vtkOversketchFollowers_h
#define vtkOversketchFollowers_h

#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkOversketchLaplacianDeform;
class vtkPolyData;

namespace oversketch
{

class Weld;

class Followers
{
public:
  // Of an output that Weld::Move made of a deformation.
  Followers(vtkPolyData* output, const Weld& welding, vtkPolyData* deformed);
  // Of an output whose points are the given vertices of restored, a mesh that was remeshed from a deformation
  // (vtkOversketchRemesh: SourceCell, SourceWeights): each stays where it lies in its triangle of that.
  Followers(vtkPolyData* output, std::vector<int> vertices, vtkPolyData* deformed, vtkPolyData* restored);

  bool Fits(vtkPoints* points) const;
  // Asks the step, whose output `deformed` was, where its points go.
  bool Place(vtkOversketchLaplacianDeform* step, const double translation[3], vtkPoints* points);

private:
  struct Binding
  {
    std::array<vtkIdType, 3> vertices{};
    std::array<double, 3> weights{};
  };
  void Bind();

  vtkSmartPointer<vtkPoints> Rest, Before;         // of the output, of the deformation
  vtkSmartPointer<vtkPolyData> Deformed, Restored; // shallow copies, null where nothing was remeshed
  vtkNew<vtkPoints> Dragged;                       // of the deformation; empty until the first drag
  std::vector<int> Vertices;                       // per point of the output, of what it was made from
  std::vector<Binding> Bindings;                   // per vertex of the remeshed mesh, to the deformation
};

} // namespace oversketch
#endif
