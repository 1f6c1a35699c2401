#include "Ray/shape_diameter.h"

#include "Ray/ray_caster.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace oversketch
{

namespace
{

constexpr double pi = 3.14159265358979323846;
constexpr int raysPerBlock =
  1 << 18; // a block's arrays stay in the cache, and a cancel waits for one at most

// Vertices with a usable normal along a space-filling curve, so that rays traced together visit the same
// nodes.
std::vector<int> tracedVertices(const RayScene& scene, const std::vector<Vector3>& normals)
{
  const auto spread = [](std::uint32_t x)
  {
    x = (x | (x << 16)) & 0x030000FFu;
    x = (x | (x << 8)) & 0x0300F00Fu;
    x = (x | (x << 4)) & 0x030C30C3u;
    return (x | (x << 2)) & 0x09249249u;
  };
  std::vector<std::pair<std::uint32_t, int>> keys;
  keys.reserve(normals.size());
  for (int v = 0; v < static_cast<int>(normals.size()); ++v)
  {
    if (normals[v].squaredNorm() > 0.0)
    {
      std::uint32_t key = 0;
      for (int k = 0; k < 3; ++k)
      {
        const float cell = 512.0f * (scene.points[v][k] + 1.0f);
        key |= spread(static_cast<std::uint32_t>(std::clamp(cell, 0.0f, 1023.0f))) << k;
      }
      keys.emplace_back(key, v);
    }
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> vertices;
  vertices.reserve(keys.size());
  for (const auto& key : keys)
  {
    vertices.push_back(key.second);
  }
  return vertices;
}

// Length of the ray to the plane of the triangle that the caster found, in double precision. The caster's own
// length stands where the ray grazes the plane, or the corners moved more than it when they were rounded.
double refine(const Mesh& mesh,
  const RayScene& scene,
  const RayHit& hit,
  int origin,
  const Vector3& direction)
{
  const double coarse = static_cast<double>(hit.distance) * scene.scale;
  const Triangle& t = mesh.triangles[hit.triangle];
  const Vector3& a = mesh.points[t[0]];
  const Vector3 n = ((mesh.points[t[1]] - a) / scene.scale).cross((mesh.points[t[2]] - a) / scene.scale);
  const double exact = n.dot(a - mesh.points[origin]) / n.dot(direction);
  return std::abs(exact - coarse) <= 1e-3 * coarse ? exact : coarse; // false for NaN as well
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
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        if (known[*n])
        {
          neighbours += result.diameter[*n];
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

void traceAndSummarise(const Mesh& mesh,
  const RayScene& scene,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  RayCaster& caster,
  const Context& context,
  ShapeDiameter& result,
  std::vector<ConeHit>* allHits)
{
  const int rays = options.rayCount;
  const std::vector<Vector3> cone = coneDirections(rays, options.coneAngle);
  std::vector<double> weights(rays, 1.0);
  for (int k = 0; options.inverseAngleWeights && k < rays; ++k)
  {
    weights[k] = 1.0 / std::acos(cone[k][2]);
  }
  const std::vector<int> order = tracedVertices(scene, normals);
  const int total = static_cast<int>(order.size());
  const int blockSize = std::max(1, raysPerBlock / rays);
  RayBatch batch;
  batch.raysPerVertex = rays;
  std::vector<RayHit> hits;
  for (int first = 0; first < total; first += blockSize)
  {
    context.checkpoint(static_cast<double>(first) / total);
    const int count = std::min(blockSize, total - first);
    batch.vertices.assign(order.begin() + first, order.begin() + first + count);
    batch.directions.resize(static_cast<std::size_t>(count) * rays);
    context.parallelFor(count,
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          const Eigen::Matrix3d frame = frameAround(-normals[batch.vertices[i]]);
          for (int k = 0; k < rays; ++k)
          {
            const Eigen::Vector3f d = (frame * cone[k]).cast<float>();
            batch.directions[static_cast<std::size_t>(i) * rays + k] = { d[0], d[1], d[2] };
          }
        }
      });
    caster.cast(batch, hits, context);
    context.checkpoint(static_cast<double>(first + count) / total);
    context.parallelFor(count,
      [&](int begin, int end)
      {
        std::vector<ConeHit> lengths(rays);
        for (int i = begin; i < end; ++i)
        {
          const int v = batch.vertices[i];
          const Eigen::Matrix3d frame = frameAround(-normals[v]);
          for (int k = 0; k < rays; ++k)
          {
            const RayHit& hit = hits[static_cast<std::size_t>(i) * rays + k];
            lengths[k] = ConeHit();
            if (hit.triangle >= 0)
            {
              lengths[k] = { refine(mesh, scene, hit, v, frame * cone[k]), hit.triangle };
            }
          }
          if (allHits)
          {
            std::copy(
              lengths.begin(), lengths.end(), allHits->begin() + static_cast<std::ptrdiff_t>(v) * rays);
          }
          const double diameter = summarise(lengths.data(), weights);
          result.measured[v] = diameter >= 0.0;
          result.diameter[v] = std::max(0.0, diameter);
        }
      });
    result.raysTraced += static_cast<long long>(count) * rays;
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

Eigen::Matrix3d frameAround(const Vector3& axis)
{
  // No plane of symmetry of an upright model holds this direction, so that rounding cannot turn its frames.
  Vector3 reference(0.4169, 0.5411, 0.7303);
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
  const std::size_t rays = weights.size();
  std::vector<double> lengths;
  lengths.reserve(rays);
  double sum = 0.0;
  for (std::size_t k = 0; k < rays; ++k)
  {
    if (hits[k].triangle >= 0)
    {
      lengths.push_back(hits[k].length);
      sum += hits[k].length;
    }
  }
  if (lengths.empty())
  {
    return -1.0;
  }
  const double count = static_cast<double>(lengths.size());
  const double mean = sum / count;
  double squares = 0.0;
  for (const double length : lengths)
  {
    squares += (length - mean) * (length - mean);
  }
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  double median = *middle;
  if (lengths.size() % 2 == 0)
  {
    median = 0.5 * (median + *std::max_element(lengths.begin(), middle));
  }
  // The middle hits are never farther than one deviation, but for rounding.
  const double limit = std::sqrt(squares / count) + 1e-9 * median;
  double weighted = 0.0, weight = 0.0;
  for (std::size_t k = 0; k < rays; ++k)
  {
    if (hits[k].triangle >= 0 && std::abs(hits[k].length - median) <= limit)
    {
      weighted += weights[k] * hits[k].length;
      weight += weights[k];
    }
  }
  return weighted / weight;
}

ShapeDiameter computeShapeDiameter(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const ShapeDiameterOptions& options,
  const Context& context,
  std::vector<ConeHit>* hits)
{
  ShapeDiameter result;
  const auto reset = [&]
  {
    result.diameter.assign(mesh.points.size(), 0.0);
    result.measured.assign(mesh.points.size(), 0);
    result.raysTraced = 0;
    if (hits)
    {
      hits->assign(mesh.points.size() * static_cast<std::size_t>(options.rayCount), ConeHit());
    }
  };
  reset();
  std::string warning;
  const std::shared_ptr<Device> device = Device::choose(options.backend, warning);
  if (!mesh.triangles.empty())
  {
    const RayScene scene(mesh);
    bool done = false;
    if (device)
    {
      try
      {
        const std::unique_ptr<RayCaster> caster = makeOpenCLCaster(scene, device, context);
        traceAndSummarise(mesh, scene, normals, options, *caster, context, result, hits);
        result.used = Backend::OpenCL;
        done = true;
      }
      catch (const Error& error)
      {
        if (error.failure() != Failure::NoDevice)
        {
          throw;
        }
        warning = std::string(error.what()) + " The host computes instead.";
        reset();
      }
    }
    if (!done)
    {
      const std::unique_ptr<RayCaster> caster = makeEmbreeCaster(scene);
      traceAndSummarise(mesh, scene, normals, options, *caster, context, result, hits);
    }
  }
  result.warning = warning;
  fillUnmeasured(mesh, adjacency, result);
  return result;
}

} // namespace oversketch
