#include "Stellar/leaves.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string>

namespace oversketch
{

namespace
{

constexpr const char* culprit =
  "; a filter merged, split or reordered cells or points of the 4-8 mesh. Save it "
  "and read it without such a filter in between, or make a new base of it.";

[[noreturn]] void refuseLeaves(const Message& what)
{
  throw Error(Failure::BadMesh, "%1%2", what, culprit);
}

int depthOf(std::uint64_t path)
{
  return 63 - __builtin_clzll(path);
}

// Orders leaves of one tree from left to right: the first step of a path in the highest bit.
std::uint64_t alignedPath(std::uint64_t path)
{
  return path << (63 - depthOf(path));
}

// A leaf, or leaves joined, of the tree that is being read.
struct Node
{
  std::uint64_t path;
  Triangle v;
  int gen;
};

// Joins leaves, which come from left to right, to roots; learns parents and levels on the way.
class Reader
{
public:
  Reader(const Leaves& leaves, Forest& forest)
    : In(leaves)
    , Out(forest)
    , Sides(leaves.points.size(), 0)
    , Levels(leaves.points.size(), 0)
  {
  }

  void read()
  {
    const int count = static_cast<int>(this->In.triangles.size());
    for (int cell = 0; cell < count; ++cell)
    {
      this->push(cell);
      while (this->Stack.size() > 1 && this->Stack.back().path % 2 == 1)
      {
        this->join(cell);
      }
      if (this->Stack.back().path == 1)
      {
        this->finish(cell);
      }
    }
    if (!this->Stack.empty())
    {
      refuseLeaves({ "StellarPath: the last root, %1, lacks cells", this->Out.rootCount });
    }
  }

  // How many faces each vertex's split made parents of: 2, or 1 on the boundary.
  const std::vector<char>& sides() const { return this->Sides; }
  const std::vector<std::uint8_t>& levels() const { return this->Levels; }

private:
  void push(int cell)
  {
    const std::uint64_t path = this->In.path[cell];
    const auto at = [&](const char* array)
    { return std::string(array) + " of cell " + std::to_string(cell); };
    if (this->In.root[cell] != this->Out.rootCount)
    {
      refuseLeaves(
        { "%1 is %2 where root %3 goes on", at("StellarRoot"), this->In.root[cell], this->Out.rootCount });
    }
    // The leftmost leaf of what comes next.
    const std::uint64_t next = this->Stack.empty() ? 1 : this->Stack.back().path + 1;
    const int below = path ? depthOf(path) - depthOf(next) : -1;
    if (below < 0 || path >> below != next || path != next << below || depthOf(path) > Forest::maximumDepth)
    {
      refuseLeaves({ "%1 is %2, which does not follow the cell before", at("StellarPath"), path });
    }
    const int gen = this->In.gen[cell], depth = depthOf(path);
    if (this->Stack.empty())
    {
      this->RootGen = gen - depth;
    }
    if (gen - depth != this->RootGen || this->RootGen < 0 || this->RootGen > 1)
    {
      refuseLeaves({ "%1 is %2, which does not fit its StellarPath", at("StellarGen"), gen });
    }
    const Triangle& t = this->In.triangles[cell];
    for (int v : t)
    {
      if (v < 0 || v >= static_cast<int>(this->In.points.size()))
      {
        refuseLeaves({ "Cell %1 names point %2, which is not there", cell, v });
      }
    }
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      refuseLeaves({ "Cell %1 names a point twice", cell });
    }
    this->Stack.push_back({ path, t, gen });
  }

  // (m, p, a) and (m, c, p) into (p, a, c).
  void join(int cell)
  {
    const Node second = this->Stack.back();
    this->Stack.pop_back();
    Node& first = this->Stack.back();
    const int m = first.v[0], p = first.v[1], a = first.v[2], c = second.v[1];
    Forest::Vertex& vertex = this->Out.vertices[m];
    const bool fits = second.v[0] == m && second.v[2] == p && a != c &&
                      (this->Sides[m] == 0 || (this->Sides[m] == 1 && vertex.parents[0] == c &&
                                                vertex.parents[1] == a && this->Levels[m] == first.gen));
    if (!fits)
    {
      refuseLeaves({ "The points of cell %1 do not fit those of the cell it was split off", cell });
    }
    vertex.parents[0] = a;
    vertex.parents[1] = c;
    this->Levels[m] = static_cast<std::uint8_t>(first.gen);
    ++this->Sides[m];
    first = { first.path / 2, { p, a, c }, first.gen - 1 };
  }

  void finish(int cell)
  {
    const Node& root = this->Stack.back();
    // A corner of a root has no parents; only the first of a third is a barycentre.
    for (int i = 0; i < 3; ++i)
    {
      const int v = root.v[i], level = i == 0 ? root.gen : 0;
      if (this->Sides[v] < 0 ? this->Levels[v] != level : this->Sides[v] > 0)
      {
        refuseLeaves(
          { "Point %1, a corner of the root that ends with cell %2, is a new point elsewhere", v, cell });
      }
      this->Levels[v] = static_cast<std::uint8_t>(level);
      this->Sides[v] = -1;
    }
    ++this->Out.rootCount;
    this->Stack.pop_back();
  }

  const Leaves& In;
  Forest& Out;
  std::vector<char> Sides; // by point, -1 for a corner of a root; apart, since corners come in any order
  std::vector<std::uint8_t> Levels;
  std::vector<Node> Stack;
  int RootGen = 0;
};

void checkSizes(const Leaves& in)
{
  const auto require = [](const char* array, std::size_t size, std::size_t wanted, bool optional)
  {
    if (size != wanted && !(optional && size == 0))
    {
      throw Error(Failure::MissingArray,
        "The array %1 of a 4-8 mesh is absent or has %2 values where %3 are needed%4",
        array,
        size,
        wanted,
        culprit);
    }
  };
  const std::size_t cells = in.triangles.size(), points = in.points.size();
  require("StellarRoot", in.root.size(), cells, false);
  require("StellarPath", in.path.size(), cells, false);
  require("StellarGen", in.gen.size(), cells, false);
  require("StellarMoved", in.moved.size(), points, false);
  require("CurveId", in.curveId.size(), points, false);
  require("CurveParam", in.curveParam.size(), points, false);
  require("BaseNormal", in.baseNormal.size(), points, true);
  require("Displacement", in.displacement.size(), points, true);
  require("Feature", in.feature.size(), points, true);
}

void readPoints(const Leaves& in, Forest& out)
{
  out.vertices.reserve(in.points.size());
  out.hasBaseNormals = !in.baseNormal.empty();
  out.displacement = in.displacement;
  out.feature = in.feature;
  for (std::size_t i = 0; i < in.points.size(); ++i)
  {
    const auto wrong = [&](const char* array, const char* why) {
      refuseLeaves({ "%1 of point %2 %3", array, i, why });
    };
    Forest::Vertex& v = out.vertices.emplace_back();
    v.position = in.points[i];
    v.moved = in.moved[i];
    v.curveId = in.curveId[i];
    v.curveParam = in.curveParam[i];
    if (!v.position.allFinite())
    {
      wrong("The place", "is not finite");
    }
    if (v.moved > (Forest::Placed | Forest::Displaced | Forest::Crest))
    {
      wrong("StellarMoved", "is no sum of 1, 2 and 4");
    }
    if (v.curveId < -1 || (v.curveId >= 0 && !(v.moved & Forest::Placed)))
    {
      wrong("CurveId", "does not fit its StellarMoved");
    }
    if (!std::isfinite(v.curveParam))
    {
      wrong("CurveParam", "is not finite");
    }
    if (out.hasBaseNormals)
    {
      v.baseNormal = in.baseNormal[i];
      if (!v.baseNormal.allFinite())
      {
        wrong("BaseNormal", "is not finite");
      }
    }
    if (!in.displacement.empty() && !in.displacement[i].allFinite())
    {
      wrong("Displacement", "is not finite");
    }
    if (!in.feature.empty() && !std::isfinite(in.feature[i]))
    {
      wrong("Feature", "is not finite");
    }
  }
}

// Writes levels down. Points without parents first, then by level and parents; each edge is split once.
void checkPointOrder(Forest& forest, const std::vector<std::uint8_t>& levels)
{
  const auto key = [&](const Forest::Vertex& v)
  { return std::make_pair(v.level, std::minmax(v.parents[0], v.parents[1])); };
  for (std::size_t i = 0; i < forest.vertices.size(); ++i)
  {
    Forest::Vertex& v = forest.vertices[i];
    v.level = levels[i];
    if (v.parents[0] > v.parents[1])
    {
      std::swap(v.parents[0], v.parents[1]);
    }
    const bool isFirst = i == 0 || forest.vertices[i - 1].parents[0] < 0;
    if (isFirst ? false : v.parents[0] < 0 || !(key(forest.vertices[i - 1]) < key(v)))
    {
      refuseLeaves({ "Point %1 is not where the order of levels and parents has it", i });
    }
  }
}

// The faces round a vertex that are reached from one of them.
int reached(const Forest& forest, int v)
{
  const int start = forest.vertices[v].face;
  int count = 0;
  for (int f = start; f >= 0; ++count) // counter-clockwise
  {
    const Forest::Face& face = forest.faces[f];
    f = face.n[(face.v[0] == v) + 2 * (face.v[1] == v)]; // no branch, which would be guessed wrong
    if (f == start)
    {
      return count + 1;
    }
  }
  for (int f = start; f >= 0; ++count) // and where that ended at the boundary, clockwise
  {
    const Forest::Face& face = forest.faces[f];
    f = face.n[2 * (face.v[0] == v) + (face.v[2] == v)];
  }
  return count - 1; // the first one was met twice
}

// Leaves that share an edge agree on its generation, an edge that was split on one side only is on the
// boundary, and round a corner of a root there is one fan of cells; round new points that follows.
void checkFit(const Forest& forest, const std::vector<char>& sides, const Context& context)
{
  std::vector<int> corners(forest.vertices.size(), 0);
  for (const Forest::Face& face : forest.faces)
  {
    ++corners[face.v[0]];
    ++corners[face.v[1]];
    ++corners[face.v[2]];
  }
  std::vector<int> misfit(forest.faces.size(), -1);
  context.each(static_cast<int>(misfit.size()),
    [&](int f)
    {
      const Forest::Face& face = forest.faces[f];
      for (int i = 2; i >= 0; --i)
      {
        const int g = face.n[i];
        if (g >= 0 && face.gen + (i > 0) != forest.faces[g].gen + (forest.faces[g].n[0] != f))
        {
          misfit[f] = g;
        }
      }
    });
  const auto first = std::find_if(misfit.begin(), misfit.end(), [](int g) { return g >= 0; });
  if (first != misfit.end())
  {
    refuseLeaves({ "Cells %1 and %2 do not fit each other", first - misfit.begin(), *first });
  }
  context.checkpoint(0.8);
  std::vector<char> bad(forest.vertices.size(), 0);
  context.each(static_cast<int>(forest.vertices.size()),
    [&](int v)
    {
      const int* parents = forest.vertices[v].parents;
      bad[v] = sides[v] < 0    ? reached(forest, v) != corners[v]
               : sides[v] == 1 ? forest.faceWithEdge(parents[0], parents[1]) >= 0
                               : 0;
    });
  context.checkpoint(0.9);
  const auto found = std::find(bad.begin(), bad.end(), 1);
  if (found != bad.end())
  {
    refuseLeaves({ "The cells round point %1 do not fit each other", found - bad.begin() });
  }
}

// Slots of faces by root, then from left to right.
std::vector<int> faceOrder(const Forest& forest, const Context& context)
{
  std::vector<int> first(forest.rootCount + 1, 0);
  for (const Forest::Face& face : forest.faces)
  {
    if (face.root >= 0)
    {
      ++first[face.root + 1];
    }
  }
  for (int r = 0; r < forest.rootCount; ++r)
  {
    first[r + 1] += first[r];
  }
  std::vector<int> order(forest.faceCount()), next(first.begin(), first.end() - 1);
  for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
  {
    if (forest.isFace(f))
    {
      order[next[forest.faces[f].root]++] = f;
    }
  }
  context.parallelFor(forest.rootCount,
    [&](int begin, int end)
    {
      std::vector<std::pair<std::uint64_t, int>> keys;
      for (int r = begin; r < end && !context.cancelled(); ++r)
      {
        if (first[r + 1] - first[r] > 1)
        {
          keys.clear();
          for (int i = first[r]; i < first[r + 1]; ++i)
          {
            keys.emplace_back(alignedPath(forest.faces[order[i]].path), order[i]);
          }
          std::sort(keys.begin(), keys.end());
          std::transform(
            keys.begin(), keys.end(), order.begin() + first[r], [](const auto& key) { return key.second; });
        }
      }
    });
  return order;
}

// Slots of vertices: those without parents, then level by level by their parents' new ids.
std::vector<int> vertexOrder(const Forest& forest)
{
  struct Key
  {
    std::uint64_t parents;
    int vertex;
    bool operator<(const Key& other) const { return this->parents < other.parents; }
  };
  std::vector<int> order, newVertex(forest.vertices.size(), -1);
  order.reserve(forest.vertexCount());
  std::vector<std::vector<Key>> levels;
  const auto add = [&](int v)
  {
    newVertex[v] = static_cast<int>(order.size());
    order.push_back(v);
  };
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    const Forest::Vertex& vertex = forest.vertices[v];
    if (vertex.level != Forest::unusedLevel && vertex.parents[0] < 0)
    {
      add(v);
    }
    else if (vertex.level != Forest::unusedLevel)
    {
      levels.resize(std::max<std::size_t>(levels.size(), vertex.level + 1));
      levels[vertex.level].push_back({ 0, v });
    }
  }
  for (std::vector<Key>& level : levels)
  {
    for (Key& key : level)
    {
      const int* parents = forest.vertices[key.vertex].parents;
      const auto [low, high] = std::minmax(newVertex[parents[0]], newVertex[parents[1]]);
      key.parents = (static_cast<std::uint64_t>(low) << 32) | static_cast<std::uint32_t>(high);
    }
    std::sort(level.begin(), level.end());
    for (const Key& key : level)
    {
      add(key.vertex);
    }
  }
  return order;
}

} // namespace

Canonical canonical(const Forest& forest, const Context& context)
{
  Canonical result;
  Forest& out = result.forest;
  result.faceFrom = faceOrder(forest, context);
  context.checkpoint(0.4);
  result.vertexFrom = vertexOrder(forest);
  context.checkpoint(0.7);
  const std::vector<int> newFace = placesIn(result.faceFrom, forest.faces.size()),
                         newVertex = placesIn(result.vertexFrom, forest.vertices.size());
  const int faceCount = static_cast<int>(result.faceFrom.size()),
            vertexCount = static_cast<int>(result.vertexFrom.size());
  out.rootCount = forest.rootCount;
  out.hasBaseNormals = forest.hasBaseNormals;
  out.closed = forest.closed;
  // Memory is what this takes: each place is written once, and one thread is as quick as several are where
  // they find places that had to be made first.
  std::vector<int> highest(vertexCount, -1); // of a star, as connect() has it
  out.faces.reserve(faceCount);
  for (int i = 0; i < faceCount; ++i)
  {
    out.faces.push_back(forest.faces[result.faceFrom[i]]);
    Forest::Face& face = out.faces.back();
    for (int k = 0; k < 3; ++k)
    {
      face.v[k] = newVertex[face.v[k]];
      face.n[k] = face.n[k] < 0 ? -1 : newFace[face.n[k]];
      highest[face.v[k]] = i;
    }
  }
  context.checkpoint(0.85);
  out.vertices.reserve(vertexCount);
  out.displacement.reserve(forest.displacement.empty() ? 0 : vertexCount);
  out.feature.reserve(forest.feature.empty() ? 0 : vertexCount);
  for (int i = 0; i < vertexCount; ++i)
  {
    const int from = result.vertexFrom[i];
    out.vertices.push_back(forest.vertices[from]);
    Forest::Vertex& vertex = out.vertices.back();
    vertex.face = highest[i] < 0 ? vertex.face : highest[i];
    if (vertex.parents[0] >= 0)
    {
      const auto [low, high] = std::minmax(newVertex[vertex.parents[0]], newVertex[vertex.parents[1]]);
      vertex.parents[0] = low;
      vertex.parents[1] = high;
    }
    if (!forest.displacement.empty())
    {
      out.displacement.push_back(forest.displacement[from]);
    }
    if (!forest.feature.empty())
    {
      out.feature.push_back(forest.feature[from]);
    }
  }
  context.checkpoint(1.0);
  assert(out.broken().empty());
  return result;
}

Leaves emit(const Forest& forest)
{
  Leaves out;
  const std::size_t cells = forest.faces.size(), points = forest.vertices.size();
  out.triangles.resize(cells);
  out.root.resize(cells);
  out.path.resize(cells);
  out.gen.resize(cells);
  for (std::size_t f = 0; f < cells; ++f)
  {
    const Forest::Face& face = forest.faces[f];
    out.triangles[f] = { face.v[0], face.v[1], face.v[2] };
    out.root[f] = face.root;
    out.path[f] = face.path;
    out.gen[f] = face.gen;
  }
  out.points.resize(points);
  out.moved.resize(points);
  out.curveId.resize(points);
  out.curveParam.resize(points);
  out.baseNormal.resize(forest.hasBaseNormals ? points : 0);
  for (std::size_t i = 0; i < points; ++i)
  {
    const Forest::Vertex& v = forest.vertices[i];
    out.points[i] = v.position;
    out.moved[i] = v.moved;
    out.curveId[i] = v.curveId;
    out.curveParam[i] = v.curveParam;
    if (forest.hasBaseNormals)
    {
      out.baseNormal[i] = v.baseNormal;
    }
  }
  out.displacement = forest.displacement;
  out.feature = forest.feature;
  return out;
}

Forest rebuild(const Leaves& leaves, const Context& context)
{
  checkSizes(leaves);
  Forest forest;
  readPoints(leaves, forest);
  context.checkpoint(0.1);
  Reader reader(leaves, forest);
  reader.read();
  context.checkpoint(0.3);
  checkPointOrder(forest, reader.levels());
  forest.faces.reserve(leaves.triangles.size());
  for (std::size_t f = 0; f < leaves.triangles.size(); ++f)
  {
    const Triangle& t = leaves.triangles[f];
    forest.faces.push_back(
      { leaves.path[f], { t[0], t[1], t[2] }, { -1, -1, -1 }, leaves.root[f], leaves.gen[f] });
  }
  try
  {
    forest.connect(context);
  }
  catch (const Error& e)
  {
    refuseLeaves(std::string(e.what()));
  }
  context.checkpoint(0.6);
  checkFit(forest, reader.sides(), context);
  assert(forest.broken().empty());
  return forest;
}

std::vector<int> facesUnder(const Forest& before, const Forest& after)
{
  std::vector<int> under(after.faces.size(), 0);
  std::size_t at = 0;
  for (std::size_t f = 0; f < after.faces.size(); ++f)
  {
    const Forest::Face& face = after.faces[f];
    const std::uint64_t wanted = alignedPath(face.path);
    // The last one that begins at or before the face in its tree; of several within it, the first.
    while (at + 1 < before.faces.size() &&
           (before.faces[at + 1].root < face.root ||
             (before.faces[at + 1].root == face.root && alignedPath(before.faces[at + 1].path) <= wanted)))
    {
      ++at;
    }
    under[f] = static_cast<int>(at);
  }
  return under;
}

} // namespace oversketch
