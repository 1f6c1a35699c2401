#include "Inflate/unstretch.h"

#include "Mesh/shape.h"
#include "Planar/guard.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{
namespace
{

constexpr double halfPi = 1.57079632679489661923;
constexpr double flat = 1e-12; // of the canvas's square
// The first row's angle on the circle, of the angle of the points beyond it: the rim bends by the first, what
// is beside it by half of the second.
constexpr double firstAngle = 0.53;
constexpr double firstShare = 0.96; // of the way there: farther out, its edges inward cut pits
// Rows of triangles need not be evened where edges are so short, as a share of the thickness, that the rim is
// smooth as it is; ten rows and fewer are evened in full.
constexpr double fine = 1.0 / 40.0, coarse = 1.0 / 10.0;
// Least angles that the plane's triangles are to keep [rad]: the twentieth part of them, and the half.
constexpr double fewest = 0.182, middle = 0.61;
constexpr double narrower = 0.88; // of what they are, where they do not reach that as it is
constexpr int steps = 10;         // of how far points are moved
constexpr int leastInside = 4;    // of these steps: less of the inner rows, and their triangles are stretched
constexpr int rounds = 3;         // of averaging the lengths

// Calls use with each edge of each face, both ways.
template <typename Use>
void eachEdge(const PlanarMesh& mesh, const Use& use)
{
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      const int a = face.corners[k], b = face.corners[(k + 1) % face.count()];
      use(a, b);
      use(b, a);
    }
  }
}

// Mean length of the edges about each point, smooth along the mesh [world].
std::vector<double> lengthsOf(const PlanarMesh& mesh)
{
  std::vector<double> sums(mesh.points.size(), 0.0), lengths;
  std::vector<int> counts(mesh.points.size(), 0);
  eachEdge(mesh,
    [&](int a, int b)
    {
      sums[a] += (mesh.points[a].place - mesh.points[b].place).norm();
      ++counts[a];
    });
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    lengths.push_back(sums[i] / std::max(1, counts[i]));
  }
  for (int round = 0; round < rounds; ++round)
  {
    std::fill(sums.begin(), sums.end(), 0.0);
    eachEdge(mesh, [&](int a, int b) { sums[a] += lengths[b]; });
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      lengths[i] = 0.5 * (lengths[i] + sums[i] / std::max(1, counts[i]));
    }
  }
  return lengths;
}

// Places on the circular cross-section, as shares of the thickness off the rim.
struct Rows
{
  std::vector<Vector2> inward; // what a share of 1 is in the plane [world]; 0 of points that stay
  std::vector<double> before;
  std::vector<double> need;             // 0 where edges are fine, 1 where they are coarse
  std::vector<std::vector<int>> beyond; // of points that an edge joins to a rim: those that it joins to none
};

double angleAt(double share)
{
  return std::acos(1.0 - std::clamp(share, 0.0, 1.0));
}

Rows rowsOf(const PlanarMesh& mesh, const HeightMaps& maps, const Context& context)
{
  const Frame& frame = maps.distance.frame;
  const MapReader reader(maps);
  const std::vector<int> objects = objectsOf(mesh);
  const std::vector<double> lengths = lengthsOf(mesh);
  const std::size_t count = mesh.points.size();
  Rows rows{ std::vector<Vector2>(count, Vector2::Zero()),
    std::vector<double>(count, 0.0),
    std::vector<double>(count, 0.0),
    std::vector<std::vector<int>>(count) };
  context.eachUntilCancelled(static_cast<int>(count),
    [&](int i)
    {
      const PlanarPoint& point = mesh.points[i];
      if (point.kind != BoundaryKind::Interior)
      {
        return;
      }
      const Vector2 at = frame.toPixels(point.place);
      const double whole = reader.inner(maps.thickness, at, objects[i]);
      const double distance = std::min(reader.distance(at), whole);
      const Vector2 slope = reader.slope(at);
      rows.before[i] = whole > 0.0 ? distance / whole : 1.0;
      // On a ridge T has no direction.
      if (!(distance > 0.0) || !(slope.norm() > 0.5))
      {
        return;
      }
      rows.need[i] = std::clamp((lengths[i] / (frame.spacing * whole) - fine) / (coarse - fine), 0.0, 1.0);
      rows.inward[i] = frame.spacing * whole * slope.normalized();
    });
  context.checkpoint(0.3);

  std::vector<char> first(count, 0);
  eachEdge(mesh, [&](int a, int b) { first[a] = first[a] || isRim(mesh.points[b].kind); });
  eachEdge(mesh,
    [&](int a, int b)
    {
      if (first[a] && !first[b] && mesh.points[b].kind == BoundaryKind::Interior)
      {
        rows.beyond[a].push_back(b);
      }
    });
  return rows;
}

// How much of what is wanted the first row moves, and those inside of it.
struct Shares
{
  double first, inside;
};

// How far each point moves.
std::vector<Vector2> movesOf(const Rows& rows, const Shares& shares)
{
  const auto evenAt = [&](int i) { return 1.0 - std::cos(halfPi * rows.before[i]); };
  const auto insideAt = [&](int i)
  { return rows.before[i] + shares.inside * rows.need[i] * (evenAt(i) - rows.before[i]); };
  std::vector<Vector2> moves;
  for (int i = 0; i < static_cast<int>(rows.before.size()); ++i)
  {
    double to = insideAt(i);
    if (const std::vector<int>& beyond = rows.beyond[i]; !beyond.empty())
    {
      double angle = 0.0;
      for (const int v : beyond)
      {
        angle += angleAt(insideAt(v)) / static_cast<double>(beyond.size());
      }
      to = std::min(evenAt(i), 1.0 - std::cos(firstAngle * angle));
      to = rows.before[i] + shares.first * rows.need[i] * (to - rows.before[i]);
    }
    moves.emplace_back((to - rows.before[i]) * rows.inward[i]);
  }
  return moves;
}

struct Angles
{
  double low, half;
};

// Percentiles of the faces' least angles, with points moved so far: what a twentieth is under, and half.
Angles anglesOf(const PlanarMesh& mesh, const std::vector<Vector2>& moves, const Context& context)
{
  std::vector<double> least(mesh.faces.size());
  context.each(static_cast<int>(least.size()),
    [&](int f)
    {
      const PlanarFace& face = mesh.faces[f];
      const auto at = [&](int k) -> Vector2
      {
        const int corner = face.corners[k % face.count()];
        return mesh.points[corner].place + moves[corner];
      };
      least[f] = halfPi;
      for (int k = 0; k < face.count(); ++k)
      {
        // Angles of a quad that its diagonals cut off.
        const Vector2 a = at(k);
        least[f] = std::min(least[f], turnAngle(at(k + 1) - a, at(k + 2) - a));
      }
    });
  const auto nth = [&](std::size_t n)
  {
    std::nth_element(least.begin(), least.begin() + static_cast<std::ptrdiff_t>(n), least.end());
    return least[n];
  };
  return { nth(least.size() / 20), nth(least.size() / 2) };
}

// As much of what is wanted as leaves the plane's triangles in shape. The rows inside give way first.
std::vector<Vector2> affordable(const PlanarMesh& mesh, const Rows& rows, const Context& context)
{
  const Angles rest = anglesOf(mesh, movesOf(rows, { 0.0, 0.0 }), context);
  const auto kept = [](double asked, double before) { return before >= asked ? asked : narrower * before; };
  std::vector<Shares> tries;
  for (int step = steps; step >= leastInside; --step)
  {
    tries.push_back({ firstShare, static_cast<double>(step) / steps });
  }
  for (int step = steps - 1; step >= 0; --step)
  {
    const double share = static_cast<double>(step) / steps;
    tries.push_back({ share, share * leastInside / steps });
  }
  std::vector<Vector2> moves;
  for (const Shares& shares : tries)
  {
    moves = movesOf(rows, shares);
    const Angles now = anglesOf(mesh, moves, context);
    if (now.low >= kept(fewest, rest.low) && now.half >= kept(middle, rest.half))
    {
      break;
    }
  }
  return moves;
}

} // namespace

PlanarMesh unstretch(const PlanarMesh& mesh,
  const HeightMaps& maps,
  const Context& context,
  UnstretchReport* report)
{
  if (mesh.faces.empty())
  {
    return mesh;
  }
  const std::vector<Vector2> moves = affordable(mesh, rowsOf(mesh, maps, context), context);
  const double longest = maps.distance.frame.spacing * maps.distance.frame.width;
  const double least = flat * longest * longest;
  SubdividedMesh level;
  level.mesh = mesh;
  for (int i = 0; i < static_cast<int>(mesh.points.size()); ++i)
  {
    level.smooth.push_back(mesh.points[i].place + moves[i]);
    level.free.push_back(moves[i] != Vector2::Zero());
  }
  keepUpright(level, least, {}, context);
  for (std::size_t i = 0; i < mesh.points.size() && report; ++i)
  {
    const Vector2& place = level.mesh.points[i].place;
    report->moved += place != mesh.points[i].place;
    report->held += place != level.smooth[i];
  }
  return std::move(level.mesh);
}

} // namespace oversketch
