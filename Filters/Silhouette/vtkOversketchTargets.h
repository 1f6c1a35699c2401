/**
 * @class vtkOversketchTargets
 * @brief control points of the matched section and where the stroke wants them
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.4, Eqs. 4 to 7. Section point q_j
 * at relative length r_j goes to the stroke's place at the same relative length, on its own depth (p*_j);
 * near both ends it is merged with q_j: p'_j = f(r_j) p*_j + (1 - f(r_j)) q_j. Departures: the second branch
 * of Eq. 7 is misprinted, it is read as f(r) = sqrt((1 - r) / omega) for r > 1 - omega, the form that
 * symmetry and f(1) = 0 force; lengths of the section are taken in the image plane, like the stroke's, so
 * that a stroke traced on the section moves nothing; in a perspective view a target lies on the plane through
 * q_j parallel to the image plane; the Offset of a point from the outline it was attached to
 * (specification 13.1) is added back, turned by the angle between section and stroke. With SingleLayer
 * (specification 13.3), of control points on several layers of the mesh that share an outline, those of the
 * layer that covers most of the section are kept, and further ones geodesically within 2.5 times their gap
 * along the section + 6 edges of them.
 *
 * Input 0 (Section): the section from vtkOversketchMatch: one polyline; point arrays MeshVertices,
 * MeshWeights, Normals and, optionally, Display and Offset.
 *
 * Input 1 (Stroke): exactly one stroke with its view (cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize).
 *
 * Input 2 (Mesh): the triangle mesh the section hangs on.
 *
 * Output 0: the handles: one vertex cell per control point, at its present place q_j. Point arrays:
 * - HandleId, vtkIdType: 0 .. n - 1 along the section,
 * - MeshVertices, vtkIdType[3], and MeshWeights, double[3]: what it hangs on,
 * - Target, double[3] [world]: p'_j,
 * - UnmergedTarget, double[3] [world]: p*_j,
 * - RelativePosition, double: r_j in [0, 1],
 * - MergeRatio, double: f(r_j) in [0, 1], the share of a move of the stroke that the target follows.
 *
 * Field data SectionLength and TargetLength, double [world]: lengths of the curves of q_j and of p'_j,
 * smoothed by five taps, since control points lie to and fro across the curve.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke; NoMatch when
 * fewer than two points of the section hang on the mesh or on one layer of it. A mesh or section without
 * points gives an empty output silently.
 *
 * Deterministic. Cost: linear in section and stroke; with several layers, one bounded search over edge paths
 * for each.
 *
 * @sa vtkOversketchMatch, vtkOversketchLaplacianDeform
 */
#ifndef vtkOversketchTargets_h
#define vtkOversketchTargets_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchTargets : public vtkOversketchFilter
{
public:
  static vtkOversketchTargets* New();
  vtkTypeMacro(vtkOversketchTargets, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke with its view, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  /**
   * The mesh that the section hangs on, on port 2.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(2, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(2, mesh); }

  ///@{
  /**
   * Part of the section at either end over which targets blend into the present places [fraction of its
   * length, 0.001 to 0.5, default 0.2; omega of the paper].
   */
  vtkSetClampMacro(Omega, double, 0.001, 0.5);
  vtkGetMacro(Omega, double);
  ///@}

  ///@{
  /**
   * Keep the control points of one layer of the mesh; off: all, as published [default on].
   */
  vtkSetMacro(SingleLayer, bool);
  vtkGetMacro(SingleLayer, bool);
  vtkBooleanMacro(SingleLayer, bool);
  ///@}

protected:
  vtkOversketchTargets();
  ~vtkOversketchTargets() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchTargets(const vtkOversketchTargets&) = delete;
  void operator=(const vtkOversketchTargets&) = delete;

  double Omega = 0.2;
  bool SingleLayer = true;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
