/**
 * @class vtkOversketchCorrection
 * @brief further control points where the deformed mesh's outline has left the stroke
 *
 * Source: an amendment to Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", not in the paper. The
 * control points of Sec. 3.4 bring the old silhouette to the stroke; where the deformation turns other parts
 * of the surface into the outline (a foot's sole, an instep, an ankle of a bent or stretched limb), these
 * stand out and the outline misses the stroke by several pixels. This step looks at the deformed mesh and
 * makes control points of the region's vertices that are its outline now and off the stroke: each is to
 * shift, parallel to the image plane, as the outline beside it must shift to lie on the stroke. Only the
 * stroke's part from Omega to 1 - Omega counts, where the targets are not merged with the present places.
 * Deforming the original mesh with these handles too gives the corrected result.
 *
 * Input 0 (Handles): handles (vtkOversketchTargets), that the mesh was deformed with.
 * Input 1 (Stroke): the stroke with its view.
 * Input 2 (Deformed mesh): the deformed triangle mesh with point array Region
 * (vtkOversketchLaplacianDeform).
 * Input 3 (Mesh before): the same mesh before, with the same points and cells.
 *
 * Output 0: the handles, then one vertex cell for each new one at its place on the mesh before; its arrays go
 * on: HandleId; MeshVertices and MeshWeights name the one vertex; Target and UnmergedTarget, double[3]
 * [world]; RelativePosition, double, of the place on the stroke; MergeRatio, 1. Other point arrays are
 * dropped where handles are added, field data are passed. Without new handles the input handles are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh (also for meshes of different size),
 * MissingArray, BadStroke. A mesh or handles without points give an empty output silently.
 *
 * Deterministic. Cost: one trace of the outline, linear in triangles.
 *
 * @sa vtkOversketchTargets, vtkOversketchLaplacianDeform
 */
#ifndef vtkOversketchCorrection_h
#define vtkOversketchCorrection_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchCorrection : public vtkOversketchFilter
{
public:
  static vtkOversketchCorrection* New();
  vtkTypeMacro(vtkOversketchCorrection, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Part of the stroke at either end that is left alone [fraction of its length, 0.001 to 0.5, default 0.2]:
   * the Omega of vtkOversketchTargets.
   */
  vtkSetClampMacro(Omega, double, 0.001, 0.5);
  vtkGetMacro(Omega, double);
  ///@}

  ///@{
  /**
   * How far the outline may be off the stroke and stay [px, 0 or more, default 1]; fewer new control points
   * fold fewer triangles.
   */
  vtkSetClampMacro(Tolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * How far it may be off and still be meant by the stroke [px, 0 or more, default 12].
   */
  vtkSetClampMacro(Reach, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Reach, double);
  ///@}

protected:
  vtkOversketchCorrection();
  ~vtkOversketchCorrection() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchCorrection(const vtkOversketchCorrection&) = delete;
  void operator=(const vtkOversketchCorrection&) = delete;

  double Omega = 0.2;
  double Tolerance = 1.0;
  double Reach = 12.0;
};

#endif
