/**
 * @class vtkOversketchPush
 * @brief pushes what lies between two strokes by the brightness of a picture
 *
 * A toy: Testing/Toy adds it to a copy of the sources, as CONTRIBUTING.md says.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData.
 * Input 1 (First stroke): one stroke with its view (cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize).
 * Input 2 (Second stroke): one more, in the same picture.
 * Input 3 (Brightness, vtkImageData): a picture that lies over the view; the mean of up to three components,
 * 255 the brightest.
 *
 * Output 0: the mesh with moved points, double. Cells and arrays are passed.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): BadMesh, MissingArray, BadStroke. A mesh without
 * points gives an empty output silently.
 *
 * Deterministic. Cost: linear in points times samples.
 *
 * @sa vtkOversketchPushBetween
 */
#ifndef vtkOversketchPush_h
#define vtkOversketchPush_h

#include "OversketchFiltersPushModule.h" // For export macro
#include "vtkOversketchFilter.h"

class OVERSKETCHFILTERSPUSH_EXPORT vtkOversketchPush : public vtkOversketchFilter
{
public:
  static vtkOversketchPush* New();
  vtkTypeMacro(vtkOversketchPush, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SenseType
  {
    Out = 0,
    In = 1
  };

  ///@{
  /**
   * Where it goes: Out (default) or In.
   */
  vtkSetClampMacro(Sense, int, Out, In);
  vtkGetMacro(Sense, int);
  void SetSenseToOut() { this->SetSense(Out); }
  void SetSenseToIn() { this->SetSense(In); }
  ///@}

  ///@{
  /**
   * How far, where the picture is brightest [share of the diagonal of the bounding box, 0 to 1, default
   * 0.05].
   */
  vtkSetClampMacro(Length, double, 0.0, 1.0);
  vtkGetMacro(Length, double);
  ///@}

protected:
  vtkOversketchPush();
  ~vtkOversketchPush() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkOversketchPush(const vtkOversketchPush&) = delete;
  void operator=(const vtkOversketchPush&) = delete;

  int Sense = Out;
  double Length = 0.05;
};

#endif
