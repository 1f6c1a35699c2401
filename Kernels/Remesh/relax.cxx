#include "Remesh/relax.h"

#include "Remesh/shape.h"

namespace oversketch
{

namespace
{

constexpr double moveNarrowest = 0.25; // sine squared of 30 degrees, as for a flip
constexpr double moveDeviation = 0.1;  // how far a vertex may leave the surface behind, in target lengths
constexpr double smallestMove = 0.01;  // not worth the tests, in target lengths
constexpr int checkEvery = 1024;       // vertices or triangles between two looks at whether to stop

} // namespace

template <typename Body>
void Relaxation::parallel(int count, const Body& body) const
{
  this->context_.parallelFor(count,
    [this, &body](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        if (i % checkEvery == 0 && this->context_.cancelled())
        {
          return;
        }
        body(i);
      }
    });
}

// Calls visit(spoke) for the half-edges out of a free vertex.
template <typename Visit>
void Relaxation::eachSpoke(int v, Visit&& visit) const
{
  const int first = this->patch_.out_[v];
  int h = first;
  do
  {
    visit(h);
    h = this->patch_.twin_[previousHalfEdge(h)];
  } while (h != first);
}

// Towards the mean of its neighbours. Weighing by area evens out areas, but is slower to even out angles, and
// no better on graded ground, where triangles in order have their target area anyway.
void Relaxation::want(int v)
{
  const Patch& patch = this->patch_;
  const Vector3 old = patch.points_[v];
  this->points_[v] = old;
  this->moves_[v] = 0;
  if (!patch.aliveVertex(v) || patch.fixed(v))
  {
    return;
  }
  // Cross products about the origin moved to `old` add up to twice the area vector of the fan.
  const Vector3 first = patch.points_[patch.target(patch.out_[v])] - old;
  Vector3 sum = Vector3::Zero(), normal = Vector3::Zero(), last = first;
  int count = 0;
  this->eachSpoke(v,
    [&](int h)
    {
      const Vector3 spoke = patch.points_[patch.target(h)] - old;
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
  this->places_[v] = patch.surface_.closest(old + step, patch.places_[v].triangle);
  const Vector3 wanted = positionOf(patch.surface_.mesh(), this->places_[v]);
  const double least = smallestMove * patch.sizes_[v];
  if ((wanted - old).squaredNorm() >= least * least)
  {
    this->points_[v] = wanted;
    this->moves_[v] = 1;
  }
}

bool Relaxation::changes(int t) const
{
  const int* corners = this->patch_.origin_.data() + 3 * t;
  return this->moves_[corners[0]] || this->moves_[corners[1]] || this->moves_[corners[2]];
}

void Relaxation::see(int t)
{
  const Patch& patch = this->patch_;
  if (!patch.aliveTriangle(t))
  {
    return;
  }
  const Triangle c = patch.triangle(t);
  const Vector3 &a = this->points_[c[0]], &b = this->points_[c[1]], &d = this->points_[c[2]];
  this->crosses_[t] = patch.cross(a, b, d);
  if (this->changes(t))
  {
    const Vector3 &a0 = patch.points_[c[0]], &b0 = patch.points_[c[1]], &d0 = patch.points_[c[2]];
    const Vector3 before = patch.cross(a0, b0, d0);
    this->changes_[t] = { static_cast<float>(narrowness(a, b, d, this->crosses_[t])),
      static_cast<float>(narrowness(a0, b0, d0, before)),
      turned(before, this->crosses_[t]),
      false };
  }
}

void Relaxation::seeFolds(int t)
{
  if (!this->patch_.aliveTriangle(t) || !this->changes(t))
  {
    return;
  }
  const Vector3& own = this->crosses_[t];
  bool sharp = false;
  for (int h = 3 * t; h < 3 * t + 3; ++h)
  {
    const int twin = this->patch_.twin_[h];
    sharp =
      sharp || (twin >= 0 ? own.dot(this->crosses_[twin / 3]) < 0.0 : this->patch_.foldsOver(h, own) > 0);
  }
  this->changes_[t].folded = sharp;
}

// How sharply the edges are folded at v and opposite.
int Relaxation::foldsAround(int v, const std::vector<Vector3>& at) const
{
  const Patch& patch = this->patch_;
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
      const int rim = patch.twin_[nextHalfEdge(h)];
      folds += foldWeight(own, crossOf(patch.twin_[h])) +
               (rim >= 0 ? foldWeight(own, crossOf(rim)) : patch.foldsOver(nextHalfEdge(h), own));
    });
  return folds;
}

bool Relaxation::safe(int v) const
{
  const Patch& patch = this->patch_;
  float narrowest = 1.0F, narrowestBefore = 1.0F;
  bool good = true, folded = false;
  this->eachSpoke(v,
    [&](int h)
    {
      const Change& change = this->changes_[h / 3];
      narrowest = std::min(narrowest, change.narrowest);
      narrowestBefore = std::min(narrowestBefore, change.narrowestBefore);
      good = good && !change.turned;
      folded = folded || change.folded;
    });
  if (!good || narrowest < std::min(narrowestBefore, static_cast<float>(moveNarrowest)))
  {
    return false;
  }
  const Vector3& old = patch.points_[v];
  const double deviation = moveDeviation * patch.sizes_[v] * moveDeviation * patch.sizes_[v];
  bool near = (this->points_[v] - old).squaredNorm() <= deviation;
  if (!near)
  {
    this->eachSpoke(v,
      [&](int h)
      {
        const Triangle c = patch.triangle(h / 3);
        near = near || squaredDistance(this->points_[c[0]], this->points_[c[1]], this->points_[c[2]], old) <=
                         deviation;
      });
  }
  return near && (!folded || this->foldsAround(v, this->points_) <= this->foldsAround(v, patch.points_));
}

// Takes back moves until all that are left are safe: taking back one may spoil those around it.
void Relaxation::settle()
{
  const int count = this->patch_.vertexCount();
  this->parallel(count, [this](int v) { this->unsafe_[v] = this->moves_[v] && !this->safe(v) ? 1 : 0; });
  std::vector<int> back, triangles, around;
  for (int v = 0; v < count; ++v)
  {
    if (this->unsafe_[v])
    {
      back.push_back(v);
    }
  }
  const auto unique = [](std::vector<int>& ids)
  {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  while (!back.empty() && !this->context_.cancelled())
  {
    triangles.clear();
    around.clear();
    for (const int v : back)
    {
      this->moves_[v] = 0;
      this->points_[v] = this->patch_.points_[v];
      this->eachSpoke(v, [&](int h) { triangles.push_back(h / 3); });
    }
    unique(triangles);
    const std::size_t changed = triangles.size();
    for (std::size_t i = 0; i < changed; ++i)
    {
      this->see(triangles[i]);
      for (int h = 3 * triangles[i]; h < 3 * triangles[i] + 3; ++h)
      {
        const int twin = this->patch_.twin_[h];
        if (twin >= 0)
        {
          triangles.push_back(twin / 3); // sees another fold now
        }
      }
    }
    unique(triangles);
    for (const int t : triangles)
    {
      this->seeFolds(t);
      const Triangle c = this->patch_.triangle(t);
      around.insert(around.end(), c.begin(), c.end());
    }
    unique(around);
    back.clear();
    for (const int v : around)
    {
      if (this->moves_[v] && !this->safe(v))
      {
        back.push_back(v);
      }
    }
  }
}

void Relaxation::run()
{
  Patch& patch = this->patch_;
  const int vertices = patch.vertexCount(), triangles = patch.triangleCount();
  this->points_.resize(vertices);
  this->places_.resize(vertices);
  this->moves_.resize(vertices);
  this->unsafe_.resize(vertices);
  this->crosses_.resize(triangles);
  this->changes_.resize(triangles);
  this->parallel(vertices, [this](int v) { this->want(v); });
  this->parallel(triangles, [this](int t) { this->see(t); });
  this->parallel(triangles, [this](int t) { this->seeFolds(t); });
  this->settle();
  if (this->context_.cancelled())
  {
    return;
  }
  this->parallel(vertices,
    [&](int v)
    {
      if (this->moves_[v])
      {
        patch.points_[v] = this->points_[v];
        patch.places_[v] = this->places_[v];
        patch.sizes_[v] = patch.sizeAt(this->places_[v]);
      }
    });
}

} // namespace oversketch
