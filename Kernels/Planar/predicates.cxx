#include "Planar/predicates.h"

#include "Planar/exact.h"

namespace oversketch
{

int orientation(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return exactTurn(a, b, c);
}

int inCircle(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  return exactCircle(a, b, c, d);
}

bool between(const Vector2& a, const Vector2& b, const Vector2& c)
{
  const int axis = a[0] != b[0] ? 0 : 1;
  return (a[axis] < c[axis] && c[axis] < b[axis]) || (b[axis] < c[axis] && c[axis] < a[axis]);
}

bool segmentsMeet(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d)
{
  const int sc = orientation(a, b, c), sd = orientation(a, b, d);
  const int sa = orientation(c, d, a), sb = orientation(c, d, b);
  if (sc * sd < 0 && sa * sb < 0)
  {
    return true;
  }
  return (sc == 0 && between(a, b, c)) || (sd == 0 && between(a, b, d)) || (sa == 0 && between(c, d, a)) ||
         (sb == 0 && between(c, d, b)) || (a == c && b == d) || (a == d && b == c);
}

} // namespace oversketch
