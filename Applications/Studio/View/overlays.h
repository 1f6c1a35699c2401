// What lies over the view: the strip at its upper left corner, the axes.
#ifndef oversketch_applications_studio_view_overlays_h
#define oversketch_applications_studio_view_overlays_h

#include "hint.h"

#include <vector>

class QWidget;

namespace oversketch_studio
{

// Those that are seen, in the screen's pixels.
std::vector<Hint::Box> overlaysOf(const QWidget& view);

} // namespace oversketch_studio
#endif
