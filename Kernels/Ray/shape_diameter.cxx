#include "Ray/shape_diameter.h"

#include "Ray/known_diameters.h"
#include "Ray/ray_caster.h"
#include "Ray/ray_starts.h"
#include "Ray/wide.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

namespace oversketch
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int raysPerBlock =
  1 << 18;                          // a block's arrays stay in the cache, and a cancel waits for one at most
constexpr int verticesPerPart = 32; // of a block
constexpr double evenRing = 1e-4;   // of the edges' sum: less is rounding, also far from the origin
constexpr int fewCones = 4;         // a part of all for which starts cost more than they save

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

// The values with `below` and with `above` smaller ones before them. At most `few` values: each is compared
// with all, which no branch can go wrong in.
OVERSKETCH_CLONES void ranked(const double* values, int count, int below, int above, double* found)
{
  alignas(sizeof(WideDouble)) double padded[few];
  std::fill(std::copy_n(values, count, padded), padded + few, std::numeric_limits<double>::infinity());
  for (int first = 0; first < count; first += wide)
  {
    WideDouble block;
    std::memcpy(&block, padded + first, sizeof block);
    WideLong less = {}, notMore = {};
    for (int k = 0; k < count; ++k)
    {
      less -= padded[k] < block;
      notMore -= padded[k] <= block;
    }
    for (int i = 0; i < wide; ++i)
    {
      found[0] = less[i] <= below && below < notMore[i] ? block[i] : found[0];
      found[1] = less[i] <= above && above < notMore[i] ? block[i] : found[1];
    }
  }
}

double medianOf(const double* values, int count)
{
  double middle[2] = {};
  if (count <= few)
  {
    ranked(values, count, (count - 1) / 2, count / 2, middle);
  }
  else
  {
    std::vector<double> parted(values, values + count);
    const auto half = parted.begin() + count / 2;
    std::nth_element(parted.begin(), half, parted.end());
    middle[1] = *half;
    middle[0] = count % 2 ? *half : *std::max_element(parted.begin(), half);
  }
  return 0.5 * (middle[0] + middle[1]);
}

// Values for vertices that no ray measured.
void fillUnmeasured(const Mesh& mesh, const Adjacency& adjacency, ShapeDiameter& result)
{
  std::vector<int> open;
  double sum = 0.0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (result.measured[v])
      sum += result.diameter[v];
    else
      open.push_back(v);
  }
  if (open.empty())
  {
    return;
  }
  const std::size_t measured = result.measured.size() - open.size();
  std::vector<char> known = result.measured;
  std::vector<int> rest, filled;
  for (bool grown = true; grown && !open.empty();)
  {
    rest.clear();
    filled.clear();
    for (const int v : open)
    {
      double neighbours = 0.0;
      int count = 0;
      for (const int n : adjacency.vertexVertices[v])
      {
        if (known[n])
        {
          neighbours += result.diameter[n];
          ++count;
        }
      }
      if (count > 0)
      {
        result.diameter[v] = neighbours / count;
        filled.push_back(v);
      }
      else
      {
        rest.push_back(v);
      }
    }
    // Only now: a ring is filled from the ring before, whatever the order of its vertices.
    for (const int v : filled)
    {
      known[v] = 1;
    }
    grown = !filled.empty();
    open.swap(rest);
  }
  const double fallback = measured > 0 ? sum / static_cast<double>(measured) : boundingDiagonal(mesh);
  for (const int v : open)
  {
    result.diameter[v] = fallback;
  }
}

// The rays of all vertices that have a normal and are not known: what is the same for each, and the work on a
// part of them.
class VertexRays
{
public:
  VertexRays(const Mesh& mesh,
    const RayScene& scene,
    const std::vector<Vector3>& normals,
    const std::vector<Vector3>& sides,
    const ShapeDiameterOptions& options,
    const TakenOver& known)
    : Model(mesh)
    , Scene(scene)
    , Normals(normals)
    , Sides(sides)
    , Cone(coneDirections(options.rayCount, options.coneAngle))
    , Weights(options.rayCount, 1.0)
    , Known(known)
  {
    for (int k = 0; options.inverseAngleWeights && k < options.rayCount; ++k)
    {
      this->Weights[k] = 1.0 / std::acos(this->Cone[k][2]);
    }
    // Rays traced together then visit the same nodes.
    std::copy_if(scene.order.begin(),
      scene.order.end(),
      std::back_inserter(this->Vertices),
      [&](int v) { return !known.kept[v] && normals[v].squaredNorm() > 0.0; });
    this->Starts.resize(this->Vertices.size());
  }

  // Only where they save more than they cost.
  void findStarts(const Context& context)
  {
    if (this->Vertices.size() > this->Scene.points.size() / fewCones)
    {
      this->Starts =
        rayStarts(this->Scene, this->Normals, this->Vertices, std::acos(this->Cone.back()[2]), context);
    }
  }

  int vertexCount() const { return static_cast<int>(this->Vertices.size()); }
  int rayCount() const { return static_cast<int>(this->Cone.size()); }

  // Traces and summarises the vertices [first, first + count).
  void measure(int first,
    int count,
    RayCaster& caster,
    const Context& context,
    ConeMeasures& result,
    std::vector<ConeHit>* allHits) const
  {
    const int rays = this->rayCount();
    RayBatch batch =
      conesOf(this->Vertices.data() + first, count, this->Normals, this->Sides, this->Cone, context);
    batch.starts.assign(this->Starts.begin() + first, this->Starts.begin() + first + count);
    this->addBounds(batch);
    std::vector<RayHit> hits;
    caster.cast(batch, hits, context);
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
          const std::size_t next = static_cast<std::size_t>(std::min(i + 1, end - 1)) * rays;
          for (std::size_t ray = next; ray < next + rays; ++ray)
          {
            prefetch(&this->Scene.facets[std::max(hits[ray].triangle, 0)]);
          }
          const int v = batch.vertices[i];
          const Vector3 origin = this->Scene.inScene(this->Model.points[v]);
          const Eigen::Matrix3d frame = frameAround(-this->Normals[v], this->Sides[v]);
          float reach = 0.0f;
          for (int k = 0; k < rays; ++k)
          {
            const RayHit& hit = hits[static_cast<std::size_t>(i) * rays + k];
            lengths[k] = ConeHit();
            reach =
              std::max(reach, hit.triangle >= 0 ? hit.distance : std::numeric_limits<float>::infinity());
            if (hit.triangle >= 0)
            {
              lengths[k] = { refine(this->Scene, hit, origin, frame * this->Cone[k]), hit.triangle };
            }
          }
          if (allHits)
          {
            std::copy(
              lengths.begin(), lengths.end(), allHits->begin() + static_cast<std::ptrdiff_t>(v) * rays);
          }
          const double diameter = summarise(lengths.data(), this->Weights);
          result.measured[v] = diameter >= 0.0;
          result.diameter[v] = std::max(0.0, diameter);
          result.reach[v] = reach;
          const RayLengths packing(reach);
          for (int k = 0; k < rays; ++k)
          {
            result.lengths[static_cast<std::size_t>(v) * rays + k] =
              packing.pack(hits[static_cast<std::size_t>(i) * rays + k]);
          }
        }
      });
  }

private:
  // Adds what is known of the rays of a batch, where something is.
  void addBounds(RayBatch& batch) const
  {
    if (this->Known.bounds.empty())
    {
      return;
    }
    const std::ptrdiff_t rays = this->rayCount();
    batch.bounds.resize(batch.directions.size());
    for (std::size_t i = 0; i < batch.vertices.size(); ++i)
    {
      const int row = this->Known.rows[batch.vertices[i]];
      if (row >= 0)
      {
        std::copy_n(this->Known.bounds.begin() + row * rays,
          rays,
          batch.bounds.begin() + static_cast<std::ptrdiff_t>(i) * rays);
      }
    }
  }

  const Mesh& Model;
  const RayScene& Scene;
  const std::vector<Vector3>& Normals;
  const std::vector<Vector3>& Sides;
  std::vector<Vector3> Cone;
  std::vector<double> Weights;
  const TakenOver& Known;
  std::vector<int> Vertices; // along the curve of the scene
  std::vector<float> Starts;
};

void traceAndSummarise(const VertexRays& cones,
  RayCaster& caster,
  const Context& context,
  ConeMeasures& result,
  std::vector<ConeHit>* allHits)
{
  const int total = cones.vertexCount();
  const int blockSize = std::max(1, raysPerBlock / cones.rayCount());
  for (int first = 0; first < total; first += blockSize)
  {
    context.checkpoint(static_cast<double>(first) / total);
    const int count = std::min(blockSize, total - first);
    if (caster.onHost())
    {
      // Each part from its rays to its values at once, while they are in the cache.
      const int parts = (count + verticesPerPart - 1) / verticesPerPart;
      context.eachUntilCancelled(parts,
        [&](int part)
        {
          const int start = part * verticesPerPart;
          cones.measure(
            first + start, std::min(verticesPerPart, count - start), caster, Context(), result, allHits);
        });
    }
    else
    {
      cones.measure(first, count, caster, context, result, allHits);
    }
    context.checkpoint(static_cast<double>(first + count) / total);
  }
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

ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits,
  KnownDiameters* known)
{
  ShapeDiameter result;
  ConeMeasures measures;
  const std::shared_ptr<Device> device = Device::choose(options.backend, result.warning);
  const RayScene scene(mesh, context);
  std::vector<Vector3> sides = options.turnCones
                                 ? coneSides(mesh, scene, adjacency.vertexTriangles, normals, context)
                                 : std::vector<Vector3>(mesh.points.size(), Vector3::Zero());
  const auto measure = [&](Backend used, const MakeCaster& makeCaster)
  {
    measures = { std::vector<double>(mesh.points.size(), 0.0),
      std::vector<char>(mesh.points.size(), 0),
      std::vector<float>(mesh.points.size(), 0.0f),
      std::vector<std::uint8_t>(mesh.points.size() * static_cast<std::size_t>(options.rayCount), 0) };
    TakenOver taken{ std::vector<char>(mesh.points.size(), 0), {}, {} };
    if (hits)
    {
      hits->assign(mesh.points.size() * static_cast<std::size_t>(options.rayCount), ConeHit());
    }
    else if (known && known->filled && known->used == used && known->options == options &&
             RayFrame(*known->mesh) == scene.frame)
    {
      taken = takeOver(*known, mesh, scene, normals, sides, makeCaster, context, measures);
    }
    VertexRays cones(mesh, scene, normals, sides, options, taken);
    if (cones.vertexCount() > 0)
    {
      const std::unique_ptr<RayCaster> caster = makeCaster(scene);
      if (caster->onHost())
      {
        cones.findStarts(context);
      }
      traceAndSummarise(cones, *caster, context, measures, hits);
    }
    result.used = used;
    result.raysCast = static_cast<long long>(cones.vertexCount()) * options.rayCount;
    result.raysTraced =
      result.raysCast +
      static_cast<long long>(std::count(taken.kept.begin(), taken.kept.end(), 1)) * options.rayCount;
  };
  bool done = mesh.triangles.empty();
  if (device && !done)
  {
    try
    {
      measure(Backend::OpenCL, [&](const RayScene& rays) { return makeOpenCLCaster(rays, device, context); });
      done = true;
    }
    catch (const Error& error)
    {
      if (error.failure() != Failure::NoDevice)
      {
        throw;
      }
      result.warning = { "%1 The host computes instead.", error.message() };
    }
  }
  if (!done)
  {
    measure(Backend::Host, [](const RayScene& rays) { return makeEmbreeCaster(rays); });
  }
  measures.diameter.resize(mesh.points.size(), 0.0);
  measures.measured.resize(mesh.points.size(), 0);
  result.diameter = measures.diameter;
  result.measured = measures.measured;
  fillUnmeasured(mesh, adjacency, result);
  if (known)
  {
    known->filled = false; // if memory runs out here
    const bool meshKept = known->nextMesh.get() == &mesh, normalsKept = known->nextNormals.get() == &normals;
    known->mesh = meshKept ? known->nextMesh : std::make_shared<const Mesh>(mesh);
    known->normals = normalsKept ? known->nextNormals : std::make_shared<const std::vector<Vector3>>(normals);
    known->nextMesh = nullptr;
    known->nextNormals = nullptr;
    known->sides = std::move(sides);
    known->options = options;
    known->used = result.used;
    known->measures = std::move(measures);
    known->filled = !mesh.triangles.empty();
  }
  return result;
}

} // namespace oversketch
