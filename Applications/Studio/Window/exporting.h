// Where an export or a film goes: a name and a format, which are remembered.
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
// Asks for the path of a model that is to be printed, in a format of printers.
QString printPathAsked(QWidget* parent, const QString& name);
// Whether a file of that format keeps a model's picture.
bool keepsPicture(const QString& path);

// Asks of how many frames a film of one turn is, and where it goes: as one file or as numbered pictures. The
// path is empty where nobody wants it, and else has the suffix of a format; `name` without its suffix to
// begin with.
struct TurnFilm
{
  QString path;
  int frames = 0;
};
TurnFilm turnFilmAsked(QWidget* parent, const QString& name);

} // namespace oversketch_studio
#endif
