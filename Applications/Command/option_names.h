// Messages in the words of a command line. Filters call a setting by its property, as their class does; the
// list of systems knows which option has it.
#ifndef oversketch_applications_command_option_names_h
#define oversketch_applications_command_option_names_h

#include "systems.h"

#include "Mesh/message.h"

#include <string>

namespace oversketch_command
{

// "{AllowTorn on}" is "give --allow-torn", "{Candidate}" is "--candidate", "{Rule Off}" is "--rule off".
std::string inOptions(const oversketch::Message& message, const oversketch_session::SystemRow& system);

// For a file that gives them as members: "set 'allow-torn' to true", "'candidate'".
std::string inMembers(const oversketch::Message& message, const oversketch_session::SystemRow& system);

} // namespace oversketch_command
#endif
