// The constrained Delaunay triangulation of 5,000 points, without constraints and with some 2,000: the edges
// of the triangulation of every seventh point. Beside it CGAL's, which takes both as ranges, and, without
// constraints, vtkDelaunay2D: with these it takes memory without end (VTK 9.1), since it is not exact.
#include "benchmark_frame.h"

#include "Planar/delaunay.h"

#include "vtkDelaunay2D.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#ifdef OVERSKETCH_CGAL
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#endif

#include <cstdio>
#include <random>
#include <set>

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

Job side(const std::string& who, bool constrained, std::function<void()> run)
{
  Job job;
  job.job = constrained ? "constrained triangulation" : "triangulation";
  job.size = "5k";
  job.who = who;
  job.threads = 1;
  job.prepare = [] { points(); };
  job.run = std::move(run);
  job.figures = [constrained]
  {
    return std::map<std::string, double>{ { "constraints",
      constrained ? static_cast<double>(points().constraints.size()) : 0.0 } };
  };
  return job;
}

#ifdef OVERSKETCH_CGAL
void triangulateTheirs(bool constrained)
{
  using Exact = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Exact::Point_2> places;
  for (const Vector2& p : points().places)
  {
    places.emplace_back(p[0], p[1]);
  }
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for (const Constraint& c : points().constraints)
  {
    edges.emplace_back(c.from, c.to);
  }
  CGAL::Constrained_Delaunay_triangulation_2<Exact> triangulation;
  if (constrained)
  {
    triangulation.insert_constraints(places.begin(), places.end(), edges.begin(), edges.end());
  }
  else
  {
    triangulation.insert(places.begin(), places.end());
  }
  if (triangulation.number_of_vertices() != places.size())
  {
    std::fprintf(stderr, "CGAL's triangulation went astray.\n");
  }
}
#endif

void triangulateByVtk()
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
}

} // namespace

void jobs()
{
  add(side("VTK", false, triangulateByVtk));
  for (const bool constrained : { false, true })
  {
    add(side("ours",
      constrained,
      [constrained]
      {
        constrainedDelaunay(
          points().places, constrained ? points().constraints : std::vector<Constraint>(), Context());
      }));
#ifdef OVERSKETCH_CGAL
    add(side("CGAL", constrained, [constrained] { triangulateTheirs(constrained); }));
#endif
  }
}

} // namespace oversketch_bench
