// The view's camera as a session keeps it.
#ifndef oversketch_applications_studio_view_camera_look_h
#define oversketch_applications_studio_view_camera_look_h

#include "look.h"

namespace oversketch_studio
{

class Viewport;

oversketch_session::Look lookOf(Viewport& view);
void lookAs(const oversketch_session::Look& look, Viewport& view);

} // namespace oversketch_studio
#endif
