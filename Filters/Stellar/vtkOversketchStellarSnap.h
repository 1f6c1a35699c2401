/**
 * @class vtkOversketchStellarSnap
 * @brief moves vertices to where curves cross their edges, so that edges follow the curves
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-C.1: each vertex moves
 * to the nearest crossing of its edges with a curve. Departures, undone by the order AllAtOnce: crossings are
 * taken one by one, the nearest of all first; those that a snapped vertex explains are left alone; moves that
 * would spoil a triangle are refused (an angle under 5 degrees and smaller than before); where edges are
 * still crossed an end goes along a curve, to where it meets another, or they are split
 * (MaximumResidualRounds). Vertices on the border and on seams move along those only. Ours too: steep
 * features get edges along their foot (SnapFoot).
 *
 * Input 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase and Filters/Stellar/README.md. Cell array Chart
 * (optional): one whole number per triangle, as for vtkOversketchRemesh; where neighbours have different ones
 * there is a seam between them. Points whose point array Mask is 1 (vtkOversketchMask) stay.
 * Input 1 (Curves): polylines of vtkOversketchSurfaceStroke or vtkOversketchSilhouetteSketch; of their arrays
 * Normals and Pressure are read, and the cell arrays Radius, Height and Sharpness go before parameters.
 * Input 2 (Source, optional): output 1 of vtkOversketchStellarBase or vtkOversketchTerrain, on which new
 * points lie that residual rounds make away from curves.
 *
 * Output 0 (Mesh): the 4-8 mesh; CurveId and CurveParam of the vertices that lie on curves, StellarMoved with
 * 1, BaseNormal as at their places before, and field array CurveDigest. Other point arrays, normals among
 * them, as at the vertex's new place on the surface before.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, cell or
 * point, where the mesh is no sound 4-8 mesh or was changed by a filter in between; BadStroke for curves that
 * are none, for others than the mesh is snapped to (field array CurveDigest), and parameters out of range.
 * A mesh without points gives an empty output silently, without curves it goes through.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does. Cost: some 10
 * microseconds a crossing, and a copy of the mesh.
 *
 * @sa vtkOversketchStellarRefine vtkOversketchStellarSmooth
 */
#ifndef vtkOversketchStellarSnap_h
#define vtkOversketchStellarSnap_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarSnap : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarSnap* New();
  vtkTypeMacro(vtkOversketchStellarSnap, vtkOversketchFilter);
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

  enum OrderType
  {
    Nearest = 0,
    AllAtOnce = 1
  };
  ///@{
  /**
   * Nearest (default), or as published AllAtOnce: crossings are found once, and every vertex goes to its
   * nearest; then both ends of an edge meet in one point, and triangles collapse and turn over.
   */
  vtkSetClampMacro(Order, int, Nearest, AllAtOnce);
  vtkGetMacro(Order, int);
  void SetOrderToNearest() { this->SetOrder(Nearest); }
  void SetOrderToAllAtOnce() { this->SetOrder(AllAtOnce); }
  ///@}

  ///@{
  /**
   * Rounds that split edges which are crossed in the end [default 2]. 0: vertices move along their own edges
   * and nowhere else.
   */
  vtkSetClampMacro(MaximumResidualRounds, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumResidualRounds, int);
  ///@}

  ///@{
  /**
   * Put vertices also on the foot of features whose sharpness is below 1, and on a rim just inside of it,
   * which else show saw-teeth there: their slope has no bound at the foot. Vertices only move [default on; as
   * published: off].
   */
  vtkSetMacro(SnapFoot, bool);
  vtkGetMacro(SnapFoot, bool);
  vtkBooleanMacro(SnapFoot, bool);
  ///@}

  ///@{
  /**
   * For SnapFoot: how far from the curve the foot is [model length, default -1: 0.03 of the mesh's diagonal].
   * A curve's own Radius goes before it.
   */
  vtkSetMacro(Radius, double);
  vtkGetMacro(Radius, double);
  ///@}

  ///@{
  /**
   * For SnapFoot: exponent s of the feature's profile (1 - distance / radius)^s, not negative [default 1.5].
   * A curve's own Sharpness goes before it.
   */
  vtkSetMacro(Sharpness, double);
  vtkGetMacro(Sharpness, double);
  ///@}

  ///@{
  /**
   * For SnapFoot: reach only what is joined to the curve through what is reached [default on; as published:
   * off].
   */
  vtkSetMacro(ConnectedOnly, bool);
  vtkGetMacro(ConnectedOnly, bool);
  vtkBooleanMacro(ConnectedOnly, bool);
  ///@}

  ///@{
  /**
   * Counts of the last snapping: crossings before the first move and after the last, vertices put on a curve,
   * moves refused, faces added.
   */
  vtkGetMacro(Crossings, int);
  vtkGetMacro(Residual, int);
  vtkGetMacro(Snapped, int);
  vtkGetMacro(Refused, int);
  vtkGetMacro(FacesAdded, int);
  ///@}

  /**
   * Vertices of the last snapping that went to feet and their rims, or towards them.
   */
  vtkGetMacro(FootMoved, int);

  /**
   * How many times a mesh has been snapped: executions that the kept result did not answer.
   */
  vtkGetMacro(SnapCount, vtkIdType);

protected:
  vtkOversketchStellarSnap();
  ~vtkOversketchStellarSnap() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Order = Nearest;
  int MaximumResidualRounds = 2;
  bool SnapFoot = true;
  double Radius = -1.0;
  double Sharpness = 1.5;
  bool ConnectedOnly = true;
  int Crossings = 0, Residual = 0, Snapped = 0, Refused = 0, FacesAdded = 0, FootMoved = 0;
  vtkIdType SnapCount = 0;
};

#endif
