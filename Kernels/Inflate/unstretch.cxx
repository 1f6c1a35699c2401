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
// Rows of triangles need not be evened where edges are so short, as a share of the thickness, that the rim is
// smooth as it is; ten rows and fewer are evened in full.
constexpr double fine = 1.0 / 40.0, coarse = 1.0 / 10.0;
// What the least angles of the plane's triangles are to keep [rad]: the twentieth part of them, and the half.
constexpr double fewest = 0.182, middle = 0.61;
constexpr double narrower = 0.8; // of what they are, where they do not reach that as it is
constexpr int steps = 10;        // of how far points are moved
constexpr int rounds = 3;        // of averaging the lengths

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
        const double even = whole * (1.0 - std::cos(halfPi * u));
        moves[i] = -frame.spacing * std::clamp(share, 0.0, 1.0) * (distance - even) * slope.normalized();
      }
    });
  context.checkpoint(0.3);
  return moves;
}

struct Angles
{
  double low, half;
};

// Of the least angles of the faces, with points moved so far, the one that a twentieth is under, and the
// half.
Angles anglesOf(const PlanarMesh& mesh,
  const std::vector<Vector2>& moves,
  double share,
  const Context& context)
{
  std::vector<double> least(mesh.faces.size());
  context.parallelFor(static_cast<int>(least.size()),
    [&](int begin, int end)
    {
      for (int f = begin; f < end; ++f)
      {
        const PlanarFace& face = mesh.faces[f];
        const auto at = [&](int k) -> Vector2
        {
          const int corner = face.corners[k % face.count()];
          return mesh.points[corner].place + share * moves[corner];
        };
        least[f] = halfPi;
        for (int k = 0; k < face.count(); ++k)
        {
          // Of a quad those that its diagonals cut off.
          const Vector2 a = at(k), b = at(k + 1), c = at(k + 2), u = b - a, v = c - a;
          least[f] = std::min(least[f], std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)));
        }
      }
    });
  const auto nth = [&](std::size_t n)
  {
    std::nth_element(least.begin(), least.begin() + static_cast<std::ptrdiff_t>(n), least.end());
    return least[n];
  };
  return { nth(least.size() / 20), nth(least.size() / 2) };
}

// How much of the moves leaves the plane's triangles in shape.
double affordable(const PlanarMesh& mesh, const std::vector<Vector2>& moves, const Context& context)
{
  if (mesh.faces.empty())
  {
    return 0.0;
  }
  const Angles rest = anglesOf(mesh, moves, 0.0, context);
  const auto kept = [](double wanted, double before)
  { return before >= wanted ? wanted : narrower * before; };
  for (int step = steps; step > 0; --step)
  {
    const double share = static_cast<double>(step) / steps;
    const Angles now = anglesOf(mesh, moves, share, context);
    if (now.low >= kept(fewest, rest.low) && now.half >= kept(middle, rest.half))
    {
      return share;
    }
  }
  return 0.0;
}

} // namespace

PlanarMesh unstretch(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const Context& context,
  UnstretchReport* report)
{
  std::vector<Vector2> moves = wanted(mesh, maps, context);
  const double share = affordable(mesh, moves, context);
  for (Vector2& move : moves)
  {
    move *= share;
  }
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
