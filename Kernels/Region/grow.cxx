#include "Region/grow.h"

#include "Region/cut.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <utility>

namespace oversketch
{

namespace
{

// The connected pieces of the vertices with label `which`: which piece each vertex belongs to (-1: none), the
// pieces in the order of their lowest vertex.
struct Pieces
{
  std::vector<int> of;
  int count = 0;
};

Pieces piecesOf(const Adjacency& adjacency, const std::vector<char>& label, char which)
{
  Pieces pieces{ std::vector<int>(label.size(), -1), 0 };
  std::vector<int> open;
  for (int start = 0; start < int(label.size()); ++start)
  {
    if (pieces.of[start] >= 0 || label[start] != which)
    {
      continue;
    }
    const int piece = pieces.count++;
    pieces.of[start] = piece;
    open.assign(1, start);
    while (!open.empty())
    {
      const int v = open.back();
      open.pop_back();
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        if (pieces.of[*n] < 0 && label[*n] == which)
        {
          pieces.of[*n] = piece;
          open.push_back(*n);
        }
      }
    }
  }
  return pieces;
}

// Whether the unselected vertices next to the region hang together, by edges between them, in each part.
bool onePieceRing(const MeshParts& parts, const Adjacency& adjacency, const std::vector<char>& region)
{
  std::vector<char> open(region.size(), 0); // in a ring and not yet met
  std::vector<int> ring;
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (region[v])
    {
      for (const int* n = adjacency.vertexVertices.begin(int(v)); n != adjacency.vertexVertices.end(int(v));
           ++n)
      {
        if (!region[*n] && !open[*n])
        {
          open[*n] = 1;
          ring.push_back(*n);
        }
      }
    }
  }
  std::vector<char> met(parts.count, 0);
  std::vector<int> stack;
  for (const int start : ring)
  {
    if (!open[start])
    {
      continue;
    }
    if (met[parts.of[start]])
    {
      return false;
    }
    met[parts.of[start]] = 1;
    open[start] = 0;
    stack.assign(1, start);
    while (!stack.empty())
    {
      const int v = stack.back();
      stack.pop_back();
      for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
      {
        if (open[*n])
        {
          open[*n] = 0;
          stack.push_back(*n);
        }
      }
    }
  }
  return true;
}

} // namespace

std::vector<double> vertexAreas(const Mesh& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (const Triangle& t : mesh.triangles)
  {
    const double area =
      0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm();
    for (int v : t)
    {
      areas[v] += area / 3.0;
    }
  }
  return areas;
}

std::vector<char> growRegion(const Adjacency& adjacency,
  const std::vector<int>& seeds,
  const std::vector<double>& ratio,
  double lambda,
  const std::vector<char>& allowed)
{
  std::vector<char> region(ratio.size(), 0);
  std::deque<int> queue;
  std::vector<char> queued(ratio.size(), 0);
  const auto queueNeighbours = [&](int v)
  {
    for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
    {
      if (!region[*n] && !queued[*n] && (allowed.empty() || allowed[*n]))
      {
        queued[*n] = 1;
        queue.push_back(*n);
      }
    }
  };
  for (int seed : seeds)
  {
    region[seed] = 1;
  }
  for (int seed : seeds)
  {
    queueNeighbours(seed);
  }
  while (!queue.empty())
  {
    const int v = queue.front();
    queue.pop_front();
    queued[v] = 0;
    int selected = 0;
    for (const int* n = adjacency.vertexVertices.begin(v); n != adjacency.vertexVertices.end(v); ++n)
    {
      selected += region[*n];
    }
    const int unselected = adjacency.vertexVertices.size(v) - selected;
    if (ratio[v] > lambda * (unselected - selected))
    {
      region[v] = 1;
      queueNeighbours(v);
    }
  }
  return region;
}

MeshParts findParts(const Mesh& mesh, const Adjacency& adjacency)
{
  Pieces pieces = piecesOf(adjacency, std::vector<char>(mesh.points.size(), 0), 0);
  return { vertexAreas(mesh), std::move(pieces.of), pieces.count };
}

void fillIslands(const MeshParts& parts, const Adjacency& adjacency, std::vector<char>& region)
{
  // Every piece of the rest of a part with a region touches the region: where what touches it is one ring in
  // each part, there are no islands, and the rest itself need not be walked.
  if (onePieceRing(parts, adjacency, region))
  {
    return;
  }
  // Separate parts of a mesh each keep their own largest rest: an eyeball far from the stroke is no island.
  const Pieces rests = piecesOf(adjacency, region, 0);
  std::vector<double> area(rests.count, 0.0);
  std::vector<int> part(rests.count);
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (rests.of[v] >= 0)
    {
      area[rests.of[v]] += parts.areas[v];
      part[rests.of[v]] = parts.of[v];
    }
  }
  std::vector<int> largest(parts.count, -1);
  for (int r = 0; r < rests.count; ++r)
  {
    int& champion = largest[part[r]];
    if (champion < 0 || area[r] > area[champion])
    {
      champion = r;
    }
  }
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (rests.of[v] >= 0 && largest[parts.of[v]] != rests.of[v])
    {
      region[v] = 1;
    }
  }
}

void fillIslands(const Mesh& mesh, const Adjacency& adjacency, std::vector<char>& region)
{
  fillIslands(findParts(mesh, adjacency), adjacency, region);
}

void dropSeedless(const Adjacency& adjacency, const std::vector<char>& isSeed, std::vector<char>& region)
{
  const Pieces pieces = piecesOf(adjacency, region, 1);
  std::vector<char> seeded(pieces.count, 0);
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (pieces.of[v] >= 0 && isSeed[v])
    {
      seeded[pieces.of[v]] = 1;
    }
  }
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    region[v] = region[v] && seeded[pieces.of[v]];
  }
}

std::vector<int> expandSeeds(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& seeds,
  std::size_t needed,
  double tolerance)
{
  std::vector<int> expanded = seeds;
  if (seeds.size() < needed)
  {
    const std::vector<double> distance = edgeDistances(mesh, adjacency, seeds, tolerance);
    std::vector<std::pair<double, int>> near;
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (distance[v] > 0.0 && std::isfinite(distance[v]))
      {
        near.emplace_back(distance[v], v);
      }
    }
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), needed - seeds.size()));
    for (const auto& [d, v] : near)
    {
      expanded.push_back(v);
    }
    std::sort(expanded.begin(), expanded.end());
  }
  return expanded;
}

std::vector<char> detectRegion(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const MeshParts& parts,
  const RegionEvidence& evidence,
  const RegionOptions& options,
  const Context& context)
{
  if (evidence.seeds.empty())
  {
    throw Error(Failure::BadRegion,
      "The section has no vertices to grow a region from; draw a longer stroke or lower SeedMargin.");
  }
  std::vector<char> isSeed(mesh.points.size(), 0);
  for (int seed : evidence.seeds)
  {
    isSeed[seed] = 1;
  }
  // The parts that hold seeds: the region can lie nowhere else.
  std::vector<char> held(parts.count, 0);
  for (int seed : evidence.seeds)
  {
    held[parts.of[seed]] = 1;
  }
  double all = 0.0;
  for (std::size_t v = 0; v < isSeed.size(); ++v)
  {
    all += held[parts.of[v]] ? parts.areas[v] : 0.0;
  }
  const auto runsAway = [&](const std::vector<char>& region)
  {
    double selected = 0.0;
    for (std::size_t v = 0; v < region.size(); ++v)
    {
      selected += region[v] ? parts.areas[v] : 0.0;
    }
    return selected > 0.5 * all;
  };
  const auto grow = [&](const std::vector<char>& allowed)
  {
    std::vector<char> region = growRegion(adjacency, evidence.seeds, evidence.ratio, options.lambda, allowed);
    if (options.fillIslands)
    {
      fillIslands(parts, adjacency, region);
    }
    return region;
  };

  context.checkpoint(0.0);
  std::vector<char> region = grow({});
  if (options.limitRunaway && runsAway(region))
  {
    const std::vector<double> distance =
      edgeDistances(mesh, adjacency, evidence.seeds, evidence.sectionLength);
    std::vector<char> allowed(mesh.points.size());
    std::transform(
      distance.begin(), distance.end(), allowed.begin(), [](double d) { return char(std::isfinite(d)); });
    region = grow(allowed);
  }
  context.checkpoint(0.5);
  if (options.cutAtJunction)
  {
    region = cutBridges(mesh, adjacency, parts, evidence.diameter, isSeed, region);
    Context half = context;
    half.progress = [&context](double done) { context.progress(0.5 + 0.5 * done); };
    std::vector<char> moved =
      cutAtJunction(mesh, adjacency, normals, parts, evidence.diameter, isSeed, region, {}, half);
    if (options.fillIslands)
    {
      fillIslands(parts, adjacency, moved);
    }
    if (!runsAway(moved))
    {
      region = std::move(moved);
    }
  }
  dropSeedless(adjacency, isSeed, region);
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (!region[v])
    {
      held[parts.of[v]] = 0; // something of the part is left
    }
  }
  if (std::any_of(held.begin(), held.end(), [](char whole) { return whole != 0; }))
  {
    throw Error(Failure::BadRegion,
      "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold it; "
      "draw a "
      "shorter stroke, or one on a part that differs more in thickness from the rest.");
  }
  return region;
}

std::vector<char> detectRegion(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const RegionEvidence& evidence,
  const RegionOptions& options,
  const Context& context)
{
  return detectRegion(mesh, adjacency, normals, findParts(mesh, adjacency), evidence, options, context);
}

} // namespace oversketch
