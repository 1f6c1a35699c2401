/**
 * @class vtkOversketchJoin
 * @brief closed parts become one closed body: joined, cut from each other, or what they have in common
 *
 * Source: ours; none of the papers has it. Where faces of two parts cut each other is decided exactly, as if
 * one part were moved by next to nothing (H. Edelsbrunner, E. Muecke, "Simulation of Simplicity", 1990), by
 * CGAL's exact predicates; cut faces are triangulated anew, what rounding leaves is taken out (M. Botsch, L.
 * Kobbelt, "A Robust Procedure to Eliminate Degenerate Faces", 2001). With a width the crease becomes a
 * seam: points nearer to it than half of that are laid on a thin plate that goes on as the parts do (M.
 * Botsch, L. Kobbelt, "An intuitive framework for real-time freeform modeling", 2004), on triangles of the
 * parts' own size, an eighth of the width at most, and smaller where it bends by more than 11 degrees an
 * edge. Sharp edges of the parts that run into a seam (over 50 degrees) end there.
 *
 * Input 0 (Mesh): closed parts, vtkPolyData of triangles: its parts by cell array PartId (one int a face, as
 * vtkOversketchAssemble writes it; those in field array Joined, int, are one), without that, and without
 * input 1, its pieces that hang together. Points that a reader split are welded for computing (exactly equal
 * positions).
 *
 * Input 1 (Other, optional): a further mesh, whose parts come after those.
 *
 * Output 0 (Mesh): the body, points in double precision. Beyond the faces that were cut, and beyond the seam,
 * points keep their bits; point arrays are interpolated in the parts' own triangles and have two values, at
 * two points, where parts meet; without point arrays no place has two points. Cell arrays are carried,
 * normals are not. PartId, and with it a picture for each part (field arrays Part0.Texture and so on), stays
 * where there is one; field array Joined, int, then holds the numbers of the parts, which are one body. Parts
 * that touch within 2.5e-7 of the diagonal of the box round all of them meet.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh for one part alone, a part that is not
 * closed or goes through itself where it meets another one (with its number, from 1, and the place), parts
 * that do not meet without Bridge, and where nothing is left; BadRegion for a seam that takes all that is
 * left of a part, with the widest that would do, and for a bridge without a width; Torn where faces would go
 * through each other. An empty mesh gives an empty output silently.
 * A run that AbortExecute stopped needs Modified() before the next.
 *
 * Deterministic: same result bit for bit for any number of threads.
 *
 * @sa vtkOversketchAssemble vtkOversketchTransform
 */
#ifndef vtkOversketchJoin_h
#define vtkOversketchJoin_h

#include "OversketchFiltersJoinModule.h" // For export macro
#include "vtkOversketchSystem.h"

class OVERSKETCHFILTERSJOIN_EXPORT vtkOversketchJoin : public vtkOversketchSystem
{
public:
  static vtkOversketchJoin* New();
  vtkTypeMacro(vtkOversketchJoin, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetOtherConnection(vtkAlgorithmOutput* mesh) { this->SetInputConnection(1, mesh); }
  void SetOtherData(vtkPolyData* mesh) { this->SetInputData(1, mesh); }

  enum OperationType
  {
    Join = 0,
    Cut = 1,
    Common = 2
  };
  ///@{
  /**
   * What becomes of the parts: one body [0, default], what is left of the first one without the others [1],
   * what all of them fill [2].
   */
  vtkSetClampMacro(Operation, int, Join, Common);
  vtkGetMacro(Operation, int);
  void SetOperationToJoin() { this->SetOperation(Join); }
  void SetOperationToCut() { this->SetOperation(Cut); }
  void SetOperationToCommon() { this->SetOperation(Common); }
  ///@}

  ///@{
  /**
   * Width of the rounded seam where parts meet, half of it to either side, over the surface [model length,
   * from 0, default 0: a crease].
   */
  vtkSetMacro(Width, double);
  vtkGetMacro(Width, double);
  ///@}

  ///@{
  /**
   * Join parts that do not meet by a round bar along the shortest way, as thick as the seam is wide [default
   * off: they are refused].
   */
  vtkSetMacro(Bridge, bool);
  vtkGetMacro(Bridge, bool);
  vtkBooleanMacro(Bridge, bool);
  ///@}

  /**
   * "parts": how many there were; "seam.sharpest_edge": what the seam's edges bend by at most [degrees], but
   * those at edges of the parts that bend by over 11; NaN without a seam.
   */
  FigureList Figures() override;

protected:
  vtkOversketchJoin();
  ~vtkOversketchJoin() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Operation = Join;
  double Width = 0.0;
  bool Bridge = false;
  FigureList Found;
};

#endif
