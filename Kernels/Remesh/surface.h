// The surface that a remeshed patch must stay on: places on it, and the nearest place found by walking.
//
// Why walking, and why ours: a closest-point tree (CGAL's AABB tree, vtkStaticCellLocator) knows no sheets.
// It throws a vertex of a thin limb to the limb's other side, and a vertex of one texture chart into its
// neighbour. A walk over neighbouring triangles from where the vertex was cannot, and needs a handful of
// steps.
#ifndef oversketch_surface_h
#define oversketch_surface_h

#include "Mesh/mesh.h"

#include <array>
#include <vector>

namespace oversketch
{

// A place on a mesh: a triangle and barycentric weights of its corners, sum 1, exactly zero for corners that
// take no part (a place on an edge has one zero, on a vertex two).
struct SurfacePoint
{
  int triangle = -1;
  std::array<double, 3> weights{ 1.0, 0.0, 0.0 };
};

// Barycentric weights of the point of triangle (a, b, c) nearest to p.
std::array<double, 3> closestWeights(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& p);

// The place of `triangle` nearest to p.
SurfacePoint closestInTriangle(const Mesh& mesh, int triangle, const Vector3& p);

inline Vector3 positionOf(const Mesh& mesh, const SurfacePoint& at)
{
  const Triangle& t = mesh.triangles[at.triangle];
  return at.weights[0] * mesh.points[t[0]] + at.weights[1] * mesh.points[t[1]] +
         at.weights[2] * mesh.points[t[2]];
}

class Surface
{
public:
  // The triangles of mesh with active[t] != 0. charts: one number per triangle of mesh, or empty for one
  // chart. All three are kept by reference.
  Surface(const Mesh& mesh, const std::vector<char>& active, const std::vector<int>& charts);

  const Mesh& mesh() const { return this->mesh_; }
  int chart(int triangle) const { return this->charts_.empty() ? 0 : this->charts_[triangle]; }

  // Nearest place to p reached by descent over neighbouring triangles from `start`, within start's chart.
  SurfacePoint closest(const Vector3& p, int start) const;

  // The middle of two places that lie in one triangle, exactly on their common edge where they have one.
  // False when no triangle of that chart (any chart if chart < 0) holds both.
  bool middle(const SurfacePoint& a, const SurfacePoint& b, int chart, SurfacePoint& result) const;

  // The same place as seen from a triangle of the given chart; of several, from the one whose middle is
  // nearest to `towards`. The place itself if no triangle around it is of that chart.
  SurfacePoint inChart(const SurfacePoint& at, int chart, const Vector3& towards) const;

  // The first active triangle that holds all the vertices, or -1.
  int triangleWith(const std::vector<int>& vertices) const;

private:
  const Mesh& mesh_;
  const std::vector<int>& charts_;
  Lists vertexTriangles_; // active triangles only, ascending
};

} // namespace oversketch
#endif
