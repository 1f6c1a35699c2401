// Rows of the list of systems for those that none of the papers has; of each that is built.
#ifndef oversketch_applications_session_scene_own_systems_h
#define oversketch_applications_session_scene_own_systems_h

#include "systems.h"

namespace oversketch_session
{

SystemRow joining();
SystemRow mask();
SystemRow pose();
SystemRow relax();
SystemRow transform();

} // namespace oversketch_session
#endif
