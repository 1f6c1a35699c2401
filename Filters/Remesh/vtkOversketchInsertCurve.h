/**
 * @class vtkOversketchInsertCurve
 * @brief curves on a mesh become chains of its edges
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 4.1: the points of a
 * curve are added to the mesh as vertices.
 *
 * Departures (see Kernels/Remesh/insert_curves.h): the thesis stops there. Here vertices and edges that are
 * near are used instead of new ones (Snap); segments become edges (EmbedSegments), so that a region can be
 * grown up to a curve; a closed curve that leaves the mesh, or is hidden in parts, is led on behind what
 * hides it (Bridge); and narrow triangles at the curves are cleaned (Clean). All four off is as published;
 * with EmbedSegments, JoinRuns.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData. Borders and non-manifold edges are tolerated. Triangles at a
 * vertex whose point array Mask is 1 (vtkOversketchMask) are split, not cleaned.
 * Input 1 (Curves): curves of vtkOversketchProjectCurve on this mesh: point arrays CurveT, MeshCell,
 * MeshVertices, MeshWeights; cell arrays StrokeId, Closed and those of the view. Runs of one StrokeId make
 * one curve and follow each other.
 * Input 2 (Stored, optional): curves that the mesh has as chains of edges, with point arrays VertexId and
 * CurveT. What splits an edge of theirs becomes a point of theirs.
 *
 * Output 0 (Mesh): the mesh: points that stay in their order and bit for bit, then new ones. Point arrays:
 * measures mixed (active normals of length 1), labels and Region from the point of largest weight; cell
 * arrays from the triangle that each comes from. Field data is passed. Global ids and the arrays of a 4-8
 * mesh are dropped.
 * Output 1 (Curves): one polyline per curve, in the order of StrokeId; closed ones repeat their first point
 * id. Point arrays VertexId, vtkIdType: the vertex of output 0, none twice; CurveT, double, rising from 0 to
 * 1, from 0 on of a closed curve. Cell arrays as in input 1, without CurveId; field data is passed.
 * Output 2 (Stored): input 2 on the new mesh, with its cell and field arrays, VertexId and CurveT.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, also for curves of another mesh;
 * MissingArray; BadStroke, naming the curve, for an open one in several runs, a closed one that does not
 * close, one that comes to less than a segment, and for a stored curve that is no chain of edges. Without
 * curves mesh and stored curves are passed; a mesh without points gives empty outputs silently.
 *
 * Deterministic. Cost: some 0.2 s a million triangles and 30 microseconds a vertex made. The result is kept,
 * as the same arrays, while all that it is made from stands.
 *
 * @sa vtkOversketchProjectCurve vtkOversketchMeanEdge
 */
#ifndef vtkOversketchInsertCurve_h
#define vtkOversketchInsertCurve_h

#include "OversketchFiltersRemeshModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREMESH_EXPORT vtkOversketchInsertCurve : public vtkOversketchFilter
{
public:
  static vtkOversketchInsertCurve* New();
  vtkTypeMacro(vtkOversketchInsertCurve, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The curves on port 1, those that the mesh has on port 2, and where they come out.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(1, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(1, curves); }
  void SetStoredConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(2, curves); }
  void SetStoredData(vtkPolyData* curves) { this->SetInputData(2, curves); }
  vtkPolyData* GetCurvesOutput() { return this->GetOutput(1); }
  vtkPolyData* GetStoredOutput() { return this->GetOutput(2); }
  ///@}

  ///@{
  /**
   * Use vertices and edges that are near instead of new ones [default on; off as published].
   */
  vtkSetMacro(Snap, bool);
  vtkGetMacro(Snap, bool);
  vtkBooleanMacro(Snap, bool);
  ///@}

  ///@{
  /**
   * Make segments edges [default on; off as published: only their ends are vertices].
   */
  vtkSetMacro(EmbedSegments, bool);
  vtkGetMacro(EmbedSegments, bool);
  vtkBooleanMacro(EmbedSegments, bool);
  ///@}

  ///@{
  /**
   * Lead closed curves on behind what hides them and where they leave the mesh [default on; off: such curves
   * are refused].
   */
  vtkSetMacro(Bridge, bool);
  vtkGetMacro(Bridge, bool);
  vtkBooleanMacro(Bridge, bool);
  ///@}

  enum GapType
  {
    Viewer = 0,
    Onward = 1,
    Across = 2
  };
  ///@{
  /**
   * With Bridge on, over a gap first off from the Viewer, in the plane through the eye (default), or on as
   * the curve comes, Onward, or in the plane Across the first stored curve.
   */
  vtkSetClampMacro(Gap, int, Viewer, Across);
  vtkGetMacro(Gap, int);
  void SetGapToViewer() { this->SetGap(Viewer); }
  void SetGapToOnward() { this->SetGap(Onward); }
  void SetGapToAcross() { this->SetGap(Across); }
  ///@}

  ///@{
  /**
   * With Bridge off: as published, samples that miss the mesh are left out, and those beside the gap joined
   * as all others are, over what is seen of it [default off].
   */
  vtkSetMacro(JoinRuns, bool);
  vtkGetMacro(JoinRuns, bool);
  vtkBooleanMacro(JoinRuns, bool);
  ///@}

  ///@{
  /**
   * Raise angles under 24 degrees at the curves by flips, and under 20 by collapses, too [default on; off as
   * published].
   */
  vtkSetMacro(Clean, bool);
  vtkGetMacro(Clean, bool);
  vtkBooleanMacro(Clean, bool);
  ///@}

  /**
   * How many gaps of closed curves the last execution has bridged.
   */
  vtkGetMacro(BridgeCount, int);

  /**
   * How many times curves have been inserted: executions that the kept result did not answer.
   */
  vtkGetMacro(InsertionCount, vtkIdType);

protected:
  vtkOversketchInsertCurve();
  ~vtkOversketchInsertCurve() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  bool Snap = true;
  bool EmbedSegments = true;
  bool Bridge = true;
  int Gap = Viewer;
  bool JoinRuns = false;
  bool Clean = true;
  int BridgeCount = 0;
  vtkIdType InsertionCount = 0;
};

#endif
