#include "Ray/mesh_match.h"

#include <array>
#include <cstdint>
#include <cstring>

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
      this->value_ = (this->value_ ^ x) * 0x9e3779b97f4a7c15u;
      this->value_ ^= this->value_ >> 32;
    }
  }
  std::uint32_t value() const { return static_cast<std::uint32_t>(this->value_); }

private:
  std::uint64_t value_ = 0;
};

bool same(const Vector3& a, const Vector3& b)
{
  return bitsOf(a) == bitsOf(b);
}

// Per item now the first one before that is equal to it, or -1; and which ones before are not the first of
// their kind.
struct Pairs
{
  std::vector<int> found;
  std::vector<char> repeated;
};

template <typename HashOf, typename Equal>
Pairs match(int before, int now, const HashOf& hash, const Equal& equal, const Context& context)
{
  std::vector<std::uint32_t> hashes[2] = { std::vector<std::uint32_t>(before),
    std::vector<std::uint32_t>(now) };
  for (int side = 0; side < 2; ++side)
  {
    context.parallelFor(static_cast<int>(hashes[side].size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          hashes[side][i] = hash(side, i);
        }
      });
  }
  // Open addressing, at most half full.
  std::uint32_t mask = 1;
  while (mask < 2 * static_cast<std::uint32_t>(before))
  {
    mask *= 2;
  }
  std::vector<int> table(mask--, -1);
  // Where an equal item stands, or where the search ended.
  const auto place = [&](int side, int i)
  {
    std::uint32_t at = hashes[side][i] & mask;
    while (table[at] >= 0 && !(hashes[0][table[at]] == hashes[side][i] && equal(table[at], side, i)))
    {
      at = (at + 1) & mask;
    }
    return at;
  };
  Pairs pairs{ std::vector<int>(now, -1), std::vector<char>(before, 0) };
  for (int i = 0; i < before; ++i)
  {
    int& entry = table[place(0, i)];
    pairs.repeated[i] = entry >= 0;
    entry = entry >= 0 ? entry : i;
  }
  context.parallelFor(now,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        pairs.found[i] = table[place(1, i)];
      }
    });
  return pairs;
}

} // namespace

MeshMatch matchMeshes(const Mesh& before,
  const std::vector<Vector3>& normalsBefore,
  const Mesh& now,
  const std::vector<Vector3>& normalsNow,
  const Context& context)
{
  const Mesh* meshes[2] = { &before, &now };
  const std::vector<Vector3>* normals[2] = { &normalsBefore, &normalsNow };
  MeshMatch result;
  result.vertices = match(
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
    context)
                      .found;
  const Pairs facets = match(
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
  std::vector<char> stays = facets.repeated;
  for (int t = 0; t < now.triangleCount(); ++t)
  {
    if (facets.found[t] < 0)
      result.added.push_back(t);
    else
      stays[facets.found[t]] = 1;
  }
  for (int t = 0; t < before.triangleCount(); ++t)
  {
    if (!stays[t])
    {
      result.removed.push_back(t);
    }
  }
  return result;
}

} // namespace oversketch
