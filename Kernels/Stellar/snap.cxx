#include "Stellar/snap.h"

#include "Mesh/context.h"
#include "Stellar/crossings.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

namespace oversketch
{

namespace
{

constexpr double onCurve = 1e-9;                        // edge lengths
constexpr double cornerCosine = 0.70710678118654752440; // a boundary that turns by more stays
constexpr int residualGeneration = 24;
constexpr double splitShare = 0.9; // of A2's angle: what a split may leave, since it halves angles
constexpr int facesPerScan = 4096;
constexpr int movesPerCheck = 1024; // moves between two looks at whether to stop

struct Found
{
  EdgeCrossing crossing;
  bool snapped[2]; // which ends were when it was found
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
  struct Scan
  {
    std::vector<EdgeCrossing> crossings;
    std::vector<std::pair<int, EdgeCrossing>> on; // vertices on a curve, that and the parameter
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
  bool mayGo(int v, int towards) const;
  bool unchanged(const Found& found) const;
  bool explained(const EdgeCrossing& crossing) const;
  void findAround(int v);
  std::vector<int> residual() const;
  double narrowestOf(const std::vector<Forest::Birth>& births) const;
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
  std::vector<Vector3> First;                         // where vertices were before they moved, by slot
  std::vector<Found> Crossings;                       // also those that are no longer
  std::vector<std::pair<int, Forest::Vertex>> Before; // of what this round has moved
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<Candidate>> Heap;
};

// Each edge is told of by its lower face, each vertex by the face that it names.
void Snapper::scan(int f, Scan& result) const
{
  const Forest::Face& face = this->Mesh.faces[f];
  double length = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    length += (this->vertex(face.v[(i + 1) % 3]).position - this->vertex(face.v[i]).position).norm() / 3.0;
    if (face.n[i] < 0 || f < face.n[i])
    {
      this->Finder.add(f, i, result.crossings);
    }
  }
  for (const int v : face.v)
  {
    if (this->vertex(v).face != f || this->snapped(v))
    {
      continue;
    }
    NearestOnCurve best;
    best.distance = onCurve * length;
    int curve = -1;
    for (int k = 0; k < static_cast<int>(this->Search.curves().size()); ++k)
    {
      const NearestOnCurve near = this->Search.nearest(k, this->vertex(v).position, best.distance);
      if (near.segment >= 0)
      {
        best = near;
        curve = k;
      }
    }
    if (curve >= 0)
    {
      result.on.push_back({ v, { { v, v }, curve, 0.0, best.parameter } });
    }
  }
}

void Snapper::mark(int v, int curve, double parameter)
{
  Forest::Vertex& moved = this->vertex(v);
  moved.curveId = curve;
  moved.curveParam = parameter;
  moved.moved |= Forest::Placed;
  ++this->Report.snapped;
}

void Snapper::put(int v, const EdgeCrossing& crossing, const Vector3& to)
{
  this->Before.emplace_back(v, this->vertex(v));
  Forest::Vertex& moved = this->vertex(v);
  const Vector3 normal = (1.0 - crossing.u) * this->vertex(crossing.ends[0]).baseNormal +
                         crossing.u * this->vertex(crossing.ends[1]).baseNormal;
  if (normal.squaredNorm() > 0.0)
  {
    moved.baseNormal = normal.normalized();
  }
  moved.position = to;
  this->mark(v, crossing.curve, crossing.parameter);
}

// A boundary vertex keeps to its boundary, a corner of it to its place.
bool Snapper::mayGo(int v, int towards) const
{
  if (!this->Mesh.onBoundary(v))
  {
    return true;
  }
  int first = -1, last = -1;
  this->Mesh.link(v,
    [&](int w)
    {
      first = first < 0 ? w : first;
      last = w;
    });
  const Vector3 in = this->vertex(v).position - this->vertex(first).position;
  const Vector3 out = this->vertex(last).position - this->vertex(v).position;
  return (towards == first || towards == last) && in.dot(out) >= cornerCosine * in.norm() * out.norm();
}

// A1: whether a snapped end stands for this crossing.
bool Snapper::explained(const EdgeCrossing& crossing) const
{
  const Forest::Vertex* ends[] = { &this->vertex(crossing.ends[0]), &this->vertex(crossing.ends[1]) };
  const double length = (ends[1]->position - ends[0]->position).norm();
  const FeatureCurve& curve = this->Search.curves()[crossing.curve];
  for (int i = 0; i < 2; ++i)
  {
    const double share = i == 0 ? crossing.u : 1.0 - crossing.u; // of the edge, from this end
    if (ends[i]->curveId >= 0 && share <= 0.25)
    {
      return true;
    }
    if (ends[i]->curveId == crossing.curve &&
        curve.apart(ends[i]->curveParam, crossing.parameter) < 0.5 * length)
    {
      return true;
    }
  }
  return ends[0]->curveId == crossing.curve && ends[1]->curveId == crossing.curve &&
         curve.apart(ends[0]->curveParam, ends[1]->curveParam) <= 2.0 * length;
}

// A vertex moves once, when it is snapped; so an edge is as it was if its ends' states are.
bool Snapper::unchanged(const Found& found) const
{
  return this->snapped(found.crossing.ends[0]) == found.snapped[0] &&
         this->snapped(found.crossing.ends[1]) == found.snapped[1];
}

void Snapper::remember(const EdgeCrossing& crossing)
{
  const bool nearest = this->Options.order == SnapOrder::Nearest;
  if (nearest && this->explained(crossing))
  {
    return;
  }
  const int id = static_cast<int>(this->Crossings.size());
  this->Crossings.push_back(
    { crossing, { this->snapped(crossing.ends[0]), this->snapped(crossing.ends[1]) } });
  const double length =
    (this->vertex(crossing.ends[1]).position - this->vertex(crossing.ends[0]).position).norm();
  for (int i = 0; i < 2; ++i)
  {
    const int v = crossing.ends[i], other = crossing.ends[1 - i];
    if (!this->snapped(v) && (!nearest || this->mayGo(v, other)))
    {
      this->Heap.push({ (i == 0 ? crossing.u : 1.0 - crossing.u) * length, v, other, id });
    }
  }
}

void Snapper::take(const Scan& scan)
{
  for (const auto& [v, at] : scan.on)
  {
    this->Before.emplace_back(v, this->vertex(v));
    this->mark(v, at.curve, at.parameter);
  }
  for (const EdgeCrossing& crossing : scan.crossings)
  {
    this->remember(crossing);
  }
}

void Snapper::start()
{
  const int slots = static_cast<int>(this->Mesh.faces.size());
  std::vector<Scan> parts((slots + facesPerScan - 1) / facesPerScan);
  this->Caller.parallelFor(static_cast<int>(parts.size()),
    [&](int begin, int end)
    {
      for (int c = begin; c < end && !this->Caller.cancelled(); ++c)
      {
        for (int f = c * facesPerScan; f < std::min((c + 1) * facesPerScan, slots); ++f)
        {
          if (this->Mesh.isFace(f) && this->Finder.near(f))
          {
            this->scan(f, parts[c]);
          }
        }
      }
    });
  this->Caller.checkpoint(0.3);
  Scan all;
  for (const Scan& part : parts)
  {
    all.on.insert(all.on.end(), part.on.begin(), part.on.end());
    all.crossings.insert(all.crossings.end(), part.crossings.begin(), part.crossings.end());
  }
  this->take(all);
  this->Report.crossings = static_cast<int>(this->Crossings.size());
}

void Snapper::allAtOnce()
{
  std::vector<std::pair<Candidate, Vector3>> moves;
  for (; !this->Heap.empty(); this->Heap.pop())
  {
    const Candidate& next = this->Heap.top();
    if (!this->snapped(next.vertex))
    {
      const EdgeCrossing& crossing = this->Crossings[next.found].crossing;
      moves.emplace_back(next, this->place(crossing));
      this->mark(next.vertex, crossing.curve, crossing.parameter);
    }
  }
  // Normals of all before any is changed.
  std::vector<Vector3> normals;
  for (const auto& [move, to] : moves)
  {
    const EdgeCrossing& crossing = this->Crossings[move.found].crossing;
    normals.push_back((1.0 - crossing.u) * this->vertex(crossing.ends[0]).baseNormal +
                      crossing.u * this->vertex(crossing.ends[1]).baseNormal);
  }
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    Forest::Vertex& moved = this->vertex(moves[i].first.vertex);
    moved.position = moves[i].second;
    moved.baseNormal = normals[i].squaredNorm() > 0.0 ? normals[i].normalized() : moved.baseNormal;
  }
}

// Crossings of the edges at a vertex that has moved.
void Snapper::findAround(int v)
{
  std::vector<EdgeCrossing> crossings;
  this->Mesh.star(v,
    [&](int f, int i)
    {
      this->Finder.add(f, (i + 2) % 3, crossings);
      if (this->Mesh.faces[f].n[(i + 1) % 3] < 0)
      {
        this->Finder.add(f, (i + 1) % 3, crossings);
      }
    });
  for (const EdgeCrossing& crossing : crossings)
  {
    this->remember(crossing);
  }
}

void Snapper::nearestFirst()
{
  for (int count = 1; !this->Heap.empty(); ++count)
  {
    if (count % movesPerCheck == 0)
    {
      this->Caller.checkpoint(0.5);
    }
    const Candidate next = this->Heap.top();
    this->Heap.pop();
    const Found found = this->Crossings[next.found];
    if (this->snapped(next.vertex) || !this->unchanged(found) || this->explained(found.crossing))
    {
      continue;
    }
    const Vector3 to = this->place(found.crossing);
    if (!mayMove(this->Mesh, next.vertex, to, this->Options.minimumAngle, &this->First))
    {
      ++this->Report.refused;
      continue;
    }
    this->put(next.vertex, found.crossing, to);
    this->findAround(next.vertex);
  }
}

std::vector<int> Snapper::residual() const
{
  std::vector<int> left;
  for (int i = 0; i < static_cast<int>(this->Crossings.size()); ++i)
  {
    const Found& found = this->Crossings[i];
    if (this->unchanged(found) && !this->explained(found.crossing) &&
        this->Mesh.faceWithEdge(found.crossing.ends[0], found.crossing.ends[1]) >= 0)
    {
      left.push_back(i);
    }
  }
  return left;
}

// Sine squared of the smallest angle of the faces that splits left in their slots.
double Snapper::narrowestOf(const std::vector<Forest::Birth>& births) const
{
  double least = 1.0;
  for (const Forest::Birth& birth : births)
  {
    for (const int f : { birth.parent, birth.child })
    {
      if (this->Mesh.isFace(f))
      {
        const int* v = this->Mesh.faces[f].v;
        least = std::min(least,
          narrowness(this->vertex(v[0]).position, this->vertex(v[1]).position, this->vertex(v[2]).position));
      }
    }
  }
  return least;
}

// Splits an edge and puts the new vertex where a curve crosses it, if the guard lets it.
void Snapper::split(const EdgeCrossing& crossing,
  const MidpointRule& rule,
  std::vector<Forest::Birth>& births)
{
  const Vector3 to = this->place(crossing);
  const int m = this->Mesh.refineEdge(crossing.ends[0], crossing.ends[1], rule, &births);
  this->First.resize(this->Mesh.vertices.size());
  for (const Forest::Birth& birth : births)
  {
    const int* ends = this->vertex(birth.vertex).parents;
    this->First[birth.vertex] = 0.5 * (this->First[ends[0]] + this->First[ends[1]]);
  }
  if (this->snapped(m))
  {
    return;
  }
  if (mayMove(this->Mesh, m, to, this->Options.minimumAngle, &this->First))
  {
    this->put(m, crossing, to);
  }
  else
  {
    ++this->Report.refused;
  }
}

// Undoes splits that nothing was split after.
void Snapper::weldBack(const std::vector<Forest::Birth>& births)
{
  for (auto birth = births.rbegin(); birth != births.rend(); ++birth)
  {
    if (this->Mesh.isVertex(birth->vertex)) // not gone with its twin
    {
      this->Mesh.weld(birth->vertex);
    }
  }
}

// The same, unless that makes triangles that are too narrow of such that were wider.
void Snapper::splitWithCare(const EdgeCrossing& crossing,
  const MidpointRule& rule,
  std::vector<Forest::Birth>& births)
{
  const int f = this->Mesh.faceWithEdge(crossing.ends[0], crossing.ends[1]);
  if (f < 0 || this->Mesh.faces[f].gen >= residualGeneration)
  {
    return;
  }
  const SnapReport report = this->Report;
  std::vector<Forest::Birth> own;
  this->split(crossing, rule, own);
  const double after = this->narrowestOf(own);
  if (after < squaredSine(splitShare * this->Options.minimumAngle))
  {
    this->weldBack(own);
    this->Report = report;
    const bool wider = after < this->narrowestOf(own);
    own.clear();
    if (wider)
    {
      ++this->Report.refused;
      return;
    }
    this->split(crossing, rule, own);
  }
  births.insert(births.end(), own.begin(), own.end());
}

// Crossings of the edges that splits have made.
void Snapper::findIn(const std::vector<Forest::Birth>& births)
{
  std::vector<int> faces, vertices;
  for (const Forest::Birth& birth : births)
  {
    faces.push_back(birth.parent);
    faces.push_back(birth.child);
    vertices.push_back(birth.vertex);
  }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  std::sort(vertices.begin(), vertices.end());
  const auto isNew = [&](int v) { return std::binary_search(vertices.begin(), vertices.end(), v); };
  Scan all, fresh;
  for (const int f : faces)
  {
    this->scan(f, all);
  }
  fresh.on = all.on;
  for (const EdgeCrossing& crossing : all.crossings)
  {
    if (isNew(crossing.ends[0]) || isNew(crossing.ends[1]))
    {
      fresh.crossings.push_back(crossing);
    }
  }
  this->take(fresh);
}

void Snapper::residualRounds(const MidpointRule& rule)
{
  std::vector<int> left = this->residual();
  for (int round = 0; round < this->Options.maximumResidualRounds && !left.empty(); ++round)
  {
    this->Caller.checkpoint(0.8);
    this->Report.split = true;
    const int faces = this->Mesh.faceCount();
    const SnapReport report = this->Report;
    this->Before.clear();
    std::vector<Forest::Birth> births;
    for (const int i : left)
    {
      const EdgeCrossing crossing = this->Crossings[i].crossing;
      this->splitWithCare(crossing, rule, births);
    }
    this->findIn(births);
    this->nearestFirst();
    this->Report.facesAdded += this->Mesh.faceCount() - faces;
    std::vector<int> now = this->residual();
    if (now.size() >= left.size())
    {
      this->takeBack(births);
      this->Report = report;
      break;
    }
    left = std::move(now);
  }
  this->Report.residual = static_cast<int>(left.size());
}

// Undoes a round.
void Snapper::takeBack(const std::vector<Forest::Birth>& births)
{
  this->weldBack(births);
  for (const auto& [v, before] : this->Before)
  {
    if (this->Mesh.isVertex(v))
    {
      const int face = this->vertex(v).face;
      this->vertex(v) = before;
      this->vertex(v).face = face;
    }
  }
}

} // namespace

SnapReport snap(Forest& forest,
  const FeatureCurves& curves,
  const SnapOptions& options,
  const MidpointRule& source,
  const Context& context)
{
  checkCurves(curves);
  if (!(options.minimumAngle >= 0.0 && options.minimumAngle <= 60.0) || options.maximumResidualRounds < 0)
  {
    throw Error(Failure::BadStroke,
      "Snapping needs a minimum angle of 0 to 60 degrees, and a number of residual rounds that is not "
      "negative.");
  }
  needBaseNormals(forest, context);
  Snapper snapper(forest, curves, options, context);
  snapper.start();
  if (options.order == SnapOrder::AllAtOnce)
  {
    snapper.allAtOnce();
    return snapper.result();
  }
  MidpointRule rule = source;
  rule.curves = &curves;
  snapper.nearestFirst();
  snapper.residualRounds(rule);
  context.checkpoint(1.0);
  return snapper.result();
}

} // namespace oversketch
