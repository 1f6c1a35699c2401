#include "options.h"

#include "film.h"
#include "heights.h"
#include "mesh_file.h"
#include "models.h"
#include "option_values.h"
#include "print_colours.h"
#include "text.h"
#include "upright_picture.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <functional>
#include <set>

namespace oversketch_command
{

using namespace oversketch_files;
using namespace oversketch_session;

namespace
{

// The parameters that have options of their own.
std::vector<Parameter> singlesOf(const SystemRow& system)
{
  std::vector<Parameter> singles;
  for (const Parameter& parameter : system.parameters)
  {
    const auto has = [&](const Pair& pair)
    { return pair.first == parameter.property || pair.second == parameter.property; };
    const auto adds = [&](const Phrase& phrase) { return phrase.property == parameter.property; };
    if (std::none_of(system.pairs.begin(), system.pairs.end(), has) &&
        std::none_of(system.phrases.begin(), system.phrases.end(), adds))
    {
      singles.push_back(parameter);
    }
  }
  return singles;
}

// "PNG" or "auto|on|off"; empty for a switch.
std::string valueName(const Parameter& parameter)
{
  if (parameter.isLength)
  {
    return "X|X%";
  }
  if (parameter.isFile)
  {
    return "JSON";
  }
  if (!parameter.choices.empty())
  {
    return listOf(wordsOf(parameter), "|");
  }
  struct Kinds
  {
    std::string operator()(bool usual) const { return usual ? "on|off" : ""; }
    std::string operator()(int) const { return "N"; }
    std::string operator()(double) const { return "X"; }
    std::string operator()(const std::vector<double>&) const { return "X,X,…"; }
    std::string operator()(const std::string&) const { return "TEXT"; }
  };
  return std::visit(Kinds{}, parameter.initial);
}

// Whether an option names it, and not its place on the command line.
bool isOption(const SystemInput& input)
{
  return (input.optional && input.madeBy.empty()) || input.byOption;
}

bool isLines(const SystemInput& input)
{
  return input.kind == SystemInput::Kind::Stroke || input.kind == SystemInput::Kind::Curves;
}

// "MESH", "STROKE.vtp"
std::string fileName(const SystemInput& input)
{
  std::string name = input.word;
  std::transform(name.begin(),
    name.end(),
    name.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return name + (isLines(input) ? ".vtp" : "") + (input.orNumbers ? "|TEXT" : "");
}

std::string fileHelp(const SystemInput& input)
{
  switch (input.kind)
  {
    case SystemInput::Kind::Mesh:
      return input.help + ", of triangles: " + meshExtensions;
    case SystemInput::Kind::Picture:
      return input.help + ": " + pictureExtensions;
    case SystemInput::Kind::Heights:
      return input.help + ": " + heightsExtensions;
    default:
      return input.help;
  }
}

// An option that a command line may have, once unless it repeats, and what becomes of it.
struct Option
{
  bool takesValue = false;
  std::function<void(const std::string& name, const std::string& value)> take;
  bool repeats = false; // each adds to those before
};
using OptionTable = std::map<std::string, Option>;

Option fileOption(std::string& place, const std::string& extension = {}, const std::string& does = "writes")
{
  return { true,
    [&place, extension, does](const std::string& name, const std::string& value)
    {
      if (value.empty())
      {
        throw BadUse(name + " needs a value");
      }
      if (!extension.empty() && extensionOf(value) != extension)
      {
        throw BadUse(name + " " + does + " a " + extension + " file, not '" + value + "'");
      }
      place = value;
    } };
}

int wholeNumber(const std::string& name, const std::string& value, const std::string& what, double most)
{
  const std::vector<double> numbers = numbersOf(name, value);
  if (numbers.size() != 1 || !(numbers[0] >= 1.0 && numbers[0] <= most) ||
      numbers[0] != std::floor(numbers[0]))
  {
    throw BadUse(name + " takes " + what + ", from 1, not '" + value + "'");
  }
  return static_cast<int>(numbers[0]);
}

// "0.8" or "1%".
void takeWall(Options& options, const std::string& name, const std::string& value)
{
  options.wallIsShare = !value.empty() && value.back() == '%';
  const std::vector<double> numbers =
    numbersOf(name, options.wallIsShare ? value.substr(0, value.size() - 1) : value);
  if (numbers.size() != 1 || !(numbers[0] >= 0.0))
  {
    throw BadUse(
      name + " takes millimetres or a share of the mesh's size, such as 0.8 or 1%, not '" + value + "'");
  }
  options.wall = options.wallIsShare ? 0.01 * numbers[0] : numbers[0];
}

// "cm" or the millimetres of a length of 1.
void takeUnit(Options& options, const std::string& name, const std::string& value)
{
  const std::map<std::string, double> units = {
    { "mm", 1.0 }, { "cm", 10.0 }, { "m", 1000.0 }, { "in", 25.4 }
  };
  const auto known = units.find(value);
  const std::vector<double> numbers =
    known != units.end() ? std::vector<double>{ known->second } : numbersOf(name, value);
  if (numbers.size() != 1 || !(numbers[0] > 0.0))
  {
    throw BadUse(name + " takes mm, cm, m, in, or how many mm a length of 1 is, not '" + value + "'");
  }
  options.millimetres = numbers[0];
}

OptionTable tableOf(Options& options)
{
  OptionTable table = { { "-o", fileOption(options.output) }, { "--output", fileOption(options.output) } };
  if (options.verb == Action::Replay)
  {
    table["--model"] = { true,
      [&options](const std::string& name, const std::string& value)
      { options.model = wholeNumber(name, value, "the number of a model", double(mostModels)); } };
    return table;
  }
  table["--report"] = fileOption(options.report, ".json");
  if (options.verb == Action::Check)
  {
    table["--wall"] = { true,
      [&options](const std::string& name, const std::string& value) { takeWall(options, name, value); } };
    table["--unit"] = { true,
      [&options](const std::string& name, const std::string& value) { takeUnit(options, name, value); } };
  }
  if (!options.system)
  {
    return table;
  }
  table["--inner"] = fileOption(options.inner);
  table["--backend"] = { true, [&options](const std::string& name, const std::string& value) {
                          options.backend = choiceOf(name, value, backendWords());
                        } };
  if (findInput(*options.system, SystemInput::Kind::Stroke))
  {
    table["--picture"] = fileOption(options.picture, ".png");
    table["--turntable"] = { true,
      [&options](const std::string& name, const std::string& value)
      {
        const std::string extension = extensionOf(value) == ".png" ? ".png" : ".ogv";
        fileOption(options.turntable, extension).take(name, value);
      } };
  }
  if (findInput(*options.system, SystemInput::Kind::Mesh))
  {
    table["--proxy-above"] = { true, [&options](const std::string& name, const std::string& value) {
                                options.proxyAbove = wholeNumber(name, value, "a number of triangles", 2e9);
                              } };
  }
  for (const SystemInput& input : options.system->inputs)
  {
    if (isOption(input))
    {
      table["--" + input.word] = fileOption(options.inputs[input.name]);
    }
  }
  for (const Phrase& phrase : options.system->phrases)
  {
    table["--" + phrase.word] = { true,
      [&options, &phrase](const std::string& name, const std::string& value)
      { takePhrase(options, phrase, name, value); },
      true };
  }
  for (const Pair& pair : options.system->pairs)
  {
    table["--" + pair.word] = { true, [&options, &pair](const std::string& name, const std::string& value) {
                                 takePair(options, pair, name, value);
                               } };
  }
  for (const Parameter& parameter : singlesOf(*options.system))
  {
    if (parameter.isFile)
    {
      table["--" + parameter.word] = fileOption(options.textFiles[parameter.property], ".json", "reads");
      continue;
    }
    table["--" + parameter.word] = { !isSwitch(parameter),
      [&options, parameter](const std::string& name, const std::string& value)
      { takeValue(options, parameter, name, value); },
      parameter.isList };
  }
  return table;
}

// Takes what is an option; the rest are files. True where help is asked for.
bool takeOptions(const std::vector<std::string>& arguments,
  const std::string& verb,
  const OptionTable& table,
  std::vector<std::string>& files)
{
  bool onlyFiles = false;
  std::set<std::string> given;
  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    const std::string& argument = arguments[i];
    if (onlyFiles || argument.size() < 2 || argument[0] != '-')
    {
      files.push_back(argument);
      continue;
    }
    const std::size_t equals = argument.rfind("--", 0) == 0 ? argument.find('=') : std::string::npos;
    const std::string name = argument.substr(0, equals);
    const bool isHelp = name == "--help" || name == "-h";
    const auto option = table.find(name);
    if (name == "--")
    {
      onlyFiles = true;
      continue;
    }
    if (!isHelp && option == table.end())
    {
      throw BadUse("'" + name + "' is no option of " + verb);
    }
    const bool takesValue = !isHelp && option->second.takesValue;
    if (!takesValue && equals != std::string::npos)
    {
      throw BadUse(name + " takes no value");
    }
    if (isHelp)
    {
      return true;
    }
    if (!given.insert(name == "-o" ? "--output" : name).second && !option->second.repeats)
    {
      throw BadUse(name + " is given twice; give it once");
    }
    if (takesValue && equals == std::string::npos && ++i == arguments.size())
    {
      throw BadUse(name + " needs a value");
    }
    const bool isApart = takesValue && equals == std::string::npos;
    option->second.take(name,
      isApart      ? arguments[i]
      : takesValue ? argument.substr(equals + 1)
                   : std::string());
  }
  return false;
}

std::vector<std::string> verbs()
{
  std::vector<std::string> all;
  for (const SystemRow& system : systems())
  {
    all.push_back(system.verb);
  }
  all.insert(all.end(), { "assemble", "check", "replay" });
  return all;
}

// The files that must be there, by their order.
void takeFiles(const std::vector<std::string>& files, const std::string& verb, Options& options)
{
  std::vector<std::string*> places;
  std::vector<std::string> wanted;
  if (!options.system)
  {
    places = { &options.session };
    wanted = { options.verb == Action::Replay  ? "a session"
               : options.verb == Action::Check ? "a mesh"
                                               : "a file of parts" };
  }
  else
  {
    for (const SystemInput& input : options.system->inputs)
    {
      std::string& place = options.inputs[input.name];
      if (!isOption(input) && (isNeeded(input, options.values) || files.size() > places.size()))
      {
        places.push_back(&place);
        wanted.push_back("a " + input.word);
      }
    }
  }
  if (files.size() > places.size())
  {
    throw BadUse("'" + files[places.size()] + "' is one file too many");
  }
  if (files.size() < places.size())
  {
    throw BadUse(verb + " needs " + listOf(wanted, " and "));
  }
  for (std::size_t i = 0; i < files.size(); ++i)
  {
    if (files[i].empty())
    {
      throw BadUse(verb + " needs " + wanted[i] + ", and '' names no file");
    }
    *places[i] = files[i];
  }
  for (std::size_t i = 0; options.system && i < options.system->inputs.size(); ++i)
  {
    const SystemInput& input = options.system->inputs[i];
    const std::string& given = options.inputs[input.name];
    if (input.byOption && given.empty())
    {
      throw BadUse(verb + " needs --" + input.word + " " + fileName(input) + ", " + input.help);
    }
    if (isPlaces(input, given))
    {
      placesOf("--" + input.word, given);
    }
  }
  const bool isCheck = options.verb == Action::Check;
  if (options.output.empty() && isCheck)
  {
    return;
  }
  if (options.output.empty())
  {
    throw BadUse(verb + " needs -o OUT, the mesh to write");
  }
  const std::string extension = extensionOf(options.output);
  if (isCheck ? !isAmong(extension, faceColourExtensions) : !isWrittenExtension(extension))
  {
    throw BadUse(
      "'" + options.output + "' is none of the mesh formats " +
      (isCheck ? std::string("that keep colours of faces, ") + faceColourExtensions : writtenExtensions));
  }
}

} // namespace

Options parseArguments(const std::vector<std::string>& arguments)
{
  Options options;
  if (arguments.empty())
  {
    throw BadUse("a command is needed: " + listOf(verbs(), " or "));
  }
  const std::string& verb = arguments[0];
  if (verb == "--help" || verb == "-h" || verb == "--version")
  {
    if (arguments.size() > 1)
    {
      throw BadUse("'" + arguments[1] + "' is one argument too many");
    }
    options.action = verb == "--version" ? Action::Version : Action::Help;
    return options;
  }
  options.verb = verb == "replay"     ? Action::Replay
                 : verb == "assemble" ? Action::Assemble
                 : verb == "check"    ? Action::Check
                                      : Action::RunSystem;
  options.system = findVerb(verb);
  if (options.verb == Action::RunSystem && !options.system)
  {
    throw BadUse("'" + verb + "' is no command; commands are " + listOf(verbs(), " and "));
  }
  std::vector<std::string> files;
  if (takeOptions(arguments, verb, tableOf(options), files))
  {
    return options; // help
  }
  options.action = options.verb;
  takeFiles(files, verb, options);
  return options;
}

std::vector<OptionText> filesOf(const SystemRow& system)
{
  std::vector<OptionText> files;
  for (const SystemInput& input : system.inputs)
  {
    if (!isOption(input))
    {
      files.push_back({ fileName(input), "", fileHelp(input) });
    }
  }
  return files;
}

std::vector<OptionText> neededOf(const SystemRow& system)
{
  std::vector<OptionText> options;
  for (const SystemInput& input : system.inputs)
  {
    if (input.byOption)
    {
      options.push_back({ "--" + input.word, fileName(input), fileHelp(input) });
    }
  }
  return options;
}

std::vector<OptionText> optionsOf(const SystemRow& system)
{
  std::vector<OptionText> options = {
    { "-o, --output", "OUT", std::string("the mesh to write: ") + writtenExtensions }
  };
  for (const OptionText& needed : neededOf(system))
  {
    options.push_back(needed);
  }
  for (const SystemInput& input : system.inputs)
  {
    if (isOption(input) && !input.byOption)
    {
      options.push_back({ "--" + input.word, fileName(input), fileHelp(input) });
    }
  }
  for (const Phrase& phrase : system.phrases)
  {
    options.push_back({ "--" + phrase.word, phrase.fields, phrase.help });
  }
  if (findInput(system, SystemInput::Kind::Stroke))
  {
    options.push_back({ "--picture",
      "PNG",
      "picture of the result from the first stroke's view: strokes over it, in blue what they took hold of, "
      "in orange what moved; needs a display" });
    options.push_back({ "--turntable",
      "FILE",
      "film of the result while the eye goes round it once, in " + std::to_string(framesOfTurn) +
        " frames: .ogv one file, NAME.png pictures NAME_001.png, …; needs a display" });
  }
  options.push_back({ "--report", "JSON", "times of the stages, counts, distances" });
  options.push_back({ "--backend",
    listOf(backendWords(), "|"),
    "where rays and mixtures are computed; auto takes OpenCL where there is a device" });
  if (findInput(system, SystemInput::Kind::Mesh))
  {
    options.push_back({ "--proxy-above",
      "N",
      std::string("a mesh of more triangles ") +
        (system.moves ? "is moved as a coarse one in its place is" : "is refused") +
        "; 8000000 where it is not given" });
  }
  for (const Pair& pair : system.pairs)
  {
    options.push_back({ "--" + pair.word, "X[xY]", pair.help });
  }
  for (const Parameter& parameter : singlesOf(system))
  {
    options.push_back({ "--" + parameter.word,
      valueName(parameter),
      parameter.help + (parameter.isList ? "; may be given again" : "") });
  }
  options.push_back({ "--inner", "DIR", "write what every stage made as .vtp files into this folder" });
  return options;
}

} // namespace oversketch_command
