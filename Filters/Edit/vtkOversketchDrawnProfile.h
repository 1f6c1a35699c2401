// A profile as a hand has drawn it: into the section's plane, and whether it can be followed. Not installed.
#ifndef vtkOversketchDrawnProfile_h
#define vtkOversketchDrawnProfile_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// A drawn profile, sampled finely, in its plane: the samples as they are, or where the view onto the plane
// that they carry has them. who names it at the beginning of a sentence. Throws Error(BadStroke) for one
// that no section can be: without length, closed, crossing itself, or drawn in a view that looks at the
// plane askew; Error(MissingArray).
void LayInPlane(vtkPolyData* profile, const std::string& who, vtkPolyData* drawn);

// Throws Error(BadStroke) where an end of a profile lies far from the flat section that it redraws.
void RequireEndsBeside(vtkPolyData* section, vtkPolyData* drawn, const std::string& who);

// Throws Error(BadStroke) where a stroke of these was drawn in the view of one of the lines on the model, and
// so on the model itself. plane says what it is to be drawn on ("the section").
void RequireOtherView(vtkPolyData* strokes,
  const std::vector<vtkSmartPointer<vtkPolyData>>& lines,
  const std::string& who,
  const std::string& plane);

} // namespace oversketch
#endif
