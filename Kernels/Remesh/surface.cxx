#include "Remesh/surface.h"

#include "Mesh/nearest.h"

#include <algorithm>
#include <numeric>

namespace oversketch
{

namespace
{

constexpr int maximumSteps =
  200; // a walk that long has lost its way; where it stands is still on the surface

// The corners that a place hangs on: vertex ids with a weight other than zero.
int supportOf(const Mesh& mesh, const SurfacePoint& at, std::array<int, 3>& vertices)
{
  int count = 0;
  for (int k = 0; k < 3; ++k)
  {
    if (at.weights[k] != 0.0)
    {
      vertices[count++] = mesh.triangles[at.triangle][k];
    }
  }
  return count;
}

// The place as seen from another triangle that holds all its support, or triangle -1.
SurfacePoint seenFrom(const Mesh& mesh, const SurfacePoint& at, int triangle)
{
  SurfacePoint result{ triangle, { 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    if (at.weights[k] != 0.0)
    {
      const int corner = cornerOf(mesh.triangles[triangle], mesh.triangles[at.triangle][k]);
      if (corner < 0)
      {
        result.triangle = -1;
        return result;
      }
      result.weights[corner] = at.weights[k];
    }
  }
  return result;
}

} // namespace

const std::vector<int> Surface::oneChart;

Surface::Surface(const Mesh& mesh, const std::vector<char>& active, const std::vector<int>& charts)
  : Model(mesh)
  , Charts(charts)
{
  this->listTriangles(active);
  this->linkHalfEdges(active);
}

Surface::Surface(const Mesh& mesh)
  : Model(mesh)
  , Charts(oneChart)
{
  this->listTriangles(std::vector<char>(mesh.triangles.size(), 1));
}

void Surface::listTriangles(const std::vector<char>& active)
{
  const Mesh& mesh = this->Model;
  this->VertexTriangles = Lists::gathered(mesh.points.size(),
    [&](auto&& visit)
    {
      for (int t = 0; t < mesh.triangleCount(); ++t)
      {
        for (int k = 0; active[t] && k < 3; ++k)
        {
          visit(mesh.triangles[t][k], t);
        }
      }
    });
}

// As linkHalfEdges finds it, where all triangles are active; -1 where there is none.
int Surface::findTwin(int h) const
{
  const auto origin = [this](int side) { return this->Model.triangles[side / 3][side % 3]; };
  const auto target = [this](int side) { return this->Model.triangles[side / 3][(side % 3 + 1) % 3]; };
  const int a = origin(h), b = target(h);
  int twin = -1, others = 0, last = -1;
  for (const int* t = this->VertexTriangles.begin(a); a != b && t != this->VertexTriangles.end(a); ++t)
  {
    for (int side = 3 * *t; *t != last && side < 3 * *t + 3; ++side)
    {
      const bool against = origin(side) == b && target(side) == a;
      if (side != h && (against || (origin(side) == a && target(side) == b)))
      {
        twin = against ? side : -1;
        ++others;
      }
    }
    last = *t;
  }
  return others == 1 ? twin : -1;
}

// Half-edges of the vertices of active triangles, bucketed by the lower end and matched there.
void Surface::linkHalfEdges(const std::vector<char>& active)
{
  const Lists& around = this->VertexTriangles;
  const int count = 3 * this->Model.triangleCount();
  const auto ends = [this](int h)
  {
    const Triangle& t = this->Model.triangles[h / 3];
    return std::minmax(t[h % 3], t[(h + 1) % 3]);
  };
  const auto inside = [&around](int v) { return around.size(v) > 0; };
  std::vector<int> offsets(this->Model.points.size() + 1, 0);
  this->Twins.resize(count);
  for (int h = 0; h < count; ++h)
  {
    const auto [a, b] = ends(h);
    this->Twins[h] = -2 - h;
    offsets[a + 1] += a != b && inside(a) && inside(b) ? 1 : 0;
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
  struct Side
  {
    int end, h;
  };
  std::vector<Side> sides(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (int h = 0; h < count; ++h)
  {
    const auto [a, b] = ends(h);
    if (a != b && inside(a) && inside(b))
    {
      sides[next[a]++] = { b, h };
    }
  }
  for (std::size_t v = 0; v < this->Model.points.size(); ++v)
  {
    const auto begin = sides.begin() + offsets[v], end = sides.begin() + offsets[v + 1];
    std::sort(
      begin, end, [](const Side& a, const Side& b) { return a.end != b.end ? a.end < b.end : a.h < b.h; });
    for (auto first = begin; first != end;)
    {
      auto last = first + 1;
      for (; last != end && last->end == first->end; ++last)
      {
      }
      const int a = first->h, b = (last - 1)->h;
      const auto originOf = [this](int h) { return this->Model.triangles[h / 3][h % 3]; };
      if (last - first == 1)
      {
        this->Twins[a] = active[a / 3] ? -1 : -2 - a;
      }
      else if (last - first == 2 && active[a / 3] && active[b / 3] && originOf(a) != originOf(b))
      {
        this->Twins[a] = b;
        this->Twins[b] = a;
      }
      else
      {
        for (auto side = first; side != last; ++side)
        {
          this->Twins[side->h] = -2 - (side + 1 == last ? first : side + 1)->h;
        }
      }
      first = last;
    }
  }
}

int Surface::towards(const Vector3& p, int start) const
{
  int at = start, from = -1;
  for (int step = 0; step < maximumSteps; ++step)
  {
    const Triangle& t = this->Model.triangles[at];
    const Vector3 &a = this->Model.points[t[0]], &b = this->Model.points[t[1]], &c = this->Model.points[t[2]];
    const Vector3 normal = (b - a).cross(c - a);
    const double inside[3] = {
      normal.dot((b - a).cross(p - a)), normal.dot((c - b).cross(p - b)), normal.dot((a - c).cross(p - c))
    };
    const auto least = static_cast<int>(std::min_element(inside, inside + 3) - inside);
    const int twin = inside[least] < 0.0 ? this->twin(3 * at + least) : -1;
    if (twin < 0 || twin / 3 == from || this->chart(twin / 3) != this->chart(at))
    {
      break;
    }
    from = at;
    at = twin / 3;
  }
  return at;
}

SurfacePoint Surface::closest(const Vector3& p, int start) const
{
  SurfacePoint best{ start };
  double bestDistance = std::numeric_limits<double>::infinity();
  const auto consider = [&](int triangle)
  {
    const Triangle& t = this->Model.triangles[triangle];
    const Vector3 &a = this->Model.points[t[0]], &b = this->Model.points[t[1]], &c = this->Model.points[t[2]];
    const std::array<double, 3> w = closestWeights(a, b, c, p);
    const double distance = (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
    const bool nearer = distance < bestDistance * (1.0 - 1e-12);
    if (nearer)
    {
      best = { triangle, w };
      bestDistance = distance;
    }
    return nearer;
  };
  consider(start);
  const int chart = this->chart(start);
  for (int step = 0; step < maximumSteps; ++step)
  {
    std::array<int, 3> support;
    const int count = supportOf(this->Model, best, support);
    if (count == 3)
    {
      break; // p stands over the triangle
    }
    const SurfacePoint from = best;
    if (count == 2)
    {
      // Over the edge first: most often that is all.
      const int corner = from.weights[0] == 0.0 ? 0 : from.weights[1] == 0.0 ? 1 : 2;
      const int twin = this->twin(nextHalfEdge(3 * from.triangle + corner));
      if (twin >= 0 && this->chart(twin / 3) == chart && consider(twin / 3))
      {
        continue;
      }
    }
    for (int i = 0; i < count; ++i)
    {
      const int v = support[i];
      for (const int t : this->VertexTriangles[v])
      {
        if (t != from.triangle && this->chart(t) == chart)
        {
          consider(t);
        }
      }
    }
    if (best.triangle == from.triangle)
    {
      break;
    }
  }
  return best;
}

int Surface::triangleWith(const std::vector<int>& vertices) const
{
  for (const int t : this->VertexTriangles[vertices[0]])
  {
    const auto holds = [&](int v) { return cornerOf(this->Model.triangles[t], v) >= 0; };
    if (std::all_of(vertices.begin(), vertices.end(), holds))
    {
      return t;
    }
  }
  return -1;
}

bool Surface::middle(const SurfacePoint& a, const SurfacePoint& b, int chart, SurfacePoint& result) const
{
  std::array<int, 3> support;
  supportOf(this->Model, a, support);
  const int v = support[0];
  for (const int t : this->VertexTriangles[v])
  {
    if (chart >= 0 && this->chart(t) != chart)
    {
      continue;
    }
    if (this->middleIn(t, a, b, result))
    {
      return true;
    }
  }
  return false;
}

bool Surface::middleIn(int triangle, const SurfacePoint& a, const SurfacePoint& b, SurfacePoint& result) const
{
  const SurfacePoint first = seenFrom(this->Model, a, triangle);
  const SurfacePoint second = first.triangle >= 0 ? seenFrom(this->Model, b, triangle) : first;
  if (second.triangle < 0)
  {
    return false;
  }
  result.triangle = triangle;
  for (int k = 0; k < 3; ++k)
  {
    result.weights[k] = 0.5 * (first.weights[k] + second.weights[k]);
  }
  return true;
}

SurfacePoint Surface::inChart(const SurfacePoint& at, int chart, const Vector3& towards) const
{
  if (this->Charts.empty())
  {
    return at;
  }
  std::array<int, 3> support;
  const int count = supportOf(this->Model, at, support);
  if (count == 3)
  {
    return at;
  }
  SurfacePoint best = at;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (const int t : this->VertexTriangles[support[0]])
  {
    if (this->chart(t) == chart)
    {
      const SurfacePoint place = seenFrom(this->Model, at, t);
      const Triangle& corners = this->Model.triangles[t];
      const Vector3 middle =
        (this->Model.points[corners[0]] + this->Model.points[corners[1]] + this->Model.points[corners[2]]) /
        3.0;
      const double distance = (middle - towards).squaredNorm();
      if (place.triangle >= 0 && distance < bestDistance)
      {
        best = place;
        bestDistance = distance;
      }
    }
  }
  return best;
}

} // namespace oversketch
