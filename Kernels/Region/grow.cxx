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

// The connected pieces of the vertices with label `which`, each as ascending ids, in the order of their
// lowest vertex.
std::vector<std::vector<int>> piecesOf(const Adjacency& adjacency, const std::vector<char>& label, char which)
{
  std::vector<std::vector<int>> pieces;
  std::vector<char> seen(label.size(), 0);
  for (std::size_t start = 0; start < label.size(); ++start)
  {
    if (seen[start] || label[start] != which)
    {
      continue;
    }
    std::vector<int> piece{ int(start) };
    seen[start] = 1;
    for (std::size_t i = 0; i < piece.size(); ++i)
    {
      for (const int* n = adjacency.vertexVertices.begin(piece[i]);
           n != adjacency.vertexVertices.end(piece[i]);
           ++n)
      {
        if (!seen[*n] && label[*n] == which)
        {
          seen[*n] = 1;
          piece.push_back(*n);
        }
      }
    }
    std::sort(piece.begin(), piece.end());
    pieces.push_back(std::move(piece));
  }
  return pieces;
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

void fillIslands(const Mesh& mesh, const Adjacency& adjacency, std::vector<char>& region)
{
  const std::vector<double> areas = vertexAreas(mesh);
  // Separate parts of a mesh each keep their own largest rest: an eyeball far from the stroke is no island.
  std::vector<int> part(region.size(), -1);
  const std::vector<std::vector<int>> parts = piecesOf(adjacency, std::vector<char>(region.size(), 0), 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (int v : parts[p])
    {
      part[v] = int(p);
    }
  }
  const std::vector<std::vector<int>> rests = piecesOf(adjacency, region, 0);
  std::vector<double> area(rests.size(), 0.0);
  std::vector<int> largest(parts.size(), -1);
  for (std::size_t r = 0; r < rests.size(); ++r)
  {
    for (int v : rests[r])
    {
      area[r] += areas[v];
    }
    int& champion = largest[part[rests[r][0]]];
    if (champion < 0 || area[r] > area[champion])
    {
      champion = int(r);
    }
  }
  for (std::size_t r = 0; r < rests.size(); ++r)
  {
    if (largest[part[rests[r][0]]] != int(r))
    {
      for (int v : rests[r])
      {
        region[v] = 1;
      }
    }
  }
}

void dropSeedless(const Adjacency& adjacency, const std::vector<char>& isSeed, std::vector<char>& region)
{
  for (const std::vector<int>& piece : piecesOf(adjacency, region, 1))
  {
    if (std::none_of(piece.begin(), piece.end(), [&](int v) { return isSeed[v] != 0; }))
    {
      for (int v : piece)
      {
        region[v] = 0;
      }
    }
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
  std::vector<std::vector<int>> parts = piecesOf(adjacency, std::vector<char>(mesh.points.size(), 0), 0);
  parts.erase(std::remove_if(parts.begin(),
                parts.end(),
                [&](const std::vector<int>& part)
                { return std::none_of(part.begin(), part.end(), [&](int v) { return isSeed[v] != 0; }); }),
    parts.end());
  const std::vector<double> areas = vertexAreas(mesh);
  const auto runsAway = [&](const std::vector<char>& region)
  {
    double selected = 0.0, all = 0.0;
    for (const std::vector<int>& part : parts)
    {
      for (int v : part)
      {
        all += areas[v];
        selected += region[v] ? areas[v] : 0.0;
      }
    }
    return selected > 0.5 * all;
  };
  const auto grow = [&](const std::vector<char>& allowed)
  {
    std::vector<char> region = growRegion(adjacency, evidence.seeds, evidence.ratio, options.lambda, allowed);
    if (options.fillIslands)
    {
      fillIslands(mesh, adjacency, region);
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
    region = cutBridges(mesh, adjacency, evidence.diameter, isSeed, region);
    Context half = context;
    half.progress = [&context](double done) { context.progress(0.5 + 0.5 * done); };
    std::vector<char> moved =
      cutAtJunction(mesh, adjacency, normals, evidence.diameter, isSeed, region, {}, half);
    if (options.fillIslands)
    {
      fillIslands(mesh, adjacency, moved);
    }
    if (!runsAway(moved))
    {
      region = std::move(moved);
    }
  }
  dropSeedless(adjacency, isSeed, region);
  for (const std::vector<int>& part : parts)
  {
    if (std::all_of(part.begin(), part.end(), [&](int v) { return region[v] != 0; }))
    {
      throw Error(Failure::BadRegion,
        "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold it; "
        "draw a "
        "shorter stroke, or one on a part that differs more in thickness from the rest.");
    }
  }
  return region;
}

} // namespace oversketch
