#include "option_names.h"

#include "option_values.h" // isSwitch

#include <algorithm>
#include <cctype>

namespace oversketch_command
{

using namespace oversketch_session;

namespace
{

// How a name is written, and what is said of a setting that is to be turned on or off.
struct Wording
{
  std::string (*name)(const std::string& word);
  std::string (*turned)(const Parameter& parameter, const std::string& word, bool on);
};

// The option that gives the property; empty where only phrases do.
std::string optionOf(const SystemRow& system, const Parameter& parameter)
{
  for (const Pair& pair : system.pairs)
  {
    if (pair.first == parameter.property || pair.second == parameter.property)
    {
      return pair.word;
    }
  }
  const bool isOfPhrases = std::any_of(system.phrases.begin(),
    system.phrases.end(),
    [&](const Phrase& phrase) { return phrase.property == parameter.property; });
  return isOfPhrases ? "" : parameter.word;
}

std::string worded(const oversketch::Message& message, const SystemRow& system, const Wording& wording)
{
  oversketch::Message::Wording words;
  words.name = [&](const std::string& named)
  {
    const std::string property = oversketch::Message::propertyIn(named),
                      value = oversketch::Message::valueIn(named);
    const Parameter* parameter = findParameter(system, property);
    const std::string word = parameter ? optionOf(system, *parameter) : "";
    if (word.empty())
    {
      return oversketch::Message::asProperty(named);
    }
    if (value == "on" || value == "off")
    {
      return wording.turned(*parameter, word, value == "on");
    }
    std::string choice = value;
    std::transform(choice.begin(),
      choice.end(),
      choice.begin(),
      [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return wording.name(word) + (choice.empty() ? "" : ' ' + choice);
  };
  return message.text(words);
}

} // namespace

std::string inOptions(const oversketch::Message& message, const SystemRow& system)
{
  return worded(message,
    system,
    { [](const std::string& word) { return "--" + word; },
      [](const Parameter& parameter, const std::string& word, bool on)
      {
        return !isSwitch(parameter) ? "give --" + word + (on ? " on" : " off")
               : on                 ? "give --" + word
                                    : "leave out --" + word;
      } });
}

std::string inMembers(const oversketch::Message& message, const SystemRow& system)
{
  return worded(message,
    system,
    { [](const std::string& word) { return '\'' + word + '\''; },
      [](const Parameter&, const std::string& word, bool on)
      { return "set '" + word + "' to " + (on ? "true" : "false"); } });
}

} // namespace oversketch_command
