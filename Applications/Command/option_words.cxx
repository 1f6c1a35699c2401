#include "option_words.h"

#include "option_values.h"

#include <algorithm>
#include <cctype>
#include <utility>
#include <vector>

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

bool isOfName(char c)
{
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '/';
}

// Whether the word at a place is the setting, and no part of another name, of a file, or an array's.
bool isSetting(const std::string& text, std::size_t at, std::size_t size)
{
  const std::size_t end = at + size;
  const bool isInName = (at > 0 && (isOfName(text[at - 1]) || text[at - 1] == '.')) ||
                        (end < text.size() && isOfName(text[end])) ||
                        (end + 1 < text.size() && text[end] == '.' && isOfName(text[end + 1]));
  const bool isQuoted =
    std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '"') % 2 == 1;
  const auto follows = [&](const std::string& before)
  { return at >= before.size() && text.compare(at - before.size(), before.size(), before) == 0; };
  return !isInName && !isQuoted && !follows("rray ") && !follows("rrays ") && !follows("has a ");
}

// The end of the choice that follows at a place, such as that of " Off", and its word.
std::pair<std::size_t, std::string> choiceAt(const std::string& text,
  std::size_t at,
  const Parameter& parameter)
{
  std::size_t end = std::min(at + 1, text.size());
  std::string word;
  for (; end < text.size() && std::isalpha(static_cast<unsigned char>(text[end])) != 0; ++end)
  {
    word += static_cast<char>(std::tolower(static_cast<unsigned char>(text[end])));
  }
  const std::vector<std::string> words = wordsOf(parameter);
  const bool isChoice = at + 1 < text.size() && text[at] == ' ' &&
                        std::isupper(static_cast<unsigned char>(text[at + 1])) != 0 &&
                        std::find(words.begin(), words.end(), word) != words.end();
  return isChoice ? std::pair(end, ' ' + word) : std::pair(at, std::string());
}

std::string worded(std::string text, const SystemRow& system, const Wording& wording)
{
  const auto stands = [&text](const std::string& part, std::size_t at)
  { return at < text.size() && text.compare(at, part.size(), part) == 0; };
  for (const Parameter& parameter : system.parameters)
  {
    const std::string word = optionOf(system, parameter), &property = parameter.property;
    for (std::size_t at = 0; !word.empty() && (at = text.find(property, at)) != std::string::npos;)
    {
      std::size_t begin = at, end = at + property.size();
      std::string said = property;
      const std::string turn = "turn ";
      if (isSetting(text, at, property.size()))
      {
        const bool isOn = stands(" on", end), isOff = stands(" off", end);
        if (at >= turn.size() && stands(turn, at - turn.size()) && (isOn || isOff))
        {
          said = wording.turned(parameter, word, isOn);
          begin -= turn.size();
          end += isOn ? 3 : 4;
        }
        else
        {
          const auto [after, choice] = choiceAt(text, end, parameter);
          said = wording.name(word) + choice;
          end = after;
        }
      }
      text.replace(begin, end - begin, said);
      at = begin + said.size();
    }
  }
  return text;
}

} // namespace

std::string inOptions(const std::string& message, const SystemRow& system)
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

std::string inMembers(const std::string& message, const SystemRow& system)
{
  return worded(message,
    system,
    { [](const std::string& word) { return '\'' + word + '\''; },
      [](const Parameter&, const std::string& word, bool on)
      { return "set '" + word + "' to " + (on ? "true" : "false"); } });
}

} // namespace oversketch_command
