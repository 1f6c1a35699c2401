// Refinement of a planar mesh by Loop's scheme, three levels, at equal counts, beside CGAL's and VTK's: ours
// whole, which shares the snap of features, lets no face turn over and hands back what it cannot keep from
// it, and ours without these three, which only puts the rim on its stroke. Free points are compared with
// CGAL's.
#include "benchmark_frame.h"

#include "Harness/refine_shapes.h"
#include "Planar/refine.h"

#include "vtkCellArray.h"
#include "vtkLoopSubdivisionFilter.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#ifdef OVERSKETCH_CGAL
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#endif

#include <algorithm>

namespace oversketch_bench
{

namespace
{

constexpr int cells = 24, levels = 3;

struct Sheet
{
  oversketch_test::CoarseDrawing drawing =
    oversketch_test::gridDrawing(cells, oversketch_test::Cells::Triangles, false, 3);
  vtkNew<vtkPolyData> forVtk;
  vtkNew<vtkLoopSubdivisionFilter> loop;
  PlanarMesh made;
#ifdef OVERSKETCH_CGAL
  using Peer = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Peer coarse, theirs;
#endif

  Sheet()
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const PlanarPoint& point : this->drawing.mesh.points)
    {
      points->InsertNextPoint(point.place[0], point.place[1], 0.0);
    }
    vtkNew<vtkCellArray> polys;
    for (const PlanarFace& face : this->drawing.mesh.faces)
    {
      const vtkIdType ids[3] = { face.corners[0], face.corners[1], face.corners[2] };
      polys->InsertNextCell(3, ids);
    }
    this->forVtk->SetPoints(points);
    this->forVtk->SetPolys(polys);
    this->loop->SetNumberOfSubdivisions(levels);
    this->loop->SetInputData(this->forVtk);
#ifdef OVERSKETCH_CGAL
    for (const PlanarPoint& point : this->drawing.mesh.points)
    {
      this->coarse.add_vertex({ point.place[0], point.place[1], 0.0 });
    }
    for (const PlanarFace& face : this->drawing.mesh.faces)
    {
      this->coarse.add_face(Peer::Vertex_index(static_cast<unsigned>(face.corners[0])),
        Peer::Vertex_index(static_cast<unsigned>(face.corners[1])),
        Peer::Vertex_index(static_cast<unsigned>(face.corners[2])));
    }
#endif
  }
};

Sheet& sheet()
{
  static Sheet made;
  return made;
}

void refineOurs(bool whole)
{
  PlanarRefineOptions options;
  options.levels = levels;
  if (!whole)
  {
    options.guard = false;
    options.snapShare = 0.0;
  }
  sheet().made = refinePlanar(sheet().drawing.mesh, sheet().drawing.strokes, options, Context()).mesh;
}

void side(const std::string& name,
  const std::string& who,
  const std::function<void()>& prepare,
  const std::function<void()>& run,
  const std::function<std::map<std::string, double>()>& figures)
{
  Job job;
  job.job = name;
  job.size = std::to_string(2 * cells * cells);
  job.who = who;
  job.threads = 1;
  job.prepare = prepare;
  job.run = run;
  job.figures = figures;
  add(job);
}

#ifdef OVERSKETCH_CGAL
void refineTheirs()
{
  sheet().theirs = sheet().coarse;
  CGAL::Subdivision_method_3::Loop_subdivision(
    sheet().theirs, CGAL::parameters::number_of_iterations(levels));
}

// Of points well inside, where no border rule reaches, how far ours are from the nearest of theirs, at most.
double apartFromTheirs()
{
  std::vector<Vector2> places;
  refineTheirs(); // whoever's turn was first
  for (const auto vertex : sheet().theirs.vertices())
  {
    const auto& p = sheet().theirs.point(vertex);
    places.emplace_back(p.x(), p.y());
  }
  const auto less = [](const Vector2& a, const Vector2& b) { return a[0] < b[0]; };
  std::sort(places.begin(), places.end(), less);
  Vector2 low = places.front(), high = places.front();
  for (const Vector2& p : places)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double margin = 3.0 * (high - low).maxCoeff() / cells, near = 1e-9;
  double worst = 0.0;
  for (const PlanarPoint& point : sheet().made.points)
  {
    const Vector2& p = point.place;
    if ((p - low).minCoeff() < margin || (high - p).minCoeff() < margin)
    {
      continue;
    }
    double nearest = near;
    for (auto at = std::lower_bound(places.begin(), places.end(), Vector2(p[0] - near, 0.0), less);
         at != places.end() && (*at)[0] <= p[0] + near;
         ++at)
    {
      nearest = std::min(nearest, (*at - p).norm());
    }
    worst = std::max(worst, nearest);
  }
  return worst;
}
#endif

} // namespace

void jobs()
{
  for (const bool whole : { true, false })
  {
    const std::string name = whole ? "refinement" : "refinement, Loop alone";
    side(
      name,
      "ours",
      [] { sheet(); },
      [whole] { refineOurs(whole); },
      []
      {
        std::map<std::string, double> figures{ { "triangles",
          static_cast<double>(sheet().made.faces.size()) } };
#ifdef OVERSKETCH_CGAL
        figures["apart_from_cgal"] = apartFromTheirs();
#endif
        return figures;
      });
    side(
      name,
      "VTK",
      [] { sheet().forVtk->Modified(); },
      [] { sheet().loop->Update(); },
      []
      {
        return std::map<std::string, double>{ { "triangles",
          static_cast<double>(sheet().loop->GetOutput()->GetNumberOfPolys()) } };
      });
#ifdef OVERSKETCH_CGAL
    side(
      name,
      "CGAL",
      [] { sheet(); },
      [] { refineTheirs(); },
      []
      {
        return std::map<std::string, double>{ { "triangles",
          static_cast<double>(sheet().theirs.number_of_faces()) } };
      });
#endif
  }
}

} // namespace oversketch_bench
