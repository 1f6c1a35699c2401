#include "Stellar/simplify.h"

#include "Mesh/context.h"
#include "Stellar/leaves.h"
#include "Stellar/passage.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

// How far a weldable vertex is from the triangles that come back without it.
double errorOf(const Forest& forest, int w)
{
  double error = std::numeric_limits<double>::infinity();
  const auto at = [&](int v) -> const Vector3& { return forest.vertices[v].position; };
  forest.star(w,
    [&](int f, int)
    {
      const Forest::Face& face = forest.faces[f];
      if (face.path % 2 == 0)
      {
        const int c = forest.faces[face.n[2]].v[1];
        error = std::min(error, distanceToTriangle(at(w), at(face.v[1]), at(face.v[2]), at(c)));
      }
    });
  return error;
}

// Vertices that curves need, of the surface before the last displacement: 1 within the radius, 2 of a face
// that a curve passes through.
std::vector<char> needed(const Forest& before,
  const FeatureCurves& curves,
  const SimplifyOptions& options,
  const Context& context)
{
  std::vector<char> needed(before.vertices.size(), 0);
  if (curves.empty())
  {
    return needed;
  }
  const CurveSearch search(curves);
  const Passage passage(before, search, context);
  CurveReach reach(before, search);
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    for (const Reached& r : reach.find(k,
           passage.faces(k),
           { curves[k].radius.value_or(options.radius), options.distance, options.connectedOnly },
           context))
    {
      needed[r.vertex] |= 1;
    }
    for (int f : passage.faces(k))
    {
      for (int v : before.faces[f].v)
      {
        needed[v] |= 2;
      }
    }
  }
  return needed;
}

void checkSimplifyOptions(const FeatureCurves& curves, const SimplifyOptions& options)
{
  checkCurves(curves);
  if (!(options.tolerance >= 0.0 && std::isfinite(options.tolerance)))
  {
    throw Error(Failure::BadMesh, "The Tolerance must be zero or a positive number.");
  }
  for (const FeatureCurve& c : curves)
  {
    const double radius = c.radius.value_or(options.radius);
    if (!(radius > 0.0 && std::isfinite(radius)))
    {
      throw Error(Failure::BadStroke, "The Radius must be a positive number.");
    }
  }
}

} // namespace

Forest simplify(const Forest& forest,
  const FeatureCurves& curves,
  const SimplifyOptions& options,
  const Context& context,
  int* welded)
{
  checkSimplifyOptions(curves, options);
  Forest work = forest;
  for (std::size_t v = 0; v < forest.displacement.size(); ++v)
  {
    if (forest.displacement[v] != Vector3::Zero())
    {
      work.vertices[v].position -= forest.displacement[v];
    }
  }
  const std::vector<char> near = needed(work, curves, options, context);
  for (std::size_t v = 0; v < forest.displacement.size(); ++v)
  {
    if (forest.displacement[v] != Vector3::Zero())
    {
      work.vertices[v].position = forest.vertices[v].position;
    }
  }
  context.checkpoint(0.3);
  std::vector<std::vector<int>> levels;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    const Forest::Vertex& vertex = forest.vertices[v];
    if (!forest.isVertex(v) || vertex.parents[0] < 0 || near[v] ||
        (!options.weldSnapped && (vertex.curveId >= 0 || (vertex.moved & Forest::Crest))))
    {
      continue;
    }
    levels.resize(std::max<std::size_t>(levels.size(), vertex.level + 1));
    levels[vertex.level].push_back(v);
  }
  int count = 0;
  // Stars of weldable vertices of one level are disjoint, and their errors depend on coarser ones alone; so
  // one pass finds all.
  for (std::size_t level = levels.size(); level-- > 0;)
  {
    const std::vector<int>& candidates = levels[level];
    std::vector<char> goes(candidates.size(), 0);
    context.parallelFor(static_cast<int>(candidates.size()),
      [&](int begin, int end)
      {
        for (int i = begin; i < end && !context.cancelled(); ++i)
        {
          const int w = candidates[i];
          if (work.weldable(w))
          {
            bool far = true;
            work.link(w, [&](int u) { far = far && !(near[u] & 1); });
            goes[i] = far && errorOf(work, w) < options.tolerance;
          }
        }
      });
    context.checkpoint(1.0 - 0.6 * static_cast<double>(level) / static_cast<double>(levels.size()));
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      if (goes[i])
      {
        work.weld(candidates[i]);
        ++count;
      }
    }
  }
  assert(work.broken().empty());
  if (welded)
  {
    *welded = count;
  }
  return count ? canonical(work, context).forest : work;
}

} // namespace oversketch
