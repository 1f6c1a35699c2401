// Functions compiled for several processors; the widest that runs here is taken when the program starts.
#ifndef oversketch_kernels_mesh_clones_h
#define oversketch_kernels_mesh_clones_h

// GCC's thread sanitizer cannot start a program whose functions are chosen while it loads; its -Wodr takes
// the clones of one for two, so that who compiles with that says OVERSKETCH_NO_CLONES.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) &&             \
  !defined(__SANITIZE_THREAD__) && !defined(OVERSKETCH_NO_CLONES)
#define OVERSKETCH_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define OVERSKETCH_CLONES
#endif

#endif
