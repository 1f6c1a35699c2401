#include "Stellar/crossed_faces.h"

#include "Mesh/context.h"
#include "Mesh/nearest.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

namespace oversketch
{

namespace
{

// An edge that a curve passes exactly along is touched by both sides.
constexpr double touching = 1e-9;
constexpr int facesPerCheck = 1024; // between two looks at whether to stop

struct Corners
{
  Vector3 p, x, y;                  // a corner, and the other two from there
  Vector3 normal = Vector3::Zero(); // unit, zero without area
  double longest = 0.0, area2 = 0.0;

  Corners(const Forest& forest, int f)
    : Corners(forest.cornerOf(f, 0), forest.cornerOf(f, 1), forest.cornerOf(f, 2))
  {
  }
  Corners(const Vector3& a, const Vector3& b, const Vector3& c)
    : p(a)
    , x(b - a)
    , y(c - a)
  {
    this->longest = std::max({ this->x.norm(), this->y.norm(), (this->x - this->y).norm() });
    this->normal = this->x.cross(this->y);
    this->area2 = this->normal.norm();
    if (this->area2 > 0.0)
    {
      this->normal /= this->area2;
    }
  }

  // The box round what lies above and below the face, as far as the gap.
  Eigen::AlignedBox3d box(double gap) const
  {
    Eigen::AlignedBox3d b(this->p);
    b.extend(Vector3(this->p + this->x)).extend(Vector3(this->p + this->y));
    const Vector3 margin = gap * this->normal.cwiseAbs() + Vector3::Constant(touching * this->longest);
    return { b.min() - margin, b.max() + margin };
  }

  // Weights of the corners at the foot of a point on the plane.
  Vector3 weights(const Vector3& at) const
  {
    const Vector3 d = at - this->p;
    const double b = d.cross(this->y).dot(this->normal) / this->area2,
                 c = this->x.cross(d).dot(this->normal) / this->area2;
    return { 1.0 - b - c, b, c };
  }
};

// Whether a segment meets a face, seen along its normal, and comes as near as `gap` there.
bool meets(const Corners& face, const Vector3& from, const Vector3& to, double gap)
{
  const Vector3 a = face.weights(from), b = face.weights(to);
  double begin = 0.0, end = 1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double wa = a[k] + touching, wb = b[k] + touching;
    if (wa < 0.0 && wb < 0.0)
    {
      return false;
    }
    if (wa < 0.0)
    {
      begin = std::max(begin, wa / (wa - wb));
    }
    else if (wb < 0.0)
    {
      end = std::min(end, wa / (wa - wb));
    }
  }
  if (begin > end)
  {
    return false;
  }
  const double heightFrom = face.normal.dot(from - face.p), heightTo = face.normal.dot(to - face.p);
  const double first = heightFrom + begin * (heightTo - heightFrom),
               last = heightFrom + end * (heightTo - heightFrom);
  return (first < 0.0) != (last < 0.0) || std::min(std::abs(first), std::abs(last)) <= gap;
}

// `gap`: how far the curve may be from the face.
bool passesThrough(const CurveSearch& search, int curve, const Corners& corners, double gap)
{
  const FeatureCurve& c = search.curves()[curve];
  if (corners.area2 <= 0.0)
  {
    return false;
  }
  return search.meet(curve,
    corners.box(gap),
    [&](int s)
    {
      const int e = c.segmentEnd(s);
      const bool faced =
        c.normals.empty() || corners.normal.dot(c.normals[s]) > 0.0 || corners.normal.dot(c.normals[e]) > 0.0;
      return faced && meets(corners, c.points[s], c.points[e], gap);
    });
}

// How far a curve may be from a face with these corners; none where it is farther from its curve's box.
std::optional<double> gapNear(const Eigen::AlignedBox3d& box,
  double widening,
  const Vector3& a,
  const Vector3& b,
  const Vector3& c)
{
  const double gap =
    0.5 * widening *
    std::sqrt(std::max({ (a - b).squaredNorm(), (b - c).squaredNorm(), (c - a).squaredNorm() }));
  const bool near = (a.cwiseMin(b).cwiseMin(c).array() - gap <= box.max().array()).all() &&
                    (a.cwiseMax(b).cwiseMax(c).array() + gap >= box.min().array()).all();
  return near ? std::optional<double>(gap) : std::nullopt;
}

// By a number for each face, the parts in which they hang together.
std::vector<int> partsOf(const Forest& forest, const std::vector<int>& touched)
{
  std::vector<int> part(touched.size(), -1), stack;
  const auto reach = [&](int i, int number)
  {
    if (part[i] < 0)
    {
      part[i] = number;
      stack.push_back(i);
    }
  };
  int count = 0;
  for (int i = 0; i < static_cast<int>(touched.size()); ++i)
  {
    reach(i, count);
    count += stack.empty() ? 0 : 1;
    while (!stack.empty())
    {
      const int number = part[stack.back()], f = touched[stack.back()];
      stack.pop_back();
      for (const int g : forest.faces[f].n)
      {
        const auto found = std::lower_bound(touched.begin(), touched.end(), g);
        if (found != touched.end() && *found == g)
        {
          reach(static_cast<int>(found - touched.begin()), number);
        }
      }
    }
  }
  return part;
}

// Faces that a curve touches and that hang together with one that is the nearest to a sample.
// `at`: where a vertex is.
template <class At>
std::vector<int> joined(const Forest& forest,
  const CurveSearch& search,
  int curve,
  double widening,
  const std::vector<int>& touched,
  const std::vector<int>& part,
  const At& at)
{
  const FeatureCurve& c = search.curves()[curve];
  const auto cornersOf = [&](int i)
  {
    const int* v = forest.faces[touched[i]].v;
    return Corners(at(v[0]), at(v[1]), at(v[2]));
  };
  // Distances are of matter only to samples that faces of several parts are near.
  constexpr int none = -1, several = -2;
  std::vector<int> partAt(c.points.size(), none);
  std::vector<std::pair<int, int>> near; // a sample, and a face
  for (int i = 0; i < static_cast<int>(touched.size()); ++i)
  {
    const Corners corners = cornersOf(i);
    search.meet(curve,
      corners.box(0.5 * widening * corners.longest),
      [&](int s)
      {
        for (const int p : { s, c.segmentEnd(s) })
        {
          partAt[p] = partAt[p] == none || partAt[p] == part[i] ? part[i] : several;
          near.emplace_back(p, i);
        }
        return false;
      });
  }
  std::vector<double> best(c.points.size(), std::numeric_limits<double>::infinity());
  std::vector<int> nearest(c.points.size(), -1);
  for (const auto& [p, i] : near)
  {
    if (partAt[p] == several)
    {
      const Corners corners = cornersOf(i);
      const double distance =
        squaredDistance(corners.p, corners.p + corners.x, corners.p + corners.y, c.points[p]);
      if (distance < best[p])
      {
        best[p] = distance;
        nearest[p] = i;
      }
    }
  }
  std::vector<char> stays(touched.size(), 0); // by part
  for (std::size_t p = 0; p < partAt.size(); ++p)
  {
    const int from = nearest[p] >= 0 ? part[nearest[p]] : partAt[p];
    if (from >= 0)
    {
      stays[from] = 1;
    }
  }
  std::vector<int> faces;
  for (std::size_t i = 0; i < touched.size(); ++i)
  {
    if (stays[part[i]])
    {
      faces.push_back(touched[i]);
    }
  }
  return faces;
}

} // namespace

std::vector<int> passedPutBack(const Forest& forest,
  const CurveSearch& search,
  int curve,
  const std::vector<int>& touched,
  const std::vector<int>& parts)
{
  return joined(forest, search, curve, 1.0, touched, parts, [&forest](int v) { return putBack(forest, v); });
}

bool touches(const CurveSearch& search, int curve, const Vector3& a, const Vector3& b, const Vector3& c)
{
  const std::optional<double> gap = gapNear(search.box(curve), 1.0, a, b, c);
  return gap && passesThrough(search, curve, Corners(a, b, c), *gap);
}

CrossedFaces::CrossedFaces(const Forest& forest, const CurveSearch& search, const Context& context)
  : Mesh(forest)
  , Search(search)
  , Faces(search.curves().size())
  , Touched(search.curves().size())
  , Parts(search.curves().size())
  , Gaps(search.curves().size())
{
  for (int k = 0; k < static_cast<int>(this->Faces.size()); ++k)
  {
    // A surface that moved away from the curve is looked for farther off.
    for (double widening = 1.0; this->Faces[k].empty() && widening < 1e5; widening *= 8.0)
    {
      std::vector<int> touched = this->touching(k, widening, context);
      std::vector<int> parts = partsOf(forest, touched);
      this->Faces[k] = joined(forest,
        search,
        k,
        widening,
        touched,
        parts,
        [&forest](int v) -> const Vector3& { return forest.vertices[v].position; });
      if (widening == 1.0)
      {
        this->Touched[k] = std::move(touched);
        this->Parts[k] = std::move(parts);
      }
      for (int f : this->Faces[k])
      {
        this->Gaps[k].push_back(0.5 * widening * Corners(forest, f).longest);
      }
    }
  }
}

bool CrossedFaces::passes(int face, int curve, double gap) const
{
  return passesThrough(this->Search, curve, Corners(this->Mesh, face), gap);
}

std::vector<int> CrossedFaces::touching(int curve, double widening, const Context& context) const
{
  const int count = static_cast<int>(this->Mesh.faces.size());
  std::vector<char> touched(count, 0);
  context.parallelFor(count,
    [&](int begin, int end)
    {
      for (int f = begin; f < end; ++f)
      {
        if (f % facesPerCheck == 0 && context.cancelled())
        {
          return;
        }
        if (!this->Mesh.isFace(f))
        {
          continue;
        }
        const std::optional<double> gap = gapNear(this->Search.box(curve),
          widening,
          this->Mesh.cornerOf(f, 0),
          this->Mesh.cornerOf(f, 1),
          this->Mesh.cornerOf(f, 2));
        touched[f] = gap && this->passes(f, curve, *gap);
      }
    });
  context.checkpoint(0.0);
  return marked(touched);
}

void CrossedFaces::follow(const std::vector<Forest::Birth>& births)
{
  for (int k = 0; k < static_cast<int>(this->Faces.size()); ++k)
  {
    // Slots that hold pieces of the curve's faces, with the gaps of those.
    std::unordered_map<int, double> pieces;
    for (std::size_t i = 0; i < this->Faces[k].size(); ++i)
    {
      pieces.emplace(this->Faces[k][i], this->Gaps[k][i]);
    }
    for (const Forest::Birth& birth : births)
    {
      const auto parent = pieces.find(birth.parent);
      if (parent != pieces.end())
      {
        const double gap = parent->second;
        pieces.emplace(birth.child, gap);
      }
    }
    std::vector<std::pair<int, double>> kept;
    for (const auto& piece : pieces)
    {
      if (this->passes(piece.first, k, piece.second))
      {
        kept.push_back(piece);
      }
    }
    std::sort(kept.begin(), kept.end());
    this->Faces[k].clear();
    this->Gaps[k].clear();
    for (const auto& [face, gap] : kept)
    {
      this->Faces[k].push_back(face);
      this->Gaps[k].push_back(gap);
    }
  }
}

} // namespace oversketch
