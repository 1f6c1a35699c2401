// What filters say in the words of a command line. They call a setting by its property, as their class does;
// the list of systems knows which option has it.
#ifndef oversketch_applications_command_option_words_h
#define oversketch_applications_command_option_words_h

#include "systems.h"

#include <string>

namespace oversketch_command
{

// "turn AllowTorn on" becomes "give --allow-torn", "Lower Candidate" becomes "Lower --candidate", "Rule Off"
// becomes "--rule off". Names of arrays, of files and what is quoted stay.
std::string inOptions(const std::string& message, const oversketch_session::SystemRow& system);

// The same for a file that gives them as members: "set 'allow-torn' to true", "Lower 'candidate'".
std::string inMembers(const std::string& message, const oversketch_session::SystemRow& system);

} // namespace oversketch_command
#endif
