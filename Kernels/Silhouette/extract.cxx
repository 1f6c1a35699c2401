#include "Silhouette/extract.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

// The crossed edges and how the curves run through them. A slot is a crossed edge seen from one of its
// triangles: two for a usual edge, in the order of its triangles.
class Extraction
{
public:
  Extraction(const Mesh& surface,
    const Adjacency& neighbours,
    const std::vector<Vector3>& vertexNormals,
    const View& eye)
    : Model(surface)
    , Neighbours(neighbours)
    , Normals(vertexNormals)
    , Camera(eye)
  {
    // An index of the signs, by boxes round clumps of vertices, would halve this pass; making it costs as
    // much as some seventy views save, and a mesh is seldom looked at from that many.
    std::vector<double> values(surface.points.size());
    double largest = 0.0;
    for (int v = 0; v < surface.vertexCount(); ++v)
    {
      values[v] = this->g(v);
      largest = std::max(largest, std::abs(values[v]));
    }
    this->Limit = tolerance * largest;
    std::vector<char> plus(surface.points.size());
    for (int v = 0; v < surface.vertexCount(); ++v)
    {
      plus[v] = this->countsAsPlus(values[v]);
    }
    for (int e = 0; e < static_cast<int>(neighbours.edges.size()); ++e)
    {
      if (plus[neighbours.edges[e].v0] != plus[neighbours.edges[e].v1])
      {
        this->Crossings.push_back({ e, 0, 0, 0 });
      }
    }
  }

  std::vector<Curve> run()
  {
    std::vector<int> slotOf(this->Model.triangles.size(), 0);
    const int count = static_cast<int>(this->Crossings.size());
    this->Points.reserve(count);
    this->Slots.reserve(2 * count + 1);
    this->Slots.push_back({ -1 });
    for (int c = 0; c < count; c += block)
    {
      const int end = std::min(c + block, count);
      this->link(c, end, slotOf);
      for (int i = c; i < end; ++i)
      {
        this->Points.push_back(this->pointOn(this->Crossings[i]));
      }
    }
    this->Crossings.push_back(
      { -1, -1, -1, static_cast<int>(this->Slots.size()) }); // where the last slots end
    std::vector<Curve> curves;
    std::vector<int> chain;
    for (int seed = 0; seed < count; ++seed)
    {
      const int first = this->Crossings[seed].firstSlot, sides = this->slotCount(seed);
      // One curve runs through a usual edge; at any other, every triangle starts a curve of its own.
      for (int slot = first; slot < first + (sides == 2 ? 1 : sides); ++slot)
      {
        if (this->Slots[slot].visited)
        {
          continue;
        }
        chain.assign(1, seed);
        const bool closed = this->walk(slot, chain);
        if (sides == 2 && !closed)
        {
          std::reverse(chain.begin(), chain.end());
          this->walk(slot + 1, chain);
        }
        this->emit(chain, closed, curves);
      }
    }
    return curves;
  }

private:
  static constexpr double tolerance = 1e-9; // of the largest |g|: what counts as on the silhouette

  // Crossings at a time: what the points need is on its way while the curves are linked.
  static constexpr int block = 16;

  struct Crossing
  {
    int edge, v0, v1, firstSlot;
  };
  struct Slot
  {
    int crossing;
    int across = 0; // the slot of the triangle's other crossed edge: it has none or two
    bool visited = false;
  };

  int slotCount(int crossing) const
  {
    return this->Crossings[crossing + 1].firstSlot - this->Crossings[crossing].firstSlot;
  }

  void link(int begin, int end, std::vector<int>& slotOf)
  {
    for (int c = begin; c < end; ++c)
    {
      Crossing& crossing = this->Crossings[c];
      const MeshEdge& edge = this->Neighbours.edges[crossing.edge];
      crossing.v0 = edge.v0;
      crossing.v1 = edge.v1;
      for (const int v : { edge.v0, edge.v1 })
      {
        __builtin_prefetch(this->Model.points[v].data());
        __builtin_prefetch(this->Normals[v].data());
      }
      crossing.firstSlot = static_cast<int>(this->Slots.size());
      const int* triangles = this->Neighbours.edgeTriangles.data() + edge.firstTriangle;
      for (int i = 0; i < edge.triangleCount; ++i)
      {
        // Slot 0 is nobody's: it takes what the first of two has to say, so that nothing need be decided.
        const int slot = static_cast<int>(this->Slots.size()), other = slotOf[triangles[i]];
        this->Slots.push_back({ c, other });
        this->Slots[other].across = slot;
        slotOf[triangles[i]] = other == 0 ? slot : 0;
      }
    }
  }

  double g(int vertex) const
  {
    return this->Normals[vertex].dot(this->Camera.towardsViewer(this->Model.points[vertex]));
  }

  // What lies on the silhouette counts as +, whichever side rounding puts it on.
  bool countsAsPlus(double value) const { return value >= -this->Limit; }

  CurvePoint pointOn(const Crossing& e) const
  {
    const double g0 = this->g(e.v0), g1 = this->g(e.v1);
    const bool firstPlus = this->countsAsPlus(g0);
    CurvePoint p;
    p.binding = (firstPlus ? g0 : g1) <= this->Limit ? Binding::vertex(firstPlus ? e.v0 : e.v1)
                                                     : Binding::edge(e.v0, e.v1, g1 / (g1 - g0));
    p.position = p.binding.of(this->Model.points);
    p.normal = p.binding.of(this->Normals).normalized();
    return p;
  }

  // Follows the crossed edges from one through one of its triangles and appends them, until the curve ends or
  // is back where it started; true for the latter.
  bool walk(int slot, std::vector<int>& chain)
  {
    const int start = this->Slots[slot].crossing;
    while (!this->Slots[slot].visited)
    {
      this->Slots[slot].visited = true;
      slot = this->Slots[slot].across;
      this->Slots[slot].visited = true;
      const int crossing = this->Slots[slot].crossing;
      if (crossing == start)
      {
        return true;
      }
      chain.push_back(crossing);
      if (this->slotCount(crossing) != 2)
      {
        break;
      }
      slot = 2 * this->Crossings[crossing].firstSlot + 1 - slot; // the edge's other triangle
    }
    return false;
  }

  void emit(const std::vector<int>& chain, bool closed, std::vector<Curve>& curves) const
  {
    const auto sameVertex = [](const CurvePoint& a, const CurvePoint& b) {
      return a.binding.onVertex() && b.binding.onVertex() && a.binding.vertices[0] == b.binding.vertices[0];
    };
    Curve curve;
    curve.points.reserve(chain.size());
    for (const int crossing : chain)
    {
      const CurvePoint& p = this->Points[crossing];
      if (curve.points.empty() || !sameVertex(curve.points.back(), p))
      {
        curve.points.push_back(p);
      }
    }
    if (closed && curve.points.size() > 1 && sameVertex(curve.points.front(), curve.points.back()))
    {
      curve.points.pop_back();
    }
    curve.closed = closed && curve.points.size() > 2; // two points go to and fro on one edge
    if (curve.points.size() > 1)
    {
      curves.push_back(std::move(curve));
    }
  }

  const Mesh& Model;
  const Adjacency& Neighbours;
  const std::vector<Vector3>& Normals;
  const View& Camera;
  double Limit = 0.0;              // |g| up to it is on the silhouette
  std::vector<Crossing> Crossings; // by edge
  std::vector<Slot> Slots;
  std::vector<CurvePoint> Points; // of the crossings
};

} // namespace

std::vector<Curve> extractSilhouette(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view)
{
  return Extraction(mesh, adjacency, normals, view).run();
}

} // namespace oversketch
