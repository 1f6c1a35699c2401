// Places at which outlines are traced, and drawings put together, for the system of this module. Not
// installed.
#ifndef vtkOversketchTraceTools_h
#define vtkOversketchTraceTools_h

#include "Mesh/mesh.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// The places that a list names; (-1, -1) where it says auto. Throws Error(BadStroke) for what is none.
std::vector<Vector2> TracedPlaces(const std::string& list);

// Two drawings as one. What strokes say of themselves stays, where those of one alone say it, too.
vtkSmartPointer<vtkPolyData> JoinedDrawings(vtkPolyData* first, vtkPolyData* second);

} // namespace oversketch
#endif
