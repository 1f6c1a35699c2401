/**
 * @class vtkOversketchAssemble
 * @brief one mesh of several parts, each placed by an affine transform
 *
 * Source: "Image-Assisted Modeling from Sketches", Secs. 3 and 4, Fig. 17: parts made from one or several
 * pictures are placed by affine transforms, mainly translation in depth; they are not merged or blended. The
 * faces of a part that its transform mirrors are reversed, so that they still look outward.
 *
 * Input 0 (Mesh, repeatable): the parts. A part's field array Placement, 16 numbers, is its transform row by
 * row; without it the part stays where it is.
 *
 * Output 0 (Mesh): all of them, in the order of the connections. Point and cell arrays that every part has
 * are passed, normals not; texture coordinates are passed where any part has some, as doubles in TCoords, 0
 * on the others. Cell array PartId, int: the number of the connection, from 0. Field arrays of part 2 are
 * called Part2.Canvas and so on; its Placement is done and is not among them; Joined (vtkOversketchJoin) is
 * one list for all, counted on. A part that was assembled itself (PartId) stays several: its numbers, and
 * those in its arrays' names, are counted on, and later connections after them.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, naming the part, for a Placement that is
 * not 16 finite numbers of an affine transform or flattens the part, a point that is not finite, a PartId
 * that is below 0 or not one int a face, and for lines, vertices or strips. Parts without points are left out
 * silently and keep their number.
 *
 * Deterministic. Cost: a copy of the parts. No part's own filters run again when another one moves.
 *
 * @sa vtkOversketchInflate vtkOversketchExtrude vtkOversketchProjectTexture
 */
#ifndef vtkOversketchAssemble_h
#define vtkOversketchAssemble_h

#include "OversketchFiltersInflateModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class OVERSKETCHFILTERSINFLATE_EXPORT vtkOversketchAssemble : public vtkPolyDataAlgorithm
{
public:
  static vtkOversketchAssemble* New();
  vtkTypeMacro(vtkOversketchAssemble, vtkPolyDataAlgorithm);

protected:
  vtkOversketchAssemble();
  ~vtkOversketchAssemble() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
};

#endif
