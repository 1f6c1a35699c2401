// One process that needs one program: prints how many it compiled, then what the program computed. For the
// tests.
#include "OpenCL/saxpy.h"

#include <cstdio>
#include <exception>

using namespace oversketch;

int main()
try
{
  const auto device = Device::instance();
  if (!device)
  {
    return 1;
  }
  const std::vector<float> y = oversketch_test::runSaxpy(*device).sums;
  std::printf("%d: %g %g %g %g\n", device->compilations(), y[0], y[1], y[2], y[3]);
  return 0;
}
catch (const std::exception& error)
{
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
