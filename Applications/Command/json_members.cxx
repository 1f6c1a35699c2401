#include "json_members.h"

#include "files.h"

#include <algorithm>
#include <filesystem>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

void requireKnown(const JsonReader& json, const std::vector<std::string>& members)
{
  for (const std::string& name : json.names())
  {
    if (std::find(members.begin(), members.end(), name) == members.end())
    {
      std::string known;
      for (const std::string& member : members)
      {
        known += (known.empty() ? "" : ", ") + member;
      }
      json.refuse(name, "is no member of it; these are: " + known);
    }
  }
}

std::string fileBeside(const JsonReader& json,
  const std::string& name,
  const std::string& folder,
  const std::string& whose)
{
  const std::string given = json.text(name);
  if (given.empty() || given.find('\0') != std::string::npos)
  {
    json.refuse(name, "is no path of a file; name one, beginning at the folder of " + whose);
  }
  std::string path = (std::filesystem::path(folder) / given).lexically_normal().string();
  try
  {
    requireReadable(path);
  }
  catch (const Failed& failed)
  {
    const std::string why = failed.what();
    json.refuse(name,
      "names '" + given + "': " + why.substr(path.size() + 2) +
        "; mend the path, which begins at the folder of " + whose);
  }
  return path;
}

} // namespace oversketch_command
