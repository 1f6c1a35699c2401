#include "Planar/terminal.h"

#include "Mesh/context.h"
#include "Planar/face_order.h"
#include "Planar/predicates.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace oversketch
{
namespace
{

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

} // namespace oversketch
