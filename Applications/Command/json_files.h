// JSON files that the command takes: parts of a model, and where each one goes, of `oversketch assemble`;
// the layers of an edit.
#ifndef oversketch_applications_command_json_files_h
#define oversketch_applications_command_json_files_h

#include "step.h"

#include "vtkPolyData.h"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace oversketch_command
{

// The things that a part is made of: a drawing, its picture and that of its back, if any, and the values of
// its parameters; or a mesh. Files by their paths.
struct PartSource
{
  std::string drawing, picture, back, mesh;
  oversketch_session::Values values;

  bool operator<(const PartSource& other) const
  {
    return std::tie(this->drawing, this->picture, this->back, this->mesh, this->values) <
           std::tie(other.drawing, other.picture, other.back, other.mesh, other.values);
  }
};

// Left, bottom, right and top [world units].
using Box = Eigen::Vector4d;

struct Part
{
  std::string where; // "figure.json, part 2", for messages
  PartSource source;
  std::optional<Eigen::Matrix4d> placement; // in place of box and depth
  std::optional<Box> box;
  double depth = 0.0;
};

// Throws oversketch_files::Failed, which names the part, from 0, the member and the remedy: the text is no
// JSON or has other members than it may, a value is of another type, a placement is none of an affine
// transform that keeps space apart, a part is there twice at one place, there is none or over 1000.
std::vector<Part> readParts(const std::string& path);

// Where a part goes, by its box and depth where it has no matrix: its canvas (field array Canvas), else what
// it covers in x and y, comes to fill the box, by a mean of both scales in z, then it is moved along z.
// Throws Failed where it cannot be.
Eigen::Matrix4d placementOf(const Part& part, vtkPolyData* mesh);

// A JSON object with the members, each of which may be absent: levels, a number; handles, a list of [from,
// to]; areas, a list of objects with stroke, the path of a .vtp file of one stroke over the disc, and levels
// and handles of its own. Sets the parameters Levels, where it says some, and Layers, and the input Areas.
// Throws Failed, naming file and member.
void readLayers(const std::string& path, oversketch_session::Step& step);

} // namespace oversketch_command
#endif
