#include "Silhouette/snake.h"

#include "Silhouette/bend.h"
#include "Silhouette/edge_smoothness.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <iterator>
#include <list>
#include <map>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr double splitBend = 0.01; // [rad] a vertex snaxel that bends by more is split
constexpr int sweepLimit = 200;
constexpr int splitLimit = 1 + 5;     // of one vertex: split and conversion can alternate for ever
constexpr double splitDistance = 0.2; // of the spoke, halved until E_geo allows it
constexpr int halvingLimit = 40;
constexpr int intervals = 32; // of an edge, where the limit on E_geo is looked for
constexpr int bisections = 30;
constexpr double endTolerance = 1e-6; // of an edge: nearer to its end is on the vertex

struct Snaxel : CurvePoint
{
  explicit Snaxel(const CurvePoint& p)
    : CurvePoint(p)
  {
  }

  // Something about it or a neighbour has changed since it was last looked at. Looking again at one that is
  // not stale would find what it found then, so a sweep passes over it.
  bool stale = true;
  // It and its neighbours are known not to lie in one triangle. Relocation along an edge does not change
  // that.
  bool apart = false;
  // Of an edge snaxel, once known: the part of its edge that it can reach with E_geo < epsilon, and the
  // edge's ends and their normals, together where the sweeps come by.
  double low = 1.0, high = 0.0;
  Vector3 ends[2] = { Vector3::Zero(), Vector3::Zero() },
          endNormals[2] = { Vector3::Zero(), Vector3::Zero() };
};

// The vertices that hold up a point, each once.
struct Support
{
  int vertices[9];
  int count = 0;
  void add(const Binding& binding)
  {
    for (int v : binding.vertices)
    {
      if (!this->holds(v))
      {
        this->vertices[this->count++] = v;
      }
    }
  }
  bool holds(int v) const
  {
    return std::find(this->vertices, this->vertices + this->count, v) != this->vertices + this->count;
  }
};

// The neighbours of a vertex in order round it, as far as they can be reached over edges of two triangles.
// Places in it are numbered: 2k is the spoke to link[k], 2k + 1 lies between the spokes k and k + 1.
struct Fan
{
  int centre;
  std::vector<int> link;
  bool closed = false;

  int places() const { return 2 * static_cast<int>(this->link.size()); }

  int placeOf(const Binding& binding) const
  {
    Support support;
    support.add(binding);
    const int m = static_cast<int>(this->link.size());
    const int wanted = support.count - (support.holds(this->centre) ? 1 : 0);
    for (int k = 0; k < m; ++k)
    {
      if (wanted == 1 && support.holds(this->link[k]))
      {
        return 2 * k;
      }
      if (wanted == 2 && (this->closed || k + 1 < m) && support.holds(this->link[k]) &&
          support.holds(this->link[(k + 1) % m]))
      {
        return 2 * k + 1;
      }
    }
    return -1;
  }
};

class Snake
{
public:
  Snake(const Curve& curve,
    const Mesh& surface,
    const Adjacency& neighbours,
    const std::vector<Vector3>& vertexNormals,
    const View& eye,
    double limit)
    : mesh(surface)
    , adjacency(neighbours)
    , normals(vertexNormals)
    , view(eye)
    , epsilon(limit)
    , closed(curve.closed)
  {
    for (const CurvePoint& p : curve.points)
    {
      this->snaxels.emplace_back(p);
    }
  }

  Curve run(const Context& context)
  {
    for (int sweep = 0; sweep < sweepLimit && this->sweepOnce(false) && !context.cancelled(); ++sweep)
    {
    }
    // Only after the last allowed sweep is there anything left to remove.
    for (Snaxel& s : this->snaxels)
    {
      s.stale = true;
    }
    while (this->sweepOnce(true))
    {
    }
    return { std::vector<CurvePoint>(this->snaxels.begin(), this->snaxels.end()), this->closed };
  }

private:
  using Place = std::list<Snaxel>::iterator;

  Snaxel& before(Place s) { return s == this->snaxels.begin() ? this->snaxels.back() : *std::prev(s); }
  Snaxel& after(Place s)
  {
    const Place next = std::next(s);
    return next == this->snaxels.end() ? this->snaxels.front() : *next;
  }

  // Looks at every stale snaxel but fixed ends once; false when nothing changed.
  bool sweepOnce(bool removeOnly)
  {
    bool changed = false;
    if (this->snaxels.size() < 3)
    {
      return false;
    }
    Place s = this->closed ? this->snaxels.begin() : std::next(this->snaxels.begin());
    while (s != this->snaxels.end() && (this->closed || std::next(s) != this->snaxels.end()))
    {
      if (!s->stale)
      {
        ++s;
        continue;
      }
      s->stale = false;
      Snaxel& previous = this->before(s);
      Snaxel& next = this->after(s);
      if (!s->apart && this->inOneTriangle(previous, *s, next))
      {
        s = this->snaxels.erase(s);
        previous.stale = next.stale = changed = true;
        previous.apart = next.apart = false;
        if (this->closed && this->snaxels.size() < 3)
        {
          this->snaxels.clear();
          return true;
        }
        continue; // with the follower of what was removed
      }
      s->apart = true;
      const bool splitting = !removeOnly && s->binding.onVertex();
      if (splitting ? this->split(s, previous, next) : !removeOnly && this->relocate(*s, previous, next))
      {
        previous.stale = next.stale = changed = true;
        if (s->binding.onVertex() || splitting)
        {
          previous.apart = next.apart = s->apart = false;
        }
        if (splitting)
        {
          continue; // with the first of the new snaxels
        }
      }
      ++s;
    }
    return changed;
  }

  CurvePoint pointAt(const Binding& binding) const
  {
    return { binding, binding.of(this->mesh.points), binding.of(this->normals).normalized() };
  }

  bool inOneTriangle(const Snaxel& a, const Snaxel& b, const Snaxel& c) const
  {
    Support support;
    support.add(a.binding);
    support.add(b.binding);
    support.add(c.binding);
    return support.count < 3 || (support.count == 3 && this->triangleWith(support) >= 0);
  }

  int triangleWith(const Support& support) const
  {
    const Lists& lists = this->adjacency.vertexTriangles;
    for (const int* t = lists.begin(support.vertices[0]); t != lists.end(support.vertices[0]); ++t)
    {
      const Triangle& corners = this->mesh.triangles[*t];
      if (std::all_of(support.vertices,
            support.vertices + support.count,
            [&](int v) { return v == corners[0] || v == corners[1] || v == corners[2]; }))
      {
        return *t;
      }
    }
    return -1;
  }

  // Puts the triangle's neighbours across its spoke to `to` at the end of link; true when the walk comes back
  // to it.
  bool walkFan(int centre, int triangle, int to, std::vector<int>& link) const
  {
    const int first = triangle;
    for (int steps = this->adjacency.vertexTriangles.size(centre); steps > 0; --steps)
    {
      const int spoke = this->adjacency.findEdge(centre, to);
      if (spoke < 0 || this->adjacency.edges[spoke].triangleCount != 2)
      {
        return false;
      }
      const int* sides = this->adjacency.trianglesBegin(spoke);
      triangle = sides[0] == triangle ? sides[1] : sides[0];
      if (triangle == first)
      {
        link.pop_back(); // the neighbour that the walk began with, met again
        return true;
      }
      for (int v : this->mesh.triangles[triangle])
      {
        if (v != centre && v != to)
        {
          to = v;
          break;
        }
      }
      link.push_back(to);
    }
    return false;
  }

  Fan fanOf(int centre, int triangle) const
  {
    const Triangle& corners = this->mesh.triangles[triangle];
    const int k = static_cast<int>(std::find(corners.begin(), corners.end(), centre) - corners.begin());
    const int a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
    Fan fan{ centre, { a, b }, false };
    fan.closed = this->walkFan(centre, triangle, b, fan.link);
    if (!fan.closed)
    {
      std::vector<int> other;
      this->walkFan(centre, triangle, a, other);
      fan.link.insert(fan.link.begin(), other.rbegin(), other.rend());
    }
    return fan;
  }

  // Replaces a bent vertex snaxel by edge snaxels on the spokes that the curve crosses on the side of the
  // smaller angle, so that the curve shortens; s is then the first of them. False where it stays.
  bool split(Place& s, const Snaxel& previous, const Snaxel& next)
  {
    const int centre = s->binding.vertices[0];
    int& splits = this->splitCount[centre];
    if (splits >= splitLimit || smoothness(previous, *s, next) >= straight - splitBend)
    {
      return false;
    }
    Support support;
    support.add(s->binding);
    support.add(previous.binding);
    const int triangle = this->triangleWith(support);
    if (triangle < 0)
    {
      return false;
    }
    const Fan fan = this->fanOf(centre, triangle);
    const int from = fan.placeOf(previous.binding);
    const int to = fan.placeOf(next.binding);
    if (from < 0 || to < 0 || from == to)
    {
      return false;
    }
    std::vector<int> best;
    double bestAngle = 0.0;
    for (const int step : { 1, -1 })
    {
      if (!fan.closed && (to > from) != (step > 0))
      {
        continue;
      }
      std::vector<int> spokes;
      double angle = 0.0;
      Vector3 direction = previous.position - s->position;
      const auto turn = [&](const Vector3& position)
      {
        const Vector3 following = position - s->position;
        angle += angleBetween(direction, following);
        direction = following;
      };
      for (int place = (from + step + fan.places()) % fan.places(); place != to;
           place = (place + step + fan.places()) % fan.places())
      {
        if (place % 2 == 0)
        {
          spokes.push_back(fan.link[place / 2]);
          turn(this->mesh.points[spokes.back()]);
        }
      }
      turn(next.position);
      if (best.empty() || (!spokes.empty() && angle < bestAngle))
      {
        best = spokes;
        bestAngle = angle;
      }
    }
    std::list<Snaxel> made;
    for (int end : best)
    {
      made.emplace_back(this->pointNear(centre, end));
      if (made.back().binding.onVertex())
      {
        return false;
      }
    }
    if (made.empty())
    {
      return false;
    }
    ++splits;
    const Place firstMade = made.begin();
    this->snaxels.splice(s, made);
    this->snaxels.erase(s);
    s = firstMade;
    return true;
  }

  // The edge point at splitDistance from the centre towards a neighbour, or nearer, with E_geo < epsilon; the
  // centre itself where there is none.
  CurvePoint pointNear(int centre, int end) const
  {
    double t = splitDistance;
    for (int halving = 0; halving < halvingLimit; ++halving, t *= 0.5)
    {
      CurvePoint p =
        this->pointAt(centre < end ? Binding::edge(centre, end, 1.0 - t) : Binding::edge(end, centre, t));
      if (silhouetteDeviation(p, this->view) < this->epsilon)
      {
        return p;
      }
    }
    return this->pointAt(Binding::vertex(centre));
  }

  // Moves an edge snaxel to the straightest place of the feasible interval it is in; on a vertex it turns
  // stale.
  bool relocate(Snaxel& s, const Snaxel& previous, const Snaxel& next)
  {
    const int v0 = s.binding.vertices[0], v1 = s.binding.vertices[1];
    if (s.binding.weights[2] != 0.0)
    {
      return false;
    }
    const double present = s.binding.weights[1];
    if (s.low > s.high && !this->measure(s, present))
    {
      return false;
    }
    const Bend bend(previous, s, next);
    if (!bend.matters())
    {
      return false;
    }
    const double low = s.low, high = s.high;
    const Triple p0(s.ends[0]), p1(s.ends[1]), n0(s.endNormals[0]), n1(s.endNormals[1]);
    const Triple before(previous.position), after(next.position);
    const Triple a = before - p0, b = after - p0, e = p1 - p0, dn = n1 - n0;
    const std::array<double, 2> places = straightPlaces(a, b, e, n0, dn);
    // A whole edge may be free to its end, or the limit may lie just short of it.
    const auto toFirst = [&](double t) { return low == 0.0 && t < endTolerance; };
    const auto toSecond = [&](double t) { return high == 1.0 && t > 1.0 - endTolerance; };
    // As pointAt computes it, term by term.
    struct EdgePoint
    {
      double w0, w1;
      Triple position, normal;
      double squared; // length of the normal before
    };
    const auto edgePoint = [&](double t)
    {
      const double w0 = 1.0 - t, w1 = 1.0 - w0;
      const Triple normal = w0 * n0 + w1 * n1 + 0.0 * n0;
      const double squared = normal.dot(normal), length = squared > 0.0 ? std::sqrt(squared) : 1.0;
      return EdgePoint{ w0,
        w1,
        w0 * p0 + w1 * p1 + 0.0 * p0,
        { normal.x / length, normal.y / length, normal.z / length },
        squared };
    };
    const auto accept = [&](const EdgePoint& p, const Bend& left)
    {
      if (!this->nearContour(p.position, p.normal) || !bend.matters(left))
      {
        return false;
      }
      s.binding.weights = { p.w0, p.w1, 0.0 };
      s.position = { p.position.x, p.position.y, p.position.z };
      s.normal = { p.normal.x, p.normal.y, p.normal.z };
      s.stale = false;
      return true;
    };
    // Mostly one of the places is in reach, and often the curve is straight there without doubt.
    const bool firstInReach = places[0] >= low && places[0] <= high,
               secondInReach = places[1] >= low && places[1] <= high;
    const bool one = firstInReach != secondInReach;
    const double place = firstInReach ? places[0] : places[1];
    if (one && !toFirst(place) && !toSecond(place))
    {
      const EdgePoint p = edgePoint(place);
      const Bend left(before, p.position, p.normal, after);
      const double squaredStep = place * place * e.dot(e);
      if ((p.squared > 0.25 && left.isNone(a.dot(a) + squaredStep, b.dot(b) + squaredStep)) ||
          EdgeSmoothness(a, b, e, n0, dn).isStraight(place))
      {
        return accept(p, left);
      }
    }
    const EdgeSmoothness energy(a, b, e, n0, dn);
    double best = one && energy.isStraight(place) ? place
                  : firstInReach && secondInReach ? energy.straightPlace(places, present)
                                                  : -1.0;
    if (best < 0.0)
    {
      best = searchStraightest(energy, low, high);
    }
    if (!toFirst(best) && !toSecond(best))
    {
      const EdgePoint p = edgePoint(best);
      return accept(p, Bend(before, p.position, p.normal, after));
    }
    const CurvePoint moved = this->pointAt(Binding::vertex(toFirst(best) ? v0 : v1));
    if (!this->nearContour(Triple(moved.position), Triple(moved.normal)) ||
        !bend.matters(Bend(previous, moved, next)))
    {
      return false;
    }
    static_cast<CurvePoint&>(s) = moved;
    s.stale = true;
    return true;
  }

  // E_geo < epsilon; only near the limit does it take E_geo itself to know.
  bool nearContour(const Triple& position, const Triple& normal) const
  {
    constexpr double margin = 1e-9;
    const Vector3 place(position.x, position.y, position.z);
    const Triple d(this->view.towardsViewer(place));
    const double across = d.dot(normal), most = this->epsilon * this->epsilon * d.dot(d);
    if (across * across < most * (1.0 - margin))
    {
      return true;
    }
    const CurvePoint p{ Binding(), place, { normal.x, normal.y, normal.z } };
    return across * across <= most * (1.0 + margin) && silhouetteDeviation(p, this->view) < this->epsilon;
  }

  // Finds the part [low, high] round t of a snaxel's edge where E_geo < epsilon; false when t itself is not
  // in it.
  bool measure(Snaxel& s, double t) const
  {
    const int v0 = s.binding.vertices[0], v1 = s.binding.vertices[1];
    s.ends[0] = this->mesh.points[v0];
    s.ends[1] = this->mesh.points[v1];
    s.endNormals[0] = this->normals[v0];
    s.endNormals[1] = this->normals[v1];
    const Triple d0(this->view.towardsViewer(s.ends[0]));
    const Triple dd = Triple(this->view.towardsViewer(s.ends[1])) - d0;
    const Triple n0(s.endNormals[0]);
    const Triple dn = Triple(s.endNormals[1]) - n0;
    const Quadratic nd = product(n0, dn, d0, dd), nn = product(n0, dn, n0, dn),
                    lengths = product(d0, dd, d0, dd);
    const auto allowed = [&](double place)
    { return nd(place) * nd(place) < this->epsilon * this->epsilon * nn(place) * lengths(place); };
    if (!allowed(t))
    {
      return false;
    }
    const auto reach = [&](int k, int direction)
    {
      double good = t;
      for (; k >= 0 && k <= intervals; k += direction)
      {
        double bad = static_cast<double>(k) / intervals;
        if (allowed(bad))
        {
          good = bad;
          continue;
        }
        for (int i = 0; i < bisections; ++i)
        {
          const double middle = 0.5 * (good + bad);
          (allowed(middle) ? good : bad) = middle;
        }
        break;
      }
      return good;
    };
    s.low = reach(static_cast<int>(std::floor(t * intervals)), -1);
    s.high = reach(static_cast<int>(std::ceil(t * intervals)), 1);
    return true;
  }

  const Mesh& mesh;
  const Adjacency& adjacency;
  const std::vector<Vector3>& normals;
  const View& view;
  double epsilon;
  bool closed;
  std::list<Snaxel> snaxels;
  std::map<int, int> splitCount; // by vertex
};

} // namespace

double silhouetteDeviation(const CurvePoint& snaxel, const View& view)
{
  return std::abs(snaxel.normal.dot(view.towardsViewer(snaxel.position).normalized()));
}

double smoothness(const CurvePoint& before, const CurvePoint& at, const CurvePoint& after)
{
  return Bend(before, at, after).smoothness();
}

std::vector<Curve> smoothSilhouette(const std::vector<Curve>& curves,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view,
  double epsilon,
  const Context& context)
{
  context.checkpoint(0.0);
  std::vector<Curve> smoothed(curves.size());
  // The longest first, each by whoever is free: one curve, the outline, can take half of the time.
  std::vector<int> order(curves.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(),
    order.end(),
    [&](int a, int b) { return curves[a].points.size() > curves[b].points.size(); });
  std::atomic<int> taken{ 0 };
  context.parallelFor(static_cast<int>(curves.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end && !context.cancelled(); ++i)
      {
        const int curve = order[taken++];
        smoothed[curve] = Snake(curves[curve], mesh, adjacency, normals, view, epsilon).run(context);
      }
    });
  context.checkpoint(1.0);
  smoothed.erase(
    std::remove_if(
      smoothed.begin(), smoothed.end(), [](const Curve& curve) { return curve.points.size() < 2; }),
    smoothed.end());
  return smoothed;
}

} // namespace oversketch
