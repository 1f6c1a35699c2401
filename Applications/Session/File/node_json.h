// Steps and pictures of a session, and how it was looked at, as JSON: see README.md beside this.
#ifndef oversketch_applications_session_file_node_json_h
#define oversketch_applications_session_file_node_json_h

#include "json_reader.h"
#include "look.h"
#include "package.h"
#include "systems.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace oversketch_session
{

// The word of a choice; numbers, texts and lists as they are.
Json::Value jsonOf(const Parameter& parameter, const Value& value);

// A member that is a value of the parameter. Throws Failed, naming it.
Value valueOf(const JsonReader& values, const std::string& name, const Parameter& parameter);

// Whether version 1 of the format can tell all of the session.
bool isVersion1(const Session& session, const std::vector<SystemRow>& rows);

// How an input's content becomes an entry; gives the entry's name.
struct EntryWriter
{
  std::function<std::string(const Lines& lines)> lines;
  std::function<std::string(const Image& image)> image;
};
Json::Value jsonOf1(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries);
Json::Value jsonOf2(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries);

Json::Value jsonOf(const Picture& picture, const EntryWriter& entries);

// The entries of a package, each parsed once however often it is named. Throws Failed, naming the path and
// the entry.
class EntryReader
{
public:
  // The package must outlive this.
  EntryReader(const Package& package, std::string path)
    : Entries(package)
    , Path(std::move(path))
  {
  }

  const std::shared_ptr<const std::string>& bytes(const std::string& entry) const;
  Lines lines(const std::string& entry);
  // The bytes of a picture that can be read.
  const std::shared_ptr<const std::string>& picture(const std::string& entry);
  // The bytes of a grid of heights that can be read.
  const std::shared_ptr<const std::string>& heights(const std::string& entry);

private:
  const Package& Entries;
  std::string Path;
  std::map<std::string, Lines> Parsed;
  std::set<std::string> Pictures, Heights; // that were looked at
};

// Throw Failed, naming the path, the entry and the member. Version 1 has no ids.
Node nodeOf1(const JsonReader& json, const std::vector<SystemRow>& rows, EntryReader& entries);
Node nodeOf2(const JsonReader& json, const std::vector<SystemRow>& rows, EntryReader& entries);

Picture pictureOf(const JsonReader& json, EntryReader& entries);

Json::Value jsonOf(const PartSource& part);
PartSource partSourceOf(const JsonReader& json);

Json::Value jsonOf(const Look& look);
// Throws oversketch_files::Failed where nothing could be seen so.
Look lookOf(const JsonReader& json);

} // namespace oversketch_session
#endif
