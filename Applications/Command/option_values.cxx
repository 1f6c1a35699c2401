#include "option_values.h"

#include "mesh_file.h"

#include "vtkOversketchSystem.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

std::string listOf(const std::vector<std::string>& words, const std::string& between)
{
  std::string list;
  for (const std::string& word : words)
  {
    list += (list.empty() ? "" : between) + word;
  }
  return list;
}

int choiceOf(const std::string& option, const std::string& value, const std::vector<std::string>& choices)
{
  const auto it = std::find(choices.begin(), choices.end(), value);
  if (it == choices.end())
  {
    throw BadUse(option + " is one of " + listOf(choices, ", ") + ", not '" + value + "'");
  }
  return static_cast<int>(it - choices.begin());
}

std::vector<double> numbersOf(const std::string& option, const std::string& text)
{
  std::vector<double> numbers;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    char* end = nullptr;
    numbers.push_back(std::strtod(part.c_str(), &end));
    if (part.empty() || *end != '\0' || !std::isfinite(numbers.back()))
    {
      throw BadUse(option + " takes numbers, not '" + text + "'");
    }
  }
  return numbers;
}

bool isSwitch(const Parameter& parameter)
{
  const bool* usual = std::get_if<bool>(&parameter.initial);
  return usual && !*usual;
}

namespace
{

// A value of the kind that the parameter's default is.
Value valueOf(const Parameter& parameter, const std::string& option, const std::string& text)
{
  if (isSwitch(parameter))
  {
    return true;
  }
  if (std::holds_alternative<bool>(parameter.initial))
  {
    return choiceOf(option, text, { "off", "on" }) == 1;
  }
  if (!parameter.choices.empty())
  {
    return choiceOf(option, text, wordsOf(parameter));
  }
  if (std::holds_alternative<std::string>(parameter.initial))
  {
    return text;
  }
  const std::vector<double> numbers = numbersOf(option, text);
  if (const auto* usual = std::get_if<std::vector<double>>(&parameter.initial))
  {
    if (parameter.oneForAll && numbers.size() == 1)
    {
      return std::vector<double>(usual->size(), numbers[0]);
    }
    if (numbers.size() != usual->size())
    {
      throw BadUse(
        option + " takes " + std::to_string(usual->size()) + " numbers, such as 0,1.5,0, not '" + text + "'");
    }
    return numbers;
  }
  if (numbers.size() != 1)
  {
    throw BadUse(option + " takes one number, not '" + text + "'");
  }
  if (std::holds_alternative<double>(parameter.initial))
  {
    return numbers[0];
  }
  if (numbers[0] != std::floor(numbers[0]) || std::abs(numbers[0]) > 1e9)
  {
    throw BadUse(option + " takes a whole number, not '" + text + "'");
  }
  return static_cast<int>(numbers[0]);
}

std::string textOf(const Value& number)
{
  std::ostringstream text;
  std::holds_alternative<int>(number) ? text << std::get<int>(number) : text << std::get<double>(number);
  return text.str();
}

// A setter takes the nearest value that it can; a command line that asks for another one is wrong.
void expectTaken(const SystemRow& row,
  const Parameter& parameter,
  const std::string& option,
  const Value& value)
{
  if (!std::holds_alternative<int>(value) && !std::holds_alternative<double>(value))
  {
    return;
  }
  const auto system = row.make();
  parameter.set(system, value);
  const Value taken = parameter.get(system);
  if (taken != value)
  {
    throw BadUse(option + " cannot be " + textOf(value) + "; the nearest that it takes is " + textOf(taken));
  }
}

} // namespace

void takeValue(Options& options,
  const Parameter& parameter,
  const std::string& option,
  const std::string& text)
{
  const bool isShare = parameter.isLength && !text.empty() && text.back() == '%';
  Value value = valueOf(parameter, option, isShare ? text.substr(0, text.size() - 1) : text);
  if (isShare)
  {
    value = 0.01 * std::get<double>(value);
    options.shares.insert(parameter.property);
  }
  expectTaken(*options.system, parameter, option, value);
  const auto [place, isFirst] = options.values.try_emplace(parameter.property, value);
  if (!isFirst) // of a list
  {
    std::get<std::string>(place->second) += " " + std::get<std::string>(value);
  }
}

void takePair(Options& options, const Pair& pair, const std::string& option, const std::string& text)
{
  const std::size_t cross = text.find('x');
  const Parameter& first = *findParameter(*options.system, pair.first);
  const Parameter& second = *findParameter(*options.system, pair.second);
  options.values[pair.first] = valueOf(first, option, text.substr(0, cross));
  options.values[pair.second] =
    cross == std::string::npos ? second.initial : valueOf(second, option, text.substr(cross + 1));
  for (const Parameter* side : { &first, &second })
  {
    expectTaken(*options.system, *side, option, options.values[side->property]);
  }
}

void takePhrase(Options& options, const Phrase& phrase, const std::string& option, const std::string& text)
{
  const auto split = [](const std::string& list)
  {
    std::vector<std::string> parts;
    std::istringstream stream(list);
    for (std::string part; std::getline(stream, part, ',');)
    {
      parts.push_back(part);
    }
    return parts;
  };
  const std::vector<std::string> fields = split(phrase.fields), given = split(text);
  if (given.size() != fields.size())
  {
    throw BadUse(option + " takes " + phrase.fields + ", not '" + text + "'");
  }
  Options::Added added;
  added.property = phrase.property;
  added.words = { phrase.word };
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    std::string word = given[i];
    if (fields[i] == "AXIS")
    {
      choiceOf(option + "'s AXIS", word, { "t", "w", "n" });
    }
    else
    {
      if (fields[i] == "LENGTH" && !word.empty() && word.back() == '%')
      {
        word.pop_back();
        added.shares.insert(added.words.size());
      }
      if (numbersOf(option, word).size() != 1)
      {
        throw BadUse(option + " takes " + phrase.fields + ", not '" + text + "'");
      }
    }
    added.words.push_back(word);
  }
  options.added.push_back(added);
}

bool isPlaces(const SystemInput& input, const std::string& given)
{
  return input.orNumbers && !given.empty() && extensionOf(given) != ".vtp";
}

std::vector<std::array<double, 2>> placesOf(const std::string& option, const std::string& text)
{
  std::vector<std::array<double, 2>> places;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');)
  {
    std::istringstream words(part);
    std::string x, y, more;
    if (!(words >> x >> y) || (words >> more))
    {
      throw BadUse(option + " takes a .vtp file or places such as \"0 0, 0.4 0.3, 1 0\", not '" + text + "'");
    }
    places.push_back({ numbersOf(option, x).at(0), numbersOf(option, y).at(0) });
  }
  if (places.size() < 2)
  {
    throw BadUse(option + " takes two places at least, such as \"0 0, 0.4 0.3, 1 0\", not '" + text + "'");
  }
  return places;
}

} // namespace oversketch_command
