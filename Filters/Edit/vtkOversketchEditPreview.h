// The mesh with both curves in it, in the user's terms, and its region as an edit moves it: what is shown
// while something is dragged, and what comes out where no new triangles are asked for. Not installed.
#ifndef vtkOversketchEditPreview_h
#define vtkOversketchEditPreview_h

#include "vtkOversketchKept.h"
#include "vtkOversketchWeld.h"

#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <vector>

class vtkDataArray;
class vtkPoints;

namespace oversketch
{

class EditPreview
{
public:
  // start: the mesh that came in, plain, welded; rest: that with the curves as edges, EditRegion, the arrays
  // that AddPlaces and the welding gave it, and active normals. Made where rest is another one than it was.
  void Provide(const Weld& welding,
    vtkPolyData* plain,
    vtkPolyData* start,
    vtkPolyData* rest,
    const Context& context);

  // The mesh where the region is as in moved, which has rest's points and active normals. What the last call
  // wrote into edited is written over, so that only the region's points and normals are new; else all is.
  void Write(vtkPolyData* moved, vtkPolyData* edited);

  // Whether the user's mesh has normals; those of a preview are shown in any case.
  bool HasNormals() const { return this->Rest->GetPointData()->GetNormals() != nullptr; }

  // The vertex of rest that each point is.
  const std::vector<int>& Vertices() const { return this->VertexOf; }

private:
  StepKey Seen;
  vtkNew<vtkPolyData> Rest;                  // in the user's terms
  vtkSmartPointer<vtkDataArray> RestNormals; // of its vertices
  std::vector<int> VertexOf;
  std::vector<vtkIdType> Live; // points at or beside what may move
  vtkSmartPointer<vtkPoints> Points;
  vtkSmartPointer<vtkDataArray> Normals; // that the last call wrote
};

} // namespace oversketch
#endif
