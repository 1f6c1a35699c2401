// A camera as the interactor style moves it: taken at a press, changed, put back.
#ifndef oversketch_widgets_camera_camera_state_h
#define oversketch_widgets_camera_camera_state_h

#include "OversketchWidgetsCameraModule.h" // For export macro

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <Eigen/Geometry>

class vtkCamera;
class vtkRenderer;

namespace oversketch
{

using Line = Eigen::ParametrizedLine<double, 3>;

struct OVERSKETCHWIDGETSCAMERA_EXPORT CameraState
{
  Eigen::Vector3d position, focal, up;
  double angle = 30.0, scale = 1.0;
  // Place of the picture in what the eye sees, as vtkCamera::WindowCenter: a zoom at the cursor moves it, not
  // the eye, so that what is seen in its own view alone (pictures, strokes) stays.
  Eigen::Vector2d centre;

  explicit CameraState(vtkCamera* camera);
  void putInto(vtkCamera* camera) const;
  Eigen::Vector3d direction() const { return (this->focal - this->position).normalized(); }
  // Turns the camera about its focal point, or another.
  void turn(const Eigen::Quaterniond& rotation) { this->turn(rotation, this->focal); }
  void turn(const Eigen::Quaterniond& rotation, const Eigen::Vector3d& about);
  void move(const Eigen::Vector3d& by);
  // For a view of another size [px, those below 1 are 1]: what was seen across its smaller side, about its
  // middle, is again. A camera by itself keeps what is seen from top to bottom, so that a view narrower than
  // high cuts what was whole.
  void fit(const int before[2], const int now[2]);
};

// A copy of the renderer's camera whose clipping range comes from its distance to the focal point, not from
// the scene: that of a scene behind the camera makes no projection.
OVERSKETCHWIDGETSCAMERA_EXPORT vtkSmartPointer<vtkCamera> unclippedCamera(vtkRenderer* renderer);

// Height of the picture at the focal point, in world units.
double viewHeight(vtkCamera* camera);

// The view that a camera had first, and how far it has been zoomed and spun since.
struct FirstView
{
  vtkWeakPointer<vtkCamera> camera;
  CameraState state;
  double spin; // degrees in [0, 360)

  double zoom() const;
  // Clamped to [0.1, 10]; what is seen there stays there [-1 to 1 across the view].
  void setZoom(double zoom, const Eigen::Vector2d& at = Eigen::Vector2d::Zero()) const;
  // Perspective or not, of the same size where the camera looks at.
  void setParallel(bool parallel);
  void roll(double degrees);
};

// The lines of sight of the moment it was made, whatever the camera does later.
class SightLines
{
public:
  explicit SightLines(vtkRenderer* renderer);
  // Through a display position [px], away from the viewer.
  Line at(double x, double y) const;

private:
  vtkWeakPointer<vtkRenderer> Renderer;
  Eigen::Matrix4d WorldFromView;
};

} // namespace oversketch
#endif
