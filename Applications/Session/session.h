// What a person made of a mesh: the mesh they opened and the strokes they drew on it, in order. Values: a
// change is a new Session that shares all that did not change, so undo keeps sessions and costs next to
// nothing.
#ifndef oversketch_session_h
#define oversketch_session_h

#include "shared_data.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace oversketch_session
{

using Point = std::array<double, 3>;

// Those parameters of vtkOversketchOneStroke that belong to one stroke; its names and defaults.
struct Parameters
{
  int remesh = 0; // vtkOversketchOneStroke::RemeshType
  bool adjustNormals = false;
  bool asPublished = false;

  bool operator==(const Parameters& other) const
  {
    return this->remesh == other.remesh && this->adjustNormals == other.adjustNormals &&
           this->asPublished == other.asPublished;
  }
};

// The plane where one coordinate has one value; a stroke acts on both sides of it (Filters/Deform,
// vtkOversketchMirror).
struct MirrorPlane
{
  int axis = 0; // 0, 1, 2: x, y, z
  double offset = 0.0;
};

// A stroke and how it acts. Never changed once made: results are kept by its identity.
struct Action
{
  SharedData stroke; // with its view
  Parameters parameters;
  std::optional<MirrorPlane> mirror;
};

// The place on the model that a stroke took hold of, in the world.
struct Section
{
  Point middle{};
  double length = 0.0;
};

// An action in the history.
struct Node
{
  std::shared_ptr<const Action> action;
  std::string name; // for the reader of the history
  bool on = true;   // off: the mesh passes by
  // Where the stroke took hold when it was committed; absent until it has run once.
  std::optional<Section> committed;
};

struct Session
{
  std::string meshName; // of the file that was opened, without its folder
  SharedData mesh;
  std::vector<Node> nodes;
  int backend = 0; // vtkOversketchOneStroke::BackendType
};

} // namespace oversketch_session
#endif
