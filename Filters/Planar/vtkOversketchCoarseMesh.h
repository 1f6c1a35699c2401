/**
 * @class vtkOversketchCoarseMesh
 * @brief the coarse mesh of a drawing: the constrained Delaunay triangulation of its polylines
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.2, Fig. 8. Readings and departures
 * (Kernels/Planar/triangulate.h and coarse_faces.h): triangles with at least two edges on the rim are
 * divided, which is what the doubled surface needs, rather than all of three boundary vertices
 * (TerminalRule); ties are decided so that the mesh does not depend on the strokes' order; faces of holes are
 * left out; points inside make room for triangles of good shape (Relax). Not CGAL's, which is under the GPL:
 * ours, on CGAL's exact predicates.
 *
 * Input 0 (Polylines): those of vtkOversketchPolyline.
 * Input 1 (Darts, optional): further points, those of vtkOversketchDarts; its cells are not read.
 *
 * Output 0 (Triangles): the mesh, counter-clockwise, z = 0, points and faces in canonical order, with
 * - point array BoundaryKind, int: 0 interior, 1 boundary of an object, 2 of a hole, 3 feature, 4 rim of a
 *   tunnel; StrokeId, int: the stroke that it lies on, of two the rim's, -1 on none; StrokeParam, double:
 * where on it, arc length [world]; IsBaseVertex, unsigned char: 1,
 * - cell arrays RegionId, ObjectId, int; BaseFaceId, int: the face itself,
 * - the field arrays of the polylines.
 * Output 1 (Edges): the edges on strokes, lines of two points of output 0, with cell arrays StrokeId, int,
 * and ParamStart, ParamEnd, double: arc lengths at the two, ascending; on the edge over a closed stroke's
 * first sample the second is past the whole length.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray for absent arrays; BadStroke for
 * polylines that are none, darts that are not finite, and, naming the strokes, polylines that meet or lie on
 * the wrong side of another one. Polylines without points give empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads. Cost: 5,000 points some 3 ms. The result
 * stays while polylines, darts and parameters do.
 *
 * @sa vtkOversketchPolyline vtkOversketchDarts vtkOversketchQuadMerge
 */
#ifndef vtkOversketchCoarseMesh_h
#define vtkOversketchCoarseMesh_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchCoarseMesh : public vtkOversketchFilter
{
public:
  static vtkOversketchCoarseMesh* New();
  vtkTypeMacro(vtkOversketchCoarseMesh, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Rule
  {
    TWO_BOUNDARY_EDGES = 0,
    THREE_BOUNDARY_VERTICES = 1,
    NONE = 2
  };

  /**
   * The darts, on port 1.
   */
  void SetDartsConnection(vtkAlgorithmOutput* darts) { this->SetInputConnection(1, darts); }
  void SetDartsData(vtkPolyData* darts) { this->SetInputData(1, darts); }

  /**
   * The edges on strokes, on port 1.
   */
  vtkPolyData* GetEdgesOutput() { return this->GetOutput(1); }

  ///@{
  /**
   * Which triangles are divided, because the doubled surface would be none there: TwoBoundaryEdges;
   * ThreeBoundaryVertices, as the paper has it literally; None, for a mesh that is not doubled [default
   * TwoBoundaryEdges].
   */
  vtkSetClampMacro(TerminalRule, int, TWO_BOUNDARY_EDGES, NONE);
  vtkGetMacro(TerminalRule, int);
  void SetTerminalRuleToTwoBoundaryEdges() { this->SetTerminalRule(TWO_BOUNDARY_EDGES); }
  void SetTerminalRuleToThreeBoundaryVertices() { this->SetTerminalRule(THREE_BOUNDARY_VERTICES); }
  void SetTerminalRuleToNone() { this->SetTerminalRule(NONE); }
  ///@}

  ///@{
  /**
   * Move points that lie on no stroke to where the triangles round them are of better shape
   * (Kernels/Planar/coarse_faces.h) [default on; not as published].
   */
  vtkSetMacro(Relax, bool);
  vtkGetMacro(Relax, bool);
  vtkBooleanMacro(Relax, bool);
  ///@}

  /**
   * How many times meshes have been made: executions that the kept result did not answer.
   */
  vtkGetMacro(MeshCount, vtkIdType);

protected:
  vtkOversketchCoarseMesh();
  ~vtkOversketchCoarseMesh() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int TerminalRule = TWO_BOUNDARY_EDGES;
  bool Relax = true;
  vtkIdType MeshCount = 0;
};

#endif
