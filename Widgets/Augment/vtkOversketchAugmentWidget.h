/**
 * @class vtkOversketchAugmentWidget
 * @brief draw a line on a mesh and it rises; the last line's width and height are turned with the wheel
 *
 * Source: "Sketch-based Adaptive Mesh Augmentation using Stellar Operators". A pen over a mesh
 * (vtkOversketchLiveStrokeWidget, whose header says what the hand does) and the system
 * (vtkOversketchAugment), for any vtkRenderWindowInteractor. The paper has no such pen; this one is the
 * house's.
 *
 * While the pen is down, under the stroke (red) and over the last frame: the curve on the surface (blue), the
 * crest as high as it will be (orange) and, thin, where the feature ends to either side. The same for a live
 * stroke that is moved; the mesh follows when it is let go. A stroke that is nowhere on the mesh leaves it as
 * it was and stays as the live stroke, to be corrected.
 *
 * | event | at any time, the pen in the air, on the mesh, or moving the stroke |
 * |---|---|
 * | Ctrl + wheel | the radius, by 1.1 a notch [0.001 to 1 of the mesh's diagonal] |
 * | Shift + wheel | the height, by a tenth of the radius a notch, through to carving and back [at most the
 * diagonal] | | wheel | the camera's; swallowed while the pen draws or the stroke is moved |
 *
 * They are parameters of the system (GetAugment): of the live stroke and of those that come. A stroke that is
 * dropped while it is drawn takes back what the wheel has done since it began. There is no height of 0, which
 * the system reads as half the radius. In silhouette mode the sketch is the height, and Shift + wheel the
 * camera's.
 *
 * @sa vtkOversketchLiveStrokeWidget, vtkOversketchAugment
 */
#ifndef vtkOversketchAugmentWidget_h
#define vtkOversketchAugmentWidget_h

#include "OversketchWidgetsAugmentModule.h" // For export macro
#include "vtkOversketchLiveStrokeWidget.h"

class vtkOversketchAugment;

class OVERSKETCHWIDGETSAUGMENT_EXPORT vtkOversketchAugmentWidget : public vtkOversketchLiveStrokeWidget
{
public:
  static vtkOversketchAugmentWidget* New();
  vtkTypeMacro(vtkOversketchAugmentWidget, vtkOversketchLiveStrokeWidget);

  ///@{
  /**
   * The system that runs, for its parameters: after a change the mesh follows with the next render. One of
   * the host's may be set; the widget connects its inputs.
   */
  void SetAugment(vtkOversketchAugment* system);
  vtkOversketchAugment* GetAugment();
  ///@}

protected:
  vtkOversketchAugmentWidget();
  ~vtkOversketchAugmentWidget() override;

  void Look(vtkPolyData* mesh, vtkPolyData* stroke) override;
  bool LooksWhileMoving() const override { return true; }
  void LineBegins() override;
  void LineEnds() override;
  bool UseWheel(int notches) override;

private:
  double RadiusBefore = 0.0, HeightBefore = 0.0; // the stroke that is drawn
  vtkMTimeType StrokeBefore = 0;                 // when the pen's last stroke was made
};

#endif
