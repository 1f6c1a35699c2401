// Words that the command tells its user while it works, and the interrupt.
#ifndef oversketch_applications_command_terminal_h
#define oversketch_applications_command_terminal_h

#include "files.h"

#include <string>
#include <vector>

namespace oversketch_command
{

// The first SIGINT asks to stop, the second ends the program at once, as SIGTERM and SIGHUP do; no temporary
// file is left.
void catchSignals();
bool interrupted();
// Throws Failed after the first interrupt.
void throwIfInterrupted();

// One line on stderr.
void say(const std::string& text);
// A warning, once however often it is given.
void warn(const std::string& text);
// All warnings so far.
const std::vector<std::string>& warned();
// Each note a line; they are gone afterwards.
void say(oversketch_files::Notes& notes);

// A line that is written over, where stderr is a terminal: share done [0 to 1], what is being done.
void showProgress(double share, const std::string& what);
void clearProgress();

} // namespace oversketch_command
#endif
