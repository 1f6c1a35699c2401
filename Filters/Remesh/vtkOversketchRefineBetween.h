/**
 * @class vtkOversketchRefineBetween
 * @brief triangles from a line to the ring round it become as small as the way between the two asks for
 *
 * Source: none; R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing" takes the triangles as
 * they come, so that an edit of a coarse mesh has an edge or two to bend. Here triangles are bisected at
 * their longest edge (M.-C. Rivara) where that is longer than a share of the way from line to ring, see
 * Kernels/Remesh/refine_between.h. New points lie on the old triangles.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with field array MeanEdge (vtkOversketchMeanEdge).
 * Input 1 (Reference, optional): the line on the mesh, polylines with point array MeshCell, the polygon of
 * each point (vtkOversketchProjectCurve). Without line or ring the mesh is passed.
 * Input 2 (Boundary, optional): the ring round it, alike.
 *
 * Output 0 (Mesh): the mesh. Where it is fine enough along both curves, the input. Else points are those of
 * the input, then new ones; point arrays: floating ones interpolated (the active normals re-normalised),
 * others from the vertex of largest weight; cell arrays: those of the triangle that was there. Field data is
 * passed. Global ids and the arrays of a 4-8 mesh are dropped. Added is point array EdgeLength, double: the
 * length of edges that the way asks for, MeanEdge at most [model length], which vtkOversketchRetriangulate
 * reads.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray without MeanEdge or MeshCell;
 * BadStroke for curves that are no polylines on the mesh. A mesh without points gives an empty output
 * silently.
 *
 * Deterministic. Cost: a millisecond where nothing is to be done, else some 50 a million triangles of the
 * mesh and 10 microseconds a new one. The result is kept while all that it is made from stands.
 *
 * @sa vtkOversketchInsertCurve vtkOversketchRetriangulate
 */
#ifndef vtkOversketchRefineBetween_h
#define vtkOversketchRefineBetween_h

#include "OversketchFiltersRemeshModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREMESH_EXPORT vtkOversketchRefineBetween : public vtkOversketchFilter
{
public:
  static vtkOversketchRefineBetween* New();
  vtkTypeMacro(vtkOversketchRefineBetween, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The curves on the mesh, on ports 1 and 2.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }
  void SetBoundaryConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(2, curve); }
  void SetBoundaryData(vtkPolyData* curve) { this->SetInputData(2, curve); }
  ///@}

  ///@{
  /**
   * How many edges are asked for from line to ring, of which a few fewer come out [0 to 100, default 7, which
   * makes six; 0, as published: the mesh is passed].
   */
  vtkSetClampMacro(Edges, double, 0.0, 100.0);
  vtkGetMacro(Edges, double);
  ///@}

protected:
  vtkOversketchRefineBetween();
  ~vtkOversketchRefineBetween() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Edges = 7.0;
};

#endif
