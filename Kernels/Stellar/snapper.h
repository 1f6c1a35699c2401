// The work of snap.h, in steps: what it knows of a mesh while it snaps. Private to this folder.
#ifndef oversketch_kernels_stellar_snapper_h
#define oversketch_kernels_stellar_snapper_h

#include "Stellar/snap.h"

#include <functional>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace oversketch
{

// A curve passes over the edge from ends[0] to ends[1] at ends[0] + u (ends[1] - ends[0]).
struct EdgeCrossing
{
  int ends[2];
  int curve;
  double u;         // above 0, below 1
  double parameter; // of the curve [its arc length]
};

// Finds crossings. Curve and edge are projected along the mean normal of the edge's faces; they cross where
// the projections do and the two are not farther apart than half the edge. An edge whose normal points away
// from the curve's own (where it has normals) is on the other side of a thin part, and is not crossed (ours).
// A curve's sample that lies exactly over an edge counts for one of its two segments.
class CrossingFinder
{
public:
  CrossingFinder(const Forest& forest, const CurveSearch& search)
    : Mesh(forest)
    , Search(search)
  {
  }

  // Crossings of the edge of face f opposite its corner i are added to `found`, ascending by curve and
  // segment.
  void add(int f, int i, std::vector<EdgeCrossing>& found) const;

  // Whether a curve comes so near to a face that it may cross one of its edges.
  bool near(int f) const;

private:
  const Forest& Mesh;
  const CurveSearch& Search;
};

constexpr int residualGeneration = 24; // how deep edges are split that refinement left, the spec's
constexpr int movesPerCheck = 1024;    // moves between two looks at whether to stop

class Snapper
{
public:
  Snapper(Forest& forest, const FeatureCurves& curves, const SnapOptions& options, const Context& context)
    : Mesh(forest)
    , Options(options)
    , Caller(context)
    , Search(curves)
    , Finder(forest, this->Search)
  {
    this->First.reserve(forest.vertices.size() + forest.vertices.size() / 8);
    for (const Forest::Vertex& v : forest.vertices)
    {
      this->First.push_back(v.position);
    }
  }

  void start();
  void allAtOnce();
  void nearestFirst();
  void residualRounds(const MidpointRule& rule);

  const SnapReport& result() const { return this->Report; }

private:
  struct Found
  {
    EdgeCrossing crossing;
    int moves[2]; // of its ends, when it was found
  };

  struct Candidate
  {
    double distance;
    int vertex, other, found;
    bool operator>(const Candidate& o) const
    {
      return std::tie(this->distance, this->vertex, this->other, this->found) >
             std::tie(o.distance, o.vertex, o.other, o.found);
    }
  };

  struct Scan
  {
    std::vector<EdgeCrossing> crossings;
    std::vector<std::pair<int, EdgeCrossing>> on; // vertices on a curve, that and the parameter
  };
  struct Place // on a curve
  {
    int curve;
    double parameter;
  };

  Forest::Vertex& vertex(int v) const { return this->Mesh.vertices[v]; }
  bool snapped(int v) const { return this->vertex(v).curveId >= 0; }
  Vector3 place(const EdgeCrossing& c) const
  {
    const Vector3& a = this->vertex(c.ends[0]).position;
    return a + c.u * (this->vertex(c.ends[1]).position - a);
  }

  void scan(int f, Scan& result) const;
  void take(const Scan& scan);
  void remember(const EdgeCrossing& crossing);
  void mark(int v, int curve, double parameter);
  void put(int v, const EdgeCrossing& crossing, const Vector3& to);
  Vector3 normalAt(int v, const Vector3& to) const;
  std::vector<EdgeCrossing> crossingsAround(int v) const;
  int countAround(int v) const;
  std::vector<Place> placesFor(int v, const EdgeCrossing& crossing) const;
  bool slide(const EdgeCrossing& crossing);
  void slide();
  int movesOf(int v) const { return v < static_cast<int>(this->Moves.size()) ? this->Moves[v] : 0; }
  bool isFree(int v) const
  {
    return !this->Mesh.onBoundary(v) && !this->Mesh.onSeam(v, this->Options.parts) && !this->stays(v);
  }
  bool stays(int v) const { return this->Options.staying.at(this->Mesh, v); }
  bool unchanged(const Found& found) const;
  bool explained(const EdgeCrossing& crossing) const;
  void findAround(int v);
  std::vector<int> residual() const;
  void split(const EdgeCrossing& crossing, const MidpointRule& rule, std::vector<Forest::Birth>& births);
  void weldBack(const std::vector<Forest::Birth>& births);
  void splitWithCare(const EdgeCrossing& crossing,
    const MidpointRule& rule,
    std::vector<Forest::Birth>& births);
  void findIn(const std::vector<Forest::Birth>& births);
  void takeBack(const std::vector<Forest::Birth>& births);

  SnapReport Report;
  Forest& Mesh;
  const SnapOptions& Options;
  const Context& Caller;
  CurveSearch Search;
  CrossingFinder Finder;
  std::vector<int> Moves;                             // how often vertices moved, by slot, as far as any did
  std::vector<Vector3> First;                         // where vertices were before they moved, by slot
  std::vector<Found> Crossings;                       // also those that are no longer
  std::vector<std::pair<int, Forest::Vertex>> Before; // of what this round has moved
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> Heap;
};

} // namespace oversketch
#endif
