#include "Stellar/simplify.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"
#include "Stellar/crossed_faces.h"
#include "Stellar/leaves.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

// Twice the area of a triangle over the sum of two squared sides: one that is not greater than this has none.
constexpr double flattest = 1e-6;

// How far a weldable vertex is from the triangles that come back without it; infinite where one of them has
// no area.
double errorOf(const Forest& forest, int w)
{
  double error = std::numeric_limits<double>::infinity();
  bool isFlat = false;
  const auto at = [&](int v) -> const Vector3& { return forest.vertices[v].position; };
  forest.star(w,
    [&](int f, int)
    {
      const Forest::Face& face = forest.faces[f];
      if (face.path % 2 == 0)
      {
        const int c = forest.faces[face.n[2]].v[1];
        const Vector3 &p = at(face.v[1]), &q = at(face.v[2]), &r = at(c);
        isFlat |= !((q - p).cross(r - p).norm() > flattest * ((q - p).squaredNorm() + (r - p).squaredNorm()));
        error = std::min(error, std::sqrt(squaredDistance(p, q, r, at(w))));
      }
    });
  return isFlat ? std::numeric_limits<double>::infinity() : error;
}

// Marks of what curves need of the surface before the last displacement.
std::vector<char> neededOf(const Forest& forest,
  const FeatureCurves& curves,
  const SimplifyOptions& options,
  const DisplacedFrom* from,
  const Context& context)
{
  if (curves.empty())
  {
    return std::vector<char>(forest.vertices.size(), 0);
  }
  const ReachOptions reach{ options.radius, options.distance, options.connectedOnly };
  const bool known = from && stillNeeded(from->before,
                               from->reached.needed,
                               forest,
                               from->reached.changing,
                               from->reached.faces,
                               curves,
                               reach,
                               context);
#ifdef NDEBUG
  if (known)
  {
    return from->reached.needed.why;
  }
#endif
  Forest before = forest;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    before.vertices[v].position = putBack(forest, v);
  }
  std::vector<char> why = verticesToKeep(before, curves, reach, context).why;
  assert(!known || why == from->reached.needed.why);
  return why;
}

void checkSimplifyOptions(const FeatureCurves& curves, const SimplifyOptions& options)
{
  checkCurves(curves);
  if (!(options.tolerance >= 0.0 && std::isfinite(options.tolerance)))
  {
    throw Error(Failure::BadMesh, "The {tolerance} must be zero or a positive number.");
  }
  checkRadius(curves, options.radius);
}

} // namespace

std::optional<Forest> simplify(const Forest& forest,
  const FeatureCurves& curves,
  const SimplifyOptions& options,
  const Context& context,
  int* welded,
  const DisplacedFrom* from)
{
  checkSimplifyOptions(curves, options);
  const std::vector<char> near = neededOf(forest, curves, options, from, context);
  context.checkpoint(0.3);
  std::vector<std::vector<int>> levels;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    const Forest::Vertex& vertex = forest.vertices[v];
    if (near[v] || options.staying.at(forest, v) || !forest.isVertex(v) || vertex.parents[0] < 0 ||
        (!options.weldSnapped && (vertex.curveId >= 0 || (vertex.moved & Forest::Crest))))
    {
      continue;
    }
    levels.resize(std::max<std::size_t>(levels.size(), vertex.level + 1));
    levels[vertex.level].push_back(v);
  }
  std::optional<Forest> work; // once something goes
  int count = 0;
  // Stars of weldable vertices of one level are disjoint, and their errors depend on coarser ones alone; so
  // one pass finds all.
  for (std::size_t level = levels.size(); level-- > 0;)
  {
    const std::vector<int>& candidates = levels[level];
    const Forest& now = work ? *work : forest;
    std::vector<char> goes(candidates.size(), 0);
    context.eachUntilCancelled(static_cast<int>(candidates.size()),
      [&](int i)
      {
        const int w = candidates[i];
        if (now.weldable(w))
        {
          bool far = true;
          now.link(w, [&](int u) { far = far && !(near[u] & VerticesToKeep::Within); });
          goes[i] = far && errorOf(now, w) < options.tolerance;
        }
      });
    context.checkpoint(1.0 - 0.6 * static_cast<double>(level) / static_cast<double>(levels.size()));
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      if (goes[i])
      {
        if (!work)
        {
          work = forest;
        }
        work->weld(candidates[i]);
        ++count;
      }
    }
  }
  if (welded)
  {
    *welded = count;
  }
  if (!work)
  {
    return std::nullopt;
  }
  assert(work->broken().empty());
  return canonical(*work, context).forest;
}

} // namespace oversketch
