// Members that the command asks of JSON files that it is given.
#ifndef oversketch_applications_command_json_members_h
#define oversketch_applications_command_json_members_h

#include "json_reader.h"

#include <string>
#include <vector>

namespace oversketch_command
{

// Throws Failed, naming one that is none of the members.
void requireKnown(const oversketch_session::JsonReader& json, const std::vector<std::string>& members);

// A readable file that a member names; relative to the folder of the JSON file, which messages call `whose`
// ("the parts' file"). Throws Failed, naming the member.
std::string fileBeside(const oversketch_session::JsonReader& json,
  const std::string& name,
  const std::string& folder,
  const std::string& whose);

} // namespace oversketch_command
#endif
