/**
 * @class vtkOversketchStellarSimplify
 * @brief takes away vertices that a 4-8 mesh does not need
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Secs. I-A and III-B, which
 * schedule simplification and give no rule. Here a vertex goes that lies nearer than a tolerance to the two
 * triangles that it split, from the finest level to the coarsest; what a displacement along the curves moved
 * stays, as do snapped vertices and crests of earlier strokes.
 *
 * Input 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase and Filters/Stellar/README.md. Points whose point
 * array Mask is 1 (vtkOversketchMask) are kept.
 * Input 1 (Curves, optional): polylines of vtkOversketchSurfaceStroke, whose features are kept.
 *
 * Output 0 (Mesh): the 4-8 mesh; what is left of points is as it was. Cell arrays of several cells that
 * became one are those of the first.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, cell or
 * point, where the mesh is no sound 4-8 mesh or was changed by a filter in between; BadStroke for curves that
 * are none and parameters out of range. A mesh without points gives an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does.
 *
 * @sa vtkOversketchStellarRefine vtkOversketchStellarDisplace
 */
#ifndef vtkOversketchStellarSimplify_h
#define vtkOversketchStellarSimplify_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarSimplify : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarSimplify* New();
  vtkTypeMacro(vtkOversketchStellarSimplify, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves, on port 1.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }

  ///@{
  /**
   * How near a vertex is to lie to the triangles that it split; errors of several levels add up. At most half
   * of what a refinement was to keep [model length, default -1: 1e-4 of the mesh's diagonal].
   */
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Within this of a curve nothing goes [model length, default -1: 0.03 of the mesh's diagonal]. A curve's
   * own Radius goes before it.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  enum DistanceType
  {
    Straight = 0,
    Geodesic = 1
  };
  ///@{
  /**
   * Distances through space (default, as published) or over the surface, which do not reach round thin parts.
   */
  vtkSetClampMacro(Distance, int, Straight, Geodesic);
  vtkGetMacro(Distance, int);
  void SetDistanceToStraight() { this->SetDistance(Straight); }
  void SetDistanceToGeodesic() { this->SetDistance(Geodesic); }
  ///@}

  ///@{
  /**
   * With straight distances, reach only what is joined to the curve through what is reached [default on; as
   * published: off].
   */
  vtkSetMacro(ConnectedOnly, bool);
  vtkGetMacro(ConnectedOnly, bool);
  vtkBooleanMacro(ConnectedOnly, bool);
  ///@}

  /**
   * Vertices that the last simplification took away.
   */
  vtkGetMacro(Welded, int);

  /**
   * Number that a point of the last output has in the input, -1 where there is no such point.
   */
  vtkIdType GetInputPoint(vtkIdType point) const;

  /**
   * How many times a mesh has been simplified: executions that the kept result did not answer.
   */
  vtkGetMacro(SimplifyCount, vtkIdType);

protected:
  vtkOversketchStellarSimplify();
  ~vtkOversketchStellarSimplify() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Tolerance = -1.0;
  double Radius = -1.0;
  int Distance = Straight;
  bool ConnectedOnly = true;
  int Welded = 0;
  vtkIdType SimplifyCount = 0;
};

#endif
