#include "Pose/limb.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace oversketch
{

namespace
{

constexpr int smoothRounds = 4;
constexpr int lookEvery = 65536; // vertices between two looks at the caller

// The limb's cross-section by the plane at the joint.
struct CrossSection
{
  std::vector<double> height;      // of each vertex over the plane, above 0 on the tip's side
  std::vector<char> isCut;         // by edge: whether the cross-section crosses it
  std::vector<int> before, beyond; // ends of these edges on either side
};

CrossSection crossSectionOf(const Mesh& mesh, const Adjacency& adjacency, const Bone& bone)
{
  CrossSection section;
  for (const Vector3& p : mesh.points)
  {
    section.height.push_back(bone.across.dot(p - bone.places.front()));
  }
  const auto isCut = [&](int a, int b) { return (section.height[a] > 0.0) != (section.height[b] > 0.0); };
  section.isCut.assign(adjacency.edges.size(), 0);
  std::vector<char> isReached(mesh.triangles.size(), 0);
  std::vector<int> triangles;
  const auto reach = [&](int t)
  {
    const Triangle& c = mesh.triangles[t];
    if (!isReached[t] && (isCut(c[0], c[1]) || isCut(c[1], c[2])))
    {
      isReached[t] = 1;
      triangles.push_back(t);
    }
  };
  // The ray may have met an edge, and the plane the triangle beside it.
  for (const int met : bone.joint)
  {
    for (const int v : mesh.triangles[met])
    {
      for (const int t : adjacency.vertexTriangles[v])
      {
        reach(t);
      }
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    for (const int e : adjacency.triangleEdges[triangles[i]])
    {
      if (e < 0 || section.isCut[e] || !isCut(adjacency.edges[e].v0, adjacency.edges[e].v1))
      {
        continue;
      }
      section.isCut[e] = 1;
      const MeshEdge& edge = adjacency.edges[e];
      const bool rises = section.height[edge.v1] > 0.0;
      section.before.push_back(rises ? edge.v0 : edge.v1);
      section.beyond.push_back(rises ? edge.v1 : edge.v0);
      for (const int t : adjacency.trianglesAt(e))
      {
        reach(t);
      }
    }
  }
  sortUnique(section.before);
  sortUnique(section.beyond);
  return section;
}

// Marks what the surface joins to the cross-section's far side, over edges that may be crossed.
std::vector<char> flooded(const Adjacency& adjacency,
  const CrossSection& section,
  const std::function<bool(int from, int to)>& mayCross)
{
  std::vector<char> region(section.height.size(), 0);
  std::vector<int> reached = section.beyond;
  for (const int v : reached)
  {
    region[v] = 1;
  }
  for (std::size_t i = 0; i < reached.size(); ++i)
  {
    for (const int n : adjacency.vertexVertices[reached[i]])
    {
      if (!region[n] && mayCross(reached[i], n))
      {
        region[n] = 1;
        reached.push_back(n);
      }
    }
  }
  return region;
}

std::vector<char> regionOf(const Adjacency& adjacency, const CrossSection& section)
{
  const auto isOverPlane = [&](int v) { return section.height[v] > 0.0; };
  std::vector<char> region = flooded(adjacency,
    section,
    [&](int from, int to)
    { return isOverPlane(from) == isOverPlane(to) || !section.isCut[adjacency.findEdge(from, to)]; });
  if (std::any_of(section.before.begin(), section.before.end(), [&](int v) { return region[v] != 0; }))
  {
    region = flooded(adjacency, section, [&](int, int to) { return isOverPlane(to); });
  }
  return region;
}

// The length along the bone of its place nearest to a point, of those within a reach of another one.
double nearestAlong(const Bone& bone, const Vector3& p, double about, double reach)
{
  const int last = static_cast<int>(bone.places.size()) - 1;
  double best = about, square = std::numeric_limits<double>::infinity();
  for (int i = 0; i < last; ++i)
  {
    const double length = bone.along[i + 1] - bone.along[i];
    if (bone.along[i + 1] < about - reach || bone.along[i] > about + reach || !(length > 0.0))
    {
      continue;
    }
    const Vector3 way = bone.places[i + 1] - bone.places[i], offset = p - bone.places[i];
    const double t =
      std::clamp(bone.along[i] + nearestShare(offset, way) * length, about - reach, about + reach);
    const double found = (offset - (t - bone.along[i]) / length * way).squaredNorm();
    if (found < square)
    {
      square = found;
      best = t;
    }
  }
  return best;
}

} // namespace

Limb limbOf(const Mesh& mesh, const Adjacency& adjacency, const Bone& bone, const Context& context)
{
  const CrossSection section = crossSectionOf(mesh, adjacency, bone);
  if (section.beyond.empty())
  {
    throw Error(Failure::BadStroke,
      "Nothing of the model lies on the tip's side of the bone's joint; draw the bone along a limb, from the "
      "joint that stays to the tip.");
  }
  context.checkpoint(0.1);
  const std::vector<char> region = regionOf(adjacency, section);
  context.checkpoint(0.3);

  // Outward from what stays, by the shortest way over edges.
  std::vector<double> way(region.size(), std::numeric_limits<double>::infinity());
  std::vector<double> parameter(region.size(), 0.0), about(region.size(), 0.0);
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const std::vector<int> limb = marked(region);
  for (const int v : limb)
  {
    for (const int n : adjacency.vertexVertices[v])
    {
      const double edge = (mesh.points[v] - mesh.points[n]).norm();
      if (!region[n] && edge < way[v])
      {
        way[v] = edge;
        queue.emplace(edge, v);
      }
    }
  }
  std::vector<char> isDone(region.size(), 0);
  for (int count = 0; !queue.empty();)
  {
    const int v = queue.top().second;
    queue.pop();
    if (isDone[v])
    {
      continue;
    }
    isDone[v] = 1;
    if (++count % lookEvery == 0)
    {
      context.checkpoint(0.3 + 0.6 * count / static_cast<double>(limb.size()));
    }
    // parameter[v] is that of where the way comes from; about[v] the length of its last edge.
    const double edge = about[v] > 0.0 ? about[v] : way[v];
    const double along = nearestAlong(bone, mesh.points[v], parameter[v], 2.0 * edge);
    parameter[v] = along;
    for (const int n : adjacency.vertexVertices[v])
    {
      const double length = (mesh.points[v] - mesh.points[n]).norm();
      if (region[n] && !isDone[n] && way[v] + length < way[n])
      {
        way[n] = way[v] + length;
        parameter[n] = along;
        about[n] = length;
        queue.emplace(way[n], n);
      }
    }
  }
  for (const int v : limb)
  {
    parameter[v] = std::min(parameter[v], way[v]);
  }
  context.checkpoint(0.9);

  // As if the bone went on before the joint, so that what stays beside it does not draw the first points
  // back.
  for (const int v : section.before)
  {
    parameter[v] = std::min(0.0, section.height[v]);
  }
  for (int round = 0; round < smoothRounds; ++round)
  {
    const std::vector<double> before = parameter;
    context.each(static_cast<int>(limb.size()),
      [&](int i)
      {
        const int v = limb[i];
        double sum = 0.0;
        for (const int n : adjacency.vertexVertices[v])
        {
          sum += before[n];
        }
        const int count = adjacency.vertexVertices.size(v);
        parameter[v] =
          std::clamp(count > 0 ? 0.5 * (before[v] + sum / count) : before[v], 0.0, bone.along.back());
      });
  }
  return { limb, valuesAt(parameter, limb) };
}

} // namespace oversketch
