#include "Inflate/unstretch.h"

#include "Planar/guard.h"

#include <algorithm>
#include <array>
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
// The bend over a rim may be so much of the one over the edges beside it.
constexpr double evenBend = 1.02;
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

// What moves each point: none of those on strokes.
struct Moves
{
  std::vector<Vector2> moves;       // [world]
  std::vector<double> before, even; // of the thickness, from the rim: where the point is, and is to be
  std::vector<char> first;          // an edge joins it to a rim
};

Moves wanted(const PlanarMesh& mesh, const HeightMaps& maps, const Context& context)
{
  const Frame& frame = maps.distance.frame;
  const MapReader reader(maps);
  const std::vector<int> objects = objectsOf(mesh);
  const std::vector<double> lengths = lengthsOf(mesh);
  const std::size_t count = mesh.points.size();
  Moves wanted{ std::vector<Vector2>(count, Vector2::Zero()),
    std::vector<double>(count, 0.0),
    std::vector<double>(count, 0.0),
    std::vector<char>(count, 0) };
  context.parallelFor(static_cast<int>(count),
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
        wanted.before[i] = wanted.even[i] = whole > 0.0 ? distance / whole : 1.0;
        // On a ridge T has no direction.
        if (!(distance > 0.0) || !(slope.norm() > 0.5))
        {
          continue;
        }
        const double share =
          std::clamp((lengths[i] / (frame.spacing * whole) - fine) / (coarse - fine), 0.0, 1.0);
        wanted.even[i] += share * (1.0 - std::cos(halfPi * wanted.before[i]) - wanted.before[i]);
        wanted.moves[i] = frame.spacing * whole * (wanted.even[i] - wanted.before[i]) * slope.normalized();
      }
    });
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      const int a = face.corners[k], b = face.corners[(k + 1) % face.count()];
      wanted.first[a] = wanted.first[a] || isRim(mesh.points[b].kind);
      wanted.first[b] = wanted.first[b] || isRim(mesh.points[a].kind);
    }
  }
  context.checkpoint(0.3);
  return wanted;
}

// Edges of the first row beside a rim and the corners beyond them.
std::vector<std::array<int, 3>> firstRow(const PlanarMesh& mesh, const std::vector<char>& first)
{
  std::vector<std::array<int, 3>> row;
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < 3 && face.count() == 3; ++k)
    {
      const int a = face.corners[k], b = face.corners[(k + 1) % 3], beyond = face.corners[(k + 2) % 3];
      const auto inside = [&](int v) { return mesh.points[v].kind == BoundaryKind::Interior; };
      if (inside(a) && inside(b) && first[a] && first[b] && inside(beyond) && !first[beyond])
      {
        row.push_back({ a, b, beyond });
      }
    }
  }
  return row;
}

// How much of what is wanted the first row moves, and those inside of it.
struct Shares
{
  double first, inside;
  double of(const Moves& wanted, int v) const { return wanted.first[v] ? this->first : this->inside; }
};

// Whether a rim would bend about as much as what is beside it: on a circle the first bend is the angle to the
// first row, the other one half of that to the second.
bool bendsEvenly(const std::vector<std::array<int, 3>>& row, const Moves& wanted, const Shares& shares)
{
  const auto angle = [&](int v)
  {
    const double share = shares.of(wanted, v);
    const double to = wanted.before[v] + share * (wanted.even[v] - wanted.before[v]);
    return std::acos(1.0 - std::clamp(to, 0.0, 1.0));
  };
  double rim = 0.0, beside = 0.0;
  for (const auto& [a, b, beyond] : row)
  {
    rim += angle(a) + angle(b);
    beside += angle(beyond);
  }
  return rim <= evenBend * beside;
}

struct Angles
{
  double low, half;
};

// Of the least angles of the faces, with points moved so far, the one that a twentieth is under, and the
// half.
Angles anglesOf(const PlanarMesh& mesh, const Moves& wanted, const Shares& shares, const Context& context)
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
          return mesh.points[corner].place + shares.of(wanted, corner) * wanted.moves[corner];
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

// How much of the moves leaves the rim even, and the plane's triangles in shape. The rows inside give way
// first.
Shares affordable(const PlanarMesh& mesh, const Moves& wanted, const Context& context)
{
  const std::vector<std::array<int, 3>> row = firstRow(mesh, wanted.first);
  const Angles rest = anglesOf(mesh, wanted, { 0.0, 0.0 }, context);
  const auto kept = [](double asked, double before) { return before >= asked ? asked : narrower * before; };
  const auto inShape = [&](const Shares& shares)
  {
    const Angles now = anglesOf(mesh, wanted, shares, context);
    return now.low >= kept(fewest, rest.low) && now.half >= kept(middle, rest.half);
  };
  for (int step = steps; step >= 0; --step)
  {
    const Shares shares{ 1.0, static_cast<double>(step) / steps };
    if (bendsEvenly(row, wanted, shares) && inShape(shares))
    {
      return shares;
    }
  }
  for (int step = steps; step > 0; --step)
  {
    const Shares shares{ static_cast<double>(step) / steps, 0.0 };
    if (inShape(shares))
    {
      return shares;
    }
  }
  return { 0.0, 0.0 };
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
  const Moves toRim = wanted(mesh, maps, context);
  const Shares shares = affordable(mesh, toRim, context);
  const double longest = maps.distance.frame.spacing * maps.distance.frame.width;
  const double least = flat * longest * longest;
  SubdividedMesh level;
  level.mesh = mesh;
  for (int i = 0; i < static_cast<int>(mesh.points.size()); ++i)
  {
    const Vector2 move = shares.of(toRim, i) * toRim.moves[i];
    level.smooth.push_back(mesh.points[i].place + move);
    level.free.push_back(move != Vector2::Zero());
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
