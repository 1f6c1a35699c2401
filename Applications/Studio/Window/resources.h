// The files that come with the program: models, drawings and sessions to begin with, and translations,
// Translations/oversketch_LANGUAGE.qm.
#ifndef oversketch_applications_studio_window_resources_h
#define oversketch_applications_studio_window_resources_h

#include "document.h"

#include <QLocale>
#include <QString>
#include <QVector>

namespace oversketch_studio
{

// A file by its path among them; empty where it is not installed.
QString shippedFile(const QString& path);
// The model that the window opens on; empty where it is not installed.
QString shippedModel();

// A model, a drawing or a session.
struct Example
{
  QString title;
  QString file;
  QString picture; // that a drawing lies over; else empty
};

// Those that are installed, models first.
QVector<Example> examples();

// On any thread. A session is read as one that is not saved yet. Throws Failed.
Document::Opened readExample(const Example& example, int backend);

// Takes up the translation into that language that is in the folder, for the rest of the program, with Qt's
// own texts. False where there is none: the window is English.
bool installTranslation(const QLocale& locale, const QString& folder);

} // namespace oversketch_studio
#endif
