// Steps and pictures of a session as JSON, in both versions of the format: see README.md beside this.
#ifndef oversketch_node_json_h
#define oversketch_node_json_h

#include "json_reader.h"
#include "package.h"
#include "systems.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace oversketch_session
{

// The word of a choice; numbers, texts and lists as they are.
Json::Value jsonOf(const Parameter& parameter, const Value& value);

// Whether version 1 of the format can tell all of the session.
bool isVersion1(const Session& session);

// How an input's content becomes an entry; gives the entry's name.
struct EntryWriter
{
  std::function<std::string(const Lines& lines)> lines;
  std::function<std::string(const Image& image)> image;
};
Json::Value jsonOf1(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries);
Json::Value jsonOf2(const Node& node, const std::vector<SystemRow>& rows, const EntryWriter& entries);

Json::Value jsonOf(const Picture& picture, const EntryWriter& entries);

// Throw Failed, naming the path, the entry and the member. Version 1 has no ids.
Node nodeOf1(const JsonReader& json,
  const std::vector<SystemRow>& rows,
  const Package& package,
  const std::string& path);
Node nodeOf2(const JsonReader& json,
  const std::vector<SystemRow>& rows,
  const Package& package,
  const std::string& path);

Picture pictureOf(const JsonReader& json, const Package& package, const std::string& path);

// The bytes of an entry. Throws Failed where there is none.
const std::shared_ptr<const std::string>& entryOf(const Package& package,
  const std::string& name,
  const std::string& path);

} // namespace oversketch_session
#endif
