/**
 * @class vtkOversketchHeldStrokeRepresentation
 * @brief the stroke of vtkOversketchHeldStrokeWidget that can be taken hold of, a line of text
 *
 * The stroke stands in the world: in the plane parallel to its picture through a place that is given with it.
 * In the view it was drawn in it is seen exactly as it was drawn: red, 3 px wide; under the cursor wider.
 * From elsewhere it is seen from there, thinner and half transparent: out of reach. It is never hidden by
 * what else is in the scene.
 *
 * The text stands in the lower left corner and needs VTK::RenderingFreeType.
 *
 * @sa vtkOversketchHeldStrokeWidget
 */
#ifndef vtkOversketchHeldStrokeRepresentation_h
#define vtkOversketchHeldStrokeRepresentation_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkWidgetRepresentation.h"

#include <memory>

class vtkPolyData;
class vtkProperty2D;
class vtkTextProperty;

class OVERSKETCHWIDGETSPEN_EXPORT vtkOversketchHeldStrokeRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkOversketchHeldStrokeRepresentation* New();
  vtkTypeMacro(vtkOversketchHeldStrokeRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The stroke, with its view, and a place [world] in the plane that it is to stand in. Null, or what is no
   * stroke with a view, takes it away.
   */
  void SetStroke(vtkPolyData* stroke, const double place[3]);

  ///@{
  /**
   * Whether there is a stroke; whether the renderer's camera is where it was drawn, so that it can be moved;
   * whether zoom and window are the same too, so that it can be drawn over.
   */
  bool HasStroke() const;
  bool IsInReach();
  bool IsInItsView();
  ///@}

  /**
   * Distance of a place in the window [px, y up] from the line as it is seen [px]; infinite without a stroke.
   */
  double DistanceTo(double x, double y);

  /**
   * Puts the renderer's camera where the stroke was drawn. The window keeps its size.
   */
  void LookFromStroke();

  ///@{
  /**
   * Moves the line in its plane, as seen from its view: by what brings the first place in the window [px] to
   * the second. GetTranslation is the vector [world]; PutMoved writes the stroke moved so. SetStroke ends it.
   */
  void Move(double fromX, double fromY, double toX, double toY);
  vtkGetVector3Macro(Translation, double);
  void PutMoved(vtkPolyData* stroke);
  ///@}

  ///@{
  /**
   * Whether the line is shown [default on]; whether it is under the cursor [default off].
   */
  vtkSetMacro(ShowStroke, bool);
  vtkGetMacro(ShowStroke, bool);
  vtkBooleanMacro(ShowStroke, bool);
  vtkSetMacro(Highlighted, bool);
  vtkGetMacro(Highlighted, bool);
  vtkBooleanMacro(Highlighted, bool);
  ///@}

  ///@{
  /**
   * Whether the line is seen, and can be met, also where the camera is not where it was drawn: in its plane,
   * it floats before or behind what it changed [default on]. Off for hosts that show it there in another way.
   */
  vtkSetMacro(ShowFromElsewhere, bool);
  vtkGetMacro(ShowFromElsewhere, bool);
  vtkBooleanMacro(ShowFromElsewhere, bool);
  ///@}

  ///@{
  /**
   * The line of text; empty (default) none.
   */
  void SetText(const char* text);
  const char* GetText();
  ///@}

  ///@{
  /**
   * Looks of the line in its view, of the text.
   */
  vtkProperty2D* GetProperty();
  vtkTextProperty* GetTextProperty();
  ///@}

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
  vtkOversketchHeldStrokeRepresentation();
  ~vtkOversketchHeldStrokeRepresentation() override;

private:
  bool ShowStroke = true;
  bool ShowFromElsewhere = true;
  bool Highlighted = false;
  double Translation[3] = { 0.0, 0.0, 0.0 };

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
