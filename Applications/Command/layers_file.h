// The file that says the layers of an edit.
#ifndef oversketch_applications_command_layers_file_h
#define oversketch_applications_command_layers_file_h

#include "step.h"

#include <string>

namespace oversketch_command
{

// A JSON object with the members, each of which may be absent: levels, a number; handles, a list of [from,
// to]; areas, a list of objects with stroke, the path of a .vtp file of one stroke over the disc, and levels
// and handles of its own. Sets the parameters Levels, where it says some, and Layers, and the input Areas.
// Throws Failed, naming file and member.
void readLayers(const std::string& path, oversketch_session::Step& step);

} // namespace oversketch_command
#endif
