/**
 * @class vtkOversketchStellarRefine
 * @brief makes a 4-8 mesh finer where curves are near, and nowhere else
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-B: the triangles round
 * each vertex that is nearer to a curve than the radius are refined. When that ends is left open there: here
 * at an edge length or generation. Departures, each with a switch: SeedCurveFaces, ConnectedOnly, FineFoot.
 *
 * Input 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase and Filters/Stellar/README.md. Between two points
 * whose point array Mask is 1 (vtkOversketchMask) new ones lie in the middle.
 * Input 1 (Curves): polylines of vtkOversketchSurfaceStroke or vtkOversketchSilhouetteSketch; of their arrays
 * Normals and Pressure are read, and the cell arrays Radius and Sharpness go before parameters.
 * Input 2 (Source, optional): output 1 of vtkOversketchStellarBase or vtkOversketchTerrain, on which new
 * points lie where those of their edge do. What a terrain's mesh carries of that is read where nothing is
 * connected here.
 *
 * Output 0 (Mesh): the 4-8 mesh, refined; points and cells that were not refined are as they were. BaseNormal
 * is there from here on. Other arrays as vtkOversketchStellarBase has it; point normals are mixed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, cell or
 * point, where the mesh is no sound 4-8 mesh or was changed by a filter in between; BadStroke for curves that
 * are none, for others than the mesh is snapped to (field array CurveDigest), and parameters out of range.
 * BadRegion where more than MaximumFaces would be needed. A mesh without points gives an empty output
 * silently, without curves it goes through.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does. Cost: some 0.5
 * microseconds a new face, and a copy of the mesh.
 *
 * @sa vtkOversketchStellarBase vtkOversketchSurfaceStroke vtkOversketchStellarSnap
 */
#ifndef vtkOversketchStellarRefine_h
#define vtkOversketchStellarRefine_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarRefine : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarRefine* New();
  vtkTypeMacro(vtkOversketchStellarRefine, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The curves, on port 1.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }

  /**
   * The source, on port 2.
   */
  void SetSourceConnection(vtkAlgorithmOutput* source) { this->SetInputConnection(2, source); }
  void SetSourceData(vtkPolyData* source) { this->SetInputData(2, source); }

  ///@{
  /**
   * Triangles nearer than this to a curve are refined [model length, default -1: 0.03 of the mesh's
   * diagonal]. A curve's own Radius goes before it.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * Exponent s of the feature's profile (1 - distance / radius)^s, not negative [default 1.5]. A curve's own
   * Sharpness goes before it.
   */
  vtkSetMacro(Sharpness, double);
  vtkGetMacro(Sharpness, double);
  ///@}

  ///@{
  /**
   * Edges longer than this are split [model length, default 0: a quarter of the radius, and see FineFoot].
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Where TargetEdgeLength is 0 and the sharpness below 1: an eighth of the radius, and a thirty-second where
   * the feature ends and no other curve is nearer, which leaves no saw-teeth at the foot; above 2 an eighth,
   * or the crest's flanks look torn [default on; as published: off].
   */
  vtkSetMacro(FineFoot, bool);
  vtkGetMacro(FineFoot, bool);
  vtkBooleanMacro(FineFoot, bool);
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

  ///@{
  /**
   * Refine also triangles that a curve passes through without coming near a vertex [default on; as published:
   * off].
   */
  vtkSetMacro(SeedCurveFaces, bool);
  vtkGetMacro(SeedCurveFaces, bool);
  vtkBooleanMacro(SeedCurveFaces, bool);
  ///@}

  ///@{
  /**
   * No triangle is split more often than so [default 16].
   */
  vtkSetClampMacro(MaximumGeneration, int, 0, 62);
  vtkGetMacro(MaximumGeneration, int);
  ///@}

  ///@{
  /**
   * How many triangles may be added; where more would be needed that is refused as soon as it can be foreseen
   * [default 4000000].
   */
  vtkSetClampMacro(MaximumFaces, int, 1, VTK_INT_MAX);
  vtkGetMacro(MaximumFaces, int);
  ///@}

  /**
   * Sweeps of the last refinement: how many times all triangles were looked at.
   */
  vtkGetMacro(Sweeps, int);

  /**
   * How many times a mesh has been refined: executions that the kept result did not answer.
   */
  vtkGetMacro(RefineCount, vtkIdType);

protected:
  vtkOversketchStellarRefine();
  ~vtkOversketchStellarRefine() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  double Radius = -1.0;
  double Sharpness = 1.5;
  double TargetEdgeLength = 0.0;
  bool FineFoot = true;
  int Distance = Straight;
  bool ConnectedOnly = true;
  bool SeedCurveFaces = true;
  int MaximumGeneration = 16;
  int MaximumFaces = 4000000;
  int Sweeps = 0;
  vtkIdType RefineCount = 0;

  struct Cache;
};

#endif
