// Writes the manual page: what is told of the systems comes from the list, the rest from a text with lines
// `.\" SYNOPSIS`, `.\" COMMANDS`, `.\" OPTIONS` in its places. A program of the build, not installed.
#include "options.h"

#include <cctype>
#include <fstream>
#include <iostream>

using namespace oversketch_command;
using namespace oversketch_session;

namespace
{

// As roff takes it.
std::string escaped(const std::string& text)
{
  std::string made;
  for (const char c : text)
  {
    made += c == '-' ? "\\-" : c == '\\' ? "\\e" : std::string(1, c);
  }
  return made;
}

std::string bold(const std::string& text)
{
  return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text)
{
  return "\\fI" + escaped(text) + "\\fR";
}

std::string sentence(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return escaped(text) + ".";
}

std::string synopsis()
{
  std::string text;
  for (const SystemRow& system : systems())
  {
    text += bold("oversketch " + system.verb);
    for (const OptionText& file : filesOf(system))
    {
      text += " " + italic(file.names);
    }
    for (const OptionText& option : neededOf(system))
    {
      text += " " + bold(option.names) + " " + italic(option.value);
    }
    text += " " + bold("-o") + " " + italic("OUT") + " [" + italic("options") + "]\n.br\n";
  }
  return text;
}

std::string commands()
{
  std::string text;
  for (const SystemRow& system : systems())
  {
    text += ".TP\n" + bold("oversketch " + system.verb) + "\n" + escaped(system.help);
    for (const OptionText& file : filesOf(system))
    {
      text += "\n" + italic(file.names) + ": " + escaped(file.help) + ".";
    }
    text += "\n";
  }
  return text;
}

std::string options()
{
  std::string text;
  for (const SystemRow& system : systems())
  {
    text += ".SS oversketch " + escaped(system.verb) + "\n";
    for (const OptionText& option : optionsOf(system))
    {
      text += ".TP\n" + bold(option.names) + (option.value.empty() ? "" : " " + italic(option.value)) + "\n" +
              sentence(option.help) + "\n";
    }
  }
  return text;
}

} // namespace

int main(int count, char** values)
{
  std::ifstream frame(count > 1 ? values[1] : "");
  if (!frame)
  {
    std::fputs("man_page FRAME: there is no such file\n", stderr);
    return 1;
  }
  for (std::string line; std::getline(frame, line);)
  {
    if (line == ".\\\" SYNOPSIS")
    {
      std::cout << synopsis();
    }
    else if (line == ".\\\" COMMANDS")
    {
      std::cout << commands();
    }
    else if (line == ".\\\" OPTIONS")
    {
      std::cout << options();
    }
    else
    {
      std::cout << line << '\n';
    }
  }
  return 0;
}
