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

double unfoldedDistance(double da, double db, double c, double vx, double vy)
{
  if (!(c > 0.0))
  {
    return unreached;
  }
  const double x = (da * da - db * db + c * c) / (2.0 * c), square = da * da - x * x;
  if (!(square >= 0.0))
  {
    return unreached;
  }
  const double y = std::sqrt(square), across = y + vy > 0.0 ? x + (vx - x) * y / (y + vy) : vx;
  return across >= 0.0 && across <= c ? std::hypot(vx - x, vy + y) : unreached;
}

double frontStep(double da, double db, const Vector3& toB, const Vector3& toV)
{
  const double direct = da + toV.norm();
  if (!std::isfinite(db))
  {
    return direct;
  }
  const double c = toB.norm();
  if (c > 0.0)
  {
    const double across = unfoldedDistance(da, db, c, toV.dot(toB) / c, toV.cross(toB).norm() / c);
    if (std::isfinite(across))
    {
      return across;
    }
  }
  return std::min(direct, db + (toV - toB).norm());
}

CurveReach::CurveReach(const Forest& forest, const CurveSearch& search, bool follows)
  : Mesh(forest)
  , Search(search)
  , Follows(follows)
  , Memories(search.curves().size())
{
}

const std::vector<Reached>& CurveReach::find(int curve,
  const std::vector<int>& faces,
  const ReachOptions& options,
  const Context& context)
{
  this->recall(curve, options);
  std::size_t known = this->Found.size();
  const bool grown = this->grow(faces, context),
             floods = options.kind == CurveDistance::Straight && options.connectedOnly;
  if (!grown)
  {
    known = 0;
    this->forget();
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
  }
  const auto lower = [](const Reached& a, const Reached& b) { return a.vertex < b.vertex; };
  const auto middle = this->Found.begin() + static_cast<std::ptrdiff_t>(known);
  std::sort(middle, this->Found.end(), lower);
  std::inplace_merge(this->Found.begin(), middle, this->Found.end(), lower);
  for (std::size_t i = 0; i < this->Found.size(); ++i)
  {
    this->Place[this->Found[i].vertex] = static_cast<int>(i);
  }
  Memory& memory = this->Memories[curve];
  memory.isWhole = grown || (this->Follows && floods && this->hangsTogether());
  memory.born.clear();
  return this->Found;
}

void CurveReach::follow(const std::vector<Forest::Birth>& births)
{
  for (Memory& memory : this->Memories)
  {
    if (memory.isWhole)
    {
      memory.born.insert(memory.born.end(), births.begin(), births.end());
    }
  }
}

void CurveReach::recall(int curve, const ReachOptions& options)
{
  const bool same = curve == this->Curve && options == this->Options;
  if (this->Curve >= 0 && !same)
  {
    Memory& last = this->Memories[this->Curve];
    for (const Reached& r : last.straight)
    {
      this->Known[r.vertex] = -1;
    }
    last.found = this->Found;
    this->forget();
  }
  this->Known.resize(this->Mesh.vertices.size(), -1);
  this->Place.resize(this->Mesh.vertices.size(), -1);
  if (same)
  {
    return;
  }
  this->Curve = curve;
  this->Options = options;
  Memory& memory = this->Memories[curve];
  if (!(memory.options == options))
  {
    memory = Memory();
    memory.options = options;
  }
  for (std::size_t i = 0; i < memory.straight.size(); ++i)
  {
    this->Known[memory.straight[i].vertex] = static_cast<int>(i);
  }
  for (const Reached& reached : memory.found)
  {
    this->put(reached);
  }
}

void CurveReach::forget()
{
  for (const Reached& r : this->Found)
  {
    this->Place[r.vertex] = -1;
  }
  this->Found.clear();
}

void CurveReach::put(const Reached& reached)
{
  this->Place[reached.vertex] = static_cast<int>(this->Found.size());
  this->Found.push_back(reached);
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
  context.eachUntilCancelled(
    count, [&](int v) { near[v] = this->Mesh.isVertex(v) && std::isfinite(this->straight(v).distance); });
  context.checkpoint(0.0);
  for (const int v : marked(near))
  {
    this->Found.push_back(this->straight(v));
  }
}

std::vector<Reached> CurveReach::measured(const std::vector<int>& vertices, const Context& context)
{
  std::vector<Reached> distances(vertices.size());
  // What is known, or a small ring, is not worth waking threads for.
  const auto isNew = [this](int v) { return this->Known[v] < 0; };
  const bool few = std::count_if(vertices.begin(), vertices.end(), isNew) < 512;
  const Context serial;
  (few ? serial : context)
    .each(static_cast<int>(vertices.size()), [&](int i) { distances[i] = this->straight(vertices[i]); });
  context.checkpoint(0.0);
  for (const Reached& r : distances)
  {
    this->remember(r);
  }
  return distances;
}

void CurveReach::flood(const std::vector<int>& faces, const Context& context)
{
  std::vector<int> ring;
  for (int f : faces)
  {
    ring.insert(ring.end(), this->Mesh.faces[f].v, this->Mesh.faces[f].v + 3);
  }
  this->spread(ring, context);
}

// Puts what of a ring is near and not there yet, and on from there.
void CurveReach::spread(const std::vector<int>& from, const Context& context)
{
  constexpr int looked = -2; // and too far, or not measured yet
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
  std::for_each(from.begin(), from.end(), look);
  while (!ring.empty())
  {
    const std::vector<Reached> distances = this->measured(ring, context);
    ring.clear();
    for (const Reached& r : distances)
    {
      if (std::isfinite(r.distance))
      {
        this->put(r);
        this->Mesh.link(r.vertex, look);
      }
    }
  }
  for (int v : seen)
  {
    this->Place[v] = std::max(this->Place[v], -1);
  }
}

// Whether what was found is joined by its edges to one piece.
bool CurveReach::hangsTogether() const
{
  std::vector<char> met(this->Found.size(), 0);
  std::vector<int> stack;
  std::size_t count = 0;
  const auto meet = [&](int v)
  {
    const int at = this->Place[v];
    if (at >= 0 && !met[at])
    {
      met[at] = 1;
      stack.push_back(v);
      ++count;
    }
  };
  for (std::size_t i = 0; i < std::min<std::size_t>(this->Found.size(), 1); ++i)
  {
    meet(this->Found[i].vertex);
  }
  while (!stack.empty())
  {
    const int v = stack.back();
    stack.pop_back();
    this->Mesh.link(v, meet);
  }
  return count == this->Found.size();
}

// Adds what new vertices join to a whole that the curve has reached. False where a flood is to find it anew:
// where an edge of it was split too far off and no triangle there leads round, so that it may have come
// apart, or where it is not all that the curve's faces begin with.
bool CurveReach::grow(const std::vector<int>& faces, const Context& context)
{
  const Memory& memory = this->Memories[this->Curve];
  if (!memory.isWhole)
  {
    return false;
  }
  std::vector<int> born, ring;
  for (const Forest::Birth& birth : memory.born)
  {
    if (born.empty() || born.back() != birth.vertex) // else of the edge's other side
    {
      born.push_back(birth.vertex);
    }
  }
  this->measured(born, context);
  const auto isNear = [this](int v) // and known to be
  { return this->Known[v] >= 0 && std::isfinite(this->straight(v).distance); };
  const auto gather = [&ring](int v) { ring.push_back(v); };
  for (std::size_t i = 0; i < memory.born.size(); ++i)
  {
    const Forest::Birth& birth = memory.born[i];
    const bool hasTwin = i + 1 < memory.born.size() && memory.born[i + 1].vertex == birth.vertex;
    const int m = birth.vertex, *ends = this->Mesh.vertices[m].parents;
    const bool near = isNear(m);
    if (!near && isNear(ends[0]) && isNear(ends[1]) && !isNear(birth.apex) &&
        !(hasTwin && isNear(memory.born[i + 1].apex)))
    {
      return false;
    }
    // What lies on an edge that ends in the whole is joined to it, and stays so, whatever is split next.
    if (near && (this->Place[ends[0]] >= 0 || this->Place[ends[1]] >= 0))
    {
      this->put(this->straight(m));
      this->Mesh.link(m, gather);
    }
    i += hasTwin ? 1 : 0;
  }
  for (const int m : born)
  {
    bool joined = false;
    if (this->Place[m] < 0 && isNear(m))
    {
      this->Mesh.link(m, [&](int w) { joined = joined || this->Place[w] >= 0; });
    }
    if (joined)
    {
      ring.push_back(m);
    }
  }
  this->spread(ring, context);
  bool begins = false;
  for (const int f : faces)
  {
    for (const int v : this->Mesh.faces[f].v)
    {
      const bool in = this->Place[v] >= 0;
      if (!in && std::isfinite(this->straight(v).distance))
      {
        return false;
      }
      begins = begins || in;
    }
  }
  return begins;
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
        this->put({ v, unreached, nearest.parameter });
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
          const double reached = frontStep(da, db, toB, toV);
          meet(v, reached);
        }
      });
  }
}

} // namespace oversketch
