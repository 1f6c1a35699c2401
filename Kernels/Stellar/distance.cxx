#include "Stellar/distance.h"

#include "Mesh/context.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace oversketch
{

namespace
{

constexpr double unreached = std::numeric_limits<double>::infinity();

}

namespace
{

// unfoldedDistance, and where the way crosses the edge.
FrontStep unfolded(double da, double db, double c, double vx, double vy)
{
  if (!(c > 0.0))
  {
    return { unreached, 0.0 };
  }
  const double x = (da * da - db * db + c * c) / (2.0 * c), square = da * da - x * x;
  if (!(square >= 0.0))
  {
    return { unreached, 0.0 };
  }
  const double y = std::sqrt(square), across = y + vy > 0.0 ? x + (vx - x) * y / (y + vy) : vx;
  return { across >= 0.0 && across <= c ? std::hypot(vx - x, vy + y) : unreached, across / c };
}

}

double unfoldedDistance(double da, double db, double c, double vx, double vy)
{
  return unfolded(da, db, c, vx, vy).distance;
}

FrontStep frontStep(double da, double db, const Vector3& toB, const Vector3& toV)
{
  const double direct = da + toV.norm();
  if (!std::isfinite(db))
  {
    return { direct, 0.0 };
  }
  const double c = toB.norm();
  if (c > 0.0)
  {
    const FrontStep across = unfolded(da, db, c, toV.dot(toB) / c, toV.cross(toB).norm() / c);
    if (std::isfinite(across.distance))
    {
      return across;
    }
  }
  const double other = db + (toV - toB).norm();
  return other < direct ? FrontStep{ other, 1.0 } : FrontStep{ direct, 0.0 };
}

Vector3 nearestWeights(const Vector3& at, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const auto onEdge = [&at](const Vector3& from, const Vector3& to)
  {
    const double square = (to - from).squaredNorm();
    return square > 0.0 ? std::clamp((at - from).dot(to - from) / square, 0.0, 1.0) : 0.0;
  };
  const Vector3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area > 0.0)
  {
    const double wb = (at - a).cross(c - a).dot(normal) / area;
    const double wc = (b - a).cross(at - a).dot(normal) / area;
    if (wb >= 0.0 && wc >= 0.0 && wb + wc <= 1.0)
    {
      return { 1.0 - wb - wc, wb, wc };
    }
  }
  const double ab = onEdge(a, b), bc = onEdge(b, c), ca = onEdge(c, a);
  const Vector3 candidates[] = { { 1.0 - ab, ab, 0.0 }, { 0.0, 1.0 - bc, bc }, { ca, 0.0, 1.0 - ca } };
  return *std::min_element(std::begin(candidates),
    std::end(candidates),
    [&](const Vector3& x, const Vector3& y)
    {
      return (x[0] * a + x[1] * b + x[2] * c - at).squaredNorm() <
             (y[0] * a + y[1] * b + y[2] * c - at).squaredNorm();
    });
}

double distanceToTriangle(const Vector3& at, const Vector3& p, const Vector3& a, const Vector3& c)
{
  const Vector3 x = a - p, y = c - p, d = at - p, n = x.cross(y);
  const double square = n.squaredNorm();
  if (square > 0.0)
  {
    const double u = d.cross(y).dot(n) / square, v = x.cross(d).dot(n) / square;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0)
    {
      return std::abs(n.dot(d)) / std::sqrt(square);
    }
  }
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [from, to] : { std::make_pair(p, a), std::make_pair(a, c), std::make_pair(c, p) })
  {
    const Vector3 along = to - from;
    const double length = along.squaredNorm();
    const double t = length > 0.0 ? std::clamp(along.dot(at - from) / length, 0.0, 1.0) : 0.0;
    best = std::min(best, (at - from - t * along).norm());
  }
  return best;
}

CurveReach::CurveReach(const Forest& forest, const CurveSearch& search)
  : Mesh(forest)
  , Search(search)
  , Memories(search.curves().size())
{
}

const std::vector<Reached>& CurveReach::find(int curve,
  const std::vector<int>& faces,
  const ReachOptions& options,
  const Context& context)
{
  for (const Reached& r : this->Found)
  {
    this->Place[r.vertex] = -1;
  }
  this->Found.clear();
  this->Place.resize(this->Mesh.vertices.size(), -1);
  this->recall(curve, options);
  if (options.kind == CurveDistance::Geodesic)
  {
    this->front(faces, context);
  }
  else if (options.connectedOnly)
  {
    this->flood(faces, context);
  }
  else
  {
    this->everywhere(context);
  }
  std::sort(this->Found.begin(),
    this->Found.end(),
    [](const Reached& a, const Reached& b) { return a.vertex < b.vertex; });
  for (std::size_t i = 0; i < this->Found.size(); ++i)
  {
    this->Place[this->Found[i].vertex] = static_cast<int>(i);
  }
  return this->Found;
}

void CurveReach::recall(int curve, const ReachOptions& options)
{
  if (this->Curve >= 0)
  {
    for (const Reached& r : this->Memories[this->Curve].straight)
    {
      this->Known[r.vertex] = -1;
    }
  }
  this->Known.resize(this->Mesh.vertices.size(), -1);
  this->Curve = curve;
  this->Options = options;
  Memory& memory = this->Memories[curve];
  if (memory.radius != options.radius)
  {
    memory = { options.radius, {} };
  }
  for (std::size_t i = 0; i < memory.straight.size(); ++i)
  {
    this->Known[memory.straight[i].vertex] = static_cast<int>(i);
  }
}

void CurveReach::remember(const Reached& measured)
{
  std::vector<Reached>& straight = this->Memories[this->Curve].straight;
  if (this->Known[measured.vertex] < 0)
  {
    this->Known[measured.vertex] = static_cast<int>(straight.size());
    straight.push_back(measured);
  }
}

double CurveReach::distance(int vertex) const
{
  const int at = this->Place[vertex];
  return at < 0 ? unreached : this->Found[at].distance;
}

double CurveReach::distanceOfMiddle(int a, int b) const
{
  const double da = this->distance(a), db = this->distance(b);
  const Vector3 &pa = this->Mesh.vertices[a].position, &pb = this->Mesh.vertices[b].position;
  const double straight = this->Search.nearest(this->Curve, 0.5 * (pa + pb), this->Options.radius).distance;
  if (this->Options.kind == CurveDistance::Straight)
  {
    return std::isfinite(da) || std::isfinite(db) ? straight : unreached;
  }
  const double c = (pa - pb).norm(),
               behind = std::min(unfoldedDistance(da, db, c, 0.5 * c, 0.0), std::min(da, db) + 0.5 * c);
  return behind < this->Options.radius ? std::max(behind, straight) : unreached;
}

// Infinite where it is not nearer than the radius.
Reached CurveReach::straight(int vertex) const
{
  if (const int known = this->Known[vertex]; known >= 0)
  {
    return this->Memories[this->Curve].straight[known];
  }
  const Forest::Vertex& v = this->Mesh.vertices[vertex];
  if (v.curveId == this->Curve)
  {
    return { vertex, 0.0, v.curveParam };
  }
  const NearestOnCurve nearest = this->Search.nearest(this->Curve, v.position, this->Options.radius);
  return { vertex, nearest.distance, nearest.parameter };
}

void CurveReach::everywhere(const Context& context)
{
  const int count = static_cast<int>(this->Mesh.vertices.size());
  std::vector<char> near(count, 0);
  context.parallelFor(count,
    [&](int begin, int end)
    {
      for (int v = begin; v < end && !context.cancelled(); ++v)
      {
        near[v] = this->Mesh.isVertex(v) && std::isfinite(this->straight(v).distance);
      }
    });
  context.checkpoint(0.0);
  for (int v = 0; v < count; ++v)
  {
    if (near[v])
    {
      this->Found.push_back(this->straight(v));
    }
  }
}

void CurveReach::flood(const std::vector<int>& faces, const Context& context)
{
  constexpr int looked = -2; // and too far
  std::vector<int> seen, ring;
  const auto look = [&](int v)
  {
    if (this->Place[v] == -1)
    {
      this->Place[v] = looked;
      ring.push_back(v);
      seen.push_back(v);
    }
  };
  for (int f : faces)
  {
    std::for_each(this->Mesh.faces[f].v, this->Mesh.faces[f].v + 3, look);
  }
  std::vector<Reached> distances;
  while (!ring.empty())
  {
    distances.resize(ring.size());
    const auto measure = [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        distances[i] = this->straight(ring[i]);
      }
    };
    // What is known, or a small ring, is not worth waking threads for.
    const auto isNew = [this](int v) { return this->Known[v] < 0; };
    if (std::count_if(ring.begin(), ring.end(), isNew) < 512)
    {
      measure(0, static_cast<int>(ring.size()));
    }
    else
    {
      context.parallelFor(static_cast<int>(ring.size()), measure);
    }
    context.checkpoint(0.0);
    ring.clear();
    for (const Reached& r : distances)
    {
      this->remember(r);
      if (std::isfinite(r.distance))
      {
        this->Found.push_back(r);
        this->Mesh.link(r.vertex, look);
      }
    }
  }
  for (int v : seen)
  {
    this->Place[v] = -1;
  }
}

void CurveReach::front(const std::vector<int>& faces, const Context& context)
{
  // Found holds what was met, Place where; done: what the front has passed.
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  std::vector<char> done;
  std::vector<double> least; // through space
  const auto meet = [&](int v, double distance)
  {
    int& at = this->Place[v];
    if (at < 0 && distance < this->Options.radius)
    {
      const Reached nearest = this->straight(v);
      this->remember(nearest);
      if (std::isfinite(nearest.distance))
      {
        at = static_cast<int>(this->Found.size());
        this->Found.push_back({ v, unreached, nearest.parameter });
        done.push_back(0);
        least.push_back(nearest.distance);
      }
    }
    if (at >= 0 && !done[at] && std::max(distance, least[at]) < this->Found[at].distance)
    {
      this->Found[at].distance = std::max(distance, least[at]);
      queue.emplace(this->Found[at].distance, v);
    }
  };
  for (int f : faces)
  {
    for (int v : this->Mesh.faces[f].v)
    {
      meet(v, 0.0); // as far as through space
    }
  }
  for (int steps = 0; !queue.empty(); ++steps)
  {
    if (steps % 4096 == 0)
    {
      context.checkpoint(0.0);
    }
    const auto [da, a] = queue.top();
    queue.pop();
    if (done[this->Place[a]])
    {
      continue;
    }
    done[this->Place[a]] = 1;
    const Vector3& pa = this->Mesh.vertices[a].position;
    this->Mesh.star(a,
      [&, da = da](int f, int i)
      {
        const int* corners = this->Mesh.faces[f].v;
        for (int side = 1; side < 3; ++side)
        {
          // From a and b, if the front has passed that, to v.
          const int b = corners[(i + side) % 3], v = corners[(i + 3 - side) % 3];
          const Vector3 toV = this->Mesh.vertices[v].position - pa,
                        toB = this->Mesh.vertices[b].position - pa;
          const bool passed = this->Place[b] >= 0 && done[this->Place[b]];
          const double db = passed ? this->Found[this->Place[b]].distance : unreached;
          const double reached = frontStep(da, db, toB, toV).distance;
          meet(v, reached);
        }
      });
  }
}

} // namespace oversketch
