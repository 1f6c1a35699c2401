// What --version says.
#ifndef oversketch_applications_command_version_h
#define oversketch_applications_command_version_h

#include <string>

namespace oversketch_command
{

// Oversketch, VTK, OpenCL platform and device, Embree, build.
std::string versionText();

} // namespace oversketch_command
#endif
