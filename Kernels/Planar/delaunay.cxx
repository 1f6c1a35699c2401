#include "Planar/delaunay.h"

#include "Planar/exact.h"
#include "Planar/predicates.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numeric>

namespace oversketch
{
namespace
{

// Where an edge is: a face and the corner opposite.
struct EdgeSide
{
  int face = -1, corner = -1;
};

class Triangulation
{
public:
  Triangulation(const Polyline& points, const Context& context);

  // Whether there are triangles at all.
  bool build();
  void constrain(const std::vector<Constraint>& constraints);
  std::vector<DelaunayFace> result() const;

private:
  // The outside is faces too, one beside each edge of the hull, whose third corner lies infinitely far.
  bool isOuter(int face) const
  {
    const std::array<int, 3>& c = this->Faces[face].corners;
    return c[0] == this->Far || c[1] == this->Far || c[2] == this->Far;
  }
  int turn(int a, int b, int c) const { return exactTurn(this->Points[a], this->Points[b], this->Points[c]); }
  bool conflicts(int face, int point) const;
  std::vector<int> insertionOrder() const;
  int seed(const std::vector<int>& order);
  int locate(int point, int start) const;
  int insert(int point, int start);
  EdgeSide find(int from, int to) const;
  template <typename Visit>
  void aroundPoint(int point, const Visit& visit) const;
  int farCorner(const EdgeSide& side) const;
  void flip(const EdgeSide& side);
  std::vector<std::array<int, 2>> crossed(int number, const Constraint& constraint) const;
  void insert(int number, const Constraint& constraint);
  void legalise(std::vector<std::array<int, 2>> edges);
  [[noreturn]] void refuse(const Constraint& constraint, int other, const Vector2& place) const;

  const Polyline& Points;
  const Context& Run;
  const int Far; // the number of the point at infinity
  std::vector<DelaunayFace> Faces;
  std::vector<int> FaceOf; // of each point, one at it
  const std::vector<Constraint>* Constraints = nullptr;
  // Edge that an insertion looks at.
  struct Edge
  {
    int from, to, outside;
  };
  std::vector<Edge> Border;
  std::vector<int> Cavity, StartAt;
  std::vector<std::uint8_t> InCavity;
};

Triangulation::Triangulation(const Polyline& points, const Context& context)
  : Points(points)
  , Run(context)
  , Far(static_cast<int>(points.size()))
  , FaceOf(points.size() + 1, -1)
  , StartAt(points.size() + 1, -1)
{
  this->Faces.reserve(2 * points.size() + 4);
}

// Whether a point lies in a face's circle, the tie decided as the header says; the circle of an outer face is
// the half plane beyond its edge, and that edge.
bool Triangulation::conflicts(int face, int point) const
{
  const std::array<int, 3>& c = this->Faces[face].corners;
  for (int i = 0; i < 3; ++i)
  {
    if (c[i] == this->Far)
    {
      const int a = c[(i + 1) % 3], b = c[(i + 2) % 3];
      const int side = this->turn(a, b, point);
      return side > 0 || (side == 0 && between(this->Points[a], this->Points[b], this->Points[point]));
    }
  }
  const int side =
    exactCircle(this->Points[c[0]], this->Points[c[1]], this->Points[c[2]], this->Points[point]);
  if (side != 0)
  {
    return side > 0;
  }
  const int i = static_cast<int>(std::min_element(c.begin(), c.end()) - c.begin());
  return point < c[i] || this->turn(point, c[(i + 1) % 3], c[(i + 2) % 3]) < 0;
}

// The first triangle: two points and the first that is not in line with them, and what lies outside. Returns
// that point's place in the order, or the count of points where all lie on one line.
int Triangulation::seed(const std::vector<int>& order)
{
  const int count = static_cast<int>(order.size());
  for (int k = 2; k < count; ++k)
  {
    const int side = this->turn(order[0], order[1], order[k]);
    if (side != 0)
    {
      const int a = order[0], b = side > 0 ? order[1] : order[k], c = side > 0 ? order[k] : order[1];
      this->Faces.resize(4);
      this->Faces[0] = { { a, b, c }, { 1, 2, 3 }, { -1, -1, -1 } };
      this->Faces[1] = { { this->Far, c, b }, { 0, 3, 2 }, { -1, -1, -1 } };
      this->Faces[2] = { { this->Far, a, c }, { 0, 1, 3 }, { -1, -1, -1 } };
      this->Faces[3] = { { this->Far, b, a }, { 0, 2, 1 }, { -1, -1, -1 } };
      return k;
    }
  }
  return count;
}

// A face that conflicts with the point: walks towards it.
int Triangulation::locate(int point, int start) const
{
  int face = start;
  for (int i = 0; i < 3; ++i)
  {
    if (this->Faces[face].corners[i] == this->Far)
    {
      face = this->Faces[face].across[i];
      break;
    }
  }
  for (int last = -1;;)
  {
    const DelaunayFace& here = this->Faces[face];
    int next = -1;
    for (int i = 0; i < 3 && next < 0; ++i)
    {
      if (here.across[i] != last &&
          this->turn(here.corners[(i + 1) % 3], here.corners[(i + 2) % 3], point) < 0)
      {
        next = here.across[i];
      }
    }
    if (next < 0)
    {
      return face;
    }
    last = face;
    face = next;
    if (this->isOuter(face))
    {
      return face;
    }
  }
}

// Returns a face at the point.
int Triangulation::insert(int point, int start)
{
  this->Cavity.assign(1, this->locate(point, start));
  this->InCavity.resize(this->Faces.size(), 0);
  this->InCavity[this->Cavity[0]] = 1;
  this->Border.clear();
  for (std::size_t i = 0; i < this->Cavity.size(); ++i)
  {
    const DelaunayFace& face = this->Faces[this->Cavity[i]];
    for (int k = 0; k < 3; ++k)
    {
      const int across = face.across[k];
      if (this->InCavity[across])
      {
        continue;
      }
      if (this->conflicts(across, point))
      {
        this->InCavity[across] = 1;
        this->Cavity.push_back(across);
      }
      else
      {
        this->Border.push_back({ face.corners[(k + 1) % 3], face.corners[(k + 2) % 3], across });
      }
    }
  }
  for (const int face : this->Cavity)
  {
    this->InCavity[face] = 0;
  }
  // The fan takes the cavity's places and two more.
  std::size_t used = 0;
  for (const Edge& edge : this->Border)
  {
    int face = static_cast<int>(this->Faces.size());
    if (used < this->Cavity.size())
    {
      face = this->Cavity[used++];
    }
    else
    {
      this->Faces.emplace_back();
    }
    this->Faces[face] = { { edge.from, edge.to, point }, { -1, -1, edge.outside }, { -1, -1, -1 } };
    this->StartAt[edge.from] = face;
    DelaunayFace& outside = this->Faces[edge.outside];
    for (int k = 0; k < 3; ++k)
    {
      if (outside.corners[(k + 1) % 3] == edge.to && outside.corners[(k + 2) % 3] == edge.from)
      {
        outside.across[k] = face;
      }
    }
  }
  for (const Edge& edge : this->Border)
  {
    const int face = this->StartAt[edge.from], next = this->StartAt[edge.to];
    this->Faces[face].across[0] = next;
    this->Faces[next].across[1] = face;
  }
  return this->StartAt[this->Border.front().from];
}

// Slabs of neighbours in x, up one and down the next.
std::vector<int> Triangulation::insertionOrder() const
{
  std::vector<int> order(this->Points.size());
  std::iota(order.begin(), order.end(), 0);
  const int slab = 1 + static_cast<int>(std::sqrt(2.0 * this->Far));
  for (int begin = 0, number = 0; begin < this->Far; begin += slab, ++number)
  {
    std::sort(order.begin() + begin,
      order.begin() + std::min(begin + slab, this->Far),
      [&](int a, int b)
      {
        const double ya = this->Points[a][1], yb = this->Points[b][1];
        return number % 2 == 0 ? ya < yb : ya > yb;
      });
  }
  return order;
}

bool Triangulation::build()
{
  const std::vector<int> order = this->insertionOrder();
  const int third = this->seed(order);
  int face = 0;
  for (int k = 2; third < this->Far && k < this->Far; ++k)
  {
    if (k % 1024 == 0)
    {
      this->Run.checkpoint(0.5 * k / this->Far);
    }
    if (k != third)
    {
      face = this->insert(order[k], face);
    }
  }
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    for (const int corner : this->Faces[f].corners)
    {
      this->FaceOf[corner] = static_cast<int>(f);
    }
  }
  return !this->Faces.empty();
}

// Calls visit(face, corner of the point) for the faces at a point, counter-clockwise, until it says true.
template <typename Visit>
void Triangulation::aroundPoint(int point, const Visit& visit) const
{
  const int first = this->FaceOf[point];
  int face = first;
  do
  {
    const DelaunayFace& here = this->Faces[face];
    const int corner = here.corners[0] == point ? 0 : here.corners[1] == point ? 1 : 2;
    if (visit(face, corner))
    {
      return;
    }
    face = here.across[(corner + 1) % 3];
  } while (face != first);
}

// The face that has the edge from one point to another counter-clockwise.
EdgeSide Triangulation::find(int from, int to) const
{
  EdgeSide result;
  this->aroundPoint(from,
    [&](int face, int corner)
    {
      if (this->Faces[face].corners[(corner + 1) % 3] == to)
      {
        result = { face, (corner + 2) % 3 };
      }
      return result.face >= 0;
    });
  return result;
}

// The corner, in the face across, that is opposite the same edge.
int Triangulation::farCorner(const EdgeSide& side) const
{
  const DelaunayFace& here = this->Faces[side.face];
  const DelaunayFace& there = this->Faces[here.across[side.corner]];
  const int before = here.corners[(side.corner + 2) % 3]; // the far corner follows the edge's start there
  for (int k = 0; k < 3; ++k)
  {
    if (there.corners[(k + 1) % 3] == before)
    {
      return k;
    }
  }
  return -1;
}

// Puts the other diagonal into the two faces at an edge.
void Triangulation::flip(const EdgeSide& side)
{
  const int f = side.face, i = side.corner, g = this->Faces[f].across[i], j = this->farCorner(side);
  const DelaunayFace a = this->Faces[f], b = this->Faces[g];
  const int top = a.corners[i], left = a.corners[(i + 1) % 3], right = a.corners[(i + 2) % 3];
  const int low = b.corners[j];
  // a is top, left, right; b is low, right, left.
  this->Faces[f] = { { top, left, low },
    { b.across[(j + 1) % 3], g, a.across[(i + 2) % 3] },
    { b.constraints[(j + 1) % 3], -1, a.constraints[(i + 2) % 3] } };
  this->Faces[g] = { { low, right, top },
    { a.across[(i + 1) % 3], f, b.across[(j + 2) % 3] },
    { a.constraints[(i + 1) % 3], -1, b.constraints[(j + 2) % 3] } };
  const auto relink = [&](int face, int was, int now)
  {
    for (int& across : this->Faces[face].across)
    {
      across = across == was ? now : across;
    }
  };
  relink(b.across[(j + 1) % 3], g, f);
  relink(a.across[(i + 1) % 3], f, g);
  this->FaceOf[left] = this->FaceOf[top] = f;
  this->FaceOf[right] = this->FaceOf[low] = g;
}

void Triangulation::refuse(const Constraint& constraint, int other, const Vector2& place) const
{
  const char* text =
    other == constraint.stroke
      ? "{stroke %1} meets itself near {(%2, %3)}; draw one of them anew, or with more room there"
    : other >= 0
      ? "{stroke %1} meets {stroke %4} near {(%2, %3)}; draw one of them anew, or with more room there"
      : "{stroke %1} goes through a point of the mesh near {(%2, %3)}; draw one of them anew, or with more "
        "room "
        "there";
  throw Error(Failure::BadStroke, text, constraint.stroke, place[0], place[1], other);
}

// The edges that a constraint crosses, each from its right to its left.
std::vector<std::array<int, 2>> Triangulation::crossed(int number, const Constraint& constraint) const
{
  const int u = constraint.from, v = constraint.to;
  const auto throughPoint = [&](int point)
  {
    // Stroke that ends or bends there, if one does.
    const auto owner = std::find_if(this->Constraints->begin(),
      this->Constraints->end(),
      [&](const Constraint& c) { return c.from == point || c.to == point; });
    this->refuse(constraint, owner == this->Constraints->end() ? -1 : owner->stroke, this->Points[point]);
  };
  EdgeSide side;
  this->aroundPoint(u,
    [&](int face, int corner)
    {
      const int a = this->Faces[face].corners[(corner + 1) % 3],
                b = this->Faces[face].corners[(corner + 2) % 3];
      const int sa = a == this->Far ? 1 : this->turn(u, v, a);
      if (sa == 0 && between(this->Points[u], this->Points[v], this->Points[a]))
      {
        throughPoint(a);
      }
      if (sa < 0 && b != this->Far && this->turn(u, v, b) > 0)
      {
        side = { face, corner };
      }
      return side.face >= 0;
    });
  std::vector<std::array<int, 2>> edges;
  while (side.face >= 0)
  {
    const DelaunayFace& face = this->Faces[side.face];
    const int right = face.corners[(side.corner + 1) % 3], left = face.corners[(side.corner + 2) % 3];
    if (face.constraints[side.corner] >= 0)
    {
      const int other = (*this->Constraints)[face.constraints[side.corner]].stroke;
      this->refuse((*this->Constraints)[number], other, 0.5 * (this->Points[right] + this->Points[left]));
    }
    edges.push_back({ right, left });
    const int next = face.across[side.corner], far = this->farCorner(side);
    const int point = this->Faces[next].corners[far];
    if (point == v)
    {
      break;
    }
    const int turned = this->turn(u, v, point);
    if (turned == 0)
    {
      throughPoint(point);
    }
    // Goes on with the edge of the triangle beyond, between the new point and the one on the other side.
    side = { next, turned > 0 ? (far + 1) % 3 : (far + 2) % 3 };
  }
  return edges;
}

void Triangulation::insert(int number, const Constraint& constraint)
{
  const int u = constraint.from, v = constraint.to;
  std::vector<std::array<int, 2>> fresh;
  if (this->find(u, v).face < 0)
  {
    const std::vector<std::array<int, 2>> edges = this->crossed(number, constraint);
    std::deque<std::array<int, 2>> queue(edges.begin(), edges.end());
    while (!queue.empty())
    {
      const auto [a, b] = queue.front();
      queue.pop_front();
      const EdgeSide side = this->find(a, b);
      const int top = this->Faces[side.face].corners[side.corner];
      const int low = this->Faces[this->Faces[side.face].across[side.corner]].corners[this->farCorner(side)];
      if (this->turn(low, b, top) <= 0 || this->turn(top, a, low) <= 0)
      {
        queue.push_back({ a, b }); // the two are no convex quad yet
        continue;
      }
      this->flip(side);
      const bool ends = top == u || top == v || low == u || low == v;
      if (!ends && this->turn(u, v, top) != this->turn(u, v, low))
      {
        queue.push_back({ top, low });
      }
      else
      {
        fresh.push_back({ top, low });
      }
    }
  }
  for (const EdgeSide& side : { this->find(u, v), this->find(v, u) })
  {
    int& owner = this->Faces[side.face].constraints[side.corner];
    if (owner >= 0)
    {
      this->refuse(constraint, (*this->Constraints)[owner].stroke, 0.5 * (this->Points[u] + this->Points[v]));
    }
    owner = number;
  }
  this->legalise(std::move(fresh));
}

// Lawson's flips, from these edges on.
void Triangulation::legalise(std::vector<std::array<int, 2>> edges)
{
  while (!edges.empty())
  {
    const auto [a, b] = edges.back();
    edges.pop_back();
    const EdgeSide side = this->find(a, b);
    if (side.face < 0 || this->Faces[side.face].constraints[side.corner] >= 0)
    {
      continue;
    }
    const int across = this->Faces[side.face].across[side.corner];
    if (this->isOuter(side.face) || this->isOuter(across))
    {
      continue;
    }
    const int low = this->Faces[across].corners[this->farCorner(side)];
    if (this->conflicts(side.face, low))
    {
      const int top = this->Faces[side.face].corners[side.corner];
      this->flip(side);
      edges.insert(edges.end(), { { a, top }, { top, b }, { b, low }, { low, a } });
    }
  }
}

void Triangulation::constrain(const std::vector<Constraint>& constraints)
{
  this->Constraints = &constraints;
  for (std::size_t i = 0; i < constraints.size(); ++i)
  {
    if (i % 256 == 0)
    {
      this->Run.checkpoint(0.5 + 0.5 * static_cast<double>(i) / static_cast<double>(constraints.size()));
    }
    this->insert(static_cast<int>(i), constraints[i]);
  }
}

std::vector<DelaunayFace> Triangulation::result() const
{
  // Faces by their least corner, then by the next one: no two have both.
  struct Key
  {
    int second, face, shift;
  };
  std::vector<int> begins(this->Points.size() + 1, 0);
  const auto shiftOf = [](const DelaunayFace& face)
  {
    const std::array<int, 3>& c = face.corners;
    return c[0] < c[1] ? (c[0] < c[2] ? 0 : 2) : (c[1] < c[2] ? 1 : 2);
  };
  int count = 0;
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    if (!this->isOuter(static_cast<int>(f)))
    {
      ++begins[this->Faces[f].corners[shiftOf(this->Faces[f])] + 1];
      ++count;
    }
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Key> keys(count);
  std::vector<int> ends = begins;
  for (std::size_t f = 0; f < this->Faces.size(); ++f)
  {
    if (!this->isOuter(static_cast<int>(f)))
    {
      const std::array<int, 3>& c = this->Faces[f].corners;
      const int shift = shiftOf(this->Faces[f]);
      keys[ends[c[shift]]++] = { c[(shift + 1) % 3], static_cast<int>(f), shift };
    }
  }
  std::vector<int> numbers(this->Faces.size(), -1);
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    std::sort(keys.begin() + begins[i],
      keys.begin() + begins[i + 1],
      [](const Key& a, const Key& b) { return a.second < b.second; });
    for (int k = begins[i]; k < begins[i + 1]; ++k)
    {
      numbers[keys[k].face] = k;
    }
  }
  std::vector<DelaunayFace> sorted(count);
  for (int i = 0; i < count; ++i)
  {
    const DelaunayFace& face = this->Faces[keys[i].face];
    for (int k = 0; k < 3; ++k)
    {
      const int from = (k + keys[i].shift) % 3;
      sorted[i].corners[k] = face.corners[from];
      sorted[i].across[k] = numbers[face.across[from]];
      sorted[i].constraints[k] = face.constraints[from];
    }
  }
  return sorted;
}

} // namespace

std::vector<DelaunayFace> constrainedDelaunay(const Polyline& points,
  const std::vector<Constraint>& constraints,
  const Context& context)
{
  Triangulation triangulation(points, context);
  if (!triangulation.build())
  {
    return {};
  }
  triangulation.constrain(constraints);
  return triangulation.result();
}

} // namespace oversketch
