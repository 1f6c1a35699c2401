// Shape diameter function: local thickness from cones of rays (SEED, Sec. 4.1).
#ifndef oversketch_shape_diameter_h
#define oversketch_shape_diameter_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "OpenCL/device.h"

#include <string>
#include <vector>

namespace oversketch
{

struct ShapeDiameterOptions
{
  int rayCount = 32;
  double coneAngle = 60.0; // full opening [degrees], in (0, 180)
  bool inverseAngleWeights = false;
  Backend backend = Backend::Auto; // Host: Embree
};

struct ShapeDiameter
{
  std::vector<double> diameter; // per vertex [model length], finite
  std::vector<char> measured;   // per vertex, 1 where a ray left through a facet
  long long raysTraced = 0;     // rayCount per vertex that has a normal
  Backend used = Backend::Host;
  std::string warning; // why the host stood in for the device, or empty
};

// One hit of a cone's ray, in the precision of the mesh.
struct ConeHit
{
  double length = -1.0; // [model length], -1: no hit
  int triangle = -1;
};

// Directions of a cone round +z, equal in solid angle: cos phi_k = 1 - (1 - cos beta)(k + 0.5)/N, beta half
// the opening, azimuth k times the golden angle.
std::vector<Vector3> coneDirections(int rayCount, double coneAngle);

// A right-handed frame (columns) whose third axis is `axis`, a unit vector. A continuous function of the axis
// but at two opposite directions that upright models do not have.
Eigen::Matrix3d frameAround(const Vector3& axis);

// The summary of one cone: hits farther than one standard deviation from the median are dropped, the rest
// averaged with the weights of their directions. -1 without a hit.
double summarise(const ConeHit* hits, const std::vector<double>& weights);

// Per vertex the rays of the cone round -normal; each ends where it first leaves through a facet that does
// not touch the vertex. Vertices without such a ray get the mean of their measured neighbours, ring by ring;
// pieces without any measured vertex the mean of all measured ones; a mesh without any its bounding-box
// diagonal. Where `hits` is given it receives the rays of vertex v at v * rayCount. Throws Error(Cancelled).
ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits = nullptr);

} // namespace oversketch
#endif
