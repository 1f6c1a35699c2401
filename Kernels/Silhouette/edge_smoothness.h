// E_smth of a snaxel as it moves along its edge. A part of the snake.
#ifndef oversketch_kernels_silhouette_edge_smoothness_h
#define oversketch_kernels_silhouette_edge_smoothness_h

#include "Mesh/mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace oversketch
{

// Three numbers that the compiler keeps in three registers. Vector3 goes through memory in pairs where a
// value is used as a whole and by coordinate, which the sweeps of a snake wait for. The sums are Vector3's,
// bit for bit.
struct Triple
{
  double x, y, z;

  Triple(double a, double b, double c)
    : x(a)
    , y(b)
    , z(c)
  {
  }
  explicit Triple(const Vector3& v)
    : Triple(v[0], v[1], v[2])
  {
  }
  double dot(const Triple& o) const { return this->x * o.x + this->y * o.y + this->z * o.z; }
  Triple cross(const Triple& o) const
  {
    return { this->y * o.z - this->z * o.y, this->z * o.x - this->x * o.z, this->x * o.y - this->y * o.x };
  }
  double norm() const { return std::sqrt(this->dot(*this)); }
  Triple operator-() const { return { -this->x, -this->y, -this->z }; }
  Triple operator-(const Triple& o) const { return { this->x - o.x, this->y - o.y, this->z - o.z }; }
  Triple operator+(const Triple& o) const { return { this->x + o.x, this->y + o.y, this->z + o.z }; }
  friend Triple operator*(double s, const Triple& v) { return { s * v.x, s * v.y, s * v.z }; }
};

// c0 + c1 t + c2 t^2.
struct Quadratic
{
  double c0, c1, c2;
  double operator()(double t) const { return this->c0 + t * (this->c1 + t * this->c2); }
};

// (a0 + t a1) . (b0 + t b1)
inline Quadratic product(const Triple& a0, const Triple& a1, const Triple& b0, const Triple& b1)
{
  return { a0.dot(b0), a0.dot(b1) + a1.dot(b0), a1.dot(b1) };
}

// Along an edge, as below: the places where n . (a x b) = 0 make E_smth 0 or pi. No place, or one of a linear
// function, is not a number or infinite.
inline std::array<double, 2> straightPlaces(const Triple& a,
  const Triple& b,
  const Triple& e,
  const Triple& n,
  const Triple& dn)
{
  const auto [c0, c1, c2] = product(n, dn, a.cross(b), e.cross(a - b));
  const double root = std::sqrt(std::max(0.0, c1 * c1 - 4.0 * c0 * c2));
  const double q = -0.5 * (c1 + std::copysign(root, c1));
  return { c0 / q, q / c2 };
}

// E_smth along an edge as a function of t, from its first vertex to its second. The vectors to the neighbours
// and the normal before it is normalised are linear in t.
class EdgeSmoothness
{
public:
  // a, b: from the edge's first vertex to the neighbours; e: the edge; n, dn: normal at the first vertex and
  // its change.
  EdgeSmoothness(const Triple& a, const Triple& b, const Triple& e, const Triple& n, const Triple& dn)
    : Aa(product(a, -e, a, -e))
    , Bb(product(b, -e, b, -e))
    , Ab(product(a, -e, b, -e))
    , Na(product(n, dn, a, -e))
    , Nb(product(n, dn, b, -e))
    , Nn(product(n, dn, n, dn))
  {
  }

  // -cos E_smth: grows with E_smth and is cheaper than the angle.
  double operator()(double t) const
  {
    const double n = this->Nn(t), a = this->Na(t), b = this->Nb(t);
    const double lengths = (this->Aa(t) * n - a * a) * (this->Bb(t) * n - b * b);
    return lengths > 0.0 ? (a * b - this->Ab(t) * n) / std::sqrt(lengths) : -1.0;
  }

private:
  Quadratic Aa, Bb, Ab, Na, Nb, Nn;
};

// Where E_smth is largest in [low, high] when it is pi nowhere: 33 samples, then golden section about the
// best of them.
double searchStraightest(const EdgeSmoothness& energy, double low, double high);

} // namespace oversketch
#endif
