#include "Stellar/foot.h"

#include "Mesh/context.h"
#include "Stellar/distance.h"
#include "Stellar/passage.h"
#include "Stellar/quality.h"
#include "Stellar/snapper.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double rim = 1.0 - 0.0175;  // shares of the radius: a row of the vertices that refinement makes
constexpr double rimEdge = 0.0625;    // and the longest edge that is cut there
constexpr double closeEnough = 1e-13; // and how near to its place a vertex is put
constexpr double farOff = 2.0;        // and from where on nothing needs to be known

// Of a place: distance / radius of the curve where that is least.
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

  FootReport run(const MidpointRule& rule)
  {
    const int faces = this->Mesh.faceCount();
    this->measure();
    this->move(1.0, this->crossings(1.0));
    this->move(rim, this->crossings(rim));
    this->split(this->crossings(rim), rule);
    this->Report.facesAdded = this->Mesh.faceCount() - faces;
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
    Vector3 to;
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

  // What is reached.
  void measure()
  {
    const Passage passage(this->Mesh, this->Search, this->Caller);
    CurveReach reach(this->Mesh, this->Search);
    for (int k = 0; k < static_cast<int>(this->Curves.size()); ++k)
    {
      const ReachOptions options{ this->radius(k), CurveDistance::Straight, this->Options.connectedOnly };
      for (const Reached& reached : reach.find(k, passage.faces(k), options, this->Caller))
      {
        Share& share = this->Shares[reached.vertex];
        const double value = reached.distance / options.radius;
        share = value < share.value ? Share{ value, k } : share;
        this->Inside.push_back(reached.vertex);
      }
    }
    std::sort(this->Inside.begin(), this->Inside.end());
    this->Inside.erase(std::unique(this->Inside.begin(), this->Inside.end()), this->Inside.end());
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
           keepsToLines(this->Mesh, v, towards, this->Options.parts);
  }

  void put(int v, int other, double u, const Vector3& to, double level)
  {
    Forest::Vertex& moved = this->Mesh.vertices[v];
    const Vector3 normal = (1.0 - u) * moved.baseNormal + u * this->Mesh.vertices[other].baseNormal;
    if (normal.squaredNorm() > 0.0)
    {
      moved.baseNormal = normal.normalized();
    }
    moved.position = to;
    moved.moved |= Forest::Placed;
    this->Shares[v].value = level;
    this->Placed[v] = 1;
    ++this->Report.moved;
  }

  void move(double level, const std::vector<Crossing>& crossings)
  {
    this->Report.crossings += static_cast<int>(crossings.size());
    std::vector<Move> moves;
    for (const Crossing& c : crossings)
    {
      const Vector3 along = this->at(c.beyond) - this->at(c.within), to = this->at(c.within) + c.u * along;
      const double length = along.norm();
      if (this->mayGo(c.within, c.beyond))
      {
        moves.push_back({ c.u * length, c.within, c.beyond, to, c.u });
      }
      if (this->mayGo(c.beyond, c.within))
      {
        moves.push_back({ (1.0 - c.u) * length, c.beyond, c.within, to, 1.0 - c.u });
      }
    }
    std::sort(moves.begin(), moves.end());
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
      if (i % movesPerCheck == 0)
      {
        this->Caller.checkpoint(0.9);
      }
      const Move& m = moves[i];
      // An edge with an end on the level is crossed no more.
      if (this->Placed[m.vertex] || this->Shares[m.other].value == level)
      {
        continue;
      }
      if (!mayMove(this->Mesh, m.vertex, m.to, this->Options.minimumAngle, &this->First))
      {
        ++this->Report.refused;
        continue;
      }
      this->put(m.vertex, m.other, m.u, m.to, level);
    }
  }

  // What splits made and what the first of them changed is left as it is.
  void split(const std::vector<Crossing>& crossings, const MidpointRule& rule)
  {
    for (const Crossing& c : crossings)
    {
      const int f = this->Mesh.faceWithEdge(c.within, c.beyond);
      if (f < 0 || this->Mesh.faces[f].gen >= residualGeneration)
      {
        continue;
      }
      const Vector3 to = this->at(c.within) + c.u * (this->at(c.beyond) - this->at(c.within));
      std::vector<Forest::Birth> births;
      const int made = this->Mesh.refineEdge(c.within, c.beyond, rule, &births);
      this->First.resize(this->Mesh.vertices.size());
      for (const Forest::Birth& birth : births)
      {
        const int* ends = this->Mesh.vertices[birth.vertex].parents;
        this->First[birth.vertex] = 0.5 * (this->First[ends[0]] + this->First[ends[1]]);
      }
      if (mayMove(this->Mesh, made, to, this->Options.minimumAngle, &this->First))
      {
        this->Mesh.vertices[made].position = to;
        this->Mesh.vertices[made].moved |= Forest::Placed;
      }
      else if (narrowestOf(this->Mesh, births) < squaredSine(this->Options.minimumAngle))
      {
        weldBack(this->Mesh, births);
      }
    }
    this->Caller.checkpoint(1.0);
  }

  FootReport Report;
  Forest& Mesh;
  const FeatureCurves& Curves;
  const FootOptions& Options;
  const Context& Caller;
  CurveSearch Search;
  std::vector<Share> Shares;  // per vertex, before any split
  std::vector<char> Placed;   // per vertex: on foot or rim
  std::vector<Vector3> First; // where vertices were before they moved, by slot
  std::vector<int> Inside;    // reached vertices, ascending
};

} // namespace

FootReport snapFoot(Forest& forest,
  const FeatureCurves& curves,
  const FootOptions& options,
  const MidpointRule& source,
  const Context& context)
{
  checkCurves(curves);
  const auto steep = [&](const FeatureCurve& c) { return c.sharpness.value_or(options.sharpness) < 1.0; };
  if (std::none_of(curves.begin(), curves.end(), steep))
  {
    return {};
  }
  const bool own =
    std::all_of(curves.begin(), curves.end(), [](const FeatureCurve& c) { return c.radius.has_value(); });
  if (!own && !(options.radius > 0.0 && std::isfinite(options.radius)))
  {
    throw Error(Failure::BadStroke, "The Radius must be a positive number.");
  }
  if (!(options.sharpness >= 0.0 && options.minimumAngle >= 0.0 && options.minimumAngle <= 60.0))
  {
    throw Error(Failure::BadStroke,
      "The foot of a feature needs a Sharpness that is not negative and a minimum angle of 0 to 60 degrees.");
  }
  if (!options.parts.empty() && static_cast<int>(options.parts.size()) != forest.rootCount)
  {
    throw Error(
      Failure::BadStroke, "The foot of a feature needs a part for each triangle of the base mesh, or none.");
  }
  needBaseNormals(forest, context);
  return FootSnapper(forest, curves, options, context).run(source);
}

} // namespace oversketch
