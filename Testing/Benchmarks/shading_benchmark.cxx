// A region's grey model: the balanced disc beside plain harmonic maps, from the ring's release to weights and
// images, and a layer that is dragged. The region is a cap of a sphere of 328k triangles.
#include "benchmark_frame.h"

#include "vtkOversketchDistanceField.h"
#include "vtkOversketchFlatten.h"
#include "vtkOversketchShadingLevels.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"
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

// Vertices of the region above a height, of a sphere of 163,842.
struct Region
{
  Mesh sphere, patch;
  vtkNew<vtkPolyData> mesh, curve;
  vtkSmartPointer<vtkOversketchFlatten> flatten;
  vtkSmartPointer<vtkOversketchDistanceField> field;
  vtkSmartPointer<vtkOversketchShadingLevels> levels;
  int drags = 0;

  explicit Region(double height)
    : sphere(oversketch_test::icosphere(7))
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
    this->layCurve(0.6 * std::sqrt(1.0 - height * height));
  }

  // Over the pole, from -reach to reach in x.
  void layCurve(double reach)
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

  void anew()
  {
    this->flatten = vtkSmartPointer<vtkOversketchFlatten>::New();
    this->field = vtkSmartPointer<vtkOversketchDistanceField>::New();
    this->levels = vtkSmartPointer<vtkOversketchShadingLevels>::New();
    this->flatten->SetInputData(this->mesh);
    this->flatten->SetReferenceData(this->curve);
    this->field->SetInputConnection(this->flatten->GetOutputPort());
    this->field->SetReferenceData(this->curve);
    this->levels->SetInputConnection(this->field->GetOutputPort());
    this->levels->SetDiscConnection(this->flatten->GetOutputPort(1));
  }
  void shaded()
  {
    if (!this->levels)
    {
      this->anew();
      this->levels->Update();
    }
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
    one = std::make_unique<Region>(size == "10k" ? 0.878 : 0.39);
  }
  return *one;
}

// The plain harmonic map to a circle with Eigen's own factorisation.
void harmonicByEigen(const Mesh& patch)
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
  if (!disc.allFinite())
  {
    std::abort();
  }
}

#ifdef OVERSKETCH_CGAL
void harmonicByCgal(const Mesh& patch)
{
  namespace Maps = CGAL::Surface_mesh_parameterization;
  using Kernel = CGAL::Simple_cartesian<double>;
  using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
  Surface mesh;
  for (const Vector3& p : patch.points)
  {
    mesh.add_vertex({ p[0], p[1], p[2] });
  }
  for (const Triangle& t : patch.triangles)
  {
    mesh.add_face(Surface::Vertex_index(t[0]), Surface::Vertex_index(t[1]), Surface::Vertex_index(t[2]));
  }
  const auto border = std::find_if(mesh.halfedges().begin(),
    mesh.halfedges().end(),
    [&](Surface::Halfedge_index h) { return mesh.is_border(h); });
  const auto uv = mesh.add_property_map<Surface::Vertex_index, Kernel::Point_2>("v:uv").first;
  const Maps::Error_code code =
    Maps::parameterize(mesh, Maps::Discrete_conformal_map_parameterizer_3<Surface>(), *border, uv);
  if (code != Maps::OK)
  {
    std::abort();
  }
}
#endif

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
  made.threads = who == "ours" || who == "unbalanced" ? 2 : 1;
  made.prepare = [size, prepare = std::move(prepare)] { prepare(region(size)); };
  made.run = [size, run = std::move(run)] { run(region(size)); };
  return made;
}

} // namespace

void jobs()
{
  const auto nothing = [](Region&) {};
  for (const std::string& size : { std::string("10k"), std::string("50k") })
  {
    const auto limit = [size](double small, double large)
    {
      return [size, value = size == "10k" ? small : large]
      {
        return std::map<std::string, double>{ { "limit_ms", value },
          { "vertices", static_cast<double>(region(size).patch.vertexCount()) } };
      };
    };
    add(side("disc", size, "ours", nothing, [](Region& r) { flattened(r.patch, ThreadsOnly()); }));
    add(side("disc", size, "unbalanced", nothing, [](Region& r) { flattened(r.patch, ThreadsOnly(), 0); }));
    add(side("disc", size, "Eigen", nothing, [](Region& r) { harmonicByEigen(r.patch); }));
#ifdef OVERSKETCH_CGAL
    add(side("disc", size, "CGAL", nothing, [](Region& r) { harmonicByCgal(r.patch); }));
#endif
    // Without laying the ring into the mesh and enclosing, which are other steps.
    Job model = side(
      "grey model", size, "ours", [](Region& r) { r.anew(); }, [](Region& r) { r.levels->Update(); });
    model.figures = limit(150.0, 900.0);
    add(model);
    Job layer = side(
      "layer drag", size, "ours", [](Region& r) { r.shaded(); }, [](Region& r) { r.drag(); });
    layer.figures = limit(1.0, 4.0);
    add(layer);
  }
}

} // namespace oversketch_bench
