#include "Relax/relax.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double pi = 3.14159265358979323846;

// A curve has its whole effect within its radius, and fades to nothing at its reach. Numbers from here on are
// in terms of that.
constexpr double reach = 1.25, wholeWithin = 1.0 / reach;
// The surface is relaxed further out, to know what the rim goes on as. There each point counts for many: the
// shape is held, and its noise comes to nothing in the mean. Within, a point counts for little, since what
// rises there is to go.
constexpr double solvedWithin = 2.0, weightBeyond = 300.0, weightWithin = 0.2;

// Properties of the surface at a curve's points.
struct Ground
{
  double radius;
  std::vector<Vector3> normals;            // means over a radius each way; empty: either side will do
  std::vector<double> scales, thicknesses; // likewise
};

// Means of a curve's values over a window of arc length to either side of each point.
template <typename Value>
std::vector<Value> averaged(const FeatureCurve& curve, const std::vector<Value>& values, double window)
{
  std::vector<Value> result(values);
  const int count = static_cast<int>(values.size());
  int first = 0, last = 0; // of the window, the second exclusive
  Value sum = values[0] - values[0];
  for (int i = 0; i < count; ++i)
  {
    for (; last < count && curve.arc[last] <= curve.arc[i] + window; ++last)
    {
      sum += values[last];
    }
    for (; curve.arc[first] < curve.arc[i] - window; ++first)
    {
      sum -= values[first];
    }
    result[i] = sum / static_cast<double>(last - first);
  }
  return result;
}

// The least of a curve's values in such windows.
std::vector<double> leastNear(const FeatureCurve& curve, const std::vector<double>& values, double window)
{
  std::vector<double> result(values);
  const int count = static_cast<int>(values.size());
  for (int i = 0; i < count; ++i)
  {
    for (const int step : { -1, 1 })
    {
      for (int k = i; k >= 0 && k < count && std::abs(curve.arc[k] - curve.arc[i]) <= window; k += step)
      {
        result[i] = std::min(result[i], values[k]);
      }
    }
  }
  return result;
}

Ground groundOf(const FeatureCurve& curve, const RelaxOptions& options)
{
  Ground ground{ reach * curve.radius.value_or(options.radius), {}, {}, {} };
  // A limb that is thinner than the band may not be drawn in from all sides: it keeps the waves that go round
  // it.
  constexpr double shareOfThickness = 0.15;
  std::vector<double> thicknesses(curve.points.size(), ground.radius / shareOfThickness);
  for (std::size_t i = 0; i < curve.room.size(); ++i)
  {
    thicknesses[i] = std::min(thicknesses[i], curve.room[i][0]);
  }
  ground.thicknesses = averaged(curve, leastNear(curve, thicknesses, ground.radius), ground.radius);
  for (const double thickness : ground.thicknesses)
  {
    ground.scales.push_back(shareOfThickness * thickness);
  }
  if (!curve.normals.empty())
  {
    ground.normals = averaged(curve, curve.normals, ground.radius);
    for (Vector3& n : ground.normals)
    {
      n.stableNormalize();
    }
  }
  return ground;
}

// How far a place is from the surface that the curve lies on: that lies no further down or up than aside, but
// for what stands out where it is rough, less in a thin part. 1 where it can only just be of it.
double besideness(const Vector3& offset, const Vector3& normal, double radius, double thickness)
{
  constexpr double steepest = 1.2;
  const double depth = std::abs(offset.dot(normal));
  const double aside = std::sqrt(std::max(0.0, offset.squaredNorm() - depth * depth));
  return depth / (steepest * aside + std::min(0.5 * radius, 0.25 * thickness));
}

// Lot of a vertex by the curve that is nearest in terms of its radius; a scale of 0 where none is near.
struct Hold
{
  double share = 0.0, scale = 0.0;
  double own = 0.0;     // whether it is within the radius and of the curve's own surface, 0 to 1
  double longest = 0.0; // way over the surface from the curve: what is near by a longer one is another part
};

// 1 up to one distance, 0 from another one on.
double fading(double distance, double from, double to)
{
  const double t = std::clamp((to - distance) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

// The effect of a curve at a point, by all of its places: where another place becomes the nearest, with
// another pressure, it does not leap.
double effectAt(const Vector3& point, const CurveSearch& search, int number, double radius, bool usePressure)
{
  const FeatureCurve& curve = search.curves()[number];
  Eigen::AlignedBox3d box(point);
  box.extend(point + Vector3::Constant(radius)).extend(point - Vector3::Constant(radius));
  double effect = 0.0;
  search.meet(number,
    box,
    [&](int segment)
    {
      const int end = curve.segmentEnd(segment);
      const Vector3 offset = point - curve.points[segment], along = curve.points[end] - curve.points[segment];
      const double t = nearestShare(offset, along);
      const bool pressed = usePressure && !curve.pressure.empty();
      const double pressure =
        pressed ? curve.pressure[segment] + t * (curve.pressure[end] - curve.pressure[segment]) : 1.0;
      const double near = fading((offset - t * along).norm() / radius, wholeWithin, 1.0);
      effect = std::max(effect, near * std::clamp(pressure, 0.0, 1.0));
      return false;
    });
  return effect;
}

Hold holdAt(const Vector3& point,
  const CurveSearch& search,
  const std::vector<Ground>& grounds,
  const RelaxOptions& options)
{
  Hold hold;
  double nearest = solvedWithin;
  for (std::size_t c = 0; c < grounds.size(); ++c)
  {
    const Ground& ground = grounds[c];
    const int number = static_cast<int>(c);
    if (search.box(number).exteriorDistance(point) >= solvedWithin * ground.radius)
    {
      continue;
    }
    const NearestOnCurve on = search.nearest(number, point, solvedWithin * ground.radius);
    if (on.segment < 0)
    {
      continue;
    }
    const FeatureCurve& curve = search.curves()[c];
    const auto [from, t] = curve.at(on.parameter);
    const int to = curve.segmentEnd(from);
    const auto between = [share = t](double a, double b) { return a + share * (b - a); };
    const Vector3 offset = point - on.point;
    const double off =
      ground.normals.empty()
        ? 0.0
        : besideness(offset,
            (ground.normals[from] + t * (ground.normals[to] - ground.normals[from])).stableNormalized(),
            ground.radius,
            between(ground.thicknesses[from], ground.thicknesses[to]));
    if (off > 1.0)
    {
      continue;
    }
    const double beside = fading(off, 0.5, 0.8);
    hold.share = std::max(hold.share,
      options.strength * beside * effectAt(point, search, number, ground.radius, options.usePressure));
    if (on.distance < nearest * ground.radius)
    {
      nearest = on.distance / ground.radius;
      hold.scale = between(ground.scales[from], ground.scales[to]);
      hold.own = beside * fading(nearest, 1.0, 1.2);
      hold.longest = 1.5 * on.distance + 0.5 * ground.radius;
    }
  }
  return hold;
}

// The vertices of the part that must stay where they are.
std::vector<char> heldVertices(const MeshPart& part, double featureAngle)
{
  std::vector<char> held = part.adjacency.borderVertex;
  const double straight = std::cos(featureAngle * pi / 180.0);
  for (int e = 0; e < static_cast<int>(part.adjacency.edges.size()); ++e)
  {
    const MeshEdge& edge = part.adjacency.edges[e];
    const int* sides = part.adjacency.trianglesBegin(e);
    const bool bends = featureAngle < 180.0 && edge.triangleCount == 2 &&
                       facetNormal(part.mesh, sides[0]).dot(facetNormal(part.mesh, sides[1])) < straight;
    if (bends || edge.triangleCount > 2)
    {
      held[edge.v0] = held[edge.v1] = 1;
    }
  }
  return held;
}

// The chosen vertices that hang together with the seeds.
std::vector<char> connected(const MeshPart& part, const std::vector<int>& seeds)
{
  std::vector<char> reached(part.vertices.size(), 0);
  std::vector<int> front;
  const auto take = [&](int v)
  {
    if (part.region[v] && !reached[v])
    {
      reached[v] = 1;
      front.push_back(v);
    }
  };
  std::for_each(seeds.begin(), seeds.end(), take);
  for (std::size_t i = 0; i < front.size(); ++i)
  {
    const Lists::Range around = part.adjacency.vertexVertices[front[i]];
    std::for_each(around.begin(), around.end(), take);
  }
  return reached;
}

} // namespace

RelaxBand relaxBand(const Mesh& mesh,
  const FeatureCurves& curves,
  const RelaxOptions& options,
  const Context& context)
{
  checkCurves(curves);
  checkRadius(curves, options.radius);
  const CurveSearch search(curves);
  std::vector<Ground> grounds;
  double widest = 0.0;
  std::vector<char> isSeed(mesh.points.size(), 0);
  for (const FeatureCurve& curve : curves)
  {
    if (curve.cells.empty())
    {
      throw Error(
        Failure::BadStroke, "A curve does not say which triangles it lies in; draw the stroke again.");
    }
    grounds.push_back(groundOf(curve, options));
    widest = std::max(widest, grounds.back().radius);
    for (const int cell : curve.cells)
    {
      for (const int v : mesh.triangles[cell])
      {
        isSeed[v] = 1;
      }
    }
  }
  std::vector<Hold> holds(mesh.points.size());
  std::vector<char> near(mesh.points.size());
  context.each(mesh.vertexCount(),
    [&](int v)
    {
      holds[v] = holdAt(mesh.points[v], search, grounds, options);
      near[v] = holds[v].scale > 0.0;
    });
  context.checkpoint(0.1);
  RelaxBand band{ MeshPart(mesh, near, context), {}, {}, {} };
  MeshPart& part = band.part;
  for (const int v : part.vertices)
  {
    band.share.push_back(holds[v].share);
    band.scale.push_back(holds[v].scale);
  }
  std::vector<int> seeds;
  for (int v = 0; v < part.mesh.vertexCount(); ++v)
  {
    if (isSeed[part.vertices[v]])
    {
      seeds.push_back(v);
    }
  }
  const std::vector<double> ways =
    edgeDistances(part.mesh, part.adjacency, seeds, (1.5 * solvedWithin + 0.5) * widest);
  for (std::size_t v = 0; v < part.region.size(); ++v)
  {
    const Hold& hold = holds[part.vertices[v]];
    part.region[v] = part.region[v] && ways[v] <= hold.longest;
    const double straight = part.region[v] ? fading(ways[v] / hold.longest, 0.8, 1.0) : 0.0;
    band.share[v] *= straight;
    band.weight.push_back(weightBeyond + (weightWithin - weightBeyond) * straight * hold.own);
  }
  part.region = connected(part, seeds);
  // A spike that stands out too far is held by nothing but the band.
  const std::vector<char> reached = part.region;
  for (int v = 0; v < part.mesh.vertexCount(); ++v)
  {
    const Lists::Range around = part.adjacency.vertexVertices[v];
    if (!reached[v] && around.begin() != around.end() &&
        std::all_of(around.begin(), around.end(), [&](int n) { return reached[n]; }))
    {
      part.region[v] = 1;
      for (const int n : around)
      {
        band.share[v] = std::max(band.share[v], band.share[n]);
        band.scale[v] = std::max(band.scale[v], band.scale[n]);
        band.weight[v] = std::min(band.weight[v], band.weight[n]);
      }
    }
  }
  const std::vector<char> held = heldVertices(part, options.featureAngle);
  const std::vector<double> mask = valuesAt(options.mask, part.vertices);
  for (std::size_t v = 0; v < held.size(); ++v)
  {
    const double free = mask.empty() ? 1.0 : 1.0 - mask[v];
    part.region[v] = part.region[v] && !held[v] && free > 0.0;
    band.share[v] = part.region[v] ? free * band.share[v] : 0.0;
  }
  return band;
}

} // namespace oversketch
