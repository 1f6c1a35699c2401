// `oversketch replay`.
#ifndef oversketch_applications_command_replay_h
#define oversketch_applications_command_replay_h

#include "options.h"

namespace oversketch_command
{

// Reads a session, runs it, writes the mesh, of a scene all models or the one asked for; says on stderr where
// the machine or the mesh are not those that the session recorded. A stroke that failed when the session was
// saved is passed by as it was then, with its reason. Throws Failed. An interrupt (SIGINT) cancels: nothing
// is written.
void replay(const Options& options);

} // namespace oversketch_command
#endif
