#include "Ray/ray_starts.h"

#include "Ray/wide.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace oversketch
{

namespace
{

using Vector3f = Eigen::Vector3f;

constexpr int groupSize = 4;       // vertices that share one walk down the tree
constexpr double edgesAhead = 4.0; // how far a search looks, in mean edges
constexpr float slack = 1e-3f;     // radians, far more than what rounding turns
constexpr float margin = 1e-5f;    // likewise, for lengths
constexpr float huge = 1e9f;
constexpr float widest = 1.55f; // radians; from a right angle on, a cone is none
constexpr float sceneDiagonal = 3.5f;
constexpr float grazing = 1e-3f;

// A set of facets as the search sees it: where it lies and which way its facets face.
struct Cluster
{
  Vector3f low = Vector3f::Constant(huge), high = Vector3f::Constant(-huge);
  Vector3f axis = Vector3f::Zero(); // of a cone that holds all normals
  float angle = 4.0f;               // of the cone, radians
};

// Eight clusters side by side; an absent one lies far away.
struct alignas(sizeof(WideFloat)) Node
{
  WideFloat centre[3], half[3], radius;
  WideFloat axis[3], cosine, sine; // of the cone of normals

  void set(int i, const Cluster& cluster)
  {
    const bool absent = cluster.low[0] > cluster.high[0];
    const Vector3f c = absent ? Vector3f::Constant(huge) : Vector3f(0.5f * (cluster.low + cluster.high));
    const Vector3f h = absent ? Vector3f::Zero() : Vector3f(0.5f * (cluster.high - cluster.low));
    for (int k = 0; k < 3; ++k)
    {
      this->centre[k][i] = c[k];
      this->half[k][i] = h[k];
      this->axis[k][i] = cluster.axis[k];
    }
    this->radius[i] = h.norm();
    const float angle = std::min(cluster.angle, 3.0f);
    this->cosine[i] = std::cos(angle);
    this->sine[i] = std::sin(angle);
  }
};

// The cones of one vertex, or of several.
struct Cones
{
  Vector3f centre, half; // of the box of the vertices
  Vector3f normal;       // the mean
  float radius;          // of the sphere round the box
  // Functions of the angle from the mean normal to the outermost ray, and of the angle that a facet's normal
  // may be away from it so that no ray leaves through the facet.
  float openingCosine, openingSine, limitCosine, limitSine;

  Cones(const Vector3f& low, const Vector3f& high, const Vector3f& n, float opening)
    : centre(0.5f * (low + high))
    , half(0.5f * (high - low))
    , normal(n)
    , radius(this->half.norm())
    , openingCosine(std::cos(opening))
    , openingSine(std::sin(opening))
    , limitCosine(openingSine)
    , limitSine(openingCosine)
  {
  }
};

float angleBetween(const Vector3f& a, const Vector3f& b)
{
  return 2.0f * std::asin(std::min(0.5f * (a - b).norm(), 1.0f)); // exact for small angles, unlike acos
}

// Which clusters of a node lie nearer to the cones' origins than a given distance and may be left through by
// a ray, and how near.
__attribute__((always_inline)) inline void measure(const Node& node,
  const Cones& cones,
  float squaredRadius,
  WideInt& found,
  WideFloat& squared)
{
  WideFloat along = {}, to = {}, depth = {};
  squared = along;
  for (int k = 0; k < 3; ++k)
  {
    const WideFloat offset = node.centre[k] - cones.centre[k];
    const WideFloat gap = (offset < 0.0f ? -offset : offset) - (node.half[k] + cones.half[k]);
    squared += gap > 0.0f ? gap * gap : WideFloat{};
    along += node.axis[k] * cones.normal[k];
    to += offset * offset;
    depth -= offset * cones.normal[k];
  }
  // All normals within the limit: their cone's axis is, and its angle fits into what is left.
  const WideInt facing = (node.cosine >= cones.limitCosine) &
                         (along >= cones.limitCosine * node.cosine + cones.limitSine * node.sine);
  // The sphere round the box lies beside the cone.
  const WideFloat reach = cones.openingSine * depth + (node.radius + cones.radius) * 1.001f + margin;
  const WideInt aside =
    (reach < 0.0f) | (cones.openingCosine * cones.openingCosine * (to - depth * depth) > reach * reach);
  found = (squared < squaredRadius) & ~(facing | aside);
}

bool any(const WideInt& mask)
{
  long long halves[wide / 2];
  std::memcpy(halves, &mask, sizeof mask);
  return (halves[0] | halves[1] | halves[2] | halves[3]) != 0;
}

// Facets in the order of the curve, eight by eight, up to one root: cheaper to build than a tree of quality,
// and good enough for the few nodes that a search visits.
class Clusters
{
public:
  Clusters(const RayScene& scene, const Context& context)
    : Scene(scene)
    , Facets(facetOrder(scene))
  {
    std::vector<Cluster> clusters(Facets.size()), parents;
    context.each(
      static_cast<int>(clusters.size()), [&](int i) { clusters[i] = this->ofFacet(this->Facets[i]); });
    do
    {
      const int count = static_cast<int>(clusters.size() + wide - 1) / wide;
      this->Levels.emplace_back(count);
      std::vector<Node>& nodes = this->Levels.back();
      parents.assign(count, Cluster());
      context.each(count,
        [&](int i)
        {
          const int first = i * wide, last = std::min(first + wide, static_cast<int>(clusters.size()));
          parents[i] = join(clusters.data() + first, clusters.data() + last);
          for (int k = 0; k < wide; ++k)
          {
            nodes[i].set(k, first + k < last ? clusters[first + k] : Cluster());
          }
        });
      clusters.swap(parents);
    } while (clusters.size() > 1);
  }

  // The lowest nodes, of eight facets each, that may matter to a ray of the cones within a distance.
  OVERSKETCH_CLONES void gather(const Cones& cones, float squaredRadius, std::vector<int>& found) const
  {
    found.clear();
    struct Entry
    {
      int level, node;
    };
    Entry stack[12 * wide]; // more levels than facets can have ids
    int top = 0;
    stack[top++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
    while (top > 0)
    {
      const Entry entry = stack[--top];
      if (entry.level == 0)
      {
        found.push_back(entry.node);
        continue;
      }
      WideInt near;
      WideFloat squared;
      measure(this->Levels[entry.level][entry.node], cones, squaredRadius, near, squared);
      for (int i = 0; i < wide && any(near); ++i)
      {
        if (near[i])
        {
          stack[top++] = { entry.level - 1, entry.node * wide + i };
        }
      }
    }
  }

  // Whether any facet within a distance may matter to a ray of the cones.
  OVERSKETCH_CLONES bool meet(const Cones& cones, float squaredRadius) const
  {
    struct Entry
    {
      int level, node;
    };
    Entry stack[12 * wide];
    int top = 0;
    stack[top++] = { static_cast<int>(this->Levels.size()) - 1, 0 };
    while (top > 0)
    {
      const Entry entry = stack[--top];
      WideInt near;
      WideFloat squared;
      measure(this->Levels[entry.level][entry.node], cones, squaredRadius, near, squared);
      const bool found = any(near);
      if (found && entry.level == 0)
      {
        return true;
      }
      for (int i = 0; i < wide && found; ++i)
      {
        if (near[i])
        {
          stack[top++] = { entry.level - 1, entry.node * wide + i };
        }
      }
    }
    return false;
  }

  // The squared distance to the nearest facet of the nodes that matters and does not touch the vertex, at
  // most `best`.
  OVERSKETCH_CLONES float nearest(const Cones& cones,
    int place,
    const std::vector<int>& nodes,
    float best) const
  {
    for (const int node : nodes)
    {
      WideInt near;
      WideFloat squared;
      measure(this->Levels[0][node], cones, best, near, squared);
      for (int i = 0; i < wide && any(near); ++i)
      {
        if (near[i] && squared[i] < best && !this->touches(node * wide + i, place))
        {
          best = squared[i];
        }
      }
    }
    return best;
  }

private:
  bool touches(int i, int place) const
  {
    const std::array<int, 3>& corners = this->Scene.facets[this->Facets[i]].places;
    return corners[0] == place || corners[1] == place || corners[2] == place;
  }

  static std::vector<int> facetOrder(const RayScene& scene)
  {
    std::vector<int> rank(scene.order.size());
    for (int i = 0; i < static_cast<int>(rank.size()); ++i)
    {
      rank[scene.order[i]] = i;
    }
    std::vector<int> starts(rank.size() + 1, 0);
    for (const RayFacet& facet : scene.facets)
    {
      ++starts[rank[facet.places[0]] + 1];
    }
    for (std::size_t i = 1; i < starts.size(); ++i)
    {
      starts[i] += starts[i - 1];
    }
    std::vector<int> order(scene.facets.size());
    for (int i = 0; i < static_cast<int>(order.size()); ++i)
    {
      order[starts[rank[scene.facets[i].places[0]]]++] = i;
    }
    return order;
  }

  Cluster ofFacet(int i) const
  {
    const RayFacet& facet = this->Scene.facets[i];
    Cluster cluster;
    cluster.axis = Vector3f(facet.normal[0], facet.normal[1], facet.normal[2]);
    if (cluster.axis.squaredNorm() > 0.0f) // rays pass through degenerate ones
    {
      for (const int v : facet.places)
      {
        const Vector3f p(this->Scene.points[v].data());
        cluster.low = cluster.low.cwiseMin(p);
        cluster.high = cluster.high.cwiseMax(p);
      }
      cluster.angle = 0.0f;
    }
    return cluster;
  }

  static Cluster join(const Cluster* begin, const Cluster* end)
  {
    Cluster joined;
    for (const Cluster* c = begin; c != end; ++c)
    {
      joined.low = joined.low.cwiseMin(c->low);
      joined.high = joined.high.cwiseMax(c->high);
      joined.axis += c->axis;
    }
    const float length = joined.axis.norm();
    if (length > 0.1f)
    {
      joined.axis /= length;
      joined.angle = 0.0f;
      for (const Cluster* c = begin; c != end; ++c)
      {
        if (c->low[0] < huge)
        {
          joined.angle = std::max(joined.angle, angleBetween(joined.axis, c->axis) + c->angle);
        }
      }
    }
    return joined;
  }

  const RayScene& Scene;
  std::vector<int> Facets;
  std::vector<std::vector<Node>> Levels; // the root last
};

} // namespace

std::vector<float> rayStarts(const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<int>& vertices,
  double opening,
  const Context& context)
{
  std::vector<float> starts(vertices.size(), 0.0f);
  const float outermost = static_cast<float>(opening) + slack;
  if (outermost >= widest || scene.facets.empty())
  {
    return starts;
  }
  const Clusters clusters(scene, context);
  // The crowd at a vertex is a few edges wide; looking farther costs more than it saves.
  double area = 0.0;
  for (const RayFacet& facet : scene.facets)
  {
    area += 0.5 * facet.plane.norm();
  }
  const double squaredEdge = 4.0 / std::sqrt(3.0) * area / static_cast<double>(scene.facets.size());
  const float squaredRadius = static_cast<float>(edgesAhead * edgesAhead * squaredEdge);
  const int groups = static_cast<int>(vertices.size() + groupSize - 1) / groupSize;
  context.parallelFor(groups,
    [&](int firstGroup, int lastGroup)
    {
      std::vector<int> nodes;
      for (int g = firstGroup; g < lastGroup; ++g)
      {
        const int begin = g * groupSize;
        const int end = std::min(begin + groupSize, static_cast<int>(vertices.size()));
        Vector3f low = Vector3f::Constant(huge), high = -low;
        Vector3 sum = Vector3::Zero();
        for (int i = begin; i < end; ++i)
        {
          const Vector3f p(scene.points[vertices[i]].data());
          low = low.cwiseMin(p);
          high = high.cwiseMax(p);
          sum += normals[vertices[i]];
        }
        const Vector3f mean = sum.stableNormalized().cast<float>();
        float spread = 0.0f;
        for (int i = begin; i < end; ++i)
        {
          spread = std::max(spread, angleBetween(mean, normals[vertices[i]].cast<float>()));
        }
        if (outermost + spread >= widest)
        {
          continue;
        }
        clusters.gather(Cones(low, high, mean, outermost + spread), squaredRadius, nodes);
        for (int i = begin; i < end; ++i)
        {
          const int v = vertices[i];
          const Vector3f p(scene.points[v].data());
          const float distance = std::sqrt(clusters.nearest(
            Cones(p, p, normals[v].cast<float>(), outermost), scene.places[v], nodes, squaredRadius));
          starts[i] = std::max(0.0f, distance * (1.0f - margin) - margin);
        }
      }
    });
  return starts;
}

std::vector<char> conesThatMeet(const RayScene& others,
  const RayScene& scene,
  const std::vector<Vector3>& normals,
  const std::vector<int>& vertices,
  const std::vector<float>& reaches,
  double opening,
  const Context& context)
{
  std::vector<char> met(vertices.size(), others.facets.empty() ? 0 : 1);
  const float outermost = static_cast<float>(opening) + slack;
  if (outermost >= widest || others.facets.empty())
  {
    return met;
  }
  const Clusters clusters(others, context);
  context.each(static_cast<int>(vertices.size()),
    [&](int i)
    {
      const int v = vertices[i];
      const Vector3f p(scene.points[v].data());
      // Lengths of rays that graze a facet are rounded far more than points are.
      const float radius = std::min(reaches[i], sceneDiagonal) + grazing;
      met[i] = clusters.meet(Cones(p, p, normals[v].cast<float>(), outermost), radius * radius);
    });
  return met;
}

} // namespace oversketch
