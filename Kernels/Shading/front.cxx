#include "Shading/front.h"

#include "Mesh/context.h"
#include "Shading/directions.h"
#include "Stellar/curves.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace oversketch
{
namespace
{

constexpr double unreached = std::numeric_limits<double>::infinity();
constexpr double worthwhile = 1e-3; // of an edge: by less, what was passed is not passed again
constexpr double bent = 0.1;        // slopes that fall by more along an edge are those of two fronts
constexpr double veryRound = 0.7;   // edges over the radius: of such a front the centre says more than slopes

// A distance along an edge, by its values and slopes at the ends.
struct EdgeDistance
{
  double value, slope, square, cube, length;

  EdgeDistance(double atA, double slopeA, double atB, double slopeB, double c)
    : value(atA)
    , slope(slopeA)
    , length(c)
  {
    const double mean = (atB - atA) / c;
    this->square = (3.0 * mean - 2.0 * slopeA - slopeB) / c;
    this->cube = (slopeA + slopeB - 2.0 * mean) / (c * c);
  }
  double at(double x) const { return this->value + x * (this->slope + x * (this->square + x * this->cube)); }
  double slopeAt(double x) const { return this->slope + x * (2.0 * this->square + x * 3.0 * this->cube); }

  // One over the radius of the front there.
  double bow(double x) const
  {
    const double rise = this->slopeAt(x), off = 1.0 - rise * rise,
                 bend = 2.0 * this->square + 6.0 * this->cube * x;
    return off > 0.0 && bend > 0.0 ? std::min(bend / off, 1.0 / this->at(x)) : 0.0;
  }

  // Where on the edge the shortest way to (vx, vy) crosses it.
  double crossing(double vx, double vy) const
  {
    const auto away = [&](double x) { return std::sqrt((x - vx) * (x - vx) + vy * vy); };
    const auto rise = [&](double x) { return this->slopeAt(x) + (x - vx) / away(x); };
    double low = 0.0, high = this->length, atLow = rise(low), atHigh = rise(high);
    if (!(atLow < 0.0))
    {
      return 0.0;
    }
    if (!(atHigh > 0.0))
    {
      return this->length;
    }
    double x = this->length * atLow / (atLow - atHigh);
    for (int i = 0; i < 8; ++i)
    {
      const double far = away(x), now = this->slopeAt(x) + (x - vx) / far,
                   bend = 2.0 * this->square + 6.0 * this->cube * x + vy * vy / (far * far * far);
      (now < 0.0 ? low : high) = x;
      const double newton = bend > 0.0 ? x - now / bend : low, last = x;
      x = newton > low && newton < high ? newton : 0.5 * (low + high);
      if (std::abs(x - last) < 1e-6 * this->length) // the way's length is off by the square of that
      {
        break;
      }
    }
    return x;
  }
};

class Front
{
public:
  Front(const Mesh& mesh,
    const Adjacency& adjacency,
    const Directions& directions,
    const FeatureCurve& curve,
    ChainDistances& straight)
    : Surface(mesh)
    , Links(adjacency)
    , Curve(curve)
    , Angles(directions)
    , Least(straight.distance)
    , Distance(straight.distance)
    , Place(straight.place)
    , Back(mesh.points.size(), 0.0)
    , Bow(mesh.points.size(), 0.0)
    , Source(mesh.points.size(), -1)
    , Passed(mesh.points.size(), 0)
  {
    std::fill(this->Distance.begin(), this->Distance.end(), unreached);
  }

  void begin(const std::vector<int>& chain)
  {
    const int count = static_cast<int>(chain.size());
    for (int i = 0; i < count; ++i)
    {
      const int v = chain[i];
      const bool hasPrevious = i > 0 || this->Curve.closed, hasNext = i + 1 < count || this->Curve.closed;
      const int previous = chain[(i + count - 1) % count], next = chain[(i + 1) % count];
      const double back = this->Angles.toward(v, hasPrevious ? previous : next),
                   forth = this->Angles.toward(v, hasNext ? next : previous);
      this->Source[v] = static_cast<int>(this->Along.size());
      this->Along.push_back({ back, forth });
      this->Distance[v] = 0.0;
      this->Place[v] = this->Curve.arc[i];
      this->Queue.emplace(0.0, v);
    }
  }

  void run(const Context& context)
  {
    for (int steps = 0; !this->Queue.empty(); ++steps)
    {
      if (steps % 4096 == 0)
      {
        context.checkpoint(0.0);
      }
      const auto [distance, a] = this->Queue.top();
      this->Queue.pop();
      if (distance > this->Distance[a])
      {
        continue; // a shorter way has come since
      }
      this->Passed[a] = 1;
      for (const int t : this->Links.vertexTriangles[a])
      {
        this->cross(t, this->Angles.corner(t, a), 1);
        this->cross(t, this->Angles.corner(t, a), 2);
      }
    }
  }

private:
  // Over a triangle from its corner i and the one that is `side` on, if the front has passed that, to the
  // third.
  void cross(int t, int i, int side)
  {
    const Triangle& corners = this->Surface.triangles[t];
    const int j = (i + side) % 3, k = (i + 3 - side) % 3;
    const int a = corners[i], b = corners[j], v = corners[k];
    const double da = this->Distance[a], db = this->Distance[b];
    if (this->Source[v] >= 0 ||
        (this->Passed[v] && this->Distance[v] <= (this->Passed[b] ? std::min(da, db) : da)))
    {
      return;
    }
    const Vector3 toB = this->Surface.points[b] - this->Surface.points[a],
                  toV = this->Surface.points[v] - this->Surface.points[a];
    const double c = toB.norm();
    double x = 0.0, vx = 0.0, vy = 0.0, distance = da + toV.norm();
    double bow = this->Source[a] >= 0 ? 1.0 / toV.norm() : spread(this->Bow[a], toV.norm());
    if (this->Passed[b] && c > 0.0)
    {
      vx = toV.dot(toB) / c;
      vy = toV.cross(toB).norm() / c;
      const double slopeA = this->slope(a, side == 1 ? this->Angles.next(t, i) : this->Angles.previous(t, i));
      const double slopeB = this->slope(b, side == 1 ? this->Angles.previous(t, j) : this->Angles.next(t, j));
      const bool meet = -slopeB < slopeA - bent;
      if (!meet)
      {
        const EdgeDistance edge(da, slopeA, db, -slopeB, c);
        x = edge.crossing(vx, vy);
        if (x > 0.0)
        {
          const double onward = std::hypot(x - vx, vy);
          distance = edge.at(x) + onward;
          bow = spread(edge.bow(x), onward);
        }
      }
      // Where two fronts meet between the ends, or one is very round, by one end's.
      const auto alone = [&](int end, double slope, bool fromA)
      {
        const double round = this->bowOf(end, slope);
        if (!meet && round * c < veryRound)
        {
          return;
        }
        const Way way = this->alone(end, slope, fromA ? vx : c - vx, vy);
        if (way.x > 0.0 && way.x < c && way.distance < distance)
        {
          distance = way.distance;
          x = fromA ? way.x : c - way.x;
          bow = spread(round, distance - this->Distance[end]);
        }
      };
      alone(a, slopeA, true);
      alone(b, slopeB, false);
    }
    distance = std::max(distance, this->Least[v]);
    if (!(distance < this->Distance[v] - (this->Passed[v] ? worthwhile * toV.norm() : 0.0)))
    {
      return;
    }
    this->Distance[v] = distance;
    this->Bow[v] = bow;
    // The angle between the way back and the edge to a.
    const double turned = std::atan2(vy * x, vy * vy - vx * (x - vx));
    this->Back[v] = side == 1 ? this->Angles.next(t, k) + turned : this->Angles.previous(t, k) - turned;
    this->Place[v] = this->placeOn(a, b, c > 0.0 ? x / c : 0.0, c);
    this->Queue.emplace(distance, v);
  }

  // How the distance changes along an edge in a direction.
  double slope(int vertex, double direction) const
  {
    if (const int source = this->Source[vertex]; source >= 0)
    {
      const auto& along = this->Along[source];
      const double turn = std::min(
        this->Angles.between(vertex, along[0], direction), this->Angles.between(vertex, along[1], direction));
      return turn < M_PI_2 ? std::sin(turn) : 1.0;
    }
    const double turn = this->Angles.between(vertex, this->Back[vertex], direction);
    return turn < M_PI ? -std::cos(turn) : 1.0;
  }

  // How much a front bows, as one over its radius, where it has gone on for a length.
  static double spread(double bow, double length) { return bow / (1.0 + bow * length); }
  // At a vertex; beside the curve it is straight, round the curve's vertices it would be infinite.
  double bowOf(int vertex, double slope) const
  {
    return this->Source[vertex] < 0 ? this->Bow[vertex] : slope < 1.0 ? 0.0 : unreached;
  }

  // The way to (vx, vy) by one end of an edge alone, at (0, 0).
  struct Way
  {
    double distance, x;
  };
  Way alone(int vertex, double slope, double vx, double vy) const
  {
    const double bow = this->bowOf(vertex, slope), off = std::sqrt(std::max(0.0, 1.0 - slope * slope));
    if (!(off > 0.0 && std::isfinite(bow)))
    {
      return { unreached, 0.0 };
    }
    const double d = this->Distance[vertex];
    if (bow * (std::abs(vx) + vy) < 1e-6)
    {
      return { d + slope * vx + off * vy, vx - vy * slope / off };
    }
    const double r = 1.0 / bow, across = r * slope + vx, up = r * off + vy;
    return { d - r + std::hypot(across, up), across * r * off / up - r * slope };
  }

  double placeOn(int a, int b, double share, double c) const
  {
    // Ways to a bent curve spread by no more than their length; farther apart are two fronts that meet, and
    // between their places is nothing.
    const double from = this->Place[a], to = this->Place[b];
    const bool together =
      this->Passed[b] && !this->Curve.closed && this->Curve.apart(from, to) <= 2.0 * c + this->Distance[a];
    return together ? from + share * (to - from) : share < 0.5 ? from : to;
  }

  const Mesh& Surface;
  const Adjacency& Links;
  const FeatureCurve& Curve;
  const Directions& Angles;
  const std::vector<double> Least; // through space
  std::vector<double>&Distance, &Place;
  std::vector<double> Back;                 // the direction that the way comes from
  std::vector<double> Bow;                  // how much the front bows there, as one over its radius
  std::vector<int> Source;                  // of the curve's vertices, into Along
  std::vector<std::array<double, 2>> Along; // directions along the curve
  std::vector<char> Passed;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> Queue;
};

} // namespace

void marchFront(const Mesh& mesh,
  const Adjacency& adjacency,
  const Directions& directions,
  const std::vector<int>& chain,
  const FeatureCurve& curve,
  ChainDistances& straight,
  const Context& context)
{
  Front front(mesh, adjacency, directions, curve, straight);
  front.begin(chain);
  front.run(context);
}

} // namespace oversketch
