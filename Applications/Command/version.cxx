#include "version.h"

#include "OpenCL/device.h"

#include "vtkVersion.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <sstream>

namespace oversketch_command
{

std::string versionText()
{
  std::ostringstream text;
  text << "Oversketch " << OVERSKETCH_VERSION << '\n';
  text << "VTK        " << vtkVersion::GetVTKVersion() << '\n';
  text << "OpenCL     ";
  if (const auto device = oversketch::Device::instance())
  {
    text << device->info().platform << ", " << device->info().device << " (" << device->info().version
         << ")\n";
  }
  else
  {
    text << "no device; the host does the work\n";
  }
  text << "Embree     " << RTC_VERSION_STRING << '\n';
  text << "Build      " << OVERSKETCH_BUILD << '\n';
  return text.str();
}

} // namespace oversketch_command
