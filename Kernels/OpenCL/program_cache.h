// Compiled OpenCL programs, kept between runs so that no kernel is compiled twice. One file for each program
// and device, in $XDG_CACHE_HOME/oversketch or, where that variable is not set, $HOME/.cache/oversketch;
// without either there is no cache. The folder may be deleted at any time. Nothing that is wrong with it is
// an error: a file that is missing, damaged, of another program or refused by the driver only means that the
// program is compiled, and written again. A folder that cannot be written to means that it is compiled each
// time. While one process builds a program the others wait for it, and then find its file. Ours, since the
// drivers' own caches still parse sources: with PoCL's alone, warm, a stroke by the command takes 0.41 to
// 0.45 s in place of 0.32.
#ifndef oversketch_kernels_open_cl_program_cache_h
#define oversketch_kernels_open_cl_program_cache_h

#include "OpenCL/device.h"

#include <filesystem>
#include <string>
#include <vector>

namespace oversketch
{

// Text of all that the compiled program depends on: our format, platform, device and driver with their
// versions, the options, and the source itself.
std::string programKey(const cl::Device& device, const std::string& source, const std::string& options);

// The file for a key; empty without a cache. The environment is read at each call.
std::filesystem::path programFile(const std::string& key);

// The binary in the file for that key; empty unless the file is whole and of that very key.
std::vector<unsigned char> loadProgram(const std::string& key);

// Writes the file under a temporary name beside it and renames it, so that another process sees all of it or
// none.
void storeProgram(const std::string& key, const std::vector<unsigned char>& binary);

// The program, built for that device: from the cache where it can be, else from the source. `compiled` tells
// which. Throws cl::BuildError, cl::Error.
cl::Program buildProgram(const cl::Context& context,
  const cl::Device& device,
  const std::string& source,
  const std::string& options,
  bool& compiled);

} // namespace oversketch
#endif
