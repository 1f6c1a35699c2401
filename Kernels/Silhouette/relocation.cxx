#include "Silhouette/relocation.h"

#include "Mesh/clones.h"
#include "Silhouette/bend.h"

namespace oversketch
{

namespace
{

struct Squares
{
  double cross, dot; // the one squared

  // Tells a bend by more, or surely by less, than a small angle.
  bool exceeds(double angle) const
  {
    return (this->dot >= 0.0) | (this->cross > this->dot * this->dot * angle * angle);
  }
  bool isBelow(double angle) const
  {
    return (this->dot < 0.0) & (this->cross < this->dot * this->dot * angle * angle);
  }
};

// See Bend.
Squares squaresOf(const Triple& before, const Triple& at, const Triple& normal, const Triple& after)
{
  const Triple toBefore = before - at, toAfter = after - at;
  const Triple a = toBefore - normal.dot(toBefore) * normal, b = toAfter - normal.dot(toAfter) * normal;
  const Triple cross = a.cross(b);
  return { cross.dot(cross), a.dot(b) };
}

} // namespace

// As in edge_smoothness.cxx, vectors change not one bit of what is found.
OVERSKETCH_CLONES void Relocations::find(const Triple& towards, double share, double epsilon)
{
  constexpr double margin = 1e-6; // far more than rounding errors
  const Triple eye = towards;
  const double squaredEpsilon = epsilon * epsilon * (1.0 - margin);
  Found result;
  for (int i = 0; i < lanes; ++i)
  {
    const Triple from = this->before[i], to = this->after[i], p0 = this->ends[0][i], p1 = this->ends[1][i],
                 n0 = this->endNormals[0][i], n1 = this->endNormals[1][i];
    const double least = this->low[i], most = this->high[i];
    const auto [t0, t1] = straightPlaces(from - p0, to - p0, p1 - p0, n0, n1 - n0);
    const bool first = (t0 >= least) & (t0 <= most), second = (t1 >= least) & (t1 <= most);
    const double place = first ? t0 : t1;
    const bool inside =
      ((least > 0.0) | (place >= endTolerance)) & ((most < 1.0) | (place <= 1.0 - endTolerance));
    const EdgePoint p(place, p0, p1, n0, n1);
    const Squares now = squaresOf(from, this->at[i], this->normal[i], to);
    const Squares then = squaresOf(from, p.position, p.normal, to);
    const Triple d = eye - share * p.position;
    const double across = d.dot(p.normal), allowed = squaredEpsilon * d.dot(d);
    // Without branches, or the compiler makes no vectors of it.
    const bool bent = now.exceeds(leastGain + 2.0 * Bend::nothing),
               straightThere = then.isBelow(Bend::nothing);
    const bool moves =
      (first != second) & inside & (p.squared > 0.25) & bent & straightThere & (across * across < allowed);
    result.verdict[i] = now.isBelow(leastGain * (1.0 - margin)) ? Stays : moves ? Moves : Unclear;
    result.weight[i] = p.weight;
    result.position.set(i, p.position);
    result.normal.set(i, p.normal);
  }
  this->found = result;
}

} // namespace oversketch
