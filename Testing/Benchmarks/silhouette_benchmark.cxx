// The silhouette after a camera move, mesh and filter kept. Limit: one plain pass over the signs of all faces
// and one over all edges, which writes the edges' vertices and no polydata. The reach is twice that, and a
// hundredth of vtkPolyDataSilhouette.
#include "Harness/polydata.h"
#include "benchmark_frame.h"

#include "vtkOversketchSilhouette.h"

#include "vtkCamera.h"
#include "vtkPolyDataSilhouette.h"

#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

using oversketch_test::perspectiveView;
using oversketch_test::toStroke;

// An eye that goes round the model, a step a call.
struct Orbit
{
  double angle = 0.0;
  Vector3 next()
  {
    this->angle += 0.05;
    return { 2.0 * std::cos(this->angle), 0.3, 2.0 * std::sin(this->angle) };
  }
};

std::function<std::map<std::string, double>()> lines(const std::function<double()>& count)
{
  return [count] { return std::map<std::string, double>{ { "segments", count() } }; };
}

void ours(const std::string& size)
{
  struct State
  {
    Orbit orbit;
    vtkSmartPointer<vtkOversketchSilhouette> filter;
  };
  auto state = std::make_shared<State>();
  const auto look = [state]
  {
    state->filter->SetStrokeData(
      toStroke({ { 0, 0 }, { 1, 1 } }, perspectiveView(state->orbit.next(), { 0, 1, 0 }, 30.0)));
  };
  Job job;
  job.job = "silhouette";
  job.size = size;
  job.who = "ours";
  job.threads = 1;
  job.prepare = [=]
  {
    if (!state->filter)
    {
      state->filter = vtkSmartPointer<vtkOversketchSilhouette>::New();
      state->filter->SetInputData(0, model(size).polyData);
      look(); // what depends on the mesh alone is made for the first view
      state->filter->Update();
    }
    look();
  };
  job.run = [state] { state->filter->Update(); };
  job.figures = lines(
    [state]
    {
      return state->filter->GetOutput()->GetLines()->GetNumberOfConnectivityIds() -
             state->filter->GetOutput()->GetNumberOfLines();
    });
  add(job);
}

void peer(const std::string& size)
{
  struct State
  {
    Orbit orbit;
    vtkNew<vtkCamera> camera;
    vtkSmartPointer<vtkPolyDataSilhouette> filter;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.job = "silhouette";
  job.size = size;
  job.who = "vtkPolyDataSilhouette";
  job.threads = 1;
  job.prepare = [=]
  {
    if (!state->filter)
    {
      state->filter = vtkSmartPointer<vtkPolyDataSilhouette>::New();
      state->filter->SetInputData(model(size).polyData);
      state->filter->SetCamera(state->camera);
      state->filter->SetEnableFeatureAngle(0);
      state->filter->BorderEdgesOff();
      state->camera->SetPosition(state->orbit.next().data());
      state->filter->Update();
    }
    state->camera->SetPosition(state->orbit.next().data());
  };
  job.run = [state] { state->filter->Update(); };
  job.figures = lines([state] { return state->filter->GetOutput()->GetNumberOfLines(); });
  add(job);
}

void limit(const std::string& size)
{
  struct Edge
  {
    int v0, v1, left, right;
  };
  struct State
  {
    Orbit orbit;
    Vector3 eye;
    std::vector<std::array<float, 4>> planes; // of the faces
    std::vector<Edge> edges;
    std::vector<char> front;
    std::vector<std::array<int, 2>> found; // as long as there are edges
    std::size_t count = 0;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.job = "silhouette";
  job.size = size;
  job.who = "limit";
  job.threads = 1;
  job.prepare = [=]
  {
    if (state->planes.empty())
    {
      const Mesh& mesh = model(size).mesh;
      for (int t = 0; t < mesh.triangleCount(); ++t)
      {
        const Vector3 n = facetNormal(mesh, t);
        const double offset = -n.dot(mesh.points[mesh.triangles[t][0]]);
        state->planes.push_back({ static_cast<float>(n[0]),
          static_cast<float>(n[1]),
          static_cast<float>(n[2]),
          static_cast<float>(offset) });
      }
      const Adjacency adjacency = buildAdjacency(mesh);
      for (const MeshEdge& edge : adjacency.edges)
      {
        const int* sides = adjacency.edgeTriangles.data() + edge.firstTriangle;
        state->edges.push_back({ edge.v0, edge.v1, sides[0], sides[edge.triangleCount - 1] });
      }
      state->front.resize(state->planes.size());
      state->found.resize(state->edges.size());
    }
    state->eye = state->orbit.next();
  };
  job.run = [state]
  {
    const float x = static_cast<float>(state->eye[0]), y = static_cast<float>(state->eye[1]),
                z = static_cast<float>(state->eye[2]);
    for (std::size_t f = 0; f < state->planes.size(); ++f)
    {
      const auto& plane = state->planes[f];
      state->front[f] = plane[0] * x + plane[1] * y + plane[2] * z + plane[3] > 0.0f;
    }
    std::size_t count = 0;
    for (const Edge& edge : state->edges)
    {
      state->found[count] = { edge.v0, edge.v1 };
      count += state->front[edge.left] != state->front[edge.right];
    }
    state->count = count;
  };
  job.figures = lines([state] { return static_cast<double>(state->count); });
  add(job);
}

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    ours(size);
    peer(size);
    limit(size);
  }
}

} // namespace oversketch_bench
