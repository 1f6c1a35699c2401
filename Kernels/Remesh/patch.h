// The part of a mesh that is being remeshed: its changing connectivity, what may not change, and the moves
// of incremental remeshing with the tests that keep them safe.
//
// Why ours: CGAL's isotropic_remeshing is GPL, has one length for all vertices in 5.5, forgets where on the
// input a vertex came from (which attributes and texture seams need), and does not promise an order.
//
// Half-edges in flat arrays of 32-bit ids: half-edge 3 t + k runs from corner k of triangle t to the next.
// Real models have edges that no half-edge structure can hold (three triangles, two wound against each
// other); such edges, and those shared with a triangle outside, are walls: never moved, split or flipped. A
// vertex whose triangles are not one closed fan of the patch is fixed and lists its triangles.
#ifndef oversketch_kernels_remesh_patch_h
#define oversketch_kernels_remesh_patch_h

#include "Mesh/shape.h"
#include "Remesh/surface.h"

#include <array>
#include <cmath>
#include <vector>

namespace oversketch
{

// The normals of two triangles, given by vectors of any length along them, are over 100 degrees apart.
inline bool folded(const Vector3& a, const Vector3& b)
{
  constexpr double limit = 0.030153690; // square of the cosine of 100 degrees
  const double dot = a.dot(b);
  return dot < 0.0 && dot * dot > limit * (a.squaredNorm() * b.squaredNorm());
}

// A normal, given by vectors along it, turned by more than 60 degrees: too much for one move, and for an edge
// to be flipped.
inline bool turned(const Vector3& before, const Vector3& after)
{
  constexpr double limit = 0.25; // square of the cosine
  const double dot = before.dot(after);
  return dot < 0.0 || dot * dot < limit * (before.squaredNorm() * after.squaredNorm());
}

// How sharply folded an edge is: one over 100 degrees weighs more than all edges over 90 together, so that no
// move trades the latter for the former.
inline int foldWeight(const Vector3& a, const Vector3& b)
{
  return a.dot(b) < 0.0 ? (folded(a, b) ? 1001 : 1) : 0;
}

constexpr double calmCosine = 0.9743701; // of 13 degrees
// How much more a move may let the surface turn, in target lengths: as an edge that turns by 32 in place of
// 30 degrees. Without it rows of narrow triangles along a ridge stay for ever.
constexpr double turnSlack = 0.02;

// How much an edge of this length turns the surface more than 13 degrees; the triangles are given by vectors
// along their normals. Grows with the square of the angle: the same turn spread over more edges weighs less.
inline double turnWeight(const Vector3& a, const Vector3& b, double length)
{
  const double dot = a.dot(b), squared = a.squaredNorm() * b.squaredNorm();
  if (!(squared > 0.0) || (dot > 0.0 && dot * dot >= calmCosine * calmCosine * squared))
  {
    return 0.0;
  }
  return length * (calmCosine - dot / std::sqrt(squared));
}

class Patch
{
public:
  // The triangles of surface with active != 0 may change. sizes: target edge length per vertex of the input.
  // Vertices and edges are protected besides those that protect themselves: see fixed() and protectedEdge().
  // keepSmooth: sharp edges protect themselves too, and no move makes the surface turn more sharply.
  Patch(const Surface& surface,
    const std::vector<char>& active,
    const std::vector<double>& sizes,
    const std::vector<int>& protectedVertices,
    const std::vector<std::array<int, 2>>& protectedEdges,
    bool keepSmooth);

  int vertexCount() const { return static_cast<int>(this->Points.size()); }
  int triangleCount() const { return static_cast<int>(this->Active.size()); }
  bool aliveTriangle(int t) const { return this->Active[t] != 0; } // of the patch, not removed
  bool aliveVertex(int v) const { return this->MergedInto[v] == v; }
  int mergedInto(int v) const { return this->MergedInto[v]; } // v itself, or the vertex it was collapsed to
  const Vector3& point(int v) const { return this->Points[v]; }
  const SurfacePoint& place(int v) const { return this->Places[v]; } // of a vertex of the patch
  Triangle triangle(int t) const
  {
    return { this->Origin[3 * t], this->Origin[3 * t + 1], this->Origin[3 * t + 2] };
  }
  int chart(int t) const { return this->Charts.empty() ? 0 : this->Charts[t]; }

  // Moves all vertices; their places stay.
  void moveTo(const std::vector<Vector3>& points) { this->Points = points; }
  // The ends of each protected edge that was split, and the vertex between them.
  const std::vector<std::array<int, 3>>& keptSplits() const { return this->KeptSplits; }

  // Half-edges.
  int origin(int h) const { return this->Origin[h]; }
  int target(int h) const { return this->Origin[nextHalfEdge(h)]; }
  int twin(int h) const { return this->Twin[h]; } // as Surface::twins()
  // True for an edge of two triangles of the patch, wound alike.
  bool inner(int h) const { return this->Twin[h] >= 0; }
  bool splittable(int h) const { return this->Twin[h] >= borderEdge; } // inner, or on the border of the mesh
  // True for an edge that is neither flipped nor collapsed: between charts, sharp, or given as protected.
  bool protectedEdge(int h) const { return this->Kept[h] != 0; }
  // A half-edge between a and b, a to b if there is one: inner or on the border of the mesh; else -1. guess:
  // an id that is likely to be it.
  int find(int a, int b, int guess = -1) const;

  // True for a vertex that neither moves nor goes: on the patch's border (shared with a triangle outside), on
  // a border of the mesh, at a non-manifold edge or a pinched or doubly wound fan, on a protected edge, or
  // protected itself.
  bool fixed(int v) const { return this->Fixed[v] != 0; }

  // Calls visit(h) for one half-edge of every edge of triangle t of the patch that no triangle before it has
  // (for a wall: of each triangle at it). Of all triangles: for every edge of the patch.
  template <typename Visit>
  void eachEdge(int t, Visit&& visit) const
  {
    for (int h = 3 * t; this->Active[t] && h < 3 * t + 3; ++h)
    {
      if (this->Twin[h] < h)
      {
        visit(h);
      }
    }
  }

  // Squared length over squared target length.
  double relativeSquared(int a, int b) const
  {
    const double size = 0.5 * (this->Sizes[a] + this->Sizes[b]);
    return (this->Points[a] - this->Points[b]).squaredNorm() / (size * size);
  }

  // Split and collapse do their move, or find it unsafe or of no use and change nothing.
  // Puts a vertex at the middle of an edge, on the surface; -1 if refused (a folded edge, flat or folded
  // halves). neighbours: vertices it is joined to, -1 fill.
  int split(int h, std::array<int, 4>& neighbours);
  // Splits without a question an edge between two triangles with other corners each: puts the vertex at
  // this place of the surface, and to this position, which need not be on it.
  int halve(int h, const SurfacePoint& place, const Vector3& position, std::array<int, 4>& neighbours);
  // Whether that leaves more folded edges than there are.
  bool foldsHalved(int h, const Vector3& position) const
  {
    return this->halvesFold(h, this->halvesAt(h, position));
  }
  // Removes the half-edge's origin by merging it into its target, unless an edge longer than `longest`
  // (relative) would come.
  bool collapse(int h, double longest);
  // Whether a flip is safe and goes towards valence 6 (4 on a border); byAngle: towards larger smallest
  // angles. Reads the triangles at the four corners of the edge's two, and nothing else.
  bool flippable(int h, bool byAngle) const;
  void flip(int h);
  // Calls visit(t) for the triangles of the patch at a vertex.
  template <typename Visit>
  void eachTriangleAt(int v, Visit&& visit) const
  {
    if (this->Listed[v] >= 0)
    {
      for (const int t : this->Lists[this->Listed[v]])
      {
        visit(t);
      }
      return;
    }
    int h = this->Out[v];
    do
    {
      visit(h / 3);
      h = this->Twin[previousHalfEdge(h)];
    } while (h != this->Out[v]);
  }

private:
  static constexpr int borderEdge = -1; // in Twin

  friend class Relaxation;

  void protect(int h);
  bool isDisc(int v) const;
  template <typename Test>
  bool anyNeighbour(int v, Test&& test) const;
  bool joined(int a, int b) const;
  const Vector3& at(int h) const { return this->Points[this->Origin[h]]; }
  // Twice the area times the normal.
  Vector3 cross(const Vector3& a, const Vector3& b, const Vector3& c) const { return (b - a).cross(c - a); }
  Vector3 cross(int t) const
  {
    return this->cross(this->at(3 * t), this->at(3 * t + 1), this->at(3 * t + 2));
  }
  using Halves = std::array<Vector3, 4>; // of two triangles, given by their cross products
  Halves halvesAt(int h, const Vector3& p) const;
  bool halvesFold(int h, const Halves& half) const;
  int foldsOver(int h, const Vector3& own) const;
  double turnOver(int h, const Vector3& own, double length) const;
  double lengthOf(int h) const { return (this->at(nextHalfEdge(h)) - this->at(h)).norm(); }
  bool ringToCollapse(int h, double longest);
  bool shapeSurvivesCollapse(int h);
  bool collapseFolds(int h) const;
  bool collapseTurns(int h) const;
  bool middleOf(int h, SurfacePoint& result, bool& straight) const;
  void link(int h, int twin, int was);
  void join(int h, int twin);
  void set(int t, int a, int b, int c);
  void attach(int v, int t);
  void detach(int v, int t);
  double sizeAt(const SurfacePoint& at) const;
  int addVertex(const SurfacePoint& at, const Vector3& position, bool fixedVertex, bool border);
  int addTriangle(int chart);

  const Surface& Original;
  const std::vector<double>& InputSizes;
  const bool KeepSmooth;
  // Per vertex.
  std::vector<Vector3> Points;
  std::vector<SurfacePoint> Places;
  std::vector<double> Sizes;
  std::vector<char> Fixed, Border; // Border: on a border of the mesh
  std::vector<int> MergedInto;
  std::vector<int> Out;                // a half-edge of the patch that starts here
  std::vector<int> Valence;            // triangles, outside ones too, and one more on a border
  std::vector<int> Listed;             // index into Lists for a vertex that is no disc, else -1
  std::vector<std::vector<int>> Lists; // all its triangles, outside ones too
  // Per triangle.
  std::vector<char> Active;
  std::vector<int> Charts; // or empty
  // Per half-edge.
  std::vector<int> Origin;
  std::vector<int> Twin; // as Surface::twins()
  std::vector<char> Kept;
  std::vector<std::array<int, 3>> KeptSplits;
  // State of a collapse in progress, kept for its memory.
  std::vector<int> Spokes, Ring;
  std::vector<Vector3> Before, After;
};

} // namespace oversketch
#endif
