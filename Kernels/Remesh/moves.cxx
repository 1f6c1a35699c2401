// The moves of incremental remeshing that change connectivity, and the tests that keep them safe.
#include "Remesh/shape.h"

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
  if (this->listed_[v] >= 0)
  {
    for (const int t : this->lists_[this->listed_[v]])
    {
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        if (this->origin_[h] != v && test(this->origin_[h]))
        {
          return true;
        }
      }
    }
    return false;
  }
  int h = this->out_[v];
  do
  {
    if (test(this->target(h)))
    {
      return true;
    }
    h = this->twin_[previousHalfEdge(h)];
  } while (h != this->out_[v]);
  return false;
}

bool Patch::joined(int a, int b) const
{
  const bool listed = this->listed_[a] >= 0;
  const int other = listed ? a : b;
  return this->anyNeighbour(listed ? b : a, [other](int u) { return u == other; });
}

int Patch::find(int a, int b, int guess) const
{
  if (guess >= 0 && this->active_[guess / 3] && this->origin(guess) == a && this->target(guess) == b)
  {
    return guess;
  }
  if (this->out_[a] < 0 || this->out_[b] < 0)
  {
    return -1;
  }
  if (this->listed_[a] >= 0 && this->listed_[b] >= 0)
  {
    for (const int t : this->lists_[this->listed_[a]])
    {
      for (int h = 3 * t; this->active_[t] && h < 3 * t + 3; ++h)
      {
        const bool along = this->origin(h) == a && this->target(h) == b;
        const bool against = this->origin(h) == b && this->target(h) == a;
        if ((along || against) && this->splittable(h))
        {
          return against && this->inner(h) ? this->twin_[h] : h;
        }
      }
    }
    return -1;
  }
  const bool swapped = this->listed_[a] >= 0;
  const int from = swapped ? b : a, to = swapped ? a : b;
  int h = this->out_[from];
  do
  {
    if (this->target(h) == to)
    {
      return swapped ? this->twin_[h] : h;
    }
    h = this->twin_[previousHalfEdge(h)];
  } while (h != this->out_[from]);
  return -1;
}

// The folds between a triangle, given by its cross product, and what lies over its half-edge h.
int Patch::foldsOver(int h, const Vector3& own) const
{
  const int twin = this->twin_[h];
  if (twin >= 0)
  {
    return foldWeight(own, this->cross(twin / 3));
  }
  int folds = 0;
  for (int other = -2 - twin; twin != borderEdge && other != h; other = -2 - this->twin_[other])
  {
    folds += foldWeight(own, this->cross(other / 3));
  }
  return folds;
}

// Gives half-edge h the place of half-edge `was`, of which only its link, `twin`, is known any more.
void Patch::link(int h, int twin, int was)
{
  this->twin_[h] = twin;
  if (twin >= 0)
  {
    this->twin_[twin] = h;
  }
  else if (twin == -2 - was)
  {
    this->twin_[h] = -2 - h;
  }
  else if (twin != borderEdge)
  {
    int before = -2 - twin; // round the wall
    while (this->twin_[before] != -2 - was)
    {
      before = -2 - this->twin_[before];
    }
    this->twin_[before] = -2 - h;
  }
}

void Patch::join(int h, int twin)
{
  this->twin_[h] = twin;
  this->twin_[twin] = h;
}

void Patch::set(int t, int a, int b, int c)
{
  const int corners[3] = { a, b, c };
  for (int k = 0; k < 3; ++k)
  {
    this->origin_[3 * t + k] = corners[k];
    this->out_[corners[k]] = 3 * t + k;
    this->kept_[3 * t + k] = 0;
  }
}

// Where the middle of an edge lies on the surface; straight where it is the middle of the edge itself. False
// if it must not be split.
bool Patch::middleOf(int h, SurfacePoint& result, bool& straight) const
{
  const int a = this->origin(h), b = this->target(h), chart = this->chart(h / 3);
  const bool seam = this->inner(h) && this->chart(this->twin_[h] / 3) != chart;
  straight = this->surface_.middle(this->places_[a], this->places_[b], seam ? -1 : chart, result);
  if (straight)
  {
    return true;
  }
  if (this->protectedEdge(h) || !this->inner(h))
  {
    return false; // an edge of the input that must stay where it is, but cannot be found on it any more
  }
  const Mesh& mesh = this->surface_.mesh();
  const Vector3 middle = 0.5 * (this->points_[a] + this->points_[b]);
  const auto nearest = [&](int v) {
    return this->surface_.closest(middle, this->surface_.inChart(this->places_[v], chart, middle).triangle);
  };
  const SurfacePoint first = nearest(a), second = nearest(b);
  const double firstOffset = (positionOf(mesh, first) - middle).squaredNorm();
  const double secondOffset = (positionOf(mesh, second) - middle).squaredNorm();
  result = secondOffset < firstOffset ? second : first;
  // A middle that the surface puts near one of the ends would leave the edge as long as it was, time and
  // again.
  return std::min(firstOffset, secondOffset) <=
         largestOffset * (this->points_[a] - this->points_[b]).squaredNorm();
}

int Patch::split(int h, std::array<int, 4>& neighbours)
{
  const bool inside = this->inner(h);
  const int a = this->origin(h), b = this->target(h), c = this->origin(previousHalfEdge(h));
  const int g = inside ? this->twin_[h] : -1;
  const int d = inside ? this->origin(previousHalfEdge(g)) : -1;
  const int t0 = h / 3, t1 = g / 3;
  const Vector3 whole[2] = { this->cross(t0), inside ? this->cross(t1) : Vector3(0, 0, 0) };
  SurfacePoint place;
  bool straight = false;
  if (c == d || (inside && folded(whole[0], whole[1])) || !this->middleOf(h, place, straight))
  {
    return -1; // of a folded edge there would be two
  }
  const Vector3 p = positionOf(this->surface_.mesh(), place);
  const Vector3 &pa = this->points_[a], &pb = this->points_[b];
  // Halves at a and b of the first triangle, then of the second.
  Vector3 half[4];
  double narrowest = std::numeric_limits<double>::infinity(), narrowestBefore = narrowest;
  for (int i = 0; i < (inside ? 2 : 1); ++i)
  {
    const Vector3& wing = this->points_[i == 0 ? c : d];
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
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h);
  const int g1 = inside ? nextHalfEdge(g) : -1, g2 = inside ? previousHalfEdge(g) : -1;
  if (!straight)
  {
    if (turned(whole[0], half[0]) || turned(whole[0], half[1]) || turned(whole[1], half[2]) ||
        turned(whole[1], half[3]))
    {
      return -1;
    }
    const int after = foldWeight(half[0], half[1]) + foldWeight(half[2], half[3]) +
                      foldWeight(half[0], half[2]) + foldWeight(half[1], half[3]) +
                      this->foldsOver(h2, half[0]) + this->foldsOver(h1, half[1]) +
                      this->foldsOver(g1, half[2]) + this->foldsOver(g2, half[3]);
    if (after > 0 && after > foldWeight(whole[0], whole[1]) + this->foldsOver(h2, whole[0]) +
                               this->foldsOver(h1, whole[0]) + this->foldsOver(g1, whole[1]) +
                               this->foldsOver(g2, whole[1]))
    {
      return -1;
    }
  }

  const char kept = this->kept_[h];
  const int m = this->addVertex(place, kept || !inside, !inside);
  neighbours = { a, b, c, d };
  const auto halve = [&](int t, int s, int e, int wing, int first, int second)
  {
    // Triangle t = (s, e, wing), with half-edges first (e to wing) and second (wing to s), becomes
    // (s, m, wing) and a new one, (m, e, wing).
    const int firstTwin = this->twin_[first], secondTwin = this->twin_[second];
    const char firstKept = this->kept_[first], secondKept = this->kept_[second];
    const int fresh = this->addTriangle(this->chart(t));
    this->set(t, s, m, wing);
    this->set(fresh, m, e, wing);
    this->link(3 * t + 2, secondTwin, second);
    this->link(3 * fresh + 1, firstTwin, first);
    this->join(3 * t + 1, 3 * fresh + 2);
    this->kept_[3 * t] = this->kept_[3 * fresh] = kept;
    this->kept_[3 * t + 2] = secondKept;
    this->kept_[3 * fresh + 1] = firstKept;
    this->detach(e, t);
    this->attach(e, fresh);
    this->attach(wing, fresh);
    this->attach(m, t);
    this->attach(m, fresh);
    ++this->valence_[wing];
    this->valence_[m] += 2;
    return fresh;
  };
  const int f0 = halve(t0, a, b, c, h1, h2);
  if (inside)
  {
    const int f1 = halve(t1, b, a, d, g1, g2); // t1 is now (b, m, d), f1 (m, a, d)
    this->join(3 * t0, 3 * f1);
    this->join(3 * f0, 3 * t1);
  }
  else
  {
    this->twin_[3 * t0] = this->twin_[3 * f0] = borderEdge;
  }
  return m;
}

// Fills spokes_ and ring_ with what is round a half-edge's origin; false where the mesh would not stay a
// surface without it, or an edge longer than `longest` would come.
bool Patch::ringToCollapse(int h, double longest)
{
  const int to = this->target(h);
  // Link condition: the two vertices opposite the edge are the only common neighbours, and stay in at least
  // three triangles (one on a border).
  for (const int wing : { this->origin(previousHalfEdge(h)), this->origin(previousHalfEdge(this->twin_[h])) })
  {
    if (this->valence_[wing] <= (this->border_[wing] ? 2 : 3))
    {
      return false;
    }
  }
  // Half-edges out of `from` in turn, the first to `to`, the second to one wing, the last to the other.
  this->spokes_.clear();
  this->ring_.clear();
  int spoke = h;
  do
  {
    const int w = this->target(spoke);
    if (spoke != h && this->relativeSquared(to, w) > longest * longest)
    {
      return false;
    }
    this->spokes_.push_back(spoke);
    this->ring_.push_back(w);
    spoke = this->twin_[previousHalfEdge(spoke)];
  } while (spoke != h);
  const int n = static_cast<int>(this->ring_.size());
  const auto farSide = [this, n](int u) {
    return std::find(this->ring_.begin() + 2, this->ring_.begin() + n - 1, u) != this->ring_.begin() + n - 1;
  };
  if (n < 3 || (n > 3 && this->anyNeighbour(to, farSide)))
  {
    return false;
  }
  // A triangle that is left must not lie upon another.
  const int rim = this->twin_[nextHalfEdge(this->spokes_[1])];
  return n > 3 || (rim >= 0 && this->origin(previousHalfEdge(rim)) != to);
}

// Fills before_ and after_ for the ring; false where a triangle would turn over or become too narrow, or the
// surface would lose what the vertex stands for.
bool Patch::shapeSurvivesCollapse(int h)
{
  const int from = this->origin(h), to = this->target(h), n = static_cast<int>(this->ring_.size());
  // Triangle i lies between spokes i and i + 1: the first and the last go, the others move to `to`.
  this->before_.resize(n);
  this->after_.resize(n);
  const Vector3 &old = this->points_[from], &goal = this->points_[to];
  double narrowest = std::numeric_limits<double>::infinity(), narrowestBefore = narrowest;
  for (int i = 0; i < n; ++i)
  {
    const Vector3 &p = this->points_[this->ring_[i]], &q = this->points_[this->ring_[i + 1 == n ? 0 : i + 1]];
    this->before_[i] = this->cross(old, p, q);
    narrowestBefore = std::min(narrowestBefore, narrowness(old, p, q, this->before_[i]));
    if (i > 0 && i + 1 < n)
    {
      this->after_[i] = this->cross(goal, p, q);
      if (turned(this->before_[i], this->after_[i]))
      {
        return false;
      }
      narrowest = std::min(narrowest, narrowness(goal, p, q, this->after_[i]));
    }
  }
  if (narrowest < std::min(collapseWorsening * narrowestBefore, collapseNarrowest))
  {
    return false;
  }
  const double deviation = collapseDeviation * this->sizes_[from];
  bool near = (old - goal).squaredNorm() <= deviation * deviation;
  for (int i = 1; !near && i + 1 < n; ++i)
  {
    near = squaredDistance(goal, this->points_[this->ring_[i]], this->points_[this->ring_[i + 1]], old) <=
           deviation * deviation;
  }
  return near;
}

// Whether there would be more folded edges.
bool Patch::collapseFolds(int h) const
{
  const int n = static_cast<int>(this->ring_.size());
  int folds = this->foldsOver(nextHalfEdge(h), this->after_[1]) +
              this->foldsOver(nextHalfEdge(this->spokes_[n - 1]), this->after_[n - 2]);
  for (int i = 1; i + 1 < n; ++i)
  {
    folds += this->foldsOver(nextHalfEdge(this->spokes_[i]), this->after_[i]) +
             (i + 2 < n ? foldWeight(this->after_[i], this->after_[i + 1]) : 0);
  }
  for (int i = 0; folds > 0 && i < n; ++i)
  {
    folds -= this->foldsOver(nextHalfEdge(this->spokes_[i]), this->before_[i]) +
             foldWeight(this->before_[i], this->before_[i + 1 == n ? 0 : i + 1]);
  }
  return folds > 0;
}

bool Patch::collapse(int h, double longest)
{
  if (!this->inner(h) || this->fixed(this->origin(h)) || !this->ringToCollapse(h, longest) ||
      !this->shapeSurvivesCollapse(h) || this->collapseFolds(h))
  {
    return false;
  }
  const int from = this->origin(h), to = this->target(h), n = static_cast<int>(this->ring_.size());
  const int wings[2] = { this->origin(previousHalfEdge(h)), this->origin(previousHalfEdge(this->twin_[h])) };
  const int t0 = this->spokes_[0] / 3, t1 = this->spokes_[n - 1] / 3;
  const int first = nextHalfEdge(this->spokes_[0]);    // `to` to the first wing
  const int last = nextHalfEdge(this->spokes_[n - 1]); // the last wing to `to`
  for (int i = 1; i + 1 < n; ++i)
  {
    this->origin_[this->spokes_[i]] = to;
    this->attach(to, this->spokes_[i] / 3);
  }
  const int newFirst = this->spokes_[1], newLast = previousHalfEdge(this->spokes_[n - 2]);
  this->kept_[newFirst] = this->kept_[first];
  this->kept_[newLast] = this->kept_[last];
  this->link(newFirst, this->twin_[first], first);
  this->link(newLast, this->twin_[last], last);
  this->active_[t0] = this->active_[t1] = 0;
  for (const int v : { to, wings[0] })
  {
    this->detach(v, t0);
  }
  for (const int v : { to, wings[1] })
  {
    this->detach(v, t1);
  }
  --this->valence_[wings[0]];
  --this->valence_[wings[1]];
  this->valence_[to] += n - 4;
  this->out_[to] = newFirst;
  this->out_[wings[0]] = nextHalfEdge(newFirst);
  this->out_[wings[1]] = newLast;
  this->mergedInto_[from] = to;
  return true;
}

bool Patch::flip(int h, bool byAngle)
{
  if (!this->inner(h) || this->protectedEdge(h))
  {
    return false;
  }
  const int g = this->twin_[h];
  const int h1 = nextHalfEdge(h), h2 = previousHalfEdge(h), g1 = nextHalfEdge(g), g2 = previousHalfEdge(g);
  const int a = this->origin(h), b = this->origin(h1), c = this->origin(h2), d = this->origin(g2);
  const auto gainOf = [this](int v, int change)
  {
    const int best = this->border_[v] ? 4 : 6;
    return squaredDeviation(this->valence_[v], best) - squaredDeviation(this->valence_[v] + change, best);
  };
  if ((!byAngle && gainOf(a, -1) + gainOf(b, -1) + gainOf(c, 1) + gainOf(d, 1) <= 0) ||
      this->valence_[a] <= 3 || this->valence_[b] <= 3 || c == d)
  {
    return false;
  }
  const int t0 = h / 3, t1 = g / 3;
  const Vector3 &pa = this->points_[a], &pb = this->points_[b], &pc = this->points_[c],
                &pd = this->points_[d];
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

  const int twins[4] = { this->twin_[h1], this->twin_[h2], this->twin_[g1], this->twin_[g2] };
  const char kept[4] = { this->kept_[h1], this->kept_[h2], this->kept_[g1], this->kept_[g2] };
  this->set(t0, a, d, c);
  this->set(t1, d, b, c);
  this->link(3 * t0, twins[2], g1);
  this->link(3 * t0 + 2, twins[1], h2);
  this->link(3 * t1, twins[3], g2);
  this->link(3 * t1 + 1, twins[0], h1);
  this->join(3 * t0 + 1, 3 * t1 + 2);
  this->kept_[3 * t0] = kept[2];
  this->kept_[3 * t0 + 2] = kept[1];
  this->kept_[3 * t1] = kept[3];
  this->kept_[3 * t1 + 1] = kept[0];
  this->detach(a, t1);
  this->detach(b, t0);
  this->attach(c, t1);
  this->attach(d, t0);
  --this->valence_[a];
  --this->valence_[b];
  ++this->valence_[c];
  ++this->valence_[d];
  return true;
}

} // namespace oversketch
