/**
 * @class vtkOversketchMask
 * @brief lassos over a mesh mask what they enclose: no step moves it
 *
 * Source: ours; none of the papers has it. Points that a lasso encloses in the picture, and that nothing
 * hides there, are masked or freed; then the mask grows or shrinks, then it is inverted. Every system keeps
 * masked points: vtkOversketchOneStroke, vtkOversketchEdit, vtkOversketchAugment, vtkOversketchRelax,
 * vtkOversketchPose, vtkOversketchTransform.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData; borders, non-manifold edges and any orientation are tolerated.
 * Point array Mask, where it has one, is the mask so far. Points that share a position are one: they get one
 * value, of several that they had the largest.
 * Input 1 (Strokes, optional): lassos: polylines in display coordinates with cell arrays ViewTransform,
 * ProjectionTransform, ViewportSize; any number, each with its own view, all at once. A straight line closes
 * each from its last to its first sample. One that crosses itself encloses what a line outwards meets an odd
 * number of times.
 *
 * Output 0: the mesh, its points untouched, with point array
 * - Mask, float: 1: no step moves the point; 0: free; between, as at new points and from other programs: the
 *   point follows by 1 - Mask where a step can, else is free.
 * Other arrays are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh; MissingArray for a Mask that is not one
 * finite number a point; BadStroke, naming the stroke, for fewer than three samples and values that are not
 * finite, where the lassos together enclose no point, and where there is neither a lasso nor anything else to
 * do. An empty mesh gives an empty output silently. A run that AbortExecute stopped needs Modified() before
 * the next.
 *
 * Deterministic: same result bit for bit for any number of threads. The first lasso on a mesh makes its ray
 * scene; each further one takes a look at each point of the mesh, and a ray for each that it encloses.
 *
 * @sa vtkOversketchRelax
 */
#ifndef vtkOversketchMask_h
#define vtkOversketchMask_h

#include "OversketchFiltersMaskModule.h" // For export macro
#include "vtkOversketchSystem.h"

class OVERSKETCHFILTERSMASK_EXPORT vtkOversketchMask : public vtkOversketchSystem
{
public:
  static vtkOversketchMask* New();
  vtkTypeMacro(vtkOversketchMask, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetStrokesConnection(vtkAlgorithmOutput* strokes) { this->SetInputConnection(1, strokes); }
  void SetStrokesData(vtkPolyData* strokes) { this->SetInputData(1, strokes); }

  enum ModeType
  {
    Add = 0,      // masked is also what the lassos enclose
    Subtract = 1, // that is freed
    Replace = 2   // that alone is masked; without a lasso nothing is
  };
  ///@{
  /**
   * What lassos do to the mask [default Add].
   */
  vtkSetClampMacro(Mode, int, Add, Replace);
  vtkGetMacro(Mode, int);
  void SetModeToAdd() { this->SetMode(Add); }
  void SetModeToSubtract() { this->SetMode(Subtract); }
  void SetModeToReplace() { this->SetMode(Replace); }
  ///@}

  ///@{
  /**
   * Take also what is hidden in the picture, such as the back [default off].
   */
  vtkSetMacro(Through, bool);
  vtkGetMacro(Through, bool);
  vtkBooleanMacro(Through, bool);
  ///@}

  ///@{
  /**
   * How far the mask grows over the surface, along edges; below 0 points so near to one that is not masked
   * are freed [model length; default 0].
   */
  vtkSetMacro(Grow, double);
  vtkGetMacro(Grow, double);
  ///@}

  ///@{
  /**
   * Mask what is free and free what is masked, after all else [default off].
   */
  vtkSetMacro(Invert, bool);
  vtkGetMacro(Invert, bool);
  vtkBooleanMacro(Invert, bool);
  ///@}

  bool Prepare() override;
  /**
   * "masked": how many points of the output are; "of_points": how many there are.
   */
  FigureList Figures() override;

protected:
  vtkOversketchMask();
  ~vtkOversketchMask() override = default;

  int RequestData(vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  int Mode = Add;
  bool Through = false;
  double Grow = 0.0;
  bool Invert = false;

  struct Inner;
};

#endif
