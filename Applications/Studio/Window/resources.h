// Where the files that come with the program are. A translation is one of them,
// Translations/oversketch_LANGUAGE.qm.
#ifndef oversketch_applications_studio_window_resources_h
#define oversketch_applications_studio_window_resources_h

#include <QLocale>
#include <QString>

namespace oversketch_studio
{

// A file by its path among them; empty where it is not installed.
QString shippedFile(const QString& path);
// The model that the window opens on; empty where it is not installed.
QString shippedModel();

// Takes up the translation into that language that is in the folder, for the rest of the program, with Qt's
// own texts. False where there is none: the window is English.
bool installTranslation(const QLocale& locale, const QString& folder);

} // namespace oversketch_studio
#endif
