// Several strokes in one polydata, taken apart and put together.
#ifndef oversketch_widgets_edit_stroke_list_h
#define oversketch_widgets_edit_stroke_list_h

#include "vtkSmartPointer.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

// Each polyline by itself, with its own points and arrays; of null none.
std::vector<vtkSmartPointer<vtkPolyData>> strokesOf(vtkPolyData* all);

// Into one that stays the same object.
void putInto(vtkPolyData* all, const std::vector<vtkSmartPointer<vtkPolyData>>& strokes);

} // namespace oversketch
#endif
