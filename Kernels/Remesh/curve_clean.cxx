#include "Remesh/insert_curves.h"

#include "Mesh/nearest.h"
#include "Mesh/shape.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace oversketch
{

namespace
{

constexpr double radian = 57.29577951308232; // degrees
constexpr double narrow = 24.0;              // degrees: an angle to be raised,
constexpr double narrowest = 20.0;           // if need be by a vertex less
constexpr double leastGain = 0.1;            // degrees: smaller ones may go back and forth
constexpr double largestShift = 0.1;         // how far a curve may move, of its new segment
constexpr int mostRounds = 12;
constexpr double longestReach = 1.9; // mean edges from a curve, beyond which vertices and triangles stay

const double turnCosine = std::cos(15.0 / radian), featureCosine = std::cos(25.0 / radian);

double degreesOf(const Vector3& a, const Vector3& b, const Vector3& c)
{
  return smallestAngle(a, b, c) * radian;
}

// Whether a vector along a normal is within an angle of another one.
bool within(const Vector3& before, const Vector3& after, double cosine)
{
  return before.dot(after) >= cosine * before.norm() * after.norm() && after.squaredNorm() > 0.0;
}

class Cleaner
{
public:
  explicit Cleaner(CurveMesh& mesh)
    : Mesh(mesh)
    , Reach(longestReach * meanEdge(mesh))
  {
  }

  // One round; whether anything was changed.
  bool round()
  {
    std::vector<std::pair<double, int>> bad;
    for (const int t : this->near())
    {
      const double angle = this->angleOf(t);
      if (angle < narrow)
      {
        bad.emplace_back(angle, t);
      }
    }
    std::sort(bad.begin(), bad.end());
    bool changed = false;
    for (const auto& entry : bad)
    {
      if (this->Mesh.alive(entry.second) && this->angleOf(entry.second) < narrow)
      {
        changed = this->improve(entry.second) || changed;
      }
    }
    return changed;
  }

private:
  struct Move
  {
    bool flip = false;
    int from = -1, to = -1; // ends of the edge; `from` goes in a collapse
    double gain = leastGain;
  };

  static double meanEdge(const CurveMesh& mesh)
  {
    double sum = 0.0;
    int count = 0;
    for (int t = 0; t < static_cast<int>(mesh.triangles().size()); ++t)
    {
      for (int k = 0; mesh.alive(t) && k < 3; ++k, ++count)
      {
        sum += (mesh.point(mesh.triangle(t)[(k + 1) % 3]) - mesh.point(mesh.triangle(t)[k])).norm();
      }
    }
    return count > 0 ? sum / count : 0.0;
  }

  // Whether a vertex was inserted, or lies on a curve or near one of its neighbours that does.
  bool inReach(int v) const
  {
    if (this->Mesh.inserted(v) || this->Mesh.onCurve(v))
    {
      return true;
    }
    const std::vector<int> neighbours = this->Mesh.neighbours(v);
    return std::any_of(neighbours.begin(),
      neighbours.end(),
      [&](int w)
      { return this->Mesh.onCurve(w) && (this->Mesh.point(w) - this->Mesh.point(v)).norm() <= this->Reach; });
  }

  // Triangles with a vertex that was inserted or is on a curve, ascending.
  std::vector<int> near() const
  {
    std::vector<int> found;
    for (int v = 0; v < static_cast<int>(this->Mesh.points().size()); ++v)
    {
      if (this->Mesh.inserted(v) || this->Mesh.onCurve(v))
      {
        found.insert(found.end(), this->Mesh.around(v).begin(), this->Mesh.around(v).end());
      }
    }
    sortUnique(found);
    return found;
  }

  double angleOf(int t) const
  {
    const Triangle& c = this->Mesh.triangle(t);
    return degreesOf(this->Mesh.point(c[0]), this->Mesh.point(c[1]), this->Mesh.point(c[2]));
  }

  bool improve(int t)
  {
    const Triangle corners = this->Mesh.triangle(t);
    Move best;
    for (int k = 0; k < 3; ++k)
    {
      const int a = corners[k], b = corners[(k + 1) % 3];
      this->tryFlip(a, b, best);
      this->tryCollapse(a, b, best);
      this->tryCollapse(b, a, best);
    }
    if (best.from < 0)
    {
      return false;
    }
    if (best.flip)
    {
      this->Mesh.flip(best.from, best.to);
    }
    else
    {
      this->Mesh.collapse(best.from, best.to);
    }
    return true;
  }

  // Whether two triangles run along their edge in opposite directions.
  bool woundAlike(int t, int u, int a, int b) const
  {
    return runsAlong(this->Mesh.triangle(t), a, b) != runsAlong(this->Mesh.triangle(u), a, b);
  }

  // An edge between two triangles that are wound alike and meet at no more than 25 degrees.
  bool plainEdge(int a, int b, const std::vector<int>& both) const
  {
    return both.size() == 2 && this->woundAlike(both[0], both[1], a, b) &&
           within(this->Mesh.cross(both[0]), this->Mesh.cross(both[1]), featureCosine);
  }

  void tryFlip(int a, int b, Move& best) const
  {
    const std::vector<int> both = this->Mesh.trianglesAt(a, b);
    if (both.size() != 2 || !this->woundAlike(both[0], both[1], a, b) || this->Mesh.curveEdge(a, b))
    {
      return;
    }
    const int c = this->Mesh.opposite(both[0], a, b), d = this->Mesh.opposite(both[1], a, b);
    const auto isLeft = [this](int v) { return this->Mesh.isLeft(v); };
    if (isLeft(a) || isLeft(b) || isLeft(c) || isLeft(d) || c < 0 || d < 0 || c == d ||
        this->Mesh.joined(c, d) || this->Mesh.neighbours(a).size() < 4 || this->Mesh.neighbours(b).size() < 4)
    {
      return;
    }
    const Vector3 &pa = this->Mesh.point(a), &pb = this->Mesh.point(b), &pc = this->Mesh.point(c),
                  &pd = this->Mesh.point(d);
    const Vector3 before[2] = { this->Mesh.cross(both[0]), this->Mesh.cross(both[1]) };
    // A needle has no normal to speak of, so both together count.
    const Vector3 whole = before[0] + before[1];
    Vector3 first = (pd - pa).cross(pc - pa), second = (pc - pb).cross(pd - pb);
    if (!runsAlong(this->Mesh.triangle(both[0]), a, b))
    {
      first = -first;
      second = -second;
    }
    if (!within(whole, first, turnCosine) || !within(whole, second, turnCosine) ||
        !this->flat(both[0], whole) || !this->flat(both[1], whole))
    {
      return;
    }
    const double least = std::min(this->angleOf(both[0]), this->angleOf(both[1]));
    const double gain = std::min(degreesOf(pa, pd, pc), degreesOf(pb, pc, pd)) - least;
    if (gain > best.gain && (this->inReach(a) || this->inReach(b) || (this->inReach(c) && this->inReach(d))))
    {
      best = { true, a, b, gain };
    }
  }

  // Whether a triangle does not turn by more than 15 degrees when it takes this normal; a needle may.
  bool flat(int t, const Vector3& normal) const
  {
    return this->angleOf(t) < 1.0 || within(this->Mesh.cross(t), normal, turnCosine);
  }

  // Whether a vertex may leave its place: on no border, on no edge over 25 degrees, no end of a curve, of no
  // triangle that is left.
  bool movable(int v) const
  {
    for (const int w : this->Mesh.neighbours(v))
    {
      if (this->Mesh.isLeft(v) || this->Mesh.isLeft(w) || !this->smooth(v, w))
      {
        return false;
      }
    }
    return !this->Mesh.around(v).empty();
  }

  // Needles between two flat neighbours look like sharp edges; they are not.
  bool smooth(int v, int w) const
  {
    const std::vector<int> both = this->Mesh.trianglesAt(v, w);
    return both.size() == 2 && this->woundAlike(both[0], both[1], v, w) &&
           (this->plainEdge(v, w, both) || this->angleOf(both[0]) < 1.0 || this->angleOf(both[1]) < 1.0);
  }

  // Whether a vertex on curves may go to a neighbour: an inserted one, along its only curve.
  bool alongCurve(int from, int to) const
  {
    if (!this->Mesh.inserted(from) || this->Mesh.marks[from] != 1)
    {
      return false;
    }
    for (const MeshCurve& curve : this->Mesh.curves)
    {
      const auto at = std::find(curve.vertices.begin(), curve.vertices.end(), from);
      if (at == curve.vertices.end())
      {
        continue;
      }
      const int count = curve.count(), i = static_cast<int>(at - curve.vertices.begin());
      if (!curve.closed && (i == 0 || i == count - 1))
      {
        return false;
      }
      const int before = curve.vertices[(i + count - 1) % count], after = curve.vertices[(i + 1) % count];
      if ((to != before && to != after) || count <= (curve.closed ? 4 : 2))
      {
        return false;
      }
      const Vector3 &p = this->Mesh.point(before), step = this->Mesh.point(after) - p;
      return distanceToSegment(this->Mesh.point(from), p, this->Mesh.point(after)) <=
             largestShift * step.norm();
    }
    return false;
  }

  void tryCollapse(int from, int to, Move& best) const
  {
    if (!this->inReach(from) || (this->Mesh.onCurve(from) && !this->alongCurve(from, to)))
    {
      return;
    }
    const std::vector<int> both = this->Mesh.trianglesAt(from, to);
    if (both.size() != 2 || !this->movable(from) || !this->linked(from, to, both))
    {
      return;
    }
    double before = 180.0, after = 180.0;
    Vector3 whole = Vector3::Zero();
    std::vector<int> around = this->Mesh.around(from);
    std::sort(around.begin(), around.end());
    for (const int t : around)
    {
      whole += this->Mesh.cross(t);
      before = std::min(before, this->angleOf(t));
    }
    if (before >= narrowest)
    {
      return;
    }
    for (const int t : around)
    {
      if (t == both[0] || t == both[1])
      {
        continue;
      }
      Triangle c = this->Mesh.triangle(t);
      std::replace(c.begin(), c.end(), from, to);
      const Vector3 &p = this->Mesh.point(c[0]), &q = this->Mesh.point(c[1]), &r = this->Mesh.point(c[2]);
      const Vector3 cross = (q - p).cross(r - p);
      if (!within(this->angleOf(t) < 1.0 ? whole : this->Mesh.cross(t), cross, turnCosine))
      {
        return;
      }
      after = std::min(after, degreesOf(p, q, r));
      if (after - before <= best.gain)
      {
        return;
      }
    }
    best = { false, from, to, after - before };
  }

  // Link condition: the only common neighbours are the two vertices opposite the edge, and they keep three.
  bool linked(int from, int to, const std::vector<int>& both) const
  {
    const std::vector<int> one = this->Mesh.neighbours(from), other = this->Mesh.neighbours(to);
    std::vector<int> common;
    std::set_intersection(one.begin(), one.end(), other.begin(), other.end(), std::back_inserter(common));
    if (common.size() != 2 || this->Mesh.around(from).size() != one.size())
    {
      return false;
    }
    for (const int t : both)
    {
      const int wing = this->Mesh.opposite(t, from, to);
      if (wing < 0 || this->Mesh.neighbours(wing).size() < 4)
      {
        return false;
      }
    }
    return true;
  }

  CurveMesh& Mesh;
  const double Reach;
};

} // namespace

void cleanAlongCurves(CurveMesh& mesh, const Context& context)
{
  Cleaner cleaner(mesh);
  for (int round = 0; round < mostRounds && cleaner.round(); ++round)
  {
    context.checkpoint(0.7 + 0.3 * (round + 1) / mostRounds);
  }
}

} // namespace oversketch
