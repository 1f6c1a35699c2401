// The ends of a line that replaces an outline, led onto it.
#ifndef oversketch_applications_studio_tools_led_ends_h
#define oversketch_applications_studio_tools_led_ends_h

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_studio
{

// The stroke with each end that is nearer than that [px] to its end of the section, which the stroke takes
// hold of, put there, and the last 15 % of its length led along: between an end that misses the outline by a
// hair and the outline that goes on there would be a notch. The stroke itself where there is nothing to lead.
vtkSmartPointer<vtkPolyData> withLedEnds(vtkPolyData* stroke, vtkPolyData* section, double reach);

} // namespace oversketch_studio
#endif
