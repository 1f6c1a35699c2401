/**
 * @class vtkOversketchMeanEdge
 * @brief the mean edge length of a mesh as it was loaded
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 8.1: e_avg, which every
 * later retriangulation measures edges by, is computed once, when the mesh is loaded. So a mesh that has it
 * keeps it, whatever was done to it since.
 *
 * Departures: none.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData.
 *
 * Output 0 (Mesh): the input with field array MeanEdge, double: the mean length of its edges, each counted
 * once [model length]; the input's own where it has that, one positive value. All else is passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, also where no edge has a length;
 * MissingArray for a MeanEdge that is not one positive number. A mesh without points gives an empty output
 * silently.
 *
 * Deterministic. Cost: some 0.2 s a million triangles, once for a mesh.
 *
 * @sa vtkOversketchInsertCurve
 */
#ifndef vtkOversketchMeanEdge_h
#define vtkOversketchMeanEdge_h

#include "OversketchFiltersRemeshModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREMESH_EXPORT vtkOversketchMeanEdge : public vtkOversketchFilter
{
public:
  static vtkOversketchMeanEdge* New();
  vtkTypeMacro(vtkOversketchMeanEdge, vtkOversketchFilter);

protected:
  vtkOversketchMeanEdge() = default;
  ~vtkOversketchMeanEdge() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
