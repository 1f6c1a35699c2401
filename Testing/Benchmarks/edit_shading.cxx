// A region's grey model: the balanced disc beside plain harmonic maps, distances beside the heat method, from
// the ring's release to weights and images, and a layer that is dragged. The region is a cap of a sphere of
// 328k triangles, on which distances are known.
#include "edit_jobs.h"

#include "vtkOversketchDistanceField.h"
#include "vtkOversketchEdit.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchShadingLevels.h"

#include "Harness/polydata.h"
#include "Mesh/context.h"
#include "Shading/fields.h"
#include "Shading/flatten.h"
#include "vtkOversketchFilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"

#include <Eigen/Sparse>

#ifdef OVERSKETCH_CGAL
#define CGAL_EIGEN3_ENABLED // whose solver it takes
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace oversketch_bench
{

namespace
{

// The region above a height of the sphere.
struct Region
{
  const Mesh& sphere = sphereOfRegions();
  Mesh patch;
  std::vector<int> chain; // the reference curve, by vertices of the patch
  vtkNew<vtkPolyData> mesh, curve;
  vtkSmartPointer<vtkOversketchFlatten> flatten;
  vtkSmartPointer<vtkOversketchDistanceField> field;
  vtkSmartPointer<vtkOversketchShadingLevels> levels;
  int drags = 0;

  explicit Region(double height)
  {
    const auto within = [&](int v) { return this->sphere.points[v][2] > height; };
    std::vector<unsigned char> faces, labels(this->sphere.points.size(), 2);
    std::vector<int> number(this->sphere.points.size(), -1);
    for (const Triangle& t : this->sphere.triangles)
    {
      const bool inside = within(t[0]) && within(t[1]) && within(t[2]);
      faces.push_back(inside ? 2 : 0);
      Triangle mine{};
      for (int k = 0; k < 3; ++k)
      {
        if (inside && number[t[k]] < 0)
        {
          number[t[k]] = this->patch.vertexCount();
          this->patch.points.push_back(this->sphere.points[t[k]]);
        }
        mine[k] = number[t[k]];
        labels[t[k]] = inside ? labels[t[k]] : 1;
      }
      if (inside)
      {
        this->patch.triangles.push_back(mine);
      }
    }
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkUnsignedCharArray> pointLabels, cellLabels;
    for (vtkUnsignedCharArray* array : { pointLabels.Get(), cellLabels.Get() })
    {
      array->SetName("EditRegion");
    }
    vtkNew<vtkCellArray> triangles;
    for (std::size_t v = 0; v < labels.size(); ++v)
    {
      points->InsertNextPoint(this->sphere.points[v].data());
      pointLabels->InsertNextValue(labels[v]);
    }
    for (std::size_t t = 0; t < faces.size(); ++t)
    {
      const Triangle& c = this->sphere.triangles[t];
      const vtkIdType corners[3] = { c[0], c[1], c[2] };
      triangles->InsertNextCell(3, corners);
      cellLabels->InsertNextValue(faces[t]);
    }
    this->mesh->SetPoints(points);
    this->mesh->SetPolys(triangles);
    this->mesh->GetPointData()->AddArray(pointLabels);
    this->mesh->GetCellData()->AddArray(cellLabels);
    this->layCurve(0.6 * std::sqrt(1.0 - height * height), number);
  }

  // Over the pole, from -reach to reach in x.
  void layCurve(double reach, const std::vector<int>& number)
  {
    const Adjacency adjacency = buildAdjacency(this->sphere);
    const auto nearest = [&](double x)
    {
      const Vector3 place(x, 0.0, std::sqrt(1.0 - x * x));
      return static_cast<int>(std::min_element(this->sphere.points.begin(),
                                this->sphere.points.end(),
                                [&](const Vector3& a, const Vector3& b)
                                { return (a - place).squaredNorm() < (b - place).squaredNorm(); }) -
                              this->sphere.points.begin());
    };
    const int end = nearest(reach);
    const std::vector<double> far = edgeDistances(this->sphere, adjacency, { end });
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkIdTypeArray> ids;
    ids->SetName("VertexId");
    for (int v = nearest(-reach);;)
    {
      points->InsertNextPoint(this->sphere.points[v].data());
      ids->InsertNextValue(v);
      this->chain.push_back(number[v]);
      if (v == end)
      {
        break;
      }
      v = *std::min_element(adjacency.vertexVertices.begin(v),
        adjacency.vertexVertices.end(v),
        [&](int a, int b) { return far[a] < far[b]; });
    }
    lines->InsertNextCell(static_cast<int>(points->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      lines->InsertCellPoint(i);
    }
    this->curve->SetPoints(points);
    this->curve->SetLines(lines);
    this->curve->GetPointData()->AddArray(ids);
  }

  void shaded()
  {
    if (this->levels)
    {
      return;
    }
    this->flatten = vtkSmartPointer<vtkOversketchFlatten>::New();
    this->field = vtkSmartPointer<vtkOversketchDistanceField>::New();
    this->levels = vtkSmartPointer<vtkOversketchShadingLevels>::New();
    this->flatten->SetInputData(this->mesh);
    this->flatten->SetReferenceData(this->curve);
    this->field->SetInputConnection(this->flatten->GetOutputPort());
    this->field->SetReferenceData(this->curve);
    this->levels->SetInputConnection(this->field->GetOutputPort());
    this->levels->SetDiscConnection(this->flatten->GetOutputPort(1));
    this->levels->Update();
  }
  void drag()
  {
    const std::string text = "handle 0.5 " + std::to_string(0.3 + 0.001 * (++this->drags % 400));
    this->levels->SetLayers(text.c_str());
    this->levels->Update();
  }
};

Region& region(const std::string& size)
{
  static std::map<std::string, std::unique_ptr<Region>> made;
  std::unique_ptr<Region>& one = made[size];
  if (!one)
  {
    one = std::make_unique<Region>(regionHeight(size));
  }
  return *one;
}

// The plain harmonic map to a circle with Eigen's own factorisation.
std::vector<Vector2> harmonicByEigen(const Mesh& patch)
{
  const Adjacency adjacency = buildAdjacency(patch);
  const std::vector<double> weights = positiveWeights(patch, adjacency);
  const std::vector<int> border = discBorder(patch, adjacency);
  std::vector<int> number(patch.points.size(), 0);
  for (const int v : border)
  {
    number[v] = -1;
  }
  int count = 0;
  for (int& n : number)
  {
    n = n < 0 ? n : count++;
  }
  Eigen::MatrixX2d fixed = Eigen::MatrixX2d::Zero(patch.vertexCount(), 2),
                   side = Eigen::MatrixX2d::Zero(count, 2);
  for (std::size_t i = 0; i < border.size(); ++i)
  {
    const double angle =
      2.0 * oversketch_test::pi * static_cast<double>(i) / static_cast<double>(border.size());
    fixed.row(border[i]) << std::cos(angle), std::sin(angle);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < weights.size(); ++e)
  {
    const std::array<int, 2> ends{ adjacency.edges[e].v0, adjacency.edges[e].v1 };
    for (int k = 0; k < 2; ++k)
    {
      const int a = number[ends[k]], b = number[ends[1 - k]];
      if (a >= 0)
      {
        entries.emplace_back(a, a, weights[e]);
        if (b >= 0)
        {
          entries.emplace_back(a, b, -weights[e]);
        }
        else
        {
          side.row(a) += weights[e] * fixed.row(ends[1 - k]);
        }
      }
    }
  }
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
  const Eigen::MatrixX2d disc = factor.solve(side);
  std::vector<Vector2> places;
  places.reserve(patch.vertexCount());
  for (int v = 0; v < patch.vertexCount(); ++v)
  {
    places.emplace_back(number[v] < 0 ? Vector2(fixed.row(v)) : Vector2(disc.row(number[v])));
  }
  return places;
}

// Triangles of the disc that are turned over, and how unevenly it shares its area out: by triangles, their
// share of the disc over that of the surface, the 95th percentile over the 5th.
std::map<std::string, double> discFigures(const Mesh& patch, const std::vector<Vector2>& disc)
{
  std::map<std::string, double> figures{ { "turned_over", 0.0 },
    { "vertices", static_cast<double>(patch.vertexCount()) } };
  std::vector<double> shares;
  for (const Triangle& t : patch.triangles)
  {
    const Vector2 a = disc[t[1]] - disc[t[0]], b = disc[t[2]] - disc[t[0]];
    const double flat = a[0] * b[1] - a[1] * b[0];
    figures["turned_over"] += flat <= 0.0;
    const Vector3& origin = patch.points[t[0]];
    shares.push_back(flat / (patch.points[t[1]] - origin).cross(patch.points[t[2]] - origin).norm());
  }
  std::sort(shares.begin(), shares.end());
  figures["area_p95_p5"] = shares[shares.size() * 95 / 100] / shares[shares.size() * 5 / 100];
  return figures;
}

// How far off vertices' distances from the curve are, as a share, where they are at least a tenth of the
// unit: the exact ones are those to arcs of the sphere over the curve's edges.
std::map<std::string, double> distanceFigures(const Region& r, const std::vector<double>& distances)
{
  double sum = 0.0, most = 0.0;
  int count = 0;
  for (int v = 0; v < r.patch.vertexCount(); ++v)
  {
    const Vector3 p = r.patch.points[v].normalized();
    double least = HUGE_VAL;
    for (std::size_t i = 1; i < r.chain.size(); ++i)
    {
      const Vector3 a = r.patch.points[r.chain[i - 1]], b = r.patch.points[r.chain[i]];
      const Vector3 across = a.cross(b).normalized();
      const bool beside = across.cross(a).dot(p) >= 0.0 && b.cross(across).dot(p) >= 0.0;
      const double away =
        beside ? std::abs(std::asin(std::clamp(across.dot(p), -1.0, 1.0)))
               : std::min(std::acos(std::min(1.0, a.dot(p))), std::acos(std::min(1.0, b.dot(p))));
      least = std::min(least, away);
    }
    if (least >= 0.1)
    {
      const double off = std::abs(distances[v] - least) / least;
      sum += off;
      most = std::max(most, off);
      ++count;
    }
  }
  return { { "mean_off_percent", 100.0 * sum / count }, { "most_off_percent", 100.0 * most } };
}

std::vector<double> distancesByUs(const Region& r)
{
  return chainDistances(r.patch, buildAdjacency(r.patch), r.chain, false, false, ThreadsOnly()).distance;
}

#ifdef OVERSKETCH_CGAL
using CgalKernel = CGAL::Simple_cartesian<double>;
using CgalSurface = CGAL::Surface_mesh<CgalKernel::Point_3>;

CgalSurface cgalSurface(const Mesh& patch)
{
  CgalSurface mesh;
  for (const Vector3& p : patch.points)
  {
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  for (const Triangle& t : patch.triangles)
  {
    mesh.add_face(
      CgalSurface::Vertex_index(t[0]), CgalSurface::Vertex_index(t[1]), CgalSurface::Vertex_index(t[2]));
  }
  return mesh;
}

const CgalSurface& cgalSurfaceOf(const std::string& size)
{
  static std::map<std::string, CgalSurface> made;
  const auto found = made.find(size);
  return found != made.end() ? found->second
                             : made.emplace(size, cgalSurface(region(size).patch)).first->second;
}

std::vector<Vector2> harmonicByCgal(const CgalSurface& surface)
{
  namespace Maps = CGAL::Surface_mesh_parameterization;
  CgalSurface mesh = surface;
  const auto border = std::find_if(mesh.halfedges().begin(),
    mesh.halfedges().end(),
    [&](CgalSurface::Halfedge_index h) { return mesh.is_border(h); });
  const auto uv = mesh.add_property_map<CgalSurface::Vertex_index, CgalKernel::Point_2>("v:uv").first;
  const Maps::Error_code code =
    Maps::parameterize(mesh, Maps::Discrete_conformal_map_parameterizer_3<CgalSurface>(), *border, uv);
  if (code != Maps::OK)
  {
    std::abort();
  }
  std::vector<Vector2> disc;
  for (const auto v : mesh.vertices())
  {
    disc.emplace_back(uv[v].x(), uv[v].y());
  }
  return disc;
}

// From nothing, as a region is a new one: two factors and two solutions.
std::vector<double> distancesByHeat(const CgalSurface& mesh, const std::vector<int>& chain)
{
  CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<CgalSurface, CGAL::Heat_method_3::Direct> heat(mesh);
  const std::vector<CgalSurface::Vertex_index> sources(chain.begin(), chain.end());
  heat.add_sources(sources);
  std::vector<double> distances(mesh.number_of_vertices());
  heat.estimate_geodesic_distances(
    boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)));
  return distances;
}
#endif

// The whole edit from the ring on, with a line that has been drawn: the ring into the mesh, the region, its
// disc and distances, weights and images.
struct RingReleased
{
  vtkNew<vtkOversketchEdit> system;
  vtkSmartPointer<vtkPolyData> sphere;
  double height;
  int rings = 0;

  explicit RingReleased(double at)
    : sphere(oversketch_test::toPolyData(sphereOfRegions()))
    , height(at)
  {
    this->system->SetInputData(0, this->sphere);
    this->system->SetReferenceData(oversketch_test::toStroke(lineFromAbove(at), viewFromAbove()));
    this->draw();
    this->system->Update(); // the line is in the mesh, and rays have been cast at it
  }
  void draw()
  {
    const double other = this->height + 1e-4 * (++this->rings % 7);
    this->system->SetBoundaryData(oversketch_test::toStroke(ringFromAbove(other), viewFromAbove()));
  }
  std::map<std::string, double> figures() const
  {
    std::map<std::string, double> figures;
    for (const char* stage :
      { "BoundaryProject", "BoundaryInsert", "Enclose", "Flatten", "Distance", "Shading", "Deform" })
    {
      figures[std::string(stage) + "_ms"] = 1000.0 * this->system->GetStageTime(stage);
    }
    vtkPolyData* region = this->system->GetInnerOutput("Shading");
    const double* weights =
      static_cast<double*>(region->GetPointData()->GetArray("EditWeight")->GetVoidPointer(0));
    figures["vertices"] = static_cast<double>(
      std::count_if(weights, weights + region->GetNumberOfPoints(), [](double w) { return w > 0.0; }));
    return figures;
  }
};

RingReleased& ringReleased(const std::string& size)
{
  static std::map<std::string, std::unique_ptr<RingReleased>> made;
  std::unique_ptr<RingReleased>& one = made[size];
  if (!one)
  {
    one = std::make_unique<RingReleased>(regionHeight(size));
  }
  return *one;
}

Job side(const std::string& job,
  const std::string& size,
  const std::string& who,
  std::function<void(Region&)> prepare,
  std::function<void(Region&)> run)
{
  Job made;
  made.job = job;
  made.size = size;
  made.who = who;
  made.threads = who.rfind("ours", 0) == 0 ? 2 : 1;
  made.prepare = [size, prepare = std::move(prepare)] { prepare(region(size)); };
  made.run = [size, run = std::move(run)] { run(region(size)); };
  return made;
}

} // namespace

void addShading()
{
  const auto nothing = [](Region&) {};
  for (const std::string& size : { std::string("10k"), std::string("50k") })
  {
    const auto disc = [&](const char* who, const std::function<std::vector<Vector2>(Region&)>& make)
    {
      Job job = side("disc", size, who, nothing, [=](Region& r) { make(r); });
      job.figures = [=] { return discFigures(region(size).patch, make(region(size))); };
      add(job);
    };
    disc("ours", [](Region& r) { return flattened(r.patch, ThreadsOnly()); });
    disc("ours, unbalanced", [](Region& r) { return flattened(r.patch, ThreadsOnly(), 0); });
    disc("Eigen", [](Region& r) { return harmonicByEigen(r.patch); });

    const auto distance = [&](const char* who,
                            const std::function<void(Region&)>& prepare,
                            const std::function<std::vector<double>(Region&)>& make)
    {
      Job job = side("distance", size, who, prepare, [=](Region& r) { make(r); });
      job.figures = [=] { return distanceFigures(region(size), make(region(size))); };
      add(job);
    };
    distance("ours", nothing, distancesByUs);
#ifdef OVERSKETCH_CGAL
    disc("CGAL", [size](Region&) { return harmonicByCgal(cgalSurfaceOf(size)); });
    distance(
      "CGAL's heat method",
      [size](Region&) { cgalSurfaceOf(size); },
      [size](Region& r) { return distancesByHeat(cgalSurfaceOf(size), r.chain); });
#endif

    Job model =
      side("grey model", size, "ours", nothing, [size](Region&) { ringReleased(size).system->Update(); });
    model.prepare = [size] { ringReleased(size).draw(); };
    model.figures = [size]
    {
      std::map<std::string, double> figures = ringReleased(size).figures();
      figures["limit_ms"] = size == "10k" ? 150.0 : 900.0;
      return figures;
    };
    add(model);
    Job layer = side(
      "layer drag", size, "ours", [](Region& r) { r.shaded(); }, [](Region& r) { r.drag(); });
    layer.figures = [size] {
      return std::map<std::string, double>{ { "limit_ms", size == "10k" ? 1.0 : 4.0 } };
    };
    add(layer);
  }
}

} // namespace oversketch_bench
