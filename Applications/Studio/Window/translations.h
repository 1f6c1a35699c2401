// The window in the user's language: a translation is one file, oversketch_LANGUAGE.qm among the program's
// files (Translations/).
#ifndef oversketch_applications_studio_window_translations_h
#define oversketch_applications_studio_window_translations_h

#include <QLocale>
#include <QString>

namespace oversketch_studio
{

// Takes up the translation into that language that is in the folder, for the rest of the program, with Qt's
// own texts. False where there is none: the window is English.
bool installTranslation(const QLocale& locale, const QString& folder);

} // namespace oversketch_studio
#endif
