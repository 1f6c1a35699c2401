// E_smth of a snaxel as it moves along its edge. A part of the snake.
#ifndef oversketch_edge_smoothness_h
#define oversketch_edge_smoothness_h

#include "Mesh/mesh.h"

#include <algorithm>
#include <cmath>

namespace oversketch
{

// c0 + c1 t + c2 t^2.
struct Quadratic
{
  double c0, c1, c2;
  double operator()(double t) const { return this->c0 + t * (this->c1 + t * this->c2); }
};

// (a0 + t a1) . (b0 + t b1)
inline Quadratic product(const Vector3& a0, const Vector3& a1, const Vector3& b0, const Vector3& b1)
{
  return { a0.dot(b0), a0.dot(b1) + a1.dot(b0), a1.dot(b1) };
}

// E_smth along an edge as a function of t, from its first vertex to its second. The vectors to the neighbours
// and the normal before it is normalised are linear in t.
class EdgeSmoothness
{
public:
  // a, b: from the edge's first vertex to the neighbours; e: the edge; n, dn: normal at the first vertex and
  // its change.
  EdgeSmoothness(const Vector3& a, const Vector3& b, const Vector3& e, const Vector3& n, const Vector3& dn)
    : aa(product(a, -e, a, -e))
    , bb(product(b, -e, b, -e))
    , ab(product(a, -e, b, -e))
    , na(product(n, dn, a, -e))
    , nb(product(n, dn, b, -e))
    , nn(product(n, dn, n, dn))
    , area(product(n, dn, a.cross(b), e.cross(a - b)))
  {
  }

  // -cos E_smth: grows with E_smth and is cheaper than the angle.
  double operator()(double t) const
  {
    const double n = this->nn(t), a = this->na(t), b = this->nb(t);
    const double lengths = (this->aa(t) * n - a * a) * (this->bb(t) * n - b * b);
    return lengths > 0.0 ? (a * b - this->ab(t) * n) / std::sqrt(lengths) : -1.0;
  }

  // The places where n . (a x b) = 0 make E_smth 0 or pi. The one in [low, high] nearest to t where it is pi,
  // or -1.
  double straightPlace(double low, double high, double t) const
  {
    const double c0 = this->area.c0, c1 = this->area.c1, c2 = this->area.c2;
    const double root = std::sqrt(std::max(0.0, c1 * c1 - 4.0 * c0 * c2));
    const double q = -0.5 * (c1 + std::copysign(root, c1));
    double best = -1.0;
    for (const double place :
      { c0 / q, q / c2 }) // no root, or one of a linear function, is not a number or infinite
    {
      if (place >= low && place <= high && (best < 0.0 || std::abs(place - t) < std::abs(best - t)) &&
          (*this)(place) > 1.0 - 1e-12)
      {
        best = place;
      }
    }
    return best;
  }

private:
  Quadratic aa, bb, ab, na, nb, nn, area;
};

} // namespace oversketch
#endif
