// Kernel curves to polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchCurveTools_h
#define vtkOversketchCurveTools_h

#include "Mesh/view.h"
#include "Silhouette/curves.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace oversketch
{

// Writes polylines (a closed curve repeats its first point id at the end) with the point arrays that
// vtkOversketchSilhouette documents; NormalDotView is n . d / |d| of the view.
void WriteCurves(const std::vector<Curve>& curves, const View& view, vtkPolyData* output);

// Curves that ReadCurves finds: curve i is cell i of the polydata.
struct CurveSet
{
  std::vector<Curve> Curves;
  std::vector<int> Ids;      // cell array CurveId, the cell's own index where there is none
  std::vector<char> Visible; // cell array Visible, 1 where there is none
};

// The counterpart of WriteCurves. holder names the input in messages ("silhouette curves"). Throws what
// ReadBindings throws, Error(MissingArray) for another absent or wrongly shaped array and Error(BadMesh) for
// a cell that is no polyline or a point that is not finite.
CurveSet ReadCurves(vtkPolyData* input,
  int meshVertices,
  const std::string& holder,
  Unbound unbound = Unbound::Refused);

// All that a step of this module reads of curves, and of a mesh.
MeshKey CurvesKey(vtkPolyData* curves);
MeshKey SurfaceKey(vtkPolyData* mesh);

} // namespace oversketch
#endif
