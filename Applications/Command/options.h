// The command line of `oversketch`: its verbs, their options and files, all from the list of systems.
#ifndef oversketch_applications_command_options_h
#define oversketch_applications_command_options_h

#include "large_mesh.h"
#include "systems.h"

#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace oversketch_command
{

// A command line that makes no sense. Exit code 2.
struct BadUse : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

enum class Action
{
  Help, // of the command, or of one of its verbs
  Version,
  RunSystem,
  Replay,
  Assemble,
  Check
};

struct Options
{
  Action action = Action::Help;
  Action verb = Action::RunSystem;                       // what the verb does, also where help is asked for
  const oversketch_session::SystemRow* system = nullptr; // null for other verbs and what is of none
  std::map<std::string, std::string> inputs;             // files, by the names of the system's inputs
  oversketch_session::Values values;
  std::set<std::string> shares; // properties whose values are shares of the mesh's size, to be multiplied
  // Words that phrases add to texts, and numbers of words that are shares, to be multiplied.
  struct Added
  {
    std::string property;
    std::vector<std::string> words; // "move", "0.5", "n", "0.1"
    std::set<std::size_t> shares;
  };
  std::vector<Added> added;
  std::map<std::string, std::string> textFiles; // by the properties that they say
  std::string session; // replay: a session; assemble: the file of the parts; check: a mesh
  int model = 0;       // replay: of the scene, from 1; 0: all of them
  double wall = 0.0;   // check: mm that no wall may be below, or a share of the mesh's size
  bool wallIsShare = false;
  double millimetres = 1.0; // check: of a length of 1 in the file
  std::string output, picture, turntable, report, inner;
  int backend = 0; // vtkOversketchSystem::BackendType
  vtkIdType proxyAbove = oversketch_session::mostTriangles;
};

// Throws BadUse, naming the argument.
Options parseArguments(const std::vector<std::string>& arguments);

// An option as help and man page show it.
struct OptionText
{
  std::string names; // "-o, --output"
  std::string value; // "OUT", empty for a switch
  std::string help;  // ends without a stop
};
// Everything that a system's verb takes, in the order of its help: files that must be there, then options.
std::vector<OptionText> filesOf(const oversketch_session::SystemRow& system);
// The ones of these that must be given, but -o.
std::vector<OptionText> neededOf(const oversketch_session::SystemRow& system);
std::vector<OptionText> optionsOf(const oversketch_session::SystemRow& system);

// "oversketch one-stroke MESH STROKE.vtp -o OUT [options]"
std::string usageOf(const oversketch_session::SystemRow& system);
std::string helpText();
std::string helpText(const oversketch_session::SystemRow& system);
std::string replayHelpText();
std::string assembleHelpText();
std::string checkHelpText();

} // namespace oversketch_command
#endif
