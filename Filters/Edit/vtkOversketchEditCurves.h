// What the edit's inputs draw: curves of an earlier edit on a mesh that has changed, a profile in its plane.
// Not installed.
#ifndef vtkOversketchEditCurves_h
#define vtkOversketchEditCurves_h

#include "Mesh/context.h"

#include <string>

class vtkPolyData;

namespace oversketch
{

// Throws Error(BadStroke) where the input does not hold exactly one polyline. holder names it ("reference").
void RequireOneCurve(vtkPolyData* curve, const std::string& holder);

// Whether a curve is one that an edit has put out.
bool IsCurveOfEdit(vtkPolyData* curve);

// Such a curve at the nearest places of the mesh, as vtkOversketchProjectCurve would have it.
void LayOnMesh(vtkPolyData* curve, vtkPolyData* mesh, bool closed, const Context& context, vtkPolyData* laid);

// A drawn profile, evenly sampled, in its plane: the samples as they are, or where the view onto the plane
// that they carry has them. Throws Error(BadStroke), Error(MissingArray).
void LayInPlane(vtkPolyData* profile, vtkPolyData* drawn);

} // namespace oversketch
#endif
