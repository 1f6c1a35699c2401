#include "Stellar/smooth.h"

#include "Mesh/context.h"
#include "Stellar/quality.h"

#include <algorithm>

namespace oversketch
{

namespace
{

// Vertices around snapped ones that may move, ascending.
std::vector<int> verticesToSmooth(const Forest& forest, const SmoothOptions& options)
{
  const int rings = options.rings;
  const int slots = static_cast<int>(forest.vertices.size());
  std::vector<char> chosen(slots, 0);
  for (int v = 0; v < slots; ++v)
  {
    chosen[v] = rings < 0 ? forest.isVertex(v) : forest.vertices[v].curveId >= 0;
  }
  std::vector<int> ring = marked(chosen);
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
    ring = std::move(next);
  }
  std::vector<int> all = marked(chosen);
  const auto pinned = [&](int v)
  {
    const Forest::Vertex& vertex = forest.vertices[v];
    return vertex.curveId >= 0 || (vertex.moved & Forest::Crest) || vertex.face < 0 || forest.onBoundary(v) ||
           forest.onSeam(v, options.parts) || options.staying.at(forest, v);
  };
  all.erase(std::remove_if(all.begin(), all.end(), pinned), all.end());
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
  const Forest::FacePlace at = forest.inStar(v, to);
  if (at.face < 0)
  {
    return to;
  }
  Vector3 weights[3];
  forest.rootWeights(at.face, weights);
  return source.source({ forest.faces[at.face].root,
    at.weights[0] * weights[0] + at.weights[1] * weights[1] + at.weights[2] * weights[2],
    to });
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
  const std::vector<int> vertices = verticesToSmooth(forest, options);
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
