/**
 * @class vtkOversketchDrawingRepresentation
 * @brief the picture of vtkOversketchDrawingWidget: canvas or picture, and the curves of the drawing
 *
 * The picture lies at z = 0, its outermost samples drawn whole (vtkImageActor::BorderOn); without one there
 * is a white canvas. Under a picture with alpha there are checks, light and dark. Curves lie over it,
 * coloured by what they are: boundaries red, closed features blue, open ones green, rejected ones grey, one
 * that is at fault orange with a ring where it is. One that bounds a body in front is purple, behind purple
 * and dashed, on both sides purple with dark dashes. A region that is to be a hole is shaded dark, one that
 * is to be a tunnel violet. A line of text stands below.
 *
 * @sa vtkOversketchDrawingWidget
 */
#ifndef vtkOversketchDrawingRepresentation_h
#define vtkOversketchDrawingRepresentation_h

#include "OversketchWidgetsDrawingModule.h" // For export macro
#include "vtkWidgetRepresentation.h"

#include <memory>

class vtkImageData;
class vtkPolyData;
class vtkProperty;

class OVERSKETCHWIDGETSDRAWING_EXPORT vtkOversketchDrawingRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkOversketchDrawingRepresentation* New();
  vtkTypeMacro(vtkOversketchDrawingRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * What is drawn on: a picture of 8 bits (null: none), or a white rectangle from its lower left corner
   * [world]. The one takes the other away.
   */
  void SetPicture(vtkImageData* picture);
  void SetCanvas(double x, double y, double width, double height);
  ///@}

  /**
   * Curves of vtkOversketchClassify or vtkOversketchTreatment: cell arrays Role and, where there are such,
   * Treatment and Depth. Null: none.
   */
  void SetCurves(vtkPolyData* curves);

  /**
   * A stroke that is at fault (cell array StrokeId of the curves, read by the next SetCurves; -1: none), and
   * the place where it is [world; null: none that is known].
   */
  void SetFault(int stroke, const double place[2]);

  ///@{
  /**
   * The line of text; empty: none.
   */
  void SetText(const char* text);
  const char* GetText();
  ///@}

  /**
   * Width and opacity of the curves.
   */
  vtkProperty* GetCurveProperty();

  ///@{
  /**
   * As a prop.
   */
  void BuildRepresentation() override;
  double* GetBounds() VTK_SIZEHINT(6) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkOversketchDrawingRepresentation();
  ~vtkOversketchDrawingRepresentation() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
