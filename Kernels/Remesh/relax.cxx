#include "Remesh/relax.h"

#include "Mesh/nearest.h"
#include "Remesh/patch.h"

namespace oversketch
{

namespace
{

constexpr double moveNarrowest = 0.25; // sine squared of 30 degrees, as for a flip
constexpr double moveDeviation = 0.1;  // how far a vertex may leave the surface behind, in target lengths
constexpr double smallestMove = 0.01;  // not worth the tests, in target lengths
constexpr int checkEvery = 1024;       // vertices or triangles between two looks at whether to stop
constexpr int worthThreads = 512;      // of them

} // namespace

template <typename Body>
void Relaxation::parallel(int count, const Body& body) const
{
  const auto all = [this, &body](int begin, int end)
  {
    for (int i = begin; i < end; ++i)
    {
      if (i % checkEvery == 0 && this->Caller.cancelled())
      {
        return;
      }
      body(i);
    }
  };
  count < worthThreads ? all(0, count) : this->Caller.parallelFor(count, all);
}

// Calls visit(spoke) for the half-edges out of a free vertex.
template <typename Visit>
void Relaxation::eachSpoke(int v, Visit&& visit) const
{
  const int first = this->Area.Out[v];
  int h = first;
  do
  {
    visit(h);
    h = this->Area.Twin[previousHalfEdge(h)];
  } while (h != first);
}

// Towards the mean of its neighbours. Weighing by area evens out areas, but is slower to even out angles, and
// no better on graded ground, where triangles in order have their target area anyway.
void Relaxation::want(int v)
{
  const Patch& patch = this->Area;
  const Vector3 old = patch.Points[v];
  this->Points[v] = old;
  this->Moves[v] = 0;
  if (!patch.aliveVertex(v) || patch.fixed(v))
  {
    return;
  }
  // Cross products about the origin moved to `old` add up to twice the area vector of the fan.
  const Vector3 first = patch.Points[patch.target(patch.Out[v])] - old;
  Vector3 sum = Vector3::Zero(), normal = Vector3::Zero(), last = first;
  int count = 0;
  this->eachSpoke(v,
    [&](int h)
    {
      const Vector3 spoke = patch.Points[patch.target(h)] - old;
      sum += spoke;
      normal += last.cross(spoke);
      last = spoke;
      ++count;
    });
  normal += last.cross(first);
  const double squared = normal.squaredNorm();
  if (!(squared > 0.0))
  {
    return;
  }
  const Vector3 mean = sum / count;
  const Vector3 step = mean - normal * (normal.dot(mean) / squared);
  const double least = smallestMove * patch.Sizes[v];
  if (this->Quick && step.squaredNorm() < least * least)
  {
    return;
  }
  const Vector3 goal = old + step;
  const int from = patch.Places[v].triangle;
  this->Places[v] = patch.Original.closest(goal, this->Quick ? patch.Original.towards(goal, from) : from);
  const Vector3 wanted = positionOf(patch.Original.mesh(), this->Places[v]);
  if ((wanted - old).squaredNorm() >= least * least)
  {
    this->Points[v] = wanted;
    this->Moves[v] = 1;
  }
}

bool Relaxation::changes(int t) const
{
  const int* corners = this->Area.Origin.data() + 3 * t;
  return this->Moves[corners[0]] || this->Moves[corners[1]] || this->Moves[corners[2]];
}

void Relaxation::see(int t)
{
  const Patch& patch = this->Area;
  if (!patch.aliveTriangle(t))
  {
    return;
  }
  const Triangle c = patch.triangle(t);
  const Vector3 &a = this->Points[c[0]], &b = this->Points[c[1]], &d = this->Points[c[2]];
  this->Crosses[t] = patch.cross(a, b, d);
  if (this->changes(t))
  {
    const Vector3 &a0 = patch.Points[c[0]], &b0 = patch.Points[c[1]], &d0 = patch.Points[c[2]];
    const Vector3 before = patch.cross(a0, b0, d0);
    this->Changes[t] = { static_cast<float>(narrowness(a, b, d, this->Crosses[t])),
      static_cast<float>(narrowness(a0, b0, d0, before)),
      turned(before, this->Crosses[t]),
      false,
      false };
  }
}

void Relaxation::seeFolds(int t)
{
  if (!this->Area.aliveTriangle(t) || !this->changes(t))
  {
    return;
  }
  const Vector3& own = this->Crosses[t];
  bool folded = false, sharp = false;
  for (int h = 3 * t; h < 3 * t + 3; ++h)
  {
    const int twin = this->Area.Twin[h];
    folded =
      folded || (twin >= 0 ? own.dot(this->Crosses[twin / 3]) < 0.0 : this->Area.foldsOver(h, own) > 0);
    sharp = sharp || (this->Area.KeepSmooth && (twin >= 0 ? turnWeight(own, this->Crosses[twin / 3], 1.0)
                                                          : this->Area.turnOver(h, own, 1.0)) > 0.0);
  }
  this->Changes[t].folded = folded;
  this->Changes[t].sharp = sharp;
}

// How sharply the edges are folded at v and opposite.
int Relaxation::foldsAround(int v, const std::vector<Vector3>& at) const
{
  const Patch& patch = this->Area;
  const auto crossOf = [&](int h)
  {
    const Triangle c = patch.triangle(h / 3);
    return patch.cross(at[c[0]], at[c[1]], at[c[2]]);
  };
  int folds = 0;
  this->eachSpoke(v,
    [&](int h)
    {
      const Vector3 own = crossOf(h);
      const int rim = patch.Twin[nextHalfEdge(h)];
      folds += foldWeight(own, crossOf(patch.Twin[h])) +
               (rim >= 0 ? foldWeight(own, crossOf(rim)) : patch.foldsOver(nextHalfEdge(h), own));
    });
  return folds;
}

// How sharply the surface turns at the edges at v and opposite.
double Relaxation::turnAround(int v, const std::vector<Vector3>& at) const
{
  const Patch& patch = this->Area;
  const auto crossOf = [&](int h)
  {
    const Triangle c = patch.triangle(h / 3);
    return patch.cross(at[c[0]], at[c[1]], at[c[2]]);
  };
  const auto lengthOf = [&](int h) { return (at[patch.target(h)] - at[patch.origin(h)]).norm(); };
  double turn = 0.0;
  this->eachSpoke(v,
    [&](int h)
    {
      const Vector3 own = crossOf(h);
      const int opposite = nextHalfEdge(h), rim = patch.Twin[opposite];
      turn += turnWeight(own, crossOf(patch.Twin[h]), lengthOf(h)) +
              (rim >= 0 ? turnWeight(own, crossOf(rim), lengthOf(opposite))
                        : patch.turnOver(opposite, own, lengthOf(opposite)));
    });
  return turn;
}

bool Relaxation::safe(int v) const
{
  const Patch& patch = this->Area;
  float narrowest = 1.0F, narrowestBefore = 1.0F;
  bool good = true, folded = false, sharp = false;
  this->eachSpoke(v,
    [&](int h)
    {
      const Change& change = this->Changes[h / 3];
      narrowest = std::min(narrowest, change.narrowest);
      narrowestBefore = std::min(narrowestBefore, change.narrowestBefore);
      good = good && !change.turned;
      folded = folded || change.folded;
      sharp = sharp || change.sharp;
    });
  if (!good || narrowest < std::min(narrowestBefore, static_cast<float>(moveNarrowest)))
  {
    return false;
  }
  const Vector3& old = patch.Points[v];
  const double deviation = moveDeviation * patch.Sizes[v] * moveDeviation * patch.Sizes[v];
  bool near = (this->Points[v] - old).squaredNorm() <= deviation;
  if (!near)
  {
    this->eachSpoke(v,
      [&](int h)
      {
        const Triangle c = patch.triangle(h / 3);
        near = near ||
               squaredDistance(this->Points[c[0]], this->Points[c[1]], this->Points[c[2]], old) <= deviation;
      });
  }
  return near && (!folded || this->foldsAround(v, this->Points) <= this->foldsAround(v, patch.Points)) &&
         (!sharp || this->turnAround(v, this->Points) <=
                      this->turnAround(v, patch.Points) + turnSlack * patch.Sizes[v]);
}

// Takes back moves until all that are left are safe: taking back one may spoil those around it.
void Relaxation::settle()
{
  const int count = this->Area.vertexCount();
  this->parallel(count, [this](int v) { this->Unsafe[v] = this->Moves[v] && !this->safe(v) ? 1 : 0; });
  std::vector<int> back = marked(this->Unsafe), triangles, around;
  std::vector<char> isListed(this->Crosses.size(), 0), isAround(this->Points.size(), 0);
  const auto list = [](int i, std::vector<char>& marks, std::vector<int>& all)
  {
    if (!marks[i])
    {
      marks[i] = 1;
      all.push_back(i);
    }
  };
  while (!back.empty() && !this->Caller.cancelled())
  {
    triangles.clear();
    around.clear();
    for (const int v : back)
    {
      this->Moves[v] = 0;
      this->Points[v] = this->Area.Points[v];
      this->eachSpoke(v, [&](int h) { list(h / 3, isListed, triangles); });
    }
    const std::size_t changed = triangles.size();
    this->parallel(static_cast<int>(changed), [&](int i) { this->see(triangles[i]); });
    for (std::size_t i = 0; i < changed; ++i)
    {
      for (int h = 3 * triangles[i]; h < 3 * triangles[i] + 3; ++h)
      {
        const int twin = this->Area.Twin[h];
        if (twin >= 0)
        {
          list(twin / 3, isListed, triangles); // sees another fold now
        }
      }
    }
    this->parallel(static_cast<int>(triangles.size()), [&](int i) { this->seeFolds(triangles[i]); });
    for (const int t : triangles)
    {
      isListed[t] = 0;
      for (const int v : this->Area.triangle(t))
      {
        list(v, isAround, around);
      }
    }
    this->parallel(static_cast<int>(around.size()),
      [&](int i) { this->Unsafe[around[i]] = this->Moves[around[i]] && !this->safe(around[i]) ? 1 : 0; });
    back.clear();
    for (const int v : around)
    {
      isAround[v] = 0;
      if (this->Unsafe[v])
      {
        back.push_back(v);
      }
    }
  }
}

void Relaxation::run()
{
  Patch& patch = this->Area;
  const int vertices = patch.vertexCount(), triangles = patch.triangleCount();
  this->Points.resize(vertices);
  this->Places.resize(vertices);
  this->Moves.resize(vertices);
  this->Unsafe.resize(vertices);
  this->Crosses.resize(triangles);
  this->Changes.resize(triangles);
  this->parallel(vertices, [this](int v) { this->want(v); });
  this->parallel(triangles, [this](int t) { this->see(t); });
  this->parallel(triangles, [this](int t) { this->seeFolds(t); });
  this->settle();
  if (this->Caller.cancelled())
  {
    return;
  }
  this->parallel(vertices,
    [&](int v)
    {
      if (this->Moves[v])
      {
        patch.Points[v] = this->Points[v];
        patch.Places[v] = this->Places[v];
        patch.Sizes[v] = patch.sizeAt(this->Places[v]);
      }
    });
}

} // namespace oversketch
