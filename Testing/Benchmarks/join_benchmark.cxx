// Joining a bunny and the same one turned, with a crease: ours, mesh in to mesh out, and CGAL's corefinement.
// The figures say whether the results compare: triangles and volume.
#include "benchmark_frame.h"

#include "Harness/cgal_surface.h"
#include "Join/join.h"

#include "vtkSMPTools.h"

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <cmath>
#include <memory>
#include <numeric>

namespace oversketch_bench
{

namespace
{

using oversketch_test::cgalSurface;
using oversketch_test::CgalSurface;

Mesh turned(Mesh mesh)
{
  const Eigen::AlignedBox3d box = boxRound(mesh.points);
  const Eigen::Matrix3d by = Eigen::AngleAxisd(0.8, Vector3(0.3, 1.0, 0.2).normalized()).toRotationMatrix();
  for (Vector3& p : mesh.points)
  {
    p = by * (p - box.center()) + box.center() + 0.15 * box.diagonal();
  }
  return mesh;
}

double volumeOf(const Mesh& mesh)
{
  return std::accumulate(mesh.triangles.begin(),
           mesh.triangles.end(),
           0.0,
           [&mesh](double sum, const Triangle& t)
           { return sum + mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])); }) /
         6.0;
}

std::map<std::string, double> figuresOf(const Mesh& mesh)
{
  return { { "triangles", mesh.triangleCount() }, { "volume", volumeOf(mesh) } };
}

struct Ours
{
  Mesh both;
  std::vector<int> parts;
  Joined result;
};

struct Theirs
{
  CgalSurface first, second, one, two, out;
};

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k" }))
  {
    Job job;
    job.job = "joining";
    job.size = size;

    auto ours = std::make_shared<Ours>();
    job.who = "ours";
    job.prepare = [=]
    {
      if (ours->parts.empty())
      {
        const Mesh &one = model(size).mesh, two = turned(one);
        ours->both = one;
        ours->both.points.insert(ours->both.points.end(), two.points.begin(), two.points.end());
        for (const Triangle& t : two.triangles)
        {
          const int first = one.vertexCount();
          ours->both.triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
        }
        ours->parts.assign(ours->both.triangles.size(), 1);
        std::fill_n(ours->parts.begin(), one.triangles.size(), 0);
      }
      ours->result = Joined();
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
      ours->result = join({ ours->both, ours->parts, ours->parts }, {}, context);
    };
    job.figures = [=] { return figuresOf(ours->result.mesh); };
    add(job);

    auto theirs = std::make_shared<std::unique_ptr<Theirs>>();
    job.who = "CGAL";
    job.threads = 1; // it has no more
    job.prepare = [=]
    {
      if (!*theirs)
      {
        *theirs = std::make_unique<Theirs>();
        (*theirs)->first = cgalSurface(model(size).mesh);
        (*theirs)->second = cgalSurface(turned(model(size).mesh));
      }
      (*theirs)->one = (*theirs)->first;
      (*theirs)->two = (*theirs)->second;
      (*theirs)->out = CgalSurface();
    };
    job.run = [=]
    {
      CGAL::Polygon_mesh_processing::corefine_and_compute_union(
        (*theirs)->one, (*theirs)->two, (*theirs)->out);
    };
    job.figures = [=] { return figuresOf(oversketch_test::meshOfCgal((*theirs)->out)); };
    add(job);
  }
}

} // namespace oversketch_bench
