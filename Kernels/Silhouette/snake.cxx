#include "Silhouette/snake.h"

#include "Silhouette/bend.h"
#include "Silhouette/fan.h"
#include "Silhouette/relocation.h"

#include <algorithm>
#include <array>
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
constexpr double sameAngle = 1e-9; // what rounding makes of two equal sides
constexpr int sweepLimit = 200;
constexpr int splitLimit = 1 + 5;     // of one vertex: split and conversion can alternate for ever
constexpr double splitDistance = 0.2; // of the spoke, halved until E_geo allows it
constexpr int halvingLimit = 40;
constexpr int intervals = 32; // of an edge, where the limit on E_geo is looked for
constexpr int bisections = 30;
constexpr int leastSection = 4; // snaxels of a section, or the curve is one

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
  // Part of an edge snaxel's edge, once known, that it can reach with E_geo < epsilon, and the edge's ends
  // and their normals, together where the sweeps come by.
  double low = 1.0, high = 0.0;
  Vector3 ends[2] = { Vector3::Zero(), Vector3::Zero() },
          endNormals[2] = { Vector3::Zero(), Vector3::Zero() };

  void moveTo(double weight, const Triple& to, const Triple& unit)
  {
    this->binding.weights = { weight, 1.0 - weight, 0.0 };
    this->position = { to.x, to.y, to.z };
    this->normal = { unit.x, unit.y, unit.z };
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
    : Model(surface)
    , Neighbours(neighbours)
    , Normals(vertexNormals)
    , Camera(eye)
    , Epsilon(limit)
    , Closed(curve.closed)
  {
    for (const CurvePoint& p : curve.points)
    {
      this->Snaxels.emplace_back(p);
    }
    const int fixed = this->Closed ? 0 : 1;
    const int swept = static_cast<int>(this->Snaxels.size()) - 2 * fixed;
    this->Sections = std::clamp(swept / leastSection, 1, Relocations::lanes);
    this->Heads.fill(this->Snaxels.end());
    for (int i = 0; i <= this->Sections && swept > 0; ++i)
    {
      this->Heads[i] = std::next(this->Snaxels.begin(), fixed + swept * i / this->Sections);
    }
  }

  Curve run(const Context& context)
  {
    for (int sweep = 0; sweep < sweepLimit && this->sweepOnce(false) && !context.cancelled(); ++sweep)
    {
    }
    // Only after the last allowed sweep is there anything left to remove.
    for (Snaxel& s : this->Snaxels)
    {
      s.stale = true;
    }
    while (this->sweepOnce(true))
    {
    }
    return { std::vector<CurvePoint>(this->Snaxels.begin(), this->Snaxels.end()), this->Closed };
  }

private:
  using Place = std::list<Snaxel>::iterator;

  Snaxel& before(Place s) { return s == this->Snaxels.begin() ? this->Snaxels.back() : *std::prev(s); }
  Snaxel& after(Place s)
  {
    const Place next = std::next(s);
    return next == this->Snaxels.end() ? this->Snaxels.front() : *next;
  }

  // Looks at every stale snaxel but fixed ends once, at one of each section in turn; false when nothing
  // changed.
  bool sweepOnce(bool removeOnly)
  {
    if (this->Snaxels.size() < 3)
    {
      return false;
    }
    this->Changed = false;
    std::copy_n(this->Heads.begin(), this->Places.size(), this->Places.begin());
    std::array<Place, Relocations::lanes> looked;
    for (bool open = true; open;)
    {
      int count = 0;
      for (int section = 0; section < this->Sections; ++section)
      {
        if (this->goToEdgeSnaxel(section, removeOnly))
        {
          looked[count] = this->Places[section]++;
          this->put(looked[count], count);
          ++count;
        }
      }
      open = count > 0 && !this->Snaxels.empty();
      if (open)
      {
        const bool perspective = this->Camera.perspective();
        this->Relocated.find(Triple(perspective ? this->Camera.eye() : this->Camera.normal()),
          perspective ? 1.0 : 0.0,
          this->Epsilon);
        for (int i = 0; i < count; ++i)
        {
          this->settle(looked[i], i);
        }
      }
    }
    return this->Changed;
  }

  // Goes on to the section's next stale snaxel that may move along its edge, removes and splits on the way;
  // false at the section's end.
  bool goToEdgeSnaxel(int section, bool removeOnly)
  {
    Place& s = this->Places[section];
    while (s != this->Heads[section + 1])
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
        this->replace(s, std::next(s));
        this->reconsider(previous, next);
        if (this->Closed && this->Snaxels.size() < 3)
        {
          this->Snaxels.clear();
          this->Heads.fill(this->Snaxels.end());
          this->Places.fill(this->Snaxels.end());
        }
        continue; // with the follower of what was removed
      }
      s->apart = true;
      if (!removeOnly && s->binding.onVertex())
      {
        if (this->split(s, previous, next))
        {
          this->reconsider(previous, next);
          continue; // with the first of the new snaxels
        }
      }
      else if (!removeOnly && s->binding.weights[2] == 0.0 &&
               (s->low <= s->high || this->measure(*s, s->binding.weights[1])))
      {
        return true;
      }
      ++s;
    }
    return false;
  }

  // Another snaxel, or what follows, takes the place of one that is gone.
  void replace(Place gone, Place by)
  {
    std::replace(this->Heads.begin(), this->Heads.end(), gone, by);
    std::replace(this->Places.begin(), this->Places.end(), gone, by);
    this->Snaxels.erase(gone);
  }

  // What lies between these two is another than before.
  void reconsider(Snaxel& previous, Snaxel& next)
  {
    previous.stale = next.stale = this->Changed = true;
    previous.apart = next.apart = false;
  }

  void put(Place s, int i)
  {
    Relocations& r = this->Relocated;
    r.before.set(i, this->before(s).position);
    r.after.set(i, this->after(s).position);
    r.at.set(i, s->position);
    r.normal.set(i, s->normal);
    for (int k = 0; k < 2; ++k)
    {
      r.ends[k].set(i, s->ends[k]);
      r.endNormals[k].set(i, s->endNormals[k]);
    }
    r.low[i] = s->low;
    r.high[i] = s->high;
  }

  // Does to a snaxel what was found for it.
  void settle(Place place, int i)
  {
    const Relocations::Found& found = this->Relocated.found;
    Snaxel &s = *place, &previous = this->before(place), &next = this->after(place);
    const Relocations::Verdict verdict = found.verdict[i];
    if (verdict == Relocations::Moves)
    {
      s.moveTo(found.weight[i], found.position[i], found.normal[i]);
    }
    else if (verdict == Relocations::Stays || !this->relocate(s, previous, next))
    {
      return;
    }
    previous.stale = next.stale = this->Changed = true;
    if (s.binding.onVertex())
    {
      this->reconsider(previous, next);
      s.apart = false;
    }
  }

  CurvePoint pointAt(const Binding& binding) const
  {
    return { binding, binding.of(this->Model.points), binding.of(this->Normals).normalized() };
  }

  bool inOneTriangle(const Snaxel& a, const Snaxel& b, const Snaxel& c) const
  {
    Support support;
    support.add(a.binding);
    support.add(b.binding);
    support.add(c.binding);
    return support.count < 3 ||
           (support.count == 3 && triangleWith(this->Model, this->Neighbours, support) >= 0);
  }

  // Replaces a bent vertex snaxel by edge snaxels on the spokes that the curve crosses on the side of the
  // smaller angle, so that the curve shortens. False where it stays.
  bool split(Place s, const Snaxel& previous, const Snaxel& next)
  {
    const int centre = s->binding.vertices[0];
    int& splits = this->SplitCount[centre];
    if (splits >= splitLimit || smoothness(previous, *s, next) >= straight - splitBend)
    {
      return false;
    }
    Support support;
    support.add(s->binding);
    support.add(previous.binding);
    const int triangle = triangleWith(this->Model, this->Neighbours, support);
    if (triangle < 0)
    {
      return false;
    }
    const Fan fan = fanOf(this->Model, this->Neighbours, centre, triangle);
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
          turn(this->Model.points[spokes.back()]);
        }
      }
      turn(next.position);
      if (best.empty() || (!spokes.empty() && angle < bestAngle - sameAngle))
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
    this->Snaxels.splice(s, made);
    this->replace(s, firstMade);
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
      if (silhouetteDeviation(p, this->Camera) < this->Epsilon)
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
    const Bend bend(previous, s, next);
    if (!bend.matters())
    {
      return false;
    }
    const double low = s.low, high = s.high, present = s.binding.weights[1];
    const Triple p0(s.ends[0]), p1(s.ends[1]), n0(s.endNormals[0]), n1(s.endNormals[1]);
    const Triple before(previous.position), after(next.position);
    const Triple a = before - p0, b = after - p0, e = p1 - p0, dn = n1 - n0;
    const auto bendAt = [&](const EdgePoint& p) { return Bend(before, p.position, p.normal, after); };
    std::array<double, 2> straightest = straightPlaces(a, b, e, n0, dn);
    if (std::abs(straightest[1] - present) < std::abs(straightest[0] - present))
    {
      std::swap(straightest[0], straightest[1]);
    }
    const auto found = std::find_if(straightest.begin(),
      straightest.end(),
      [&](double t) { return t >= low && t <= high && bendAt(EdgePoint(t, p0, p1, n0, n1)).isNone(); });
    const double best =
      found != straightest.end() ? *found : searchStraightest(EdgeSmoothness(a, b, e, n0, dn), low, high);
    // A whole edge may be free to its end, or the limit may lie just short of it.
    const bool toFirst = low == 0.0 && best < endTolerance,
               toSecond = high == 1.0 && best > 1.0 - endTolerance;
    if (toFirst || toSecond)
    {
      const CurvePoint moved = this->pointAt(Binding::vertex(s.binding.vertices[toFirst ? 0 : 1]));
      if (!this->nearContour(Triple(moved.position), Triple(moved.normal)) ||
          !bend.matters(Bend(previous, moved, next)))
      {
        return false;
      }
      static_cast<CurvePoint&>(s) = moved;
      s.stale = true;
      return true;
    }
    const EdgePoint p(best, p0, p1, n0, n1);
    if (!this->nearContour(p.position, p.normal) || !bend.matters(bendAt(p)))
    {
      return false;
    }
    s.moveTo(p.weight, p.position, p.normal);
    return true;
  }

  // E_geo < epsilon; only near the limit does it take E_geo itself to know.
  bool nearContour(const Triple& position, const Triple& normal) const
  {
    constexpr double margin = 1e-9;
    const Vector3 place(position.x, position.y, position.z);
    const Triple d(this->Camera.towardsViewer(place));
    const double across = d.dot(normal), most = this->Epsilon * this->Epsilon * d.dot(d);
    if (across * across < most * (1.0 - margin))
    {
      return true;
    }
    const CurvePoint p{ Binding(), place, { normal.x, normal.y, normal.z } };
    return across * across <= most * (1.0 + margin) && silhouetteDeviation(p, this->Camera) < this->Epsilon;
  }

  // Finds the part [low, high] round t of a snaxel's edge where E_geo < epsilon; false when t itself is not
  // in it.
  bool measure(Snaxel& s, double t) const
  {
    const int v0 = s.binding.vertices[0], v1 = s.binding.vertices[1];
    s.ends[0] = this->Model.points[v0];
    s.ends[1] = this->Model.points[v1];
    s.endNormals[0] = this->Normals[v0];
    s.endNormals[1] = this->Normals[v1];
    const Triple d0(this->Camera.towardsViewer(s.ends[0]));
    const Triple dd = Triple(this->Camera.towardsViewer(s.ends[1])) - d0;
    const Triple n0(s.endNormals[0]);
    const Triple dn = Triple(s.endNormals[1]) - n0;
    const Quadratic nd = product(n0, dn, d0, dd), nn = product(n0, dn, n0, dn),
                    lengths = product(d0, dd, d0, dd);
    const auto allowed = [&](double place)
    { return nd(place) * nd(place) < this->Epsilon * this->Epsilon * nn(place) * lengths(place); };
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

  const Mesh& Model;
  const Adjacency& Neighbours;
  const std::vector<Vector3>& Normals;
  const View& Camera;
  double Epsilon;
  bool Closed;
  std::list<Snaxel> Snaxels;
  // The curve in sections of equal length: where each begins, and the next one after the last. A sweep goes
  // over all of them at once, so that what one snaxel waits for is worked on for others.
  int Sections;
  std::array<Place, Relocations::lanes + 1> Heads;
  std::array<Place, Relocations::lanes> Places; // that the sweep has come to
  Relocations Relocated;
  bool Changed = false;          // in this sweep
  std::map<int, int> SplitCount; // by vertex
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

namespace
{

// The middle of a mesh that lies more than sixteen times its size from the origin; zeros for others.
Vector3 farMiddle(const Mesh& mesh)
{
  const Eigen::AlignedBox3d box = boxRound(mesh.points);
  constexpr double farAway = 16.0;
  const bool isFar = !box.isEmpty() && box.center().norm() > farAway * box.diagonal().norm();
  return isFar ? Vector3(box.center()) : Vector3(Vector3::Zero());
}

void move(std::vector<Curve>& curves, const Vector3& by)
{
  for (Curve& curve : curves)
  {
    for (CurvePoint& p : curve.points)
    {
      p.position += by;
    }
  }
}

} // namespace

// Far away coordinates have no digits left for the difference of two bends: there all is moved to the origin
// and back.
std::vector<Curve> smoothSilhouette(const std::vector<Curve>& curves,
  const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const View& view,
  double epsilon,
  const Context& context)
{
  const Vector3 origin = farMiddle(mesh);
  if (!origin.isZero(0.0))
  {
    Mesh near = mesh;
    for (Vector3& p : near.points)
    {
      p -= origin;
    }
    std::vector<Curve> moved = curves;
    move(moved, -origin);
    Eigen::Matrix4d there = Eigen::Matrix4d::Identity();
    there.topRightCorner<3, 1>() = origin;
    const View nearView(
      view.viewTransform() * there, view.projectionTransform(), view.width(), view.height());
    std::vector<Curve> done = smoothSilhouette(moved, near, adjacency, normals, nearView, epsilon, context);
    move(done, origin);
    return done;
  }
  context.checkpoint(0.0);
  std::vector<Curve> done(curves.size());
  // The longest first, each by whoever is free: one curve, the outline, can take half of the time.
  std::vector<int> order(curves.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(),
    order.end(),
    [&](int a, int b) { return curves[a].points.size() > curves[b].points.size(); });
  std::atomic<int> taken{ 0 };
  context.eachUntilCancelled(static_cast<int>(curves.size()),
    [&](int)
    {
      const int curve = order[taken++];
      done[curve] = Snake(curves[curve], mesh, adjacency, normals, view, epsilon).run(context);
    });
  context.checkpoint(1.0);
  done.erase(
    std::remove_if(done.begin(), done.end(), [](const Curve& curve) { return curve.points.size() < 2; }),
    done.end());
  return done;
}

} // namespace oversketch
