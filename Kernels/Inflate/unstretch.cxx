#include "Inflate/unstretch.h"

#include "Planar/guard.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace oversketch
{
namespace
{

constexpr double flat = 1e-12; // of the canvas's square
// How much of its depth beside the rim a point loses, by the length of the edges about it as a share of the
// thickness: nothing where rows of triangles are so fine that the rim is smooth as it is, most from some
// eight rows on. All of it would leave triangles of the plane too thin.
const double fine = getenv("XR0") ? 1 / atof(getenv("XR0")) : 1.0 / 40.0, coarse = getenv("XR1") ? 1 / atof(getenv("XR1")) : 1.0 / 8.0, most = getenv("XB") ? atof(getenv("XB")) : 0.9;
constexpr int rounds = 3; // of averaging the lengths

// Of each point the mean length of the edges about it, smooth along the mesh [world].
std::vector<double> lengthsOf(const PlanarMesh& mesh)
{
  std::vector<double> sums(mesh.points.size(), 0.0), lengths;
  std::vector<int> counts(mesh.points.size(), 0);
  const auto eachEdge = [&](const auto& use)
  {
    for (const PlanarFace& face : mesh.faces)
    {
      for (int k = 0; k < face.count(); ++k)
      {
        use(face.corners[k], face.corners[(k + 1) % face.count()]);
      }
    }
  };
  eachEdge(
    [&](int a, int b)
    {
      const double length = (mesh.points[a].place - mesh.points[b].place).norm();
      sums[a] += length;
      sums[b] += length;
      ++counts[a];
      ++counts[b];
    });
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    lengths.push_back(sums[i] / std::max(1, counts[i]));
  }
  for (int round = 0; round < rounds; ++round)
  {
    std::fill(sums.begin(), sums.end(), 0.0);
    eachEdge(
      [&](int a, int b)
      {
        sums[a] += lengths[b];
        sums[b] += lengths[a];
      });
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      lengths[i] = 0.5 * (lengths[i] + sums[i] / std::max(1, counts[i]));
    }
  }
  return lengths;
}

// How far each point is to move [world]; 0 of those on strokes.
std::vector<Vector2> wanted(const PlanarMesh& mesh, const HeightMaps& maps, const Context& context)
{
  const Frame& frame = maps.distance.frame;
  const MapReader reader(maps);
  const std::vector<int> objects = objectsOf(mesh);
  const std::vector<double> lengths = lengthsOf(mesh);
  std::vector<Vector2> moves(mesh.points.size(), Vector2::Zero());
  context.parallelFor(static_cast<int>(moves.size()),
    [&](int begin, int end)
    {
      for (int i = begin; i < end && !context.cancelled(); ++i)
      {
        const PlanarPoint& point = mesh.points[i];
        if (point.kind != BoundaryKind::Interior)
        {
          continue;
        }
        const Vector2 at = frame.toPixels(point.place);
        const double whole = reader.inner(maps.thickness, at, objects[i]);
        const double distance = std::min(reader.distance(at), whole);
        const Vector2 slope = reader.slope(at);
        // On a ridge T has no direction.
        if (!(distance > 0.0) || !(slope.norm() > 0.5))
        {
          continue;
        }
        const double share = (lengths[i] / (frame.spacing * whole) - fine) / (coarse - fine);
        const double u = distance / whole;
        const double move = most * std::clamp(share, 0.0, 1.0) * distance * (1.0 - u) * (1.0 - u);
        moves[i] = -frame.spacing * move * slope.normalized();
      }
    });
  context.checkpoint(0.3);
  return moves;
}

} // namespace

PlanarMesh unstretch(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const Context& context,
  UnstretchReport* report)
{
  const std::vector<Vector2> moves = wanted(mesh, maps, context);
  const double longest = maps.distance.frame.spacing * maps.distance.frame.width;
  const double least = flat * longest * longest;
  SubdividedMesh level;
  level.mesh = mesh;
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    level.smooth.push_back(mesh.points[i].place + moves[i]);
    level.free.push_back(moves[i] != Vector2::Zero());
  }
  keepUpright(level, least, {}, context);
  for (std::size_t i = 0; i < moves.size() && report; ++i)
  {
    const Vector2& place = level.mesh.points[i].place;
    report->moved += place != mesh.points[i].place;
    report->held += place != level.smooth[i];
  }
  return std::move(level.mesh);
}

} // namespace oversketch
