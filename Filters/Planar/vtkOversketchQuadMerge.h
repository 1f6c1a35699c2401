/**
 * @class vtkOversketchQuadMerge
 * @brief pairs of a coarse mesh's triangles become quads
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.2.4, Fig. 10: greedy merging, after which triangles
 * may remain; one level of refinement makes quads of all. The measure of a quad is ours
 * (Kernels/Planar/coarse_faces.h). No quad has two edges of the rim that meet, and with
 * vtkOversketchCoarseMesh's TerminalRule TwoBoundaryEdges no triangle has, so that the surface stays one when
 * its quads are cut into triangles, whichever way.
 *
 * Input 0 (Triangles): those of vtkOversketchCoarseMesh.
 * Input 1 (Edges): its edges, which stay.
 *
 * Output 0 (Faces): quads and triangles with the same points and arrays; BaseFaceId is the face itself.
 * Output 1 (Edges): the same.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray for absent arrays, BadMesh as
 * vtkOversketchPlanarTools.h says. A mesh without points gives empty outputs silently.
 *
 * Deterministic. Cost: some milliseconds. The result stays while both inputs do.
 *
 * @sa vtkOversketchCoarseMesh vtkOversketchPlanarRefine
 */
#ifndef vtkOversketchQuadMerge_h
#define vtkOversketchQuadMerge_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchQuadMerge : public vtkOversketchFilter
{
public:
  static vtkOversketchQuadMerge* New();
  vtkTypeMacro(vtkOversketchQuadMerge, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The edges on strokes, on port 1 of input and output.
   */
  void SetEdgesConnection(vtkAlgorithmOutput* edges) { this->SetInputConnection(1, edges); }
  void SetEdgesData(vtkPolyData* edges) { this->SetInputData(1, edges); }
  vtkPolyData* GetEdgesOutput() { return this->GetOutput(1); }

  /**
   * How many times triangles have been merged: executions that the kept result did not answer.
   */
  vtkGetMacro(MergeCount, vtkIdType);

protected:
  vtkOversketchQuadMerge();
  ~vtkOversketchQuadMerge() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkIdType MergeCount = 0;
};

#endif
