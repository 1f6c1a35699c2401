#include "Remesh/curve_walk.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>

namespace oversketch
{

namespace
{

constexpr double touching = 1e-3; // share of an edge: a crossing that near to a curve's vertex meets it

class PlaneWalk
{
public:
  PlaneWalk(const CurveMesh& mesh, int from, int to, const WalkRules& rules)
    : Mesh(mesh)
    , From(from)
    , To(to)
    , Rules(rules)
    , At(mesh.point(from))
    , Here{ from, -1, 0.0 }
    , Heading(rules.start)
  {
    this->Vertices.insert(from);
  }

  std::optional<Way> run()
  {
    Way way;
    while (!this->arrives())
    {
      if (!this->step())
      {
        return std::nullopt;
      }
      way.steps.push_back(this->Here);
      way.length = this->Length;
      if (this->Length > this->Rules.longest)
      {
        return std::nullopt;
      }
    }
    way.length += (this->Mesh.point(this->To) - this->At).norm();
    return way;
  }

private:
  struct Candidate
  {
    WayStep step;
    Vector3 place;
    double score = -2.0; // the cosine between its direction and the one that is wanted
    int through = -1;    // the triangle that is crossed on the way there, none along an edge
  };

  std::vector<int> trianglesHere() const
  {
    std::vector<int> triangles =
      this->Here.b < 0 ? this->Mesh.around(this->Here.a) : this->Mesh.trianglesAt(this->Here.a, this->Here.b);
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

  bool arrives() const
  {
    const std::vector<int> here = this->trianglesHere();
    return std::any_of(
      here.begin(), here.end(), [&](int t) { return cornerOf(this->Mesh.triangle(t), this->To) >= 0; });
  }

  void turnPlane()
  {
    if (this->Rules.fixedPlane && this->Normal.norm() > 0.0)
    {
      return;
    }
    const Vector3 goal = this->Mesh.point(this->To) - this->At;
    const Vector3 normal = goal.cross(this->Rules.direction(this->At).normalized());
    // Seen end-on the plane is none: the one before is kept.
    if (normal.norm() > 0.05 * (this->Mesh.point(this->To) - this->Mesh.point(this->From)).norm())
    {
      this->Normal = normal.normalized();
    }
    this->Anchor = this->At;
  }

  double side(int v) const { return this->Normal.dot(this->Mesh.point(v) - this->Anchor); }

  bool barred(int v) const { return this->Rules.avoidCurves && this->Mesh.onCurve(v); }

  // A way that met itself inside a triangle, or on an edge that it runs along, could not be made edges.
  void consider(const WayStep& step, int t, Candidate& best) const
  {
    const bool alongEdge =
      step.b < 0 && (this->Here.b < 0 || step.a == this->Here.a || step.a == this->Here.b);
    if (alongEdge ? this->Here.b < 0 && this->Edges.count(std::minmax(this->Here.a, step.a)) > 0
                  : this->Crossed.count(t) > 0)
    {
      return;
    }
    const Vector3 place =
      step.b < 0 ? this->Mesh.point(step.a)
                 : Vector3((1.0 - step.s) * this->Mesh.point(step.a) + step.s * this->Mesh.point(step.b));
    const Vector3 wanted =
      this->Rules.start.isZero() ? Vector3(this->Mesh.point(this->To) - this->At) : this->Heading;
    const double score = (place - this->At).normalized().dot(wanted.normalized());
    if (score > best.score)
    {
      best = { step, place, score, alongEdge ? -1 : t };
    }
  }

  // The place where the plane crosses an edge, as a vertex where it is near enough to one.
  void considerEdge(int a, int b, int t, Candidate& best) const
  {
    const double sa = this->side(a), sb = this->side(b);
    if (sa * sb > 0.0 || (sa == 0.0 && sb == 0.0))
    {
      return;
    }
    const double s = sa / (sa - sb);
    const bool nearA = s < 0.5;
    const int end = nearA ? a : b;
    const double share = nearA ? s : 1.0 - s;
    const double away = share * (this->Mesh.point(a) - this->Mesh.point(b)).norm();
    const bool snaps = share < touching || (share < this->Rules.snap && away <= this->Rules.snapLength &&
                                             !this->Mesh.onCurve(end));
    if (snaps)
    {
      if (this->Vertices.count(end) == 0 && !this->barred(end))
      {
        this->consider({ end, -1, 0.0 }, t, best);
      }
    }
    else if (this->Edges.count(std::minmax(a, b)) == 0 &&
             !(this->Rules.avoidCurves && this->Mesh.curveEdge(a, b)))
    {
      this->consider({ a, b, s }, t, best);
    }
  }

  bool step()
  {
    this->turnPlane();
    if (this->Normal.isZero())
    {
      return false;
    }
    Candidate best;
    for (const int t : this->trianglesHere())
    {
      const Triangle& corners = this->Mesh.triangle(t);
      for (int k = 0; k < 3 && t != this->Entered; ++k)
      {
        const int a = corners[k], b = corners[(k + 1) % 3];
        const bool touches = this->Here.b < 0 ? a == this->Here.a || b == this->Here.a
                                              : std::minmax(a, b) == std::minmax(this->Here.a, this->Here.b);
        if (!touches)
        {
          this->considerEdge(a, b, t, best);
        }
      }
    }
    if (best.score < -1.5)
    {
      return false;
    }
    this->Entered = -1;
    if (best.step.b < 0)
    {
      this->Vertices.insert(best.step.a);
      if (this->Here.b < 0)
      {
        this->Edges.insert(std::minmax(this->Here.a, best.step.a));
      }
    }
    else
    {
      this->Edges.insert(std::minmax(best.step.a, best.step.b));
      this->Entered = this->between(this->Here, best.step);
    }
    if (best.through >= 0)
    {
      this->Crossed.insert(best.through);
    }
    else if (this->Here.b >=
             0) // the place on the edge cuts the triangle beyond it, too, which is not entered
    {
      for (const int t : this->Mesh.trianglesAt(this->Here.a, this->Here.b))
      {
        this->Crossed.insert(t);
      }
    }
    this->Length += (best.place - this->At).norm();
    this->Heading = best.place - this->At;
    this->At = best.place;
    this->Here = best.step;
    return true;
  }

  // The triangle that holds both places.
  int between(const WayStep& one, const WayStep& other) const
  {
    for (const int t : this->Mesh.trianglesAt(other.a, other.b))
    {
      const auto has = [&](int v) { return cornerOf(this->Mesh.triangle(t), v) >= 0; };
      if (has(one.a) && (one.b < 0 || has(one.b)))
      {
        return t;
      }
    }
    return -1;
  }

  const CurveMesh& Mesh;
  const int From, To;
  const WalkRules& Rules;
  Vector3 At;
  WayStep Here;
  Vector3 Heading;
  Vector3 Normal = Vector3::Zero(), Anchor = Vector3::Zero();
  int Entered = -1; // through which triangle an edge was reached
  double Length = 0.0;
  std::set<int> Vertices, Crossed;     // triangles are crossed
  std::set<std::pair<int, int>> Edges; // that are crossed or run along
};

} // namespace

std::optional<Way> walkPlane(const CurveMesh& mesh, int from, int to, const WalkRules& rules)
{
  return PlaneWalk(mesh, from, to, rules).run();
}

std::optional<Way> walkEdges(const CurveMesh& mesh, int from, int to, double longest)
{
  struct Reached
  {
    double length;
    int before;
    bool done = false;
  };
  std::unordered_map<int, Reached> reached{ { from, { 0.0, -1 } } };
  using Entry = std::pair<double, int>; // length so far and the least that is left; ties by number
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  const Vector3& goal = mesh.point(to);
  open.emplace((goal - mesh.point(from)).norm(), from);
  while (!open.empty())
  {
    const int v = open.top().second;
    open.pop();
    if (reached.at(v).done)
    {
      continue;
    }
    reached.at(v).done = true;
    if (v == to)
    {
      Way way;
      way.length = reached.at(v).length;
      for (int w = reached.at(v).before; w != from; w = reached.at(w).before)
      {
        way.steps.push_back({ w, -1, 0.0 });
      }
      std::reverse(way.steps.begin(), way.steps.end());
      return way;
    }
    for (const int w : mesh.neighbours(v))
    {
      const double length = reached.at(v).length + (mesh.point(w) - mesh.point(v)).norm();
      const double least = length + (goal - mesh.point(w)).norm();
      const auto known = reached.find(w);
      if ((w != to && mesh.onCurve(w)) || least > longest ||
          (known != reached.end() && known->second.length <= length))
      {
        continue;
      }
      reached[w] = { length, v };
      open.emplace(least, w);
    }
  }
  return std::nullopt;
}

namespace
{

std::vector<int> alongBorder(const CurveMesh& mesh, int v)
{
  std::vector<int> found = mesh.neighbours(v);
  const auto isInner = [&](int w) { return mesh.trianglesAt(v, w).size() != 1; };
  found.erase(std::remove_if(found.begin(), found.end(), isInner), found.end());
  return found;
}

// The vertex itself where it is on the border, or its nearest neighbour that is; -1 where none is.
int nearestOnBorder(const CurveMesh& mesh, int v)
{
  if (!alongBorder(mesh, v).empty())
  {
    return v;
  }
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (const int w : mesh.neighbours(v))
  {
    const double away = (mesh.point(w) - mesh.point(v)).norm();
    if (away < least && !mesh.onCurve(w) && !alongBorder(mesh, w).empty())
    {
      nearest = w;
      least = away;
    }
  }
  return nearest;
}

} // namespace

std::optional<Way> walkBorder(const CurveMesh& mesh, int from, int to, double longest)
{
  const int begin = nearestOnBorder(mesh, from), end = nearestOnBorder(mesh, to);
  if (begin < 0 || end < 0 || begin == end)
  {
    return std::nullopt;
  }
  std::optional<Way> shortest;
  for (const int first : alongBorder(mesh, begin))
  {
    Way way;
    const auto isFree = [&](int v) { return v == from || v == to || !mesh.onCurve(v); };
    const auto goOn = [&](int v, int before)
    {
      way.length += (mesh.point(v) - mesh.point(before)).norm();
      if (v != to)
      {
        way.steps.push_back({ v, -1, 0.0 });
      }
    };
    if (begin != from)
    {
      goOn(begin, from);
    }
    int before = begin, at = first;
    while (at != end && isFree(at) && way.length <= longest)
    {
      goOn(at, before);
      const std::vector<int> next = alongBorder(mesh, at);
      if (next.size() != 2) // where borders touch
      {
        break;
      }
      before = std::exchange(at, next[0] == before ? next[1] : next[0]);
    }
    if (at != end)
    {
      continue;
    }
    goOn(end, before);
    if (end != to)
    {
      way.length += (mesh.point(to) - mesh.point(end)).norm();
    }
    if (way.length <= longest)
    {
      longest = way.length;
      shortest = way;
    }
  }
  return shortest;
}

std::vector<int> makeWay(CurveMesh& mesh, const Way& way)
{
  std::vector<int> vertices;
  for (const WayStep& step : way.steps)
  {
    vertices.push_back(step.b < 0 ? step.a : mesh.splitEdge(step.a, step.b, step.s));
  }
  return vertices;
}

} // namespace oversketch
