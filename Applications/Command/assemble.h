// `oversketch assemble`: several parts, drawings with their pictures or meshes, placed and joined into one
// mesh.
#ifndef oversketch_applications_command_assemble_h
#define oversketch_applications_command_assemble_h

#include "options.h"

namespace oversketch_command
{

// Reads, makes each part, joins, writes; as runSystem tells, stops and throws.
void assemble(const Options& options);

} // namespace oversketch_command
#endif
