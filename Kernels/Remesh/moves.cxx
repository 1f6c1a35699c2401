// The moves of incremental remeshing that change connectivity, and the tests that keep them safe.
#include "Mesh/nearest.h"
#include "Remesh/patch.h"

namespace oversketch
{

namespace
{

// Sines squared of smallest angles that a move may not go below, unless the triangles were narrower before.
constexpr double splitNarrowest = 0.0302;    // 10 degrees
constexpr double collapseNarrowest = 0.1786; // 25 degrees
constexpr double flipNarrowest = 0.25;       // 30 degrees
// A collapse may make the smallest angle a little narrower, in sines squared: or rows of equal needles stay
// for ever.
constexpr double collapseWorsening = 0.5;
// How far a vertex that goes may leave the surface behind, in target lengths: keeps thin tips whole.
constexpr double collapseDeviation = 0.2;

// How far the middle of a split edge may be from the surface, squared and over the edge's length squared.
constexpr double largestOffset = 0.04;

int squaredDeviation(int valence, int best)
{
  return (valence - best) * (valence - best);
}

} // namespace

// True if test(u) is for a neighbour u of v; calls it once or more for each until then.
template <typename Test>
bool Patch::anyNeighbour(int v, Test&& test) const
{
  if (this->Listed[v] >= 0)
  {
    for (const int t : this->Lists[this->Listed[v]])
    {
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (this->Origin[h] != v && test(this->Origin[h]))
        {
          return true;
        }
      }
    }
    return false;
  }
  int h = this->Out[v];
  do
  {
    if (test(this->target(h)))
    {
      return true;
    }
    h = this->Twin[previousHalfEdge(h)];
  } while (h != this->Out[v]);
  return false;
}

bool Patch::joined(int a, int b) const
{
  const bool listed = this->Listed[a] >= 0;
  const int other = listed ? a : b;
  return this->anyNeighbour(listed ? b : a, [other](int u) { return u == other; });
}

int Patch::find(int a, int b, int guess) const
{
  if (guess >= 0 && this->Active[guess / 3] && this->origin(guess) == a && this->target(guess) == b)
  {
    return guess;
  }
  if (this->Out[a] < 0 || this->Out[b] < 0)
  {
    return -1;
  }
  if (this->Listed[a] >= 0 && this->Listed[b] >= 0)
  {
    for (const int t : this->Lists[this->Listed[a]])
    {
      for (int h = 3 * t; this->Active[t] && h < 3 * t + 3; ++h)
      {
        const bool along = this->origin(h) == a && this->target(h) == b;
        const bool against = this->origin(h) == b && this->target(h) == a;
        if ((along || against) && this->splittable(h))
        {
          return against && this->inner(h) ? this->Twin[h] : h;
        }
      }
    }
    return -1;
  }
  const bool swapped = this->Listed[a] >= 0;
  const int from = swapped ? b : a, to = swapped ? a : b;
  int h = this->Out[from];
  do
  {
    if (this->target(h) == to)
    {
      return swapped ? this->Twin[h] : h;
    }
    h = this->Twin[previousHalfEdge(h)];
  } while (h != this->Out[from]);
  return -1;
}

// The folds between a triangle, given by its cross product, and what lies over its half-edge h.
int Patch::foldsOver(int h, const Vector3& own) const
{
  const int twin = this->Twin[h];
  if (twin >= 0)
  {
    return foldWeight(own, this->cross(twin / 3));
  }
  int folds = 0;
  for (int other = -2 - twin; twin != borderEdge && other != h; other = -2 - this->Twin[other])
  {
    folds += foldWeight(own, this->cross(other / 3));
  }
  return folds;
}

// How sharply the surface turns between a triangle, given by its cross product, and what lies over its
// half-edge h.
double Patch::turnOver(int h, const Vector3& own, double length) const
{
  const int twin = this->Twin[h];
  if (twin >= 0)
  {
    return turnWeight(own, this->cross(twin / 3), length);
  }
  double turn = 0.0;
  for (int other = -2 - twin; twin != borderEdge && other != h; other = -2 - this->Twin[other])
  {
    turn += turnWeight(own, this->cross(other / 3), length);
  }
  return turn;
}

// Gives half-edge h the place of half-edge `was`, of which only its link, `twin`, is known any more.
void Patch::link(int h, int twin, int was)
{
  this->Twin[h] = twin;
  if (twin >= 0)
  {
    this->Twin[twin] = h;
  }
  else if (twin == -2 - was)
  {
    this->Twin[h] = -2 - h;
  }
  else if (twin != borderEdge)
  {
    int before = -2 - twin; // round the wall
    while (this->Twin[before] != -2 - was)
    {
      before = -2 - this->Twin[before];
    }
    this->Twin[before] = -2 - h;
  }
}

void Patch::join(int h, int twin)
{
  this->Twin[h] = twin;
  this->Twin[twin] = h;
}

void Patch::set(int t, int a, int b, int c)
{
  const int corners[3] = { a, b, c };
  for (int k = 0; k < 3; ++k)
  {
    this->Origin[3 * t + k] = corners[k];
    this->Out[corners[k]] = 3 * t + k;
    this->Kept[3 * t + k] = 0;
  }
}

// Where the middle of an edge lies on the surface; straight where it is the middle of the edge itself. False
// if it must not be split.
bool Patch::middleOf(int h, SurfacePoint& result, bool& straight) const
{
  const int a = this->origin(h), b = this->target(h), chart = this->chart(h / 3);
  const bool seam = this->inner(h) && this->chart(this->Twin[h] / 3) != chart;
  straight = this->Original.middle(this->Places[a], this->Places[b], seam ? -1 : chart, result);
  if (straight)
  {
    return true;
  }
  if (this->protectedEdge(h) || !this->inner(h))
  {
    return false; // an edge of the input that must stay where it is, but cannot be found on it any more
  }
  const Mesh& mesh = this->Original.mesh();
  const Vector3 middle = 0.5 * (this->Points[a] + this->Points[b]);
  const auto nearest = [&](int v)
  { return this->Original.closest(middle, this->Original.inChart(this->Places[v], chart, middle).triangle); };
  const SurfacePoint first = nearest(a), second = nearest(b);
  const double firstOffset = (positionOf(mesh, first) - middle).squaredNorm();
  const double secondOffset = (positionOf(mesh, second) - middle).squaredNorm();
  result = secondOffset < firstOffset ? second : first;
  // A middle that the surface puts near one of the ends would leave the edge as long as it was, time and
  // again.
  return std::min(firstOffset, secondOffset) <=
         largestOffset * (this->Points[a] - this->Points[b]).squaredNorm();
}

// Halves that a vertex on an edge makes of its two triangles: at the edge's ends of the first, then of the
// second.
Patch::Halves Patch::halvesAt(int h, const Vector3& p) const
{
  const Vector3 &a = this->at(h), &b = this->at(nextHalfEdge(h));
  const Vector3& c = this->at(previousHalfEdge(h));
  const Vector3& d = this->at(previousHalfEdge(this->Twin[h]));
  return { this->cross(a, p, c), this->cross(p, b, c), -this->cross(a, p, d), -this->cross(p, b, d) };
}

bool Patch::halvesFold(int h, const Halves& half) const
{
  const int g = this->Twin[h];
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h), g1 = nextHalfEdge(g), g2 = previousHalfEdge(g);
  const int after = foldWeight(half[0], half[1]) + foldWeight(half[2], half[3]) +
                    foldWeight(half[0], half[2]) + foldWeight(half[1], half[3]) +
                    this->foldsOver(h2, half[0]) + this->foldsOver(h1, half[1]) +
                    this->foldsOver(g1, half[2]) + this->foldsOver(g2, half[3]);
  const Vector3 whole[2] = { this->cross(h / 3), this->cross(g / 3) };
  return after > 0 && after > foldWeight(whole[0], whole[1]) + this->foldsOver(h2, whole[0]) +
                                this->foldsOver(h1, whole[0]) + this->foldsOver(g1, whole[1]) +
                                this->foldsOver(g2, whole[1]);
}

int Patch::split(int h, std::array<int, 4>& neighbours)
{
  const bool inside = this->inner(h);
  const int a = this->origin(h), b = this->target(h), c = this->origin(previousHalfEdge(h));
  const int g = inside ? this->Twin[h] : -1;
  const int d = inside ? this->origin(previousHalfEdge(g)) : -1;
  const int t0 = h / 3, t1 = g / 3;
  const Vector3 whole[2] = { this->cross(t0), inside ? this->cross(t1) : Vector3(0, 0, 0) };
  SurfacePoint place;
  bool straight = false;
  if (c == d || (inside && folded(whole[0], whole[1])) || !this->middleOf(h, place, straight))
  {
    return -1; // of a folded edge there would be two
  }
  const Vector3 p = positionOf(this->Original.mesh(), place);
  const Vector3 &pa = this->Points[a], &pb = this->Points[b];
  Halves half;
  double narrowest = std::numeric_limits<double>::infinity(), narrowestBefore = narrowest;
  for (int i = 0; i < (inside ? 2 : 1); ++i)
  {
    const Vector3& wing = this->Points[i == 0 ? c : d];
    const double sign = i == 0 ? 1.0 : -1.0;
    half[2 * i] = sign * this->cross(pa, p, wing);
    half[2 * i + 1] = sign * this->cross(p, pb, wing);
    narrowest =
      std::min({ narrowest, narrowness(pa, p, wing, half[2 * i]), narrowness(p, pb, wing, half[2 * i + 1]) });
    narrowestBefore = std::min(narrowestBefore, narrowness(pa, pb, wing, whole[i]));
  }
  // Beside a long edge that cannot be split, splitting the others would go on for ever with ever flatter
  // triangles.
  if (narrowest < std::min(splitNarrowest, 0.98 * narrowestBefore))
  {
    return -1;
  }
  if (!straight)
  {
    if (turned(whole[0], half[0]) || turned(whole[0], half[1]) || turned(whole[1], half[2]) ||
        turned(whole[1], half[3]))
    {
      return -1;
    }
    if (this->halvesFold(h, half))
    {
      return -1;
    }
  }
  return this->halve(h, place, p, neighbours);
}

int Patch::halve(int h, const SurfacePoint& place, const Vector3& position, std::array<int, 4>& neighbours)
{
  const bool inside = this->inner(h);
  const int a = this->origin(h), b = this->target(h), c = this->origin(previousHalfEdge(h));
  const int g = inside ? this->Twin[h] : -1;
  const int d = inside ? this->origin(previousHalfEdge(g)) : -1;
  const int t0 = h / 3, t1 = g / 3;
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h);
  const int g1 = inside ? nextHalfEdge(g) : -1, g2 = inside ? previousHalfEdge(g) : -1;
  const char kept = this->Kept[h];
  const int m = this->addVertex(place, position, kept || !inside, !inside);
  if (kept)
  {
    this->KeptSplits.push_back({ a, b, m });
  }
  neighbours = { a, b, c, d };
  const auto part = [&](int t, int s, int e, int wing, int first, int second)
  {
    // Triangle t = (s, e, wing), with half-edges first (e to wing) and second (wing to s), becomes
    // (s, m, wing) and a new one, (m, e, wing).
    const int firstTwin = this->Twin[first], secondTwin = this->Twin[second];
    const char firstKept = this->Kept[first], secondKept = this->Kept[second];
    const int fresh = this->addTriangle(this->chart(t));
    this->set(t, s, m, wing);
    this->set(fresh, m, e, wing);
    this->link(3 * t + 2, secondTwin, second);
    this->link(3 * fresh + 1, firstTwin, first);
    this->join(3 * t + 1, 3 * fresh + 2);
    this->Kept[3 * t] = this->Kept[3 * fresh] = kept;
    this->Kept[3 * t + 2] = secondKept;
    this->Kept[3 * fresh + 1] = firstKept;
    this->detach(e, t);
    this->attach(e, fresh);
    this->attach(wing, fresh);
    this->attach(m, t);
    this->attach(m, fresh);
    ++this->Valence[wing];
    this->Valence[m] += 2;
    return fresh;
  };
  const int f0 = part(t0, a, b, c, h1, h2);
  if (inside)
  {
    const int f1 = part(t1, b, a, d, g1, g2); // t1 is now (b, m, d), f1 (m, a, d)
    this->join(3 * t0, 3 * f1);
    this->join(3 * f0, 3 * t1);
  }
  else
  {
    this->Twin[3 * t0] = this->Twin[3 * f0] = borderEdge;
  }
  return m;
}

// Fills Spokes and Ring with what is round a half-edge's origin; false where the mesh would not stay a
// surface without it, or an edge longer than `longest` would come.
bool Patch::ringToCollapse(int h, double longest)
{
  const int to = this->target(h);
  // Link condition: the two vertices opposite the edge are the only common neighbours, and stay in at least
  // three triangles (one on a border).
  for (const int wing : { this->origin(previousHalfEdge(h)), this->origin(previousHalfEdge(this->Twin[h])) })
  {
    if (this->Valence[wing] <= (this->Border[wing] ? 2 : 3))
    {
      return false;
    }
  }
  // Half-edges out of `from` in turn, the first to `to`, the second to one wing, the last to the other.
  this->Spokes.clear();
  this->Ring.clear();
  int spoke = h;
  do
  {
    const int w = this->target(spoke);
    if (spoke != h && this->relativeSquared(to, w) > longest * longest)
    {
      return false;
    }
    this->Spokes.push_back(spoke);
    this->Ring.push_back(w);
    spoke = this->Twin[previousHalfEdge(spoke)];
  } while (spoke != h);
  const int n = static_cast<int>(this->Ring.size());
  const auto farSide = [this, n](int u)
  { return std::find(this->Ring.begin() + 2, this->Ring.begin() + n - 1, u) != this->Ring.begin() + n - 1; };
  if (n < 3 || (n > 3 && this->anyNeighbour(to, farSide)))
  {
    return false;
  }
  // A triangle that is left must not lie upon another.
  const int rim = this->Twin[nextHalfEdge(this->Spokes[1])];
  return n > 3 || (rim >= 0 && this->origin(previousHalfEdge(rim)) != to);
}

// Fills Before and After for the ring; false where a triangle would turn over or become too narrow, or the
// surface would lose what the vertex stands for.
bool Patch::shapeSurvivesCollapse(int h)
{
  const int from = this->origin(h), to = this->target(h), n = static_cast<int>(this->Ring.size());
  // Triangle i lies between spokes i and i + 1: the first and the last go, the others move to `to`.
  this->Before.resize(n);
  this->After.resize(n);
  const Vector3 &old = this->Points[from], &goal = this->Points[to];
  double narrowest = std::numeric_limits<double>::infinity(), narrowestBefore = narrowest;
  for (int i = 0; i < n; ++i)
  {
    const Vector3 &p = this->Points[this->Ring[i]], &q = this->Points[this->Ring[i + 1 == n ? 0 : i + 1]];
    this->Before[i] = this->cross(old, p, q);
    narrowestBefore = std::min(narrowestBefore, narrowness(old, p, q, this->Before[i]));
    if (i > 0 && i + 1 < n)
    {
      this->After[i] = this->cross(goal, p, q);
      if (turned(this->Before[i], this->After[i]))
      {
        return false;
      }
      narrowest = std::min(narrowest, narrowness(goal, p, q, this->After[i]));
    }
  }
  if (narrowest < std::min(collapseWorsening * narrowestBefore, collapseNarrowest))
  {
    return false;
  }
  const double deviation = collapseDeviation * this->Sizes[from];
  bool near = (old - goal).squaredNorm() <= deviation * deviation;
  for (int i = 1; !near && i + 1 < n; ++i)
  {
    near = squaredDistance(goal, this->Points[this->Ring[i]], this->Points[this->Ring[i + 1]], old) <=
           deviation * deviation;
  }
  return near;
}

// Whether there would be more folded edges.
bool Patch::collapseFolds(int h) const
{
  const int n = static_cast<int>(this->Ring.size());
  int folds = this->foldsOver(nextHalfEdge(h), this->After[1]) +
              this->foldsOver(nextHalfEdge(this->Spokes[n - 1]), this->After[n - 2]);
  for (int i = 1; i + 1 < n; ++i)
  {
    folds += this->foldsOver(nextHalfEdge(this->Spokes[i]), this->After[i]) +
             (i + 2 < n ? foldWeight(this->After[i], this->After[i + 1]) : 0);
  }
  for (int i = 0; folds > 0 && i < n; ++i)
  {
    folds -= this->foldsOver(nextHalfEdge(this->Spokes[i]), this->Before[i]) +
             foldWeight(this->Before[i], this->Before[i + 1 == n ? 0 : i + 1]);
  }
  return folds > 0;
}

// Whether the surface would turn more sharply, beyond the slack.
bool Patch::collapseTurns(int h) const
{
  const int n = static_cast<int>(this->Ring.size());
  const Vector3 &old = this->Points[this->origin(h)], &goal = this->Points[this->target(h)];
  const int last = nextHalfEdge(this->Spokes[n - 1]);
  double turn = this->turnOver(nextHalfEdge(h), this->After[1], this->lengthOf(nextHalfEdge(h))) +
                this->turnOver(last, this->After[n - 2], this->lengthOf(last));
  for (int i = 1; i + 1 < n; ++i)
  {
    const int rim = nextHalfEdge(this->Spokes[i]);
    turn += this->turnOver(rim, this->After[i], this->lengthOf(rim));
    if (i + 2 < n)
    {
      turn += turnWeight(this->After[i], this->After[i + 1], (this->Points[this->Ring[i + 1]] - goal).norm());
    }
  }
  turn -= turnSlack * this->Sizes[this->origin(h)];
  for (int i = 0; turn > 0.0 && i < n; ++i)
  {
    const int rim = nextHalfEdge(this->Spokes[i]), next = i + 1 == n ? 0 : i + 1;
    turn -= this->turnOver(rim, this->Before[i], this->lengthOf(rim)) +
            turnWeight(this->Before[i], this->Before[next], (this->Points[this->Ring[next]] - old).norm());
  }
  return turn > 0.0;
}

bool Patch::collapse(int h, double longest)
{
  if (!this->inner(h) || this->fixed(this->origin(h)) || !this->ringToCollapse(h, longest) ||
      !this->shapeSurvivesCollapse(h) || this->collapseFolds(h) ||
      (this->KeepSmooth && this->collapseTurns(h)))
  {
    return false;
  }
  const int from = this->origin(h), to = this->target(h), n = static_cast<int>(this->Ring.size());
  const int wings[2] = { this->origin(previousHalfEdge(h)), this->origin(previousHalfEdge(this->Twin[h])) };
  const int t0 = this->Spokes[0] / 3, t1 = this->Spokes[n - 1] / 3;
  const int first = nextHalfEdge(this->Spokes[0]);    // `to` to the first wing
  const int last = nextHalfEdge(this->Spokes[n - 1]); // the last wing to `to`
  for (int i = 1; i + 1 < n; ++i)
  {
    this->Origin[this->Spokes[i]] = to;
    this->attach(to, this->Spokes[i] / 3);
  }
  const int newFirst = this->Spokes[1], newLast = previousHalfEdge(this->Spokes[n - 2]);
  this->Kept[newFirst] = this->Kept[first];
  this->Kept[newLast] = this->Kept[last];
  this->link(newFirst, this->Twin[first], first);
  this->link(newLast, this->Twin[last], last);
  this->Active[t0] = this->Active[t1] = 0;
  for (const int v : { to, wings[0] })
  {
    this->detach(v, t0);
  }
  for (const int v : { to, wings[1] })
  {
    this->detach(v, t1);
  }
  --this->Valence[wings[0]];
  --this->Valence[wings[1]];
  this->Valence[to] += n - 4;
  this->Out[to] = newFirst;
  this->Out[wings[0]] = nextHalfEdge(newFirst);
  this->Out[wings[1]] = newLast;
  this->MergedInto[from] = to;
  return true;
}

bool Patch::flippable(int h, bool byAngle) const
{
  if (!this->inner(h) || this->protectedEdge(h))
  {
    return false;
  }
  const int g = this->Twin[h];
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h), g1 = nextHalfEdge(g), g2 = previousHalfEdge(g);
  const int a = this->origin(h), b = this->origin(h1), c = this->origin(h2), d = this->origin(g2);
  const auto gainOf = [this](int v, int change)
  {
    const int best = this->Border[v] ? 4 : 6;
    return squaredDeviation(this->Valence[v], best) - squaredDeviation(this->Valence[v] + change, best);
  };
  if ((!byAngle && gainOf(a, -1) + gainOf(b, -1) + gainOf(c, 1) + gainOf(d, 1) <= 0) ||
      this->Valence[a] <= 3 || this->Valence[b] <= 3 || c == d)
  {
    return false;
  }
  const Vector3 &pa = this->Points[a], &pb = this->Points[b], &pc = this->Points[c], &pd = this->Points[d];
  const Vector3 before[2] = { this->cross(pa, pb, pc), this->cross(pb, pa, pd) };
  const Vector3 after[2] = { this->cross(pa, pd, pc), this->cross(pd, pb, pc) };
  const double narrowestBefore =
    std::min(narrowness(pa, pb, pc, before[0]), narrowness(pb, pa, pd, before[1]));
  const double narrowest = std::min(narrowness(pa, pd, pc, after[0]), narrowness(pd, pb, pc, after[1]));
  const Vector3 whole = before[0] + before[1];
  if ((byAngle ? narrowest <= 1.05 * narrowestBefore
               : narrowest < std::min(narrowestBefore, flipNarrowest)) ||
      turned(before[0], before[1]) || turned(after[0], after[1]) || turned(whole, after[0]) ||
      turned(whole, after[1]) || this->joined(c, d))
  {
    return false;
  }
  const int folds = foldWeight(after[0], after[1]) + this->foldsOver(h2, after[0]) +
                    this->foldsOver(g1, after[0]) + this->foldsOver(h1, after[1]) +
                    this->foldsOver(g2, after[1]);
  if (folds > 0 && folds > foldWeight(before[0], before[1]) + this->foldsOver(h1, before[0]) +
                             this->foldsOver(h2, before[0]) + this->foldsOver(g1, before[1]) +
                             this->foldsOver(g2, before[1]))
  {
    return false;
  }
  if (this->KeepSmooth)
  {
    const double rims[4] = { (pc - pa).norm(), (pd - pa).norm(), (pc - pb).norm(), (pd - pb).norm() };
    const double turn = turnWeight(after[0], after[1], (pd - pc).norm()) +
                        this->turnOver(h2, after[0], rims[0]) + this->turnOver(g1, after[0], rims[1]) +
                        this->turnOver(h1, after[1], rims[2]) + this->turnOver(g2, after[1], rims[3]);
    const double slack = 0.5 * turnSlack * (this->Sizes[a] + this->Sizes[b]);
    if (turn > slack &&
        turn - slack > turnWeight(before[0], before[1], (pb - pa).norm()) +
                         this->turnOver(h1, before[0], rims[2]) + this->turnOver(h2, before[0], rims[0]) +
                         this->turnOver(g1, before[1], rims[1]) + this->turnOver(g2, before[1], rims[3]))
    {
      return false;
    }
  }
  return true;
}

void Patch::flip(int h)
{
  const int g = this->Twin[h], t0 = h / 3, t1 = g / 3;
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h), g1 = nextHalfEdge(g), g2 = previousHalfEdge(g);
  const int a = this->origin(h), b = this->origin(h1), c = this->origin(h2), d = this->origin(g2);
  const int twins[4] = { this->Twin[h1], this->Twin[h2], this->Twin[g1], this->Twin[g2] };
  const char kept[4] = { this->Kept[h1], this->Kept[h2], this->Kept[g1], this->Kept[g2] };
  this->set(t0, a, d, c);
  this->set(t1, d, b, c);
  this->link(3 * t0, twins[2], g1);
  this->link(3 * t0 + 2, twins[1], h2);
  this->link(3 * t1, twins[3], g2);
  this->link(3 * t1 + 1, twins[0], h1);
  this->join(3 * t0 + 1, 3 * t1 + 2);
  this->Kept[3 * t0] = kept[2];
  this->Kept[3 * t0 + 2] = kept[1];
  this->Kept[3 * t1] = kept[3];
  this->Kept[3 * t1 + 1] = kept[0];
  this->detach(a, t1);
  this->detach(b, t0);
  this->attach(c, t1);
  this->attach(d, t0);
  --this->Valence[a];
  --this->Valence[b];
  ++this->Valence[c];
  ++this->Valence[d];
}

} // namespace oversketch
