// Vectors of the compiler, for loops that compilers do not vectorise on their own. Within OVERSKETCH_CLONES
// functions multiplications and additions may be contracted on processors that can, so none may feed a result
// that has to be the same on every machine.
#ifndef oversketch_kernels_ray_wide_h
#define oversketch_kernels_ray_wide_h

#include "Mesh/clones.h"

namespace oversketch
{

constexpr int wide = 8; // lanes

using WideFloat = float __attribute__((vector_size(wide * sizeof(float))));
using WideInt = int __attribute__((vector_size(wide * sizeof(int))));
using WideDouble = double __attribute__((vector_size(wide * sizeof(double))));
using WideLong = long long __attribute__((vector_size(wide * sizeof(long long))));

// Asks for a line of memory that is read soon.
inline void prefetch(const void* address)
{
#if defined(__GNUC__)
  __builtin_prefetch(address);
#else
  (void)address;
#endif
}

} // namespace oversketch
#endif
