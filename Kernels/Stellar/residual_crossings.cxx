#include "Stellar/snapper.h"

#include "Mesh/context.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double splitShare = 0.9;    // of A2's angle: what a split may leave, since it halves angles
constexpr double meetingShare = 0.25; // of a crossed edge: how near two curves are that meet there
constexpr double slideShare = 0.75;   // of a crossed edge: how far along the curve a vertex may go
constexpr int slideSteps = 6;

} // namespace

// The base normal where a vertex goes to, from the face of its star that is there or the nearest.
Vector3 Snapper::normalAt(int v, const Vector3& to) const
{
  const Vector3& own = this->vertex(v).baseNormal;
  const Forest::FacePlace at = this->Mesh.inStar(v, to);
  if (at.face < 0)
  {
    return own;
  }
  const int* c = this->Mesh.faces[at.face].v;
  const Vector3 w = at.weights.cwiseMax(0.0);
  const Vector3 sum = w[0] * this->vertex(c[0]).baseNormal + w[1] * this->vertex(c[1]).baseNormal +
                      w[2] * this->vertex(c[2]).baseNormal;
  return sum.squaredNorm() > 0.0 ? Vector3(sum.normalized()) : own;
}

// Where on a curve a vertex at a crossed edge may go: one that is on another curve to where the two meet, any
// other to the crossing and to both sides of it.
std::vector<Snapper::Place> Snapper::placesFor(int v, const EdgeCrossing& crossing) const
{
  const Forest::Vertex& own = this->vertex(v);
  const double length =
    (this->vertex(crossing.ends[1]).position - this->vertex(crossing.ends[0]).position).norm();
  if (own.curveId == crossing.curve || !this->isFree(v))
  {
    return {};
  }
  if (own.curveId >= 0)
  {
    const NearestOnCurve near =
      this->Search.nearest(own.curveId, this->place(crossing), meetingShare * length);
    return near.segment >= 0 ? std::vector<Place>{ { own.curveId, near.parameter } } : std::vector<Place>();
  }
  const FeatureCurve& curve = this->Search.curves()[crossing.curve];
  std::vector<Place> places;
  for (int i = 0; i <= slideSteps; ++i)
  {
    for (const double side : { 1.0, -1.0 })
    {
      double t = crossing.parameter + side * i * slideShare * length / slideSteps;
      if (curve.closed)
      {
        t -= curve.length * std::floor(t / curve.length);
      }
      if (t >= 0.0 && t <= curve.length && (i > 0 || side > 0.0))
      {
        places.push_back({ crossing.curve, t });
      }
    }
  }
  return places;
}

// Moves an end of a crossed edge along a curve, to the first of the places where the fewest crossings are
// left.
bool Snapper::slide(const EdgeCrossing& crossing)
{
  int best = -1, bestVertex = -1;
  Place bestPlace{ -1, 0.0 };
  const int nearer = crossing.u <= 0.5 ? 0 : 1;
  for (const int v : { crossing.ends[nearer], crossing.ends[1 - nearer] })
  {
    const int now = this->countAround(v);
    for (const Place& place : this->placesFor(v, crossing))
    {
      const Vector3 to = this->Search.curves()[place.curve].position(place.parameter);
      if (!mayMove(this->Mesh, v, to, this->Options.minimumAngle, &this->First))
      {
        continue;
      }
      const Forest::Vertex before = this->vertex(v);
      this->vertex(v).position = to;
      this->vertex(v).curveId = place.curve;
      this->vertex(v).curveParam = place.parameter;
      const int gain = now - this->countAround(v);
      this->vertex(v) = before;
      if (gain > 0 && gain > best)
      {
        best = gain;
        bestVertex = v;
        bestPlace = place;
      }
    }
  }
  if (best < 0)
  {
    return false;
  }
  const bool fresh = !this->snapped(bestVertex);
  const Vector3 to = this->Search.curves()[bestPlace.curve].position(bestPlace.parameter);
  const Vector3 normal = this->normalAt(bestVertex, to);
  this->Before.emplace_back(bestVertex, this->vertex(bestVertex));
  this->vertex(bestVertex).position = to;
  this->vertex(bestVertex).baseNormal = normal;
  this->mark(bestVertex, bestPlace.curve, bestPlace.parameter);
  this->Report.snapped -= fresh ? 0 : 1;
  this->findAround(bestVertex);
  return true;
}

// Crossings that are left since no end may come along its edge. Each slide leaves fewer of them, so this
// ends.
void Snapper::slide()
{
  for (bool moved = true; moved;)
  {
    moved = false;
    for (const int i : this->residual())
    {
      const Found found = this->Crossings[i];
      if (this->unchanged(found) && !this->explained(found.crossing))
      {
        moved = this->slide(found.crossing) || moved;
      }
    }
    this->nearestFirst();
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

// Undoes splits that nothing was split after; their crossings are none of later vertices of the same numbers.
void Snapper::weldBack(const std::vector<Forest::Birth>& births)
{
  oversketch::weldBack(this->Mesh, births);
  for (const Forest::Birth& birth : births)
  {
    this->Moves.resize(this->Mesh.vertices.size(), 0);
    ++this->Moves[birth.vertex];
  }
}

// Splits, unless that makes triangles that are too narrow of such that were wider.
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
  const double after = narrowestOf(this->Mesh, own);
  if (after < squaredSine(splitShare * this->Options.minimumAngle))
  {
    this->weldBack(own);
    this->Report = report;
    const bool wider = after < narrowestOf(this->Mesh, own);
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
  sortUnique(faces);
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
  if (this->Options.maximumResidualRounds > 0)
  {
    this->slide();
  }
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
    this->slide();
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
  for (auto one = this->Before.rbegin(); one != this->Before.rend(); ++one)
  {
    const auto& [v, before] = *one;
    if (this->Mesh.isVertex(v))
    {
      const int face = this->vertex(v).face;
      this->vertex(v) = before;
      this->vertex(v).face = face;
    }
  }
}

} // namespace oversketch
