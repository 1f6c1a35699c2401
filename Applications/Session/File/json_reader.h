// Reads members of a JSON object, and says which is wrong.
#ifndef oversketch_applications_session_file_json_reader_h
#define oversketch_applications_session_file_json_reader_h

#include "session.h"

#include "vtk_jsoncpp.h"

#include <string>
#include <vector>

namespace oversketch_session
{

class JsonReader
{
public:
  // `where` is the name of the object for messages, `verdict` what a member that is not right tells of the
  // file; the object must outlive this. Throws oversketch_files::Failed, as all below.
  JsonReader(const Json::Value& object, std::string where, std::string verdict = "the session is damaged");

  // The text of an entry as JSON.
  static Json::Value parse(const std::string& text, const std::string& where);

  bool has(const std::string& name) const;
  const Json::Value& get(const std::string& name) const;
  std::string text(const std::string& name) const;
  bool yes(const std::string& name) const;
  double number(const std::string& name) const;
  int integer(const std::string& name, int least, int most) const;
  std::vector<double> numbers(const std::string& name) const;
  // The place of a word in a list.
  int choice(const std::string& name, const std::vector<std::string>& words) const;
  Point point(const std::string& name) const;
  // A list of objects, and an object among the members.
  std::vector<JsonReader> list(const std::string& name, const std::string& ofWhat) const;
  JsonReader object(const std::string& name) const;
  std::vector<std::string> names() const { return this->Object.getMemberNames(); }

  // Throws what is wrong with a member.
  [[noreturn]] void refuse(const std::string& name, const std::string& what) const;
  const std::string& where() const { return this->Where; }

private:
  void require(bool good, const std::string& name, const char* what) const;

  const Json::Value& Object;
  std::string Where, Verdict;
};

// Numbers as JSON.
template <typename Numbers>
Json::Value jsonList(const Numbers& numbers)
{
  Json::Value list(Json::arrayValue);
  for (const auto number : numbers)
  {
    list.append(number);
  }
  return list;
}

} // namespace oversketch_session
#endif
