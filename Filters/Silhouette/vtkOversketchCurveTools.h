// Kernel curves to polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchCurveTools_h
#define vtkOversketchCurveTools_h

#include "Mesh/view.h"
#include "Silhouette/curves.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// Writes polylines (a closed curve repeats its first point id at the end) with the point arrays that
// vtkOversketchSilhouette documents; NormalDotView is n . d / |d| of the view.
void WriteCurves(const std::vector<Curve>& curves, const View& view, vtkPolyData* output);

// What ReadCurves finds: curve i is cell i of the polydata.
struct CurveSet
{
  std::vector<Curve> Curves;
  std::vector<int> Ids;      // cell array CurveId, the cell's own index where there is none
  std::vector<char> Visible; // cell array Visible, 1 where there is none
};

// The counterpart of WriteCurves. A binding of three -1 means that the point hangs on nothing and is accepted
// only with allowUnbound. holder names the input in messages ("silhouette curves"). Throws
// Error(MissingArray) for an absent or wrongly shaped array and Error(BadMesh) for a cell that is no
// polyline, a point that is not finite, a mesh vertex outside [0, meshVertices) or weights that are not
// finite or do not sum to 1.
CurveSet ReadCurves(vtkPolyData* input,
  int meshVertices,
  const std::string& holder,
  bool allowUnbound = false);

} // namespace oversketch
#endif
