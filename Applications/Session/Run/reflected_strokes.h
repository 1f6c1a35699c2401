// Strokes as a mirror shows them, for systems that take several at once.
#ifndef oversketch_applications_session_run_reflected_strokes_h
#define oversketch_applications_session_run_reflected_strokes_h

#include "step.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace oversketch_session
{

// The strokes, and then each once more as if it had been drawn in the mirror: x counted from the other side
// of the picture, the view reflected, so that it stays right-handed. Where the strokes carry no sound views
// they come back alone: the system says what is wrong with them.
vtkSmartPointer<vtkPolyData> withReflections(vtkPolyData* strokes, const MirrorPlane& plane);

} // namespace oversketch_session
#endif
