#include "Section/walk.h"

#include "Mesh/context.h"

#include <algorithm>
#include <limits>

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

// An edge that the plane crosses, its ends and their heights.
struct Crossing
{
  int v0 = -1, v1 = -1; // v0 < v1; -1: none
  double h0 = 0.0, h1 = 0.0;

  bool found() const { return this->v0 >= 0; }
  bool sameEdge(const Crossing& other) const { return this->v0 == other.v0 && this->v1 == other.v1; }
  bool edgeBefore(const Crossing& other) const
  {
    return this->v0 < other.v0 || (this->v0 == other.v0 && this->v1 < other.v1);
  }
  Binding place() const
  {
    if (this->h0 == 0.0 || this->h1 == 0.0)
    {
      return Binding::vertex(this->h0 == 0.0 ? this->v0 : this->v1);
    }
    return Binding::edge(this->v0, this->v1, this->h1 / (this->h1 - this->h0));
  }
};

// Edges that are crossed one after the other, without the one where it began.
struct Way
{
  std::vector<Crossing> edges;
  Ended ended = Ended::Met;
};

struct Walker
{
  const Mesh& surface;
  const Adjacency& links;
  const std::vector<Sectioner::Face>& faces;
  Vector3 origin, normal;

  // None where the plane does not cross the edge.
  Crossing crossing(int edge) const
  {
    const MeshEdge& e = this->links.edges[edge];
    const double h0 = this->height(e.v0), h1 = this->height(e.v1);
    return (h0 >= 0.0) != (h1 >= 0.0) ? Crossing{ e.v0, e.v1, h0, h1 } : Crossing();
  }
  Vector3 pointOf(const Crossing& crossing) const { return crossing.place().of(this->surface.points); }

  // Finds the nearest crossing on an edge round some vertices.
  Crossing crossedNear(const std::vector<int>& vertices, const Vector3& to) const
  {
    Crossing nearest;
    double least = std::numeric_limits<double>::infinity();
    for (const int v : vertices)
    {
      for (const int t : this->links.vertexTriangles[v])
      {
        for (const int e : this->links.triangleEdges[t])
        {
          const Crossing crossed = e < 0 ? Crossing() : this->crossing(e);
          if (!crossed.found())
          {
            continue;
          }
          const double distance = (this->pointOf(crossed) - to).squaredNorm();
          if (distance < least || (distance == least && crossed.edgeBefore(nearest)))
          {
            least = distance;
            nearest = crossed;
          }
        }
      }
    }
    return nearest;
  }

  // A face that is entered is left across one other edge: that between its third corner and the corner of the
  // entry on the other side of the plane.
  struct Exit
  {
    Crossing crossing;
    int beyond;
    bool isBoundary;
  };
  Exit exitOf(int triangle, const Crossing& entry) const
  {
    const Sectioner::Face& face = this->faces[triangle];
    const Triangle& t = face.corners;
    int k = 0;
    while (t[k] == entry.v0 || t[k] == entry.v1)
    {
      ++k;
    }
    const int third = t[k], before = k == 0 ? 2 : k - 1;
    for (const int next : { k, before }) // the next face is one of them; its memory is slow to come
    {
      __builtin_prefetch(this->faces.data() + std::max(face.beyond[next], 0));
    }
    const double height = this->height(third);
    const bool fromFirst = (height >= 0.0) != (entry.h0 >= 0.0);
    const int other = fromFirst ? entry.v0 : entry.v1;
    const double otherHeight = fromFirst ? entry.h0 : entry.h1;
    const int side = t[before] == other ? before : k;
    return { other < third ? Crossing{ other, third, otherHeight, height }
                           : Crossing{ third, other, height, otherHeight },
      face.beyond[side],
      face.isBoundary[side] };
  }

  // Until the exit is what it was to meet.
  template <typename Meets>
  Way follow(const Crossing& from, int triangle, const Meets& meets) const
  {
    Way way;
    Crossing at = from;
    for (;;)
    {
      const Exit exit = this->exitOf(triangle, at);
      at = exit.crossing;
      way.edges.push_back(at);
      if (meets(exit))
      {
        return way;
      }
      if (at.sameEdge(from) || exit.beyond < 0)
      {
        way.ended = at.sameEdge(from)                  ? Ended::Round
                    : exit.beyond == Sectioner::border ? Ended::Border
                                                       : Ended::Branch;
        return way;
      }
      triangle = exit.beyond;
    }
  }

private:
  // Above the plane; what rounding alone keeps off it is on it.
  double height(int vertex) const
  {
    const Vector3 way = this->surface.points[vertex] - this->origin;
    const double above = this->normal.dot(way);
    return above * above <= 1e-24 * way.squaredNorm() ? 0.0 : above;
  }
};

[[noreturn]] void refuseWay(const Way& way, const Message& goal)
{
  const Crossing& e = way.edges.back();
  throw Error(Failure::BadMesh,
    way.ended == Ended::Round
      ? "The cross-section comes back to where it began without meeting %3: slide the plane along the curve."
    : way.ended == Ended::Border ? "The cross-section meets the mesh's border, at the edge of points %1 and "
                                   "%2, before %3: slide the plane "
                                   "along the curve, or draw a boundary within the mesh."
                                 : "The cross-section meets an edge of more than two faces, of points %1 and "
                                   "%2, before %3: repair the mesh "
                                   "there.",
    e.v0,
    e.v1,
    goal);
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
        "Points %1 and %2, which follow each other on {the boundary curve}, are not joined by an edge of the "
        "mesh; insert the curve with its segments.",
        a,
        b);
    }
  }
  return edges;
}

// Edge by edge, as points; where the plane runs through a vertex several edges meet in one point.
Section sectionOf(const Mesh& mesh, const std::vector<Crossing>& edges, const Vector3& normal)
{
  Section section;
  section.normal = normal;
  section.points.reserve(edges.size());
  section.places.reserve(edges.size());
  for (const Crossing& e : edges)
  {
    const Binding place = e.place();
    const Vector3 point = place.of(mesh.points);
    if (section.points.empty() || point != section.points.back())
    {
      section.places.push_back(place);
      section.points.push_back(point);
    }
  }
  return section;
}

// First across the edge that is nearer to the end; then, where that leads nowhere, the other way. triangles:
// of the edge where it begins.
std::vector<Crossing> between(const Walker& walker,
  const Crossing& from,
  const Crossing& to,
  std::vector<int> triangles)
{
  if (from.sameEdge(to))
  {
    return {};
  }
  const Vector3 end = walker.pointOf(to);
  const auto gap = [&](int triangle)
  { return (walker.pointOf(walker.exitOf(triangle, from).crossing) - end).squaredNorm(); };
  std::stable_sort(triangles.begin(), triangles.end(), [&](int a, int b) { return gap(a) < gap(b); });
  Way first;
  for (std::size_t k = 0; k < triangles.size(); ++k)
  {
    Way way = walker.follow(
      from, triangles[k], [&to](const Walker::Exit& exit) { return exit.crossing.sameEdge(to); });
    if (way.ended == Ended::Met)
    {
      way.edges.insert(way.edges.begin(), from);
      return way.edges;
    }
    first = k == 0 ? way : first;
  }
  refuseWay(first, "its other end");
}

// By one plane.
class Cut
{
public:
  Cut(const Mesh& mesh,
    const Adjacency& adjacency,
    const std::vector<int>& boundary,
    const std::vector<Sectioner::Face>& faces,
    const CurveFrame& frame,
    const SectionRules& rules)
    : Surface(mesh)
    , Links(adjacency)
    , Boundary(boundary)
    , Faces(faces)
    , Frame(frame)
    , Rules(rules)
    , Right(rules.right.dot(frame.side) < 0.0 ? Vector3(-frame.side) : frame.side)
    , Across{ mesh, adjacency, faces, frame.origin, frame.along }
  {
  }

  Section run(const Binding& start) const
  {
    const bool outermost = this->Rules.ends == SectionRules::Ends::Outermost;
    std::vector<Crossing> edges = outermost ? this->outermost() : this->nearest(start);
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
      edges = between(this->Across, edges.front(), edges.back(), this->trianglesOf(edges.front()));
    }
    return sectionOf(this->Surface, edges, this->Frame.along);
  }

private:
  std::vector<int> trianglesOf(const Crossing& crossing) const
  {
    const int edge = this->Links.findEdge(crossing.v0, crossing.v1);
    return { this->Links.trianglesBegin(edge), this->Links.trianglesEnd(edge) };
  }

  // From the start to either side as far as the boundary; nothing where there is none.
  std::vector<Crossing> nearest(const Binding& start) const
  {
    const std::vector<int> about(start.vertices.begin(), start.vertices.end());
    const Crossing middle = this->Across.crossedNear(about, this->Frame.origin);
    if (!middle.found())
    {
      throw Error(Failure::BadStroke,
        "The plane does not cut the surface beside {the reference curve}; slide it along the curve, or draw "
        "the curve smoother.");
    }
    const std::vector<int> sides = this->trianglesOf(middle);
    if (sides.size() != 2)
    {
      refuseWay({ { middle }, sides.size() == 1 ? Ended::Border : Ended::Branch }, "{the boundary curve}");
    }
    const auto meets = [](const Walker::Exit& exit) { return exit.isBoundary; };
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
        refuseWay(ways[k], "{the boundary curve}");
      }
    }
    const Vector3 step =
      this->Across.pointOf(ways[1].edges.front()) - this->Across.pointOf(ways[0].edges.front());
    const int left = step.dot(this->Right) > 0.0 ? 0 : 1;
    std::vector<Crossing> edges(ways[left].edges.rbegin(), ways[left].edges.rend());
    edges.push_back(middle);
    edges.insert(edges.end(), ways[1 - left].edges.begin(), ways[1 - left].edges.end());
    return edges;
  }

  // The boundary's edges that are crossed nearest to the middle of the drawn plane's left side, and farthest
  // from it.
  std::vector<Crossing> outermost() const
  {
    const Vector3 left = this->Frame.origin - this->Rules.halfSize * this->Right;
    std::vector<Crossing> ends;
    double least = 0.0, most = 0.0;
    int count = 0;
    for (const int e : this->Boundary)
    {
      const Crossing crossed = this->Across.crossing(e);
      if (crossed.found())
      {
        const double distance = (this->Across.pointOf(crossed) - left).norm();
        ends.resize(2, crossed);
        if (count == 0 || distance < least)
        {
          least = distance;
          ends[0] = crossed;
        }
        if (count == 0 || distance > most)
        {
          most = distance;
          ends[1] = crossed;
        }
        ++count;
      }
    }
    return count < 2 ? std::vector<Crossing>() : ends;
  }

  Section throughCentre(const Crossing& from, const Crossing& to) const
  {
    const Vector3 begin = this->Across.pointOf(from), end = this->Across.pointOf(to);
    const Vector3 normal = (end - begin).cross(this->Rules.centre - begin);
    if (!(normal.norm() > 1e-9 * (end - begin).squaredNorm()))
    {
      throw Error(Failure::BadStroke,
        "The cross-section's ends and the mesh's centre lie on one line, which no plane goes through alone; "
        "walk in the plane across the curve.");
    }
    const Walker walker{ this->Surface, this->Links, this->Faces, begin, normal.normalized() };
    const auto crossed = [&](const Crossing& met) {
      return walker.crossedNear({ met.v0, met.v1 }, this->Across.pointOf(met));
    };
    const Crossing first = crossed(from), last = crossed(to);
    if (!first.found() || !last.found())
    {
      throw Error(Failure::BadStroke,
        "The plane through the cross-section's ends and the mesh's centre does not cut the surface there; "
        "walk in the plane across the curve.");
    }
    return sectionOf(
      this->Surface, between(walker, first, last, this->trianglesOf(first)), normal.normalized());
  }

  const Mesh& Surface;
  const Adjacency& Links;
  const std::vector<int>& Boundary;
  const std::vector<Sectioner::Face>& Faces;
  const CurveFrame& Frame;
  const SectionRules& Rules;
  Vector3 Right;
  Walker Across;
};

} // namespace

Sectioner::Sectioner(const Mesh& mesh, const Adjacency& adjacency, const std::vector<int>& boundary)
  : Surface(mesh)
  , Links(adjacency)
  , Boundary(boundaryEdges(adjacency, boundary))
  , Faces(mesh.triangles.size())
{
  std::vector<char> onBoundary = marksAt(this->Boundary, adjacency.edges.size());
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    this->Faces[t].corners = mesh.triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      const int e = adjacency.triangleEdges[t][k];
      const int count = e < 0 ? 0 : adjacency.edges[e].triangleCount;
      const int* sides = count == 2 ? adjacency.trianglesBegin(e) : nullptr;
      this->Faces[t].beyond[k] = sides ? sides[sides[0] == t ? 1 : 0] : count > 2 ? branch : border;
      this->Faces[t].isBoundary[k] = e >= 0 && onBoundary[e] != 0;
    }
  }
}

Section Sectioner::at(const CurveFrame& frame, const Binding& start, const SectionRules& rules) const
{
  return Cut(this->Surface, this->Links, this->Boundary, this->Faces, frame, rules).run(start);
}

} // namespace oversketch
