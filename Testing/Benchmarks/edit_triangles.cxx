// New triangles after an edit: a line over the sphere's pole, dragged outward by the half width of its
// region. Beside it CGAL's isotropic remeshing of the dragged region, in as many rounds, to an edge length
// that gives as many faces.
#include "edit_jobs.h"

#include "Harness/polydata.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchRetriangulate.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#ifdef OVERSKETCH_CGAL
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <set>

namespace oversketch_bench
{

namespace
{

using Figures = std::map<std::string, double>;
using Corners = std::array<double, 9>;

Corners cornersOf(const Mesh& mesh, int triangle)
{
  const Triangle& t = mesh.triangles[triangle];
  const int first = static_cast<int>(std::min_element(t.begin(), t.end()) - t.begin());
  Corners corners{};
  for (int k = 0; k < 3; ++k)
  {
    std::copy_n(mesh.points[t[(first + k) % 3]].data(), 3, corners.begin() + 3 * k);
  }
  return corners;
}

// The smallest angle of each triangle: the fifth percentile, and that of all [degrees].
Figures anglesOf(const Mesh& mesh)
{
  std::vector<double> smallest;
  for (const Triangle& t : mesh.triangles)
  {
    double least = 180.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = mesh.points[t[(k + 1) % 3]] - mesh.points[t[k]];
      const Vector3 b = mesh.points[t[(k + 2) % 3]] - mesh.points[t[k]];
      least = std::min(least, std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / oversketch_test::pi);
    }
    smallest.push_back(least);
  }
  std::sort(smallest.begin(), smallest.end());
  return { { "faces", static_cast<double>(smallest.size()) },
    { "angle_p5", smallest[smallest.size() / 20] },
    { "angle_least", smallest.front() } };
}

// The triangles with a vertex inside the region, with points of their own.
Mesh regionOf(vtkPolyData* polyData)
{
  const Mesh mesh = MeshOf(polyData);
  vtkDataArray* labels = polyData->GetPointData()->GetArray("EditRegion");
  std::vector<int> number(mesh.points.size(), -1);
  Mesh region;
  for (const Triangle& t : mesh.triangles)
  {
    if (std::any_of(t.begin(), t.end(), [&](int v) { return labels->GetComponent(v, 0) == 2.0; }))
    {
      Triangle& mine = region.triangles.emplace_back();
      for (int k = 0; k < 3; ++k)
      {
        if (number[t[k]] < 0)
        {
          number[t[k]] = region.vertexCount();
          region.points.push_back(mesh.points[t[k]]);
        }
        mine[k] = number[t[k]];
      }
    }
  }
  return region;
}

struct Dragged
{
  vtkNew<vtkOversketchEdit> system;
  vtkSmartPointer<vtkOversketchRetriangulate> ours;
  Mesh before, after; // regions, the edit's and with our triangles

  explicit Dragged(const std::string& size)
  {
    const double height = regionHeight(size);
    this->system->SetInputData(0, oversketch_test::toPolyData(sphereOfRegions()));
    this->system->SetReferenceData(oversketch_test::toStroke(lineFromAbove(height), viewFromAbove()));
    this->system->SetBoundaryData(oversketch_test::toStroke(ringFromAbove(height), viewFromAbove()));
    this->system->SetRuleToOff();
    this->system->SetOperations(("move 0.5 n " + std::to_string(std::sqrt(1.0 - height * height))).c_str());
    this->system->Update();
    this->before = regionOf(this->system->GetInnerOutput("Deform"));
    this->anew();
    this->ours->Update();
    this->after = regionOf(this->ours->GetOutput());
  }
  void anew()
  {
    this->ours = vtkSmartPointer<vtkOversketchRetriangulate>::New();
    this->ours->SetInputData(0, this->system->GetInnerOutput("Deform"));
    vtkAlgorithm* insert = this->system->GetStep("BoundaryInsert");
    this->ours->SetBoundaryData(vtkPolyData::SafeDownCast(insert->GetOutputDataObject(1)));
    this->ours->SetReferenceData(vtkPolyData::SafeDownCast(insert->GetOutputDataObject(2)));
    this->ours->SetRestData(this->system->GetInnerOutput("Shading"));
  }
  Figures figures() const
  {
    std::set<Corners> known;
    for (int t = 0; t < this->before.triangleCount(); ++t)
    {
      known.insert(cornersOf(this->before, t));
    }
    int made = 0;
    for (int t = 0; t < this->after.triangleCount(); ++t)
    {
      made += known.count(cornersOf(this->after, t)) == 0;
    }
    Figures found = anglesOf(this->after);
    found["faces_before"] = this->before.triangleCount();
    found["faces_made"] = made;
    found["limit_ms"] = 10.0 * made / 1000.0;
    return found;
  }
};

Dragged& dragged(const std::string& size)
{
  static std::map<std::string, std::unique_ptr<Dragged>> made;
  std::unique_ptr<Dragged>& one = made[size];
  if (!one)
  {
    one = std::make_unique<Dragged>(size);
  }
  return *one;
}

#ifdef OVERSKETCH_CGAL
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

struct Isotropic
{
  SurfaceMesh input, output;
  double length = 0.0;

  explicit Isotropic(const Dragged& edit)
  {
    double area = 0.0;
    for (const Vector3& p : edit.before.points)
    {
      this->input.add_vertex({ p[0], p[1], p[2] });
    }
    for (const Triangle& t : edit.before.triangles)
    {
      using Vertex = SurfaceMesh::Vertex_index;
      this->input.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]));
      const Vector3& o = edit.before.points[t[0]];
      area += 0.5 * (edit.before.points[t[1]] - o).cross(edit.before.points[t[2]] - o).norm();
    }
    // Of equilateral ones first; then as the faces ask.
    const double faces = edit.after.triangleCount();
    this->length = std::sqrt(area / faces * 4.0 / std::sqrt(3.0));
    for (int round = 0; round < 6; ++round)
    {
      this->output = this->input;
      this->run();
      const double ratio = static_cast<double>(this->output.number_of_faces()) / faces;
      if (std::abs(ratio - 1.0) < 0.02)
      {
        return;
      }
      this->length *= std::sqrt(ratio);
    }
  }
  void run()
  {
    CGAL::Polygon_mesh_processing::isotropic_remeshing(this->output.faces(),
      this->length,
      this->output,
      CGAL::parameters::number_of_iterations(3)); // as many as ours has
  }
  Mesh result() const
  {
    SurfaceMesh packed = this->output;
    packed.collect_garbage();
    Mesh mesh;
    for (const auto v : packed.vertices())
    {
      const Kernel::Point_3& p = packed.point(v);
      mesh.points.emplace_back(p.x(), p.y(), p.z());
    }
    for (const auto f : packed.faces())
    {
      Triangle& t = mesh.triangles.emplace_back();
      int k = 0;
      for (const auto v : CGAL::vertices_around_face(packed.halfedge(f), packed))
      {
        t[k++] = static_cast<int>(v);
      }
    }
    return mesh;
  }
};
#endif

} // namespace

void addTriangles()
{
  for (const std::string& size : { std::string("10k"), std::string("50k") })
  {
    Job job;
    job.job = "new triangles";
    job.size = size;
    job.who = "ours";
    job.prepare = [size] { dragged(size).anew(); };
    job.run = [size] { dragged(size).ours->Update(); };
    job.figures = [size] { return dragged(size).figures(); };
    add(job);
#ifdef OVERSKETCH_CGAL
    auto peer = std::make_shared<std::unique_ptr<Isotropic>>();
    job.who = "CGAL";
    job.threads = 1;
    job.prepare = [=]
    {
      if (!*peer)
      {
        *peer = std::make_unique<Isotropic>(dragged(size));
      }
      (*peer)->output = (*peer)->input;
    };
    job.run = [=] { (*peer)->run(); };
    job.figures = [=] { return anglesOf((*peer)->result()); };
    add(job);
#endif
  }
}

} // namespace oversketch_bench
