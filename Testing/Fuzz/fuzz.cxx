// libFuzzer's entry; the target is named by OVERSKETCH_FUZZ.
#include "targets.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

namespace
{

const oversketch_fuzz::Target& target()
{
  static const oversketch_fuzz::Target& chosen = []() -> const oversketch_fuzz::Target&
  {
    const char* const name = std::getenv("OVERSKETCH_FUZZ");
    for (const oversketch_fuzz::Target& one : oversketch_fuzz::targets())
    {
      if (name && one.name == name)
      {
        return one;
      }
    }
    std::fputs("OVERSKETCH_FUZZ names no target; see targets.cxx\n", stderr);
    std::exit(2);
  }();
  return chosen;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size)
{
  try
  {
    target().take(std::string(reinterpret_cast<const char*>(data), size));
  }
  catch (const std::bad_alloc&)
  {
    return 0; // the command says so; what may be asked for at all is -malloc_limit_mb's to judge
  }
  catch (const std::exception& error)
  {
    std::fprintf(stderr, "%s: %s\n", target().name.c_str(), error.what());
    std::abort();
  }
  return 0;
}
