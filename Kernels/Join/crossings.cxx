#include "Join/crossings.h"

#include "Intersection/face_tree.h"
#include "Intersection/sides.h"
#include "Mesh/nearest.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace oversketch
{

namespace
{

using Rational = CGAL::Exact_rational;
using Exact3 = std::array<Rational, 3>;

Exact3 exactly(const Vector3& a, const Vector3& b)
{
  return {
    Rational(b[0]) - Rational(a[0]), Rational(b[1]) - Rational(a[1]), Rational(b[2]) - Rational(a[2])
  };
}

Exact3 exactCross(const Exact3& a, const Exact3& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Rational exactDot(const Exact3& a, const Exact3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

int signOf(const Rational& value)
{
  return static_cast<int>(CGAL::sign(value));
}

// The sign of the first part of the normal that is not 0; 0 for a face without area.
int leadingSign(const Corners& face)
{
  int sign = 0;
  for (int axis = 0; axis < 3 && sign == 0; ++axis)
  {
    sign = turnOf(axis, face[0], face[1], face[2]);
  }
  return sign;
}

// 1 where a point of one surface is outside the plane of a face of the other one, -1 behind it.
int sideOfFace(const Corners& face, const Vector3& point, bool pointOfSecond)
{
  const int side = sideOf(face[0], face[1], face[2], point);
  return side != 0 ? side : pointOfSecond ? leadingSign(face) : -leadingSign(face);
}

// The turn of an edge of the second surface about one of the first.
int turnAbout(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d)
{
  int turn = sideOf(a, b, c, d);
  if (turn == 0)
  {
    const Exact3 way = exactCross(exactly(c, d), exactly(a, b));
    for (int axis = 0; axis < 3 && turn == 0; ++axis)
    {
      turn = signOf(way[axis]);
    }
  }
  return turn;
}

// Tells whether an edge whose ends are on both sides of a face's plane goes through the face.
bool goesThrough(const Vector3& a, const Vector3& b, const Corners& face, bool edgeOfSecond)
{
  int turns[3];
  for (int k = 0; k < 3; ++k)
  {
    const Vector3 &p = face[k], &q = face[(k + 1) % 3];
    turns[k] = edgeOfSecond ? turnAbout(p, q, a, b) : turnAbout(a, b, p, q);
  }
  return turns[0] == turns[1] && turns[1] == turns[2];
}

// The share of the way from a to b at which the face's plane is.
double shareAt(const Vector3& a, const Vector3& b, const Corners& face)
{
  const Vector3 u = face[1] - face[0], v = face[2] - face[0], n = u.cross(v);
  const double from = n.dot(a - face[0]), to = n.dot(b - face[0]);
  const double size = u.norm() * v.norm() * std::max((a - face[0]).norm(), (b - face[0]).norm());
  if (std::abs(from - to) > 1e-6 * size) // else rounding decides much of it
  {
    return std::clamp(from / (from - to), 0.0, 1.0);
  }
  const Exact3 normal = exactCross(exactly(face[0], face[1]), exactly(face[0], face[2]));
  const Rational start = exactDot(normal, exactly(face[0], a));
  return std::clamp(CGAL::to_double(Rational(start / exactDot(normal, exactly(b, a)))), 0.0, 1.0);
}

Corners cornersAt(const Mesh& mesh, int face)
{
  const Triangle& t = mesh.triangles[face];
  return { mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]] };
}

// The faces whose boxes meet a box, with their boxes.
std::vector<BoxedFace> facesIn(const Mesh& mesh, const Eigen::AlignedBox3d& room)
{
  std::vector<BoxedFace> faces;
  for (int f = 0; f < mesh.triangleCount(); ++f)
  {
    const Eigen::AlignedBox3d box = boxOf(mesh, f);
    if (boxesMeet(box, room))
    {
      faces.push_back({ f, box });
    }
  }
  return faces;
}

// A crossing as one of two faces that cut each other sees it.
struct Seen
{
  int first, second; // faces
  bool ofSecond;
  int edge, face;
  bool entering; // from the edge's lower vertex on
  bool ends;     // the curve ends there
  bool isOfPair(const Seen& other) const
  {
    return this->first == other.first && this->second == other.second;
  }
};

// Crossings of both surfaces at a pair of faces.
class Pairs
{
public:
  Pairs(const Mesh& first, const Adjacency& firstEdges, const Mesh& second, const Adjacency& secondEdges)
    : Meshes{ &first, &second }
    , Edges{ &firstEdges, &secondEdges }
  {
  }

  // Adds the two crossings of the faces where they cut each other; false where one has no area.
  bool add(int f, int s, std::vector<Seen>& seen) const
  {
    const int faces[2] = { f, s };
    const Corners corners[2] = { cornersAt(*this->Meshes[0], f), cornersAt(*this->Meshes[1], s) };
    int sides[2][3]; // of each one's corners
    for (const int of : { 0, 1 })
    {
      for (int k = 0; k < 3; ++k)
      {
        sides[of][k] = sideOfFace(corners[1 - of], corners[of][k], of == 1);
        if (sides[of][k] == 0)
        {
          return false;
        }
      }
      if (sides[of][0] == sides[of][1] && sides[of][1] == sides[of][2])
      {
        return true;
      }
    }
    for (const int of : { 0, 1 })
    {
      const Triangle& t = this->Meshes[of]->triangles[faces[of]];
      for (int k = 0; k < 3; ++k)
      {
        const int next = (k + 1) % 3;
        if (sides[of][k] == sides[of][next] ||
            !goesThrough(corners[of][k], corners[of][next], corners[1 - of], of == 1))
        {
          continue;
        }
        const bool in = sides[of][k] > 0; // round the face, counter-clockwise
        seen.push_back({ f,
          s,
          of == 1,
          this->Edges[of]->triangleEdges[faces[of]][k],
          faces[1 - of],
          in == (t[k] < t[next]),
          in == (of == 0) });
      }
    }
    return true;
  }

private:
  const Mesh* Meshes[2];
  const Adjacency* Edges[2];
};

[[noreturn]] void refuseFlat(const Mesh& mesh, int face)
{
  const Vector3& p = mesh.points[mesh.triangles[face][0]];
  throw Error(Failure::BadMesh,
    "A triangle without area near {(%1, %2, %3)} lies where parts meet; clean the mesh (vtkCleanPolyData), "
    "or "
    "move the part a little.",
    p[0],
    p[1],
    p[2]);
}

} // namespace

std::vector<FacePair> nearFaces(const Mesh& first,
  const Mesh& second,
  double distance,
  const Context& context)
{
  const Mesh* const meshes[2] = { &first, &second };
  const auto grown = [distance](Eigen::AlignedBox3d box)
  {
    box.min().array() -= distance;
    box.max().array() += distance;
    return box;
  };
  Eigen::AlignedBox3d boxes[2];
  context.each(2, [&](int of) { boxes[of] = grown(boxRound(meshes[of]->points)); });
  std::vector<BoxedFace> faces[2];
  context.each(2, [&](int of) { faces[of] = facesIn(*meshes[of], boxes[0].intersection(boxes[1])); });
  std::vector<BoxedFace>&ofFirst = faces[0], &ofSecond = faces[1];
  if (ofFirst.empty() || ofSecond.empty())
  {
    return {};
  }
  const FaceTree tree(ofSecond, context);
  context.checkpoint(0.1);
  constexpr int ofPart = 256;
  const int count = static_cast<int>(ofFirst.size()), parts = (count + ofPart - 1) / ofPart;
  std::vector<std::vector<FacePair>> found(static_cast<std::size_t>(parts));
  context.eachUntilCancelled(parts,
    [&](int part)
    {
      for (int i = part * ofPart; i < std::min(count, (part + 1) * ofPart); ++i)
      {
        tree.facesAt(grown(ofFirst[i].box), [&](int s) { found[part].push_back({ ofFirst[i].id, s }); });
      }
    });
  context.checkpoint(0.2);
  std::vector<FacePair> pairs;
  for (const std::vector<FacePair>& some : found)
  {
    pairs.insert(pairs.end(), some.begin(), some.end());
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

Crossings findCrossings(const Mesh& first,
  const Adjacency& firstEdges,
  const Mesh& second,
  const Adjacency& secondEdges,
  const std::vector<FacePair>& near,
  const Context& context)
{
  Crossings result;
  const Pairs pairs(first, firstEdges, second, secondEdges);
  constexpr int ofPart = 1024;
  const int count = static_cast<int>(near.size()), parts = (count + ofPart - 1) / ofPart;
  std::vector<std::vector<Seen>> found(static_cast<std::size_t>(parts));
  std::vector<int> flat(static_cast<std::size_t>(parts), -1);
  context.eachUntilCancelled(parts,
    [&](int part)
    {
      for (int i = part * ofPart; i < std::min(count, (part + 1) * ofPart); ++i)
      {
        if (!pairs.add(near[i][0], near[i][1], found[part]))
        {
          flat[part] = near[i][0];
        }
      }
    });
  context.checkpoint(0.6);
  std::vector<Seen> seen;
  for (int part = 0; part < parts; ++part)
  {
    if (flat[part] >= 0)
    {
      refuseFlat(first, flat[part]);
    }
    seen.insert(seen.end(), found[part].begin(), found[part].end());
  }
  // One crossing is seen by two pairs.
  const auto keyOf = [](const Seen& s) { return std::make_tuple(s.ofSecond, s.edge, s.face); };
  std::vector<int> order(seen.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(),
    order.end(),
    [&](int a, int b)
    {
      const auto ka = keyOf(seen[a]), kb = keyOf(seen[b]);
      return ka < kb || (ka == kb && a < b);
    });
  std::vector<int> number(seen.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const Seen& s = seen[order[i]];
    if (i == 0 || keyOf(seen[order[i - 1]]) != keyOf(s))
    {
      const Mesh &own = s.ofSecond ? second : first, &other = s.ofSecond ? first : second;
      const MeshEdge& edge = (s.ofSecond ? secondEdges : firstEdges).edges[s.edge];
      const Vector3 &a = own.points[edge.v0], &b = own.points[edge.v1];
      const double share = shareAt(a, b, cornersAt(other, s.face));
      const Vector3 point = share < 0.5 ? Vector3(a + share * (b - a)) : Vector3(b + (1.0 - share) * (a - b));
      result.points.push_back({ s.ofSecond, s.edge, s.face, s.entering, share, point });
    }
    number[order[i]] = static_cast<int>(result.points.size()) - 1;
  }
  for (std::size_t i = 0; i < seen.size(); i += 2)
  {
    if (i + 1 == seen.size() || !seen[i].isOfPair(seen[i + 1]) || seen[i].ends == seen[i + 1].ends)
    {
      refuseFlat(first, seen[i].first);
    }
    const bool ends = seen[i].ends;
    result.pieces.push_back(
      { seen[i].first, seen[i].second, number[ends ? i + 1 : i], number[ends ? i : i + 1] });
  }
  context.checkpoint(1.0);
  return result;
}

bool isInside(const Vector3& point, bool ofSecond, const Mesh& other)
{
  const Eigen::AlignedBox3d room = boxRound(other.points);
  const Vector3 end(room.max()[0] + 1.0 + std::abs(room.max()[0]), point[1], point[2]);
  bool inside = false;
  for (int f = 0; end[0] > point[0] && f < other.triangleCount(); ++f)
  {
    const Eigen::AlignedBox3d box = boxOf(other, f);
    if (box.max()[0] < point[0] || box.min()[1] > point[1] || box.max()[1] < point[1] ||
        box.min()[2] > point[2] || box.max()[2] < point[2])
    {
      continue;
    }
    const Corners face = cornersAt(other, f);
    const int from = sideOfFace(face, point, ofSecond), to = sideOfFace(face, end, ofSecond);
    inside ^= from != to && goesThrough(point, end, face, ofSecond);
  }
  return inside;
}

std::vector<int> touching(const Mesh& mesh,
  const Mesh& surface,
  const std::vector<FacePair>& near,
  int own,
  double distance)
{
  std::vector<int> touches;
  for (const FacePair& pair : near)
  {
    const Triangle& t = mesh.triangles[pair[own]];
    const Corners c = cornersAt(surface, pair[1 - own]);
    const Vector3 normal = (c[1] - c[0]).cross(c[2] - c[0]).normalized();
    const auto isInPlane = [&](int v) { return std::abs(normal.dot(mesh.points[v] - c[0])) <= distance; };
    const bool flat = std::all_of(t.begin(), t.end(), isInPlane);
    for (const int v : t)
    {
      if (flat || (isInPlane(v) && squaredDistance(c[0], c[1], c[2], mesh.points[v]) <= distance * distance))
      {
        touches.push_back(v);
      }
    }
  }
  sortUnique(touches);
  return touches;
}

} // namespace oversketch
