// Messages of filters and files, in the window's own words and the user's language.
#ifndef oversketch_applications_studio_window_message_text_h
#define oversketch_applications_studio_window_message_text_h

#include "Mesh/message.h"

#include <QString>

#include <functional>
#include <string>

namespace oversketch_studio
{

// The name that a tool has for what stands in a message's braces, such as "stroke 3"; empty where it leaves
// that to the form's titles.
using Naming = std::function<QString(const std::string& named)>;

// Shorter where the window has shorter words for it, settings by their titles in forms, numbers with three
// digits at most. A translation has such texts under "Messages", as Message::id or in the window's words,
// with %1, %2, … where arguments stand.
QString plainWords(const oversketch::Message& message, const Naming& naming = {});
// Shorter, to be read on the run: it says what is not as drawn, not by how much.
QString briefWords(const oversketch::Message& message);
// The property that is to be turned on, as a message says; empty where it asks for none.
std::string askedFor(const oversketch::Message& message);

} // namespace oversketch_studio
#endif
