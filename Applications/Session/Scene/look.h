// How a model was looked at, kept with its session. No result depends on it.
#ifndef oversketch_applications_session_scene_look_h
#define oversketch_applications_session_scene_look_h

#include "session.h"

#include <array>
#include <optional>

class vtkCamera;

namespace oversketch_session
{

// A camera, in the world.
struct Look
{
  Point position{}, focus{}, up{};
  double angle = 30.0;           // that is seen from top to bottom [degrees]
  double height = 1.0;           // half of what is seen where lines of sight are parallel
  bool parallel = false;         // lines of sight are
  std::array<double, 2> shift{}; // of the picture's middle [halves of its width and height]
  // Size of the view that this was in, width and height [px]; none in files of programs before this was kept.
  std::optional<std::array<int, 2>> size;
  int upAxis = 1; // of the world, that the model is turned about: 1 for y, 2 for z

  bool operator==(const Look& other) const
  {
    return this->position == other.position && this->focus == other.focus && this->up == other.up &&
           this->angle == other.angle && this->height == other.height && this->parallel == other.parallel &&
           this->shift == other.shift && this->size == other.size && this->upAxis == other.upAxis;
  }
};

// Look of a camera, without the size of its view; and a camera that looks so.
Look lookOf(vtkCamera* camera);
void lookAs(const Look& look, vtkCamera* camera);

} // namespace oversketch_session
#endif
