/**
 * @class vtkOversketchGripRepresentation
 * @brief what the representations with grips share: what is under the cursor, a picture in pixels, a line of
 * text
 *
 * A grip is a part that the hand can take hold of; heirs number theirs from 1 and paint them over all else in
 * the scene. The one under the cursor, or in the hand, is painted stronger.
 *
 * The text stands in the lower left corner and needs VTK::RenderingFreeType.
 *
 * @sa vtkOversketchGripWidget
 */
#ifndef vtkOversketchGripRepresentation_h
#define vtkOversketchGripRepresentation_h

#include "OversketchWidgetsEditModule.h" // For export macro
#include "vtkWidgetRepresentation.h"

#include <memory>

class vtkActor;
class vtkTextProperty;

namespace oversketch
{
class Overlay;
class View;
}

class OVERSKETCHWIDGETSEDIT_EXPORT vtkOversketchGripRepresentation : public vtkWidgetRepresentation
{
public:
  vtkAbstractTypeMacro(vtkOversketchGripRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The grip at a place of the window [px, y up]; 0 where there is none.
   */
  int GetGripAt(double x, double y);

  ///@{
  /**
   * The grip that is painted stronger; 0 (default): none.
   */
  vtkSetMacro(ActiveGrip, int);
  vtkGetMacro(ActiveGrip, int);
  ///@}

  ///@{
  /**
   * How near to a grip the cursor takes hold of it [px, 0 to 50, default 8].
   */
  vtkSetClampMacro(GrabDistance, double, 0.0, 50.0);
  vtkGetMacro(GrabDistance, double);
  ///@}

  ///@{
  /**
   * The line of text; empty (default): none.
   */
  void SetText(const char* text);
  const char* GetText();
  ///@}

  /**
   * Looks of the text.
   */
  vtkTextProperty* GetTextProperty();

  ///@{
  /**
   * As a prop.
   */
  void BuildRepresentation() override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkOversketchGripRepresentation();
  ~vtkOversketchGripRepresentation() override;

  // In a view of the renderer, x and y from the viewport's lower left corner [px]; without grips, or nothing
  // to be painted, an heir leaves it.
  virtual int FindGrip(const oversketch::View&, double, double) { return 0; }
  virtual void Paint(const oversketch::View&, oversketch::Overlay&) {}
  // Draws an actor in the scene, too, while it is visible.
  void AddActor(vtkActor* actor);

private:
  int ActiveGrip = 0;
  double GrabDistance = 8.0;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
