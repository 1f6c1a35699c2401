#include "Stellar/snap_foot.h"

#include "Mesh/context.h"
#include "Stellar/crossed_faces.h"
#include "Stellar/distance.h"
#include "Stellar/quality.h"
#include "Stellar/snapper.h"

#include <algorithm>
#include <limits>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double rim = 1.0 - 0.0175;  // shares of the radius: a row of the vertices that refinement makes
constexpr double rimEdge = 0.0625;    // and the longest edge that is looked at there
constexpr double closeEnough = 1e-13; // and how near to its place a vertex is put
constexpr double partWays[] = { 0.8, 0.6, 0.4, 0.2 }; // of a way that is not open to its end
constexpr double farOff = 2.0;                        // and from where on nothing needs to be known

// Distance / radius of a place from the curve where that is least.
struct Share
{
  double value = std::numeric_limits<double>::infinity();
  int curve = -1;
};

class FootSnapper
{
public:
  FootSnapper(Forest& forest, const FeatureCurves& curves, const FootOptions& options, const Context& context)
    : Mesh(forest)
    , Curves(curves)
    , Options(options)
    , Caller(context)
    , Search(curves)
    , Shares(forest.vertices.size())
    , Placed(forest.vertices.size(), 0)
  {
    for (const Forest::Vertex& v : forest.vertices)
    {
      this->First.push_back(v.position);
    }
  }

  FootReport run()
  {
    this->measure();
    this->settle(1.0);
    this->settle(rim);
    this->Caller.checkpoint(1.0);
    return this->Report;
  }

private:
  // An edge from a vertex within a level to one beyond it, and where it leaves that.
  struct Crossing
  {
    int within, beyond;
    double u;
  };
  struct Move
  {
    double length;
    int vertex, other;
    double u; // of the way to the other
    bool operator<(const Move& o) const
    {
      return std::tie(this->length, this->vertex, this->other) < std::tie(o.length, o.vertex, o.other);
    }
  };

  double radius(int curve) const { return this->Curves[curve].radius.value_or(this->Options.radius); }
  bool steep(int curve) const
  {
    return this->Curves[curve].sharpness.value_or(this->Options.sharpness) < 1.0;
  }
  const Vector3& at(int v) const { return this->Mesh.vertices[v].position; }

  // Measures what is reached.
  void measure()
  {
    const CrossedFaces crossed(this->Mesh, this->Search, this->Caller);
    CurveReach reach(this->Mesh, this->Search);
    for (int k = 0; k < static_cast<int>(this->Curves.size()); ++k)
    {
      const ReachOptions options{ this->radius(k), CurveDistance::Straight, this->Options.connectedOnly };
      for (const Reached& reached : reach.find(k, crossed.faces(k), options, this->Caller))
      {
        Share& share = this->Shares[reached.vertex];
        const double value = reached.distance / options.radius;
        share = value < share.value ? Share{ value, k } : share;
        this->Inside.push_back(reached.vertex);
      }
    }
    sortUnique(this->Inside);
  }

  Share shareAt(const Vector3& place) const
  {
    Share best{ farOff, -1 };
    for (int k = 0; k < static_cast<int>(this->Curves.size()); ++k)
    {
      const double radius = this->radius(k);
      const double value = this->Search.nearest(k, place, best.value * radius).distance / radius;
      best = value < best.value ? Share{ value, k } : best;
    }
    return best;
  }

  // Where on an edge a level is left, as seen from within; no place within it. Negative where that is not so,
  // or the nearest curve is not steep.
  double leaving(int within, int beyond, double level) const
  {
    const auto place = [&](double t) -> Vector3
    { return this->at(within) + t * (this->at(beyond) - this->at(within)); };
    const auto over = [&](double t) { return this->shareAt(place(t)).value - level; };
    const bool known = this->Shares[beyond].curve >= 0;
    double low = 0.0, high = 1.0, below = this->Shares[within].value - level,
           above = known ? this->Shares[beyond].value - level : over(1.0);
    if (!(above >= 0.0))
    {
      return -1.0; // it is not joined to the curve
    }
    // Regula falsi, the weight of an end that stays halved (Illinois).
    double weights[2] = { 1.0, 1.0 };
    for (int i = 0; i < 60 && above > closeEnough; ++i)
    {
      const double f = weights[0] * below, g = weights[1] * above, t = (low * g - high * f) / (g - f);
      if (!(t > low && t < high))
      {
        break;
      }
      const double value = over(t);
      const bool inner = value < 0.0;
      (inner ? low : high) = t;
      (inner ? below : above) = value;
      weights[inner ? 0 : 1] = 1.0;
      weights[inner ? 1 : 0] *= 0.5;
    }
    const int curve = this->shareAt(place(low)).curve;
    return curve >= 0 && this->steep(curve) ? high : -1.0;
  }

  std::vector<Crossing> crossings(double level) const
  {
    std::vector<Crossing> crossings;
    for (const int v : this->Inside)
    {
      if (!(this->Shares[v].value < level))
      {
        continue;
      }
      this->Mesh.link(v,
        [&](int w)
        {
          const Share& share = this->Shares[w];
          const bool ends =
            share.value > level && (level == 1.0 || (this->at(w) - this->at(v)).norm() <=
                                                      rimEdge * this->radius(this->Shares[v].curve));
          const double u = ends ? this->leaving(v, w, level) : -1.0;
          if (u > 0.0 && u < 1.0)
          {
            crossings.push_back({ v, w, u });
          }
        });
    }
    return crossings;
  }

  bool mayGo(int v, int towards) const
  {
    const Forest::Vertex& vertex = this->Mesh.vertices[v];
    return !this->Placed[v] && vertex.curveId < 0 && !(vertex.moved & Forest::Crest) &&
           keepsToLines(this->Mesh, v, towards, this->Options.parts) &&
           !this->Options.staying.at(this->Mesh, v);
  }

  // Moves a vertex so much of the way along an edge, if A2 lets it.
  bool go(int v, int other, double u, double share)
  {
    const Vector3 to = this->at(v) + u * (this->at(other) - this->at(v));
    if (!mayMove(this->Mesh, v, to, this->Options.minimumAngle, &this->First))
    {
      return false;
    }
    Forest::Vertex& moved = this->Mesh.vertices[v];
    const Vector3 normal = (1.0 - u) * moved.baseNormal + u * this->Mesh.vertices[other].baseNormal;
    if (normal.squaredNorm() > 0.0)
    {
      moved.baseNormal = normal.normalized();
    }
    moved.position = to;
    moved.moved |= Forest::Placed;
    this->Shares[v].value = share;
    this->Placed[v] = 1;
    ++this->Report.moved;
    return true;
  }

  // The nearest first.
  std::vector<Move> movesFor(const std::vector<Crossing>& crossings) const
  {
    std::vector<Move> moves;
    const auto add = [&](int v, int other, double u)
    {
      if (this->mayGo(v, other))
      {
        moves.push_back({ u * (this->at(other) - this->at(v)).norm(), v, other, u });
      }
    };
    for (const Crossing& c : crossings)
    {
      add(c.within, c.beyond, c.u);
      add(c.beyond, c.within, 1.0 - c.u);
    }
    std::sort(moves.begin(), moves.end());
    return moves;
  }

  void settle(double level)
  {
    const std::vector<Crossing> crossings = this->crossings(level);
    this->Report.crossings += static_cast<int>(crossings.size());
    // An edge with an end on the level is crossed no more.
    const auto on = [&](int v) { return this->Shares[v].value == level; };
    int count = 0;
    for (const Move& m : this->movesFor(crossings))
    {
      if (++count % movesPerCheck == 0)
      {
        this->Caller.checkpoint(0.9);
      }
      if (!this->Placed[m.vertex] && !on(m.other) && !this->go(m.vertex, m.other, m.u, level))
      {
        ++this->Report.refused;
      }
    }
    // A face that still crosses the foot rises beyond it as far as its outer end is off, one that crosses the
    // rim is too low as far as its inner end is: those ends come nearer.
    for (const Crossing& c : crossings)
    {
      if (!on(c.within) && !on(c.beyond))
      {
        level == 1.0 ? this->approach(c.beyond, c.within, 1.0 - c.u)
                     : this->approach(c.within, c.beyond, c.u);
      }
    }
  }

  // As much of the way to a crossing as A2 lets it go.
  void approach(int v, int other, double u)
  {
    if (!this->mayGo(v, other))
    {
      return;
    }
    for (const double part : partWays)
    {
      const Vector3 to = this->at(v) + part * u * (this->at(other) - this->at(v));
      if (this->go(v, other, part * u, this->shareAt(to).value))
      {
        return;
      }
    }
  }

  FootReport Report;
  Forest& Mesh;
  const FeatureCurves& Curves;
  const FootOptions& Options;
  const Context& Caller;
  CurveSearch Search;
  std::vector<Share> Shares;  // per vertex
  std::vector<char> Placed;   // per vertex: on foot or rim
  std::vector<Vector3> First; // where vertices were before they moved
  std::vector<int> Inside;    // reached vertices, ascending
};

} // namespace

FootReport snapFoot(Forest& forest,
  const FeatureCurves& curves,
  const FootOptions& options,
  const Context& context)
{
  checkCurves(curves);
  const auto steep = [&](const FeatureCurve& c) { return c.sharpness.value_or(options.sharpness) < 1.0; };
  if (std::none_of(curves.begin(), curves.end(), steep))
  {
    return {};
  }
  checkRadius(curves, options.radius);
  if (!(options.sharpness >= 0.0 && options.minimumAngle >= 0.0 && options.minimumAngle <= 60.0))
  {
    throw Error(Failure::BadStroke,
      "The foot of a feature needs a {sharpness} that is not negative and a minimum angle of 0 to 60 "
      "degrees.");
  }
  if (!options.parts.empty() && static_cast<int>(options.parts.size()) != forest.rootCount)
  {
    throw Error(
      Failure::BadStroke, "The foot of a feature needs a part for each triangle of the base mesh, or none.");
  }
  needBaseNormals(forest, context);
  return FootSnapper(forest, curves, options, context).run();
}

} // namespace oversketch
