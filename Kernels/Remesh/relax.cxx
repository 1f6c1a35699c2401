// Tangential relaxation: all vertices at once, and back where that is unsafe.
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

// One relaxation in progress. Every step writes to the vertices or triangles that it names only, so the
// result does not depend on the number of threads.
struct Patch::Relaxation
{
  struct Face
  {
    Vector3 cross;
    double narrowest;
  };

  const Patch& patch;
  const Context& context;
  std::vector<Face> before, after;
  std::vector<Vector3> points; // the new ones
  std::vector<SurfacePoint> places;
  std::vector<char> moves;

  Relaxation(const Patch& of, const Context& with)
    : patch(of)
    , context(with)
    , before(of.triangleCount())
    , after(of.triangleCount())
    , points(of.vertexCount())
    , places(of.vertexCount())
    , moves(of.vertexCount(), 0)
  {
  }

  template <typename Body>
  void parallel(int count, const Body& body) const
  {
    this->context.parallelFor(count,
      [this, &body](int begin, int end)
      {
        for (int i = begin; i < end; ++i)
        {
          if (i % checkEvery == 0 && this->context.cancelled())
          {
            return;
          }
          body(i);
        }
      });
  }

  Face faceOf(int t, const std::vector<Vector3>& at) const
  {
    const Vector3 &a = at[this->patch.origin(3 * t)], &b = at[this->patch.origin(3 * t + 1)],
                  &c = at[this->patch.origin(3 * t + 2)];
    const Vector3 cross = this->patch.cross(a, b, c);
    return { cross, narrowness(a, b, c, cross) };
  }

  // Calls visit(spoke) for the half-edges out of a free vertex.
  template <typename Visit>
  void eachSpoke(int v, Visit&& visit) const
  {
    int h = this->patch.out_[v];
    do
    {
      visit(h);
      h = this->patch.twin_[previousHalfEdge(h)];
    } while (h != this->patch.out_[v]);
  }

  // Towards the mean of its neighbours. Weighing by area evens out areas, but is slower to even out angles,
  // and no better on graded ground, where triangles in order have their target area anyway.
  void want(int v)
  {
    const Patch& p = this->patch;
    const Vector3 old = p.points_[v];
    this->points[v] = old;
    if (!p.aliveVertex(v) || p.fixed(v))
    {
      return;
    }
    Vector3 sum = Vector3::Zero(), normal = Vector3::Zero();
    int count = 0;
    this->eachSpoke(v,
      [&](int h)
      {
        sum += p.points_[p.target(h)];
        normal += this->before[h / 3].cross;
        ++count;
      });
    const double length = normal.norm();
    if (!(length > 0.0))
    {
      return;
    }
    normal /= length;
    Vector3 step = sum / count - old;
    step -= normal * normal.dot(step);
    this->places[v] = p.surface_.closest(old + step, p.places_[v].triangle);
    const Vector3 wanted = positionOf(p.surface_.mesh(), this->places[v]);
    const double least = smallestMove * p.sizes_[v];
    if ((wanted - old).squaredNorm() >= least * least)
    {
      this->points[v] = wanted;
      this->moves[v] = 1;
    }
  }

  void see(int t)
  {
    const Patch& p = this->patch;
    const bool changed =
      p.aliveTriangle(t) &&
      (this->moves[p.origin(3 * t)] || this->moves[p.origin(3 * t + 1)] || this->moves[p.origin(3 * t + 2)]);
    this->after[t] = changed ? this->faceOf(t, this->points) : this->before[t];
  }

  int foldsAround(int v, const std::vector<Face>& faces) const
  {
    int folds = 0;
    this->eachSpoke(v,
      [&](int h)
      {
        const Vector3& own = faces[h / 3].cross;
        const int rim = this->patch.twin_[nextHalfEdge(h)];
        folds +=
          foldWeight(own, faces[this->patch.twin_[h] / 3].cross) +
          (rim >= 0 ? foldWeight(own, faces[rim / 3].cross) : this->patch.foldsOver(nextHalfEdge(h), own));
      });
    return folds;
  }

  bool safe(int v) const
  {
    const Patch& p = this->patch;
    double narrowest = std::numeric_limits<double>::infinity(), narrowestBefore = narrowest;
    bool good = true;
    const Vector3& old = p.points_[v];
    const double deviation = moveDeviation * p.sizes_[v];
    bool near = (this->points[v] - old).squaredNorm() <= deviation * deviation;
    this->eachSpoke(v,
      [&](int h)
      {
        const Face &was = this->before[h / 3], &is = this->after[h / 3];
        narrowest = std::min(narrowest, is.narrowest);
        narrowestBefore = std::min(narrowestBefore, was.narrowest);
        good = good && !turned(was.cross, is.cross);
        near = near || squaredDistance(this->points[v],
                         this->points[p.target(h)],
                         this->points[p.origin(previousHalfEdge(h))],
                         old) <= deviation * deviation;
      });
    if (!good || !near || narrowest < std::min(narrowestBefore, moveNarrowest))
    {
      return false;
    }
    const int folds = this->foldsAround(v, this->after);
    return folds == 0 || folds <= this->foldsAround(v, this->before);
  }

  // Takes back moves until all that are left are safe: taking back one may spoil those around it.
  void settle()
  {
    const int count = this->patch.vertexCount();
    std::vector<char> unsafe(count, 0);
    this->parallel(count, [&](int v) { unsafe[v] = this->moves[v] && !this->safe(v) ? 1 : 0; });
    std::vector<int> back, around;
    for (int v = 0; v < count; ++v)
    {
      if (unsafe[v])
      {
        back.push_back(v);
      }
    }
    while (!back.empty() && !this->context.cancelled())
    {
      around.clear();
      for (const int v : back)
      {
        this->moves[v] = 0;
        this->points[v] = this->patch.points_[v];
      }
      for (const int v : back)
      {
        this->eachSpoke(v,
          [&](int h)
          {
            this->see(h / 3);
            around.push_back(this->patch.target(h));
            const int rim = this->patch.twin_[nextHalfEdge(h)];
            if (rim >= 0)
            {
              around.push_back(this->patch.origin(previousHalfEdge(rim)));
            }
          });
      }
      std::sort(around.begin(), around.end());
      around.erase(std::unique(around.begin(), around.end()), around.end());
      back.clear();
      for (const int v : around)
      {
        if (this->moves[v] && !this->safe(v))
        {
          back.push_back(v);
        }
      }
    }
  }
};

void Patch::relax(const Context& context)
{
  Relaxation now(*this, context);
  const int triangles = this->triangleCount(), vertices = this->vertexCount();
  now.parallel(triangles,
    [&](int t)
    {
      if (this->active_[t])
      {
        now.before[t] = now.faceOf(t, this->points_);
      }
    });
  now.parallel(vertices, [&](int v) { now.want(v); });
  now.parallel(triangles, [&](int t) { now.see(t); });
  now.settle();
  if (context.cancelled())
  {
    return; // half done, and not to be used any more
  }
  now.parallel(vertices,
    [&](int v)
    {
      if (now.moves[v])
      {
        this->points_[v] = now.points[v];
        this->places_[v] = now.places[v];
        this->sizes_[v] = this->sizeAt(now.places[v]);
      }
    });
}

} // namespace oversketch
