/**
 * @class vtkOversketchCrossSection
 * @brief the profile of a region across its reference curve: where a plane cuts it, laid flat to be drawn
 * anew
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 6.2: from face to face
 * where the b-plane cuts them, from where it meets the boundary to where it meets it again; then a spline,
 * and a scale that makes it fit between 0 and 1. Departures, which Ends and Walk turn off: of several
 * meetings those next to the curve count, as the outer two of an S span several arms; the way is in the plane
 * that is drawn. Kernels/Section/walk.h and profile.h say more.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, with point arrays CurveDistance and CurveSide, one component
 * each, see vtkOversketchDistanceField; read where the section runs.
 * Input 1 (Boundary): the boundary curve, one closed polyline with point array VertexId whose segments are
 * edges of the mesh, see vtkOversketchInsertCurve.
 * Input 2 (Planes): output of vtkOversketchProfilePlanes; its field arrays are read.
 *
 * Output 0 (Profile): one polyline in the plane z = 0, from (0, 0) to the right, outward up, its longer side
 * 1; with
 * - point array CurveT, double: share of its length, 0 to 1,
 * - point array SideDistance, double: CurveSide times CurveDistance there, -1 to 1,
 * - field array ProfileMatrix, double[16]: from its plane to world space, row by row,
 * - field arrays Frame and PlaneT, those of the planes.
 * Output 1 (Section): the section before it was fitted, a polyline on the mesh, with point arrays CurveT,
 * SideDistance, MeshVertices and MeshWeights.
 *
 * Both are empty, with a warning, where the plane meets the boundary fewer than twice, or, from the curve
 * on, goes round a limb and back before it does.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadStroke for a boundary that is none or no chain
 * of edges, a plane that does not cut the mesh at its place, ends that meet; BadMesh naming the edge where
 * the section meets the mesh's border or more than two faces before the boundary; BadRegion naming a vertex
 * with a distance or a side out of range; MissingArray. A mesh without points gives empty outputs silently.
 *
 * Deterministic. Cost: once linear in the mesh, which is linked; then as many faces as are crossed. The
 * result stays, as the same arrays, while inputs and parameters do.
 *
 * @sa vtkOversketchProfilePlanes vtkOversketchResketch vtkOversketchProfileDeform
 */
#ifndef vtkOversketchCrossSection_h
#define vtkOversketchCrossSection_h

#include "OversketchFiltersDeformModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSDEFORM_EXPORT vtkOversketchCrossSection : public vtkOversketchFilter
{
public:
  static vtkOversketchCrossSection* New();
  vtkTypeMacro(vtkOversketchCrossSection, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The boundary curve, on port 1.
   */
  void SetBoundaryConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetBoundaryData(vtkPolyData* curve) { this->SetInputData(1, curve); }

  /**
   * The planes, on port 2.
   */
  void SetPlanesConnection(vtkAlgorithmOutput* planes) { this->SetInputConnection(2, planes); }
  void SetPlanesData(vtkPolyData* planes) { this->SetInputData(2, planes); }

  enum EndsType
  {
    Nearest = 0,
    Outermost = 1
  };
  ///@{
  /**
   * Where the section ends: where it first meets the boundary on either side of the curve (Nearest, default),
   * or as published at the leftmost and the rightmost of all meetings (Outermost).
   */
  vtkSetClampMacro(Ends, int, Nearest, Outermost);
  vtkGetMacro(Ends, int);
  void SetEndsToNearest() { this->SetEnds(Nearest); }
  void SetEndsToOutermost() { this->SetEnds(Outermost); }
  ///@}

  enum WalkType
  {
    Across = 0,
    Centre = 1
  };
  ///@{
  /**
   * The plane that the section is in: the b-plane, across the curve (Across, default), or as published the
   * one through both ends and the middle of the mesh's bounding box (Centre).
   */
  vtkSetClampMacro(Walk, int, Across, Centre);
  vtkGetMacro(Walk, int);
  void SetWalkToAcross() { this->SetWalk(Across); }
  void SetWalkToCentre() { this->SetWalk(Centre); }
  ///@}

  ///@{
  /**
   * Direction to the right in the view in which the profile was opened, a vector of any length in world
   * space: the profile runs that way. Default 0 0 0: to the frame's side, which is the left of the curve as
   * it goes.
   */
  vtkSetVector3Macro(Right, double);
  vtkGetVector3Macro(Right, double);
  ///@}

  /**
   * The section on the mesh, on port 1.
   */
  vtkPolyData* GetSectionOutput() { return this->GetOutput(1); }

  /**
   * How many times a section has been cut: executions that the kept result did not answer.
   */
  vtkGetMacro(SectionCount, vtkIdType);

protected:
  vtkOversketchCrossSection();
  ~vtkOversketchCrossSection() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Ends = Nearest;
  int Walk = Across;
  double Right[3] = { 0.0, 0.0, 0.0 };
  vtkIdType SectionCount = 0;

  struct Cache;
};

#endif
