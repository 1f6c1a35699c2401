// Colours of the window.
#ifndef oversketch_applications_studio_looks_h
#define oversketch_applications_studio_looks_h

#include <QPalette>

namespace oversketch_studio
{

QPalette darkPalette();

} // namespace oversketch_studio
#endif
