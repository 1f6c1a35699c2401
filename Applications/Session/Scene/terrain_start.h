// The first step of a session that begins with a grid of heights.
#ifndef oversketch_applications_session_scene_terrain_start_h
#define oversketch_applications_session_scene_terrain_start_h

#include "step.h"

#include <memory>
#include <string>

namespace oversketch_session
{

// A step of Terrain of that file. Files do not say how heights compare with widths: where the relief would be
// higher than the terrain is long, or less than a thousandth of it, the step's Scale makes it a fifth; else a
// unit of gray is one of length. Throws Failed, naming the file.
std::shared_ptr<const Step> terrainOf(const std::string& path);

} // namespace oversketch_session
#endif
