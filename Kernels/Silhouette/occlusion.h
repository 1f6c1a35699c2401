// Which points of the picture lie behind triangles: the triangle x point test of SEED, Sec. 3.2.
#ifndef oversketch_kernels_silhouette_occlusion_h
#define oversketch_kernels_silhouette_occlusion_h

#include "Mesh/context.h"
#include "Mesh/view.h"

#include <array>
#include <memory>
#include <vector>

namespace oversketch
{

class Device;

// A point on the mesh to be tested. Triangles incident to one of its vertices cannot hide it: they meet it.
struct OcclusionQuery
{
  Vector3 screen; // View::toScreen
  std::array<int, 3> vertices;
};

// The vertices as View::toScreen has them; depth is minus infinity for one that has no place on screen
// because it is at or behind the eye of a perspective view (or nearer to its plane than a millionth of the
// bounding diagonal).
std::vector<Vector3> projectVertices(const Mesh& mesh, const View& view, const Context& context = Context());

// 1 for every query that some triangle hides: the point lies in the triangle on screen, border included, and
// the triangle is nearer there. Both sides of a triangle hide; one with a vertex that has no place on screen
// hides nothing, nor does one seen edge-on. Published with a bounding box test of every triangle against
// every point; here a uniform grid over the points finds the few that a triangle's box can hold. Arithmetic
// in Real.
template <typename Real>
std::vector<char> occludedOnHost(const Mesh& mesh,
  const std::vector<Vector3>& screen,
  const std::vector<OcclusionQuery>& queries,
  const Context& context = Context());

// Works on an OpenCL device, one work-item per triangle, bit for bit equal to the host in the same
// arithmetic: double where the device has it, else float, whose decisions may differ within 1e-5 of the
// picture's extent. Throws Error(NoDevice) when the device fails.
template <typename Real>
std::vector<char> occludedOnDevice(Device& device,
  const Mesh& mesh,
  const std::vector<Vector3>& screen,
  const std::vector<OcclusionQuery>& queries);

} // namespace oversketch
#endif
