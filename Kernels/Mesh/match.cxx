#include "Mesh/match.h"

#include "Mesh/context.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <utility>

namespace oversketch
{

namespace
{

using Bits = std::array<std::uint64_t, 3>;

// 0 and -0 differ.
Bits bitsOf(const Vector3& v)
{
  Bits bits;
  std::memcpy(bits.data(), v.data(), sizeof bits);
  return bits;
}

class Hash
{
public:
  void add(const Vector3& v)
  {
    for (const std::uint64_t x : bitsOf(v))
    {
      this->Value = (this->Value ^ x) * 0x9e3779b97f4a7c15u;
      this->Value ^= this->Value >> 32;
    }
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(this->Value); }

private:
  std::uint64_t Value = 0;
};

bool same(const Vector3& a, const Vector3& b)
{
  return bitsOf(a) == bitsOf(b);
}

// Per item now an equal one before, or -1; and which ones before are equal to none now.
struct Pairs
{
  std::vector<int> found;
  std::vector<char> gone;
};

// Most of a mesh keeps its order: each item is sought behind the one found last. What has taken the place of
// others is as long as they were; where some were left out, those that follow come a little later. Ends where
// more than `most` items now have none.
template <typename Equal>
Pairs matchInOrder(int before, int now, int most, const Equal& equal)
{
  constexpr int window = 64;
  Pairs pairs{ std::vector<int>(now, -1), std::vector<char>(before, 1) };
  int next = 0, missed = 0, lost = 0;
  for (int i = 0; i < now && next < before && lost <= most; ++i)
  {
    int at = next;
    if (!equal(at, i))
    {
      at = next + missed;
      if (at >= before || !equal(at, i))
      {
        ++missed;
        at = before;
        if ((missed & (missed - 1)) == 0) // now and then only, so that all searches together stay short
        {
          const int end = static_cast<int>(std::min<long>(before, next + static_cast<long>(window) * missed));
          for (at = next; at < end && !equal(at, i); ++at)
          {
          }
          at = at < end ? at : before;
        }
      }
    }
    if (at < before)
    {
      pairs.found[i] = at;
      pairs.gone[at] = 0;
      next = at + 1;
      missed = 0;
    }
    lost += at < before ? 0 : 1;
  }
  return pairs;
}

// hash(side, i): of item i before (side 0) or now (side 1); equal(a, side, b): whether item a before is item
// b of the side.
template <typename HashOf, typename Equal>
Pairs match(int before, int now, const HashOf& hash, const Equal& equal, const Context& context)
{
  Pairs pairs = matchInOrder(before, now, now, [&](int a, int b) { return equal(a, 1, b); });
  // The others by their hashes.
  std::vector<int> rest[2] = { marked(pairs.gone), {} };
  for (int i = 0; i < now; ++i)
  {
    if (pairs.found[i] < 0)
    {
      rest[1].push_back(i);
    }
  }
  std::vector<std::uint32_t> hashes[2];
  for (int side = 0; side < 2; ++side)
  {
    hashes[side].resize(rest[side].size());
    context.each(
      static_cast<int>(rest[side].size()), [&](int i) { hashes[side][i] = hash(side, rest[side][i]); });
  }
  // Open addressing, at most half full.
  std::uint32_t mask = 1;
  while (mask < 2 * static_cast<std::uint32_t>(rest[0].size()))
  {
    mask *= 2;
  }
  std::vector<int> table(mask--, -1);
  // Where an equal item stands, or where the search ended.
  const auto place = [&](int side, int i)
  {
    std::uint32_t at = hashes[side][i] & mask;
    while (table[at] >= 0 &&
           !(hashes[0][table[at]] == hashes[side][i] && equal(rest[0][table[at]], side, rest[side][i])))
    {
      at = (at + 1) & mask;
    }
    return at;
  };
  const int unfound = static_cast<int>(rest[0].size());
  for (int i = 0; i < unfound; ++i)
  {
    int& entry = table[place(0, i)];
    pairs.gone[rest[0][i]] = entry < 0; // equal ones once
    entry = entry < 0 ? i : entry;
  }
  context.each(static_cast<int>(rest[1].size()),
    [&](int i)
    {
      const int entry = table[place(1, i)];
      pairs.found[rest[1][i]] = entry < 0 ? -1 : rest[0][entry];
    });
  for (const int i : rest[1])
  {
    if (pairs.found[i] >= 0)
    {
      pairs.gone[pairs.found[i]] = 0;
    }
  }
  return pairs;
}

} // namespace

bool matchTriangles(const Mesh& before, const Mesh& now, std::vector<int>& numbers, std::vector<int>& others)
{
  const int count = before.triangleCount(), last = now.triangleCount();
  numbers.clear();
  others.clear();
  if (8 * (last - count) > last || 8 * (count - last) > count) // other bodies
  {
    return false;
  }
  const Pairs pairs = matchInOrder(count,
    last,
    last / 8,
    [&](int i, int j)
    {
      const Triangle &a = before.triangles[i], &b = now.triangles[j];
      return before.points[a[0]] == now.points[b[0]] && before.points[a[1]] == now.points[b[1]] &&
             before.points[a[2]] == now.points[b[2]];
    });
  numbers.assign(before.triangles.size(), -1);
  for (int j = 0; j < last; ++j)
  {
    pairs.found[j] >= 0 ? void(numbers[pairs.found[j]] = j) : others.push_back(j);
  }
  const auto gone = static_cast<int>(std::count(pairs.gone.begin(), pairs.gone.end(), 1));
  const bool alike = 8 * static_cast<int>(others.size()) <= last && 8 * gone <= count;
  if (!alike)
  {
    numbers.clear();
    others.clear();
  }
  return alike;
}

bool normalsAfter(const Mesh& before,
  const std::vector<Vector3>& normals,
  const Mesh& now,
  const Lists& around,
  std::vector<Vector3>& result)
{
  std::vector<int> numbers, others;
  if (!matchTriangles(before, now, numbers, others))
  {
    return false;
  }
  // A vertex stays where all of its triangles do, and with it no other.
  std::vector<int> from(now.points.size(), -1), to(before.points.size(), -1);
  std::vector<char> changed(now.points.size(), 0), gone(before.points.size(), 0);
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int v = before.triangles[i][k];
      if (numbers[i] < 0)
      {
        gone[v] = 1;
        continue;
      }
      const int w = now.triangles[numbers[i]][k];
      if ((from[w] >= 0 && from[w] != v) || (to[v] >= 0 && to[v] != w))
      {
        changed[w] = 1;
        gone[v] = 1;
      }
      from[w] = v;
      to[v] = w;
    }
  }
  for (const int t : others)
  {
    for (const int w : now.triangles[t])
    {
      changed[w] = 1;
    }
  }
  result.resize(now.points.size());
  for (int w = 0; w < now.vertexCount(); ++w)
  {
    const int v = from[w];
    result[w] = v >= 0 && !changed[w] && !gone[v] ? normals[v] : vertexNormal(now, around, w);
  }
  return true;
}

MeshMatch matchMeshes(const Mesh& before,
  const std::vector<Vector3>& normalsBefore,
  const Mesh& now,
  const std::vector<Vector3>& normalsNow,
  const Context& context)
{
  const Mesh* meshes[2] = { &before, &now };
  const std::vector<Vector3>* normals[2] = { &normalsBefore, &normalsNow };
  const auto matchVertices = [&]
  {
    return match(
      before.vertexCount(),
      now.vertexCount(),
      [&](int side, int v)
      {
        Hash hash;
        hash.add(meshes[side]->points[v]);
        hash.add((*normals[side])[v]);
        return hash.value();
      },
      [&](int a, int side, int b) {
        return same(before.points[a], meshes[side]->points[b]) && same(normalsBefore[a], (*normals[side])[b]);
      },
      context);
  };
  const auto matchFacets = [&]
  {
    return match(
      before.triangleCount(),
      now.triangleCount(),
      [&](int side, int t)
      {
        Hash hash;
        for (const int v : meshes[side]->triangles[t])
        {
          hash.add(meshes[side]->points[v]);
        }
        return hash.value();
      },
      [&](int a, int side, int b)
      {
        const Triangle &s = before.triangles[a], &t = meshes[side]->triangles[b];
        const std::vector<Vector3>& points = meshes[side]->points;
        return same(before.points[s[0]], points[t[0]]) && same(before.points[s[1]], points[t[1]]) &&
               same(before.points[s[2]], points[t[2]]);
      },
      context);
  };
  Pairs vertices, facets;
  context.each(
    2, [&](int which) { (which == 0 ? vertices : facets) = which == 0 ? matchVertices() : matchFacets(); });
  MeshMatch result;
  result.vertices = std::move(vertices.found);
  for (int t = 0; t < now.triangleCount(); ++t)
  {
    if (facets.found[t] < 0)
    {
      result.added.push_back(t);
    }
  }
  result.removed = marked(facets.gone);
  return result;
}

} // namespace oversketch
