#include "Stellar/clusters.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"
#include "Stellar/defects.h"
#include "Stellar/quality.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace oversketch
{

namespace
{

const double featureCosine = std::sqrt(0.5); // 45 degrees
constexpr double straightCosine = 0.996;     // 5 degrees: a boundary that turns by less is straight
const double leastNarrowness = squaredSine(15.0);

struct Ring
{
  std::vector<int> link, faces; // counter-clockwise; face i holds link i and the next
  bool closed = false;
  int size() const { return static_cast<int>(this->faces.size()); }
};

Vector3 normalOf(const std::vector<Vector3>& points, const Triangle& t)
{
  return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
}

double narrownessOf(const std::vector<Vector3>& points, const Triangle& t)
{
  return narrowness(points[t[0]], points[t[1]], points[t[2]]);
}

double flatArea(const Vector2& a, const Vector2& b, const Vector2& c)
{
  return (b - a)[0] * (c - a)[1] - (b - a)[1] * (c - a)[0];
}

class ClusterSimplifier
{
public:
  ClusterSimplifier(const Mesh& mesh, const ClusterOptions& options)
    : Options(options)
    , FaceCount(mesh.triangleCount())
    , Fixed(mesh.points.size(), 0)
    , Locked(mesh.points.size(), 0)
    , Around(mesh.points.size())
    , Quadrics(mesh.points.size(), Eigen::Matrix4d::Zero())
    , Middle(Vector3::Zero())
  {
    this->Result.original = Parametrisation(mesh);
    for (const Vector3& p : mesh.points)
    {
      this->Middle += p / mesh.vertexCount();
    }
    for (int f = 0; f < mesh.triangleCount(); ++f)
    {
      const Triangle& t = mesh.triangles[f];
      const Vector3 normal = normalOf(mesh.points, t);
      const double area = normal.norm();
      Eigen::Vector4d plane;
      plane << normal / area, -normal.dot(mesh.points[t[0]] - this->Middle) / area;
      for (int v : t)
      {
        this->Around[v].push_back(f);
        this->Quadrics[v] += area * plane * plane.transpose();
      }
    }
    const Adjacency adjacency = buildAdjacency(mesh);
    for (std::size_t e = 0; e < adjacency.edges.size(); ++e)
    {
      const MeshEdge& edge = adjacency.edges[e];
      const int* t = adjacency.trianglesBegin(static_cast<int>(e));
      if (edge.triangleCount == 2 && facetNormal(mesh, t[0]).dot(facetNormal(mesh, t[1])) < featureCosine)
      {
        this->Fixed[edge.v0] = this->Fixed[edge.v1] = 1;
      }
    }
  }

  ClusterResult run(const Context& context)
  {
    const int start = this->FaceCount,
              target = this->Options.targetFaces > 0 ? this->Options.targetFaces : start / 4;
    for (bool more = true; more && this->FaceCount > target;)
    {
      more = false;
      this->Locked = this->Fixed;
      for (int w : this->queue())
      {
        if (this->FaceCount <= target)
        {
          break;
        }
        more = (!this->Locked[w] && this->remove(w)) || more;
      }
      this->Result.levels += more;
      context.checkpoint(std::min(1.0, double(start - this->FaceCount) / std::max(1, start - target)));
    }
    this->finish();
    return std::move(this->Result);
  }

private:
  const std::vector<Vector3>& points() const { return this->Result.original.points; }

  // Vertices that may go, those first that change the surface least.
  std::vector<int> queue() const
  {
    std::vector<std::pair<double, int>> order;
    for (int v = 0; v < static_cast<int>(this->Around.size()); ++v)
    {
      if (this->Around[v].empty() || this->Fixed[v])
      {
        continue;
      }
      double least = std::numeric_limits<double>::infinity();
      for (int f : this->Around[v])
      {
        for (int u : this->Result.original.faces[f])
        {
          const Eigen::Vector4d x = (this->points()[u] - this->Middle).homogeneous();
          least = u == v ? least : std::min(least, x.dot(this->Quadrics[v] * x));
        }
      }
      order.emplace_back(least, v);
    }
    std::sort(order.begin(), order.end());
    std::vector<int> vertices;
    vertices.reserve(order.size());
    for (const auto& entry : order)
    {
      vertices.push_back(entry.second);
    }
    return vertices;
  }

  Ring ring(int w) const
  {
    struct Step
    {
      int from, to, face;
    };
    std::vector<Step> steps;
    for (int f : this->Around[w])
    {
      const Triangle& t = this->Result.original.faces[f];
      const int i = cornerOf(t, w);
      steps.push_back({ t[(i + 1) % 3], t[(i + 2) % 3], f });
    }
    Ring ring;
    const auto startsAt = [&](int v)
    { return std::find_if(steps.begin(), steps.end(), [&](const Step& s) { return s.from == v; }); };
    auto at = steps.begin();
    for (auto s = steps.begin(); s != steps.end(); ++s)
    {
      if (std::none_of(steps.begin(), steps.end(), [&](const Step& other) { return other.to == s->from; }))
      {
        at = s;
      }
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
    {
      ring.link.push_back(at->from);
      ring.faces.push_back(at->face);
      const int to = at->to;
      at = startsAt(to);
      if (at == steps.end())
      {
        ring.link.push_back(to);
        break;
      }
    }
    ring.closed = ring.link.size() == ring.faces.size();
    return ring;
  }

  bool hasEdge(int a, int b) const
  {
    return std::any_of(this->Around[a].begin(),
      this->Around[a].end(),
      [&](int f) { return cornerOf(this->Result.original.faces[f], b) >= 0; });
  }

  // Whether no new face turns away from an old one.
  bool keepsSides(const std::vector<Triangle>& made, const std::vector<int>& old) const
  {
    for (const Triangle& t : made)
    {
      const Vector3 n = normalOf(this->points(), t);
      for (int f : old)
      {
        if (!(n.dot(normalOf(this->points(), this->Result.original.faces[f])) > 0.0))
        {
          return false;
        }
      }
    }
    return true;
  }

  // Whether no new face is narrower than what is allowed, or than the narrowest of the old ones.
  bool keepsAngles(const std::vector<Triangle>& made, const std::vector<int>& old) const
  {
    double allowed = leastNarrowness;
    for (int f : old)
    {
      allowed = std::min(allowed, narrownessOf(this->points(), this->Result.original.faces[f]));
    }
    return std::all_of(made.begin(),
      made.end(),
      [&](const Triangle& t) { return narrownessOf(this->points(), t) >= allowed; });
  }

  void replace(const std::vector<int>& old,
    const std::vector<std::pair<int, Vector2>>& flat,
    const std::vector<Triangle>& made,
    int removed)
  {
    for (int f : old)
    {
      for (int v : this->Result.original.faces[f])
      {
        std::vector<int>& list = this->Around[v];
        list.erase(std::find(list.begin(), list.end(), f));
      }
    }
    int f = this->Result.original.add(old, flat, made, removed);
    for (const Triangle& t : made)
    {
      for (int v : t)
      {
        this->Around[v].push_back(f);
      }
      ++f;
    }
    this->FaceCount += static_cast<int>(made.size()) - static_cast<int>(old.size());
  }

  // Takes one face out of a star by the flip of an edge there that leaves the best angles.
  bool flipOne(int w, const Ring& ring)
  {
    const int n = static_cast<int>(ring.link.size());
    double best = 0.0;
    std::vector<int> old;
    std::vector<std::pair<int, Vector2>> flat;
    std::vector<Triangle> made;
    for (int i = ring.closed ? 0 : 1; i < (ring.closed ? n : n - 1); ++i)
    {
      const int v = ring.link[i], before = ring.link[(i + n - 1) % n], after = ring.link[(i + 1) % n];
      const std::vector<Triangle> faces{ { w, before, after }, { before, v, after } };
      const std::vector<int> two{ ring.faces[(i + ring.size() - 1) % ring.size()], ring.faces[i] };
      const double narrowest =
        std::min(narrownessOf(this->points(), faces[0]), narrownessOf(this->points(), faces[1]));
      if (narrowest <= best || this->Around[v].size() < 4 || this->hasEdge(before, after) ||
          !this->keepsSides(faces, two) || !this->keepsAngles(faces, two))
      {
        continue;
      }
      // The two laid flat, hinged at the edge from w to v.
      const Vector3 &at = this->points()[w], along = this->points()[v] - at;
      const double length = along.norm();
      const auto unfold = [&](int u, double side)
      {
        const Vector3 d = this->points()[u] - at;
        return Vector2(d.dot(along) / length, side * d.cross(along).norm() / length);
      };
      const std::vector<std::pair<int, Vector2>> laid{ { w, Vector2::Zero() },
        { v, Vector2(length, 0.0) },
        { before, unfold(before, -1.0) },
        { after, unfold(after, 1.0) } };
      const double least = 1e-6 * length * length;
      if (flatArea(laid[0].second, laid[2].second, laid[3].second) > least &&
          flatArea(laid[2].second, laid[1].second, laid[3].second) > least)
      {
        best = narrowest;
        old = two;
        flat = laid;
        made = faces;
      }
    }
    if (made.empty())
    {
      return false;
    }
    this->replace(old, flat, made, -1);
    ++this->Result.flips;
    return true;
  }

  // A star laid flat: angles stretched to the whole, lengths to the same power.
  std::vector<std::pair<int, Vector2>> flatStar(int w, const Ring& ring) const
  {
    std::vector<double> angles{ 0.0 };
    for (int i = 0; i < ring.size(); ++i)
    {
      const Vector3 x = this->points()[ring.link[i]] - this->points()[w],
                    y = this->points()[ring.link[(i + 1) % ring.link.size()]] - this->points()[w];
      angles.push_back(angles.back() + std::atan2(x.cross(y).norm(), x.dot(y)));
    }
    const double power = (ring.closed ? 2.0 : 1.0) * std::acos(-1.0) / angles.back();
    std::vector<std::pair<int, Vector2>> flat{ { w, Vector2::Zero() } };
    for (std::size_t i = 0; i < ring.link.size(); ++i)
    {
      const double r = std::pow((this->points()[ring.link[i]] - this->points()[w]).norm(), power);
      flat.emplace_back(ring.link[i], r * Vector2(std::cos(power * angles[i]), std::sin(power * angles[i])));
    }
    return flat;
  }

  // Whether new faces may take a star's place; if so, how far the vertex is from them, else infinite.
  double errorOf(int w,
    const Ring& ring,
    const std::vector<std::pair<int, Vector2>>& flat,
    const std::vector<Triangle>& made) const
  {
    const auto at = [&](int v)
    { return std::find_if(flat.begin(), flat.end(), [&](const auto& f) { return f.first == v; })->second; };
    double size = 0.0, error = std::numeric_limits<double>::infinity();
    for (const auto& f : flat)
    {
      size = std::max(size, f.second.squaredNorm());
    }
    for (const Triangle& t : made)
    {
      if (!(flatArea(at(t[0]), at(t[1]), at(t[2])) > 1e-6 * size))
      {
        return std::numeric_limits<double>::infinity();
      }
      error = std::min(error,
        std::sqrt(squaredDistance(
          this->points()[t[0]], this->points()[t[1]], this->points()[t[2]], this->points()[w])));
    }
    const bool sound = this->keepsSides(made, ring.faces) && this->keepsAngles(made, ring.faces);
    return sound ? error : std::numeric_limits<double>::infinity();
  }

  bool isStraight(int w, const Ring& ring) const
  {
    const Vector3 x = this->points()[w] - this->points()[ring.link.front()],
                  y = this->points()[ring.link.back()] - this->points()[w];
    return x.dot(y) > straightCosine * x.norm() * y.norm();
  }

  bool remove(int w)
  {
    Ring ring = this->ring(w);
    if (!ring.closed && (ring.size() < 2 || !this->isStraight(w, ring)))
    {
      return false;
    }
    while (ring.size() > (ring.closed ? 4 : 2))
    {
      if (!this->flipOne(w, ring))
      {
        return false;
      }
      ring = this->ring(w);
    }
    const std::vector<int>& v = ring.link;
    const std::vector<std::pair<int, Vector2>> flat = this->flatStar(w, ring);
    // Faces that may come in its place; a new edge must not be there already, nor the one face of a
    // tetrahedron.
    std::vector<std::vector<Triangle>> choices;
    const auto offer = [&](int a, int b, const std::vector<Triangle>& made)
    {
      if (!this->hasEdge(a, b))
      {
        choices.push_back(made);
      }
    };
    if (ring.closed && ring.size() == 4)
    {
      offer(v[0], v[2], { { v[0], v[1], v[2] }, { v[0], v[2], v[3] } });
      offer(v[1], v[3], { { v[1], v[2], v[3] }, { v[1], v[3], v[0] } });
    }
    else if (!ring.closed)
    {
      offer(v[0], v[2], { { v[0], v[1], v[2] } });
    }
    else if (ring.size() == 3 && this->Around[v[0]].size() > 3)
    {
      choices.push_back({ { v[0], v[1], v[2] } });
    }
    double least =
      this->Options.maximumError > 0.0 ? this->Options.maximumError : std::numeric_limits<double>::max();
    const std::vector<Triangle>* best = nullptr;
    for (const std::vector<Triangle>& made : choices)
    {
      const double error = this->errorOf(w, ring, flat, made);
      if (error < least)
      {
        least = error;
        best = &made;
      }
    }
    if (!best)
    {
      return false;
    }
    this->replace(ring.faces, flat, *best, w);
    ++this->Result.removed;
    for (int u : v)
    {
      this->Locked[u] = 1;
      this->Quadrics[u] += this->Quadrics[w] / static_cast<double>(v.size());
    }
    return true;
  }

  void finish()
  {
    const Parametrisation& all = this->Result.original;
    std::vector<int> id(all.points.size(), -1);
    for (std::size_t v = 0; v < all.points.size(); ++v)
    {
      if (all.removedBy[v] < 0)
      {
        id[v] = this->Result.mesh.vertexCount();
        this->Result.mesh.points.push_back(all.points[v]);
        this->Result.pointFrom.push_back(static_cast<int>(v));
      }
    }
    for (std::size_t f = 0; f < all.faces.size(); ++f)
    {
      if (all.goneBy[f] < 0)
      {
        const Triangle& t = all.faces[f];
        this->Result.mesh.triangles.push_back({ id[t[0]], id[t[1]], id[t[2]] });
        this->Result.faceFrom.push_back(static_cast<int>(f));
      }
    }
  }

  const ClusterOptions Options;
  ClusterResult Result;
  int FaceCount;
  std::vector<char> Fixed, Locked; // for ever; for this level
  std::vector<std::vector<int>> Around;
  std::vector<Eigen::Matrix4d> Quadrics; // about the middle, where numbers are small
  Vector3 Middle;
};

} // namespace

ClusterResult simplifyByClusters(const Mesh& mesh, const ClusterOptions& options, const Context& context)
{
  checkManifold(mesh);
  return ClusterSimplifier(mesh, options).run(context);
}

} // namespace oversketch
