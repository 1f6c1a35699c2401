/**
 * @class vtkOversketchStellarBase
 * @brief a triangle mesh becomes a 4-8 mesh, which can be refined anywhere
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-B: triangles are paired
 * over common edges, the longest first (Velho 2000), and those that stay alone cut into thirds at their
 * barycentre. Departure (ImprovePairs): partners are exchanged along short paths until hardly any stays
 * alone.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; a manifold with one orientation, with borders or without. A
 * sound 4-8 mesh goes through as it is. Of one whose Stellar arrays do not fit it any more a new base is
 * made, with a warning that says why.
 *
 * Output 0 (Mesh): the 4-8 mesh: the input's points, in double, then barycentres; one cell or three for each
 * triangle, newest point first; arrays of Filters/Stellar/README.md. Point arrays of real numbers are mixed
 * at new points (normals to unit length), others taken from a neighbour; cell arrays come from the triangle
 * that the cell lies in. Ids that are to be unique, and arrays that do not hold numbers, are dropped.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, which counts each kind of defect and names
 * the first five. A mesh without points gives an empty output silently.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does. Cost: about a
 * microsecond a triangle.
 *
 * @sa vtkOversketchTerrain vtkOversketchStellarRefine
 */
#ifndef vtkOversketchStellarBase_h
#define vtkOversketchStellarBase_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory>

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarBase : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchStellarBase* New();
  vtkTypeMacro(vtkOversketchStellarBase, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

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
   * Split every pair at once, as Velho's library does, so that all neighbours are alike [default off].
   */
  vtkSetMacro(EagerPairs, bool);
  vtkGetMacro(EagerPairs, bool);
  vtkBooleanMacro(EagerPairs, bool);
  ///@}

  ///@{
  /**
   * Of the last base that was made: pairs and triangles that stayed alone.
   */
  vtkGetMacro(Pairs, int);
  vtkGetMacro(Unpaired, int);
  ///@}

  ///@{
  /**
   * How many bases have been made: executions that neither the kept result nor the input itself answered.
   */
  vtkGetMacro(BaseCount, vtkIdType);
  ///@}

protected:
  vtkOversketchStellarBase();
  ~vtkOversketchStellarBase() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchStellarBase(const vtkOversketchStellarBase&) = delete;
  void operator=(const vtkOversketchStellarBase&) = delete;

  bool ImprovePairs = true;
  bool EagerPairs = false;
  int Pairs = 0, Unpaired = 0;
  vtkIdType BaseCount = 0;

  struct Cache;
  std::unique_ptr<Cache> Internals;
};

#endif
