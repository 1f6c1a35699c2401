/**
 * @class vtkOversketchTransform
 * @brief moves, turns and scales a mesh or a part of it, and adds a copy in the mirror
 *
 * Source: ours; none of the papers has it. The mesh, or a part of it, is scaled along x, y and z, turned
 * about y, then x, then z, as vtkProp3D turns by its orientation, and moved, all about the middle of the box
 * of what moves. The axes are the world's and stay.
 *
 * Input 0 (Mesh): polygons, vtkPolyData. Cell array PartId, one int a face, tells the parts
 * (vtkOversketchAssemble); a mesh without it is one part, 0. Point array Mask, where it has one
 * (vtkOversketchMask): points with 1 stay; a copy has them where the mirror has.
 *
 * Output 0: the mesh with other points, in its own type; faces and arrays are passed, active normals turn
 * with the surface. Points that do not belong to what moves are bit-identical, and all are where nothing is
 * done. A copy's points and faces come after those of the mesh, with the values of all their arrays but
 * global ids, and its faces look outward; cell array PartId has the next number for it, of a mesh of several
 * parts so many. Field arrays of a part (Part0.Texture) are repeated for its copy (Part1.Texture). Of a 4-8
 * mesh the arrays that tell its hierarchy are left out.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, for a part that is not there, one that is
 * joined with others (field array Joined, vtkOversketchJoin), a point that is of the part and of another one,
 * a point that is not finite or would lie beyond 1e12, a face that names no point, a PartId that is below 0
 * or not one int a face, and for lines, vertices or strips; BadStroke, for a parameter that is not finite and
 * a factor that is not above 0. An empty mesh gives an empty output silently. A run that AbortExecute stopped
 * needs Modified() before the next.
 *
 * Deterministic: same result bit for bit for any number of threads.
 *
 * @sa vtkOversketchAssemble vtkOversketchMirror
 */
#ifndef vtkOversketchTransform_h
#define vtkOversketchTransform_h

#include "OversketchFiltersTransformModule.h" // For export macro
#include "vtkOversketchSystem.h"

class vtkTransform;

class OVERSKETCHFILTERSTRANSFORM_EXPORT vtkOversketchTransform : public vtkOversketchSystem
{
public:
  static vtkOversketchTransform* New();
  vtkTypeMacro(vtkOversketchTransform, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * How far it is moved along x, y and z [model length, default 0 0 0].
   */
  vtkSetVector3Macro(Move, double);
  vtkGetVector3Macro(Move, double);
  ///@}

  ///@{
  /**
   * Degrees that it is turned by about x, y and z, about y first, then x, then z, counter-clockwise where the
   * axis points at the eye [default 0 0 0].
   */
  vtkSetVector3Macro(Turn, double);
  vtkGetVector3Macro(Turn, double);
  ///@}

  ///@{
  /**
   * Factors that it is scaled by along x, y and z, before it is turned [above 0, default 1 1 1].
   */
  vtkSetVector3Macro(Scale, double);
  vtkGetVector3Macro(Scale, double);
  ///@}

  ///@{
  /**
   * The part that it is done to, by its number in cell array PartId [from -1, default -1: all of the mesh].
   */
  vtkSetClampMacro(Part, int, -1, VTK_INT_MAX);
  vtkGetMacro(Part, int);
  ///@}

  enum CopyType
  {
    CopyOff = 0,
    CopyMirrored = 1
  };
  ///@{
  /**
   * Add what has been moved once more, reflected in the mirror plane [default off].
   */
  vtkSetClampMacro(Copy, int, CopyOff, CopyMirrored);
  vtkGetMacro(Copy, int);
  void SetCopyToOff() { this->SetCopy(CopyOff); }
  void SetCopyToMirrored() { this->SetCopy(CopyMirrored); }
  ///@}

  enum MirrorAxisType
  {
    MirrorAxisX = 0,
    MirrorAxisY = 1,
    MirrorAxisZ = 2
  };
  ///@{
  /**
   * The axis that the mirror plane is upright on: there its coordinate is MirrorOffset [default x].
   */
  vtkSetClampMacro(MirrorAxis, int, MirrorAxisX, MirrorAxisZ);
  vtkGetMacro(MirrorAxis, int);
  void SetMirrorAxisToX() { this->SetMirrorAxis(MirrorAxisX); }
  void SetMirrorAxisToY() { this->SetMirrorAxis(MirrorAxisY); }
  void SetMirrorAxisToZ() { this->SetMirrorAxis(MirrorAxisZ); }
  ///@}

  ///@{
  /**
   * See MirrorAxis [model length, default 0].
   */
  vtkSetMacro(MirrorOffset, double);
  vtkGetMacro(MirrorOffset, double);
  ///@}

  /**
   * Makes the transform that such values are, of a thing with that middle.
   */
  static void Compose(const double move[3],
    const double turn[3],
    const double scale[3],
    const double middle[3],
    vtkTransform* transform);

  /**
   * "moved": how many points were placed; "copied": how many the copy has.
   */
  FigureList Figures() override { return this->Found; }

protected:
  vtkOversketchTransform() = default;
  ~vtkOversketchTransform() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  void RequireValues();

  double Move[3] = { 0.0, 0.0, 0.0 };
  double Turn[3] = { 0.0, 0.0, 0.0 };
  double Scale[3] = { 1.0, 1.0, 1.0 };
  int Part = -1;
  int Copy = CopyOff;
  int MirrorAxis = MirrorAxisX;
  double MirrorOffset = 0.0;

  FigureList Found; // of the last run
};

#endif
