// Kernel curves to polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchCurveTools_h
#define vtkOversketchCurveTools_h

#include "Silhouette/curves.h"

#include <vector>

class vtkPolyData;

namespace oversketch
{

// Writes polylines (a closed curve repeats its first point id at the end) with the point arrays that
// vtkOversketchSilhouette documents. viewNormal gives NormalDotView its sign and scale.
void WriteCurves(const std::vector<Curve>& curves, const std::vector<double>& normalDotView, vtkPolyData* output);

} // namespace oversketch
#endif
