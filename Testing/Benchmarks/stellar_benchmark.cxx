// System D: what its 4-8 mesh costs (splits, its arrays to and fro, the base), a stroke whole and changed,
// and the crest under the pen, each beside its limit; and beside what else there is: CGAL's edge splits,
// vtkAdaptiveSubdivisionFilter to the same edge length, rays through vtkStaticCellLocator.
#include "surface_stroke.h"

#include "Ray/surface_rays.h"
#include "Stellar/leaves.h"
#include "Stellar/pairing.h"
#include "Stellar/refine.h"
#include "vtkOversketchAugment.h"
#include "vtkOversketchStellarBase.h"
#include "vtkOversketchStellarRefine.h"
#include "vtkOversketchSurfaceStroke.h"

#include "vtkAdaptiveSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkStaticCellLocator.h"

#ifdef OVERSKETCH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace oversketch_bench
{

namespace
{

using Figures = std::map<std::string, double>;

void expectMesh(vtkPolyData* mesh)
{
  if (mesh->GetNumberOfPolys() == 0)
  {
    std::fprintf(stderr, "No mesh was made.\n");
    std::exit(1);
  }
}

// The forest of a model's base, once.
struct Stellar
{
  explicit Stellar(const std::string& size)
    : base(pairTriangles(model(size).mesh, {}, Context()).forest)
  {
  }
  Forest base;
  Forest forest; // that a run works on
  Leaves leaves;
};

std::shared_ptr<Stellar>& stellar(const std::string& size)
{
  static std::map<std::string, std::shared_ptr<Stellar>> all;
  auto& one = all[size];
  if (!one)
  {
    one = std::make_shared<Stellar>(size);
  }
  return one;
}

void kernels(const std::string& size)
{
  const double triangles = static_cast<double>(model(size).mesh.triangles.size());
  const auto each = [](double ns, double count) { return 1e-6 * ns * count; };
  // Every base face's refinement edge is split once. Room for the new ones is there, as it is for CGAL's.
  Job job;
  job.size = size;
  job.who = "ours";
  job.threads = 1;
  job.job = "edge splits";
  job.prepare = [=]
  { stellar(size)->forest = stellar(size)->base.roomyCopy(stellar(size)->base.faces.size()); };
  job.run = [=]
  {
    Forest& forest = stellar(size)->forest;
    const int count = static_cast<int>(stellar(size)->base.faces.size());
    for (int f = 0; f < count; ++f)
    {
      if (forest.faces[f].path == 1)
      {
        forest.refine(f, {});
      }
    }
  };
  job.figures = [=]
  {
    const Stellar& s = *stellar(size);
    const auto splits = static_cast<double>(s.forest.vertices.size() - s.base.vertices.size());
    const auto bytes =
      static_cast<double>(sizeof(Forest::Face) * (s.forest.faces.size() - s.base.faces.size()) +
                          sizeof(Forest::Vertex) * (s.forest.vertices.size() - s.base.vertices.size()));
    return Figures{
      { "splits", splits }, { "bytes_a_split", bytes / splits }, { "limit_ms", each(100, splits) }
    };
  };
  add(job);

  job.job = "4-8 mesh from arrays";
  job.prepare = [=]
  {
    Stellar& s = *stellar(size);
    if (s.leaves.points.empty())
    {
      s.leaves = emit(s.base);
    }
  };
  job.run = [=] { stellar(size)->forest = rebuild(stellar(size)->leaves, Context()); };
  job.figures = [=] { return Figures{ { "limit_ms", each(150, triangles) } }; };
  add(job);
  job.job = "4-8 mesh to arrays";
  job.prepare = [=] { stellar(size); };
  job.run = [=] { stellar(size)->leaves = emit(stellar(size)->base); };
  job.figures = [=] { return Figures{ { "limit_ms", each(60, triangles) } }; };
  add(job);
  job.job = "4-8 base";
  job.prepare = [=] { model(size); };
  job.run = [=] { stellar(size)->forest = pairTriangles(model(size).mesh, {}, Context()).forest; };
  job.figures = [=] { return Figures{ { "limit_ms", each(1000, triangles) } }; };
  add(job);
}

#ifdef OVERSKETCH_CGAL
// As many edges as ours, each split and its two triangles with it.
void cgalSplits(const std::string& size)
{
  using Surface = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  struct State
  {
    Surface whole, mesh;
    std::vector<Surface::Edge_index> edges;
  };
  auto state = std::make_shared<State>();
  Job job;
  job.size = size;
  job.who = "CGAL Surface_mesh";
  job.threads = 1;
  job.job = "edge splits";
  job.prepare = [=]
  {
    if (state->whole.is_empty())
    {
      const Mesh& mesh = model(size).mesh;
      std::vector<Surface::Vertex_index> vertices;
      for (const Vector3& p : mesh.points)
      {
        vertices.push_back(state->whole.add_vertex({ p[0], p[1], p[2] }));
      }
      for (const Triangle& t : mesh.triangles)
      {
        state->whole.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
      }
      // A triangle's edge each, no triangle twice: pairs as ours has them.
      std::vector<bool> taken(state->whole.number_of_faces());
      for (const Surface::Edge_index e : state->whole.edges())
      {
        const auto f = state->whole.face(state->whole.halfedge(e, 0)),
                   g = state->whole.face(state->whole.halfedge(e, 1));
        if (f.is_valid() && g.is_valid() && !taken[f] && !taken[g])
        {
          taken[f] = taken[g] = true;
          state->edges.push_back(e);
        }
      }
    }
    state->mesh = state->whole;
    const auto n = static_cast<Surface::size_type>(state->edges.size());
    state->mesh.reserve(state->mesh.number_of_vertices() + n,
      state->mesh.number_of_edges() + 3 * n,
      state->mesh.number_of_faces() + 2 * n);
  };
  job.run = [=]
  {
    Surface& mesh = state->mesh;
    for (const Surface::Edge_index e : state->edges)
    {
      const auto old = mesh.halfedge(e);
      const auto &a = mesh.point(mesh.source(old)), &c = mesh.point(mesh.target(old));
      const Surface::Point middle((a.x() + c.x()) / 2, (a.y() + c.y()) / 2, (a.z() + c.z()) / 2);
      const auto opposite = mesh.opposite(old);
      const auto made = CGAL::Euler::split_edge(old, mesh); // ends in the new vertex, before `old`
      mesh.point(mesh.target(made)) = middle;
      CGAL::Euler::split_face(made, mesh.next(old), mesh);
      CGAL::Euler::split_face(opposite, mesh.next(mesh.next(opposite)), mesh);
    }
  };
  job.figures = [=] { return Figures{ { "splits", static_cast<double>(state->edges.size()) } }; };
  add(job);
}
#endif

// The whole model until no edge is longer than half its mean.
void subdivision(const std::string& size)
{
  struct State
  {
    double length = 0.0;
    vtkNew<vtkOversketchStellarBase> base;
    vtkNew<vtkPolyData> curve;
    vtkSmartPointer<vtkOversketchStellarRefine> ours;
    vtkSmartPointer<vtkAdaptiveSubdivisionFilter> peer;
  };
  auto state = std::make_shared<State>();
  const auto open = [=]
  {
    if (state->length > 0.0)
    {
      return;
    }
    const Mesh& mesh = model(size).mesh;
    for (const Triangle& t : mesh.triangles)
    {
      state->length += 0.5 * (mesh.points[t[1]] - mesh.points[t[0]]).norm();
    }
    state->length /= static_cast<double>(mesh.triangles.size());
    state->base->SetInputData(model(size).polyData);
    state->base->Update();
    vtkNew<vtkOversketchSurfaceStroke> curves;
    curves->SetInputData(0, surfaceStroke());
    curves->SetInputData(1, model(size).polyData);
    curves->Update();
    state->curve->ShallowCopy(curves->GetOutput());
  };
  Job job;
  job.job = "refined all over";
  job.size = size;
  job.who = "ours";
  job.prepare = [=]
  {
    open();
    state->ours = vtkSmartPointer<vtkOversketchStellarRefine>::New();
    state->ours->SetInputData(0, state->base->GetOutput());
    state->ours->SetCurvesData(state->curve);
    state->ours->SetRadius(2.0);
    state->ours->SetTargetEdgeLength(state->length);
  };
  job.run = [=] { state->ours->Update(); };
  job.figures = [=]
  {
    expectMesh(state->ours->GetOutput());
    return Figures{ { "triangles", static_cast<double>(state->ours->GetOutput()->GetNumberOfPolys()) } };
  };
  add(job);
  job.who = "vtkAdaptiveSubdivisionFilter";
  job.threads = 1;
  job.prepare = [=]
  {
    open();
    state->peer = vtkSmartPointer<vtkAdaptiveSubdivisionFilter>::New();
    state->peer->SetInputData(model(size).polyData);
    state->peer->SetMaximumEdgeLength(state->length);
    state->peer->SetMaximumTriangleArea(1e9);
  };
  job.run = [=] { state->peer->Update(); };
  job.figures = [=] {
    return Figures{ { "triangles", static_cast<double>(state->peer->GetOutput()->GetNumberOfPolys()) } };
  };
  add(job);
}

// 1,000 rays from the eye; both sides find the same triangles.
void rays(const std::string& size)
{
  struct State
  {
    std::unique_ptr<SurfaceRays> ours;
    vtkNew<vtkStaticCellLocator> peer;
    int met = 0;
  };
  auto state = std::make_shared<State>();
  const auto origin = [](int i) { return Vector3(0.3 * std::cos(i), 0.3 * std::sin(1.7 * i), 2.0); };
  Job job;
  job.job = "1,000 rays";
  job.size = size;
  job.who = "ours";
  job.threads = 1;
  job.prepare = [=]
  {
    if (!state->ours)
    {
      state->ours = std::make_unique<SurfaceRays>(std::make_shared<const Mesh>(model(size).mesh));
    }
    state->met = 0;
  };
  job.run = [=]
  {
    for (int i = 0; i < 1000; ++i)
    {
      state->met += state->ours->nearest({ origin(i), -Vector3::UnitZ() }).found();
    }
  };
  job.figures = [=] { return Figures{ { "met", state->met } }; };
  add(job);
  job.who = "vtkStaticCellLocator";
  job.prepare = [=]
  {
    if (!state->peer->GetDataSet())
    {
      state->peer->SetDataSet(model(size).polyData);
      state->peer->BuildLocator();
    }
    state->met = 0;
  };
  job.run = [=]
  {
    for (int i = 0; i < 1000; ++i)
    {
      const Vector3 p = origin(i), q = p - 4.0 * Vector3::UnitZ();
      double t, x[3], weights[3];
      int sub;
      vtkIdType cell;
      state->met += state->peer->IntersectWithLine(p.data(), q.data(), 0.0, t, x, weights, sub, cell) != 0;
    }
  };
  add(job);
}

// The system: two strokes, radii, heights in turn over one mesh, so that nothing is kept.
struct Session
{
  void open(const std::string& size)
  {
    if (!this->system)
    {
      this->mesh = model(size).polyData;
      this->system = vtkSmartPointer<vtkOversketchAugment>::New();
      this->system->SetInputData(0, this->mesh);
      this->strokes = { surfaceStroke(), surfaceStroke(12.0) };
      this->system->SetStrokesData(this->strokes[0]);
      this->system->Update();
    }
    ++this->turn;
  }
  void run() const
  {
    this->system->Update();
    expectMesh(this->system->GetOutput());
  }
  Figures figures(const std::string& size, const std::map<std::string, double>& limits) const
  {
    Figures found;
    for (int i = 0; i < this->system->GetNumberOfStages(); ++i)
    {
      const char* stage = this->system->GetStage(i);
      found[std::string(stage) + "_ms"] = 1000.0 * this->system->GetStageTime(stage);
    }
    found["triangles"] = static_cast<double>(this->system->GetOutput()->GetNumberOfPolys());
    if (const auto limit = limits.find(size); limit != limits.end())
    {
      found["limit_ms"] = limit->second;
    }
    // Of refining, snapping and displacing, which are the paper's three stages.
    const double three = found["Refine_ms"] + found["Snap_ms"] + found["Displace_ms"];
    if (found["Snap_ms"] > 0.0)
    {
      found["snap_share"] = found["Snap_ms"] / three;
    }
    return found;
  }
  vtkSmartPointer<vtkPolyData> mesh;
  vtkSmartPointer<vtkOversketchAugment> system;
  std::array<vtkSmartPointer<vtkPolyData>, 2> strokes;
  vtkNew<vtkPolyData> crest;
  int turn = 0;
};

void session(const std::string& size)
{
  const auto add = [&size](const char* name,
                     const std::map<std::string, double>& limits,
                     const std::function<void(Session&)>& change)
  {
    auto state = std::make_shared<Session>();
    Job job;
    job.job = name;
    job.size = size;
    job.who = "ours";
    job.prepare = [=]
    {
      state->open(size);
      change(*state);
    };
    job.run = [=] { state->run(); };
    job.figures = [=] { return state->figures(size, limits); };
    oversketch_bench::add(job);
  };
  add("augment: new stroke",
    { { "30k", 30 }, { "180k", 120 }, { "1M", 700 } },
    [](Session& s) { s.system->SetStrokesData(s.strokes[s.turn % 2]); });
  add("augment: new radius",
    { { "30k", 20 }, { "180k", 90 } },
    [](Session& s) { s.system->SetRadius(s.turn % 2 ? 0.028 : 0.03); });
  add("augment: new height",
    { { "30k", 2 }, { "180k", 10 } },
    [](Session& s) { s.system->SetHeight(s.turn % 2 ? 0.012 : 0.015); });
  auto state = std::make_shared<Session>();
  Job job;
  job.job = "augment: crest under the pen";
  job.size = size;
  job.who = "ours";
  job.prepare = [=] { state->open(size); };
  job.run = [=]
  {
    if (!state->system->PreviewCrest(state->mesh, state->strokes[state->turn % 2], state->crest))
    {
      std::fprintf(stderr, "No crest.\n");
      std::exit(1);
    }
  };
  job.figures = [] { return Figures{ { "limit_ms", 1 } }; };
  oversketch_bench::add(job);
}

} // namespace

void jobs()
{
  for (const std::string& size : sizes({ "5k", "30k", "180k", "1M" }))
  {
    kernels(size);
#ifdef OVERSKETCH_CGAL
    cgalSplits(size);
#endif
    rays(size);
    session(size);
  }
  for (const std::string& size : sizes({ "5k", "30k", "180k" }))
  {
    subdivision(size);
  }
}

} // namespace oversketch_bench
