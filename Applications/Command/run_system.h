// `oversketch one-stroke` and the verbs of all other systems: a session of one step.
#ifndef oversketch_applications_command_run_system_h
#define oversketch_applications_command_run_system_h

#include "options.h"

namespace oversketch_command
{

// Reads, runs, writes; notes and warnings go to stderr, a progress line too where that is a terminal. Throws
// Failed. An interrupt (SIGINT) cancels: nothing is written.
void runSystem(const Options& options);

// A picture or a grid of heights. Throws Failed where it is none.
oversketch_session::Image readImage(const std::string& path, oversketch_session::SystemInput::Kind kind);

} // namespace oversketch_command
#endif
