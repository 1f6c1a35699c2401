// Colours of the window.
#ifndef oversketch_applications_studio_view_looks_h
#define oversketch_applications_studio_view_looks_h

#include <QPalette>

class QStyle;

namespace oversketch_studio
{

QPalette darkPalette();
// Qt's own, but that what is disabled is written once, not with a shadow: on dark ground that looks bold.
QStyle* plainStyle();

} // namespace oversketch_studio
#endif
