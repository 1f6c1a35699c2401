#include "Region/grow.h"

#include "Region/border.h"
#include "Region/cut.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <utility>

namespace oversketch
{

namespace
{

// How many vertices are asked for at a time, where they are not known: enough for all threads.
constexpr std::size_t askedAhead = 2048;

// Growing from the seeds; see detectRegion.
class Growth
{
public:
  // Where `allowed` is not empty, vertices with 0 there are never selected (but seeds are).
  Growth(const Adjacency& adjacency, const RegionEvidence& evidence, const std::vector<char>& allowed)
    : Neighbours(adjacency.vertexVertices)
    , Evidence(evidence)
    , Allowed(allowed)
    , Region(evidence.ratio.size(), 0)
    , Queued(evidence.ratio.size(), 0)
  {
    for (const int seed : evidence.seeds)
    {
      this->Region[seed] = 1;
    }
    for (const int seed : evidence.seeds)
    {
      this->queueNeighbours(seed);
    }
  }

  // The region, or a part of it of more than this area.
  std::vector<char> run(double lambda, const std::vector<double>& areas, double mostArea)
  {
    double area = 0.0;
    while (!this->Queue.empty() && area <= mostArea)
    {
      const int v = this->Queue.front();
      if (std::isnan(this->Evidence.ratio[v]))
      {
        this->ask();
      }
      this->Queue.pop_front();
      this->Queued[v] = 0;
      int selected = 0;
      for (const int n : this->Neighbours[v])
      {
        selected += this->Region[n];
      }
      const int unselected = this->Neighbours.size(v) - selected;
      if (this->Evidence.ratio[v] > lambda * (unselected - selected))
      {
        this->Region[v] = 1;
        area += areas[v];
        this->queueNeighbours(v);
      }
    }
    return std::move(this->Region);
  }

private:
  bool mayJoin(int v) const { return !this->Region[v] && (this->Allowed.empty() || this->Allowed[v]); }

  void queueNeighbours(int v)
  {
    for (const int n : this->Neighbours[v])
    {
      if (this->mayJoin(n) && !this->Queued[n])
      {
        this->Queued[n] = 1;
        this->Queue.push_back(n);
      }
    }
  }

  // Asks for what is waiting and some rings round it.
  void ask()
  {
    std::vector<int> wanted(this->Queue.begin(), this->Queue.end());
    std::vector<char> isWanted = this->Queued;
    for (std::size_t i = 0; i < wanted.size() && wanted.size() < askedAhead; ++i)
    {
      for (const int n : this->Neighbours[wanted[i]])
      {
        if (this->mayJoin(n) && !isWanted[n] && std::isnan(this->Evidence.ratio[n]))
        {
          isWanted[n] = 1;
          wanted.push_back(n);
        }
      }
    }
    this->Evidence.require(wanted);
  }

  const Lists& Neighbours;
  const RegionEvidence& Evidence;
  const std::vector<char>& Allowed;
  std::vector<char> Region, Queued;
  std::deque<int> Queue;
};

} // namespace

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

// Share of a model's area; what is larger is its body, or a good part of it.
constexpr double largestLimb = 0.2;

// Whether all of the part that a vertex is of lies within two rings round it: then no stroke, however short,
// leaves anything of it.
bool isWithinTwoRings(const Adjacency& adjacency, const MeshParts& parts, int vertex)
{
  const std::vector<char> near = withinRings(adjacency, { vertex }, 2);
  return std::count(near.begin(), near.end(), 1) ==
         std::count(parts.of.begin(), parts.of.end(), parts.of[vertex]);
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
      "The section has no vertices to grow a region from; draw a longer stroke or lower {seedMargin}.");
  }
  std::vector<char> isSeed = marksAt(evidence.seeds, mesh.points.size());
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
  const auto exceeds = [&](const std::vector<char>& region, double share)
  {
    double selected = 0.0;
    for (std::size_t v = 0; v < region.size(); ++v)
    {
      selected += region[v] ? parts.areas[v] : 0.0;
    }
    return selected > share * all;
  };
  const auto runsAway = [&](const std::vector<char>& region) { return exceeds(region, 0.5); };
  const auto grow = [&](const std::vector<char>& allowed, double mostArea)
  { return Growth(adjacency, evidence, allowed).run(options.lambda, parts.areas, mostArea); };
  const auto fill = [&](std::vector<char>& region)
  {
    if (options.fillIslands)
    {
      fillIslands(parts, adjacency, region);
    }
  };

  context.checkpoint(0.0);
  evidence.require(evidence.seeds);
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  // Sums may be rounded in another order.
  std::vector<char> region = grow({}, options.limitRunaway ? 0.500001 * all : unlimited);
  if (!options.limitRunaway || !runsAway(region))
  {
    fill(region);
  }
  if (options.limitRunaway && runsAway(region))
  {
    const std::vector<double> distance =
      edgeDistances(mesh, adjacency, evidence.seeds, evidence.sectionLength);
    std::vector<char> allowed(mesh.points.size());
    std::transform(
      distance.begin(), distance.end(), allowed.begin(), [](double d) { return char(std::isfinite(d)); });
    region = grow(allowed, unlimited);
    fill(region);
  }
  context.checkpoint(0.5);
  if (options.cutAtJunction)
  {
    region = cutBridges(mesh, adjacency, parts, evidence.diameter, isSeed, region);
    region = cutAtFork(mesh, adjacency, parts, evidence.seeds, region);
    evidence.require(borderOf(adjacency, region, true));
    Context half = context;
    half.progress = [&context](double done) { context.progress(0.5 + 0.5 * done); };
    std::vector<char> moved =
      cutAtJunction(mesh, adjacency, normals, parts, evidence.diameter, isSeed, region, {}, half);
    fill(moved);
    if (!runsAway(moved))
    {
      region = std::move(moved);
    }
  }
  dropSeedless(adjacency, isSeed, region);
  if (options.reachEnds)
  {
    std::vector<char> reached = reachEnds(mesh, adjacency, evidence.ends, evidence.endLength, region);
    fill(reached);
    if (!runsAway(reached))
    {
      region = std::move(reached);
    }
  }
  if (options.near > 0.0 && exceeds(region, largestLimb))
  {
    region = confineRegion(mesh, adjacency, evidence.seeds, options.near, region);
    dropSeedless(adjacency, isSeed, region);
  }
  if (options.shift != 0.0)
  {
    region = shiftBorder(mesh, adjacency, isSeed, options.shift, region);
    fill(region);
    dropSeedless(adjacency, isSeed, region);
  }
  for (std::size_t v = 0; v < region.size(); ++v)
  {
    if (!region[v])
    {
      held[parts.of[v]] = 0; // something of the part is left
    }
  }
  if (std::any_of(held.begin(), held.end(), [](char whole) { return whole != 0; }))
  {
    const bool isCoarse = std::any_of(evidence.seeds.begin(),
      evidence.seeds.end(),
      [&](int seed) { return held[parts.of[seed]] && isWithinTwoRings(adjacency, parts, seed); });
    throw Error(Failure::BadRegion,
      isCoarse
        ? "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold "
          "it; take a model with more triangles."
        : "The region reaches the whole model, or a whole separate part of it, so nothing is left to hold "
          "it; draw a shorter stroke, or one on a part that differs more in thickness from the rest.");
  }
  return region;
}

} // namespace oversketch
