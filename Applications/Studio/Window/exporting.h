// Where an export goes: a name and a format, which are remembered.
#ifndef oversketch_applications_studio_window_exporting_h
#define oversketch_applications_studio_window_exporting_h

#include <QString>

class QWidget;

namespace oversketch_studio
{

// Asks for it, offering every format that is written; `name` without its suffix to begin with. Empty where
// nobody wants it. The path has the suffix of a format. A model that wears a picture is offered one that
// keeps it.
QString exportPathAsked(QWidget* parent, const QString& name, bool wearsPicture);
// Whether a file of that format keeps a model's picture.
bool keepsPicture(const QString& path);

} // namespace oversketch_studio
#endif
