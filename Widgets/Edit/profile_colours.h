// A profile's gradient, which tells left from right in the model's window and in its own.
#ifndef oversketch_widgets_edit_profile_colours_h
#define oversketch_widgets_edit_profile_colours_h

#include "edit_overlay.h"

#include <vector>

namespace oversketch
{

// From orange at its first place to blue at its last, with a light rim.
void paintProfile(Overlay& overlay, const std::vector<Polyline>& pieces, double width);

} // namespace oversketch
#endif
