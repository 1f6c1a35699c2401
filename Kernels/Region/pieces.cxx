// Connected pieces of a mesh, of a region and of its rest; see grow.h.
#include "Region/grow.h"

#include <vector>

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

} // namespace oversketch
