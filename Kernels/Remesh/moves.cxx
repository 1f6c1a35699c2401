// The moves of incremental remeshing and the tests that keep them safe.
#include "Remesh/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

// Sines squared of smallest angles that a move may not go below, unless the triangles were narrower before.
constexpr double splitNarrowest = 0.0302;    // 10 degrees
constexpr double collapseNarrowest = 0.0670; // 15 degrees
constexpr double flipNarrowest = 0.1170;     // 20 degrees
constexpr double moveNarrowest = 0.1170;     // 20 degrees
// Cosine of the largest turn of a triangle's normal in one move, and of the dihedral angle a flip may cross.
constexpr double largestTurn = 0.5; // 60 degrees
// How far a vertex that goes or moves may leave the surface behind, in target lengths: keeps thin tips whole.
constexpr double collapseDeviation = 0.2;
constexpr double moveDeviation = 0.1;
constexpr double smallestMove = 0.01; // not worth the tests, in target lengths

// How far the middle of a split edge may be from the surface, squared and over the edge's length squared.
constexpr double largestOffset = 0.04;

bool contains(const Triangle& t, int v)
{
  return t[0] == v || t[1] == v || t[2] == v;
}

bool turned(const Vector3& before, const Vector3& after)
{
  return before.dot(after) < largestTurn * std::sqrt(before.squaredNorm() * after.squaredNorm());
}

// Sine squared of the smallest angle.
double narrowness(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& cross)
{
  const double l[3] = { (b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm() };
  const double shortest = std::min({ l[0], l[1], l[2] });
  const double others = l[0] == shortest ? l[1] * l[2] : l[1] == shortest ? l[0] * l[2] : l[0] * l[1];
  return others > 0.0 ? cross.squaredNorm() / others : 0.0;
}

int squaredDeviation(int valence, int best)
{
  return (valence - best) * (valence - best);
}

} // namespace

struct Patch::Fan
{
  std::vector<Triangle> triangles;
  std::vector<Vector3> crosses;
  double narrowest = std::numeric_limits<double>::infinity();

  void add(const std::vector<Vector3>& points, const Triangle& t)
  {
    const Vector3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
    const Vector3 cross = (b - a).cross(c - a);
    this->triangles.push_back(t);
    this->crosses.push_back(cross);
    this->narrowest = std::min(this->narrowest, narrowness(a, b, c, cross));
  }

  double distanceSquared(const std::vector<Vector3>& points, const Vector3& p) const
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : this->triangles)
    {
      const std::array<double, 3> w = closestWeights(points[t[0]], points[t[1]], points[t[2]], p);
      nearest = std::min(
        nearest, (w[0] * points[t[0]] + w[1] * points[t[1]] + w[2] * points[t[2]] - p).squaredNorm());
    }
    return nearest;
  }
};

Patch::Fan Patch::fanOf(const std::vector<int>& triangles) const
{
  Fan fan;
  fan.triangles.reserve(triangles.size());
  fan.crosses.reserve(triangles.size());
  for (const int t : triangles)
  {
    fan.add(this->points_, this->triangles_[t]);
  }
  return fan;
}

// How sharply folded the edges of a fan are, seen with what lies around it once `replaced` is gone: edges
// over 100 degrees weigh more than all edges over 90 together, so that no move trades the latter for the
// former.
int Patch::folds(const Fan& fan, const std::vector<int>& replaced) const
{
  int result = 0;
  const auto weigh = [&result](const Vector3& a, const Vector3& b)
  {
    if (a.dot(b) < 0.0)
    {
      result += folded(a, b) ? 1001 : 1;
    }
  };
  const std::size_t count = fan.triangles.size();
  for (std::size_t i = 0; i < count; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int p = fan.triangles[i][k], q = fan.triangles[i][(k + 1) % 3];
      bool within = false;
      for (std::size_t j = 0; j < count; ++j)
      {
        if (j != i && contains(fan.triangles[j], p) && contains(fan.triangles[j], q))
        {
          within = true;
          if (j > i)
          {
            weigh(fan.crosses[i], fan.crosses[j]);
          }
          break; // the triangles of a fan that may change are joined two by two
        }
      }
      if (within)
      {
        continue;
      }
      for (const int t : this->rings_[p])
      {
        if (contains(this->triangles_[t], q) &&
            std::find(replaced.begin(), replaced.end(), t) == replaced.end())
        {
          weigh(fan.crosses[i], this->cross(this->triangles_[t]));
        }
      }
    }
  }
  return result;
}

Vector3 Patch::cross(const Triangle& t) const
{
  return (this->points_[t[1]] - this->points_[t[0]]).cross(this->points_[t[2]] - this->points_[t[0]]);
}

void Patch::detach(int v, int t)
{
  std::vector<int>& ring = this->rings_[v];
  ring.erase(std::find(ring.begin(), ring.end(), t));
}

int Patch::addVertex(const SurfacePoint& at, bool fixedVertex, bool border)
{
  const int v = this->vertexCount();
  this->points_.push_back(positionOf(this->surface_.mesh(), at));
  this->places_.push_back(at);
  this->sizes_.push_back(this->sizeAt(at));
  this->fixed_.push_back(fixedVertex);
  this->border_.push_back(border);
  this->mergedInto_.push_back(v);
  this->rings_.emplace_back();
  return v;
}

void Patch::removeLastVertex()
{
  this->points_.pop_back();
  this->places_.pop_back();
  this->sizes_.pop_back();
  this->fixed_.pop_back();
  this->border_.pop_back();
  this->mergedInto_.pop_back();
  this->rings_.pop_back();
}

int Patch::split(int a, int b, std::array<int, 4>& neighbours)
{
  Faces faces;
  bool border = false;
  if (!this->facesOf(a, b, faces, border))
  {
    return -1;
  }
  if (!border && folded(this->cross(this->triangles_[faces[0]]), this->cross(this->triangles_[faces[1]])))
  {
    return -1; // two folded edges for one
  }
  const int faceCount = border ? 1 : 2;
  const bool kept = this->protectedEdge(a, b);
  const int chart = this->charts_[faces[0]];
  const bool seam = !border && this->charts_[faces[1]] != chart;
  SurfacePoint at;
  const bool straight = this->surface_.middle(this->places_[a], this->places_[b], seam ? -1 : chart, at);
  if (!straight)
  {
    if (kept || border)
    {
      return -1; // an edge of the input that must stay where it is, but cannot be found on it any more
    }
    const Vector3 middle = 0.5 * (this->points_[a] + this->points_[b]);
    at = this->surface_.closest(middle, this->surface_.inChart(this->places_[a], chart, middle).triangle);
    const SurfacePoint other =
      this->surface_.closest(middle, this->surface_.inChart(this->places_[b], chart, middle).triangle);
    if ((positionOf(this->surface_.mesh(), other) - middle).squaredNorm() <
        (positionOf(this->surface_.mesh(), at) - middle).squaredNorm())
    {
      at = other;
    }
    // A middle that the surface puts near one of the ends would leave the edge as long as it was, time and
    // again.
    const double offset = (positionOf(this->surface_.mesh(), at) - middle).squaredNorm();
    if (!(offset <= largestOffset * (this->points_[a] - this->points_[b]).squaredNorm()))
    {
      return -1;
    }
  }
  const int m = this->addVertex(at, kept || border, border);
  neighbours = { a, b, -1, -1 };
  std::vector<int> replaced;
  Fan after;
  for (int i = 0; i < faceCount; ++i)
  {
    replaced.push_back(faces[i]);
    neighbours[2 + i] = this->opposite(faces[i], a, b);
    for (const int end : { b, a })
    {
      Triangle half = this->triangles_[faces[i]];
      std::replace(half.begin(), half.end(), end, m);
      after.add(this->points_, half);
    }
  }
  const Fan before = this->fanOf(replaced);
  // Beside a long edge that cannot be split, splitting the others would go on for ever with ever flatter
  // triangles.
  bool good = after.narrowest >= std::min(splitNarrowest, 0.98 * before.narrowest) &&
              (straight || this->folds(after, replaced) <= this->folds(before, replaced));
  for (std::size_t i = 0; good && !straight && i < after.crosses.size(); ++i)
  {
    good = !turned(before.crosses[i / 2], after.crosses[i]);
  }
  if (!good)
  {
    this->removeLastVertex();
    return -1;
  }
  for (int i = 0; i < faceCount; ++i)
  {
    const int fresh = this->triangleCount();
    this->triangles_[faces[i]] = after.triangles[2 * i];
    this->triangles_.push_back(after.triangles[2 * i + 1]);
    this->active_.push_back(1);
    this->charts_.push_back(this->charts_[faces[i]]);
    this->detach(b, faces[i]);
    this->rings_[b].push_back(fresh);
    this->rings_[neighbours[2 + i]].push_back(fresh);
    this->rings_[m].push_back(faces[i]);
    this->rings_[m].push_back(fresh);
  }
  if (kept)
  {
    this->protectedEdges_.erase(std::minmax(a, b));
    this->protectedEdges_.insert(std::minmax(a, m));
    this->protectedEdges_.insert(std::minmax(b, m));
  }
  return m;
}

bool Patch::collapse(int from, int to, double longest)
{
  Faces faces;
  bool border = false;
  if (this->fixed_[from] || !this->facesOf(from, to, faces, border) || border)
  {
    return false;
  }
  const std::vector<int>& ring = this->rings_[from];
  // Link condition: the two vertices opposite the edge are the only common neighbours, and stay in at least
  // three triangles (one on a border).
  for (int i = 0; i < 2; ++i)
  {
    const int wing = this->opposite(faces[i], from, to);
    if (this->valence(wing) <= (this->border_[wing] ? 2 : 3))
    {
      return false;
    }
  }
  Fan after;
  for (const int t : ring)
  {
    for (const int w : this->triangles_[t])
    {
      if (w == from || w == to)
      {
        continue;
      }
      if (this->relativeLength(to, w) > longest)
      {
        return false;
      }
      const bool wing = contains(this->triangles_[faces[0]], w) || contains(this->triangles_[faces[1]], w);
      if (!wing && std::any_of(this->rings_[to].begin(),
                     this->rings_[to].end(),
                     [&](int s) { return contains(this->triangles_[s], w); }))
      {
        return false;
      }
    }
    if (t != faces[0] && t != faces[1])
    {
      Triangle moved = this->triangles_[t];
      std::replace(moved.begin(), moved.end(), from, to);
      const auto same = [&](int s)
      {
        const Triangle& c = this->triangles_[s];
        return contains(c, moved[0]) && contains(c, moved[1]) && contains(c, moved[2]);
      };
      if (turned(this->cross(this->triangles_[t]), this->cross(moved)) ||
          std::any_of(this->rings_[to].begin(), this->rings_[to].end(), same))
      {
        return false;
      }
      after.add(this->points_, moved);
    }
  }
  const double deviation = collapseDeviation * this->sizes_[from];
  const Fan before = this->fanOf(ring);
  if (after.narrowest < std::min(before.narrowest, collapseNarrowest) ||
      after.distanceSquared(this->points_, this->points_[from]) > deviation * deviation ||
      this->folds(after, ring) > this->folds(before, ring))
  {
    return false;
  }
  for (const int t : std::vector<int>(ring))
  {
    if (t == faces[0] || t == faces[1])
    {
      this->active_[t] = 0;
      this->detach(to, t);
      this->detach(this->opposite(t, from, to), t);
    }
    else
    {
      std::replace(this->triangles_[t].begin(), this->triangles_[t].end(), from, to);
      this->rings_[to].push_back(t);
    }
  }
  this->rings_[from].clear();
  this->mergedInto_[from] = to;
  return true;
}

bool Patch::flip(int a, int b, bool byAngle)
{
  Faces faces;
  bool border = false;
  if (!this->facesOf(a, b, faces, border) || border || this->protectedEdge(a, b))
  {
    return false;
  }
  const int c = this->opposite(faces[0], a, b), d = this->opposite(faces[1], a, b);
  const auto withD = [&](int t) { return contains(this->triangles_[t], d); };
  if (c == d || std::any_of(this->rings_[c].begin(), this->rings_[c].end(), withD))
  {
    return false;
  }
  const auto deviation = [this](int v, int change)
  { return squaredDeviation(this->valence(v) + change, this->border_[v] ? 4 : 6); };
  const int gain = deviation(a, 0) + deviation(b, 0) + deviation(c, 0) + deviation(d, 0) - deviation(a, -1) -
                   deviation(b, -1) - deviation(c, 1) - deviation(d, 1);
  const int least = 3;
  if ((!byAngle && gain <= 0) || this->valence(a) <= least || this->valence(b) <= least)
  {
    return false;
  }
  const std::vector<int> replaced{ faces[0], faces[1] };
  const Fan before = this->fanOf(replaced);
  Fan after;
  after.add(this->points_, { a, d, c });
  after.add(this->points_, { d, b, c });
  const Vector3 whole = before.crosses[0] + before.crosses[1];
  if (turned(before.crosses[0], before.crosses[1]) || turned(after.crosses[0], after.crosses[1]) ||
      turned(whole, after.crosses[0]) || turned(whole, after.crosses[1]) ||
      (byAngle ? after.narrowest <= 1.05 * before.narrowest
               : after.narrowest < std::min(before.narrowest, flipNarrowest)) ||
      this->folds(after, replaced) > this->folds(before, replaced))
  {
    return false;
  }
  this->triangles_[faces[0]] = after.triangles[0];
  this->triangles_[faces[1]] = after.triangles[1];
  this->detach(a, faces[1]);
  this->detach(b, faces[0]);
  // The first triangle now is (a, d, c), the second (d, b, c).
  this->rings_[c].push_back(faces[1]);
  this->rings_[d].push_back(faces[0]);
  return true;
}

// Towards the mean of the middles of the triangles around, weighed by area over target area: equal triangles
// on even ground, denser ones where the target is small.
SurfacePoint Patch::relaxed(int v) const
{
  Vector3 middle = Vector3::Zero(), normal = Vector3::Zero();
  double sum = 0.0;
  for (const int t : this->rings_[v])
  {
    const Triangle& c = this->triangles_[t];
    const Vector3 area = this->cross(c);
    const double size = this->sizes_[c[0]] + this->sizes_[c[1]] + this->sizes_[c[2]];
    const double weight = area.norm() / (size * size);
    middle += weight / 3.0 * (this->points_[c[0]] + this->points_[c[1]] + this->points_[c[2]]);
    sum += weight;
    normal += area;
  }
  const double length = normal.norm();
  if (!(sum > 0.0) || !(length > 0.0))
  {
    return this->places_[v];
  }
  normal /= length;
  Vector3 step = middle / sum - this->points_[v];
  step -= normal * normal.dot(step);
  return this->surface_.closest(this->points_[v] + step, this->places_[v].triangle);
}

bool Patch::move(int v, const SurfacePoint& to)
{
  const std::vector<int>& ring = this->rings_[v];
  Vector3 old = this->points_[v];
  const Vector3 wanted = positionOf(this->surface_.mesh(), to);
  if ((wanted - old).norm() < smallestMove * this->sizes_[v])
  {
    return false;
  }
  const Fan before = this->fanOf(ring);
  this->points_[v] = wanted;
  const Fan after = this->fanOf(ring);
  const double deviation = moveDeviation * this->sizes_[v];
  bool good = after.narrowest >= std::min(before.narrowest, moveNarrowest) &&
              after.distanceSquared(this->points_, old) <= deviation * deviation;
  for (std::size_t i = 0; good && i < ring.size(); ++i)
  {
    good = !turned(before.crosses[i], after.crosses[i]);
  }
  const int folded = good ? this->folds(after, ring) : 0;
  if (folded > 0)
  {
    this->points_[v].swap(old);
    good = folded <= this->folds(before, ring);
    this->points_[v].swap(old);
  }
  if (!good)
  {
    this->points_[v] = old;
    return false;
  }
  this->places_[v] = to;
  this->sizes_[v] = this->sizeAt(to);
  return true;
}

} // namespace oversketch
