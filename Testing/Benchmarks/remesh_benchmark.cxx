// Remeshing the whole bunny to its mean edge length, 5 iterations, back to the surface each time: ours, mesh
// in to mesh out, and CGAL's isotropic_remeshing. The figures beside the times say whether the results
// compare: triangles, smallest angle, mean quality 4 sqrt(3) area / (sum of squared edges), and two-sided
// Hausdorff distance to the input (over vertices and four places of each triangle; the bounding diagonal is
// 1).
#include "benchmark_frame.h"

#include "Harness/cgal_surface.h"
#include "Remesh/remesh.h"
#include "Remesh/sizing.h"

#include "vtkSMPTools.h"

#include <CGAL/AABB_tree.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_traits_3.h>
#include <CGAL/AABB_triangle_primitive_3.h>
#else
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_triangle_primitive.h>
#endif

#include <algorithm>
#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

using Kernel = oversketch_test::CgalKernel;
using SurfaceMesh = oversketch_test::CgalSurface;
using Triangles = std::vector<Kernel::Triangle_3>;
#if __has_include(<CGAL/AABB_traits_3.h>)
using Primitive = CGAL::AABB_triangle_primitive_3<Kernel, Triangles::iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, Primitive>>;
#else
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;
#endif

constexpr int iterations = 5;

Kernel::Point_3 pointOf(const Vector3& p)
{
  return { p[0], p[1], p[2] };
}

double largestDistance(const Mesh& from, const Mesh& to)
{
  Triangles triangles;
  for (const Triangle& t : to.triangles)
  {
    triangles.emplace_back(pointOf(to.points[t[0]]), pointOf(to.points[t[1]]), pointOf(to.points[t[2]]));
  }
  Tree tree(triangles.begin(), triangles.end());
  tree.accelerate_distance_queries();
  double largest = 0.0;
  const auto measure = [&](const Vector3& p)
  { largest = std::max(largest, tree.squared_distance(pointOf(p))); };
  std::for_each(from.points.begin(), from.points.end(), measure);
  for (const Triangle& t : from.triangles)
  {
    const Vector3 &a = from.points[t[0]], &b = from.points[t[1]], &c = from.points[t[2]];
    measure((a + b + c) / 3.0);
    measure(0.6 * a + 0.2 * b + 0.2 * c);
    measure(0.2 * a + 0.6 * b + 0.2 * c);
    measure(0.2 * a + 0.2 * b + 0.6 * c);
  }
  return std::sqrt(largest);
}

std::map<std::string, double> figuresOf(const Mesh& mesh, const Mesh& input)
{
  double smallest = 180.0, quality = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    double squares = 0.0, area = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      smallest = std::min(smallest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / std::acos(-1.0));
      squares += a.squaredNorm();
      area = 0.5 * a.cross(b).norm();
    }
    quality += 4.0 * std::sqrt(3.0) * area / squares;
  }
  return { { "triangles", mesh.triangleCount() },
    { "smallest_angle", smallest },
    { "mean_quality", quality / mesh.triangleCount() },
    { "Hausdorff", std::max(largestDistance(mesh, input), largestDistance(input, mesh)) } };
}

double meanEdgeLength(const Mesh& mesh)
{
  return guideLength(mesh, std::vector<char>(mesh.triangles.size(), 1));
}

struct Ours
{
  std::vector<char> region;
  std::vector<double> targets;
  RemeshResult result;
};

struct Theirs
{
  SurfaceMesh input, output;
  double length;

  explicit Theirs(const Mesh& mesh)
    : input(oversketch_test::cgalSurface(mesh))
    , length(meanEdgeLength(mesh))
  {
  }
};

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    Job job;
    job.job = "remeshing";
    job.size = size;

    auto ours = std::make_shared<Ours>();
    job.who = "ours";
    job.prepare = [=]
    {
      const Mesh& mesh = model(size).mesh;
      if (ours->region.empty())
      {
        ours->region.assign(mesh.points.size(), 1);
        ours->targets.assign(mesh.points.size(), meanEdgeLength(mesh));
      }
      ours->result = RemeshResult();
    };
    job.run = [=]
    {
      Context context;
      context.parallelFor = [](int count, const Context::Body& body)
      {
        vtkSMPTools::For(0,
          count,
          [&body](vtkIdType begin, vtkIdType end) { body(static_cast<int>(begin), static_cast<int>(end)); });
      };
      ours->result =
        remesh({ model(size).mesh, ours->region, ours->targets, {}, {}, false, iterations }, context);
    };
    job.figures = [=] { return figuresOf(ours->result.mesh, model(size).mesh); };
    add(job);

    if (size == "1M")
    {
      continue; // half a minute a run
    }
    auto theirs = std::make_shared<std::unique_ptr<Theirs>>();
    job.who = "CGAL";
    job.threads = 1; // it has no more
    job.prepare = [=]
    {
      if (!*theirs)
      {
        *theirs = std::make_unique<Theirs>(model(size).mesh);
      }
      (*theirs)->output = (*theirs)->input;
    };
    job.run = [=]
    {
      SurfaceMesh& mesh = (*theirs)->output;
      CGAL::Polygon_mesh_processing::isotropic_remeshing(
        mesh.faces(), (*theirs)->length, mesh, CGAL::parameters::number_of_iterations(iterations));
    };
    job.figures = [=] { return figuresOf(oversketch_test::meshOfCgal((*theirs)->output), model(size).mesh); };
    add(job);
  }
}

} // namespace oversketch_bench
