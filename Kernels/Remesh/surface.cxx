#include "Remesh/surface.h"

#include <algorithm>

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

// A share in [0, 1]; 0 on an edge without length.
double ratio(double part, double whole)
{
  return whole > 0.0 ? part / whole : 0.0;
}

int cornerOf(const Triangle& t, int vertex)
{
  return t[0] == vertex ? 0 : t[1] == vertex ? 1 : t[2] == vertex ? 2 : -1;
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

// By the Voronoi region of the triangle that p falls in: corners, then edges, then the inside.
std::array<double, 3> closestWeights(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p)
{
  const Vector3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return { 1.0, 0.0, 0.0 };
  }
  const Vector3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3)
  {
    return { 0.0, 1.0, 0.0 };
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = ratio(d1, d1 - d3);
    return { 1.0 - v, v, 0.0 };
  }
  const Vector3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6)
  {
    return { 0.0, 0.0, 1.0 };
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = ratio(d2, d2 - d6);
    return { 1.0 - w, 0.0, w };
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
    return { 0.0, 1.0 - w, w };
  }
  const double sum = va + vb + vc;
  const double v = ratio(vb, sum), w = ratio(vc, sum);
  return { 1.0 - v - w, v, w };
}

SurfacePoint closestInTriangle(const Mesh& mesh, int triangle, const Vector3& p)
{
  const Triangle& t = mesh.triangles[triangle];
  return { triangle, closestWeights(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], p) };
}

Surface::Surface(const Mesh& mesh, const std::vector<char>& active, const std::vector<int>& charts)
  : mesh_(mesh)
  , charts_(charts)
{
  std::vector<int>& offsets = this->vertexTriangles_.offsets;
  offsets.assign(mesh.points.size() + 1, 0);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; active[t] && k < 3; ++k)
    {
      ++offsets[mesh.triangles[t][k] + 1];
    }
  }
  for (std::size_t i = 1; i < offsets.size(); ++i)
  {
    offsets[i] += offsets[i - 1];
  }
  this->vertexTriangles_.values.resize(offsets.back());
  std::vector<int> next(offsets.begin(), offsets.end() - 1);
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; active[t] && k < 3; ++k)
    {
      this->vertexTriangles_.values[next[mesh.triangles[t][k]]++] = t;
    }
  }
}

SurfacePoint Surface::closest(const Vector3& p, int start) const
{
  SurfacePoint best = closestInTriangle(this->mesh_, start, p);
  double bestDistance = (positionOf(this->mesh_, best) - p).squaredNorm();
  const int chart = this->chart(start);
  for (int step = 0; step < maximumSteps; ++step)
  {
    std::array<int, 3> support;
    const int count = supportOf(this->mesh_, best, support);
    if (count == 3)
    {
      break; // p stands over the triangle
    }
    const SurfacePoint from = best;
    for (int i = 0; i < count; ++i)
    {
      const int v = support[i];
      for (const int* t = this->vertexTriangles_.begin(v); t != this->vertexTriangles_.end(v); ++t)
      {
        if (*t == from.triangle || this->chart(*t) != chart)
        {
          continue;
        }
        const SurfacePoint place = closestInTriangle(this->mesh_, *t, p);
        const double distance = (positionOf(this->mesh_, place) - p).squaredNorm();
        if (distance < bestDistance * (1.0 - 1e-12))
        {
          best = place;
          bestDistance = distance;
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
  for (const int* t = this->vertexTriangles_.begin(vertices[0]); t != this->vertexTriangles_.end(vertices[0]);
       ++t)
  {
    const auto holds = [&](int v) { return cornerOf(this->mesh_.triangles[*t], v) >= 0; };
    if (std::all_of(vertices.begin(), vertices.end(), holds))
    {
      return *t;
    }
  }
  return -1;
}

bool Surface::middle(const SurfacePoint& a, const SurfacePoint& b, int chart, SurfacePoint& result) const
{
  std::array<int, 3> support;
  supportOf(this->mesh_, a, support);
  const int v = support[0];
  for (const int* t = this->vertexTriangles_.begin(v); t != this->vertexTriangles_.end(v); ++t)
  {
    if (chart >= 0 && this->chart(*t) != chart)
    {
      continue;
    }
    const SurfacePoint first = seenFrom(this->mesh_, a, *t);
    const SurfacePoint second = seenFrom(this->mesh_, b, *t);
    if (first.triangle >= 0 && second.triangle >= 0)
    {
      result.triangle = *t;
      for (int k = 0; k < 3; ++k)
      {
        result.weights[k] = 0.5 * (first.weights[k] + second.weights[k]);
      }
      return true;
    }
  }
  return false;
}

SurfacePoint Surface::inChart(const SurfacePoint& at, int chart, const Vector3& towards) const
{
  if (this->charts_.empty())
  {
    return at;
  }
  std::array<int, 3> support;
  const int count = supportOf(this->mesh_, at, support);
  if (count == 3)
  {
    return at;
  }
  SurfacePoint best = at;
  double bestDistance = std::numeric_limits<double>::infinity();
  for (const int* t = this->vertexTriangles_.begin(support[0]); t != this->vertexTriangles_.end(support[0]);
       ++t)
  {
    if (this->chart(*t) == chart)
    {
      const SurfacePoint place = seenFrom(this->mesh_, at, *t);
      const Triangle& corners = this->mesh_.triangles[*t];
      const Vector3 middle =
        (this->mesh_.points[corners[0]] + this->mesh_.points[corners[1]] + this->mesh_.points[corners[2]]) /
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
