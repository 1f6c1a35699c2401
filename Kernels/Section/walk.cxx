#include "Section/walk.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <unordered_set>

namespace oversketch
{
namespace
{

enum class Ended
{
  Met,    // what it was to meet
  Round,  // back where it began
  Border, // the mesh ends
  Branch  // three faces or more at an edge
};

// Edges that are crossed one after the other, without the one where it began.
struct Way
{
  std::vector<int> edges;
  Ended ended = Ended::Met;
};

class Walker
{
public:
  Walker(const Mesh& mesh, const Adjacency& adjacency, const Vector3& origin, const Vector3& normal)
    : Surface(mesh)
    , Links(adjacency)
    , Origin(origin)
    , Normal(normal)
  {
  }

  // Above the plane; what rounding alone keeps off it is on it.
  double height(int vertex) const
  {
    const Vector3 way = this->Surface.points[vertex] - this->Origin;
    const double above = this->Normal.dot(way);
    return above * above <= 1e-24 * way.squaredNorm() ? 0.0 : above;
  }
  bool crosses(int edge) const
  {
    const MeshEdge& e = this->Links.edges[edge];
    return (this->height(e.v0) >= 0.0) != (this->height(e.v1) >= 0.0);
  }
  Binding placeOn(int edge) const
  {
    const MeshEdge& e = this->Links.edges[edge];
    const double h0 = this->height(e.v0), h1 = this->height(e.v1);
    if (h0 == 0.0 || h1 == 0.0)
    {
      return Binding::vertex(h0 == 0.0 ? e.v0 : e.v1);
    }
    return Binding::edge(e.v0, e.v1, h1 / (h1 - h0));
  }
  Vector3 pointOn(int edge) const { return this->placeOn(edge).of(this->Surface.points); }

  // Of the edges round some vertices that are crossed, the one whose crossing is nearest; -1 for none.
  int crossedNear(const std::vector<int>& vertices, const Vector3& to) const
  {
    int nearest = -1;
    double least = std::numeric_limits<double>::infinity();
    for (const int v : vertices)
    {
      for (const int* t = this->Links.vertexTriangles.begin(v); t != this->Links.vertexTriangles.end(v); ++t)
      {
        for (const int e : this->Links.triangleEdges[*t])
        {
          if (e < 0 || !this->crosses(e))
          {
            continue;
          }
          const double distance = (this->pointOn(e) - to).squaredNorm();
          if (distance < least || (distance == least && e < nearest))
          {
            least = distance;
            nearest = e;
          }
        }
      }
    }
    return nearest;
  }

  // A face that is entered is left across one other edge.
  int exitOf(int triangle, int entry) const
  {
    for (const int e : this->Links.triangleEdges[triangle])
    {
      if (e != entry && this->crosses(e))
      {
        return e;
      }
    }
    return entry; // not reached: a plane crosses two edges of a face or none
  }

  template <typename Meets>
  Way follow(int edge, int triangle, const Meets& meets) const
  {
    Way way;
    int at = edge;
    for (;;)
    {
      at = this->exitOf(triangle, at);
      way.edges.push_back(at);
      const MeshEdge& e = this->Links.edges[at];
      if (meets(at))
      {
        return way;
      }
      if (at == edge || e.triangleCount != 2)
      {
        way.ended = at == edge ? Ended::Round : e.triangleCount == 1 ? Ended::Border : Ended::Branch;
        return way;
      }
      const int* sides = this->Links.trianglesBegin(at);
      triangle = sides[sides[0] == triangle ? 1 : 0];
    }
  }

private:
  const Mesh& Surface;
  const Adjacency& Links;
  Vector3 Origin, Normal;
};

[[noreturn]] void refuseWay(const Adjacency& adjacency, const Way& way, const char* goal)
{
  const MeshEdge& e = adjacency.edges[way.edges.back()];
  const std::string edge = std::to_string(e.v0) + " and " + std::to_string(e.v1);
  throw Error(Failure::BadMesh,
    way.ended == Ended::Round
      ? std::string("The cross-section comes back to where it began without meeting ") + goal +
          ": slide the plane along the curve."
    : way.ended == Ended::Border
      ? "The cross-section meets the mesh's border, at the edge of points " + edge + ", before " + goal +
          ": slide the plane along the curve, or draw a boundary within the mesh."
      : "The cross-section meets an edge of more than two faces, of points " + edge + ", before " + goal +
          ": repair the mesh there.");
}

std::vector<int> boundaryEdges(const Adjacency& adjacency, const std::vector<int>& boundary)
{
  std::vector<int> edges;
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    const int a = boundary[i], b = boundary[(i + 1) % boundary.size()];
    edges.push_back(a == b ? -1 : adjacency.findEdge(a, b));
    if (edges.back() < 0)
    {
      throw Error(Failure::BadStroke,
        "Points " + std::to_string(a) + " and " + std::to_string(b) +
          ", which follow each other on the boundary curve, are not joined by an edge of the mesh; insert "
          "the curve with its segments.");
    }
  }
  return edges;
}

// Edge by edge, as points; where the plane runs through a vertex several edges meet in one point.
Section sectionOf(const Walker& walker, const Mesh& mesh, const std::vector<int>& edges)
{
  Section section;
  for (const int e : edges)
  {
    const Binding place = walker.placeOn(e);
    const Vector3 point = place.of(mesh.points);
    if (section.points.empty() || point != section.points.back())
    {
      section.places.push_back(place);
      section.points.push_back(point);
    }
  }
  return section;
}

class Sectioner
{
public:
  Sectioner(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<int>& boundary,
    const CurveFrame& frame,
    const SectionRules& rules)
    : Surface(mesh)
    , Links(adjacency)
    , Frame(frame)
    , Rules(rules)
    , Right(rules.right.dot(frame.side) < 0.0 ? Vector3(-frame.side) : frame.side)
    , Boundary(boundaryEdges(adjacency, boundary))
    , OnBoundary(this->Boundary.begin(), this->Boundary.end())
    , Across(mesh, adjacency, frame.origin, frame.along)
  {
  }

  Section run(const Binding& start) const
  {
    const bool outermost = this->Rules.ends == SectionRules::Ends::Outermost;
    std::vector<int> edges = outermost ? this->outermost() : this->nearest(start);
    if (edges.empty())
    {
      return {};
    }
    if (this->Rules.plane == SectionRules::Plane::Centre)
    {
      return this->throughCentre(edges.front(), edges.back());
    }
    if (outermost)
    {
      edges = this->between(this->Across, edges.front(), edges.back());
    }
    Section section = sectionOf(this->Across, this->Surface, edges);
    section.normal = this->Frame.along;
    return section;
  }

private:
  // From the start to either side as far as the boundary; nothing where there is none.
  std::vector<int> nearest(const Binding& start) const
  {
    const std::vector<int> about(start.vertices.begin(), start.vertices.end());
    const int middle = this->Across.crossedNear(about, this->Frame.origin);
    if (middle < 0)
    {
      throw Error(Failure::BadStroke,
        "The plane does not cut the surface beside the reference curve; slide it along the curve, or draw "
        "the curve smoother.");
    }
    const MeshEdge& e = this->Links.edges[middle];
    if (e.triangleCount != 2)
    {
      refuseWay(this->Links,
        { { middle }, e.triangleCount == 1 ? Ended::Border : Ended::Branch },
        "the boundary curve");
    }
    const auto meets = [this](int edge) { return this->OnBoundary.count(edge) > 0; };
    const int* sides = this->Links.trianglesBegin(middle);
    Way ways[2];
    for (int k = 0; k < 2; ++k)
    {
      ways[k] = this->Across.follow(middle, sides[k], meets);
      if (ways[k].ended == Ended::Round)
      {
        return {};
      }
      if (ways[k].ended != Ended::Met)
      {
        refuseWay(this->Links, ways[k], "the boundary curve");
      }
    }
    const Vector3 step =
      this->Across.pointOn(ways[1].edges.front()) - this->Across.pointOn(ways[0].edges.front());
    const int left = step.dot(this->Right) > 0.0 ? 0 : 1;
    std::vector<int> edges(ways[left].edges.rbegin(), ways[left].edges.rend());
    edges.push_back(middle);
    edges.insert(edges.end(), ways[1 - left].edges.begin(), ways[1 - left].edges.end());
    return edges;
  }

  // The boundary's edges that are crossed nearest to the middle of the drawn plane's left side, and farthest
  // from it.
  std::vector<int> outermost() const
  {
    const Vector3 left = this->Frame.origin - this->Rules.halfSize * this->Right;
    std::vector<int> ends;
    double least = 0.0, most = 0.0;
    int count = 0;
    for (const int e : this->Boundary)
    {
      if (this->Across.crosses(e))
      {
        const double distance = (this->Across.pointOn(e) - left).norm();
        ends.resize(2, e);
        if (count == 0 || distance < least)
        {
          least = distance;
          ends[0] = e;
        }
        if (count == 0 || distance > most)
        {
          most = distance;
          ends[1] = e;
        }
        ++count;
      }
    }
    return count < 2 ? std::vector<int>() : ends;
  }

  // First across the edge that is nearer to the end; then, where that leads nowhere, the other way.
  std::vector<int> between(const Walker& walker, int from, int to) const
  {
    if (from == to)
    {
      return {};
    }
    const Vector3 end = walker.pointOn(to);
    const MeshEdge& e = this->Links.edges[from];
    std::vector<int> triangles(
      this->Links.trianglesBegin(from), this->Links.trianglesBegin(from) + e.triangleCount);
    const auto gap = [&](int triangle)
    { return (walker.pointOn(walker.exitOf(triangle, from)) - end).squaredNorm(); };
    std::stable_sort(triangles.begin(), triangles.end(), [&](int a, int b) { return gap(a) < gap(b); });
    Way first;
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
      Way way = walker.follow(from, triangles[k], [to](int edge) { return edge == to; });
      if (way.ended == Ended::Met)
      {
        way.edges.insert(way.edges.begin(), from);
        return way.edges;
      }
      first = k == 0 ? way : first;
    }
    refuseWay(this->Links, first, "its other end");
  }

  Section throughCentre(int from, int to) const
  {
    const Vector3 begin = this->Across.pointOn(from), end = this->Across.pointOn(to);
    const Vector3 normal = (end - begin).cross(this->Rules.centre - begin);
    if (!(normal.norm() > 1e-9 * (end - begin).squaredNorm()))
    {
      throw Error(Failure::BadStroke,
        "The cross-section's ends and the mesh's centre lie on one line, which no plane goes through alone; "
        "walk in the plane across the curve.");
    }
    const Walker walker(this->Surface, this->Links, begin, normal.normalized());
    const auto crossed = [&](int edge)
    {
      const MeshEdge& e = this->Links.edges[edge];
      return walker.crossedNear({ e.v0, e.v1 }, this->Across.pointOn(edge));
    };
    const int first = crossed(from), last = crossed(to);
    if (first < 0 || last < 0)
    {
      throw Error(Failure::BadStroke,
        "The plane through the cross-section's ends and the mesh's centre does not cut the surface there; "
        "walk in the plane across the curve.");
    }
    Section section = sectionOf(walker, this->Surface, this->between(walker, first, last));
    section.normal = normal.normalized();
    return section;
  }

  const Mesh& Surface;
  const Adjacency& Links;
  const CurveFrame& Frame;
  const SectionRules& Rules;
  Vector3 Right;
  std::vector<int> Boundary;
  std::unordered_set<int> OnBoundary;
  Walker Across;
};

} // namespace

Section crossSection(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<int>& boundary,
  const CurveFrame& frame,
  const Binding& start,
  const SectionRules& rules)
{
  return Sectioner(mesh, adjacency, boundary, frame, rules).run(start);
}

} // namespace oversketch
