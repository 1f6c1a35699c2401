// Points that share a position as one vertex, whatever attributes a reader split them for, and where those
// attributes jump.
#ifndef oversketch_kernels_mesh_weld_h
#define oversketch_kernels_mesh_weld_h

#include "Mesh/mesh.h"

#include <functional>
#include <vector>

namespace oversketch
{

// The welded vertex of each point, vertices in the order of their first points; empty where no two points
// share a position.
std::vector<int> weldPoints(const std::vector<Vector3>& points);

// The mesh with its points welded, triangles in their order.
Mesh weldedMesh(const Mesh& mesh, const std::vector<int>& vertices);

// Attributes that a reader may have split a point for: `components` numbers at each point.
struct PointValues
{
  int components = 0;
  std::function<double(int point, int component)> value;
};

// Per point the first point of the same vertex whose values are all equal; a value that is not a number
// equals none.
std::vector<int> attributeClasses(const std::vector<int>& vertices, const PointValues& values);

// The triangles in charts: neighbours in one chart agree in the classes of their common points. A seam may
// end inside a patch, so a triangle joins a chart only if none across one of its seams is already there:
// every seam separates two charts.
struct Charts
{
  std::vector<int> of; // per triangle, charts in the order of their first triangles
  int count = 0;
};
// welded: of weldedMesh; corners: the points at its triangles' corners; classes: of attributeClasses.
Charts findCharts(const Mesh& welded,
  const Adjacency& adjacency,
  const std::vector<Triangle>& corners,
  const std::vector<int>& classes);

} // namespace oversketch
#endif
