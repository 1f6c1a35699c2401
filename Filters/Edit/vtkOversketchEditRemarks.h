// Remarks on an edit that is not as drawn. Not installed.
#ifndef vtkOversketchEditRemarks_h
#define vtkOversketchEditRemarks_h

#include "Mesh/context.h"

#include <string>

class vtkPolyData;

namespace oversketch
{

// Edges of an edit's region and of its ring whose two triangles' normals are over 120 degrees apart.
int FoldsIn(vtkPolyData* mesh);

// Pairs of triangles that pass through each other, of which one at least is of an edit's region.
int CrossingsIn(vtkPolyData* mesh, const Context& context);

// How deep a profile that was drawn anew goes into the model, square to the surface, over how thick that is
// there; 0 where it comes out nowhere. section: flat, with field array ProfileMatrix and point array CurveT;
// drawn: what it became, with SourceT; ground: the model.
double DepthInThickness(vtkPolyData* section,
  vtkPolyData* drawn,
  vtkPolyData* ground,
  const Context& context);

struct EditFigures
{
  bool isProfile = false;
  int folds = 0, crossings = 0;
  double depth = 0.0;     // see DepthInThickness
  double shareSeen = 1.0; // of the ring
};

Message RemarkOf(const EditFigures& figures);

} // namespace oversketch
#endif
