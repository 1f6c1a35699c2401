/**
 * @class vtkOversketchRetriangulate
 * @brief new triangles for a region that an edit has moved
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 3.4 and 8.1: after an
 * edit, edges of the region much longer than the mean edge of the mesh as it was loaded are split, much
 * shorter ones collapsed, and edges swapped where it helps. Kernels/Remesh/retriangulate.h has both rules.
 *
 * Departure: the rule of the thesis goes by curvature, which is found in the noise of an unchanged region
 * too, and puts new vertices onto the facets of a stretched surface. Rule Edit splits edges before the edit
 * by what the edit makes of them, and remeshes what it has changed. Between vertices the motion is as smooth
 * as that header says, where SetMotion does not give it.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData, moved by the edit, with point array EditRegion (0 outside, 1 on
 * the boundary, 2 strictly inside; vtkOversketchEnclose) and field array MeanEdge (vtkOversketchMeanEdge);
 * under rule Edit point array EdgeLength (1 component, vtkOversketchRefineBetween), where there is one, takes
 * the place of that at each vertex. Triangles at a vertex whose point array Mask is 1 (vtkOversketchMask) are
 * left.
 * Input 1 (Reference): the reference curve, polylines with point array VertexId (1 component): the vertex of
 * the mesh that each point is.
 * Input 2 (Boundary): the boundary curve, of the same form.
 * Input 3 (Rest, optional): the mesh before the edit, with the same polygons; rule Edit needs it.
 *
 * Output 0 (Mesh): the mesh. Points and triangles that are left come first, in their order; those outside bit
 * for bit. Point arrays: measures interpolated (the active normals re-normalised), labels from the
 * vertex of largest weight; EditRegion is 2 but between two vertices of the boundary. Cell arrays: from the
 * triangle under the middle of each. Field data is passed. Global ids, which would no longer be unique, and
 * the arrays of a 4-8 mesh are dropped. Where nothing is to be done it is the input.
 * Output 1 (Reference): the reference curve, VertexId and places renewed, with a point more wherever an edge
 * of it was split; floating arrays of that lie between its neighbours', others are the nearer one's.
 * Output 2 (Boundary): the boundary curve, alike.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, also where Rest is absent or has other
 * polygons under rule Edit; MissingArray without EditRegion, MeanEdge or VertexId; BadRegion naming the
 * vertex for a label that is not 0, 1 or 2; BadStroke for curves that are not polylines of the mesh's
 * vertices. A mesh without points gives empty outputs silently.
 *
 * Deterministic: same result bit for bit for any number of threads. The result is kept while all that it is
 * made from stands. Cost: under 10 milliseconds per 1,000 triangles made.
 *
 * @sa vtkOversketchEnclose vtkOversketchRemesh
 */
#ifndef vtkOversketchRetriangulate_h
#define vtkOversketchRetriangulate_h

#include "OversketchFiltersRemeshModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <memory>

namespace oversketch
{
struct Motion;
}

class OVERSKETCHFILTERSREMESH_EXPORT vtkOversketchRetriangulate : public vtkOversketchFilter
{
public:
  static vtkOversketchRetriangulate* New();
  vtkTypeMacro(vtkOversketchRetriangulate, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum RuleType
  {
    Edit = 0,
    Curvature = 1
  };

  ///@{
  /**
   * The curves, on ports 1 and 2, the mesh before the edit, on port 3, and where the curves come out.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }
  void SetBoundaryConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(2, curve); }
  void SetBoundaryData(vtkPolyData* curve) { this->SetInputData(2, curve); }
  void SetRestConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(3, mesh); }
  void SetRestData(vtkPolyData* mesh) { this->SetInputData(3, mesh); }
  vtkPolyData* GetReferenceOutput() { return this->GetOutput(1); }
  vtkPolyData* GetBoundaryOutput() { return this->GetOutput(2); }
  ///@}

  ///@{
  /**
   * Split by what the edit does (Edit), or, as published, by curvature (Curvature). Default Edit.
   */
  vtkSetClampMacro(Rule, int, Edit, Curvature);
  vtkGetMacro(Rule, int);
  void SetRuleToEdit() { this->SetRule(Edit); }
  void SetRuleToCurvature() { this->SetRule(Curvature); }
  ///@}

  /**
   * The motion of the edit at every place of the mesh before it (Kernels/Remesh/retriangulate.h), for rule
   * Edit; null (default): it is found between the two meshes. For C++, as vtkOversketchEdit sets it.
   */
  void SetMotion(std::shared_ptr<const oversketch::Motion> motion);

  /**
   * Splits, collapses and swaps that the output was made with.
   */
  vtkGetMacro(OperationCount, vtkIdType);

  /**
   * How many times a mesh has been retriangulated: executions that the kept result did not answer.
   */
  vtkGetMacro(RetriangulationCount, vtkIdType);

protected:
  vtkOversketchRetriangulate();
  ~vtkOversketchRetriangulate() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Rule = Edit;
  std::shared_ptr<const oversketch::Motion> Known;
  vtkIdType OperationCount = 0;
  vtkIdType RetriangulationCount = 0;

  struct Cache;
};

#endif
