// The part of a mesh that is being remeshed: its changing connectivity, what may not change, and the four
// moves of incremental remeshing with the tests that keep them safe.
//
// Why ours: CGAL's isotropic_remeshing is GPL, has one length for all vertices in 5.5, forgets where on the
// input a vertex came from (which attributes and texture seams need), and does not promise an order. Triangle
// lists per vertex rather than half-edges: real models have non-manifold edges, and lists hold them as they
// are.
#ifndef oversketch_patch_h
#define oversketch_patch_h

#include "Remesh/surface.h"

#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

namespace oversketch
{

// The normals of two triangles, given by vectors of any length along them, are over 100 degrees apart.
inline bool folded(const Vector3& a, const Vector3& b)
{
  constexpr double limit = -0.17364818; // cosine of 100 degrees
  return a.dot(b) < limit * std::sqrt(a.squaredNorm() * b.squaredNorm());
}

class Patch
{
public:
  // The triangles of surface with active != 0 may change. sizes: target edge length per vertex of the input.
  // Vertices and edges are protected besides those that protect themselves: see fixed() and protectedEdge().
  Patch(const Surface& surface,
    const std::vector<char>& active,
    const std::vector<double>& sizes,
    const std::vector<int>& protectedVertices,
    const std::vector<std::array<int, 2>>& protectedEdges);

  int vertexCount() const { return static_cast<int>(this->points_.size()); }
  int triangleCount() const { return static_cast<int>(this->triangles_.size()); }
  bool aliveTriangle(int t) const { return this->active_[t] != 0; } // of the patch, not removed
  bool aliveVertex(int v) const { return this->mergedInto_[v] == v; }
  int mergedInto(int v) const { return this->mergedInto_[v]; } // v itself, or the vertex it was collapsed to
  const Vector3& point(int v) const { return this->points_[v]; }
  const SurfacePoint& place(int v) const { return this->places_[v]; } // of a vertex of the patch
  const Triangle& triangle(int t) const { return this->triangles_[t]; }
  int chart(int t) const { return this->charts_[t]; }

  // True for a vertex that neither moves nor goes: on the patch's border (shared with a triangle outside), on
  // a border of the mesh, at a non-manifold edge or a pinched or doubly wound fan, on a protected edge, or
  // protected itself.
  bool fixed(int v) const { return this->fixed_[v] != 0; }
  // True for an edge that is neither flipped nor collapsed: between charts, or given as protected.
  bool protectedEdge(int a, int b) const;
  // True for an edge of two alive, consistently wound triangles of the patch.
  bool inner(int a, int b) const;
  bool splittable(int a, int b) const; // inner, or on the border of the mesh

  // Edges of the patch as (a, b) with a < b, ascending.
  std::vector<std::array<int, 2>> edges() const;
  double edgeLength(int a, int b) const { return (this->points_[a] - this->points_[b]).norm(); }
  // Length over target length.
  double relativeLength(int a, int b) const
  {
    return 2.0 * this->edgeLength(a, b) / (this->sizes_[a] + this->sizes_[b]);
  }

  // Each does its move and returns true, or finds it unsafe or of no use and changes nothing.
  // Puts a vertex at the middle of an edge, on the surface; -1 if refused (a folded edge, flat or folded
  // halves). neighbours: vertices it is joined to, -1 fill.
  int split(int a, int b, std::array<int, 4>& neighbours);
  // Removes vertex `from` by merging it into `to`, unless an edge longer than `longest` (relative) would
  // come.
  bool collapse(int from, int to, double longest);
  // Flips towards valence 6 (4 on a border); byAngle: towards larger smallest angles.
  bool flip(int a, int b, bool byAngle);
  // Where relaxation wants a vertex: tangential, projected to the surface. Reads only.
  SurfacePoint relaxed(int v) const;
  bool move(int v, const SurfacePoint& to);

private:
  using Faces = std::array<int, 2>;
  struct Fan; // triangles before or after a move

  bool facesOf(int a, int b, Faces& faces, bool& border) const;
  int opposite(int t, int a, int b) const;
  Vector3 cross(const Triangle& t) const; // twice the area times the normal
  int valence(int v) const;
  int folds(const Fan& fan, const std::vector<int>& replaced) const;
  Fan fanOf(const std::vector<int>& triangles) const;
  void detach(int v, int t);
  double sizeAt(const SurfacePoint& at) const;
  bool discAt(int v) const;
  int addVertex(const SurfacePoint& at, bool fixedVertex, bool border);
  void removeLastVertex();

  const Surface& surface_;
  const std::vector<double>& inputSizes_;
  std::vector<Vector3> points_;
  std::vector<SurfacePoint> places_;
  std::vector<double> sizes_;
  std::vector<char> fixed_, border_; // border_: on a border of the mesh
  std::vector<int> mergedInto_;
  std::vector<Triangle> triangles_;
  std::vector<char> active_;
  std::vector<int> charts_;
  std::vector<std::vector<int>> rings_; // all triangles around a vertex of the patch, outside ones too
  std::set<std::pair<int, int>> protectedEdges_;
};

} // namespace oversketch
#endif
