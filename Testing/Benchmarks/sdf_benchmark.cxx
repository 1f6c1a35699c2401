// The shape diameter function, 32 rays a vertex in a cone of 60 degrees: from a mesh with its adjacency and
// vertex normals to the values. Limit: plain rtcIntersect1 on the same rays, prepared, in the order of the
// vertices, in a scene without any filter or robustness, built outside the time at Embree's highest quality;
// it refines and summarises nothing. CGAL shoots from facets, twice as many rays, and smooths.
#include "Ray/ray_caster.h"
#include "Ray/shape_diameter.h"
#include "benchmark_frame.h"
#include "embree_scene.h"

#include "vtkSMPTools.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>

#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

constexpr int rayCount = 32;
constexpr double coneAngle = 60.0;

Context threaded()
{
  Context context;
  context.parallelFor = [](int count, const Context::Body& body)
  {
    vtkSMPTools::For(0,
      count,
      [&body](vtkIdType begin, vtkIdType end) { body(static_cast<int>(begin), static_cast<int>(end)); });
  };
  return context;
}

void ours(const std::string& name, const std::string& size, Backend backend)
{
  struct State
  {
    Adjacency adjacency;
    std::vector<Vector3> normals;
    ShapeDiameter result;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.job = name;
  job.size = size;
  job.who = "ours";
  job.prepare = [=]
  {
    if (state->normals.empty())
    {
      state->adjacency = buildAdjacency(model(size).mesh);
      state->normals = vertexNormals(model(size).mesh);
    }
  };
  job.run = [=]
  {
    ShapeDiameterOptions options;
    options.rayCount = rayCount;
    options.coneAngle = coneAngle;
    options.backend = backend;
    state->result =
      computeShapeDiameter(model(size).mesh, state->adjacency, state->normals, options, threaded());
    if (state->result.used != backend)
    {
      throw std::runtime_error(state->result.warning.text());
    }
  };
  job.figures = [=]
  {
    double sum = 0.0;
    for (const double d : state->result.diameter)
    {
      sum += d / static_cast<double>(state->result.diameter.size());
    }
    return std::map<std::string, double>{ { "mean", sum } };
  };
  add(job);
}

void raw(const std::string& name, const std::string& size)
{
  struct State
  {
    std::unique_ptr<RayScene> scene;
    std::unique_ptr<EmbreeScene> embree;
    std::vector<std::array<float, 3>> directions;
    std::vector<float> lengths;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.job = name;
  job.size = size;
  job.who = "limit";
  job.prepare = [=]
  {
    if (state->scene)
    {
      return;
    }
    const Mesh& mesh = model(size).mesh;
    state->scene = std::make_unique<RayScene>(mesh);
    state->embree = std::make_unique<EmbreeScene>(*state->scene, RTC_BUILD_QUALITY_HIGH);
    const std::vector<Vector3> normals = vertexNormals(mesh), cone = coneDirections(rayCount, coneAngle);
    for (const Vector3& normal : normals)
    {
      const Eigen::Matrix3d frame = frameAround(-normal);
      for (const Vector3& d : cone)
      {
        const Eigen::Vector3f f = (frame * d).cast<float>();
        state->directions.push_back({ f[0], f[1], f[2] });
      }
    }
    state->lengths.resize(state->directions.size());
  };
  job.run = [=]
  {
    vtkSMPTools::For(0,
      static_cast<vtkIdType>(state->scene->points.size()),
      64,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType ray = rayCount * begin; ray < rayCount * end; ++ray)
        {
          state->lengths[ray] =
            state->embree->length(state->scene->points[ray / rayCount], state->directions[ray]);
        }
      });
  };
  job.figures = [=]
  {
    double sum = 0.0, hits = 0.0;
    for (const float length : state->lengths)
    {
      if (std::isfinite(length))
      {
        sum += length * state->scene->frame.scale;
        hits += 1.0;
      }
    }
    return std::map<std::string, double>{ { "mean ray", sum / hits } };
  };
  add(job);
}

void cgal(const std::string& size)
{
  using Surface = CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3>;
  struct State
  {
    Surface surface;
    Surface::Property_map<Surface::Face_index, double> values;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.job = "SDF Embree";
  job.size = size;
  job.who = "CGAL";
  job.threads = 1; // it has no parallel form
  job.prepare = [=]
  {
    if (state->surface.number_of_vertices() > 0)
    {
      return;
    }
    const Mesh& mesh = model(size).mesh;
    std::vector<Surface::Vertex_index> vertices;
    for (const Vector3& p : mesh.points)
    {
      vertices.push_back(state->surface.add_vertex({ p[0], p[1], p[2] }));
    }
    for (const Triangle& t : mesh.triangles)
    {
      state->surface.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    }
    state->values = state->surface.add_property_map<Surface::Face_index, double>("f:sdf").first;
  };
  job.run = [=]
  { CGAL::sdf_values(state->surface, state->values, coneAngle * std::acos(-1.0) / 180.0, rayCount, true); };
  add(job);
}

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    ours("SDF Embree", size, Backend::Host);
    raw("SDF Embree", size);
    ours("SDF OpenCL", size, Backend::OpenCL);
    raw("SDF OpenCL", size);
    if (size != "1M")
    {
      cgal(size);
    }
  }
}

} // namespace oversketch_bench
