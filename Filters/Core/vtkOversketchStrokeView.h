/**
 * The view of one of several strokes. Free functions, for use in the .cxx of filters; not wrapped.
 */
#ifndef vtkOversketchStrokeView_h
#define vtkOversketchStrokeView_h

#include "OversketchFiltersCoreModule.h" // For export macro

#include "Mesh/view.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkPolyData;

namespace oversketch
{

/**
 * The cell arrays that a view is read from, those that are there and have the right length.
 */
OVERSKETCHFILTERSCORE_EXPORT std::vector<vtkDataArray*> ViewArraysOf(vtkPolyData* strokes);

/**
 * The view of one stroke, see ViewOf; strokes of one polydata may carry different ones. Names the stroke in
 * what it throws.
 */
OVERSKETCHFILTERSCORE_EXPORT View ViewOfStroke(vtkPolyData* strokes, vtkIdType stroke);

} // namespace oversketch
#endif
