/**
 * @class vtkOversketchCameraRepresentation
 * @brief zoom slider and spin dial of vtkOversketchCameraWidget
 *
 * In the lower right corner of the viewport: a dial of 30 px radius whose knob stands at the spin (0 at the
 * top, counter-clockwise), and above it an upright slider of 100 px, logarithmic from 0.1 to 10, with a tick
 * at 1. They show what the interactor's vtkOversketchInteractorStyle says; without one they show 1 and 0.
 *
 * @sa vtkOversketchCameraWidget
 */
#ifndef vtkOversketchCameraRepresentation_h
#define vtkOversketchCameraRepresentation_h

#include "OversketchWidgetsCameraModule.h" // For export macro
#include "vtkNew.h"                        // For the actors
#include "vtkWidgetRepresentation.h"

class vtkActor2D;
class vtkOversketchInteractorStyle;
class vtkPolyData;

class OVERSKETCHWIDGETSCAMERA_EXPORT vtkOversketchCameraRepresentation : public vtkWidgetRepresentation
{
public:
  static vtkOversketchCameraRepresentation* New();
  vtkTypeMacro(vtkOversketchCameraRepresentation, vtkWidgetRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum InteractionStateType
  {
    Outside = 0,
    OnDial = 1,
    OnSlider = 2
  };

  /**
   * What is at a display position [px]: Outside, OnDial (its disc) or OnSlider (8 px either side of the
   * track).
   */
  int ComputeInteractionState(int x, int y, int modify = 0) override;

  /**
   * Angle of a display position about the dial's centre [degrees, 0 at the top, counter-clockwise].
   */
  double GetDialAngle(double x, double y);

  /**
   * Zoom over that of a place further down the slider [1], for a distance up the track [px].
   */
  double GetZoomRatio(double pixels) const;

  /**
   * The style that is steered: that of the renderer's interactor, null where it is another.
   */
  vtkOversketchInteractorStyle* GetStyle();

  ///@{
  /**
   * As a prop.
   */
  void BuildRepresentation() override;
  void GetActors2D(vtkPropCollection* actors) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;
  int RenderOverlay(vtkViewport* viewport) override;
  ///@}

protected:
  vtkOversketchCameraRepresentation();
  ~vtkOversketchCameraRepresentation() override;

private:
  // Display position in px from the dial's centre.
  void FromCentre(double x, double y, double out[2]);

  vtkNew<vtkPolyData> Lines, Knobs;
  vtkNew<vtkActor2D> LinesActor, KnobsActor;
};

#endif
