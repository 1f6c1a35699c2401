/**
 * @class vtkOversketchLaplacianDeform
 * @brief moves a region of a triangle mesh so that handles on it reach their targets
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 5.1. The paper gives no formula;
 * this is the usual Laplacian editing: of the displacements u = x' - x, minimise sum_i |sum_j w_ij (u_i -
 * u_j)|^2 + wc^2 sum_h |u(handle h) - d_h|^2,   w_ij = (cot A + cot B) / 2, with u = 0 on and outside the
 * region's border. With AdjustNormals, T_i = s I + [h]x is fitted to the one-ring of each vertex, linear in
 * u, and row i becomes T_i delta_i - delta'_i, delta_i = sum_j w_ij (x_i - x_j). Departures: one Cholesky
 * factor serves x, y and z (the paper makes three); the border is held hard and the handles softly, as hard
 * handles on a strip of edges are ill-conditioned; cotangents are clamped to +-1000, negative ones kept.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point array Region (1 component, not 0 = in the
 * region), see vtkOversketchRegionBorder. A vertex of the region with a neighbour outside it is the border
 * and stays; a vertex on a border of the mesh itself is free. Non-manifold edges and degenerate triangles
 * are tolerated.
 * Input 1 (Handles): handles, see vtkOversketchTargets: points at the present world positions, with point
 * arrays
 * - MeshVertices, 3 components: vertices of the mesh the handle hangs on,
 * - MeshWeights, 3 components: their weights, sum 1,
 * - Target, 3 components: where the handle shall be [world]. d_h = Target - position of the point,
 * - MergeRatio, 1 component, optional: the share of a drag that the handle follows; 1 without it.
 * A handle all of whose vertices are fixed is ignored; a piece of the region without a handle stays.
 *
 * Output 0: the mesh with moved points, double where the input's are double, else float. Points outside the
 * region, and all points if every handle is at its target, are bit for bit those of the input. Active point
 * and cell normals are computed anew where a triangle moved; all other arrays and the cells are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadRegion (nothing can move,
 * or no handle inside the region), SolveFailed. A mesh without points gives an empty output silently.
 *
 * Deterministic. Cost: one sparse factorisation (kept while points, polygons, Region, the handles' bindings
 * and the properties stand), then one back-substitution for x, y and z together per change of a target. Can
 * be cancelled at any time.
 *
 * @sa vtkOversketchTargets vtkOversketchRegionBorder vtkOversketchRemesh
 */
#ifndef vtkOversketchLaplacianDeform_h
#define vtkOversketchLaplacianDeform_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

class vtkPoints;

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchLaplacianDeform : public vtkOversketchFilter
{
public:
  static vtkOversketchLaplacianDeform* New();
  vtkTypeMacro(vtkOversketchLaplacianDeform, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The handles, on port 1.
   */
  void SetHandlesConnection(vtkAlgorithmOutput* handles) { this->SetInputConnection(1, handles); }
  void SetHandlesData(vtkPolyData* handles) { this->SetInputData(1, handles); }
  ///@}

  ///@{
  /**
   * Whether each one-ring may rotate and scale, so that details turn with the limb (the paper's "AdjNorm").
   * Denser, one system for all components: slower. Default off, as in the paper.
   */
  vtkSetMacro(AdjustNormals, bool);
  vtkGetMacro(AdjustNormals, bool);
  vtkBooleanMacro(AdjustNormals, bool);
  ///@}

  ///@{
  /**
   * Weight wc of a handle against a vertex's Laplacian [1]. Range [1e-3, 1e6], default 10; 100 folds
   * triangles.
   */
  vtkSetClampMacro(HandleWeight, double, 1e-3, 1e6);
  vtkGetMacro(HandleWeight, double);
  ///@}

  /**
   * Preview of the output for all targets moved by their share of one vector [world], as a hand drags a
   * stroke: writes the places of the vertices that can move into `points`, which are a copy of the last
   * output's points (same number, float or double), and leaves the others alone. The answer is that of an
   * Update with such targets up to rounding, as it is linear in them. The first call after a change solves
   * for one column, the next ones take one multiplication per coordinate. Neither the output nor the pipeline
   * changes: to keep the place, move the targets and Update. False, with an error, before the first Update or
   * when `points` do not fit.
   */
  bool Drag(const double translation[3], vtkPoints* points);

  ///@{
  /**
   * Gives back the factor alone, once what Drag takes of it is computed; or all that was kept, and the
   * output, which the next Update makes anew.
   */
  void ReleaseFactor();
  void ReleaseWork();
  ///@}

  ///@{
  /**
   * Orders of elimination found (one that another filter holds for the same mesh and the same vertices to
   * move is shared, not found again), factors made, and targets solved for (x, y and z count as one; so does
   * what Drag solves for), since the filter was made.
   */
  vtkGetMacro(AnalysisCount, vtkIdType);
  vtkGetMacro(FactorizationCount, vtkIdType);
  vtkGetMacro(SolveCount, vtkIdType);
  ///@}

  ///@{
  /**
   * Distance of the handles from where they were pulled, over the handles not ignored, after the last
   * execution [model length]; 0 before the first.
   */
  vtkGetMacro(MeanHandleResidual, double);
  vtkGetMacro(MaximumHandleResidual, double);
  ///@}

  ///@{
  /**
   * Vertices that could move and handles not ignored in the last execution.
   */
  vtkGetMacro(MovableCount, vtkIdType);
  vtkGetMacro(ActiveHandleCount, vtkIdType);
  ///@}

protected:
  vtkOversketchLaplacianDeform() { this->SetNumberOfInputPorts(2); }
  ~vtkOversketchLaplacianDeform() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool AdjustNormals = false;
  double HandleWeight = 10.0;
  vtkIdType AnalysisCount = 0;
  vtkIdType FactorizationCount = 0;
  vtkIdType SolveCount = 0;
  double MeanHandleResidual = 0.0;
  double MaximumHandleResidual = 0.0;
  vtkIdType MovableCount = 0;
  vtkIdType ActiveHandleCount = 0;

  struct Cache;
};

#endif
