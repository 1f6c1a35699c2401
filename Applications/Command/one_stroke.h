// `oversketch one-stroke`.
#ifndef oversketch_command_one_stroke_h
#define oversketch_command_one_stroke_h

#include "options.h"

namespace oversketch_command
{

// Reads, deforms, writes; notes and warnings go to stderr, a progress line too where that is a terminal.
// Throws Failed. An interrupt (SIGINT) cancels: nothing is written.
void oneStroke(const Options& options);

} // namespace oversketch_command
#endif
