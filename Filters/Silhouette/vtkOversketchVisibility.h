/**
 * @class vtkOversketchVisibility
 * @brief tells visible from hidden parts of silhouette curves
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.2, Fig. 6. On the image plane
 * curves are cut at cusps (three consecutive points that form an angle below 90 degrees) and where they cross
 * themselves or each other; each part is visible as a whole if at least one of its points is, for smoothing
 * may have covered others. The point test runs every triangle against every point: bounding box, then 2D
 * containment and depth.
 *
 * What the paper leaves open, as chosen here: a triangle does not hide a point whose edge it touches (its
 * one-rings); cut points have no vote, as they lie on the contour that hides, and a part without other points
 * is tested at the middles of its edges; a crossing becomes a point of both curves, at the depth of each;
 * neighbouring visible parts of one curve are joined again, as a T-junction also cuts the curve in front.
 * Departures: a grid over the points finds those that a triangle's box can hold; perspective views, with
 * depth that is affine on screen, where parts at or behind the eye are hidden and triangles that reach there
 * hide nothing.
 *
 * Input 0 (Curves): curves of vtkOversketchSnake or vtkOversketchSilhouette (polylines with MeshVertices,
 * MeshWeights, Normals).
 * Input 1 (Mesh): the mesh that the curves were made from.
 * Input 2 (Stroke): stroke polydata, for the view it carries.
 *
 * Output 0: polylines, curve by curve, along each, with the point arrays that vtkOversketchSilhouette
 * documents; a crossing point has up to three MeshVertices. Joined curves keep the inserted points. Cell
 * arrays:
 * - CurveId, int: the input's polyline that the part belongs to,
 * - Visible, unsigned char: 1 or 0.
 * Nothing else is passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke. No curves give an
 * empty output silently. Points are tested on the back end that is chosen, see SetBackend.
 *
 * Deterministic for any number of threads; the device decides bit for bit like the host where it has double
 * precision, else within 1e-5 of the picture's extent. Cost: one pass over vertices and triangles. The result
 * is kept, as the same arrays, while curves, mesh, view and parameters stand.
 *
 * @sa vtkOversketchSnake vtkOversketchMatch
 */
#ifndef vtkOversketchVisibility_h
#define vtkOversketchVisibility_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchBackendFilter.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchVisibility : public vtkOversketchBackendFilter
{
public:
  static vtkOversketchVisibility* New();
  vtkTypeMacro(vtkOversketchVisibility, vtkOversketchBackendFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The mesh, on port 1.
   */
  void SetMeshConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetMeshData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  /**
   * The stroke whose view is used, on port 2.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(2, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(2, stroke); }

  ///@{
  /**
   * Whether neighbouring visible parts of one curve become one polyline again. Default on; off leaves all
   * parts.
   */
  vtkSetMacro(Rejoin, bool);
  vtkGetMacro(Rejoin, bool);
  vtkBooleanMacro(Rejoin, bool);
  ///@}

  /**
   * How many times visibility has been tested: executions that the kept result did not answer.
   */
  vtkGetMacro(TestCount, vtkIdType);

protected:
  vtkOversketchVisibility();
  ~vtkOversketchVisibility() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchVisibility(const vtkOversketchVisibility&) = delete;
  void operator=(const vtkOversketchVisibility&) = delete;

  bool Rejoin = true;
  vtkIdType TestCount = 0;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
