#include "Inflate/unstretch.h"

#include "Planar/guard.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double halfPi = 1.57079632679489661923;
constexpr double flat = 1e-12; // of the canvas's square

// How far each point is to move [world]; 0 of those on strokes.
std::vector<Vector2> wanted(const PlanarMesh& mesh, const HeightMaps& maps, const Context& context)
{
  const Frame& frame = maps.distance.frame;
  const MapReader reader(maps);
  const std::vector<int> objects = objectsOf(mesh);
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
        const double aim = whole * (1.0 - std::cos(halfPi * distance / whole));
        moves[i] = -frame.spacing * (distance - aim) * slope.normalized();
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
