#include "Planar/coarse_faces.h"

#include "Mesh/context.h"
#include "Mesh/shape.h"
#include "Planar/predicates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace oversketch
{
namespace
{

// Faces start at their least corner, ascend, and are each its own base.
void orderFaces(PlanarMesh& mesh)
{
  for (PlanarFace& face : mesh.faces)
  {
    const auto end = face.corners.begin() + face.count();
    std::rotate(face.corners.begin(), std::min_element(face.corners.begin(), end), end);
  }
  std::sort(mesh.faces.begin(),
    mesh.faces.end(),
    [](const PlanarFace& a, const PlanarFace& b) { return a.corners < b.corners; });
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    mesh.faces[f].base = static_cast<int>(f);
  }
}

class TerminalRepair
{
public:
  TerminalRepair(const PlanarMesh& mesh, TerminalRule rule)
    : Mesh(mesh)
    , Rule(rule)
  {
    for (const StrokeEdge& edge : mesh.edges)
    {
      this->OnStrokes.insert(std::minmax(edge.from, edge.to));
    }
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      this->link(static_cast<int>(f));
    }
  }

  PlanarMesh run()
  {
    // A fan is not terminal, and leaves its neighbours' edges as they are.
    const int count = static_cast<int>(this->Mesh.faces.size());
    for (int f = 0; f < count; ++f)
    {
      if (this->isTerminal(f))
      {
        this->divide(f);
      }
    }
    orderFaces(this->Mesh);
    return std::move(this->Mesh);
  }

private:
  int corner(int face, int k) const { return this->Mesh.faces[face].corners[k % 3]; }
  const Vector2& place(int point) const { return this->Mesh.points[point].place; }
  void link(int face)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->FaceAt[{ this->corner(face, k), this->corner(face, k + 1) }] = face;
    }
  }
  // The face across the edge from a corner to the next; -1 on the border.
  int across(int face, int k) const
  {
    const auto found = this->FaceAt.find({ this->corner(face, k + 1), this->corner(face, k) });
    return found == this->FaceAt.end() ? -1 : found->second;
  }
  bool isTerminal(int face) const
  {
    int edges = 0, points = 0;
    for (int k = 0; k < 3; ++k)
    {
      edges += this->across(face, k) < 0;
      points += isRim(this->Mesh.points[this->corner(face, k)].kind);
    }
    return this->Rule == TerminalRule::TwoBoundaryEdges ? edges >= 2 : points == 3;
  }
  bool sees(const Vector2& middle, const std::vector<int>& around) const
  {
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      if (orientation(this->place(around[i]), this->place(around[(i + 1) % around.size()]), middle) <= 0)
      {
        return false;
      }
    }
    return true;
  }
  void divide(int face)
  {
    // The longest edge that neither the border nor a stroke has.
    int best = -1;
    double longest = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const int a = this->corner(face, k), b = this->corner(face, k + 1);
      const double length = (this->place(a) - this->place(b)).squaredNorm();
      if (this->across(face, k) >= 0 && !this->OnStrokes.count(std::minmax(a, b)) && length > longest)
      {
        best = k;
        longest = length;
      }
    }
    std::vector<int> around, faces{ face };
    for (int k = 0; k < 3; ++k)
    {
      around.push_back(this->corner(face, best + 2 + k)); // the edge is from the second to the third
    }
    Vector2 other = Vector2::Zero(); // where the fan's middle may be as well
    if (best >= 0)
    {
      const int neighbour = this->across(face, best);
      faces.push_back(neighbour);
      other = 0.5 * (this->place(around[1]) + this->place(around[2]));
      for (int k = 0; k < 3; ++k)
      {
        if (this->corner(neighbour, k) != around[1] && this->corner(neighbour, k) != around[2])
        {
          around.insert(around.begin() + 2, this->corner(neighbour, k));
          break;
        }
      }
    }
    Vector2 middle = Vector2::Zero();
    for (const int point : around)
    {
      middle += this->place(point) / static_cast<double>(around.size());
    }
    if (best >= 0 && !this->sees(middle, around))
    {
      middle = other;
    }
    if (!this->sees(middle, around))
    {
      throw Error(Failure::BadStroke,
        "the drawing is too thin near {(%1, %2)} to be filled; draw it wider there",
        middle[0],
        middle[1]);
    }
    PlanarPoint point;
    point.place = middle;
    point.isBase = true;
    const int number = static_cast<int>(this->Mesh.points.size());
    this->Mesh.points.push_back(point);
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      PlanarFace part = this->Mesh.faces[face];
      part.corners = { around[i], around[(i + 1) % around.size()], number, -1 };
      int at = static_cast<int>(this->Mesh.faces.size());
      if (i < faces.size())
      {
        at = faces[i];
        this->Mesh.faces[at] = part;
      }
      else
      {
        this->Mesh.faces.push_back(part);
      }
      this->link(at);
    }
  }

  PlanarMesh Mesh;
  TerminalRule Rule;
  std::set<std::pair<int, int>> OnStrokes;
  std::map<std::pair<int, int>, int> FaceAt; // by an edge, counter-clockwise
};

} // namespace

PlanarMesh repairTerminals(const PlanarMesh& mesh, TerminalRule rule)
{
  return TerminalRepair(mesh, rule).run();
}

namespace
{

constexpr int rounds = 8, directions = 8;
constexpr double step = 0.1; // of the way to the nearest neighbour
constexpr double turn = 6.28318530717958647693;

// Infinite for a triangle that is flat or turned over.
double badness(const Vector2& a, const Vector2& b, const Vector2& c)
{
  double least = std::numeric_limits<double>::infinity();
  const Vector2* corners[] = { &a, &b, &c };
  for (int k = 0; k < 3; ++k)
  {
    const Vector2 u = *corners[(k + 1) % 3] - *corners[k], v = *corners[(k + 2) % 3] - *corners[k];
    least = std::min(least, turnAngle(u, v));
  }
  return least > 0.0 ? 1.0 / least : std::numeric_limits<double>::infinity();
}

} // namespace

PlanarMesh relaxed(const PlanarMesh& mesh)
{
  PlanarMesh result = mesh;
  std::vector<std::vector<std::array<int, 2>>> opposite(mesh.points.size()); // edges, in the faces' sense
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < 3; ++k)
    {
      opposite[face.corners[k]].push_back({ face.corners[(k + 1) % 3], face.corners[(k + 2) % 3] });
    }
  }
  const auto place = [&](int point) -> const Vector2& { return result.points[point].place; };
  for (int round = 0; round < rounds; ++round)
  {
    bool moved = false;
    for (std::size_t p = 0; p < opposite.size(); ++p)
    {
      if (mesh.points[p].kind != BoundaryKind::Interior || opposite[p].empty())
      {
        continue;
      }
      const auto sumAt = [&](const Vector2& at)
      {
        double sum = 0.0;
        for (const auto& [a, b] : opposite[p])
        {
          sum += badness(at, place(a), place(b));
        }
        return sum;
      };
      const Vector2 own = place(static_cast<int>(p));
      Vector2 middle = Vector2::Zero(), best = own;
      double nearest = std::numeric_limits<double>::infinity(), least = sumAt(own);
      for (const auto& [a, b] : opposite[p]) // round an inner point each neighbour once
      {
        middle += place(a) / static_cast<double>(opposite[p].size());
        nearest = std::min(nearest, (place(a) - own).norm());
      }
      const auto offer = [&](const Vector2& at)
      {
        if (const double sum = sumAt(at); sum < (1.0 - 1e-3) * least)
        {
          least = sum;
          best = at;
        }
      };
      for (const double share : { 0.25, 0.5, 1.0 })
      {
        offer(own + share * (middle - own));
      }
      for (int k = 0; k < directions; ++k)
      {
        const double angle = turn * k / directions;
        offer(own + step * nearest * Vector2(std::cos(angle), std::sin(angle)));
      }
      moved = moved || best != own;
      result.points[p].place = best;
    }
    if (!moved)
    {
      break;
    }
  }
  return result;
}

namespace
{

constexpr double leastQuality = 0.1;
constexpr double rightAngle = 1.5707963267948966;

struct Pair
{
  double quality;
  std::array<int, 2> edge; // ascending
  std::array<int, 2> faces;
  std::array<int, 4> corners;

  bool operator<(const Pair& other) const
  {
    return this->quality != other.quality ? this->quality > other.quality : this->edge < other.edge;
  }
};

} // namespace

double quadQuality(const std::array<Vector2, 4>& corners)
{
  double worst = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    const Vector2 to = corners[(k + 1) % 4] - corners[k], from = corners[(k + 3) % 4] - corners[k];
    const double angle = turnAngle(to, from);
    worst = std::max(worst, std::abs(rightAngle - angle));
  }
  return std::max(0.0, 1.0 - worst / rightAngle);
}

PlanarMesh mergeQuads(const PlanarMesh& mesh)
{
  std::set<std::array<int, 2>> onStrokes;
  for (const StrokeEdge& edge : mesh.edges)
  {
    onStrokes.insert({ std::min(edge.from, edge.to), std::max(edge.from, edge.to) });
  }
  const auto place = [&](int point) { return mesh.points[point].place; };
  struct Half
  {
    int face, corner; // the corner that the edge starts at
  };
  std::map<std::array<int, 2>, int> facesAt; // of an edge, how many; the border's have one
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 0; k < face.count(); ++k)
    {
      const auto edge = std::minmax(face.corners[k], face.corners[(k + 1) % face.count()]);
      ++facesAt[{ edge.first, edge.second }];
    }
  }
  const auto isBorder = [&](int a, int b) { return facesAt.at({ std::min(a, b), std::max(a, b) }) == 1; };
  std::map<std::array<int, 2>, Half> halves;
  std::vector<Pair> pairs;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    const PlanarFace& face = mesh.faces[f];
    for (int k = 0; k < 3 && face.count() == 3; ++k)
    {
      const int b = face.corners[k], c = face.corners[(k + 1) % 3], a = face.corners[(k + 2) % 3];
      const std::array<int, 2> edge{ std::min(b, c), std::max(b, c) };
      const auto [other, first] = halves.insert({ edge, { static_cast<int>(f), k } });
      if (first || onStrokes.count(edge))
      {
        continue;
      }
      const PlanarFace& across = mesh.faces[other->second.face];
      const int d = across.corners[(other->second.corner + 2) % 3];
      const std::array<int, 4> quad{ a, b, d, c };
      const std::array<Vector2, 4> places{ place(a), place(b), place(d), place(c) };
      const double quality = quadQuality(places);
      const bool convex =
        orientation(places[0], places[1], places[2]) > 0 && orientation(places[2], places[3], places[0]) > 0;
      const bool ear = (isBorder(a, b) && isBorder(b, d)) || (isBorder(a, c) && isBorder(c, d));
      if (convex && !ear && quality > leastQuality)
      {
        pairs.push_back({ quality, edge, { other->second.face, static_cast<int>(f) }, quad });
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  PlanarMesh result = mesh;
  std::vector<bool> gone(mesh.faces.size(), false), merged(mesh.faces.size(), false);
  for (const Pair& pair : pairs)
  {
    const auto [f, g] = pair.faces;
    if (!merged[f] && !merged[g])
    {
      merged[f] = merged[g] = gone[g] = true;
      result.faces[f].corners = pair.corners;
    }
  }
  std::size_t kept = 0;
  for (std::size_t f = 0; f < gone.size(); ++f)
  {
    if (!gone[f])
    {
      result.faces[kept++] = result.faces[f];
    }
  }
  result.faces.resize(kept);
  orderFaces(result);
  return result;
}

} // namespace oversketch
