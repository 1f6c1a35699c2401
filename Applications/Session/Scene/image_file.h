// Pictures and grids of heights as inputs of steps.
#ifndef oversketch_applications_session_scene_image_file_h
#define oversketch_applications_session_scene_image_file_h

#include "systems.h"

#include <string>

namespace oversketch_session
{

// A picture, upright, or a grid of heights. Throws oversketch_files::Failed where the file is none.
Image readImage(const std::string& path, SystemInput::Kind kind);

} // namespace oversketch_session
#endif
