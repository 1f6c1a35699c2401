// The work of a person: models, each the mesh that was opened, if any, and the steps that were taken on it,
// in order, and pictures. Values: a change is a new Session that shares all that did not change.
#ifndef oversketch_applications_session_scene_session_h
#define oversketch_applications_session_scene_session_h

#include "shared_data.h"
#include "step.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace oversketch_session
{

using Point = std::array<double, 3>;

// The place on the model that a step took hold of, in the world.
struct Section
{
  Point middle{};
  double length = 0.0;

  bool operator==(const Section& other) const
  {
    return this->middle == other.middle && this->length == other.length;
  }
};

// A step in the history.
struct Node
{
  int id = 0; // from 1, unique in its session; stays when the step is changed
  std::shared_ptr<const Step> step;
  std::string name; // for the reader of the history
  bool on = true;   // off: the mesh passes by
  // Where it took hold when it was committed; absent until it has run once.
  std::optional<Section> committed;

  bool operator==(const Node& other) const
  {
    return this->id == other.id && this->step == other.step && this->name == other.name &&
           this->on == other.on && this->committed == other.committed;
  }
};

// A picture in the scene, behind the model: seen in the view that it was put there in.
struct Picture
{
  Image image;
  Lines frame; // a stroke with its view, from the picture's lower left corner to its upper right one
  double opacity = 1.0;
  bool shown = true, locked = false;
};
using Pictures = std::vector<std::shared_ptr<const Picture>>;

// A part of a model, told by what made it: the steps before it may change, and it is still the same.
struct PartSource
{
  int step = 0; // the id of the step that put it there; 0: it came with the mesh that was opened
  int part = 0; // among those of that mesh, by its number (PartId), or of that step, from 0

  bool operator<(const PartSource& other) const
  {
    return std::tie(this->step, this->part) < std::tie(other.step, other.part);
  }
};

// A model: the mesh that it began with and the steps on it, and how it is seen, which no step depends on.
struct Model
{
  std::string meshName; // of the file that was opened, without its folder
  SharedData mesh;      // null where the first step makes one
  SharedData whole;     // what was opened, where `mesh` is a proxy of it; null where that is the mesh itself
  std::vector<Node> nodes;
  int backend = 0; // vtkOversketchSystem::BackendType
  int id = 1;      // from 1, unique in the scene; not in the file
  bool shown = true, locked = false;
  std::set<PartSource> hidden; // parts of it; those that do not exist yet are hidden when they appear
};

// A model of the scene while another one is worked on, see models.h.
struct RestingModel;

// The model that is worked on, and the scene round it, which no step sees.
struct Session : Model
{
  Pictures pictures;
  std::size_t place = 0; // of the model in the list of all
  // The others, in the order of that list.
  std::vector<std::shared_ptr<const RestingModel>> others;
};

// The place of a node in a history, by its id; -1: it is not there.
inline int rowOf(const std::vector<Node>& nodes, int id)
{
  const auto node = std::find_if(nodes.begin(), nodes.end(), [id](const Node& one) { return one.id == id; });
  return node == nodes.end() ? -1 : static_cast<int>(node - nodes.begin());
}

// The next id: greater than all that the model names, so that nothing refers to a new step by chance.
inline int freshId(const Model& model)
{
  int last = 0;
  for (const Node& node : model.nodes)
  {
    last = std::max(last, node.id);
    for (const auto& named : node.step->inputs)
    {
      const auto* output = std::get_if<StepOutput>(&named.second);
      last = std::max(last, output ? output->step : 0);
    }
  }
  for (const PartSource& part : model.hidden)
  {
    last = std::max(last, part.step);
  }
  return last + 1;
}

} // namespace oversketch_session
#endif
