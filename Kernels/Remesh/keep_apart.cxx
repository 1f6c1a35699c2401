#include "Remesh/keep_apart.h"

#include "Mesh/weld.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <set>

namespace oversketch
{
namespace
{

constexpr double leastShare = 1.0 / 16384.0; // of the way to the middle of the neighbours

Vector3 stored(const Vector3& p, bool asFloats)
{
  Vector3 result = p;
  for (int k = 0; asFloats && k < 3; ++k)
  {
    const volatile float rounded = static_cast<float>(p[k]); // GCC 12's vectoriser takes both casts for none
    result[k] = rounded;
  }
  return result;
}

// The vertices that movable ones may have met, the least movable ones first.
std::vector<int> mayHaveMet(const Mesh& mesh, const std::vector<char>& movable, bool asFloats)
{
  Vector3 low = Vector3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (movable[v])
    {
      low = low.cwiseMin(stored(mesh.points[v], asFloats));
      high = high.cwiseMax(stored(mesh.points[v], asFloats));
    }
  }
  std::vector<int> found;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    const Vector3 p = stored(mesh.points[v], asFloats);
    if ((p.array() >= low.array()).all() && (p.array() <= high.array()).all())
    {
      found.push_back(v);
    }
  }
  std::stable_sort(found.begin(), found.end(), [&](int v, int w) { return movable[v] < movable[w]; });
  return found;
}

} // namespace

int keepApart(Mesh& mesh, const std::vector<char>& movable, bool asFloats)
{
  const std::vector<int> near = mayHaveMet(mesh, movable, asFloats);
  const auto places = mapped(near, [&](int v) { return stored(mesh.points[v], asFloats); });
  const std::vector<int> welded = weldPoints(places);
  if (welded.empty())
  {
    return 0;
  }
  using Place = std::array<double, 3>;
  const auto placeOf = [](const Vector3& p) { return Place{ p[0] + 0.0, p[1] + 0.0, p[2] + 0.0 }; };
  std::set<Place> taken;
  std::map<int, std::set<int>> neighbours; // of those that lie where another one does
  int next = 0;
  for (std::size_t i = 0; i < near.size(); ++i)
  {
    taken.insert(placeOf(places[i]));
    welded[i] == next ? void(++next) : void(neighbours[near[i]]);
  }
  for (const Triangle& t : mesh.triangles)
  {
    for (const int v : t)
    {
      if (const auto found = neighbours.find(v); found != neighbours.end())
      {
        found->second.insert(t.begin(), t.end());
      }
    }
  }
  int left = 0;
  for (auto& [v, around] : neighbours)
  {
    around.erase(v);
    Vector3 middle = Vector3::Zero();
    for (const int w : around)
    {
      middle += mesh.points[w] / static_cast<double>(around.size());
    }
    const Vector3 from = mesh.points[v];
    bool apart = false;
    for (double share = leastShare; movable[v] && !around.empty() && !apart && share <= 0.5; share *= 2.0)
    {
      const Vector3 there = stored(from + share * (middle - from), asFloats);
      if (there.allFinite() && taken.insert(placeOf(there)).second)
      {
        mesh.points[v] = there;
        apart = true;
      }
    }
    left += apart ? 0 : 1;
  }
  return left;
}

} // namespace oversketch
