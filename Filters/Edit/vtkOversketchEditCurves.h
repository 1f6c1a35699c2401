// Curves that the edit's inputs draw: curves and what redraws them, curves of an earlier edit on a mesh that
// has changed. Not installed.
#ifndef vtkOversketchEditCurves_h
#define vtkOversketchEditCurves_h

#include "Mesh/context.h"

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataObject;
class vtkPolyData;

namespace oversketch
{

// The polylines of an input, each as a polydata of its own. One that has not changed by a bit stays the same
// object, so that what was made of it stands.
class DrawnLines
{
public:
  // Throws Error(BadStroke) where there is no polyline, or there are other cells. holder names the input
  // ("reference").
  void Read(vtkPolyData* input, const std::string& holder);
  const std::vector<vtkSmartPointer<vtkPolyData>>& All() const { return this->Lines; }

private:
  std::pair<const vtkDataObject*, vtkMTimeType> Seen{ nullptr, 0 };
  std::vector<vtkSmartPointer<vtkPolyData>> Lines;
};

// Whether a curve is one that an edit has put out.
bool IsCurveOfEdit(vtkPolyData* curve);

// Lays such a curve at the nearest places of the mesh, as vtkOversketchProjectCurve would.
void LayOnMesh(vtkPolyData* curve, vtkPolyData* mesh, bool closed, const Context& context, vtkPolyData* laid);

// Part of a redrawn curve on a mesh (vtkOversketchResketch) that the old one had not: the samples in a row
// that are no vertices, as a stroke in the view that they were drawn in. Of kept the vertices that are, in
// the curve's direction: before and after that row; of a closed curve after it alone, from its end on.
struct RedrawnPart
{
  vtkSmartPointer<vtkPolyData> Stroke; // null: nothing has changed
  std::vector<int> Before, After;
  bool Closed = false;
};
RedrawnPart PartRedrawn(vtkPolyData* redrawn);

// The curve whole, as vtkOversketchProjectCurve would have it: projected is that part on the mesh. Of a
// closed curve a run ends where the part does not reach what is kept, so that the gap is bridged.
void LayRedrawn(const RedrawnPart& part, vtkPolyData* projected, vtkPolyData* mesh, vtkPolyData* laid);

// A profile drawn over one that was itself drawn over another: its SourceT becomes that of the first.
void FollowSources(vtkPolyData* before, vtkPolyData* redrawn);

} // namespace oversketch
#endif
