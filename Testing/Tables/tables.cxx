// Tables 1 to 3 of system A's paper, its figures and ours in the same columns, the narrow-triangle shares of
// its Fig. 11, and Table I of system D's. Run by Testing/Tables/tables.sh; prints Markdown. Times are
// medians: a shared machine makes means useless.
#include "augment_table.h"

#include "Harness/polydata.h"

#include "Mixture/mixture.h"
#include "OpenCL/device.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchLaplacianDeform.h"
#include "vtkOversketchRemesh.h"
#include "vtkOversketchShapeDiameter.h"

#include "vtkIdTypeArray.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace oversketch_test;

namespace
{

double median(int runs, const std::function<void()>& job)
{
  std::vector<double> times;
  for (int i = 0; i < runs; ++i)
  {
    const auto start = std::chrono::steady_clock::now();
    job();
    times.push_back(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[runs / 2];
}

vtkSmartPointer<vtkPolyData> read(const std::string& path)
{
  vtkSmartPointer<vtkAbstractPolyDataReader> reader;
  if (path.substr(path.size() - 3) == "obj")
  {
    reader = vtkSmartPointer<vtkOBJReader>::New();
  }
  else
  {
    reader = vtkSmartPointer<vtkPLYReader>::New();
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  auto mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(reader->GetOutput()->GetPoints());
  mesh->SetPolys(reader->GetOutput()->GetPolys());
  return mesh;
}

struct Bunny
{
  const char* name;
  const char* file;
  double table1[2], table2[2], table3[3]; // the paper's
};

const Bunny bunnies[] = {
  { "Lo-Res (5k)", "bunny_5k.obj", { 56.5, 34.2 }, { 250, 9.51 }, { 28.3, 3.71, 2.24 } },
  { "Mid-Res (30k)", "bunny_30k.ply", { 558, 261 }, { 241, 9.04 }, { 146, 35.0, 19.4 } },
  { "Hi-Res (180k)", "bunny_180k.ply", { 4930, 2040 }, { 261, 12.0 }, { 2410, 364, 161 } },
};

std::vector<double> shapeDiameters(vtkPolyData* mesh)
{
  vtkNew<vtkOversketchShapeDiameter> sdf;
  sdf->SetInputData(mesh);
  sdf->Update();
  vtkDataArray* array = sdf->GetOutput()->GetPointData()->GetArray("ShapeDiameter");
  std::vector<double> values;
  double range[2];
  array->GetRange(range);
  for (int i : drawWithoutReplacement(static_cast<int>(array->GetNumberOfTuples()), 2048, 1))
  {
    values.push_back((array->GetComponent(i, 0) - range[0]) / (range[1] - range[0]));
  }
  return values;
}

void table1(const std::string& folder)
{
  std::printf("\n## Table 1: rays of the shape diameter [ms]\n\n"
              "| model | paper CPU | paper GPU | ours Embree | ours OpenCL |\n|---|---|---|---|---|\n");
  for (const Bunny& bunny : bunnies)
  {
    auto mesh = read(folder + bunny.file);
    double ms[2];
    for (const bool opencl : { false, true })
    {
      vtkNew<vtkOversketchShapeDiameter> sdf;
      opencl ? sdf->SetBackendToOpenCL() : sdf->SetBackendToHost();
      sdf->SetInputData(mesh);
      sdf->Update(); // the first run compiles the kernels
      ms[opencl] = median(5,
        [&]
        {
          mesh->GetPoints()->Modified();
          sdf->Update();
        });
    }
    std::printf(
      "| %s | %.1f | %.1f | %.1f | %.1f |\n", bunny.name, bunny.table1[0], bunny.table1[1], ms[0], ms[1]);
  }
}

void table2(const std::string& folder)
{
  std::printf("\n## Table 2: greedy EM, 4 components, 2048 samples [ms]\n\n"
              "| samples | paper CPU | paper GPU | ours host | ours OpenCL |\n|---|---|---|---|---|\n");
  const auto row = [](const char* name, const double paper[2], const std::vector<double>& samples)
  {
    const double host = median(15, [&] { fitMixture(samples, {}); });
    const auto device = Device::instance();
    if (device)
    {
      fitMixtureOnDevice(*device, samples, {});
      std::printf("| %s | %.0f | %.2f | %.2f | %.2f |\n",
        name,
        paper[0],
        paper[1],
        host,
        median(15, [&] { fitMixtureOnDevice(*device, samples, {}); }));
    }
    else
    {
      std::printf("| %s | %.0f | %.2f | %.2f | no device |\n", name, paper[0], paper[1], host);
    }
  };
  std::mt19937 generator(1);
  std::vector<double> uniform(2048);
  for (double& x : uniform)
  {
    x = static_cast<double>(generator()) / 4294967296.0;
  }
  const double paper[2] = { 356, 23.6 };
  row("Uniform random in [0, 1]", paper, uniform);
  for (const Bunny& bunny : bunnies)
  {
    row(bunny.name, bunny.table2, shapeDiameters(read(folder + bunny.file)));
  }
}

// The highest 20 % of the bunny (its head and ears) as region, the highest 30 vertices pulled up by a tenth
// of its size.
struct Pull
{
  explicit Pull(vtkPolyData* input)
  {
    this->mesh->ShallowCopy(input);
    const int count = static_cast<int>(input->GetNumberOfPoints());
    std::vector<std::pair<double, int>> heights;
    for (int i = 0; i < count; ++i)
    {
      double p[3];
      input->GetPoint(i, p);
      heights.emplace_back(-p[1], i);
    }
    std::sort(heights.begin(), heights.end());
    vtkNew<vtkUnsignedCharArray> region;
    region->SetName("Region");
    region->SetNumberOfTuples(count);
    region->FillComponent(0, 0);
    for (int i = 0; i < count / 5; ++i)
    {
      region->SetValue(heights[i].second, 1);
    }
    this->mesh->GetPointData()->AddArray(region);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> verts;
    vtkNew<vtkIdTypeArray> vertices, ids;
    vertices->SetName("MeshVertices");
    vertices->SetNumberOfComponents(3);
    ids->SetName("HandleId");
    vtkNew<vtkDoubleArray> weights, targets, relative;
    weights->SetName("MeshWeights");
    weights->SetNumberOfComponents(3);
    targets->SetName("Target");
    targets->SetNumberOfComponents(3);
    relative->SetName("RelativePosition");
    const double size = input->GetLength();
    for (int i = 0; i < 30; ++i)
    {
      const vtkIdType v = heights[i].second;
      double p[3];
      input->GetPoint(v, p);
      const vtkIdType point = points->InsertNextPoint(p);
      verts->InsertNextCell(1, &point);
      vertices->InsertNextTuple3(static_cast<double>(v), static_cast<double>(v), static_cast<double>(v));
      weights->InsertNextTuple3(1, 0, 0);
      targets->InsertNextTuple3(p[0], p[1] + 0.1 * size, p[2]);
      ids->InsertNextValue(i);
      relative->InsertNextValue(i / 29.0);
    }
    this->handles->SetPoints(points);
    this->handles->SetVerts(verts);
    for (vtkDataArray* array :
      std::initializer_list<vtkDataArray*>{ vertices, weights, targets, ids, relative })
    {
      this->handles->GetPointData()->AddArray(array);
    }
    // The pull lengthens what lies between border and handles by about this ratio.
    for (const auto& [name, value] :
      { std::pair<const char*, double>{ "SectionLength", 1.0 }, { "TargetLength", 1.4 } })
    {
      vtkNew<vtkDoubleArray> length;
      length->SetName(name);
      length->InsertNextValue(value);
      this->handles->GetFieldData()->AddArray(length);
    }
  }
  vtkNew<vtkPolyData> mesh, handles;
};

void table3(const std::string& folder)
{
  std::printf("\n## Table 3: Laplacian deformation of 20 %% of the bunny, 30 control points [ms]\n\n"
              "Ours: build and factor and solve, cold. Again: other targets, same section and region.\n\n"
              "| model | paper AdjNorm | paper single | paper multi "
              "| ours AdjNorm | ours, 1 thread | ours, all threads | ours, again |\n"
              "|---|---|---|---|---|---|---|---|\n");
  for (const Bunny& bunny : bunnies)
  {
    Pull pull(read(folder + bunny.file));
    double ms[3];
    for (int form = 0; form < 3; ++form)
    {
      vtkSMPTools::Initialize(form == 1 ? 1 : 0);
      ms[form] = median(3,
        [&]
        {
          vtkNew<vtkOversketchLaplacianDeform> deform;
          deform->SetAdjustNormals(form == 0);
          deform->SetInputData(0, pull.mesh);
          deform->SetInputData(1, pull.handles);
          deform->Update();
        });
    }
    vtkNew<vtkOversketchLaplacianDeform> kept;
    kept->SetInputData(0, pull.mesh);
    kept->SetInputData(1, pull.handles);
    kept->Update();
    auto* targets = vtkDoubleArray::SafeDownCast(pull.handles->GetPointData()->GetArray("Target"));
    const double again = median(7,
      [&]
      {
        targets->SetComponent(0, 1, targets->GetComponent(0, 1) * 1.001);
        targets->Modified();
        pull.handles->Modified();
        kept->Update();
      });
    std::printf("| %s | %.1f | %.2f | %.2f | %.1f | %.1f | %.1f | %.2f |\n",
      bunny.name,
      bunny.table3[0],
      bunny.table3[1],
      bunny.table3[2],
      ms[0],
      ms[1],
      ms[2],
      again);
  }
}

double narrowShare(vtkPolyData* mesh)
{
  vtkDataArray* region = mesh->GetPointData()->GetArray("Region");
  const Mesh m = MeshOf(mesh);
  int all = 0, bad = 0;
  for (const Triangle& t : m.triangles)
  {
    if (region->GetComponent(t[0], 0) == 0 || region->GetComponent(t[1], 0) == 0 ||
        region->GetComponent(t[2], 0) == 0)
    {
      continue;
    }
    ++all;
    for (int k = 0; k < 3; ++k)
    {
      const Vector3 a = (m.points[t[(k + 1) % 3]] - m.points[t[k]]).normalized();
      const Vector3 b = (m.points[t[(k + 2) % 3]] - m.points[t[k]]).normalized();
      if (a.dot(b) > std::cos(pi / 6.0))
      {
        ++bad;
        break;
      }
    }
  }
  return 100.0 * bad / std::max(all, 1);
}

void figure11(const std::string& folder)
{
  std::printf("\n## Fig. 11: triangles with an angle under 30 degrees, share of the region [%%]\n\n"
              "| model | before | deformed without remeshing | deformed, remeshed before "
              "| remeshed before and after |\n|---|---|---|---|---|\n");
  for (const Bunny& bunny : bunnies)
  {
    Pull pull(read(folder + bunny.file));
    vtkNew<vtkOversketchLaplacianDeform> plain, between;
    plain->SetInputData(0, pull.mesh);
    plain->SetInputData(1, pull.handles);
    plain->Update();
    vtkNew<vtkOversketchRemesh> stretch, restore;
    // The remesher keeps its triangles smaller than what they lie on is thick.
    vtkNew<vtkOversketchShapeDiameter> sdf;
    sdf->SetInputData(pull.mesh);
    stretch->SetStageToStretch();
    stretch->SetInputConnection(0, sdf->GetOutputPort());
    stretch->SetInputData(1, pull.handles);
    between->SetInputConnection(0, stretch->GetOutputPort(0));
    between->SetInputConnection(1, stretch->GetOutputPort(1));
    restore->SetStageToRestore();
    restore->SetInputConnection(0, between->GetOutputPort());
    restore->Update();
    if (restore->GetOutput()->GetNumberOfPolys() == 0)
    {
      std::exit(1); // the filter has said why
    }
    std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n",
      bunny.name,
      narrowShare(pull.mesh),
      narrowShare(plain->GetOutput()),
      narrowShare(between->GetOutput()),
      narrowShare(restore->GetOutput()));
  }
}

} // namespace

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::fprintf(
      stderr, "usage: oversketch_tables FOLDER (with bunny_5k.obj, bunny_30k.ply, bunny_180k.ply)\n");
    return 2;
  }
  const std::string folder = std::string(argv[1]) + "/";
  table1(folder);
  table2(folder);
  table3(folder);
  figure11(folder);
  std::vector<std::pair<const char*, vtkSmartPointer<vtkPolyData>>> models;
  for (const Bunny& bunny : bunnies)
  {
    models.emplace_back(bunny.file, read(folder + bunny.file));
  }
  augmentTable(models);
  return 0;
}
