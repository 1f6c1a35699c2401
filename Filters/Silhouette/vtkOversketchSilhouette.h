/**
 * @class vtkOversketchSilhouette
 * @brief silhouette of a triangle mesh as polylines of vertex and edge points
 *
 * Source: Bao and Howard, "SEED: Sketch-Based 3D Model Deformation", Sec. 3.1, Eq. 1. A vertex with g(v) = 0
 * is a silhouette point; an edge whose ends have g of different sign carries one at alpha v0 + (1 - alpha)
 * v1, alpha = g1 / (g1 - g0), where g(v) = n_v . d(v) and d points to the viewer. Departures: in a
 * perspective view d = eye - v, not normalised, which is exact on a sphere; topology is decided by a
 * simulated sign (g >= 0 counts as +) so that chains never branch.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; its point normals are used where it has them, else
 * angle-weighted ones are computed. Non-manifold edges are tolerated: curves end there, and at mesh
 * borders.
 * Input 1 (Stroke): stroke polydata, for the view it carries (cell arrays ViewTransform,
 * ProjectionTransform, ViewportSize).
 *
 * Output 0: one polyline per curve in world space; a closed curve repeats its first point id at the end.
 * Point arrays:
 * - MeshVertices, vtkIdType[3]: vertices of the input mesh the point hangs on; unused ones repeat the first,
 * - MeshWeights, double[3]: their weights, sum 1; (1, 0, 0) for a vertex point, (alpha, 1 - alpha, 0) on an
 * edge,
 * - Normals, double[3]: interpolated and re-normalised,
 * - NormalDotView, double: n . d / |d|, n_z of the paper.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke. A mesh without
 * points gives an empty output silently.
 *
 * Deterministic. Cost: the first view of a mesh takes adjacency, normals and one pass over vertices and
 * edges; later ones that pass alone. What depends on the mesh stays while its points, polygons and point
 * normals stand, and the result, as the same arrays, while the view does too.
 *
 * @sa vtkOversketchSnake
 */
#ifndef vtkOversketchSilhouette_h
#define vtkOversketchSilhouette_h

#include "OversketchFiltersSilhouetteModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

class OVERSKETCHFILTERSSILHOUETTE_EXPORT vtkOversketchSilhouette : public vtkOversketchFilter
{
public:
  static vtkOversketchSilhouette* New();
  vtkTypeMacro(vtkOversketchSilhouette, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke whose view is used, on port 1.
   */
  void SetStrokeConnection(vtkAlgorithmOutput* stroke) { this->SetInputConnection(1, stroke); }
  void SetStrokeData(vtkPolyData* stroke) { this->SetInputData(1, stroke); }

  /**
   * How many times curves have been extracted: executions that the kept result did not answer.
   */
  vtkGetMacro(ExtractionCount, vtkIdType);

protected:
  vtkOversketchSilhouette();
  ~vtkOversketchSilhouette() override;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchSilhouette(const vtkOversketchSilhouette&) = delete;
  void operator=(const vtkOversketchSilhouette&) = delete;

  vtkIdType ExtractionCount = 0;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
