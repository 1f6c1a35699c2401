/**
 * @class vtkOversketchRegionRepresentation
 * @brief the line and the ring of vtkOversketchRegionWidget on the model
 *
 * The line is red, the ring blue, both with a light rim, over all else in the scene. The one that a stroke
 * with Shift would change is wider.
 *
 * @sa vtkOversketchRegionWidget
 */
#ifndef vtkOversketchRegionRepresentation_h
#define vtkOversketchRegionRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchRegionRepresentation : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchRegionRepresentation* New();
  vtkTypeMacro(vtkOversketchRegionRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Grips
  {
    Reference = 1,
    Boundary = 2
  };

  ///@{
  /**
   * Polylines in the world; null: none.
   */
  void SetReference(vtkPolyData* line);
  void SetBoundary(vtkPolyData* ring);
  ///@}

  ///@{
  /**
   * Whether the line is shown where it was, as an edit has moved it: thin. Default off.
   */
  vtkSetMacro(LineWas, bool);
  vtkGetMacro(LineWas, bool);
  ///@}

  /**
   * How far a place of the window [px, y up] is from a curve as it is seen [px]; infinite where there is
   * none.
   */
  double DistanceTo(int curve, double x, double y);

protected:
  vtkOversketchRegionRepresentation();
  ~vtkOversketchRegionRepresentation() override;

  int FindGrip(const oversketch::View& view, double x, double y) override;
  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  bool LineWas = false;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
