#include "Ray/surface_rays.h"

#include "Mesh/match.h"
#include "Mesh/nearest.h"
#include "Mesh/shape.h"
#include "Ray/embree.h"
#include "Ray/ray_caster.h" // for RayFrame

#include <algorithm>
#include <cmath>
#include <mutex>

namespace oversketch
{

namespace
{

// By so much [unit of the scene, where the mesh lies within [-1, 1]] boxes are wider than their facets, and
// the tree is searched beyond the best hit: many times the rounding of single precision.
constexpr double treeSlack = 1e-5;

// The facets in the unit of the scene, where no product underflows and the distance from the origin is gone.
struct SceneFacets
{
  explicit SceneFacets(std::shared_ptr<const Mesh> surface)
    : mesh(std::move(surface))
    , frame(*this->mesh)
  {
  }
  Vector3 inScene(const Vector3& point) const { return this->frame.inScene(point); }
  Vector3 corner(int triangle, int k) const
  {
    return this->inScene(this->mesh->points[this->mesh->triangles[triangle][k]]);
  }

  std::shared_ptr<const Mesh> mesh;
  RayFrame frame;
};

struct Crossing
{
  SurfacePoint at;
  double along = std::numeric_limits<double>::infinity();
};

bool isBefore(const Crossing& a, const Crossing& b)
{
  return a.along != b.along ? a.along < b.along : a.at.triangle < b.at.triangle;
}

// A line through the scene. It starts a little outside, whatever its own origin is, so that what the tree is
// asked is as precise for an eye far away.
struct SceneLine
{
  static constexpr double length = 4.0; // all of the scene lies within 2 of its centre

  // False where the line passes the scene by.
  bool aim(const SceneFacets& facets, const Ray& ray)
  {
    this->direction = ray.direction.stableNormalized();
    const Vector3 origin = facets.inScene(ray.origin);
    const double middle = -origin.dot(this->direction);
    const Vector3 foot = origin + middle * this->direction;
    if (!(std::abs(this->direction.squaredNorm() - 1.0) < 1e-6) || !(foot.norm() <= 0.5 * length))
    {
      return false;
    }
    this->start = foot - 0.5 * length * this->direction;
    this->rayOrigin = 0.5 * length - middle;
    this->right = this->direction.unitOrthogonal();
    this->up = this->direction.cross(this->right);
    return true;
  }

  // Where the line meets a facet. A corner's place across the line and the side of an edge on which the line
  // passes are computed alike for every facet that has them, so neighbours agree and leave no gap.
  bool meets(const SceneFacets& facets, int triangle, Crossing& crossing) const
  {
    const Triangle& ids = facets.mesh->triangles[triangle];
    Vector2 across[3];
    Vector3 along;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 p = facets.corner(triangle, k) - this->start;
      across[k] = { p.dot(this->right), p.dot(this->up) };
      along[k] = p.dot(this->direction);
    }
    Vector3 side;
    for (int k = 0; k < 3; ++k)
    {
      const int i = (k + 1) % 3, j = (k + 2) % 3;
      const bool ordered = ids[i] < ids[j];
      const Vector2 &a = across[ordered ? i : j], &b = across[ordered ? j : i];
      const double twice = cross(a, b);
      side[k] = ordered ? twice : -twice;
    }
    const double sum = side.sum();
    if ((side.minCoeff() < 0.0 && side.maxCoeff() > 0.0) || !(std::abs(sum) > 0.0))
    {
      return false;
    }
    const Vector3 weights = side / sum;
    crossing.at = { triangle, { weights[0], weights[1], weights[2] } };
    crossing.along = weights.dot(along);
    return true;
  }

  Vector3 start, direction, right, up;
  double rayOrigin; // where the ray's own origin is, counted from the start
};

// A tree's facets, by their places in it, as triangles of the mesh that is asked.
struct FacetNumbers
{
  const SceneFacets* facets = nullptr;
  const std::vector<int>* numbers = nullptr; // -1: the mesh has no such triangle; null: places are numbers

  int triangle(unsigned int place) const
  {
    return this->numbers ? (*this->numbers)[place] : static_cast<int>(place);
  }
};

// State that the callbacks read and write for the line in flight. Embree hands it back as the context that it
// is.
struct LineQuery : embree::Context
{
  FacetNumbers of;
  SceneLine line;
  double from = 0.0; // hits before it do not count
  Crossing best;     // where `every` is null
  std::vector<Crossing>* every = nullptr;
};

struct NearestQuery
{
  FacetNumbers of;
  Vector3 point;
  SurfacePoint at;
  double squared = std::numeric_limits<double>::infinity(); // distance

  // Within which the tree is searched.
  float radius() const
  {
    return static_cast<float>((1.0 + treeSlack) * std::sqrt(this->squared) + treeSlack);
  }
};

void boundFacet(const RTCBoundsFunctionArguments* arguments)
{
  const FacetNumbers& of = *static_cast<const FacetNumbers*>(arguments->geometryUserPtr);
  const SceneFacets& facets = *of.facets;
  const int triangle = of.triangle(arguments->primID);
  const Vector3 a = facets.corner(triangle, 0), b = facets.corner(triangle, 1),
                c = facets.corner(triangle, 2);
  const Eigen::Vector3f low = (a.cwiseMin(b).cwiseMin(c).array() - treeSlack).cast<float>();
  const Eigen::Vector3f high = (a.cwiseMax(b).cwiseMax(c).array() + treeSlack).cast<float>();
  *arguments->bounds_o = { low[0], low[1], low[2], 0.0f, high[0], high[1], high[2], 0.0f };
}

void crossFacet(const RTCIntersectFunctionNArguments* arguments)
{
  if (!arguments->valid[0])
  {
    return;
  }
  LineQuery& query = *static_cast<LineQuery*>(arguments->context);
  const int triangle = query.of.triangle(arguments->primID);
  Crossing crossing;
  if (triangle < 0 || !query.line.meets(*query.of.facets, triangle, crossing) ||
      !(crossing.along >= query.from))
  {
    return;
  }
  if (query.every)
  {
    query.every->push_back(crossing);
  }
  else if (isBefore(crossing, query.best))
  {
    query.best = crossing;
    RTCRayN* ray = RTCRayHitN_RayN(arguments->rayhit, arguments->N);
    RTCRayN_tfar(ray, arguments->N, 0) = static_cast<float>(crossing.along + treeSlack);
  }
}

bool approachFacet(RTCPointQueryFunctionArguments* arguments)
{
  NearestQuery& query = *static_cast<NearestQuery*>(arguments->userPtr);
  const int triangle = query.of.triangle(arguments->primID);
  if (triangle < 0)
  {
    return false;
  }
  const Vector3 a = query.of.facets->corner(triangle, 0) - query.point;
  const Vector3 b = query.of.facets->corner(triangle, 1) - query.point;
  const Vector3 c = query.of.facets->corner(triangle, 2) - query.point;
  const std::array<double, 3> w = closestWeights(a, b, c, Vector3::Zero());
  const double squared = (w[0] * a + w[1] * b + w[2] * c).squaredNorm();
  if (squared > query.squared || (squared == query.squared && triangle > query.at.triangle))
  {
    return false;
  }
  query.squared = squared;
  query.at = { triangle, w };
  arguments->query->radius = query.radius();
  return true;
}

// The tree is being built: false stops that.
bool keepsBuilding(void* context, double)
{
  return !static_cast<const Context*>(context)->cancelled();
}

// Embree's tree of some facets.
class FacetTree
{
public:
  // Takes all facets.
  FacetTree(const SceneFacets& facets, const Context& context)
    : Facets(facets)
    , Device(embree::startDevice())
  {
    this->build({ &this->Facets, nullptr }, this->Facets.mesh->triangles.size(), context);
  }
  // Takes some, by a device that there is.
  FacetTree(const SceneFacets& facets,
    std::vector<int> chosen,
    const FacetTree& other,
    const Context& context)
    : Facets(facets)
    , Chosen(std::move(chosen))
    , Device(other.Device.get())
  {
    rtcRetainDevice(this->Device.get());
    this->build({ &this->Facets, &this->Chosen }, this->Chosen.size(), context);
  }
  FacetTree(const FacetTree&) = delete;
  FacetTree& operator=(const FacetTree&) = delete;

  const SceneFacets& facets() const { return this->Facets; }
  const std::vector<int>& chosen() const { return this->Chosen; }

  void trace(LineQuery& query) const
  {
    const Eigen::Vector3f start = query.line.start.cast<float>(), way = query.line.direction.cast<float>();
    const double end = std::min(SceneLine::length, query.best.along + treeSlack); // as crossFacet has it
    embree::trace(this->Scene.get(),
      query,
      start.data(),
      way.data(),
      static_cast<float>(std::max(0.0, query.from - treeSlack)),
      static_cast<float>(end));
  }

  void approach(NearestQuery& nearest) const
  {
    RTCPointQuery query;
    query.x = static_cast<float>(nearest.point[0]);
    query.y = static_cast<float>(nearest.point[1]);
    query.z = static_cast<float>(nearest.point[2]);
    query.time = 0.0f;
    query.radius = nearest.radius();
    RTCPointQueryContext context;
    rtcInitPointQueryContext(&context);
    rtcPointQuery(this->Scene.get(), &query, &context, approachFacet, &nearest);
  }

private:
  void build(FacetNumbers of, std::size_t count, const Context& context)
  {
    rtcGetDeviceError(this->Device.get()); // what is left of a build on this thread that was given up
    this->Scene.reset(rtcNewScene(this->Device.get()));
    const embree::Owned<RTCGeometry> geometry(rtcNewGeometry(this->Device.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryUserPrimitiveCount(geometry.get(), static_cast<unsigned int>(count));
    rtcSetGeometryUserData(geometry.get(), &of); // only while it is built
    rtcSetGeometryBoundsFunction(geometry.get(), boundFacet, nullptr);
    rtcSetGeometryIntersectFunction(geometry.get(), crossFacet);
    rtcCommitGeometry(geometry.get());
    rtcAttachGeometry(this->Scene.get(), geometry.get());
    rtcSetSceneFlags(this->Scene.get(), RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneProgressMonitorFunction(this->Scene.get(), keepsBuilding, const_cast<Context*>(&context));
    rtcCommitScene(this->Scene.get());
    rtcSetSceneProgressMonitorFunction(this->Scene.get(), nullptr, nullptr);
    context.checkpoint(1.0);
    embree::checkTaken(this->Device.get());
  }

  SceneFacets Facets;
  std::vector<int> Chosen; // empty: all
  embree::Owned<RTCDevice> Device;
  embree::Owned<RTCScene> Scene;
};

} // namespace

struct SurfaceRays::Trees
{
  explicit Trees(std::shared_ptr<const Mesh> surface)
    : facets(std::move(surface))
    , diagonal(boundingDiagonal(*this->facets.mesh))
  {
  }

  // Each tree in turn, with what its facets are here.
  template <typename Query, typename Ask>
  void ask(Query& query, const Ask& ask) const
  {
    query.of = { &this->facets, this->numbers.empty() ? nullptr : &this->numbers };
    ask(*this->whole);
    if (this->rest)
    {
      query.of.numbers = &this->rest->chosen();
      ask(*this->rest);
    }
  }

  void trace(LineQuery& query) const
  {
    this->ask(query, [&](const FacetTree& tree) { tree.trace(query); });
  }

  // distance in the unit of the scene
  SurfaceHit hit(const SurfacePoint& at, double distance) const
  {
    return { at, positionOf(*this->facets.mesh, at), distance * this->facets.frame.scale };
  }

  SceneFacets facets;
  double diagonal;
  std::shared_ptr<const FacetTree> whole; // of this mesh, or of an earlier one
  std::vector<int> numbers;               // of the earlier one's triangles in this; empty: of this mesh
  std::unique_ptr<const FacetTree> rest;  // of what the earlier one has not; null: nothing
};

SurfaceRays::SurfaceRays(std::shared_ptr<const Mesh> mesh, const Context& context)
{
  auto trees = std::make_unique<Trees>(std::move(mesh));
  trees->whole = std::make_shared<const FacetTree>(trees->facets, context);
  this->Internals = std::move(trees);
}

SurfaceRays::SurfaceRays(std::unique_ptr<const Trees> trees)
  : Internals(std::move(trees))
{
}

std::unique_ptr<const SurfaceRays> SurfaceRays::after(const SurfaceRays& before,
  std::shared_ptr<const Mesh> mesh,
  const Context& context)
{
  auto trees = std::make_unique<Trees>(std::move(mesh));
  const std::shared_ptr<const FacetTree>& whole = before.Internals->whole;
  const RayFrame &frame = trees->facets.frame, &known = whole->facets().frame;
  std::vector<int> others;
  if (frame.centre != known.centre || frame.scale != known.scale ||
      !matchTriangles(*whole->facets().mesh, *trees->facets.mesh, trees->numbers, others))
  {
    return nullptr;
  }
  trees->whole = whole;
  if (!others.empty())
  {
    trees->rest = std::make_unique<const FacetTree>(trees->facets, std::move(others), *whole, context);
  }
  return std::unique_ptr<const SurfaceRays>(new SurfaceRays(std::move(trees)));
}

SurfaceRays::~SurfaceRays() = default;

const Mesh& SurfaceRays::mesh() const
{
  return *this->Internals->facets.mesh;
}

double SurfaceRays::diagonal() const
{
  return this->Internals->diagonal;
}

Vector3 SurfaceRays::centre() const
{
  return this->Internals->facets.frame.centre;
}

SurfaceHit SurfaceRays::nearest(const Ray& ray) const
{
  LineQuery query;
  if (!query.line.aim(this->Internals->facets, ray) || query.line.rayOrigin > SceneLine::length)
  {
    return {};
  }
  query.from = std::max(0.0, query.line.rayOrigin);
  this->Internals->trace(query);
  return query.best.at.triangle < 0
           ? SurfaceHit()
           : this->Internals->hit(query.best.at, query.best.along - query.line.rayOrigin);
}

std::vector<SurfaceHit> SurfaceRays::all(const Ray& line) const
{
  LineQuery query;
  std::vector<SurfaceHit> hits;
  if (!query.line.aim(this->Internals->facets, line))
  {
    return hits;
  }
  std::vector<Crossing> crossings;
  query.every = &crossings;
  this->Internals->trace(query);
  std::sort(crossings.begin(), crossings.end(), isBefore);
  for (const Crossing& crossing : crossings)
  {
    hits.push_back(this->Internals->hit(crossing.at, crossing.along - query.line.rayOrigin));
  }
  return hits;
}

SurfaceHit SurfaceRays::closest(const Vector3& point) const
{
  // Farther away the direction alone counts; its square fits single precision.
  constexpr double farthest = 1e6;
  NearestQuery nearest;
  nearest.point = this->Internals->facets.inScene(point);
  const double away = nearest.point.stableNorm();
  if (!(away <= std::numeric_limits<double>::max()))
  {
    return {};
  }
  if (away > farthest)
  {
    nearest.point *= farthest / away;
  }
  this->Internals->ask(nearest, [&](const FacetTree& tree) { tree.approach(nearest); });
  if (nearest.at.triangle < 0)
  {
    return {};
  }
  SurfaceHit hit = this->Internals->hit(nearest.at, 0.0);
  hit.distance = (hit.position - point).stableNorm();
  return hit;
}

Room roomAt(const SurfaceRays& surface, const Vector3& place, const Vector3& normal)
{
  constexpr double none = std::numeric_limits<double>::infinity();
  Room room{ none, none };
  if (!place.allFinite() || !(normal.norm() > 0.0))
  {
    return room;
  }
  const Vector3 n = normal.normalized();
  for (const SurfaceHit& hit : surface.all({ place, n }))
  {
    const double slope = facetNormal(surface.mesh(), hit.at.triangle).dot(n);
    if (hit.distance < 0.0 && slope < 0.0)
    {
      room.inward = std::min(room.inward, -hit.distance);
    }
    if (hit.distance > 0.0 && slope < 0.0)
    {
      room.outward = std::min(room.outward, hit.distance);
    }
  }
  return room;
}

double depthAt(const SurfaceRays& surface, const Vector3& place, const Vector3& sight)
{
  SurfaceHit before, after;
  for (const SurfaceHit& hit : surface.all({ place, sight }))
  {
    if (hit.distance < 0.0)
    {
      before = hit; // the last one
    }
    else if (!after.found())
    {
      after = hit;
    }
  }
  if (!before.found() || !after.found() ||
      facetNormal(surface.mesh(), before.at.triangle).dot(sight) >= 0.0 ||
      facetNormal(surface.mesh(), after.at.triangle).dot(sight) <= 0.0)
  {
    return 0.0;
  }
  return std::max(-before.distance, after.distance);
}

namespace
{

struct KnownRays
{
  std::mutex mutex;
  std::vector<std::weak_ptr<const SurfaceRays>> all; // the latest last

  // Rays that somebody holds, the latest first.
  std::vector<std::shared_ptr<const SurfaceRays>> held()
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    std::vector<std::shared_ptr<const SurfaceRays>> found;
    for (auto one = this->all.rbegin(); one != this->all.rend(); ++one)
    {
      if (auto rays = one->lock())
      {
        found.push_back(std::move(rays));
      }
    }
    return found;
  }

  void add(const std::shared_ptr<const SurfaceRays>& rays)
  {
    const std::lock_guard<std::mutex> lock(this->mutex);
    this->all.erase(
      std::remove_if(this->all.begin(), this->all.end(), [](const auto& one) { return one.expired(); }),
      this->all.end());
    this->all.push_back(rays);
  }
};

KnownRays& knownRays()
{
  static KnownRays known;
  return known;
}

} // namespace

std::shared_ptr<const SurfaceRays> sharedRays(const std::shared_ptr<const Mesh>& mesh, const Context& context)
{
  KnownRays& known = knownRays();
  const std::vector<std::shared_ptr<const SurfaceRays>> held = known.held();
  for (const auto& rays : held)
  {
    if (&rays->mesh() == mesh.get())
    {
      return rays;
    }
  }
  std::shared_ptr<const SurfaceRays> made;
  for (auto rays = held.begin(); rays != held.end() && !made; ++rays)
  {
    made = SurfaceRays::after(**rays, mesh, context);
  }
  if (!made)
  {
    made = std::make_shared<const SurfaceRays>(mesh, context);
  }
  known.add(made);
  return made;
}

} // namespace oversketch
