/**
 * @class vtkOversketchStellarBase
 * @brief a triangle mesh becomes a 4-8 mesh, which can be refined anywhere
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-B: triangles are paired
 * over common edges, the longest first (Velho 2000), and those that stay alone cut into thirds at their
 * barycentre. Departure (ImprovePairs): partners are exchanged along short paths until hardly any stays
 * alone. Simplified, a mesh is made coarse first, by Velho's clusters of four faces, and keeps the way back
 * (after MAPS, Lee and others 1998): what is refined again follows the surface that came in. Departure: no
 * needles are made on the way (angles under 15 degrees of the coarse mesh, under 2.5 where it is refined
 * again); where that forbids a split the base stays farther from the mesh than SourceTolerance.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; a manifold with one orientation, with borders or without. A
 * sound 4-8 mesh goes through as it is. Of one whose Stellar arrays do not fit it any more a new base is
 * made, with a warning that says why.
 *
 * Output 0 (Mesh): the 4-8 mesh: the input's points (Simplified: those that are left), in double, then
 * others; one cell or three for each triangle, newest point first; arrays of Filters/Stellar/README.md. Point
 * arrays are mixed at new points (normals to unit length, whole numbers rounded), ids and labels taken from a
 * neighbour; cell arrays come from the triangle that the cell lies in. Ids that are to be unique, and arrays
 * that do not hold numbers, are dropped.
 *
 * Output 1 (Source): Simplified, the mesh that came in with field arrays that lead back to it: SourceFaces
 * (3 ids; the triangles that came up), SourceRecords (per operation flattened points, old and new triangles),
 * SourceFlatPoints, SourceFlat (2 [length]), SourceOldFaces, SourceRoots (per base triangle its triangle and
 * which of its corners each corner is, 3 the middle) and SourceDigest, by which later steps see a change.
 * Empty else, and where the input goes through.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, which counts each kind of defect and names
 * the first five; BadStroke for lengths that are not finite or a tolerance of 0. A mesh without points gives
 * an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does. Cost: about a microsecond a triangle, ten
 * Simplified.
 *
 * @sa vtkOversketchTerrain vtkOversketchStellarRefine
 */
#ifndef vtkOversketchStellarBase_h
#define vtkOversketchStellarBase_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarBase : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarBase* New();
  vtkTypeMacro(vtkOversketchStellarBase, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Output 1.
   */
  vtkPolyData* GetSourceOutput() { return this->GetOutput(1); }

  enum ModeType
  {
    Direct = 0,
    Simplified = 1
  };
  ///@{
  /**
   * The mesh itself becomes the base (Direct, default), or a coarse one that is refined again until it is as
   * near to the mesh as SourceTolerance.
   */
  vtkSetClampMacro(Mode, int, Direct, Simplified);
  vtkGetMacro(Mode, int);
  void SetModeToDirect() { this->SetMode(Direct); }
  void SetModeToSimplified() { this->SetMode(Simplified); }
  ///@}

  ///@{
  /**
   * Simplified: how many triangles the coarse mesh is to have [default 0: a quarter]. It has more
   * where its border, features or MaximumError keep points.
   */
  vtkSetClampMacro(TargetFaces, int, 0, VTK_INT_MAX);
  vtkGetMacro(TargetFaces, int);
  ///@}

  ///@{
  /**
   * Simplified: how far a point that goes may be from the triangles in its place [model length, default 0:
   * any].
   */
  vtkSetMacro(MaximumError, double);
  vtkGetMacro(MaximumError, double);
  ///@}

  ///@{
  /**
   * Simplified: how near middles of edges and triangles are to be to the mesh [model length, default -1: 1e-3
   * of the mesh's diagonal].
   */
  vtkSetMacro(SourceTolerance, double);
  vtkGetMacro(SourceTolerance, double);
  ///@}

  ///@{
  /**
   * Find partners for triangles that stayed alone by exchanging those of at most eight pairs [default on; as
   * published: off].
   */
  vtkSetMacro(ImprovePairs, bool);
  vtkGetMacro(ImprovePairs, bool);
  vtkBooleanMacro(ImprovePairs, bool);
  ///@}

  ///@{
  /**
   * Pairs of the last base that was made, and triangles that stayed alone.
   */
  vtkGetMacro(Pairs, int);
  vtkGetMacro(Unpaired, int);
  ///@}

  /**
   * How many bases have been made: executions that neither the kept result nor the input itself answered.
   */
  vtkGetMacro(BaseCount, vtkIdType);

protected:
  vtkOversketchStellarBase() { this->SetNumberOfOutputPorts(2); }
  ~vtkOversketchStellarBase() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Mode = Direct;
  int TargetFaces = 0;
  double MaximumError = 0.0;
  double SourceTolerance = -1.0;
  bool ImprovePairs = true;
  int Pairs = 0, Unpaired = 0;
  vtkIdType BaseCount = 0;

  struct Cache;
};

#endif
