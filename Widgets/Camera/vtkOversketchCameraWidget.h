/**
 * @class vtkOversketchCameraWidget
 * @brief zoom slider and spin dial on screen, for a vtkOversketchInteractorStyle
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 4: the camera's slider
 * and dial. Left drag round the dial spins the picture by the angle that the cursor goes round its centre;
 * left drag up and down the slider zooms. Both count from the press, so a press alone changes nothing; Escape
 * goes back to it. Presses on them are not the pen's or the camera's; any others are. They show what keys and
 * wheel change.
 *
 * Fires StartInteractionEvent, InteractionEvent, EndInteractionEvent. Does nothing where the interactor's
 * style is not a vtkOversketchInteractorStyle.
 *
 * @sa vtkOversketchInteractorStyle vtkOversketchCameraRepresentation
 */
#ifndef vtkOversketchCameraWidget_h
#define vtkOversketchCameraWidget_h

#include "OversketchWidgetsCameraModule.h" // For export macro
#include "vtkAbstractWidget.h"

class vtkOversketchCameraRepresentation;

class OVERSKETCHWIDGETSCAMERA_EXPORT vtkOversketchCameraWidget : public vtkAbstractWidget
{
public:
  static vtkOversketchCameraWidget* New();
  vtkTypeMacro(vtkOversketchCameraWidget, vtkAbstractWidget);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void SetRepresentation(vtkOversketchCameraRepresentation* representation);
  vtkOversketchCameraRepresentation* GetCameraRepresentation();
  void CreateDefaultRepresentation() override;
  void SetEnabled(int enabling) override;

protected:
  vtkOversketchCameraWidget();
  ~vtkOversketchCameraWidget() override;

private:
  // Callbacks of the event translator.
  static void Press(vtkAbstractWidget* widget);
  static void Move(vtkAbstractWidget* widget);
  static void Release(vtkAbstractWidget* widget);
  static void Key(vtkAbstractWidget* widget);

  void Stop();

  int Dragging = 0; // vtkOversketchCameraRepresentation::InteractionStateType
  double Angle = 0.0, Y = 0.0, Spin = 0.0, Zoom = 1.0; // at the press
};

#endif
