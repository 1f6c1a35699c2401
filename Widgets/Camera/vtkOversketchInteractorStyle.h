/**
 * @class vtkOversketchInteractorStyle
 * @brief the camera for drawing on models: turn, pan, zoom, spin and a key for each view
 *
 * Source: R. Bujans, "Sketch-Based Techniques for Mesh Deformation and Editing", Ch. 4, App. A, Table 1.
 *
 * | mouse | what it does | without a middle button |
 * |---|---|---|
 * | middle drag | turn (see Orbit) | Alt or Ctrl + left drag |
 * | right drag, Shift or Alt + middle drag | pan: the point under the cursor stays there | Shift, also with
 * Alt, + left drag | | wheel, Ctrl + middle drag up or down | zoom; of the wheel what is under the cursor
 * stays there | Ctrl + Shift + left drag |
 *
 * A zoom magnifies the picture: the eye stays where it is (vtkCamera::WindowCenter moves), so that what is
 * drawn in a view can be seen enlarged. A turn begins where the picture is.
 *
 * Plain left drag turns too in the mode Navigate; in the mode Draw it belongs to the tool that draws, and the
 * style leaves it alone. Middle drag turns in both. (Alt + left is what modelling programs use; Ctrl + left
 * is there because many window managers keep Alt + left for themselves.) Escape during a drag takes the
 * camera back to where it was pressed. A turn that starts beside the models is about their middle.
 *
 * | key | alone | with Shift |
 * |---|---|---|
 * | r | spin the picture counter-clockwise | clockwise |
 * | x, y, z | look along +x, +y, +z | along -x, -y, -z |
 * | 1, 2, 3 | turn clockwise about x, y, z | counter-clockwise |
 * | w | back to the first view | |
 * | c | centre the camera on the mesh | |
 * | h | spin clockwise | pan in |
 * | l | spin counter-clockwise | pan out |
 * | i, m, j, k | rotate the camera up, down, left, right | pan it up, down, left, right |
 * | p | zoom out | pan in |
 * | n | zoom in | pan out |
 * | ?, F1 | show or hide the list of keys and the mode | |
 * | q | quit (vtkRenderWindowInteractor::ExitCallback) | |
 *
 * Steps: 5 degrees; 5 % of the view's height at the focal point; zoom by 1.1. "Clockwise about an axis" turns
 * the camera by -5 degrees (right hand) about the world's axis through the focal point. Keys with Ctrl or Alt
 * are left to the host. h is the table's, so the list of keys is on ? and F1.
 *
 * Departures: the table's keys 6 to 0 (planes of the profile editor) are not here. VTK's own keys (m, q, e,
 * f, u, s, 3, p, i, ...) do nothing: this style has none, and characters of the table above do not reach
 * other observers of the interactor's CharEvent, so that i does not switch off VTK's widgets.
 *
 * Fires StartInteractionEvent, InteractionEvent and EndInteractionEvent for each drag and each key that moves
 * the camera. The list of keys needs VTK::RenderingFreeType.
 *
 * @sa vtkOversketchCameraWidget (zoom slider and spin dial on screen), vtkOversketchStrokeWidget
 */
#ifndef vtkOversketchInteractorStyle_h
#define vtkOversketchInteractorStyle_h

#include "OversketchWidgetsCameraModule.h" // For export macro
#include "vtkInteractorStyle.h"

#include <memory>

class vtkPolyData;

class OVERSKETCHWIDGETSCAMERA_EXPORT vtkOversketchInteractorStyle : public vtkInteractorStyle
{
public:
  static vtkOversketchInteractorStyle* New();
  vtkTypeMacro(vtkOversketchInteractorStyle, vtkInteractorStyle);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ModeType
  {
    Navigate = 0,
    Draw = 1
  };

  ///@{
  /**
   * Whose the left button is: the camera's (Navigate, default) or a tool's (Draw).
   */
  void SetMode(int mode);
  vtkGetMacro(Mode, int);
  void SetModeToNavigate() { this->SetMode(Navigate); }
  void SetModeToDraw() { this->SetMode(Draw); }
  ///@}

  enum OrbitType
  {
    Trackball = 0,
    Turntable = 1
  };

  ///@{
  /**
   * How a drag turns: freely, so that the picked point of the mesh stays under the cursor (Trackball, the
   * thesis's and the default), or upright, about the world's axis that is up and the picture's horizontal,
   * half a turn for the view's height, about the picked point (Turntable).
   */
  vtkSetClampMacro(Orbit, int, Trackball, Turntable);
  vtkGetMacro(Orbit, int);
  void SetOrbitToTrackball() { this->SetOrbit(Trackball); }
  void SetOrbitToTurntable() { this->SetOrbit(Turntable); }
  ///@}

  ///@{
  /**
   * The world's axis that is up [1 for y, the default, or 2 for z], for upright turns and views from a side.
   */
  vtkSetClampMacro(UpAxis, int, 1, 2);
  vtkGetMacro(UpAxis, int);
  ///@}

  ///@{
  /**
   * One movement of a gesture, by so many pixels to the right and up: an upright turn about the models'
   * middle; a pan; a zoom by a factor with what is seen at a display position staying there. Nothing during a
   * drag.
   */
  void TurnBy(double x, double y);
  void PanBy(double x, double y);
  void ZoomAt(double factor, double x, double y);
  ///@}

  ///@{
  /**
   * Orthographic or perspective, of the same size where the camera looks at, from the same place.
   * Perspective, and without effect, while there is no camera.
   */
  void SetParallelProjection(bool parallel);
  bool GetParallelProjection();
  ///@}

  ///@{
  /**
   * Apparent size, in multiples of that in the first view [0.1 to 10, default 1]: the parallel scale is
   * divided by it, or the tangent of half the view angle. A slider is best logarithmic. Setting it renders.
   * 1, and without effect, while there is no camera.
   */
  void SetZoom(double zoom);
  double GetZoom();
  ///@}

  ///@{
  /**
   * Turn about the view axis, counter-clockwise in the picture, for a dial [degrees, any; kept in [0, 360),
   * default 0]. What spins by key changes it too; a view along an axis or the first view sets it to 0.
   * Setting it renders. 0, and without effect, while there is no camera.
   */
  void SetSpin(double degrees);
  double GetSpin();
  ///@}

  ///@{
  /**
   * Whether the list of keys and the mode are on screen. Default off.
   */
  void SetShowKeys(bool show);
  vtkGetMacro(ShowKeys, bool);
  vtkBooleanMacro(ShowKeys, bool);
  ///@}

  ///@{
  /**
   * What that list says, UTF-8. Null or empty (default): the mode and the keys above, in English. For hosts
   * with keys or a language of their own.
   */
  void SetKeyList(const char* text);
  const char* GetKeyList() const;
  ///@}

  /**
   * Makes the present view the first view, that of key w and of Zoom 1. Without it, the first view of a
   * camera is the one before this style first changes it; call it after loading another model.
   */
  void SaveFirstView();

  ///@{
  /**
   * What keys w, c, and x, y, z with their Shift do (axis 0, 1, 2).
   */
  void ResetToFirstView();
  void CenterOnMesh();
  void LookAlong(int axis, bool against);
  ///@}

  /**
   * Looks at the models' middle from the positive or the negative side of an axis, upright: with axis 2 front
   * and back, 0 right and left, 1 top and bottom; where z is up 2 is top and bottom, and 1 back and front.
   */
  void LookFromSide(int axis, bool negative);

  /**
   * Puts the camera where a stroke was drawn that carries its view (vtkOversketchStrokeWidget::GetStroke);
   * the window keeps its size, and of another size (FollowSize) it shows across its smaller side what the
   * stroke's did. False, and nothing changed, without a renderer, during a drag, or for another
   * polydata.
   */
  bool LookFrom(vtkPolyData* stroke);

  /**
   * The view has another size [px, width and height] than it had: what was seen across the smaller of its
   * sides, about its middle, is seen across the smaller side again, in this view and in the first view. VTK's
   * camera keeps what is seen from top to bottom, so that a view narrower than high cuts a model that was
   * whole. Zoom stays, nothing is rendered. False, and nothing changed, without a camera and during a drag.
   */
  bool FollowSize(const int before[2], const int now[2]);

  void SetInteractor(vtkRenderWindowInteractor* interactor) override;

  ///@{
  /**
   * Events of the interactor.
   */
  void OnMouseMove() override;
  void OnLeftButtonDown() override;
  void OnLeftButtonUp() override;
  void OnMiddleButtonDown() override;
  void OnMiddleButtonUp() override;
  void OnRightButtonDown() override;
  void OnRightButtonUp() override;
  void OnMouseWheelForward() override;
  void OnMouseWheelBackward() override;
  void OnKeyPress() override;
  void OnChar() override {}
  ///@}

protected:
  vtkOversketchInteractorStyle();
  ~vtkOversketchInteractorStyle() override;

private:
  int Mode = Navigate;
  int Orbit = Trackball;
  int UpAxis = 1;
  bool ShowKeys = false;

  struct Internals;
  std::unique_ptr<Internals> Inner;
};

#endif
