#include "json_reader.h"

#include "files.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace oversketch_session
{

using oversketch_files::Failed;

JsonReader::JsonReader(const Json::Value& object, std::string where, std::string verdict)
  : Object(object)
  , Where(std::move(where))
  , Verdict(std::move(verdict))
{
  if (!object.isObject())
  {
    throw Failed(this->Where + " is no object; " + this->Verdict);
  }
}

Json::Value JsonReader::parse(const std::string& text, const std::string& where)
{
  Json::CharReaderBuilder builder;
  Json::CharReaderBuilder::strictMode(&builder.settings_);
  Json::Value root;
  std::string errors;
  std::istringstream stream(text);
  bool parsed = false;
  try
  {
    parsed = Json::parseFromStream(builder, stream, &root, &errors);
  }
  catch (const Json::Exception&)
  {
    throw Failed(where + " is damaged: it is nested too deep");
  }
  if (!parsed)
  {
    // "* Line 1, Column 5\n  what was expected there"
    const std::size_t from = errors.find("Line "), to = errors.find('\n');
    throw Failed(where + " is damaged: it is no JSON" +
                 (from < to ? ": " + errors.substr(from, to - from) : std::string()));
  }
  return root;
}

bool JsonReader::has(const std::string& name) const
{
  return this->Object.isMember(name) && !this->Object[name].isNull();
}

const Json::Value& JsonReader::get(const std::string& name) const
{
  if (!this->has(name))
  {
    throw Failed(this->Where + " lacks '" + name + "'; " + this->Verdict);
  }
  return this->Object[name];
}

void JsonReader::require(bool good, const std::string& name, const char* what) const
{
  if (!good)
  {
    this->refuse(name, "is not " + std::string(what) + "; " + this->Verdict);
  }
}

void JsonReader::refuse(const std::string& name, const std::string& what) const
{
  throw Failed(this->Where + ": '" + name + "' " + what);
}

std::string JsonReader::text(const std::string& name) const
{
  const Json::Value& value = this->get(name);
  this->require(value.isString(), name, "a string");
  return value.asString();
}

bool JsonReader::yes(const std::string& name) const
{
  const Json::Value& value = this->get(name);
  this->require(value.isBool(), name, "true or false");
  return value.asBool();
}

double JsonReader::number(const std::string& name) const
{
  const Json::Value& value = this->get(name);
  this->require(value.isNumeric() && std::isfinite(value.asDouble()), name, "a number");
  return value.asDouble();
}

int JsonReader::integer(const std::string& name, int least, int most) const
{
  const Json::Value& value = this->get(name);
  this->require(
    value.isInt() && value.asInt() >= least && value.asInt() <= most, name, "a number in its range");
  return value.asInt();
}

std::vector<double> JsonReader::numbers(const std::string& name) const
{
  const Json::Value& value = this->get(name);
  this->require(value.isArray(), name, "a list of numbers");
  std::vector<double> numbers;
  for (const Json::Value& one : value)
  {
    this->require(one.isNumeric() && std::isfinite(one.asDouble()), name, "a list of numbers");
    numbers.push_back(one.asDouble());
  }
  return numbers;
}

int JsonReader::choice(const std::string& name, const std::vector<std::string>& words) const
{
  const std::string chosen = this->text(name);
  const auto it = std::find(words.begin(), words.end(), chosen);
  if (it == words.end())
  {
    this->refuse(name, "is '" + chosen + "', which this version does not know");
  }
  return static_cast<int>(it - words.begin());
}

Point JsonReader::point(const std::string& name) const
{
  const std::vector<double> numbers = this->numbers(name);
  this->require(numbers.size() == 3, name, "three numbers");
  return { numbers[0], numbers[1], numbers[2] };
}

std::vector<JsonReader> JsonReader::list(const std::string& name, const std::string& ofWhat) const
{
  const Json::Value& value = this->get(name);
  this->require(value.isArray(), name, "a list");
  std::vector<JsonReader> objects;
  for (Json::ArrayIndex i = 0; i < value.size(); ++i)
  {
    objects.emplace_back(value[i], this->Where + ", " + ofWhat + " " + std::to_string(i + 1), this->Verdict);
  }
  return objects;
}

JsonReader JsonReader::object(const std::string& name) const
{
  return { this->get(name), this->Where + ", " + name, this->Verdict };
}

} // namespace oversketch_session
