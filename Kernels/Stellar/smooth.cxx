#include "Stellar/smooth.h"

#include "Mesh/context.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <limits>

namespace oversketch
{

namespace
{

// Vertices around snapped ones that may move, ascending.
std::vector<int> verticesToSmooth(const Forest& forest, int rings, const std::vector<int>& parts)
{
  const int slots = static_cast<int>(forest.vertices.size());
  std::vector<char> chosen(slots, 0);
  std::vector<int> all, ring;
  for (int v = 0; v < slots; ++v)
  {
    if (rings < 0 ? forest.isVertex(v) : forest.vertices[v].curveId >= 0)
    {
      chosen[v] = 1;
      all.push_back(v);
    }
  }
  ring = all;
  for (int i = 0; i < rings && !ring.empty(); ++i)
  {
    std::vector<int> next;
    for (const int v : ring)
    {
      forest.link(v,
        [&](int w)
        {
          if (!chosen[w])
          {
            chosen[w] = 1;
            next.push_back(w);
          }
        });
    }
    all.insert(all.end(), next.begin(), next.end());
    ring = std::move(next);
  }
  const auto pinned = [&](int v)
  {
    const Forest::Vertex& vertex = forest.vertices[v];
    return vertex.curveId >= 0 || (vertex.moved & Forest::Crest) || vertex.face < 0 || forest.onBoundary(v) ||
           forest.onSeam(v, parts);
  };
  all.erase(std::remove_if(all.begin(), all.end(), pinned), all.end());
  std::sort(all.begin(), all.end());
  return all;
}

Vector3 smoothed(const Forest& forest, int v, double relaxation)
{
  const Vector3& at = forest.vertices[v].position;
  Vector3 sum = Vector3::Zero();
  int count = 0;
  forest.link(v,
    [&](int w)
    {
      sum += forest.vertices[w].position - at;
      ++count;
    });
  const Vector3 step = sum / count, normal = forest.vertexNormal(v);
  return at + relaxation * (step - step.dot(normal) * normal);
}

// Where the source is under a place in the star of a vertex; the place itself if the vertex is not on the
// source or the place is over none of its faces.
Vector3 onSource(const Forest& forest, int v, const Vector3& to, const MidpointRule& source)
{
  const SourcePlace own = forest.place(v);
  if ((source.source(own) - own.position).norm() > source.sourceTolerance)
  {
    return to;
  }
  SourcePlace place;
  double best = -std::numeric_limits<double>::infinity(); // the least weight in the face that holds it
  forest.star(v,
    [&](int f, int)
    {
      const int* c = forest.faces[f].v;
      const Vector3& p = forest.vertices[c[0]].position;
      const Vector3 x = forest.vertices[c[1]].position - p, y = forest.vertices[c[2]].position - p;
      const Vector3 normal = x.cross(y);
      const double squared = normal.squaredNorm();
      if (!(squared > 0.0))
      {
        return;
      }
      const double wx = (to - p).cross(y).dot(normal) / squared, wy = x.cross(to - p).dot(normal) / squared;
      const double least = std::min({ wx, wy, 1.0 - wx - wy });
      if (least > best)
      {
        best = least;
        Vector3 weights[3];
        forest.rootWeights(f, weights);
        place = {
          forest.faces[f].root, (1.0 - wx - wy) * weights[0] + wx * weights[1] + wy * weights[2], to
        };
      }
    });
  return place.root >= 0 ? source.source(place) : to;
}

} // namespace

SmoothReport smooth(Forest& forest,
  const SmoothOptions& options,
  const MidpointRule& source,
  const Context& context)
{
  if (!(options.relaxation > 0.0 && options.relaxation <= 1.0) || options.iterations < 0)
  {
    throw Error(Failure::BadStroke,
      "Smoothing needs a relaxation above 0 and at most 1, and a number of iterations that is not negative.");
  }
  if (!options.parts.empty() && static_cast<int>(options.parts.size()) != forest.rootCount)
  {
    throw Error(Failure::BadStroke, "Smoothing needs a part for each triangle of the base mesh, or none.");
  }
  const std::vector<int> vertices = verticesToSmooth(forest, options.rings, options.parts);
  std::vector<Vector3> wanted(vertices.size());
  SmoothReport report;
  for (int iteration = 0; iteration < options.iterations; ++iteration)
  {
    context.checkpoint(static_cast<double>(iteration) / options.iterations);
    context.eachUntilCancelled(static_cast<int>(vertices.size()),
      [&](int i)
      {
        const Vector3 to = smoothed(forest, vertices[i], options.relaxation);
        wanted[i] = source.source ? onSource(forest, vertices[i], to, source) : to;
      });
    context.checkpoint((iteration + 0.5) / options.iterations);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      Forest::Vertex& vertex = forest.vertices[vertices[i]];
      if (wanted[i] == vertex.position)
      {
        continue;
      }
      if (!mayMove(forest, vertices[i], wanted[i], options.minimumAngle))
      {
        ++report.refused;
        continue;
      }
      vertex.position = wanted[i];
      vertex.moved |= Forest::Placed;
      ++report.moved;
    }
  }
  return report;
}

} // namespace oversketch
