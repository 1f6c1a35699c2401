/**
 * @class vtkOversketchPushBetween
 * @brief two strokes and a picture push a part of a mesh
 *
 * A toy: Testing/Toy adds it to a copy of the sources, as CONTRIBUTING.md says. Steps: clean strokes
 * {FirstStroke}, {SecondStroke}, the push {Push}.
 *
 * Input 0 (Mesh): triangle mesh, vtkPolyData.
 * Input 1 (First stroke): one stroke with its view (cell arrays ViewTransform, ProjectionTransform,
 * ViewportSize).
 * Input 2 (Second stroke): one more, in the same picture.
 * Input 3 (Brightness, vtkImageData): see vtkOversketchPush.
 *
 * Output 0: the mesh with moved points; points and cells keep their ids.
 *
 * Errors: as of vtkOversketchSystem. A mesh without points gives an empty output silently.
 *
 * Deterministic.
 *
 * @sa vtkOversketchPush
 */
#ifndef vtkOversketchPushBetween_h
#define vtkOversketchPushBetween_h

#include "OversketchFiltersPushBetweenModule.h" // For export macro
#include "vtkOversketchSystem.h"

#include <memory>

class OVERSKETCHFILTERSPUSHBETWEEN_EXPORT vtkOversketchPushBetween : public vtkOversketchSystem
{
public:
  static vtkOversketchPushBetween* New();
  vtkTypeMacro(vtkOversketchPushBetween, vtkOversketchSystem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SenseType
  {
    Out = 0,
    In = 1
  };

  ///@{
  /**
   * See vtkOversketchPush. Default Out.
   */
  void SetSense(int sense);
  int GetSense() const;
  void SetSenseToOut() { this->SetSense(Out); }
  void SetSenseToIn() { this->SetSense(In); }
  ///@}

  ///@{
  /**
   * See vtkOversketchPush [share of the diagonal of the bounding box]. Default 0.05.
   */
  void SetLength(double length);
  double GetLength() const;
  ///@}

protected:
  vtkOversketchPushBetween();
  ~vtkOversketchPushBetween() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOversketchPushBetween(const vtkOversketchPushBetween&) = delete;
  void operator=(const vtkOversketchPushBetween&) = delete;

  struct Steps;
  std::unique_ptr<Steps> Inner;
};

#endif
