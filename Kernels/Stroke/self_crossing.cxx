#include "Stroke/self_crossing.h"

#include <algorithm>

namespace oversketch
{

namespace
{

double turn(const Vector2& a, const Vector2& b)
{
  return a[0] * b[1] - a[1] * b[0];
}

// A point on the line counts as left of it, so that a crossing at a point of the polyline is found, too.
bool isRight(const Vector2& a, const Vector2& b, const Vector2& p)
{
  return turn(b - a, p - a) < 0.0;
}

bool areApart(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d, int axis)
{
  return std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
         std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]);
}

} // namespace

std::optional<Vector2> selfCrossing(const Polyline& line, double leastLoop)
{
  const std::vector<double> lengths = arcLengths(line);
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
  {
    const Vector2 &a = line[i], &b = line[i + 1];
    for (std::size_t j = i + 2; j + 1 < line.size(); ++j)
    {
      const Vector2 &c = line[j], &d = line[j + 1];
      if (lengths[j] - lengths[i + 1] >= leastLoop && !areApart(a, b, c, d, 0) && !areApart(a, b, c, d, 1) &&
          isRight(a, b, c) != isRight(a, b, d) && isRight(c, d, a) != isRight(c, d, b))
      {
        return a + turn(c - a, d - c) / turn(b - a, d - c) * (b - a);
      }
    }
  }
  return std::nullopt;
}

} // namespace oversketch
