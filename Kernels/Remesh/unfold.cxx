#include "Remesh/unfold.h"

#include "Remesh/shape.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <vector>

namespace oversketch
{

namespace
{

constexpr int unfoldingRounds = 20;
constexpr double unfoldedNarrowest = 0.0076; // sine squared of 5 degrees

class Unfolding
{
public:
  Unfolding(Patch& patch, const Context& context)
    : Area(patch)
    , Caller(context)
  {
  }

  void run()
  {
    for (int v = 0; v < this->Area.vertexCount(); ++v)
    {
      this->Points.push_back(this->Area.point(v));
    }
    for (int round = 0; round < unfoldingRounds; ++round)
    {
      const std::vector<int> vertices = this->atFolds();
      this->findFans(vertices);
      bool moved = false;
      for (const int v : vertices)
      {
        this->Caller.checkpoint(1.0);
        moved = this->improve(v) || moved;
      }
      if (!moved)
      {
        break;
      }
    }
    this->Area.moveTo(this->Points);
  }

private:
  Vector3 cross(int t) const
  {
    const Triangle c = this->Area.triangle(t);
    return (this->Points[c[1]] - this->Points[c[0]]).cross(this->Points[c[2]] - this->Points[c[0]]);
  }

  // The corners of all triangles at a folded edge, ascending.
  std::vector<int> atFolds() const
  {
    std::vector<Vector3> normals(this->Area.triangleCount());
    this->Caller.parallelFor(this->Area.triangleCount(),
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          normals[t] = this->Area.aliveTriangle(t) ? this->cross(t) : Vector3::Zero();
        }
      });
    std::vector<int> vertices;
    for (int h = 0; h < 3 * this->Area.triangleCount(); ++h)
    {
      if (this->Area.aliveTriangle(h / 3) && this->Area.inner(h) &&
          folded(normals[h / 3], normals[this->Area.twin(h) / 3]))
      {
        const Triangle c = this->Area.triangle(h / 3);
        vertices.insert(vertices.end(), c.begin(), c.end());
      }
    }
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    return vertices;
  }

  // The triangles of the patch round each.
  void findFans(const std::vector<int>& vertices)
  {
    this->Fans.clear();
    for (const int v : vertices)
    {
      this->Fans[v];
    }
    for (int t = 0; !vertices.empty() && t < this->Area.triangleCount(); ++t)
    {
      for (const int v : this->Area.triangle(t))
      {
        const auto fan = this->Area.aliveTriangle(t) ? this->Fans.find(v) : this->Fans.end();
        if (fan != this->Fans.end())
        {
          fan->second.push_back(t);
        }
      }
    }
  }

  bool isFree(int v) const
  {
    const std::vector<int>& fan = this->Fans.at(v);
    return std::all_of(fan.begin(),
      fan.end(),
      [&](int t)
      {
        bool free = this->Area.chart(t) == this->Area.chart(fan[0]);
        for (int h = 3 * t; h < 3 * t + 3; ++h)
        {
          free = free && (this->Area.inner(h) || (this->Area.origin(h) != v && this->Area.target(h) != v));
        }
        return free;
      });
  }

  struct Fan
  {
    int folds = 0; // weights of all edges of its triangles
    double narrowest = 1.0;
  };
  Fan look(int v) const
  {
    Fan seen;
    for (const int t : this->Fans.at(v))
    {
      const Vector3 own = this->cross(t);
      const Triangle c = this->Area.triangle(t);
      seen.narrowest =
        std::min(seen.narrowest, narrowness(this->Points[c[0]], this->Points[c[1]], this->Points[c[2]], own));
      for (int h = 3 * t; h < 3 * t + 3; ++h)
      {
        seen.folds += this->Area.inner(h) ? foldWeight(own, this->cross(this->Area.twin(h) / 3)) : 0;
      }
    }
    return seen;
  }

  bool improve(int v)
  {
    const Fan before = this->look(v);
    if (before.folds == 0 || !this->isFree(v))
    {
      return false;
    }
    const Vector3 old = this->Points[v];
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (const int t : this->Fans.at(v))
    {
      for (const int corner : this->Area.triangle(t))
      {
        sum += corner == v ? Vector3(Vector3::Zero()) : this->Points[corner];
        count += corner != v;
      }
    }
    for (const double share : { 1.0, 0.5, 0.25 })
    {
      this->Points[v] = old + share * (sum / count - old);
      const Fan after = this->look(v);
      if (after.folds < before.folds && after.narrowest >= std::min(before.narrowest, unfoldedNarrowest))
      {
        return true;
      }
    }
    this->Points[v] = old;
    return false;
  }

  Patch& Area;
  const Context& Caller;
  std::vector<Vector3> Points;
  std::unordered_map<int, std::vector<int>> Fans;
};

} // namespace

void unfold(Patch& patch, const Context& context)
{
  Unfolding(patch, context).run();
}

} // namespace oversketch
