#include "Planar/relax.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{
namespace
{

constexpr int rounds = 8, directions = 8;
constexpr double step = 0.1; // of the way to the nearest neighbour
constexpr double turn = 6.28318530717958647693;

// Infinite for a triangle that is flat or turned over.
double badness(const Vector2& a, const Vector2& b, const Vector2& c)
{
  double least = std::numeric_limits<double>::infinity();
  const Vector2* corners[] = { &a, &b, &c };
  for (int k = 0; k < 3; ++k)
  {
    const Vector2 u = *corners[(k + 1) % 3] - *corners[k], v = *corners[(k + 2) % 3] - *corners[k];
    least = std::min(least, std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)));
  }
  return least > 0.0 ? 1.0 / least : std::numeric_limits<double>::infinity();
}

} // namespace

PlanarMesh relaxed(const PlanarMesh& mesh)
{
  PlanarMesh result = mesh;
  std::vector<std::vector<std::array<int, 2>>> opposite(mesh.points.size()); // edges, in the faces' sense
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      opposite[face.corners[k]].push_back({ face.corners[(k + 1) % 3], face.corners[(k + 2) % 3] });
    }
  }
  const auto place = [&](int point) -> const Vector2& { return result.points[point].place; };
  for (int round = 0; round < rounds; ++round)
  {
    bool moved = false;
    for (std::size_t p = 0; p < opposite.size(); ++p)
    {
      if (mesh.points[p].kind != BoundaryKind::Interior || opposite[p].empty())
      {
        continue;
      }
      const auto sumAt = [&](const Vector2& at)
      {
        double sum = 0.0;
        for (const auto& [a, b] : opposite[p])
        {
          sum += badness(at, place(a), place(b));
        }
        return sum;
      };
      const Vector2 own = place(static_cast<int>(p));
      Vector2 middle = Vector2::Zero(), best = own;
      double nearest = std::numeric_limits<double>::infinity(), least = sumAt(own);
      for (const auto& [a, b] : opposite[p]) // round an inner point each neighbour once
      {
        middle += place(a) / static_cast<double>(opposite[p].size());
        nearest = std::min(nearest, (place(a) - own).norm());
      }
      const auto offer = [&](const Vector2& at)
      {
        if (const double sum = sumAt(at); sum < (1.0 - 1e-3) * least)
        {
          least = sum;
          best = at;
        }
      };
      for (const double share : { 0.25, 0.5, 1.0 })
      {
        offer(own + share * (middle - own));
      }
      for (int k = 0; k < directions; ++k)
      {
        const double angle = turn * k / directions;
        offer(own + step * nearest * Vector2(std::cos(angle), std::sin(angle)));
      }
      moved = moved || best != own;
      result.points[p].place = best;
    }
    if (!moved)
    {
      break;
    }
  }
  return result;
}

} // namespace oversketch
