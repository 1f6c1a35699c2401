#include "Stellar/snap.h"

#include "Mesh/context.h"
#include "Stellar/quality.h"
#include "Stellar/snapper.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

namespace
{

constexpr double onCurve = 1e-9; // edge lengths
constexpr int facesPerScan = 4096;

} // namespace

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
  this->Moves.resize(this->Mesh.vertices.size(), 0);
  ++this->Moves[v];
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

// An edge is as it was if its ends have not moved.
bool Snapper::unchanged(const Found& found) const
{
  return this->movesOf(found.crossing.ends[0]) == found.moves[0] &&
         this->movesOf(found.crossing.ends[1]) == found.moves[1];
}

void Snapper::remember(const EdgeCrossing& crossing)
{
  const bool nearest = this->Options.order == SnapOrder::Nearest;
  const bool isHeld = this->stays(crossing.ends[0]) && this->stays(crossing.ends[1]);
  if (isHeld || (nearest && this->explained(crossing)))
  {
    return;
  }
  const int id = static_cast<int>(this->Crossings.size());
  this->Crossings.push_back(
    { crossing, { this->movesOf(crossing.ends[0]), this->movesOf(crossing.ends[1]) } });
  const double length =
    (this->vertex(crossing.ends[1]).position - this->vertex(crossing.ends[0]).position).norm();
  for (int i = 0; i < 2; ++i)
  {
    const int v = crossing.ends[i], other = crossing.ends[1 - i];
    if (!this->snapped(v) && !this->stays(v) &&
        (!nearest || keepsToLines(this->Mesh, v, other, this->Options.parts)))
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
  this->Caller.eachUntilCancelled(static_cast<int>(parts.size()),
    [&](int c)
    {
      for (int f = c * facesPerScan; f < std::min((c + 1) * facesPerScan, slots); ++f)
      {
        if (this->Mesh.isFace(f) && this->Finder.near(f))
        {
          this->scan(f, parts[c]);
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

// Crossings of the edges at a vertex.
std::vector<EdgeCrossing> Snapper::crossingsAround(int v) const
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
  return crossings;
}

void Snapper::findAround(int v)
{
  for (const EdgeCrossing& crossing : this->crossingsAround(v))
  {
    this->remember(crossing);
  }
}

int Snapper::countAround(int v) const
{
  const std::vector<EdgeCrossing> crossings = this->crossingsAround(v);
  return static_cast<int>(std::count_if(
    crossings.begin(), crossings.end(), [&](const EdgeCrossing& c) { return !this->explained(c); }));
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

SnapReport snap(Forest& forest,
  const FeatureCurves& curves,
  const SnapOptions& options,
  const MidpointRule& source,
  const Context& context)
{
  checkCurves(curves);
  if (!options.parts.empty() && static_cast<int>(options.parts.size()) != forest.rootCount)
  {
    throw Error(Failure::BadStroke, "Snapping needs a part for each triangle of the base mesh, or none.");
  }
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
  rule.staying = &options.staying;
  snapper.nearestFirst();
  snapper.residualRounds(rule);
  context.checkpoint(1.0);
  return snapper.result();
}

void CrossingFinder::add(int f, int i, std::vector<EdgeCrossing>& found) const
{
  const Forest::Face& face = this->Mesh.faces[f];
  const int first = face.v[(i + 1) % 3], second = face.v[(i + 2) % 3];
  const Vector3& a = this->Mesh.vertices[first].position;
  const Vector3& c = this->Mesh.vertices[second].position;
  const Vector3 edge = c - a;
  const double squared = edge.squaredNorm(), half = 0.5 * std::sqrt(squared);
  Vector3 normal = this->Mesh.facetNormal(f);
  if (face.n[i] >= 0)
  {
    normal += this->Mesh.facetNormal(face.n[i]);
  }
  const double length = normal.norm();
  if (!(squared > 0.0) || !(length > 0.0))
  {
    return;
  }
  normal /= length;
  const Vector3 across = normal.cross(edge), up = half * normal;
  Eigen::AlignedBox3d box(a + up);
  box.extend(a - up).extend(c + up).extend(c - up);
  const FeatureCurves& curves = this->Search.curves();
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const FeatureCurve& curve = curves[k];
    this->Search.meet(k,
      box,
      [&](int s)
      {
        const int next = curve.segmentEnd(s);
        const Vector3 from = curve.points[s] - a, to = curve.points[next] - a;
        const double left = across.dot(from), right = across.dot(to);
        if ((left >= 0.0) == (right >= 0.0))
        {
          return false;
        }
        const double w = left / (left - right);
        const Vector3 place = from + w * (to - from);
        const double u = place.dot(edge) / squared;
        const bool facing =
          curve.normals.empty() || ((1.0 - w) * curve.normals[s] + w * curve.normals[next]).dot(normal) > 0.0;
        if (u > 0.0 && u < 1.0 && std::abs(place.dot(normal)) <= half && facing)
        {
          const double end = next == 0 ? curve.length : curve.arc[next];
          found.push_back({ { first, second }, k, u, curve.arc[s] + w * (end - curve.arc[s]) });
        }
        return false;
      });
  }
}

bool CrossingFinder::near(int f) const
{
  const Forest::Face& face = this->Mesh.faces[f];
  Eigen::AlignedBox3d box;
  for (const int v : face.v)
  {
    box.extend(this->Mesh.vertices[v].position);
  }
  // Half the longest edge, which is no longer than the box's diagonal.
  const Vector3 margin = Vector3::Constant(0.5 * box.diagonal().norm());
  box.min() -= margin;
  box.max() += margin;
  for (int k = 0; k < static_cast<int>(this->Search.curves().size()); ++k)
  {
    if (this->Search.meet(k, box, [](int) { return true; }))
    {
      return true;
    }
  }
  return false;
}

} // namespace oversketch
