// Feature curves from polydata, for the filters of this module and for systems made of them. Not installed.
#ifndef vtkOversketchStellarCurves_h
#define vtkOversketchStellarCurves_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "Stellar/curves.h"

class vtkPolyData;

namespace oversketch
{

// Curves as vtkOversketchSurfaceStroke writes them. A `height` of 0 means half the radius, for curves with a
// radius of their own half of that. Throws Error(BadStroke) naming the curve.
OVERSKETCHFILTERSSTELLAR_EXPORT FeatureCurves CurvesOf(vtkPolyData* curves, double height = 1.0);

} // namespace oversketch
#endif
