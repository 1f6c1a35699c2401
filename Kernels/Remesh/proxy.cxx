#include "Remesh/proxy.h"

#include "Remesh/passes.h"

#include <cmath>
#include <cstdint>
#include <iterator>

namespace oversketch
{

namespace
{

// Cells of the grid are halved so often where they must be; after that each vertex stands alone.
constexpr int deepest = 3;

// The least size of a cell, as a share of the box's longest side: three numbers of its grid, halved as often
// as can be, fit 64 bits.
constexpr double leastCell = 1.0 / (1 << (20 - deepest));

using Cell = std::uint64_t;

// Numbers from 0 on that are to be kept, ascending.
template <typename Keep>
std::vector<int> chosen(int count, const Context& context, const Keep& keep)
{
  constexpr int block = 1 << 16;
  std::vector<std::vector<int>> parts((static_cast<std::size_t>(count) + block - 1) / block);
  context.each(static_cast<int>(parts.size()),
    [&](int part)
    {
      const int end = std::min(count - part * block, block) + part * block;
      for (int i = part * block; i < end; ++i)
      {
        if (keep(i))
        {
          parts[part].push_back(i);
        }
      }
    });
  std::vector<int> all;
  for (const std::vector<int>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

template <typename Number>
bool allDiffer(const std::vector<Number>& of, const Triangle& t)
{
  return of[t[0]] != of[t[1]] && of[t[1]] != of[t[2]] && of[t[2]] != of[t[0]];
}

// Twice the area times the normal.
Vector3 areaNormal(const Mesh& mesh, const Triangle& t)
{
  return (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]);
}

class Grid
{
public:
  explicit Grid(const Mesh& mesh)
  {
    const Eigen::AlignedBox3d box = boxRound(mesh.points);
    this->Low = box.min();
    this->Longest = box.sizes().maxCoeff();
  }
  void setSize(double size) { this->Size = std::max(size, leastCell * this->Longest); }
  double size() const { return this->Size; }
  double longest() const { return this->Longest; } // side of the box

  Cell cellAt(const Vector3& p, int level) const
  {
    const Vector3 at = (p - this->Low) * (std::ldexp(1.0, level) / this->Size);
    return static_cast<Cell>(at[0]) << 42 | static_cast<Cell>(at[1]) << 21 | static_cast<Cell>(at[2]);
  }

private:
  Vector3 Low;
  double Longest = 0.0, Size = 1.0;
};

// An edge whose triangles are not one that runs it forward, to the higher vertex, and one that runs back.
struct OddEdge
{
  int v0, v1;
  int missing; // forward runs to one
};

// Edges of borders, and where triangles are not turned alike.
std::vector<OddEdge> oddEdges(const Mesh& mesh)
{
  // Round a vertex inside, each neighbour is once the next and once the last one of a triangle.
  std::vector<std::uint32_t> open(mesh.points.size(), 0);
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      open[t[k]] += static_cast<std::uint32_t>(t[(k + 1) % 3]) - static_cast<std::uint32_t>(t[(k + 2) % 3]);
    }
  }
  std::vector<std::array<int, 3>> sides; // lower and higher vertex, whether it runs forward
  for (const Triangle& t : mesh.triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = t[k], b = t[(k + 1) % 3];
      if (open[a] != 0 && open[b] != 0 && a != b)
      {
        sides.push_back({ std::min(a, b), std::max(a, b), a < b ? 1 : 0 });
      }
    }
  }
  std::sort(sides.begin(), sides.end());
  std::vector<OddEdge> edges;
  for (std::size_t i = 0; i < sides.size();)
  {
    OddEdge edge{ sides[i][0], sides[i][1], 1 };
    for (; i < sides.size() && sides[i][0] == edge.v0 && sides[i][1] == edge.v1; ++i)
    {
      edge.missing -= sides[i][2];
    }
    if (edge.missing != 0)
    {
      edges.push_back(edge);
    }
  }
  return edges;
}

struct Cluster
{
  int level = -1; // of the cells that it was made by
  int count = 0;  // of vertices
  int euler = 0;  // of the surface between those: 1 where that has no hole and no handle
  int vertex = -1;
  double offset = std::numeric_limits<double>::infinity(); // of that from the mean, squared
  bool joined = false;                                     // a triangle goes to another one
  Vector3 sum = Vector3::Zero();                           // of the points
  Vector3 normal = Vector3::Zero();                        // of all triangles at them, by area
};

class Clustering
{
public:
  Clustering(const Mesh& mesh, const Grid& grid, const std::vector<OddEdge>& odd, const Context& context)
    : Whole(mesh)
    , Cells(grid)
    , Odd(odd)
    , Caller(context)
    , Of(mesh.points.size(), 0)
    , Root(mesh.points.size())
    , CellOf(mesh.points.size())
    , Clusters(1)
  {
    std::vector<char> marks(1, 1); // all is one cluster
    std::vector<int> near(mesh.triangles.size());
    std::iota(near.begin(), near.end(), 0);
    for (int pass = 1; std::find(marks.begin(), marks.end(), 1) != marks.end(); ++pass)
    {
      this->split(marks, near);
      this->addFaces(near);
      marks = this->unsound(near);
      context.checkpoint(1.0 - 1.0 / (1 + pass));
    }
  }

  Proxy proxy() const
  {
    Proxy proxy;
    std::vector<int> place(this->Clusters.size(), -1);
    for (const Triangle& face : this->Faces.triangles)
    {
      for (const int c : face)
      {
        place[c] = 0;
      }
    }
    for (std::size_t c = 0; c < place.size(); ++c)
    {
      if (place[c] == 0)
      {
        place[c] = static_cast<int>(proxy.pointFrom.size());
        proxy.pointFrom.push_back(this->Clusters[c].vertex);
      }
    }
    proxy.mesh.points = valuesAt(this->Whole.points, proxy.pointFrom);
    for (const Triangle& face : this->Faces.triangles)
    {
      proxy.mesh.triangles.push_back({ place[face[0]], place[face[1]], place[face[2]] });
    }
    return proxy;
  }

private:
  int rootOf(int v)
  {
    while (this->Root[v] != v)
    {
      this->Root[v] = this->Root[this->Root[v]];
      v = this->Root[v];
    }
    return v;
  }

  // Makes new clusters of the vertices of marked ones, by cells of half the size. `near`: the triangles at
  // those, and perhaps others.
  void split(const std::vector<char>& marks, const std::vector<int>& near)
  {
    const std::vector<int> vertices =
      chosen(this->Whole.vertexCount(), this->Caller, [&](int v) { return marks[this->Of[v]] != 0; });
    this->Caller.each(static_cast<int>(vertices.size()),
      [&](int i)
      {
        const int v = vertices[i], level = this->Clusters[this->Of[v]].level + 1;
        this->Root[v] = v;
        this->CellOf[v] =
          level > deepest ? static_cast<Cell>(v) : this->Cells.cellAt(this->Whole.points[v], level);
      });
    for (const int t : near)
    {
      const Triangle& c = this->Whole.triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        const int a = c[k], b = c[(k + 1) % 3];
        if (this->Of[a] == this->Of[b] && marks[this->Of[a]] && this->CellOf[a] == this->CellOf[b])
        {
          const int one = this->rootOf(a), other = this->rootOf(b);
          this->Root[std::max(one, other)] = std::min(one, other);
        }
      }
    }
    const int fresh = static_cast<int>(this->Clusters.size());
    for (const int v : vertices) // a root comes before what hangs on it
    {
      const int root = this->rootOf(v);
      if (root == v)
      {
        Cluster cluster;
        cluster.level = this->Clusters[this->Of[v]].level + 1;
        this->Of[v] = static_cast<int>(this->Clusters.size());
        this->Clusters.push_back(cluster);
      }
      else
      {
        this->Of[v] = this->Of[root];
      }
    }
    for (const int c : marked(marks))
    {
      this->Clusters[c] = Cluster(); // joined to nothing any more
    }
    this->takeVertices(vertices);
    this->takeTriangles(near, fresh);
  }

  void takeVertices(const std::vector<int>& vertices)
  {
    for (const int v : vertices)
    {
      Cluster& cluster = this->Clusters[this->Of[v]];
      cluster.sum += this->Whole.points[v];
      ++cluster.count;
      ++cluster.euler;
    }
    for (const int v : vertices)
    {
      Cluster& cluster = this->Clusters[this->Of[v]];
      const double offset = (this->Whole.points[v] - cluster.sum / cluster.count).squaredNorm();
      if (offset < cluster.offset)
      {
        cluster.offset = offset;
        cluster.vertex = v;
      }
    }
  }

  // Only clusters from `fresh` on are counted anew.
  void takeTriangles(const std::vector<int>& near, int fresh)
  {
    for (const int t : near)
    {
      const Triangle& v = this->Whole.triangles[t];
      const Triangle at = { this->Of[v[0]], this->Of[v[1]], this->Of[v[2]] };
      const bool inOne = at[0] == at[1] && at[1] == at[2];
      const Vector3 normal = areaNormal(this->Whole, v);
      for (int k = 0; k < 3; ++k)
      {
        Cluster& cluster = this->Clusters[at[k]];
        cluster.joined = cluster.joined || !inOne;
        if (at[k] >= fresh)
        {
          cluster.normal += normal;
          cluster.euler -= at[k] == at[(k + 1) % 3] && v[k] < v[(k + 1) % 3] ? 1 : 0;
        }
      }
      this->Clusters[at[0]].euler += inOne && at[0] >= fresh ? 1 : 0;
    }
    for (const OddEdge& edge : this->Odd)
    {
      const int c = this->Of[edge.v0];
      this->Clusters[c].euler -= c >= fresh && c == this->Of[edge.v1] ? edge.missing : 0;
    }
  }

  // What has its corners in three clusters keeps them so.
  void addFaces(const std::vector<int>& near)
  {
    std::vector<int> fresh, all;
    for (const int t : near)
    {
      if (allDiffer(this->Of, this->Whole.triangles[t]))
      {
        fresh.push_back(t);
      }
    }
    std::set_union(
      this->Staying.begin(), this->Staying.end(), fresh.begin(), fresh.end(), std::back_inserter(all));
    this->Staying.swap(all);
    this->Faces.points.assign(this->Clusters.size(), Vector3::Zero());
    for (std::size_t c = 0; c < this->Clusters.size(); ++c)
    {
      if (this->Clusters[c].vertex >= 0)
      {
        this->Faces.points[c] = this->Whole.points[this->Clusters[c].vertex];
      }
    }
    this->Faces.triangles.resize(this->Staying.size());
    this->Caller.each(this->Faces.triangleCount(),
      [this](int f)
      {
        const Triangle& t = this->Whole.triangles[this->Staying[f]];
        this->Faces.triangles[f] = { this->Of[t[0]], this->Of[t[1]], this->Of[t[2]] };
      });
  }

  // Whether a face looks another way than its clusters, and than its own triangle: of clusters round a rim
  // the one tells little, of a rough surface the other. Flips get no hold of what is turned so far.
  bool isTurned(int face) const
  {
    const Triangle& at = this->Faces.triangles[face];
    const Vector3 normal = areaNormal(this->Faces, at);
    return turned(areaNormal(this->Whole, this->Whole.triangles[this->Staying[face]]), normal) &&
           turned(this->Clusters[at[0]].normal + this->Clusters[at[1]].normal + this->Clusters[at[2]].normal,
             normal);
  }

  // What is wrong, each by the clusters that it is of.
  std::vector<Triangle> defects() const
  {
    std::vector<Triangle> defects;
    const Adjacency around = buildAdjacency(this->Faces, this->Caller);
    std::vector<char> wrong(this->Clusters.size(), 0);
    this->Caller.each(static_cast<int>(wrong.size()),
      [&](int c)
      {
        const Cluster& cluster = this->Clusters[c];
        const bool isLost = around.vertexTriangles.size(c) == 0;
        wrong[c] = cluster.joined && (cluster.euler != 1 || isLost || !isOneFan(around, c)) ? 1 : 0;
      });
    for (const int c : marked(wrong))
    {
      defects.push_back({ c, c, c });
    }
    for (std::size_t e = 0; e < around.edges.size(); ++e)
    {
      const MeshEdge& edge = around.edges[e];
      const int* faces = around.trianglesBegin(static_cast<int>(e));
      if (edge.triangleCount > 2)
      {
        defects.push_back({ edge.v0, edge.v1, edge.v1 });
      }
      else if (edge.triangleCount == 2 && this->isTwice(faces[0], faces[1]))
      {
        defects.push_back(this->Faces.triangles[faces[0]]);
      }
    }
    for (const int f :
      chosen(this->Faces.triangleCount(), this->Caller, [this](int face) { return this->isTurned(face); }))
    {
      defects.push_back(this->Faces.triangles[f]);
    }
    return defects;
  }

  // Of two faces at an edge.
  bool isTwice(int face, int other) const
  {
    const Triangle& corners = this->Faces.triangles[other];
    return std::all_of(
      corners.begin(), corners.end(), [&](int c) { return cornerOf(this->Faces.triangles[face], c) >= 0; });
  }

  // The clusters to split: those of defects, but where the mesh is no manifold itself, or nothing is left to
  // split. `near`: the triangles there.
  std::vector<char> unsound(std::vector<int>& near)
  {
    const std::vector<Triangle> all = this->defects();
    std::vector<char> marks(this->Clusters.size(), 0);
    for (const Triangle& defect : all)
    {
      marks[defect[0]] = marks[defect[1]] = marks[defect[2]] = 1;
    }
    near = chosen(this->Whole.triangleCount(),
      this->Caller,
      [&](int t)
      {
        const Triangle& v = this->Whole.triangles[t];
        return marks[this->Of[v[0]]] || marks[this->Of[v[1]]] || marks[this->Of[v[2]]];
      });
    const std::vector<char> rough = this->notManifold(marks, near);
    std::fill(marks.begin(), marks.end(), 0);
    for (const Triangle& defect : all)
    {
      if (!rough[defect[0]] && !rough[defect[1]] && !rough[defect[2]])
      {
        for (const int c : defect)
        {
          marks[c] = this->Clusters[c].count > 1 ? 1 : 0;
        }
      }
    }
    return marks;
  }

  // Which of the marked clusters have a vertex where the mesh is no manifold.
  std::vector<char> notManifold(const std::vector<char>& marks, const std::vector<int>& near)
  {
    std::vector<char> rough(marks.size(), 0);
    std::vector<int>& place = this->Root; // in the part, of the triangles' corners
    for (const int t : near)
    {
      for (const int v : this->Whole.triangles[t])
      {
        place[v] = -1;
      }
    }
    Mesh part;
    std::vector<int> clusters; // per vertex of the part
    for (const int t : near)
    {
      part.triangles.push_back(this->Whole.triangles[t]);
      for (int& v : part.triangles.back())
      {
        if (place[v] < 0)
        {
          place[v] = static_cast<int>(clusters.size());
          clusters.push_back(this->Of[v]);
        }
        v = place[v];
      }
    }
    part.points.resize(clusters.size());
    const Adjacency around = buildAdjacency(part, this->Caller);
    for (std::size_t e = 0; e < around.edges.size(); ++e)
    {
      const MeshEdge& edge = around.edges[e];
      const int* t = around.trianglesBegin(static_cast<int>(e));
      if (edge.triangleCount > 2 ||
          (edge.triangleCount == 2 && runsAlong(part.triangles[t[0]], edge.v0, edge.v1) ==
                                        runsAlong(part.triangles[t[1]], edge.v0, edge.v1)))
      {
        rough[clusters[edge.v0]] = rough[clusters[edge.v1]] = 1;
      }
    }
    for (std::size_t v = 0; v < clusters.size(); ++v)
    {
      if (marks[clusters[v]] && !isOneFan(around, static_cast<int>(v)))
      {
        rough[clusters[v]] = 1;
      }
    }
    return rough;
  }

  const Mesh& Whole;
  const Grid& Cells;
  const std::vector<OddEdge>& Odd;
  const Context& Caller;
  std::vector<int> Of;   // per vertex its cluster
  std::vector<int> Root; // per vertex one of its cluster, the least of all at the end of the way
  std::vector<Cell> CellOf;
  std::vector<Cluster> Clusters; // with those that were split
  std::vector<int> Staying;      // triangles with their corners in three clusters
  Mesh Faces;                    // those, of clusters
};

// Sets cells that leave about so many triangles with their corners in three.
void findSize(const Mesh& mesh, double target, const Context& context, Grid& grid)
{
  // A surface in any direction meets one and a half cells per square of their size; two triangles a cell.
  double area = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    area += 0.5 * areaNormal(mesh, t).norm();
  }
  if (!(area > 0.0))
  {
    throw Error(Failure::BadMesh, "No triangle of the mesh has an area; give a mesh with triangles.");
  }
  double size = std::sqrt(3.0 * area / target), low = 0.0, high = std::numeric_limits<double>::infinity();
  std::vector<Cell> cells(mesh.points.size());
  constexpr int mostTries = 10;
  for (int i = 0; i < mostTries; ++i)
  {
    grid.setSize(size);
    context.each(mesh.vertexCount(), [&](int v) { cells[v] = grid.cellAt(mesh.points[v], 0); });
    const std::vector<int> staying =
      chosen(mesh.triangleCount(), context, [&](int t) { return allDiffer(cells, mesh.triangles[t]); });
    const double ratio = static_cast<double>(staying.size()) / target;
    if (std::abs(ratio - 1.0) <= 0.1)
    {
      return;
    }
    (ratio > 1.0 ? low : high) = size;
    size *= std::clamp(std::sqrt(ratio), 0.5, 2.0);
    if (!(low < size && size < high))
    {
      size = 0.5 * (low + high);
    }
    context.checkpoint(0.0);
  }
}

// Flips the edges of needles, which clusters leave and light shows.
void evenOut(Mesh& mesh, const Context& context)
{
  const std::vector<char> active(mesh.triangles.size(), 1);
  const std::vector<int> charts;
  const Surface surface(mesh, active, charts);
  Patch patch(surface, active, std::vector<double>(mesh.points.size(), 1.0), {}, {}, false);
  Steps steps{ context };
  flipByAngle(patch, steps);
  std::vector<Triangle> flipped(mesh.triangles.size());
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    flipped[t] = patch.triangle(t);
  }
  mesh.triangles = std::move(flipped);
}

} // namespace

Proxy makeProxy(const Mesh& mesh, int targetFaces, const Context& context)
{
  constexpr double share = 0.12;      // of the triangles, for what will be split
  constexpr double mostExcess = 1.25; // of triangles, by that
  constexpr double leastShare = 0.5;  // of the triangles: with fewer, cells cannot be as small as they should
  constexpr int mostTries = 3;
  Grid grid(mesh);
  findSize(mesh, (1.0 - share) * targetFaces, context, grid);
  const std::vector<OddEdge> odd = oddEdges(mesh);
  for (int i = 1;; ++i)
  {
    const Clustering clustering(mesh, grid, odd, context);
    Proxy proxy = clustering.proxy();
    const double excess = static_cast<double>(proxy.mesh.triangleCount()) / targetFaces;
    if (excess < leastShare)
    {
      throw Error(Failure::BadMesh,
        "The mesh is over %1 times as long as the triangles of a proxy would be; remove what lies far from "
        "the "
        "rest.",
        std::llround(grid.longest() / grid.size()));
    }
    if (excess <= mostExcess || i == mostTries)
    {
      evenOut(proxy.mesh, context);
      return proxy;
    }
    grid.setSize(grid.size() * std::sqrt(excess));
  }
}

} // namespace oversketch
