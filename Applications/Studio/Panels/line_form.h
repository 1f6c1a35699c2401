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

// Makes a step of what a line says.
oversketch_session::Step lineStep(vtkPolyData* line);

// Copies a line with the values of such a step.
vtkSmartPointer<vtkPolyData> withLineValues(vtkPolyData* line, const oversketch_session::Values& values);

} // namespace oversketch_studio
#endif
