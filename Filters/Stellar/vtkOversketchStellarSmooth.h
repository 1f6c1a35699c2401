/**
 * @class vtkOversketchStellarSmooth
 * @brief evens out the triangles that snapping has squeezed
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators", Sec. III-C.1: vertices move,
 * within their tangent planes, towards the mean of their neighbours. Departures: of the whole mesh, as
 * printed, only the vertices within some rings round snapped ones move (Rings), since all others are as they
 * were drawn on; snapped vertices, crests of earlier strokes, the border and seams stay; moves that would
 * spoil a triangle are refused: an angle would be under 5 degrees and smaller than before.
 *
 * Input 0 (Mesh): 4-8 mesh, see vtkOversketchStellarBase and Filters/Stellar/README.md. Cell array Chart
 * (optional): as for vtkOversketchStellarSnap. Points whose point array Mask is 1 (vtkOversketchMask) stay.
 * Input 1 (Curves): polylines of vtkOversketchSurfaceStroke or vtkOversketchSilhouetteSketch; of their arrays
 * Normals and Pressure are read, and the cell arrays Radius, Height and Sharpness go before parameters.
 * Input 2 (Source, optional): output 1 of vtkOversketchStellarBase or vtkOversketchTerrain, to which vertices
 * that were on it return.
 *
 * Output 0 (Mesh): the 4-8 mesh; StellarMoved with 1 where a vertex moved. Other point arrays, normals among
 * them, as at the vertex's new place on the surface before.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, cell or
 * point, where the mesh is no sound 4-8 mesh or was changed by a filter in between; BadStroke for curves that
 * are none, for others than the mesh is snapped to (field array CurveDigest), and parameters out of range.
 * A mesh without points gives an empty output silently, without curves it goes through.
 *
 * Deterministic: same result bit for bit for any number of threads, cached or read from a file. The result
 * stays, as the same arrays, while all that is read does.
 *
 * @sa vtkOversketchStellarSnap vtkOversketchStellarDisplace
 */
#ifndef vtkOversketchStellarSmooth_h
#define vtkOversketchStellarSmooth_h

#include "OversketchFiltersStellarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSSTELLAR_EXPORT vtkOversketchStellarSmooth : public vtkOversketchFilter
{
public:
  static vtkOversketchStellarSmooth* New();
  vtkTypeMacro(vtkOversketchStellarSmooth, vtkOversketchFilter);
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
   * Rings of edges round snapped vertices that move [default 2; -1, as published: all].
   */
  vtkSetClampMacro(Rings, int, -1, VTK_INT_MAX);
  vtkGetMacro(Rings, int);
  ///@}

  ///@{
  /**
   * How many times [default 1].
   */
  vtkSetClampMacro(Iterations, int, 0, VTK_INT_MAX);
  vtkGetMacro(Iterations, int);
  ///@}

  ///@{
  /**
   * Counts of the last smoothing: moves, and moves refused.
   */
  vtkGetMacro(Moved, int);
  vtkGetMacro(Refused, int);
  ///@}

  /**
   * How many times a mesh has been smoothed: executions that the kept result did not answer.
   */
  vtkGetMacro(SmoothCount, vtkIdType);

protected:
  vtkOversketchStellarSmooth();
  ~vtkOversketchStellarSmooth() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Rings = 2;
  int Iterations = 1;
  int Moved = 0, Refused = 0;
  vtkIdType SmoothCount = 0;
};

#endif
