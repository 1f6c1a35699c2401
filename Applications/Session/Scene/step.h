// One step of a session: a system, its parameters and what it is given. Values.
#ifndef oversketch_applications_session_scene_step_h
#define oversketch_applications_session_scene_step_h

#include "lines.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace oversketch_session
{

// A value of a parameter of a system.
using Value = std::variant<bool, int, double, std::vector<double>, std::string>;
// By the class's own names of them ("AdjustNormals").
using Values = std::map<std::string, Value>;

// One of them; `otherwise` where it is not there.
template <typename T>
T valueOr(const Values& values, const char* name, T otherwise)
{
  const auto it = values.find(name);
  return it == values.end() ? otherwise : std::get<T>(it->second);
}

// A picture or a grid of heights, kept as the bytes of its file.
struct Image
{
  std::string name; // of the file, without its folder
  std::shared_ptr<const std::string> bytes;
};

// An output of an earlier step of the session, whatever that is by now. The id stays with the step while it
// is moved, renamed or given other parameters.
struct StepOutput
{
  int step = 0;
  int port = 0;
};

using Input = std::variant<Lines, Image, StepOutput>;

// The plane where one coordinate has one value; a step acts on both sides of it (SystemRunner::run).
struct MirrorPlane
{
  int axis = 0; // 0, 1, 2: x, y, z
  double offset = 0.0;
};

// Where a part goes: the canvas that it was drawn on comes to fill a box in x and y, by a mean of both scales
// in z, and is moved along z.
struct PartPlace
{
  std::array<double, 4> box{}; // left, bottom, right, top [world]
  double depth = 0.0;

  bool operator==(const PartPlace& other) const
  {
    return this->box == other.box && this->depth == other.depth;
  }
};

// Never changed once made: results are kept by its identity.
struct Step
{
  std::string system;                  // "OneStroke"; see systems.h
  Values values;                       // where they are not the system's defaults
  std::map<std::string, Input> inputs; // by their names in systems.h; the mesh comes from the step before
  std::optional<MirrorPlane> mirror;   // only of systems whose points can keep their ids
  // The place where what it makes is put, beside the mesh of the step before and not in its place; only of
  // systems that take no mesh.
  std::optional<PartPlace> part;
};

// The lines of an input, for a pipeline; null where it holds none.
inline vtkSmartPointer<vtkPolyData> linesOf(const Step& step, const std::string& input)
{
  const auto it = step.inputs.find(input);
  const Lines* lines = it == step.inputs.end() ? nullptr : std::get_if<Lines>(&it->second);
  return lines ? lines->own() : nullptr;
}

} // namespace oversketch_session
#endif
