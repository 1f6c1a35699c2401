/**
 * @class vtkOversketchStrokeRepresentation
 * @brief the stroke of vtkOversketchStrokeWidget: its samples, its view, its picture
 *
 * Holds the stroke that is being drawn and the one that was drawn last, both with the view of the renderer at
 * their first sample. The colour is the paper's red, the line 3 px wide.
 *
 * While a stroke is drawn the window's last frame is kept as a picture, its renderers are switched off
 * (vtkRenderer::Draw) and each frame is that picture and the stroke over it: a frame costs the same however
 * large the scene is. Other things in the window stand still until the pen is up. Should the picture not be
 * readable, the scene is drawn each time.
 *
 * The stroke drawn last is shown while the renderer's view is the stroke's: it lies in the picture, not on
 * the model. It goes with the next stroke or Clear.
 *
 * @sa vtkOversketchStrokeWidget
 */
#ifndef vtkOversketchStrokeRepresentation_h
#define vtkOversketchStrokeRepresentation_h

#include "OversketchWidgetsPenModule.h" // For export macro
#include "vtkWidgetRepresentation.h"

#include <memory>

class vtkPolyData;
class vtkProperty2D;

class OVERSKETCHWIDGETSPEN_EXPORT vtkOversketchStrokeRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkOversketchStrokeRepresentation* New();
  vtkTypeMacro(vtkOversketchStrokeRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Begins a stroke: takes the renderer's view and the window's last frame. Without a renderer or while a
   * stroke is being drawn it does nothing. The stroke drawn last is hidden, or shown to be drawn over where
   * `over` is true and it has the renderer's view.
   */
  void BeginStroke(bool over);

  /**
   * Adds a sample: position in the window [px from its lower left corner, y up], pressure [0 to 1], time
   * since the stroke began [s]. Without a stroke it does nothing.
   */
  void AddSample(double x, double y, double pressure, double time);

  /**
   * Takes samples off the end: at least one, and as many as lie within the given length of path [px] from the
   * end, of the stroke being drawn, else of the one drawn last.
   */
  void RemoveLast(double length);

  /**
   * Ends the stroke being drawn. With fewer than two samples it is dropped. A stroke that is to be drawn over
   * is replaced in part (oversketch::resketch). Returns whether the stroke drawn last has changed.
   */
  bool EndStroke();

  ///@{
  /**
   * Drops the stroke being drawn; both strokes.
   */
  void DropStroke();
  void Clear();
  ///@}

  ///@{
  /**
   * Whether a stroke is being drawn; whether its view still has the renderer's size.
   */
  bool IsDrawing() const;
  bool FitsRenderer();
  ///@}

  /**
   * Samples of the stroke being drawn, else of the one drawn last.
   */
  vtkIdType GetNumberOfSamples() const;

  /**
   * The same stroke as a polydata: one polyline in display coordinates [px from the viewport's lower left
   * corner, y up], point arrays Pressure (float) and Time (double, s since the stroke began), cell arrays
   * ViewTransform, ProjectionTransform (double, 16 components, row-major) and ViewportSize (int, 2
   * components). Empty without samples.
   */
  void GetPolyData(vtkPolyData* stroke);

  /**
   * Makes a stroke with its view (as GetPolyData gives it; Pressure and Time may be missing) the one drawn
   * last. False, and nothing changed, while one is being drawn or when it holds no such stroke.
   */
  bool SetStroke(vtkPolyData* stroke);

  /**
   * The renderer's present view as a stroke of one sample, for what depends on the view alone. Empty without
   * a renderer.
   */
  void PutView(vtkPolyData* stroke);

  /**
   * Lines to be shown under the stroke while it is drawn, as the section that it would take hold of:
   * polylines; point array Display, 2 components, are their places [px from the viewport's lower left
   * corner], else their points [world] are seen as the stroke is. Null, and the end of the stroke, take them
   * away.
   */
  void SetSection(vtkPolyData* section);

  ///@{
  /**
   * The stroke itself, while it is drawn, as the section: a band under it that grows with it, for a pen whose
   * stroke moves within the section's width. Off with the end of the stroke.
   */
  void SetSectionFollows(bool follows);
  bool GetSectionFollows() const;
  ///@}

  /**
   * Lines in the world that say what the stroke would make, over all else, whether one is drawn or not: of
   * cell array Part 0 (or without that array) strong, others thin (vtkOversketchAugment::PreviewCrest). Null,
   * and the end of the stroke, take them away.
   */
  void SetCrest(vtkPolyData* crest);

  ///@{
  /**
   * Colour, width and opacity of the stroke (red), of the section (blue), of the crest (orange; its thin
   * lines are half as wide).
   */
  vtkProperty2D* GetProperty();
  vtkProperty2D* GetSectionProperty();
  vtkProperty2D* GetCrestProperty();
  ///@}

  ///@{
  /**
   * As a prop.
   */
  void SetRenderer(vtkRenderer* renderer) override;
  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkOversketchStrokeRepresentation();
  ~vtkOversketchStrokeRepresentation() override;

private:
  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
