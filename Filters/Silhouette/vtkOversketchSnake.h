/**
 * @class vtkOversketchSnake
 * @brief smooths silhouette curves over the mesh until a pen stroke can be mapped to them
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.1, Eq. 2, Figs. 4 and 5: a greedy
 * snake that raises E_smth(s), the angle at a point between its neighbours on the tangent plane, while
 * E_geo(s) = |n . d| / |d| stays below epsilon. Points are removed (three in one triangle), vertex points
 * split, edge points moved along their edge.
 *
 * What the paper leaves open, as chosen here: n is re-normalised; sweeps go on until one removes and splits
 * nothing and moves no point for a gain above 1e-4 rad (the paper stops without looking at moves, after the
 * first sweep), at most 200 sweeps; a vertex point is split when it bends by more than 0.01 rad, on the side
 * of the smaller angle, into points 0.2 of an edge away (halved until E_geo allows it), at most six times per
 * vertex; a point moves to where E_smth is pi in closed form, else to the best of 33 samples of the interval
 * that E_geo allows, refined by golden section. A sweep goes along up to eight sections of a curve at a time,
 * each from its first point (the paper's along the curve from an end), which is several times quicker.
 *
 * Input 0 (Curves): curves of vtkOversketchSilhouette (polylines with MeshVertices, MeshWeights, Normals).
 * Input 1 (Mesh): the mesh that the curves were made from.
 * Input 2 (Stroke): stroke polydata, for the view it carries.
 *
 * Output 0: curves with the point arrays that vtkOversketchSilhouette documents, in the same order.
 * Consecutive points share a triangle. Open curves keep their ends; a closed curve that shrinks to fewer than
 * three points is dropped. Nothing else is passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke. No curves give an
 * empty output silently.
 *
 * Deterministic for any number of threads: each curve is smoothed by itself. Cost: about five milliseconds
 * for each thousand points. The result is kept, as the same arrays, while curves, mesh, view and Epsilon
 * stand.
 *
 * @sa vtkOversketchSilhouette vtkOversketchVisibility
 */
#ifndef vtkOversketchSnake_h
#define vtkOversketchSnake_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchSnake : public vtkOversketchFilter
{
public:
  static vtkOversketchSnake* New();
  vtkTypeMacro(vtkOversketchSnake, vtkOversketchFilter);
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
   * How far points may leave the true silhouette: the largest |n . d| / |d|, a cosine, in [0, 1]. 0.2, the
   * paper's default, is about 11.5 degrees; at 0 nothing moves. Paper: epsilon.
   */
  vtkSetClampMacro(Epsilon, double, 0.0, 1.0);
  vtkGetMacro(Epsilon, double);
  ///@}

  /**
   * How many times curves have been smoothed: executions that the kept result did not answer.
   */
  vtkGetMacro(SmoothingCount, vtkIdType);

protected:
  vtkOversketchSnake();
  ~vtkOversketchSnake() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchSnake(const vtkOversketchSnake&) = delete;
  void operator=(const vtkOversketchSnake&) = delete;

  double Epsilon = 0.2;
  vtkIdType SmoothingCount = 0;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
