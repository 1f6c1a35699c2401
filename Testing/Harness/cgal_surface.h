// CGAL's surface meshes of ours and back, for tests and benchmarks beside it. Header-only; under CGAL's GPL.
#ifndef oversketch_testing_harness_cgal_surface_h
#define oversketch_testing_harness_cgal_surface_h

#include "Mesh/mesh.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <vector>

namespace oversketch_test
{

using CgalKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalSurface = CGAL::Surface_mesh<CgalKernel::Point_3>;

inline CgalSurface cgalSurface(const oversketch::Mesh& mesh)
{
  CgalSurface surface;
  for (const oversketch::Vector3& p : mesh.points)
  {
    surface.add_vertex({ p[0], p[1], p[2] });
  }
  using Vertex = CgalSurface::Vertex_index;
  for (const oversketch::Triangle& t : mesh.triangles)
  {
    surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
  }
  return surface;
}

inline oversketch::Mesh meshOfCgal(const CgalSurface& surface)
{
  oversketch::Mesh mesh;
  std::vector<int> id(surface.number_of_vertices() + surface.number_of_removed_vertices());
  for (const auto v : surface.vertices())
  {
    const CgalKernel::Point_3& p = surface.point(v);
    id[v] = mesh.vertexCount();
    mesh.points.emplace_back(p.x(), p.y(), p.z());
  }
  for (const auto f : surface.faces())
  {
    oversketch::Triangle t{};
    int k = 0;
    for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
    {
      t[k++] = id[v];
    }
    mesh.triangles.push_back(t);
  }
  return mesh;
}

inline int eulerNumber(const CgalSurface& surface)
{
  return static_cast<int>(surface.number_of_vertices()) - static_cast<int>(surface.number_of_edges()) +
         static_cast<int>(surface.number_of_faces());
}

} // namespace oversketch_test
#endif
