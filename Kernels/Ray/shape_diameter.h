// Shape diameter function: local thickness from cones of rays (SEED, Sec. 4.1).
#ifndef oversketch_kernels_ray_shape_diameter_h
#define oversketch_kernels_ray_shape_diameter_h

#include "Mesh/context.h"
#include "Mesh/mesh.h"
#include "OpenCL/device.h"

#include <memory>
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
  long long raysCast = 0;       // rayCount per vertex that has a normal
  Backend used = Backend::Host;
  Message warning; // why the host stood in for the device, or empty
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

// The shape diameter where it is asked for. Per vertex the rays of the cone round -normal; each ends where it
// first leaves through a facet that does not touch the vertex. Vertices without such a ray get the mean of
// their measured neighbours, ring by ring; pieces without any measured vertex the mean of all measured ones;
// a mesh without any its bounding-box diagonal. A value is the same, bit for bit, whatever was asked for
// before.
class Diameters
{
public:
  // Makes what rays need. The first three must outlive it.
  Diameters(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<Vector3>& normals,
    const ShapeDiameterOptions& options,
    const Context& context);
  ~Diameters();

  // Makes the values of these vertices known. Where `hits` is given, of mesh.points.size() * rayCount, it
  // receives the rays of vertex v at v * rayCount, of vertices that were not known. Throws Error(Cancelled);
  // what is known by then stays.
  void require(const std::vector<int>& vertices,
    const Context& context,
    std::vector<ConeHit>* hits = nullptr);
  void requireAll(const Context& context, std::vector<ConeHit>* hits = nullptr);

  // Lets go of what rays need, some 150 bytes a triangle, which is made again when it is.
  void rest();

  bool knows(int vertex) const { return this->States[vertex] == State::Known; }
  const std::vector<double>& values() const { return this->Values.diameter; } // 0 where not known
  // The values with how they came about.
  const ShapeDiameter& result() const { return this->Values; }

private:
  enum class State : char
  {
    Untried,
    Unmeasured, // none of its rays left through a facet, or it has none
    Known
  };
  class Cones;

  void start();
  void prepare(const Context& context);
  void goOnWithoutDevice(const Error& error); // throws it where it is another one
  void compute(const std::vector<int>& vertices, const Context& context, std::vector<ConeHit>* hits);
  void measure(const std::vector<int>& vertices, const Context& context, std::vector<ConeHit>* hits);
  void fill(const std::vector<int>& unmeasured, const Context& context, std::vector<ConeHit>* hits);

  const Mesh& Model;
  const Adjacency& Neighbours;
  const std::vector<Vector3>& Normals;
  ShapeDiameterOptions Options;
  std::unique_ptr<Cones> Rays; // none at rest, and where the mesh has no triangles
  std::vector<State> States;   // by vertex
  ShapeDiameter Values;
};

// All of them.
ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits = nullptr);

} // namespace oversketch
#endif
