// Where a kernel runs that has two forms.
#ifndef oversketch_kernels_mesh_backend_h
#define oversketch_kernels_mesh_backend_h

namespace oversketch
{

// Auto and OpenCL mean the OpenCL device; where there is none, or it fails, the host stands in with a
// warning.
enum class Backend : int
{
  Auto = 0,
  OpenCL = 1,
  Host = 2
};

// What is warned of where there is none.
constexpr const char* noDeviceText = "There is no OpenCL device; the host computes instead.";

} // namespace oversketch
#endif
