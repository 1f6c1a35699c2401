// The surface that a remeshed patch must stay on: places on it, and the nearest place found by walking.
//
// Why walking, and why ours: a closest-point tree (CGAL's AABB tree, vtkStaticCellLocator) knows no sheets.
// It throws a vertex of a thin limb to the limb's other side, and a vertex of one texture chart into its
// neighbour. A walk over neighbouring triangles from where the vertex was cannot, and needs a handful of
// steps.
#ifndef oversketch_kernels_remesh_surface_h
#define oversketch_kernels_remesh_surface_h

#include "Mesh/place.h"

#include <vector>

namespace oversketch
{

// Half-edge 3 t + k runs from corner k of triangle t to the next; this is the next one of its triangle.
inline int nextHalfEdge(int h)
{
  return h % 3 == 2 ? h - 2 : h + 1;
}

inline int previousHalfEdge(int h)
{
  return h % 3 == 0 ? h + 2 : h - 1;
}

class Surface
{
public:
  // The triangles of mesh with active[t] != 0. charts: one number per triangle of mesh, or empty for one
  // chart. All three are kept by reference.
  Surface(const Mesh& mesh, const std::vector<char>& active, const std::vector<int>& charts);
  // All triangles of mesh, which is kept by reference, as one chart, for a few questions: twins are looked
  // for as they are asked after, not stored.
  explicit Surface(const Mesh& mesh);

  const Mesh& mesh() const { return this->Model; }
  const std::vector<int>& charts() const { return this->Charts; }
  int chart(int triangle) const { return this->Charts.empty() ? 0 : this->Charts[triangle]; }

  // Per half-edge of mesh: the half-edge against it where exactly two triangles, both active and wound alike,
  // meet; -1 on a border, where an active triangle is alone; else the edge is a wall, and -2 - h is the next
  // half-edge h around it (itself for an inactive triangle away from active ones).
  const std::vector<int>& twins() const { return this->Twins; }

  // Nearest place to p reached by descent over neighbouring triangles from `start`, within start's chart.
  SurfacePoint closest(const Vector3& p, int start) const;

  // A triangle from which that begins nearer to its end: over edges that p lies beyond, within the chart.
  int towards(const Vector3& p, int start) const;

  // The middle of two places that lie in one triangle, exactly on their common edge where they have one.
  // False when no triangle of that chart (any chart if chart < 0) holds both.
  bool middle(const SurfacePoint& a, const SurfacePoint& b, int chart, SurfacePoint& result) const;
  // The middle of places that lie in this triangle.
  bool middleIn(int triangle, const SurfacePoint& a, const SurfacePoint& b, SurfacePoint& result) const;

  // A place as seen from a triangle of the given chart; of several, from the one whose middle is
  // nearest to `towards`. The place itself if no triangle around it is of that chart.
  SurfacePoint inChart(const SurfacePoint& at, int chart, const Vector3& towards) const;

  // The first active triangle that holds all the vertices, or -1.
  int triangleWith(const std::vector<int>& vertices) const;

private:
  void listTriangles(const std::vector<char>& active);
  void linkHalfEdges(const std::vector<char>& active);
  int twin(int h) const { return this->Twins.empty() ? this->findTwin(h) : this->Twins[h]; }
  int findTwin(int h) const;

  static const std::vector<int> oneChart;

  const Mesh& Model;
  const std::vector<int>& Charts;
  Lists VertexTriangles; // active triangles only, ascending; twice where one has a vertex twice
  std::vector<int> Twins;
};

} // namespace oversketch
#endif
