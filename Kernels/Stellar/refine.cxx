#include "Stellar/refine.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"
#include "Stellar/crossed_faces.h"
#include "Stellar/leaves.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iomanip>
#include <iterator>
#include <numeric>
#include <optional>
#include <sstream>
#include <utility>

namespace oversketch
{

namespace
{

constexpr double nearSource = 1e-9; // diagonals
constexpr double needle = 2.5;      // degrees, see SourceOptions
constexpr double wellWithin = 0.8;  // radii: where a curve hides the foot of another
constexpr double footWidth = 0.03;  // radii: inside the foot, where edges are as fine as there
constexpr double steepCrest = 2.0;  // the sharpness above which edges at the crest are too long

// A face as it was marked; what was split since is another one.
struct Mark
{
  int face;
  std::uint64_t path;
};

// A curve's demand of the faces near it.
struct Demand
{
  double radius, sharpness, edgeLength;
  double footLength = HUGE_VAL; // the same of faces that the foot passes through
};

Demand demandOf(const FeatureCurve& curve, const RefineOptions& options)
{
  Demand d{ curve.radius.value_or(options.radius),
    curve.sharpness.value_or(options.sharpness),
    options.targetEdgeLength };
  if (!(d.edgeLength > 0.0))
  {
    const bool published = !options.fineFoot, steepFoot = d.sharpness < 1.0;
    d.edgeLength = d.radius * (!published && (steepFoot || d.sharpness > steepCrest) ? 0.125 : 0.25);
    d.footLength = !published && steepFoot ? d.radius * 0.03125 : d.footLength;
  }
  return d;
}

// `added`: faces, more than the forest had at first.
void checkFaceCount(double added, int maximumFaces)
{
  if (added > maximumFaces)
  {
    std::ostringstream about;
    about << std::setprecision(2) << added;
    throw Error(Failure::BadRegion,
      "The refinement needs more than {maximumFaces} (%1) new triangles, about %2 or more; ask for longer "
      "edges ({targetEdgeLength}) or a larger tolerance, a smaller {radius} or {maxGeneration}.",
      maximumFaces,
      about.str());
  }
}

class Refiner
{
public:
  Refiner(Forest& forest, const FeatureCurves& curves, const RefineOptions& options, const Context& context)
    : Mesh(forest)
    , Options(options)
    , Run(context)
    , Search(curves)
    , Passes(forest, this->Search, context)
    , Reach(forest, this->Search, true)
    , FacesBefore(forest.faceCount())
    , LastReached(curves.size())
  {
    std::transform(curves.begin(),
      curves.end(),
      std::back_inserter(this->Demands),
      [&](const FeatureCurve& curve) { return demandOf(curve, options); });
  }

  // Faces to split, ascending.
  std::vector<Mark> marks()
  {
    this->cover();
    std::vector<Wish> wishes;
    for (int k = 0; k < static_cast<int>(this->Demands.size()); ++k)
    {
      const Demand& demand = this->Demands[k];
      const std::vector<Reached>& reached = this->reach(k);
      const int look = ++this->Looks;
      this->Looked.resize(this->Mesh.faces.size(), 0);
      std::vector<int> vertices(reached.size());
      std::transform(
        reached.begin(), reached.end(), vertices.begin(), [](const Reached& r) { return r.vertex; });
      this->forCandidates(k,
        vertices,
        [&](int f)
        {
          if (std::exchange(this->Looked[f], look) != look && this->asks(f, demand))
          {
            wishes.push_back({ f, this->leavesOf(f, demand) });
          }
        });
      this->LastReached[k] = std::move(vertices);
    }
    // The face's greatest wish comes first.
    std::sort(wishes.begin(),
      wishes.end(),
      [](const Wish& a, const Wish& b) { return a.face != b.face ? a.face < b.face : a.leaves > b.leaves; });
    wishes.erase(
      std::unique(
        wishes.begin(), wishes.end(), [](const Wish& a, const Wish& b) { return a.face == b.face; }),
      wishes.end());
    std::vector<Mark> marks;
    marks.reserve(wishes.size());
    double expected = this->added();
    for (const Wish& wish : wishes)
    {
      marks.push_back({ wish.face, this->Mesh.faces[wish.face].path });
      expected += wish.leaves - 1.0;
    }
    // It is an estimate: what it exceeds the limit by is to be sure.
    if (expected > 2.0 * this->Options.maximumFaces)
    {
      checkFaceCount(expected, this->Options.maximumFaces);
    }
    return marks;
  }

  void split(const std::vector<Mark>& marks, const MidpointRule& rule)
  {
    std::vector<Forest::Birth> births;
    for (std::size_t i = 0; i < marks.size(); ++i)
    {
      if (this->Mesh.faces[marks[i].face].path == marks[i].path)
      {
        this->Mesh.refine(marks[i].face, rule, &births);
      }
      checkFaceCount(this->added(), this->Options.maximumFaces);
      if (i % 4096 == 0)
      {
        this->Run.checkpoint(0.5);
      }
    }
    this->Passes.follow(births);
    this->Reach.follow(births);
    this->Born.clear();
    for (const Forest::Birth& birth : births)
    {
      this->Born.insert(this->Born.end(), { birth.parent, birth.child });
    }
    sortUnique(this->Born);
  }

private:
  const std::vector<Reached>& reach(int k)
  {
    return this->Reach.find(k,
      this->Passes.faces(k),
      { this->Demands[k].radius, this->Options.distance, this->Options.connectedOnly },
      this->Run);
  }

  // Marks what lies well within any curve's reach, where it matters.
  void cover()
  {
    this->Covered.clear();
    if (this->Demands.size() < 2 || std::none_of(this->Demands.begin(),
                                      this->Demands.end(),
                                      [](const Demand& demand) { return std::isfinite(demand.footLength); }))
    {
      return;
    }
    this->Covered.resize(this->Mesh.vertices.size(), 0);
    for (int k = 0; k < static_cast<int>(this->Demands.size()); ++k)
    {
      for (const Reached& reached : this->reach(k))
      {
        this->Covered[reached.vertex] |= reached.distance < wellWithin * this->Demands[k].radius;
      }
    }
  }

  // Calls look(face) for those that curve k may ask of, some more than once: where it reaches a corner, and
  // where it passes. Once that is done, only for those made since, and where what it reaches has changed;
  // the others have not asked and know nothing new, unless a front measures anew.
  template <class Look>
  void forCandidates(int k, const std::vector<int>& reached, const Look& look) const
  {
    const std::vector<int>& passed = this->Passes.faces(k);
    const bool again = !this->Born.empty() && this->Options.distance == CurveDistance::Straight;
    if (!again)
    {
      for (const int v : reached)
      {
        this->Mesh.star(v, [&](int f, int) { look(f); });
      }
      std::for_each(passed.begin(), this->Options.seedCurveFaces ? passed.end() : passed.begin(), look);
      return;
    }
    const auto lookIfNear = [&](int f)
    {
      const int* v = this->Mesh.faces[f].v;
      if (std::any_of(v, v + 3, [this](int corner) { return this->isReached(corner); }) ||
          (this->Options.seedCurveFaces && std::binary_search(passed.begin(), passed.end(), f)))
      {
        look(f);
      }
    };
    std::for_each(this->Born.begin(), this->Born.end(), lookIfNear);
    std::vector<int> changed;
    std::set_symmetric_difference(reached.begin(),
      reached.end(),
      this->LastReached[k].begin(),
      this->LastReached[k].end(),
      std::back_inserter(changed));
    for (const int v : changed)
    {
      this->Mesh.star(v, [&](int f, int) { lookIfNear(f); });
    }
  }

  // A face that asks, and how many leaves it will have where no further wish than that of its edge's length
  // is known: one more, unless the curve reaches all of it.
  struct Wish
  {
    int face;
    double leaves;
  };
  double leavesOf(int f, const Demand& demand) const
  {
    const Forest::Face& face = this->Mesh.faces[f];
    if (!std::all_of(face.v, face.v + 3, [this](int v) { return this->isReached(v); }))
    {
      return 2.0;
    }
    // A split halves a face, two of them its edges.
    const double ratio =
      (this->Mesh.vertices[face.v[1]].position - this->Mesh.vertices[face.v[2]].position).norm() /
      demand.edgeLength;
    return std::max(
      2.0, std::min(ratio * ratio, std::ldexp(1.0, this->Options.maximumGeneration - face.gen)));
  }
  double added() const { return static_cast<double>(this->Mesh.faceCount() - this->FacesBefore); }

  bool isReached(int v) const { return std::isfinite(this->Reach.distance(v)); }

  // Whether the feature ends within a face or next to it, and not in the midst of another curve's, which is
  // nearer there.
  bool isFoot(const Forest::Face& face, double radius) const
  {
    const auto reached = [this](int v) { return this->isReached(v); };
    const auto inside = [&](int v) { return this->Reach.distance(v) < (1.0 - footWidth) * radius; };
    const auto covered = [this](int v) { return !this->Covered.empty() && this->Covered[v] != 0; };
    return std::any_of(face.v, face.v + 3, reached) && !std::all_of(face.v, face.v + 3, inside) &&
           !std::all_of(face.v, face.v + 3, covered);
  }

  bool asks(int f, const Demand& demand) const
  {
    const Forest::Face& face = this->Mesh.faces[f];
    if (face.gen >= this->Options.maximumGeneration)
    {
      return false;
    }
    const int a = face.v[1], c = face.v[2];
    const double length = (this->Mesh.vertices[a].position - this->Mesh.vertices[c].position).norm();
    return length > demand.edgeLength || (length > demand.footLength && this->isFoot(face, demand.radius));
  }

  Forest& Mesh;
  const RefineOptions& Options;
  const Context& Run;
  CurveSearch Search;
  CrossedFaces Passes;
  CurveReach Reach;
  int FacesBefore;
  std::vector<Demand> Demands;               // of each curve
  std::vector<char> Covered;                 // per vertex; empty where no foot can be hidden
  std::vector<std::vector<int>> LastReached; // vertices, for each curve
  std::vector<int> Born;                     // faces that the last splits made; none before the first
  std::vector<int> Looked;                   // per face: the last of the looks, a curve's in a sweep, at it
  int Looks = 0;
};

void checkRefineOptions(const FeatureCurves& curves, const RefineOptions& options)
{
  checkCurves(curves);
  checkRadius(curves, options.radius);
  if (!std::isfinite(options.targetEdgeLength))
  {
    throw Error(Failure::BadStroke, "The {targetEdgeLength} must be a finite number.");
  }
  if (!(options.sharpness >= 0.0 && std::isfinite(options.sharpness)))
  {
    throw Error(Failure::BadStroke, "The {sharpness} must be zero or a positive number.");
  }
  if (options.maximumGeneration < 0 || options.maximumGeneration > Forest::maximumDepth)
  {
    throw Error(Failure::BadStroke, "{maxGeneration} must be between 0 and %1.", Forest::maximumDepth);
  }
}

// Splits a face, unless that makes needles of what was none: where the way back to the source leads far
// aside.
void refineWithCare(Forest& forest, int f, const MidpointRule& rule, std::vector<Forest::Birth>& births)
{
  std::vector<Forest::Birth> own;
  forest.refine(f, rule, &own);
  const double after = narrowestOf(forest, own);
  if (after < squaredSine(needle))
  {
    weldBack(forest, own);
    if (after < narrowestOf(forest, own))
    {
      return;
    }
    own.clear();
    forest.refine(f, rule, &own);
  }
  births.insert(births.end(), own.begin(), own.end());
}

} // namespace

void checkSnapped(const Forest& forest, const FeatureCurves& curves)
{
  // Snapping leaves vertices on their edges, and a curve may pass half an edge above or below: the edge as it
  // was then. The digest of the curves is what tells small differences.
  std::optional<double> tolerance; // once it is asked for
  for (std::size_t i = 0; i < forest.vertices.size(); ++i)
  {
    const Forest::Vertex& v = forest.vertices[i];
    if (v.curveId < 0)
    {
      continue;
    }
    double edge = 0.0;
    forest.link(static_cast<int>(i),
      [&](int w) { edge = std::max(edge, (forest.vertices[w].position - v.position).norm()); });
    const bool known = v.curveId < static_cast<int>(curves.size());
    const double away = known ? (curves[v.curveId].position(v.curveParam) - v.position).norm() : 0.0;
    if (known && !(away <= edge) && !tolerance)
    {
      tolerance = 0.02 * forest.diagonal();
    }
    if (!known || !(away <= edge || away <= *tolerance + edge))
    {
      throw Error(Failure::BadStroke,
        "Point %1 is snapped to curve %2 at arc length %3, where these curves have no such point; connect "
        "the curves that the mesh was snapped to.",
        i,
        v.curveId,
        v.curveParam);
    }
  }
}

MidpointRule midpointRule(const Forest& forest, const FeatureCurves* curves, const Source& source)
{
  return { curves, source, source ? nearSource * forest.diagonal() : 0.0 };
}

Forest refine(Forest forest,
  const FeatureCurves& curves,
  const RefineOptions& options,
  const Source& source,
  const Context& context,
  int* sweeps)
{
  checkRefineOptions(curves, options);
  checkSnapped(forest, curves);
  MidpointRule rule = midpointRule(forest, &curves, source);
  rule.staying = &options.staying;
  int done = 0;
  {
    Refiner refiner(forest, curves, options, context);
    for (std::vector<Mark> marks = refiner.marks(); !marks.empty(); marks = refiner.marks(), ++done)
    {
      refiner.split(marks, rule);
      context.checkpoint(1.0 - std::ldexp(1.0, -1 - std::min(done, 30)));
    }
  }
  assert(forest.broken().empty());
  if (sweeps)
  {
    *sweeps = done;
  }
  return done ? canonical(forest, context).forest : forest;
}

Forest refineToSource(const Forest& forest,
  const Source& source,
  const SourceOptions& options,
  const Context& context)
{
  if (!(options.tolerance > 0.0 && std::isfinite(options.tolerance)))
  {
    throw Error(Failure::BadMesh, "The {tolerance} must be a positive number.");
  }
  Forest work = forest.roomyCopy();
  const MidpointRule rule = midpointRule(forest, nullptr, source);
  const auto isOff = [&](int f)
  {
    const Forest::Face& face = work.faces[f];
    Vector3 weights[3];
    work.rootWeights(f, weights);
    const auto at = [&](int k) -> const Vector3& { return work.cornerOf(f, k); };
    const SourcePlace middles[] = { { face.root, 0.5 * (weights[1] + weights[2]), 0.5 * (at(1) + at(2)) },
      { face.root, (weights[0] + weights[1] + weights[2]) / 3.0, (at(0) + at(1) + at(2)) / 3.0 } };
    // The way back may lead aside of a middle, which is no deviation: how far it is from the leaves there.
    const auto farFrom = [&](int g, const Vector3& place)
    {
      return squaredDistance(work.cornerOf(g, 0), work.cornerOf(g, 1), work.cornerOf(g, 2), place) >
             options.tolerance * options.tolerance;
    };
    return std::any_of(std::begin(middles),
      std::end(middles),
      [&](const SourcePlace& middle)
      {
        const Vector3 place = source(middle);
        return farFrom(f, place) &&
               std::all_of(face.n, face.n + 3, [&](int g) { return g < 0 || farFrom(g, place); });
      });
  };
  std::vector<int> faces(work.faces.size());
  std::iota(faces.begin(), faces.end(), 0);
  while (!faces.empty())
  {
    std::vector<Mark> marks;
    for (int f : faces)
    {
      if (work.isFace(f) && work.faces[f].gen < options.maximumGeneration && isOff(f))
      {
        marks.push_back({ f, work.faces[f].path });
      }
    }
    context.checkpoint(0.5);
    std::vector<Forest::Birth> births;
    for (const Mark& mark : marks)
    {
      if (work.faces[mark.face].path == mark.path)
      {
        refineWithCare(work, mark.face, rule, births);
      }
      checkFaceCount(work.faceCount() - forest.faceCount(), options.maximumFaces);
    }
    faces.clear();
    for (const Forest::Birth& birth : births)
    {
      faces.insert(faces.end(), { birth.parent, birth.child });
    }
    sortUnique(faces);
  }
  return canonical(work, context).forest;
}

} // namespace oversketch
