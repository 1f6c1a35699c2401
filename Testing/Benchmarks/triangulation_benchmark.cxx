// The constrained Delaunay triangulation of 5,000 points, without constraints and with some 2,000: the edges
// of the triangulation of every seventh point. Beside it CGAL's, which takes both as ranges, and, without
// constraints, vtkDelaunay2D: with these it takes memory without end (VTK 9.1), since it is not exact. No two
// triangulations are right here, so edges that are not ours are counted. For Triangle, which peers.py runs,
// points, constraints and our edges go into the folder of OVERSKETCH_BENCHMARKS.
#include "benchmark_frame.h"

#include "Planar/delaunay.h"

#include "vtkCellArray.h"
#include "vtkDelaunay2D.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#ifdef OVERSKETCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>

namespace oversketch_bench
{

namespace
{

struct Points
{
  Polyline places;
  std::vector<Constraint> constraints;

  Points()
  {
    std::mt19937 random(5);
    std::set<std::pair<double, double>> ascending;
    const auto uniform = [&] { return (double(random()) + 0.5) / 4294967296.0; };
    while (ascending.size() < 5000)
    {
      const double x = uniform();
      ascending.emplace(x, uniform());
    }
    for (const auto& [x, y] : ascending)
    {
      this->places.emplace_back(x, y);
    }
    constexpr int each = 7;
    Polyline few;
    for (std::size_t i = 0; i < this->places.size(); i += each)
    {
      few.push_back(this->places[i]);
    }
    for (const DelaunayFace& face : constrainedDelaunay(few, {}, Context()))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = face.corners[k], b = face.corners[(k + 1) % 3];
        if (a < b)
        {
          this->constraints.push_back({ each * a, each * b, 0 });
        }
      }
    }
  }
};

const Points& points()
{
  static const Points made;
  return made;
}

using Edges = std::set<std::pair<int, int>>; // of each the lesser point first

void addEdge(Edges& edges, int a, int b)
{
  edges.emplace(std::min(a, b), std::max(a, b));
}

const std::vector<Constraint>& constraints(bool wanted)
{
  static const std::vector<Constraint> none;
  return wanted ? points().constraints : none;
}

const Edges& ourEdges(bool constrained)
{
  static Edges made[2];
  Edges& edges = made[constrained ? 1 : 0];
  if (edges.empty())
  {
    for (const DelaunayFace& face : constrainedDelaunay(points().places, constraints(constrained), Context()))
    {
      for (int k = 0; k < 3; ++k)
      {
        addEdge(edges, face.corners[k], face.corners[(k + 1) % 3]);
      }
    }
  }
  return edges;
}

// Edges of a peer's that are not ours, and of ours that are not the peer's.
double unlike(const Edges& theirs, bool constrained)
{
  const Edges& ours = ourEdges(constrained);
  const auto missing = [](const Edges& from, const Edges& in)
  { return std::count_if(from.begin(), from.end(), [&](const auto& edge) { return in.count(edge) == 0; }); };
  return static_cast<double>(missing(theirs, ours) + missing(ours, theirs));
}

// For the peer that runs in another program.
void write(bool constrained)
{
  const char* folder = std::getenv("OVERSKETCH_BENCHMARKS");
  if (!folder)
  {
    return;
  }
  const std::string path =
    std::string(folder) + (constrained ? "/constrained triangulation.plane" : "/triangulation.plane");
  FILE* file = std::fopen(path.c_str(), "w");
  for (std::size_t i = 0; file && i < points().places.size(); ++i)
  {
    std::fprintf(file, "point %.17g %.17g\n", points().places[i][0], points().places[i][1]);
  }
  for (std::size_t i = 0; file && i < constraints(constrained).size(); ++i)
  {
    std::fprintf(
      file, "constraint %d %d\n", constraints(constrained)[i].from, constraints(constrained)[i].to);
  }
  for (const auto& [a, b] : ourEdges(constrained))
  {
    if (file)
    {
      std::fprintf(file, "edge %d %d\n", a, b);
    }
  }
  if (!file || std::fclose(file) != 0)
  {
    std::fprintf(stderr, "Cannot write %s.\n", path.c_str());
    std::exit(1);
  }
}

Job side(const std::string& who,
  bool constrained,
  std::function<void()> run,
  const std::function<Edges()>& edges = {})
{
  Job job;
  job.job = constrained ? "constrained triangulation" : "triangulation";
  job.size = "5k";
  job.who = who;
  job.threads = 1;
  job.prepare = [] { points(); };
  job.run = std::move(run);
  job.figures = [constrained, edges]
  {
    std::map<std::string, double> figures{ { "constraints",
      static_cast<double>(constraints(constrained).size()) } };
    if (edges)
    {
      figures["edges_unlike_ours"] = unlike(edges(), constrained);
    }
    return figures;
  };
  return job;
}

#ifdef OVERSKETCH_CGAL
using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;

struct ByCgal
{
  CGAL::Constrained_Delaunay_triangulation_2<Exact> made;

  explicit ByCgal(bool constrained)
  {
    std::vector<Exact::Point_2> places;
    for (const Vector2& p : points().places)
    {
      places.emplace_back(p[0], p[1]);
    }
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (const Constraint& c : constraints(constrained))
    {
      edges.emplace_back(c.from, c.to);
    }
    if (constrained)
    {
      this->made.insert_constraints(places.begin(), places.end(), edges.begin(), edges.end());
    }
    else
    {
      this->made.insert(places.begin(), places.end());
    }
  }
  Edges edges() const
  {
    std::map<std::pair<double, double>, int> numbers;
    for (const Vector2& p : points().places)
    {
      numbers.emplace(std::pair(p[0], p[1]), static_cast<int>(numbers.size()));
    }
    Edges edges;
    for (const auto& [face, k] : this->made.finite_edges())
    {
      const Exact::Point_2 &a = face->vertex((k + 1) % 3)->point(), &b = face->vertex((k + 2) % 3)->point();
      addEdge(edges, numbers.at({ a.x(), a.y() }), numbers.at({ b.x(), b.y() }));
    }
    return edges;
  }
};
#endif

vtkSmartPointer<vtkPolyData> triangulatedByVtk()
{
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const Vector2& p : points().places)
  {
    places->InsertNextPoint(p[0], p[1], 0.0);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(places);
  vtkNew<vtkDelaunay2D> triangulation;
  triangulation->SetInputData(data);
  triangulation->Update();
  return triangulation->GetOutput();
}

Edges edgesByVtk()
{
  Edges edges;
  vtkNew<vtkIdList> ids;
  const vtkSmartPointer<vtkPolyData> made = triangulatedByVtk();
  for (vtkIdType cell = 0; cell < made->GetNumberOfCells(); ++cell)
  {
    made->GetCellPoints(cell, ids);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      addEdge(edges,
        static_cast<int>(ids->GetId(k)),
        static_cast<int>(ids->GetId((k + 1) % ids->GetNumberOfIds())));
    }
  }
  return edges;
}

} // namespace

void jobs()
{
  add(side(
    "VTK", false, [] { triangulatedByVtk(); }, edgesByVtk));
  for (const bool constrained : { false, true })
  {
    Job ours = side("ours",
      constrained,
      [constrained] { constrainedDelaunay(points().places, constraints(constrained), Context()); });
    ours.prepare = [constrained, done = false]() mutable
    {
      if (!std::exchange(done, true))
      {
        write(constrained);
      }
    };
    add(ours);
#ifdef OVERSKETCH_CGAL
    add(side(
      "CGAL",
      constrained,
      [constrained] { ByCgal made(constrained); },
      [constrained] { return ByCgal(constrained).edges(); }));
#endif
  }
}

} // namespace oversketch_bench
