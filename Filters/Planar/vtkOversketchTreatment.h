/**
 * @class vtkOversketchTreatment
 * @brief which closed strokes of a drawing are holes, and which tunnels
 *
 * Source: "Image-Assisted Modeling from Sketches", Sec. 2.3.1: every region is filled unless the user makes
 * it a hole, sealed front to back, or a tunnel, cut through the model. It stands behind
 * vtkOversketchClassify, so that a click in a region classifies nothing anew.
 *
 * Input 0 (Curves): curves of vtkOversketchClassify. Stroke i is cell i.
 *
 * Output 0 (Curves): the same, points and all arrays passed, and
 * - cell array Treatment, int: 0 fill, 1 hole, 2 tunnel. What Holes and Tunnels do not name stays what the
 *   input's array Treatment says, and is filled where there is none.
 *
 * Errors (vtkErrorCode::UserError + oversketch::Failure): MissingArray without Role; BadStroke, naming the
 * stroke, for a number that no stroke has, one of a stroke that is no closed feature, one that is both, and
 * for a text that is no list of numbers. Curves without points give an empty output silently.
 *
 * Deterministic. Cost: none to speak of.
 *
 * @sa vtkOversketchClassify vtkOversketchDistance
 */
#ifndef vtkOversketchTreatment_h
#define vtkOversketchTreatment_h

#include "OversketchFiltersPlanarModule.h" // For export macro
#include "vtkOversketchFilter.h"

#include <string>

class OVERSKETCHFILTERSPLANAR_EXPORT vtkOversketchTreatment : public vtkOversketchFilter
{
public:
  static vtkOversketchTreatment* New();
  vtkTypeMacro(vtkOversketchTreatment, vtkOversketchFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Numbers of the closed strokes that are holes, from 0, apart by spaces or commas [default none].
   */
  void SetHoles(const char* text);
  const char* GetHoles() const { return this->Holes.c_str(); }
  ///@}

  ///@{
  /**
   * Numbers of the closed strokes that are tunnels [default none].
   */
  void SetTunnels(const char* text);
  const char* GetTunnels() const { return this->Tunnels.c_str(); }
  ///@}

protected:
  vtkOversketchTreatment() = default;
  ~vtkOversketchTreatment() override = default;

  void Execute(vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  std::string Holes;
  std::string Tunnels;
};

#endif
