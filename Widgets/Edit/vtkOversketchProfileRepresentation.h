/**
 * @class vtkOversketchProfileRepresentation
 * @brief a profile in its own window: the section, what it is drawn anew as, and which way is outward
 *
 * In the plane z = 0, as vtkOversketchCrossSection lays it: from orange at its left end to blue, as on the
 * model; red what it is to be. A grey line joins its ends, an arrow points from the middle of the section
 * outward.
 *
 * @sa vtkOversketchProfilePlaneWidget
 */
#ifndef vtkOversketchProfileRepresentation_h
#define vtkOversketchProfileRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkOversketchGripRepresentation.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchProfileRepresentation : public vtkOversketchGripRepresentation
{
public:
  static vtkOversketchProfileRepresentation* New();
  vtkTypeMacro(vtkOversketchProfileRepresentation, vtkOversketchGripRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Output 0 of vtkOversketchCrossSection; null or empty: none. Strokes drawn over it, with views onto its
   * plane, each of which replaces a part of what is there by the rules of vtkOversketchResketch; null: none.
   */
  void SetProfile(vtkPolyData* profile, vtkPolyData* strokes);

  /**
   * The profile with all strokes: a polyline in its plane; empty without a profile.
   */
  void GetDrawn(vtkPolyData* drawn);

  /**
   * Puts the renderer's camera straight before the profile, with room round it for what is to be drawn.
   */
  void ResetView();

protected:
  vtkOversketchProfileRepresentation();
  ~vtkOversketchProfileRepresentation() override;

  void Paint(const oversketch::View& view, oversketch::Overlay& overlay) override;

private:
  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
