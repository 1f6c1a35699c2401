#include "Ray/shape_diameter.h"

#include "Ray/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int raysPerBlock =
  1 << 18;                          // a block's arrays stay in the cache, and a cancel waits for one at most
constexpr int verticesPerPart = 32; // of a block
constexpr double evenRing = 1e-4;   // of the edges' sum: less is rounding, also far from the origin

// Length of the ray [model length] to the plane of the facet that the caster found, in double precision. The
// caster's own length stands where the ray grazes the plane, or the corners moved more than it when they were
// rounded.
double refine(const RayScene& scene, const RayHit& hit, const Vector3& origin, const Vector3& direction)
{
  const RayFacet& facet = scene.facets[hit.triangle];
  const double coarse = hit.distance;
  const double exact = (facet.offset - facet.plane.dot(origin)) / facet.plane.dot(direction);
  return scene.frame.scale *
         (std::abs(exact - coarse) <= 1e-3 * coarse ? exact : coarse); // false for NaN as well
}

constexpr int few = 64; // rays for which the summary needs no memory of its own

// In four parts, which do not wait for each other.
template <typename Term>
double sumOf(int count, const Term& term)
{
  double parts[4] = {};
  int k = 0;
  for (; k + 4 <= count; k += 4)
  {
    for (int part = 0; part < 4; ++part)
    {
      parts[part] += term(k + part);
    }
  }
  for (; k < count; ++k)
  {
    parts[0] += term(k);
  }
  return (parts[0] + parts[1]) + (parts[2] + parts[3]);
}

// Of at least one value.
double medianOf(const double* values, int count)
{
  double fewParted[few];
  std::vector<double> manyParted(count > few ? count : 0);
  double* parted = count > few ? manyParted.data() : fewParted;
  std::copy_n(values, count, parted);
  double* half = parted + count / 2;
  std::nth_element(parted, half, parted + count);
  return count % 2 ? *half : 0.5 * (*std::max_element(parted, half) + *half);
}

} // namespace

std::vector<Vector3> coneDirections(int rayCount, double coneAngle)
{
  const double golden = pi * (3.0 - std::sqrt(5.0));
  const double cap = 1.0 - std::cos(0.5 * coneAngle * pi / 180.0);
  std::vector<Vector3> directions;
  for (int k = 0; k < rayCount; ++k)
  {
    const double c = 1.0 - cap * (k + 0.5) / rayCount;
    const double s = std::sqrt((1.0 - c) * (1.0 + c));
    directions.emplace_back(s * std::cos(k * golden), s * std::sin(k * golden), c);
  }
  return directions;
}

std::vector<Vector3> coneSides(const Mesh& mesh,
  const RayScene& scene,
  const Lists& around,
  const std::vector<Vector3>& normals,
  const Context& context)
{
  struct Sum
  {
    Vector3 edges = Vector3::Zero();
    double total = 0.0;
  };
  std::vector<Sum> sums(mesh.points.size());
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      for (const int t : around[v])
      {
        for (const int n : mesh.triangles[t])
        {
          const Vector3 edge = (mesh.points[n] - mesh.points[v]) / scene.frame.scale;
          const double weight = edge.squaredNorm() * edge.squaredNorm();
          sums[v].edges += weight * edge;
          sums[v].total += weight * edge.norm();
        }
      }
    });
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (scene.places[v] != v)
    {
      sums[scene.places[v]].edges += sums[v].edges;
      sums[scene.places[v]].total += sums[v].total;
    }
  }
  std::vector<Vector3> sides(mesh.points.size(), Vector3::Zero());
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      const Sum& sum = sums[scene.places[v]];
      const Vector3 side = sum.edges - sum.edges.dot(normals[v]) * normals[v];
      if (side.norm() > evenRing * sum.total)
      {
        sides[v] = side.normalized();
      }
    });
  return sides;
}

Eigen::Matrix3d frameAround(const Vector3& axis, const Vector3& side)
{
  // No plane of symmetry of an upright model holds this direction, so that rounding cannot turn its frames.
  Vector3 reference = side.isZero(0.0) ? Vector3(0.4169, 0.5411, 0.7303) : side;
  if (reference.cross(axis).squaredNorm() < 1e-6)
  {
    reference = Vector3(0.7303, -0.4169, 0.5411);
  }
  Eigen::Matrix3d frame;
  frame.col(0) = reference.cross(axis).normalized();
  frame.col(1) = axis.cross(frame.col(0));
  frame.col(2) = axis;
  return frame;
}

double summarise(const ConeHit* hits, const std::vector<double>& weights)
{
  double fewLengths[few], fewWeights[few];
  std::vector<double> manyLengths, manyWeights;
  double *lengths = fewLengths, *weight = fewWeights;
  const int rays = static_cast<int>(weights.size());
  if (rays > few)
  {
    manyLengths.resize(rays);
    manyWeights.resize(rays);
    lengths = manyLengths.data();
    weight = manyWeights.data();
  }
  int count = 0;
  for (int k = 0; k < rays; ++k)
  {
    lengths[count] = hits[k].length;
    weight[count] = weights[k];
    count += hits[k].triangle >= 0;
  }
  if (count == 0)
  {
    return -1.0;
  }
  const double mean = sumOf(count, [&](int k) { return lengths[k]; }) / count;
  const double squares = sumOf(count, [&](int k) { return (lengths[k] - mean) * (lengths[k] - mean); });
  const double median = medianOf(lengths, count);
  // The middle hits are never farther than one deviation, but for rounding.
  const double limit = std::sqrt(squares / count) + 1e-9 * median;
  for (int k = 0; k < count; ++k)
  {
    weight[k] = std::abs(lengths[k] - median) <= limit ? weight[k] : 0.0;
  }
  return sumOf(count, [&](int k) { return weight[k] * lengths[k]; }) /
         sumOf(count, [&](int k) { return weight[k]; });
}

// What is the same for the rays of all vertices, and the work on a part of them.
class Diameters::Cones
{
public:
  Cones(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<Vector3>& normals,
    const ShapeDiameterOptions& options,
    const Context& context)
    : Scene(mesh, context)
    , Sides(options.turnCones ? coneSides(mesh, this->Scene, adjacency.vertexTriangles, normals, context)
                              : std::vector<Vector3>(mesh.points.size(), Vector3::Zero()))
    , Model(mesh)
    , Normals(normals)
    , Cone(coneDirections(options.rayCount, options.coneAngle))
    , Weights(options.rayCount, 1.0)
  {
    for (int k = 0; options.inverseAngleWeights && k < options.rayCount; ++k)
    {
      this->Weights[k] = 1.0 / std::acos(this->Cone[k][2]);
    }
  }

  // Throws Error(NoDevice) where a device is asked for that cannot do it.
  void chooseCaster(const std::shared_ptr<Device>& device, const Context& context)
  {
    this->Caster = device ? makeOpenCLCaster(this->Scene, device, context) : makeEmbreeCaster(this->Scene);
  }
  bool onHost() const { return this->Caster->onHost(); }
  int rayCount() const { return static_cast<int>(this->Cone.size()); }
  // The vertices so that rays traced together visit the same nodes.
  const std::vector<int>& order() const { return this->Scene.order; }

  // Traces and summarises some vertices that have rays.
  void measure(const int* vertices,
    int count,
    const Context& context,
    std::vector<State>& states,
    ShapeDiameter& result,
    std::vector<ConeHit>* allHits) const
  {
    const std::size_t rays = this->Cone.size();
    RayBatch batch;
    batch.raysPerVertex = this->rayCount();
    batch.vertices.assign(vertices, vertices + count);
    batch.directions.resize(count * rays);
    context.each(count,
      [&](int i)
      {
        const Eigen::Matrix3d frame = this->frameOf(vertices[i]);
        for (std::size_t k = 0; k < rays; ++k)
        {
          const Eigen::Vector3f d = (frame * this->Cone[k]).cast<float>();
          batch.directions[i * rays + k] = { d[0], d[1], d[2] };
        }
      });
    std::vector<RayHit> hits;
    this->Caster->cast(batch, hits, context);
    if (context.cancelled())
    {
      return;
    }
    context.parallelFor(count,
      [&](int begin, int end)
      {
        std::vector<ConeHit> lengths(rays);
        for (int i = begin; i < end; ++i)
        {
          // The next one's facets are on their way meanwhile.
          const std::size_t next = std::min(i + 1, end - 1) * rays;
          for (std::size_t ray = next; ray < next + rays; ++ray)
          {
            __builtin_prefetch(&this->Scene.facets[std::max(hits[ray].triangle, 0)]);
          }
          const int v = vertices[i];
          const Vector3 origin = this->Scene.frame.inScene(this->Model.points[v]);
          const Eigen::Matrix3d frame = this->frameOf(v);
          for (std::size_t k = 0; k < rays; ++k)
          {
            const RayHit& hit = hits[i * rays + k];
            lengths[k] = ConeHit();
            if (hit.triangle >= 0)
            {
              lengths[k] = { refine(this->Scene, hit, origin, frame * this->Cone[k]), hit.triangle };
            }
          }
          if (allHits)
          {
            std::copy(
              lengths.begin(), lengths.end(), allHits->begin() + static_cast<std::ptrdiff_t>(v * rays));
          }
          const double diameter = summarise(lengths.data(), this->Weights);
          result.measured[v] = diameter >= 0.0;
          result.diameter[v] = std::max(0.0, diameter);
          states[v] = diameter >= 0.0 ? State::Known : State::Unmeasured;
        }
      });
  }

private:
  Eigen::Matrix3d frameOf(int vertex) const
  {
    return frameAround(-this->Normals[vertex], this->Sides[vertex]);
  }

  RayScene Scene;
  std::vector<Vector3> Sides;
  std::unique_ptr<RayCaster> Caster;
  const Mesh& Model;
  const std::vector<Vector3>& Normals;
  std::vector<Vector3> Cone;
  std::vector<double> Weights;
};

Diameters::Diameters(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context)
  : Model(mesh)
  , Neighbours(adjacency)
  , Normals(normals)
  , Options(options)
{
  this->Values.diameter.resize(mesh.points.size(), 0.0);
  this->Values.measured.resize(mesh.points.size(), 0);
  this->start();
  this->prepare(context);
}

Diameters::~Diameters() = default;

void Diameters::start()
{
  this->States.assign(this->Model.points.size(), State::Unmeasured);
  for (int v = 0; v < this->Model.vertexCount(); ++v)
  {
    const bool hasRays = !this->Model.triangles.empty() && this->Normals[v].squaredNorm() > 0.0;
    this->States[v] = hasRays ? State::Untried : State::Unmeasured;
  }
}

void Diameters::prepare(const Context& context)
{
  if (this->Rays || this->Model.triangles.empty())
  {
    return;
  }
  const std::shared_ptr<Device> device = Device::choose(this->Options.backend, this->Values.warning);
  this->Rays = std::make_unique<Cones>(this->Model, this->Neighbours, this->Normals, this->Options, context);
  try
  {
    this->Rays->chooseCaster(device, context);
    this->Values.used = device ? Backend::OpenCL : Backend::Host;
  }
  catch (const Error& error)
  {
    this->goOnWithoutDevice(error);
  }
}

void Diameters::rest()
{
  this->Rays.reset();
}

void Diameters::goOnWithoutDevice(const Error& error)
{
  if (error.failure() != Failure::NoDevice)
  {
    throw;
  }
  this->Values.warning = { "%1 The host computes instead.", error.message() };
  this->Values.used = this->Options.backend = Backend::Host; // from now on
  this->Rays->chooseCaster(nullptr, {});
}

void Diameters::require(const std::vector<int>& vertices, const Context& context, std::vector<ConeHit>* hits)
{
  std::vector<int> wanted;
  std::vector<char> isWanted(this->Model.points.size(), 0);
  for (const int v : vertices)
  {
    if (!this->knows(v) && !isWanted[v])
    {
      isWanted[v] = 1;
      wanted.push_back(v);
    }
  }
  if (wanted.empty())
  {
    return;
  }
  this->prepare(context);
  try
  {
    this->compute(wanted, context, hits);
  }
  catch (const Error& error)
  {
    this->goOnWithoutDevice(error);
    // The host's values may differ in their last bits, so that those that are known are made anew.
    for (int v = 0; v < this->Model.vertexCount(); ++v)
    {
      if (this->knows(v))
      {
        wanted.push_back(v);
      }
    }
    this->start();
    this->compute(wanted, context, hits);
  }
}

void Diameters::requireAll(const Context& context, std::vector<ConeHit>* hits)
{
  this->prepare(context);
  if (this->Rays)
  {
    this->require(this->Rays->order(), context, hits);
  }
  else
  {
    std::vector<int> all(this->Model.points.size());
    std::iota(all.begin(), all.end(), 0);
    this->require(all, context, hits);
  }
}

void Diameters::compute(const std::vector<int>& vertices, const Context& context, std::vector<ConeHit>* hits)
{
  this->measure(vertices, context, hits);
  std::vector<int> unmeasured;
  std::copy_if(vertices.begin(),
    vertices.end(),
    std::back_inserter(unmeasured),
    [this](int v) { return this->States[v] == State::Unmeasured; });
  this->fill(unmeasured, context, hits);
}

void Diameters::measure(const std::vector<int>& vertices, const Context& context, std::vector<ConeHit>* hits)
{
  std::vector<int> untried;
  std::copy_if(vertices.begin(),
    vertices.end(),
    std::back_inserter(untried),
    [this](int v) { return this->States[v] == State::Untried; });
  if (untried.empty())
  {
    return;
  }
  const int total = static_cast<int>(untried.size());
  const int blockSize = std::max(1, raysPerBlock / this->Rays->rayCount());
  for (int first = 0; first < total; first += blockSize)
  {
    context.checkpoint(static_cast<double>(first) / total);
    const int count = std::min(blockSize, total - first);
    const auto part = [&](int start, int size, const Context& caller)
    { this->Rays->measure(untried.data() + first + start, size, caller, this->States, this->Values, hits); };
    if (this->Rays->onHost())
    {
      // Each part from its rays to its values at once, while they are in the cache.
      context.eachUntilCancelled((count + verticesPerPart - 1) / verticesPerPart,
        [&](int i)
        {
          const int start = i * verticesPerPart;
          part(start, std::min(verticesPerPart, count - start), Context());
        });
    }
    else
    {
      part(0, count, context);
    }
    context.checkpoint(static_cast<double>(first + count) / total);
    this->Values.raysCast += static_cast<long long>(count) * this->Rays->rayCount();
  }
}

// Values for vertices that no ray measured, and for all others of the patches without that they lie in.
void Diameters::fill(const std::vector<int>& unmeasured, const Context& context, std::vector<ConeHit>* hits)
{
  if (unmeasured.empty())
  {
    return;
  }
  std::vector<int> open = unmeasured, ring = unmeasured, beside;
  std::vector<char> isOpen = marksAt(open, this->Model.points.size());
  while (!ring.empty())
  {
    beside.clear();
    for (const int v : ring)
    {
      const auto neighbours = this->Neighbours.vertexVertices[v];
      beside.insert(beside.end(), neighbours.begin(), neighbours.end());
    }
    sortUnique(beside);
    this->measure(beside, context, hits);
    ring.clear();
    for (const int v : beside)
    {
      if (!this->knows(v) && !isOpen[v])
      {
        isOpen[v] = 1;
        ring.push_back(v);
        open.push_back(v);
      }
    }
  }
  std::vector<double>& diameter = this->Values.diameter;
  std::vector<int> rest, filled;
  while (!open.empty())
  {
    rest.clear();
    filled.clear();
    for (const int v : open)
    {
      double neighbours = 0.0;
      int count = 0;
      for (const int n : this->Neighbours.vertexVertices[v])
      {
        if (!isOpen[n])
        {
          neighbours += diameter[n];
          ++count;
        }
      }
      if (count > 0)
      {
        diameter[v] = neighbours / count;
        filled.push_back(v);
      }
      else
      {
        rest.push_back(v);
      }
    }
    if (filled.empty())
    {
      break;
    }
    // Only now: a ring is filled from the ring before, whatever the order of its vertices.
    for (const int v : filled)
    {
      isOpen[v] = 0;
      this->States[v] = State::Known;
    }
    open.swap(rest);
  }
  if (open.empty())
  {
    return;
  }
  // Pieces without any.
  if (this->Rays)
  {
    this->measure(this->Rays->order(), context, hits);
  }
  double sum = 0.0;
  std::size_t count = 0;
  for (int v = 0; v < this->Model.vertexCount(); ++v)
  {
    sum += this->Values.measured[v] ? diameter[v] : 0.0;
    count += this->Values.measured[v] != 0;
  }
  const double fallback = count > 0 ? sum / static_cast<double>(count) : boundingDiagonal(this->Model);
  for (const int v : open)
  {
    diameter[v] = fallback;
    this->States[v] = State::Known;
  }
}

ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits)
{
  if (hits)
  {
    hits->assign(mesh.points.size() * static_cast<std::size_t>(options.rayCount), ConeHit());
  }
  Diameters diameters(mesh, adjacency, normals, options, context);
  diameters.requireAll(context, hits);
  return diameters.result();
}

} // namespace oversketch
