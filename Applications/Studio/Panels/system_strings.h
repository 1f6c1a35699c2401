// What the list of systems says, in the user's language.
#ifndef oversketch_applications_studio_panels_system_strings_h
#define oversketch_applications_studio_panels_system_strings_h

#include <QString>
#include <QStringList>

#include <string>
#include <vector>

namespace oversketch_studio
{

// A text of a row (Applications/Session/Scene/systems.cxx); translators find it under "Systems".
QString rowText(const std::string& text);
// The same as a sentence: it begins with a capital letter.
QString rowSentence(const std::string& text);
// What a step of a system is called.
QString titleOf(const std::string& system);
// Texts of files that were read or written.
QStringList listOf(const std::vector<std::string>& texts);

} // namespace oversketch_studio
#endif
