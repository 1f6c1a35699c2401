#include "Silhouette/judgement.h"

#include "Silhouette/extract.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

bool narrow(const Mesh& mesh, const Triangle& t)
{
  const double limit = std::cos(M_PI / 6.0);
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
    const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
    if (a.dot(b) > limit * a.norm() * b.norm())
    {
      return true;
    }
  }
  return false;
}

double leastDistance(const std::vector<NearestPlace>& places, const Vector2& p)
{
  double least = std::numeric_limits<double>::infinity();
  for (const NearestPlace& place : places)
  {
    least = std::min(least, place(p, least).distance);
  }
  return least;
}

} // namespace

int foldedEdges(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<char>& regionVertex,
  const Context& context)
{
  const auto eachTriangleAt = [&](const std::vector<char>& chosen, auto&& visit)
  {
    for (int v = 0; v < mesh.vertexCount(); ++v)
    {
      if (chosen[v])
      {
        std::for_each(adjacency.vertexTriangles.begin(v), adjacency.vertexTriangles.end(v), visit);
      }
    }
  };
  // One ring more: a triangle outside may share an edge with one that has a corner in the region.
  std::vector<char> near = regionVertex, part(mesh.triangles.size(), 0);
  eachTriangleAt(regionVertex,
    [&](int t)
    {
      for (const int v : mesh.triangles[t])
      {
        near[v] = 1;
      }
    });
  eachTriangleAt(near, [&part](int t) { part[t] = 1; });
  std::vector<Vector3> normals(mesh.triangles.size()); // of the part
  context.each(mesh.triangleCount(),
    [&](int t)
    {
      if (part[t])
      {
        normals[t] = facetNormal(mesh, t);
      }
    });
  std::vector<std::array<int, 2>> pairs;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    for (int k = 0; part[t] && k < 3; ++k)
    {
      const int e = adjacency.triangleEdges[t][k];
      std::array<int, 2> pair{ -1, -1 };
      int count = 0; // of the edge's triangles, those of the part
      for (int i = 0; e >= 0 && i < adjacency.edges[e].triangleCount; ++i)
      {
        const int other = adjacency.trianglesBegin(e)[i];
        if (part[other])
        {
          pair[std::min(count++, 1)] = other;
        }
      }
      if (count == 2 && pair[0] == t)
      {
        pairs.push_back(pair);
      }
    }
  }
  const double limit = std::cos(100.0 * M_PI / 180.0);
  std::vector<char> folded(pairs.size(), 0);
  context.each(static_cast<int>(pairs.size()),
    [&](int i) { folded[i] = normals[pairs[i][0]].dot(normals[pairs[i][1]]) < limit; });
  return static_cast<int>(std::count(folded.begin(), folded.end(), 1));
}

double narrowShare(const Mesh& mesh, const std::vector<char>& chosen)
{
  int all = 0, bad = 0;
  for (int t = 0; t < mesh.triangleCount(); ++t)
  {
    if (chosen[t])
    {
      ++all;
      bad += narrow(mesh, mesh.triangles[t]);
    }
  }
  return all > 0 ? static_cast<double>(bad) / all : 0.0;
}

bool wantsRemeshing(const Mesh& before, const Mesh& after, const std::vector<char>& regionVertex)
{
  std::vector<char> chosen(before.triangles.size(), 0);
  int edges = 0, stretched = 0;
  for (int t = 0; t < before.triangleCount(); ++t)
  {
    const Triangle& v = before.triangles[t];
    chosen[t] = regionVertex[v[0]] && regionVertex[v[1]] && regionVertex[v[2]];
    for (int k = 0; chosen[t] && k < 3; ++k)
    {
      const int a = v[k], b = v[(k + 1) % 3];
      ++edges;
      stretched +=
        (after.points[a] - after.points[b]).norm() > 1.5 * (before.points[a] - before.points[b]).norm();
    }
  }
  return stretched > 0.01 * edges || narrowShare(after, chosen) > narrowShare(before, chosen) + 0.01;
}

std::vector<OutlineLoop> regionContours(const Mesh& mesh,
  const Adjacency& adjacency,
  const std::vector<Vector3>& normals,
  const std::vector<char>& region,
  const View& view)
{
  std::vector<OutlineLoop> lines;
  for (const Curve& curve : extractSilhouette(mesh, adjacency, normals, view))
  {
    lines.emplace_back();
    lines.back().closed = curve.closed;
    for (const CurvePoint& p : curve.points)
    {
      if (region[p.binding.vertices[0]] && region[p.binding.vertices[1]] && view.inFront(p.position))
      {
        lines.back().points.emplace_back(view.toDisplay(p.position).head<2>());
        continue;
      }
      lines.back().closed = false;
      if (!lines.back().points.empty())
      {
        lines.emplace_back();
        lines.back().closed = false;
      }
    }
    if (lines.back().points.size() < 2)
    {
      lines.pop_back();
    }
  }
  return lines;
}

OutlineError outlineError(const StrokeOutline& outline, const std::vector<OutlineLoop>& further)
{
  const Polyline& stroke = outline.stroke();
  const std::vector<double> length = arcLengths(stroke);
  const auto measure = [&](const std::vector<OutlineLoop>& traced)
  {
    std::vector<OutlineLoop> lines = traced;
    lines.insert(lines.end(), further.begin(), further.end());
    const std::vector<NearestPlace> places = nearestPlaces(lines);
    OutlineError error;
    int counted = 0;
    for (std::size_t i = 0; i < stroke.size(); ++i)
    {
      if (length[i] < 0.2 * length.back() || length[i] > 0.8 * length.back())
      {
        continue;
      }
      const double nearest = leastDistance(places, stroke[i]);
      error.mean += nearest;
      error.worst = std::max(error.worst, nearest);
      ++counted;
    }
    error.mean /= std::max(counted, 1);
    return error;
  };
  const OutlineError error = measure(outline.nearby());
  return error.worst <= StrokeOutline::margin ? error : measure(outline.whole());
}

double missedBeside(const StrokeOutline& outline)
{
  const std::vector<OutlineLoop>& loops = outline.whole();
  const std::vector<NearestPlace> places = nearestPlaces(loops);
  const auto isCovered = [&](const Vector2& p)
  {
    bool covered = false;
    for (const OutlineLoop& loop : loops)
    {
      for (std::size_t i = 0; i < loop.points.size(); ++i)
      {
        covered ^= passesRight(p, loop.points[i], loop.points[(i + 1) % loop.points.size()]);
      }
    }
    return covered;
  };
  double worst = 0.0;
  for (const Vector2& p : outline.stroke())
  {
    const double nearest = leastDistance(places, p);
    if (nearest > worst && !isCovered(p))
    {
      worst = nearest;
    }
  }
  return worst;
}

bool Judgement::keptAgainst(const Judgement& plain) const
{
  constexpr double step = 0.5; // px
  const bool asGood = this->folds <= plain.folds && this->outline.mean <= plain.outline.mean + step &&
                      this->outline.worst <= plain.outline.worst + step;
  const bool nearer = this->folds <= tolerableFolds && this->outline.mean <= plain.outline.mean &&
                      this->outline.worst <= plain.outline.worst - step;
  return (asGood || nearer) && !rougher(this->roughness, plain.roughness) &&
         this->back <= plain.back + tolerableBack;
}

bool Judgement::betterThan(const Judgement& first) const
{
  if (this->folds <= std::max(first.folds, 2 * tolerableFolds) && this->outline.mean <= first.outline.mean &&
      this->outline.worst <= first.outline.worst)
  {
    return this->folds < first.folds || this->outline.worst < first.outline.worst;
  }
  return first.folds > tolerableFolds && this->folds < first.folds &&
         this->outline.worst <= std::max(2.0, first.outline.worst);
}

} // namespace oversketch
