// A drawing's line in the form: a row as a system has, and a step of it that says what the line says of its
// body.
#ifndef oversketch_applications_studio_panels_line_form_h
#define oversketch_applications_studio_panels_line_form_h

#include "step.h"
#include "systems.h"

#include "vtkSmartPointer.h"

namespace oversketch_studio
{

// Depth, height, cross-section.
const oversketch_session::SystemRow& lineRow();

// What a line of a drawing says; the drawing's height where it says none.
oversketch_session::Step lineStep(vtkPolyData* line, const oversketch_session::Step& drawing);

// A copy of a line that says the values of such a step; no height where it is the drawing's.
vtkSmartPointer<vtkPolyData> withLineValues(vtkPolyData* line,
  const oversketch_session::Values& values,
  const oversketch_session::Step& drawing);

} // namespace oversketch_studio
#endif
