#include "Join/slivers.h"

#include "Mesh/nearest.h"
#include "Mesh/shape.h"

#include <algorithm>
#include <set>
#include <utility>

namespace oversketch
{

namespace
{

class Slivers
{
public:
  Slivers(United& united, double least)
    : Whole(united.body)
    , IsNew(united.isNew)
    , Changed(united.changed)
    , Least(least)
    , Number(united.isNew.size(), -1)
  {
    // Points at triangles with a new point, which are changed ones; all triangles round those are listed.
    std::vector<char> isReached(this->Number.size(), 0);
    for (int f = 0; f < this->Whole.mesh.triangleCount(); ++f)
    {
      const Triangle& t = this->triangle(f);
      if (this->Changed[f] && (this->IsNew[t[0]] || this->IsNew[t[1]] || this->IsNew[t[2]]))
      {
        isReached[t[0]] = isReached[t[1]] = isReached[t[2]] = 1;
      }
    }
    this->Reached = marked(isReached);
    this->Number = placesIn(this->Reached, this->Number.size());
    this->Around.resize(this->Reached.size());
    for (int f = 0; f < this->Whole.mesh.triangleCount(); ++f)
    {
      this->list(f);
    }
  }

  void remove()
  {
    bool any = true;
    while (any)
    {
      any = this->mergeAll();
      any |= this->flipAll();
    }
  }

  // See coarsenCrease.
  void coarsen(const std::vector<double>& lengths)
  {
    for (const int v : this->Reached)
    {
      if (this->Number[v] < 0 || !this->IsNew[v])
      {
        continue;
      }
      const std::vector<int> along = this->creaseNeighbours(v);
      int nearest = -1; // where the line goes straight on through the vertex
      for (const int n : along)
      {
        nearest = nearest < 0 || this->length(v, n) < this->length(v, nearest) ? n : nearest;
      }
      if (along.size() == 2 && this->IsNew[nearest] && this->length(v, nearest) < 0.5 * lengths[v] &&
          this->staysSound(v, nearest))
      {
        this->merge(v, nearest);
      }
    }
  }

private:
  double length(int a, int b) const { return (this->at(a) - this->at(b)).norm(); }

  // The ends of edges at a point that have triangles of two parts.
  std::vector<int> creaseNeighbours(int v)
  {
    std::vector<int> ends;
    for (const int f : this->around(v))
    {
      const int n = this->triangle(f)[(cornerOf(this->triangle(f), v) + 1) % 3];
      for (const int g : this->around(v))
      {
        if (runsAlong(this->triangle(g), n, v) && this->Whole.part[f] != this->Whole.part[g])
        {
          ends.push_back(n);
        }
      }
    }
    return ends;
  }

  // Tells whether triangles at a point look the same way and stay open when it goes to another one.
  bool staysSound(int v, int to)
  {
    for (const int f : this->around(v))
    {
      const Triangle& t = this->triangle(f);
      if (cornerOf(t, to) >= 0)
      {
        continue;
      }
      const int k = cornerOf(t, v);
      const Vector3 &a = this->at(t[(k + 1) % 3]), &b = this->at(t[(k + 2) % 3]);
      const Vector3 before = (a - this->at(v)).cross(b - this->at(v)),
                    after = (a - this->at(to)).cross(b - this->at(to));
      if (before.dot(after) <= 0.5 * before.norm() * after.norm() || narrowness(this->at(to), a, b) < 1e-3)
      {
        return false;
      }
    }
    return true;
  }

  void list(int f)
  {
    for (const int v : this->Whole.mesh.triangles[f])
    {
      if (this->Number[v] >= 0)
      {
        this->Around[this->Number[v]].push_back(f);
      }
    }
  }
  std::vector<int>& around(int v) { return this->Around[this->Number[v]]; }
  const Vector3& at(int v) const { return this->Whole.mesh.points[v]; }
  Triangle& triangle(int f) { return this->Whole.mesh.triangles[f]; }

  std::vector<int> neighbours(int v)
  {
    std::vector<int> all;
    for (const int f : this->around(v))
    {
      for (const int n : this->triangle(f))
      {
        if (n != v)
        {
          all.push_back(n);
        }
      }
    }
    sortUnique(all);
    return all;
  }

  bool mergeAll()
  {
    bool any = false;
    for (const int v : this->Reached)
    {
      bool again = this->Number[v] >= 0 && this->hasShortEdge(v);
      while (again)
      {
        again = false;
        for (const int n : this->Number[v] >= 0 ? this->neighbours(v) : std::vector<int>())
        {
          // The new one goes; of two that are none the later one.
          if (this->Number[n] >= 0 && (this->at(v) - this->at(n)).norm() < this->Least &&
              (this->IsNew[v] > this->IsNew[n] || (this->IsNew[v] == this->IsNew[n] && v > n)) &&
              this->merge(v, n))
          {
            any = again = true;
            break;
          }
        }
      }
    }
    return any;
  }

  bool hasShortEdge(int v)
  {
    const std::vector<int>& faces = this->around(v);
    return std::any_of(faces.begin(),
      faces.end(),
      [&](int f)
      {
        const int next = this->triangle(f)[(cornerOf(this->triangle(f), v) + 1) % 3];
        return (this->at(next) - this->at(v)).squaredNorm() < this->Least * this->Least;
      });
  }

  // Merges a point into a neighbour; false where that would not leave a surface.
  bool merge(int v, int into)
  {
    std::vector<int> common;
    const std::vector<int> a = this->neighbours(v), b = this->neighbours(into);
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
    if (common.size() != 2 || a.size() + b.size() <= 6)
    {
      return false;
    }
    const std::vector<int> faces = this->around(v);
    for (const int f : faces)
    {
      Triangle& t = this->triangle(f);
      if (cornerOf(t, into) >= 0)
      {
        this->drop(f);
        continue;
      }
      t[cornerOf(t, v)] = into;
      this->Changed[f] = 1;
      this->around(into).push_back(f);
    }
    this->around(v).clear();
    this->Number[v] = -1;
    return true;
  }

  void drop(int f)
  {
    for (const int v : this->triangle(f))
    {
      this->unlist(v, f);
    }
    this->triangle(f) = { -1, -1, -1 };
  }
  void unlist(int v, int f)
  {
    if (this->Number[v] >= 0)
    {
      std::vector<int>& faces = this->around(v);
      faces.erase(std::find(faces.begin(), faces.end(), f));
    }
  }

  bool flipAll()
  {
    bool any = false;
    for (const int v : this->Reached)
    {
      const std::vector<int> faces = this->Number[v] >= 0 ? this->around(v) : std::vector<int>();
      for (const int f : faces)
      {
        any |= this->isFirstOf(v, f) && this->flip(f);
      }
    }
    return any;
  }

  // Tells whether a point is the first of a triangle's that has a list.
  bool isFirstOf(int v, int f)
  {
    const Triangle& t = this->triangle(f);
    return cornerOf(t, v) >= 0 &&
           std::all_of(t.begin(), t.end(), [&](int n) { return n >= v || this->Number[n] < 0; });
  }

  // Flips a low triangle's longest edge, which then goes through its third corner. An edge that has gone does
  // not come back, so that low neighbours do not flip to and fro.
  bool flip(int f)
  {
    const Triangle t = this->triangle(f);
    int k = 0; // the edge after corner k
    const auto length = [&](int i) { return (this->at(t[(i + 1) % 3]) - this->at(t[i])).squaredNorm(); };
    for (const int i : { 1, 2 })
    {
      k = length(i) > length(k) ? i : k;
    }
    const int a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
    const Vector3 along = this->at(b) - this->at(a), way = this->at(c) - this->at(a);
    const double share = nearestShare(way, along);
    if (this->Number[a] < 0 || this->Number[b] < 0 || this->Number[c] < 0 || share <= 0.0 || share >= 1.0 ||
        (way - share * along).norm() >= this->Least)
    {
      return false;
    }
    int other = -1;
    for (const int g : this->around(a))
    {
      other = g != f && runsAlong(this->triangle(g), b, a) ? g : other;
    }
    if (other < 0)
    {
      return false;
    }
    const Triangle beyond = this->triangle(other);
    const int atB = cornerOf(beyond, b), atA = (atB + 1) % 3, atD = (atB + 2) % 3, d = beyond[atD];
    const std::vector<int> near = this->neighbours(c);
    if (d == c || std::binary_search(near.begin(), near.end(), d) || this->Gone.count(std::minmax(c, d)) > 0)
    {
      return false;
    }
    this->Gone.insert(std::minmax(a, b));
    // Both lie on what the other triangle does.
    const CornerWeights w = this->Whole.weightsOf(other);
    const Vector3 middle = (1.0 - share) * w[atA] + share * w[atB];
    this->Changed[f] = this->Changed[other] = 1;
    this->triangle(f) = { a, d, c };
    this->triangle(other) = { d, b, c };
    this->Whole.source[f] = this->Whole.source[other];
    this->Whole.part[f] = this->Whole.part[other];
    this->Whole.setWeights(f, { w[atA], w[atD], middle });
    this->Whole.setWeights(other, { w[atD], w[atB], middle });
    this->unlist(b, f);
    this->unlist(a, other);
    this->around(c).push_back(other);
    if (this->Number[d] >= 0)
    {
      this->around(d).push_back(f);
    }
    return true;
  }

  Body& Whole;
  const std::vector<char>& IsNew;
  std::vector<char>& Changed;
  const double Least;
  std::vector<int> Reached; // points that had a list, ascending
  std::vector<int> Number;  // of a point's list in Around; -1: it has none
  std::vector<std::vector<int>> Around;
  std::set<std::pair<int, int>> Gone; // edges, the lower end first
};

void leaveOutUnused(United& united)
{
  Body& body = united.body;
  auto& triangles = body.mesh.triangles;
  std::size_t kept = 0;
  for (std::size_t f = 0; f < triangles.size(); ++f)
  {
    if (triangles[f][0] >= 0)
    {
      triangles[kept] = triangles[f];
      united.changed[kept] = united.changed[f];
      body.source[kept] = body.source[f];
      body.part[kept] = body.part[f];
      body.cut[kept++] = body.cut[f];
    }
  }
  triangles.resize(kept);
  united.changed.resize(kept);
  body.source.resize(kept);
  body.part.resize(kept);
  body.cut.resize(kept);
  std::vector<char> used(body.mesh.points.size(), 0);
  for (const Triangle& t : triangles)
  {
    used[t[0]] = used[t[1]] = used[t[2]] = 1;
  }
  const std::vector<int> ids = marked(used), places = placesIn(ids, used.size());
  for (Triangle& t : triangles)
  {
    t = { places[t[0]], places[t[1]], places[t[2]] };
  }
  body.mesh.points = valuesAt(body.mesh.points, ids);
  united.isNew = valuesAt(united.isNew, ids);
}

} // namespace

void removeSlivers(United& united, double least)
{
  Slivers(united, least).remove();
  leaveOutUnused(united);
}

void coarsenCrease(United& united, const std::vector<double>& lengths)
{
  Slivers(united, 0.0).coarsen(lengths);
  leaveOutUnused(united);
}

} // namespace oversketch
