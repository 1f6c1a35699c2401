// What filters and files say, in the window's own words and the user's language.
#ifndef oversketch_applications_studio_message_words_h
#define oversketch_applications_studio_message_words_h

#include <QString>

#include <string>

namespace oversketch_studio
{

// Shorter where the window has shorter words for it, numbers with three digits at most after the point. A
// translation has such texts under "Messages", with %1, %2, … where numbers stand.
QString plainWords(const std::string& message);
// The same in a line to be read on the run: of what is not as drawn what, without by how much.
QString briefWords(const std::string& message);
// The property that is to be turned on, as a message says; empty where it asks for none.
QString askedFor(const std::string& message);

} // namespace oversketch_studio
#endif
