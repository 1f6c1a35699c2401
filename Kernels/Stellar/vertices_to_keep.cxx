#include "Stellar/vertices_to_keep.h"

#include "Mesh/context.h"

#include <algorithm>
#include <atomic>

namespace oversketch
{

namespace
{

// A vertex that is snapped to a feature's foot lies at the radius but for rounding, which is of the order of
// 1e-8 where a small model lies millions of units from the origin: it does not rise, and is not within.
bool isWithin(double distance, double radius)
{
  constexpr double rounding = 1e-6;
  return distance < (1.0 - rounding) * radius;
}

} // namespace

void VerticesToKeep::add(const Forest& forest,
  int curve,
  double radius,
  const std::vector<Reached>& reached,
  const CrossedFaces& crossed)
{
  for (const Reached& r : reached)
  {
    if (isWithin(r.distance, radius))
    {
      this->why[r.vertex] |= Within;
    }
  }
  this->passed.push_back(crossed.faces(curve));
  for (const int f : this->passed.back())
  {
    for (const int v : forest.faces[f].v)
    {
      this->why[v] |= Passed;
    }
  }
  this->touched.push_back(crossed.touched(curve));
  this->parts.push_back(crossed.parts(curve));
}

VerticesToKeep verticesToKeep(const Forest& forest,
  const FeatureCurves& curves,
  const ReachOptions& options,
  const Context& context)
{
  VerticesToKeep needed(forest);
  const CurveSearch search(curves);
  const CrossedFaces crossed(forest, search, context);
  CurveReach reach(forest, search);
  for (int k = 0; k < static_cast<int>(curves.size()); ++k)
  {
    const double radius = curves[k].radius.value_or(options.radius);
    const ReachOptions own{ radius, options.kind, options.connectedOnly };
    needed.add(forest, k, radius, reach.find(k, crossed.faces(k), own, context), crossed);
  }
  return needed;
}

bool stillNeeded(const Forest& before,
  const VerticesToKeep& needed,
  const Forest& after,
  const std::vector<int>& changing,
  const std::vector<int>& faces,
  const FeatureCurves& curves,
  const ReachOptions& options,
  const Context& context)
{
  const auto isEmpty = [](const std::vector<int>& touched) { return touched.empty(); };
  if (options.kind != CurveDistance::Straight ||
      std::any_of(needed.touched.begin(), needed.touched.end(), isEmpty))
  {
    return false;
  }
  const CurveSearch search(curves);
  const int count = static_cast<int>(curves.size());
  std::vector<char> off(before.vertices.size(), 0);
  std::atomic<bool> same{ true };
  context.parallelFor(static_cast<int>(changing.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end && same && !context.cancelled(); ++i)
      {
        const int v = changing[i];
        const Forest::Vertex& vertex = before.vertices[v];
        const Vector3 to = putBack(after, v);
        off[v] = to != vertex.position;
        // What was snapped was at distance 0 by its name, which it has no longer.
        for (int k = 0; k < count && (off[v] || vertex.curveId >= 0); ++k)
        {
          const double radius = curves[k].radius.value_or(options.radius);
          const auto within = [&](const Vector3& at)
          { return isWithin(search.nearest(k, at, radius).distance, radius); };
          same = same && (vertex.curveId == k || within(vertex.position)) == within(to);
        }
      }
    });
  context.checkpoint(0.1);
  context.parallelFor(static_cast<int>(faces.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end && same && !context.cancelled(); ++i)
      {
        const int* c = before.faces[faces[i]].v;
        for (int k = 0; k < count && (off[c[0]] || off[c[1]] || off[c[2]]); ++k)
        {
          const std::vector<int>& known = needed.touched[k];
          same =
            same && touches(search, k, putBack(after, c[0]), putBack(after, c[1]), putBack(after, c[2])) ==
                      std::binary_search(known.begin(), known.end(), faces[i]);
        }
      }
    });
  context.checkpoint(0.2);
  for (int k = 0; same && k < count; ++k)
  {
    same = passedPutBack(after, search, k, needed.touched[k], needed.parts[k]) == needed.passed[k];
  }
  return same;
}

} // namespace oversketch
