// Kernel curves to polydata and back, for the filters of this module. Not installed.
#ifndef vtkOversketchCurveTools_h
#define vtkOversketchCurveTools_h

#include "Mesh/view.h"
#include "Silhouette/curves.h"
#include "vtkOversketchBindings.h"
#include "vtkOversketchFilterTools.h"

#include "vtkSmartPointer.h"

#include <functional>
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

// The counterpart of WriteCurves. holder names the input in messages ("silhouette curves"). Throws what
// ReadBindings throws, Error(MissingArray) for another absent or wrongly shaped array and Error(BadMesh) for
// a cell that is no polyline or a point that is not finite.
CurveSet ReadCurves(vtkPolyData* input,
  int meshVertices,
  const std::string& holder,
  Unbound unbound = Unbound::Refused);

// What a step of this module has read: its result stands while this does. Null inputs are allowed.
class StepKey
{
public:
  StepKey() = default;
  StepKey(vtkPolyData* curves, vtkPolyData* mesh, const View& view, const std::vector<double>& parameters);
  bool operator==(const StepKey& other) const
  {
    return this->Curves == other.Curves && this->Mesh == other.Mesh && this->Values == other.Values;
  }

private:
  MeshKey Curves, Mesh;
  std::vector<double> Values;
};

// The last result of a step, so that the same question is answered with the same arrays.
class KeptCurves
{
public:
  // Copies the kept result, shallowly, to the output; first has it made where the key is a new one.
  void Provide(const StepKey& key, vtkPolyData* output, const std::function<void(vtkPolyData* result)>& make);

private:
  StepKey Key;
  vtkSmartPointer<vtkPolyData> Result;
};

} // namespace oversketch
#endif
