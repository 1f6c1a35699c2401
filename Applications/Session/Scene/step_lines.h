// Where a step was drawn: its stroke with its view, and that stroke on a surface, wherever it is seen from.
#ifndef oversketch_applications_session_scene_step_lines_h
#define oversketch_applications_session_scene_step_lines_h

#include "session.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkStaticCellLocator;

namespace oversketch_session
{

// The first stroke that a step was given, with its view, by itself or by the step that it takes it of; null
// where it has none.
vtkSmartPointer<vtkPolyData> strokeOf(const Model& model, const Step& step);

// The stroke [px, with its view] laid on the nearest places of a surface, at the depth of what it took hold
// of (a polyline in the world). Polylines in the world, in pieces where the surface is farther away than
// `reach`; null where nothing lies on it.
vtkSmartPointer<vtkPolyData> strokeOn(vtkStaticCellLocator* surface,
  vtkPolyData* stroke,
  vtkPolyData* hold,
  double reach);

} // namespace oversketch_session
#endif
