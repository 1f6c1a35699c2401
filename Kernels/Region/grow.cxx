#include "Region/grow.h"

#include "Region/border.h"
#include "Region/cut.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <string>
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
      for (const int n : adjacency.vertexVertices[v])
      {
        if (pieces.of[n] < 0 && label[n] == which)
        {
          pieces.of[n] = piece;
          open.push_back(n);
        }
      }
    }
  }
  return pieces;
}

// The islands of a region, found from its ring: the unselected vertices next to it. Every piece of the rest
// of a part touches the ring. All pieces are walked in step, from the ring's own pieces, until in each part
// only one is not at its end: that one need not be walked further if it is the largest.
class IslandFinder
{
public:
  IslandFinder(const MeshParts& meshParts, const Adjacency& neighbours, const std::vector<char>& selected)
    : Parts(meshParts)
    , Neighbours(neighbours)
    , Grown(selected)
    , FloodOf(selected.size(), -1)
    , RestAreas(meshParts.count, 0.0)
    , Open(meshParts.count, 0)
  {
    this->findRing();
    for (Flood& flood : this->Floods)
    {
      this->openOne(flood);
    }
    while (this->Crowded > 0)
    {
      for (int f = 0; f < int(this->Floods.size()); ++f)
      {
        this->step(f);
      }
    }
  }

  // The islands' vertices into `islands`; false where the areas are too close to tell, or a part has been
  // walked to its end.
  bool find(std::vector<int>& islands)
  {
    std::vector<std::vector<int>> pieces(this->Floods.size());
    for (int f = 0; f < int(this->Floods.size()); ++f)
    {
      std::vector<int>& piece = pieces[this->leader(f)];
      piece.insert(piece.end(), this->Floods[f].vertices.begin(), this->Floods[f].vertices.end());
    }
    std::vector<double> largest(this->Parts.count, 0.0), walked(this->Parts.count, 0.0);
    for (int f = 0; f < int(this->Floods.size()); ++f)
    {
      const int part = this->Floods[f].part;
      if (this->leader(f) != f || this->Floods[f].waiting > 0)
      {
        continue;
      }
      if (this->Open[part] == 0)
      {
        return false;
      }
      double area = 0.0;
      for (const int v : pieces[f])
      {
        area += this->Parts.areas[v];
      }
      largest[part] = std::max(largest[part], area);
      walked[part] += area;
      islands.insert(islands.end(), pieces[f].begin(), pieces[f].end());
    }
    for (int part = 0; part < this->Parts.count; ++part)
    {
      constexpr double margin = 1e-9;
      if (walked[part] > 0.0 && !(this->RestAreas[part] - walked[part] >
                                  (1.0 + margin) * largest[part] + margin * this->RestAreas[part]))
      {
        return false;
      }
    }
    return true;
  }

private:
  struct Flood
  {
    int part, leader;
    std::vector<int> vertices; // in the order they are walked
    std::size_t next = 0;
    int waiting = 0; // of a leader: floods of the piece that are not at their end
  };

  void findRing()
  {
    std::vector<int> ring;
    std::vector<char> inRing(this->Grown.size(), 0);
    for (int v = 0; v < int(this->Grown.size()); ++v)
    {
      if (!this->Grown[v])
      {
        continue;
      }
      this->RestAreas[this->Parts.of[v]] -= this->Parts.areas[v];
      for (const int n : this->Neighbours.vertexVertices[v])
      {
        if (!this->Grown[n] && !inRing[n])
        {
          inRing[n] = 1;
          ring.push_back(n);
        }
      }
    }
    for (int part = 0; part < this->Parts.count; ++part)
    {
      this->RestAreas[part] += this->Parts.partAreas[part];
    }
    for (const int start : ring)
    {
      if (this->FloodOf[start] >= 0)
      {
        continue;
      }
      const int id = int(this->Floods.size());
      this->Floods.push_back({ this->Parts.of[start], id, { start } });
      this->FloodOf[start] = id;
      std::vector<int>& vertices = this->Floods.back().vertices;
      for (std::size_t i = 0; i < vertices.size(); ++i)
      {
        const int v = vertices[i];
        for (const int n : this->Neighbours.vertexVertices[v])
        {
          if (inRing[n] && this->FloodOf[n] < 0)
          {
            this->FloodOf[n] = id;
            vertices.push_back(n);
          }
        }
      }
    }
  }

  void openOne(Flood& flood)
  {
    flood.waiting = 1;
    this->Crowded += ++this->Open[flood.part] == 2;
  }

  void closeOne(int part) { this->Crowded -= --this->Open[part] == 1; }

  int leader(int flood)
  {
    while (this->Floods[flood].leader != flood)
    {
      flood = this->Floods[flood].leader = this->Floods[this->Floods[flood].leader].leader;
    }
    return flood;
  }

  void step(int id)
  {
    if (this->Floods[id].next == this->Floods[id].vertices.size())
    {
      return;
    }
    const int v = this->Floods[id].vertices[this->Floods[id].next++];
    for (const int n : this->Neighbours.vertexVertices[v])
    {
      if (this->Grown[n])
      {
        continue;
      }
      if (this->FloodOf[n] < 0)
      {
        this->FloodOf[n] = id;
        this->Floods[id].vertices.push_back(n);
        continue;
      }
      const int mine = this->leader(id), other = this->leader(this->FloodOf[n]);
      if (mine != other)
      {
        // A piece that has been walked to its end meets nobody, so both are open.
        this->Floods[other].leader = mine;
        this->Floods[mine].waiting += this->Floods[other].waiting;
        this->closeOne(this->Floods[id].part);
      }
    }
    if (this->Floods[id].next == this->Floods[id].vertices.size() &&
        --this->Floods[this->leader(id)].waiting == 0)
    {
      this->closeOne(this->Floods[id].part);
    }
  }

  const MeshParts& Parts;
  const Adjacency& Neighbours;
  const std::vector<char>& Grown;
  std::vector<Flood> Floods;
  std::vector<int> FloodOf; // by vertex
  std::vector<double> RestAreas;
  std::vector<int> Open; // by part: pieces not at their end
  int Crowded = 0;       // parts with several of those
};

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

std::vector<double> vertexAreas(const Mesh& mesh)
{
  std::vector<double> areas(mesh.points.size(), 0.0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const double area = facetArea(mesh, t);
    for (int v : mesh.triangles[t])
    {
      areas[v] += area / 3.0;
    }
  }
  return areas;
}

MeshParts findParts(const Mesh& mesh, const Adjacency& adjacency, const Context& context)
{
  Pieces pieces;
  std::vector<double> areas;
  context.each(2,
    [&](int which)
    {
      if (which == 0)
      {
        pieces = piecesOf(adjacency, std::vector<char>(mesh.points.size(), 0), 0);
      }
      else
      {
        areas = vertexAreas(mesh);
      }
    });
  MeshParts parts{ std::move(areas), std::move(pieces.of), pieces.count, {} };
  parts.partAreas.resize(parts.count, 0.0);
  for (std::size_t v = 0; v < parts.of.size(); ++v)
  {
    parts.partAreas[parts.of[v]] += parts.areas[v];
  }
  return parts;
}

void fillIslands(const MeshParts& parts, const Adjacency& adjacency, std::vector<char>& region)
{
  std::vector<int> islands;
  if (IslandFinder(parts, adjacency, region).find(islands))
  {
    for (const int v : islands)
    {
      region[v] = 1;
    }
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
