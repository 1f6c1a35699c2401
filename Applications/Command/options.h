// The command line of `oversketch`.
#ifndef oversketch_command_options_h
#define oversketch_command_options_h

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
  Help,
  OneStrokeHelp,
  ReplayHelp,
  Version,
  OneStroke,
  Replay
};

struct Options
{
  Action action = Action::Help;
  std::string mesh, stroke, output, picture, report, inner; // one-stroke
  std::string session;                                      // replay; its output is above
  int backend = 0;                                          // vtkOversketchOneStroke::BackendType
  int remesh = 0;                                           // vtkOversketchOneStroke::RemeshType
  bool adjustNormals = false;
  bool asPublished = false;
};

// Throws BadUse, naming the argument.
Options parseArguments(const std::vector<std::string>& arguments);
std::string helpText();
std::string oneStrokeHelpText();
std::string replayHelpText();

} // namespace oversketch_command
#endif
