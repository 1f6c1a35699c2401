// The command `oversketch`. Exit code 0: done, 1: could not, or check found a fault, 2: bad use.
#include "files.h"
#include "options.h"
#include "terminal.h"
#include "verbs.h"

#include "OpenCL/device.h"

#include "vtkVersion.h"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <csignal>
#include <cstdio>
#include <filesystem>
#include <new>
#include <sstream>
#include <stdexcept>

using namespace oversketch_command;
using namespace oversketch_files;

namespace
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

int run(const std::vector<std::string>& arguments)
{
  const Options options = parseArguments(arguments);
  catchSignals();
  catchMessages();
  switch (options.action)
  {
    case Action::Help:
      std::fputs((options.verb == Action::Replay      ? replayHelpText()
                   : options.verb == Action::Assemble ? assembleHelpText()
                   : options.verb == Action::Check    ? checkHelpText()
                   : options.system                   ? helpText(*options.system)
                                                      : helpText())
                   .c_str(),
        stdout);
      break;
    case Action::Version:
      std::fputs(versionText().c_str(), stdout);
      break;
    case Action::RunSystem:
      runSystem(options);
      break;
    case Action::Replay:
      replay(options);
      break;
    case Action::Assemble:
      assemble(options);
      break;
    case Action::Check:
      return check(options) ? 0 : 1;
  }
  return 0;
}

} // namespace

int main(int count, char** values)
{
  std::signal(SIGXFSZ, SIG_IGN); // a file beyond the user's limit is a failed write like any other
  try
  {
    return run(std::vector<std::string>(values + 1, values + count));
  }
  catch (const BadUse& error)
  {
    std::fprintf(stderr, "oversketch: %s; see oversketch --help\n", printable(error.what()).c_str());
    return 2;
  }
  catch (const std::bad_alloc&)
  {
    std::fputs("oversketch: out of memory; the input is too large or damaged\n", stderr);
  }
  catch (const std::length_error&)
  {
    std::fputs("oversketch: out of memory; the input is too large or damaged\n", stderr);
  }
  catch (const std::filesystem::filesystem_error& error)
  {
    std::fprintf(stderr,
      "oversketch: %s: %s\n",
      printable(error.path1().string()).c_str(),
      error.code().message().c_str());
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "oversketch: %s\n", printable(error.what()).c_str());
  }
  return 1;
}
