/**
 * @class vtkOversketchEnclose
 * @brief the region of interest that a boundary drawn round a reference curve encloses
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Sec. 5.1: from the face
 * under the reference curve's middle over neighbouring faces within the boundary until none is left, then one
 * ring of faces more; only vertices strictly inside will be deformed. Kernels/Region/enclose.h says what the
 * thesis leaves open: growing crosses edges, and none of the boundary's, so the far side of the model stays
 * out, whatever lies over it in the picture.
 *
 * Departure: the thesis accepts any region; here the faces inside must be a disc, hold the whole reference
 * curve strictly inside and be no more than 80 % of the connected part of the mesh.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData.
 * Input 1 (Reference): the reference curve, one polyline with point array VertexId (1 component): the vertex
 * of the mesh that each point is.
 * Input 2 (Boundary): the boundary curve, of the same form, each vertex joined to the next one by an edge;
 * it ends with the vertex that it begins with.
 *
 * Output 0 (Mesh): the input with point array EditRegion, unsigned char: 0 outside, 1 on the boundary, of the
 * ring or on a border of the mesh, 2 strictly inside; and cell array EditRegion: 0 outside, 1 of the ring, 2
 * inside. All else is passed.
 * Output 1 (Patch): the faces with EditRegion 1 or 2 by themselves, in their order, with their point and cell
 * arrays, EditRegion among them, and point array VertexId, vtkIdType: their vertices' ids in the mesh.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray without VertexId; BadStroke,
 * naming the curve and the place, for a curve that is not one polyline of the mesh's vertices, a reference of
 * fewer than two, a boundary that is open or leaves the edges; BadRegion, saying which, when the reference is
 * not all strictly inside, the region over 80 % or no disc. A mesh without points gives empty outputs
 * silently.
 *
 * Deterministic. Cost: linear in the triangles. Result and patch are kept, as the same arrays, while all that
 * they are made from stands.
 *
 * @sa vtkOversketchRetriangulate
 */
#ifndef vtkOversketchEnclose_h
#define vtkOversketchEnclose_h

#include "OversketchFiltersRegionModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSREGION_EXPORT vtkOversketchEnclose : public vtkOversketchFilter
{
public:
  static vtkOversketchEnclose* New();
  vtkTypeMacro(vtkOversketchEnclose, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The curves, on ports 1 and 2, and the patch.
   */
  void SetReferenceConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(1, curve); }
  void SetReferenceData(vtkPolyData* curve) { this->SetInputData(1, curve); }
  void SetBoundaryConnection(vtkAlgorithmOutput* curve) { this->SetInputConnection(2, curve); }
  void SetBoundaryData(vtkPolyData* curve) { this->SetInputData(2, curve); }
  vtkPolyData* GetPatchOutput() { return this->GetOutput(1); }
  ///@}

  /**
   * How many times a region has been grown: executions that the kept result did not answer.
   */
  vtkGetMacro(GrowthCount, vtkIdType);

protected:
  vtkOversketchEnclose();
  ~vtkOversketchEnclose() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType GrowthCount = 0;

  struct Cache;
};

#endif
