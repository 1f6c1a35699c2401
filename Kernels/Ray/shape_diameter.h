// Shape diameter function: local thickness from cones of rays (SEED, Sec. 4.1).
#ifndef oversketch_kernels_ray_shape_diameter_h
#define oversketch_kernels_ray_shape_diameter_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "OpenCL/device.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace oversketch
{

struct RayScene;

struct ShapeDiameterOptions
{
  int rayCount = 32;
  double coneAngle = 60.0; // full opening [degrees], in (0, 180)
  bool inverseAngleWeights = false;
  bool turnCones = true;           // lay rays by coneSides and not by a fixed direction
  Backend backend = Backend::Auto; // Host: Embree

  bool operator==(const ShapeDiameterOptions& other) const
  {
    return this->rayCount == other.rayCount && this->coneAngle == other.coneAngle &&
           this->inverseAngleWeights == other.inverseAngleWeights && this->turnCones == other.turnCones &&
           this->backend == other.backend;
  }
};

struct ShapeDiameter
{
  std::vector<double> diameter; // per vertex [model length], finite
  std::vector<char> measured;   // per vertex, 1 where a ray left through a facet
  long long raysTraced = 0;     // rayCount per vertex that has a normal
  long long raysCast = 0;       // those of them that KnownDiameters did not answer
  Backend used = Backend::Host;
  Message warning; // why the host stood in for the device, or empty
};

// One hit of a cone's ray, in the precision of the mesh.
struct ConeHit
{
  double length = -1.0; // [model length], -1: no hit
  int triangle = -1;
};

// Per vertex what its rays say.
struct ConeMeasures
{
  std::vector<double> diameter; // 0 where no ray left through a facet
  std::vector<char> measured;
  std::vector<float> reach; // the longest ray [unit of the scene of rays], infinite where one has no end
  std::vector<std::uint8_t>
    lengths; // of each ray, rounded up, as parts of the longest: see known_diameters.h
};

// Results that a computation leaves for that of the next mesh. A vertex whose point and normal stayed keeps
// its value if its cone, as far as its rays went, meets no facet that came or went; only the others are cast
// again. Without mesh and normals 7 bytes a triangle and half a byte a ray.
struct KnownDiameters
{
  bool filled = false;
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const std::vector<Vector3>> normals;
  std::vector<Vector3> sides; // see coneSides
  ShapeDiameterOptions options;
  Backend used = Backend::Host;
  ConeMeasures measures;

  // Set by who keeps the mesh that is measured next, which is then not copied.
  std::shared_ptr<const Mesh> nextMesh;
  std::shared_ptr<const std::vector<Vector3>> nextNormals;
};

// Directions of a cone round +z, equal in solid angle: cos phi_k = 1 - (1 - cos beta)(k + 0.5)/N, beta half
// the opening, azimuth k times the golden angle.
std::vector<Vector3> coneDirections(int rayCount, double coneAngle);

// Per vertex a unit vector across its normal that turns with the model: where its longer edges point to. Zero
// where edges are as long on all sides. A cone whose rays lie by it says the same of a turned model.
// `around`: see trianglesAround. Where vertices lie at one place their triangles count together.
std::vector<Vector3> coneSides(const Mesh& mesh,
  const RayScene& scene,
  const Lists& around,
  const std::vector<Vector3>& normals,
  const Context& context);

// A right-handed frame (columns) whose third axis is `axis`, a unit vector, and whose first is across `side`.
// For a zero side a continuous function of the axis but at two opposite directions that upright models do not
// have.
Eigen::Matrix3d frameAround(const Vector3& axis, const Vector3& side = Vector3::Zero());

// The summary of one cone: hits farther than one standard deviation from the median are dropped, the rest
// averaged with the weights of their directions. -1 without a hit.
double summarise(const ConeHit* hits, const std::vector<double>& weights);

// Per vertex the rays of the cone round -normal; each ends where it first leaves through a facet that does
// not touch the vertex. Vertices without such a ray get the mean of their measured neighbours, ring by ring;
// pieces without any measured vertex the mean of all measured ones; a mesh without any its bounding-box
// diagonal. Where `known` is given, what it holds of another mesh spares rays, and it then holds this mesh:
// the result is the same, bit for bit. Where `hits` is given it receives the rays of vertex v at v *
// rayCount, and all are cast. Throws Error(Cancelled); `known` then stays as it is.
ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits = nullptr,
  KnownDiameters* known = nullptr);

} // namespace oversketch
#endif
