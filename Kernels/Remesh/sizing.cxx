#include "Remesh/sizing.h"

#include "Remesh/patch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <queue>

namespace oversketch
{

namespace
{

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double largestGrowth = 4.0;     // in triangles, by the limit by diameter
constexpr double equilateral = 0.4330127; // area of a triangle with sides 1
// Twice the area over the perimeter of an equilateral triangle is its side over 3.4641; the rest lets squares
// that are cut in two pass for even, too.
constexpr double sideByWidth = 3.9;
// Least share of the side of equilateral triangles of the same area: needles ask for four times as many
// triangles at most.
constexpr double leastByArea = 0.5;

struct ActiveEdge
{
  int v0, v1;  // v0 < v1
  bool frozen; // held by an outside triangle, by more than two triangles, or by two wound against each other
  bool whole;  // not to be split: frozen, or folded
};

// The active triangles and those beside them, by themselves: all that follows is as large as they are. The
// vertices of active ones are numbered in their order, so that sums are the same as over the whole mesh; the
// others have no number, -1, nor a point.
struct Part
{
  Mesh mesh;
  std::vector<char> active;  // per triangle of the part
  std::vector<int> vertices; // in the whole mesh

  Part(const Mesh& whole, const std::vector<char>& wholeActive)
  {
    std::vector<int> number(whole.points.size(), -1);
    for (int t = 0; t < whole.triangleCount(); ++t)
    {
      for (int k = 0; wholeActive[t] && k < 3; ++k)
      {
        number[whole.triangles[t][k]] = 0;
      }
    }
    for (int v = 0; v < whole.vertexCount(); ++v)
    {
      if (number[v] == 0)
      {
        number[v] = this->mesh.vertexCount();
        this->mesh.points.push_back(whole.points[v]);
        this->vertices.push_back(v);
      }
    }
    for (int t = 0; t < whole.triangleCount(); ++t)
    {
      const Triangle& c = whole.triangles[t];
      const Triangle inside{ number[c[0]], number[c[1]], number[c[2]] };
      if ((inside[0] >= 0) + (inside[1] >= 0) + (inside[2] >= 0) > 1)
      {
        this->mesh.triangles.push_back(inside);
        this->active.push_back(wholeActive[t]);
      }
    }
  }
};

// Edges of the active triangles, ascending.
std::vector<ActiveEdge> activeEdges(const Part& part)
{
  struct Side
  {
    int v1, halfEdge;
  };
  const Mesh& mesh = part.mesh;
  const std::vector<char>& active = part.active;
  // Bucketed by the lower end, then sorted per bucket: several times quicker than sorting pairs.
  const auto eachSide = [&](auto&& visit)
  {
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      const Triangle& c = mesh.triangles[t];
      for (int k = 0; k < 3; ++k)
      {
        const int a = c[k], b = c[(k + 1) % 3];
        if (a >= 0 && b >= 0)
        {
          visit(std::min(a, b), Side{ std::max(a, b), 3 * t + k });
        }
      }
    }
  };
  std::vector<int> offsets(mesh.points.size() + 1, 0);
  eachSide([&](int v0, const Side&) { ++offsets[v0 + 1]; });
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  std::vector<Side> sides(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  eachSide([&](int v0, const Side& side) { sides[next[v0]++] = side; });
  std::vector<ActiveEdge> edges;
  edges.reserve(sides.size() / 2 + 1);
  for (int v0 = 0; v0 < mesh.vertexCount(); ++v0)
  {
    const auto begin = sides.begin() + offsets[v0], end = sides.begin() + offsets[v0 + 1];
    std::sort(begin,
      end,
      [](const Side& a, const Side& b) { return a.v1 != b.v1 ? a.v1 < b.v1 : a.halfEdge < b.halfEdge; });
    for (auto first = begin; first != end;)
    {
      int count = 0, activeCount = 0, forwardCount = 0;
      for (; first + count != end && (first + count)->v1 == first->v1; ++count)
      {
        const int h = (first + count)->halfEdge;
        activeCount += active[h / 3] ? 1 : 0;
        forwardCount += mesh.triangles[h / 3][h % 3] == v0 ? 1 : 0;
      }
      if (activeCount > 0)
      {
        const auto normal = [&](int side)
        {
          const Triangle& t = mesh.triangles[(first + side)->halfEdge / 3];
          return (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).eval();
        };
        const bool frozen = activeCount != count || count > 2 || (count == 2 && forwardCount != 1);
        edges.push_back({ v0, first->v1, frozen, frozen || (count == 2 && folded(normal(0), normal(1))) });
      }
      first += count;
    }
  }
  return edges;
}

// values[v] = min over u of values[u] + slope * way(u, v), along the edges; those that would not be under
// `limit` are let be.
void spread(const Mesh& mesh,
  const std::vector<ActiveEdge>& edges,
  double slope,
  double limit,
  std::vector<double>& values)
{
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto through = [&](int from, int to)
  { return values[from] + slope * (mesh.points[to] - mesh.points[from]).norm(); };
  const auto lowers = [&](int from, int to) { return through(from, to) < std::min(values[to], limit); };
  for (const ActiveEdge& e : edges)
  {
    if (lowers(e.v0, e.v1) || lowers(e.v1, e.v0))
    {
      const int from = lowers(e.v0, e.v1) ? e.v0 : e.v1;
      queue.push({ values[from], from });
    }
  }
  if (queue.empty())
  {
    return;
  }
  const Lists neighbours = Lists::gathered(mesh.points.size(),
    [&](auto&& visit)
    {
      for (const ActiveEdge& e : edges)
      {
        visit(e.v0, e.v1);
        visit(e.v1, e.v0);
      }
    });
  while (!queue.empty())
  {
    const auto [value, v] = queue.top();
    queue.pop();
    if (value > values[v])
    {
      continue;
    }
    for (const int u : neighbours[v])
    {
      if (lowers(v, u))
      {
        values[u] = through(v, u);
        queue.push({ values[u], u });
      }
    }
  }
}

} // namespace

std::vector<char> regionTriangles(const Mesh& mesh, const std::vector<char>& region)
{
  std::vector<char> active(mesh.triangles.size(), 0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    const Triangle& v = mesh.triangles[t];
    active[t] =
      v[0] != v[1] && v[1] != v[2] && v[2] != v[0] && region[v[0]] && region[v[1]] && region[v[2]] ? 1 : 0;
  }
  return active;
}

double guideLength(const Mesh& mesh, const std::vector<char>& active)
{
  const Part part(mesh, active);
  const std::vector<ActiveEdge> edges = activeEdges(part);
  double sum = 0.0;
  for (const ActiveEdge& e : edges)
  {
    sum += (part.mesh.points[e.v0] - part.mesh.points[e.v1]).norm();
  }
  return edges.empty() ? 0.0 : sum / static_cast<double>(edges.size());
}

std::vector<double> fittingLengths(const Mesh& mesh, const std::vector<char>& active)
{
  struct Sum
  {
    double area = 0.0, perimeter = 0.0, count = 0.0;
    void add(const Sum& other)
    {
      this->area += other.area;
      this->perimeter += other.perimeter;
      this->count += other.count;
    }
  };
  const auto gathered = [&](auto&& ofTriangle)
  {
    std::vector<Sum> sums(mesh.points.size());
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      if (active[t])
      {
        const Sum sum = ofTriangle(mesh.triangles[t]);
        for (const int v : mesh.triangles[t])
        {
          sums[v].add(sum);
        }
      }
    }
    return sums;
  };
  const std::vector<Sum> near = gathered(
    [&](const Triangle& c)
    {
      const Vector3 &p = mesh.points[c[0]], &q = mesh.points[c[1]], &r = mesh.points[c[2]];
      return Sum{ 0.5 * (q - p).cross(r - p).norm(), (q - p).norm() + (r - q).norm() + (p - r).norm(), 1.0 };
    });
  const std::vector<Sum> around = gathered(
    [&](const Triangle& c)
    {
      Sum sum = near[c[0]];
      sum.add(near[c[1]]);
      sum.add(near[c[2]]);
      return sum;
    });
  std::vector<double> lengths(mesh.points.size(), 0.0);
  for (std::size_t v = 0; v < lengths.size(); ++v)
  {
    const Sum& sum = around[v];
    if (sum.area > 0.0)
    {
      lengths[v] = std::max(sideByWidth * 2.0 * sum.area / sum.perimeter,
        leastByArea * std::sqrt(sum.area / (equilateral * sum.count)));
    }
  }
  return lengths;
}

std::vector<double> targetLengths(const Mesh& whole,
  const std::vector<char>& wholeActive,
  const std::vector<double>& diameters,
  const std::vector<double>& fitting,
  const Sizing& sizing)
{
  const Part part(whole, wholeActive);
  const Mesh& mesh = part.mesh;
  const std::vector<char>& active = part.active;
  const std::vector<ActiveEdge> edges = activeEdges(part);
  const auto valueOf = [](const std::vector<double>& values, int v)
  { return !values.empty() && std::isfinite(values[v]) && values[v] > 0.0 ? values[v] : infinite; };
  // Length for vertex v of the whole mesh, where the limit by diameter may ask for `lowest` at least.
  const auto wanted = [&](int v, double lowest) {
    return std::min({ sizing.length, std::max(0.5 * valueOf(diameters, v), lowest), valueOf(fitting, v) });
  };
  // Half a triangle per active one at least, even where the area is nothing: what the input has is no growth.
  const auto expected = [&](double lowest)
  {
    double count = 0.0;
    for (int t = 0; t < mesh.triangleCount(); ++t)
    {
      if (active[t])
      {
        const Triangle& c = mesh.triangles[t];
        double mean = 0.0;
        for (const int v : c)
        {
          mean += wanted(part.vertices[v], lowest) / 3.0;
        }
        count += facetArea(mesh, t) / (equilateral * mean * mean);
      }
    }
    return count;
  };
  double lowest = sizing.minimumFactor * sizing.length;
  const double allowed =
    std::max(largestGrowth * static_cast<double>(std::count(active.begin(), active.end(), 1)),
      expected(sizing.length));
  if (expected(lowest) > allowed)
  {
    double tooLow = lowest, enough = sizing.length;
    for (int step = 0; step < 20; ++step)
    {
      const double middle = 0.5 * (tooLow + enough);
      (expected(middle) > allowed ? tooLow : enough) = middle;
    }
    lowest = enough;
  }
  std::vector<double> target(mesh.points.size());
  std::transform(
    part.vertices.begin(), part.vertices.end(), target.begin(), [&](int v) { return wanted(v, lowest); });
  spread(mesh, edges, sizing.gradation, infinite, target);
  // Near edges that stay as they are (folded ones may still be collapsed): from above towards short ones,
  // from below towards long ones.
  std::vector<double> sum(mesh.points.size(), 0.0), count(mesh.points.size(), 0.0);
  std::vector<double> below(mesh.points.size(), infinite); // negative: from the longest edge down
  for (const ActiveEdge& e : edges)
  {
    for (const int v : { e.v0, e.v1 })
    {
      const double length = (mesh.points[e.v0] - mesh.points[e.v1]).norm();
      sum[v] += e.frozen ? length : 0.0;
      count[v] += e.frozen ? 1.0 : 0.0;
      below[v] = e.whole ? std::min(below[v], -length) : below[v];
    }
  }
  std::vector<double> above(mesh.points.size(), infinite);
  for (std::size_t v = 0; v < target.size(); ++v)
  {
    if (sum[v] > 0.0)
    {
      above[v] = sum[v] / count[v];
    }
  }
  // No target is over the wanted length, nor under 0.
  spread(mesh, edges, sizing.gradation, sizing.length, above);
  spread(mesh, edges, sizing.gradation, 0.0, below);
  std::vector<double> result(whole.points.size());
  for (int v = 0; v < whole.vertexCount(); ++v)
  {
    result[v] = wanted(v, lowest);
  }
  for (std::size_t v = 0; v < target.size(); ++v)
  {
    // A border edge much shorter than wanted is the outside's flaw: it shall not make the inside finer
    // without end.
    const double shortest = std::max(above[v], sizing.minimumFactor * sizing.length);
    result[part.vertices[v]] = std::max(std::min(target[v], shortest), -below[v]);
  }
  return result;
}

TriangleLimit limitTriangles(const Mesh& mesh, const std::vector<char>& active, std::vector<double>& targets)
{
  struct Asking
  {
    double area; // in equilateral ones of side 1
    Triangle corners;
    double longest; // edge, and its ends
    int from, to;
  };
  std::vector<Asking> asking; // the active triangles
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (active[t])
    {
      const Triangle& c = mesh.triangles[t];
      const Vector3 &p = mesh.points[c[0]], &q = mesh.points[c[1]], &r = mesh.points[c[2]];
      Asking one{ 0.5 * (q - p).cross(r - p).norm() / equilateral, c, -1.0, 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        const double length = (mesh.points[c[k]] - mesh.points[c[(k + 1) % 3]]).norm();
        if (length > one.longest)
        {
          one.longest = length;
          one.from = c[k];
          one.to = c[(k + 1) % 3];
        }
      }
      asking.push_back(one);
    }
  }
  const auto asked = [&](double lowest)
  {
    double count = 0.0;
    const auto size = [&](int v) { return std::max(targets[v], lowest); };
    for (const Asking& one : asking)
    {
      double byArea = 0.0;
      for (const int v : one.corners)
      {
        byArea += one.area > 0.0 ? one.area / (3.0 * size(v) * size(v)) : 0.0;
      }
      // A needle has as many as its long edge has parts, whose size goes evenly from one end's to the
      // other's.
      const double low = std::min(size(one.from), size(one.to)),
                   high = std::max(size(one.from), size(one.to));
      const double mean = high > low ? (high - low) / std::log(high / low) : low;
      count += std::max(byArea, one.longest > 0.0 ? one.longest / mean : 0.0);
    }
    return count;
  };
  const double present = static_cast<double>(asking.size());
  const double most = std::max(std::min(64.0 * present + 2e4, 5e5), largestGrowth * present);
  const double wanted = asked(0.0);
  const auto limitOf = [](double tooMany, double expected)
  {
    // Some are made and taken away again.
    constexpr double inPassing = 4.0, few = 2e4;
    return TriangleLimit{ tooMany,
      static_cast<int>(std::min(inPassing * expected + few, 0.5 * std::numeric_limits<int>::max())) };
  };
  if (!(wanted > most))
  {
    return limitOf(0.0, std::max(present, wanted));
  }
  // Each has one part of its longest edge then.
  double tooLow = 0.0, enough = 0.0;
  for (const Asking& one : asking)
  {
    enough = std::max(enough, one.longest);
  }
  for (int step = 0; step < 60; ++step)
  {
    const double middle = 0.5 * (tooLow + enough);
    (asked(middle) > most ? tooLow : enough) = middle;
  }
  for (double& target : targets)
  {
    target = std::max(target, enough);
  }
  return limitOf(wanted, most);
}

} // namespace oversketch
