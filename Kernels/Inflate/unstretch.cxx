#include "Inflate/unstretch.h"

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

double areaOf(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const Vector2 u = b - a, v = c - a;
  return 0.5 * (u[0] * v[1] - u[1] * v[0]);
}

// The least signed area of its corners' triangles.
double areaOf(const PlanarFace& face, const std::vector<PlanarPoint>& points)
{
  const int count = face.count();
  double least = 1e300;
  for (int k = 0; k < (count == 3 ? 1 : 4); ++k)
  {
    least = std::min(least,
      areaOf(points[face.corners[k]].place,
        points[face.corners[(k + 1) % count]].place,
        points[face.corners[(k + 2) % count]].place));
  }
  return least;
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
  PlanarMesh result = mesh;
  std::vector<double> share(moves.size());
  for (std::size_t i = 0; i < moves.size(); ++i)
  {
    share[i] = moves[i] == Vector2::Zero() ? 0.0 : 1.0;
  }
  std::vector<char> bad(moves.size()), around;
  for (int pass = 0;; ++pass)
  {
    context.checkpoint(0.3 + 0.7 * pass / (pass + 5.0));
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
      result.points[i].place = mesh.points[i].place + share[i] * moves[i];
    }
    std::fill(bad.begin(), bad.end(), 0);
    const auto mark = [](const PlanarFace& face, std::vector<char>& marks)
    {
      for (int k = 0; k < face.count(); ++k)
      {
        marks[face.corners[k]] = 1;
      }
    };
    for (const PlanarFace& face : result.faces)
    {
      if (areaOf(face, result.points) <= least)
      {
        mark(face, bad);
      }
    }
    if (pass >= 6)
    {
      around = bad;
      for (const PlanarFace& face : result.faces)
      {
        if (std::any_of(face.corners.begin(),
              face.corners.begin() + face.count(),
              [&](int corner) { return bad[corner] != 0; }))
        {
          mark(face, around);
        }
      }
      bad.swap(around);
    }
    bool changed = false;
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
      if (bad[i] && share[i] > 0.0)
      {
        share[i] = share[i] < 0.2 ? 0.0 : 0.5 * share[i];
        changed = true;
      }
    }
    if (!changed)
    {
      break;
    }
  }
  if (report)
  {
    for (std::size_t i = 0; i < moves.size(); ++i)
    {
      report->moved += share[i] > 0.0;
      report->held += share[i] < 1.0 && moves[i] != Vector2::Zero();
    }
  }
  return result;
}

} // namespace oversketch
