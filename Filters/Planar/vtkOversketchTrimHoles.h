/**
 * @class vtkOversketchTrimHoles
 * @brief cuts the holes of a drawing out of its mesh
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3.1, Fig. 15: before the surface is made the faces
 * of a region that is a hole leave the mesh, by the RegionId that they inherited, never by where they lie;
 * what a closed stroke in the hole bounds stays, as an island, where it is none itself (the paper does not
 * say). vtkOversketchCoarseMesh leaves holes out from the first; this is for meshes of regions that became
 * holes later.
 *
 * Input 0 (Mesh): mesh of vtkOversketchCoarseMesh, vtkOversketchQuadMerge or vtkOversketchPlanarRefine.
 * Input 1 (Edges): output 1 of the same.
 * Input 2 (Curves): the curves that it was made of, with the arrays of vtkOversketchClassify and Treatment.
 *
 * Output 0 (Mesh): what is left, with the same arrays; points that no face has are left out. BoundaryKind is
 * 2, hole, where the mesh was cut.
 * Output 1 (Edges): edges on strokes of what is left.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray and BadMesh, naming array, face or
 * edge, where mesh and edges are not sound or not of these curves; BadStroke for contradictions in the
 * curves' arrays. A mesh without points gives empty outputs silently, without holes both go through.
 *
 * Deterministic. Cost: a few passes over the mesh. The result stays, as the same arrays, while mesh, edges
 * and what is a hole do.
 *
 * @sa vtkOversketchTreatment vtkOversketchPlanarRefine
 */
#ifndef vtkOversketchTrimHoles_h
#define vtkOversketchTrimHoles_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchTrimHoles : public vtkOversketchFilter
{
public:
  static vtkOversketchTrimHoles* New();
  vtkTypeMacro(vtkOversketchTrimHoles, vtkOversketchFilter);

  /**
   * The edges, on port 1.
   */
  void SetEdgesConnection(vtkAlgorithmOutput* edges) { this->SetInputConnection(1, edges); }
  void SetEdgesData(vtkPolyData* edges) { this->SetInputData(1, edges); }

  /**
   * The curves, on port 2.
   */
  void SetCurvesConnection(vtkAlgorithmOutput* curves) { this->SetInputConnection(2, curves); }
  void SetCurvesData(vtkPolyData* curves) { this->SetInputData(2, curves); }

  /**
   * The edges, on output port 1.
   */
  vtkPolyData* GetEdgesOutput() { return this->GetOutput(1); }

protected:
  vtkOversketchTrimHoles();
  ~vtkOversketchTrimHoles() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;
};

#endif
