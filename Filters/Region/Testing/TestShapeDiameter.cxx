#include "Harness/data.h"
#include "Harness/polydata.h"
#include "Ray/shape_diameter.h"
#include "vtkOversketchShapeDiameter.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkFloatArray.h"
#include "vtkOBJReader.h"
#include "vtkPLYReader.h"
#include "vtkSMPTools.h"
#include "vtkSTLReader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

using Filter = vtkOversketchShapeDiameter;

vtkDataArray* arrayOf(Filter* filter)
{
  return filter->GetOutput()->GetPointData()->GetArray("ShapeDiameter");
}

std::vector<double> valuesOf(Filter* filter)
{
  std::vector<double> values;
  vtkDataArray* array = arrayOf(filter);
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    values.push_back(array->GetComponent(i, 0));
  }
  return values;
}

std::vector<double> diameters(vtkPolyData* mesh, int backend, double angle = 60.0, bool inverse = false)
{
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->SetBackend(backend);
  filter->SetConeAngle(angle);
  filter->SetInverseAngleWeights(inverse);
  filter->Update();
  EXPECT_EQ(filter->GetTracedRayCount(), 32 * mesh->GetNumberOfPoints());
  if (backend == Filter::BACKEND_EMBREE || Device::instance())
  {
    EXPECT_EQ(filter->GetBackendUsed(), backend);
  }
  return valuesOf(filter);
}

const int backends[] = { Filter::BACKEND_OPENCL, Filter::BACKEND_EMBREE };

// All rays of a mesh, before their summary.
std::vector<ConeHit> coneHits(const Mesh& mesh, const std::vector<Vector3>& normals, double angle)
{
  ShapeDiameterOptions options;
  options.coneAngle = angle;
  std::vector<ConeHit> hits;
  computeShapeDiameter(mesh, buildAdjacency(mesh), normals, options, Context(), &hits);
  return hits;
}

// Weighted mean length of the rays of the vertices that are chosen, all of which must have hit.
template <typename Chosen>
double meanLength(const Mesh& mesh,
  const std::vector<ConeHit>& hits,
  const std::vector<double>& weights,
  const Chosen& chosen,
  double* worst = nullptr,
  double expected = 0.0)
{
  double total = 0.0;
  int vertices = 0;
  for (int v = 0; v < mesh.vertexCount(); ++v)
  {
    if (chosen(mesh.points[v]))
    {
      double sum = 0.0, weight = 0.0;
      for (int k = 0; k < 32; ++k)
      {
        EXPECT_GE(hits[32 * v + k].triangle, 0);
        sum += weights[k] * hits[32 * v + k].length;
        weight += weights[k];
      }
      total += sum / weight;
      ++vertices;
      if (worst)
      {
        *worst = std::max(*worst, std::abs(sum / weight / expected - 1.0));
      }
    }
  }
  EXPECT_GT(vertices, 0);
  return total / vertices;
}

std::vector<double> inverseAngles(double angle)
{
  std::vector<double> weights;
  for (const Vector3& d : coneDirections(32, angle))
  {
    weights.push_back(1.0 / std::acos(d[2]));
  }
  return weights;
}

// A closed slab of thickness h around z = 0, its sides far away, a grid of n x n on top and bottom.
Mesh slab(double half, double h, int n)
{
  Mesh mesh = gridSurface(n,
    n,
    false,
    false,
    [=](double u, double v) { return Vector3(half * (2 * u - 1), half * (2 * v - 1), h / 2); });
  const int top = mesh.vertexCount();
  for (int i = 0; i < top; ++i)
  {
    mesh.points.emplace_back(mesh.points[i][0], mesh.points[i][1], -h / 2);
  }
  const int triangles = mesh.triangleCount();
  for (int i = 0; i < triangles; ++i)
  {
    const Triangle t = mesh.triangles[i];
    mesh.triangles.push_back({ t[0] + top, t[2] + top, t[1] + top });
  }
  return mesh;
}

// A mesh of any of the formats of the shared data, null where it is absent.
vtkSmartPointer<vtkPolyData> read(const std::string& name)
{
  const std::string path = sharedData("meshes/" + name);
  if (path.empty())
  {
    return nullptr;
  }
  const auto with = [&](auto reader)
  {
    reader->SetFileName(path.c_str());
    reader->Update();
    return vtkSmartPointer<vtkPolyData>(reader->GetOutput());
  };
  const std::string ending = path.substr(path.size() - 3);
  return ending == "obj"   ? with(vtkSmartPointer<vtkOBJReader>::New())
         : ending == "ply" ? with(vtkSmartPointer<vtkPLYReader>::New())
         : ending == "stl" ? with(vtkSmartPointer<vtkSTLReader>::New())
                           : nullptr;
}

// Sees no OpenCL device while it lives.
struct NoDevice
{
  NoDevice() { setenv("OVERSKETCH_OPENCL", "off", 1); }
  ~NoDevice() { unsetenv("OVERSKETCH_OPENCL"); }
};

std::string text(double x)
{
  std::ostringstream stream;
  stream << x;
  return stream.str();
}

} // namespace

TEST(A6_1, MeanRayInALongCylinderIsTwoRadii)
{
  const double R = 0.7, length = 12.0 * R;
  const Mesh mesh = cylinder(R, length, 360, 60);
  std::vector<Vector3> normals;
  for (const Vector3& p : mesh.points)
  {
    normals.push_back(Vector3(p[0], p[1], 0.0).normalized());
  }
  const auto middle = [&](const Vector3& p) { return p[2] > 3.5 * R && p[2] < length - 3.5 * R; };
  double worst60 = 0.0;
  const double at60 =
    meanLength(mesh, coneHits(mesh, normals, 60.0), std::vector<double>(32, 1.0), middle, &worst60, 2.0 * R);
  EXPECT_NEAR(at60 / R, 2.0, 0.006);
  EXPECT_LT(worst60, 0.004); // a single vertex's cone may be turned unfavourably
  // Any cone, any weights that depend on the angle alone; wider cones and uneven weights are sampled more
  // coarsely.
  double worst120 = 0.0, worstWeighted = 0.0;
  meanLength(mesh, coneHits(mesh, normals, 120.0), std::vector<double>(32, 1.0), middle, &worst120, 2.0 * R);
  meanLength(mesh, coneHits(mesh, normals, 60.0), inverseAngles(60.0), middle, &worstWeighted, 2.0 * R);
  EXPECT_LT(worst120, 0.03);
  EXPECT_LT(worstWeighted, 0.02);
  fact("A6_1",
    "cylinder, 60 degrees, 32 rays: mean ray " + text(at60 / R) + " R, worst vertex " + text(100 * worst60) +
      " % off; 120 degrees " + text(100 * worst120) + " %, inverse-angle weights " +
      text(100 * worstWeighted) + " %");
}

TEST(A6_2, SphereAndSlabPinTheFullOpening)
{
  std::string figures;
  const Mesh sphere = icosphere(5, 2.0);
  const auto sphereData = toPolyData(sphere);
  for (const double angle : { 60.0, 120.0 })
  {
    const double c = std::cos(angle * pi / 360.0);
    for (const int backend : backends)
    {
      for (const double d : diameters(sphereData, backend, angle))
      {
        // Lengths are spread evenly, so dropping outliers takes as much from both ends.
        ASSERT_NEAR(d / 2.0, 1.0 + c, 0.01);
      }
    }
    const auto values = diameters(sphereData, Filter::BACKEND_EMBREE, angle);
    double mean = 0.0;
    for (const double d : values)
    {
      mean += d / 2.0 / static_cast<double>(values.size());
    }
    EXPECT_NEAR(mean, 1.0 + c, 0.002);
    figures += "sphere " + text(angle) + " deg " + text(mean) + " R (law " + text(1.0 + c) + "); ";

    const double h = 0.3;
    const Mesh plate = slab(3.0, h, 30);
    const double slabMean = meanLength(plate,
      coneHits(plate, vertexNormals(plate), angle),
      std::vector<double>(32, 1.0),
      [](const Vector3& p) { return p.head<2>().cwiseAbs().maxCoeff() < 2.0; });
    const double law = -std::log(c) / (1.0 - c);
    EXPECT_NEAR(slabMean / h, law, 0.002 * law);
    figures += "slab " + text(angle) + " deg " + text(slabMean / h) + " h (law " + text(law) + "); ";
  }
  fact("A6_2", figures.substr(0, figures.size() - 2));
}

TEST(A6_3, ScalesWithTheModelAndIgnoresWhereItStands)
{
  const Mesh mesh = torus(1.0, 0.37, 80, 40);
  const auto moved = [&](double scale, const Vector3& shift)
  {
    Mesh copy = mesh;
    for (Vector3& p : copy.points)
    {
      p = scale * p + shift;
    }
    return toPolyData(copy);
  };
  double scaled = 0.0, shifted = 0.0, far = 0.0;
  for (const int backend : backends)
  {
    const auto values = diameters(toPolyData(mesh), backend);
    const auto compare = [&](const std::vector<double>& others, double scale, double& worst)
    {
      ASSERT_EQ(others.size(), values.size());
      for (std::size_t i = 0; i < values.size(); ++i)
      {
        worst = std::max(worst, std::abs(others[i] / (scale * values[i]) - 1.0));
      }
    };
    for (const double scale : { 1e-7, 0.3, 25.4, 1e9 })
    {
      compare(diameters(moved(scale, Vector3::Zero()), backend), scale, scaled);
    }
    compare(diameters(moved(1.0, Vector3(3, -5, 2)), backend), 1.0, shifted);
    compare(diameters(moved(1.0, Vector3(5e6, -3e6, 1e6)), backend), 1.0, far);
  }
  EXPECT_LT(scaled, 1e-9);
  EXPECT_LT(shifted, 1e-9);
  EXPECT_LT(far, 1e-6); // the coordinates themselves are rounded to 1e-9 there
  fact("A6_3",
    "scales 1e-7 to 1e9: within " + text(scaled) + "; moved by 6 lengths: " + text(shifted) +
      ", by 6e6: " + text(far));
}

TEST(A6_4, BackendsAgreeOnRealMeshes)
{
  if (!Device::instance())
  {
    GTEST_SKIP() << "no OpenCL device";
  }
  std::string figures;
  for (const char* name : { "bunny_5k.obj", "man.ply", "koala.stl", "knot_trefoil.ply", "spot_5k9.obj" })
  {
    const auto mesh = read(name);
    if (!mesh)
    {
      std::cout << name << " is absent: set OVERSKETCH_DATA\n";
      continue;
    }
    const auto device = diameters(mesh, Filter::BACKEND_OPENCL);
    const auto embree = diameters(mesh, Filter::BACKEND_EMBREE);
    double worst = 0.0;
    for (std::size_t i = 0; i < device.size(); ++i)
    {
      worst = std::max(worst, std::abs(device[i] - embree[i]) / embree[i]);
    }
    EXPECT_LT(worst, 1e-4) << name;
    figures += std::string(name) + ' ' + text(worst) + "; ";
  }
  if (!figures.empty())
  {
    fact("A6_4", "32 rays a vertex traced; shape diameters of device and Embree differ by " + figures);
  }
}

TEST(ShapeDiameter, CapsulesAreTwoRadiiThick)
{
  const auto mesh = read("capsule_figure.obj");
  if (!mesh)
  {
    GTEST_SKIP() << "capsule_figure.obj is absent: set OVERSKETCH_DATA";
  }
  struct Limb
  {
    Vector3 from, to;
    double radius;
  };
  // The free ends are left out: a cone from a cap looks along the limb.
  const Limb limbs[] = { { { 0.65, 0, 1.25 }, { 1.2, 0, 1.25 }, 0.11 },
    { { -0.65, 0, 1.25 }, { -1.2, 0, 1.25 }, 0.11 },
    { { 0.22, 0, -0.7 }, { 0.22, 0, -1.3 }, 0.16 },
    { { -0.22, 0, -0.7 }, { -0.22, 0, -1.3 }, 0.16 },
    { { 0, -0.65, -0.2225 }, { 0, -1.2, -0.415 }, 0.06 } };
  for (const int backend : backends)
  {
    const auto values = diameters(mesh, backend);
    for (const Limb& limb : limbs)
    {
      std::vector<double> found;
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
      {
        Vector3 p;
        mesh->GetPoint(i, p.data());
        const Vector3 axis = limb.to - limb.from;
        const double along = (p - limb.from).dot(axis) / axis.squaredNorm();
        if (along > 0.0 && along < 1.0 && (p - limb.from - along * axis).norm() < 1.1 * limb.radius)
        {
          found.push_back(values[static_cast<std::size_t>(i)]);
        }
      }
      ASSERT_GT(found.size(), 50u);
      std::sort(found.begin(), found.end());
      EXPECT_NEAR(found[found.size() / 2] / (2.0 * limb.radius), 1.0, 0.06);
      EXPECT_NEAR(found.front() / (2.0 * limb.radius), 1.0, 0.2);
      EXPECT_NEAR(found.back() / (2.0 * limb.radius), 1.0, 0.2);
    }
  }
}

TEST(ShapeDiameter, PassesEverythingAndLeavesTheInputAlone)
{
  const auto mesh = toPolyData(icosphere(2));
  vtkNew<vtkFloatArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(mesh->GetNumberOfPoints());
  colour->Fill(0.5);
  mesh->GetPointData()->SetScalars(colour);
  const vtkMTimeType time = mesh->GetMTime();
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  EXPECT_EQ(mesh->GetMTime(), time);
  EXPECT_FALSE(mesh->GetPointData()->HasArray("ShapeDiameter"));
  vtkPolyData* output = filter->GetOutput();
  EXPECT_EQ(output->GetPoints(), mesh->GetPoints());
  EXPECT_EQ(output->GetNumberOfPolys(), mesh->GetNumberOfPolys());
  EXPECT_EQ(output->GetPointData()->GetScalars(), colour);
  EXPECT_EQ(arrayOf(filter)->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(arrayOf(filter)->GetNumberOfComponents(), 1);
}

TEST(ShapeDiameter, CastsRaysAgainOnlyWhenWhatItReadsChanges)
{
  const auto mesh = toPolyData(icosphere(2));
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->Update();
  vtkDataArray* first = arrayOf(filter);
  EXPECT_EQ(filter->GetRayCastCount(), 1);
  // A colour, a new shallow copy, an execution for its own sake: the same array.
  vtkNew<vtkFloatArray> colour;
  colour->SetName("Colour");
  colour->SetNumberOfTuples(mesh->GetNumberOfPoints());
  mesh->GetPointData()->AddArray(colour);
  mesh->Modified();
  filter->Update();
  EXPECT_EQ(arrayOf(filter), first);
  vtkNew<vtkPolyData> copy;
  copy->ShallowCopy(mesh);
  filter->SetInputData(copy);
  filter->Update();
  filter->Modified();
  filter->Update();
  EXPECT_EQ(arrayOf(filter), first);
  EXPECT_EQ(filter->GetRayCastCount(), 1);
  // Parameters, points, normals: again each time.
  const auto again = [&](vtkIdType count)
  {
    filter->Update();
    EXPECT_EQ(filter->GetRayCastCount(), count);
  };
  filter->SetRayCount(16);
  again(2);
  EXPECT_EQ(filter->GetTracedRayCount(), 16 * mesh->GetNumberOfPoints());
  filter->SetConeAngle(100.0);
  again(3);
  filter->InverseAngleWeightsOn();
  again(4);
  filter->SetBackendToEmbree();
  again(5);
  copy->GetPoints()->Modified();
  copy->Modified();
  again(6);
  const Mesh sphere = icosphere(2);
  copy->GetPointData()->SetNormals(toPolyData(sphere, &sphere.points)->GetPointData()->GetNormals());
  again(7);
  again(7);
}

TEST(ShapeDiameter, InverseAngleWeightsFavourTheAxis)
{
  // In a sphere the axis is the longest way.
  const auto mesh = toPolyData(icosphere(3));
  const auto even = diameters(mesh, Filter::BACKEND_EMBREE, 120.0, false);
  const auto weighted = diameters(mesh, Filter::BACKEND_EMBREE, 120.0, true);
  for (std::size_t i = 0; i < even.size(); ++i)
  {
    EXPECT_GT(weighted[i], even[i] + 0.005);
  }
}

TEST(ShapeDiameter, GoesOnWithoutADeviceAndSaysSo)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 40, 20));
  const auto embree = diameters(mesh, Filter::BACKEND_EMBREE);
  const NoDevice noDevice;
  for (const int backend : { Filter::BACKEND_AUTO, Filter::BACKEND_OPENCL, Filter::BACKEND_EMBREE })
  {
    vtkNew<Filter> filter;
    Ear ear(filter);
    filter->SetInputData(mesh);
    filter->SetBackend(backend);
    EXPECT_EQ(filter->GetBackendUsed(), Filter::BACKEND_AUTO);
    filter->Update();
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(ear.warnings.size(), backend == Filter::BACKEND_EMBREE ? 0u : 1u);
    EXPECT_EQ(filter->GetBackendUsed(), Filter::BACKEND_EMBREE);
    EXPECT_EQ(valuesOf(filter), embree);
  }
}

TEST(ShapeDiameter, SameBitsForAnyNumberOfThreads)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 150, 80));
  for (const int backend : backends)
  {
    vtkSMPTools::Initialize(1);
    const auto one = diameters(mesh, backend);
    vtkSMPTools::Initialize(2);
    const auto two = diameters(mesh, backend);
    vtkSMPTools::Initialize(0);
    EXPECT_EQ(one, two);
    EXPECT_EQ(diameters(mesh, backend), two);
  }
}

TEST(ShapeDiameter, CancelledThenRetriedGivesTheWholeResult)
{
  const auto mesh = toPolyData(icosphere(5));
  for (const int backend : backends)
  {
    vtkNew<Filter> filter;
    Ear ear(filter);
    filter->SetInputData(mesh);
    filter->SetBackend(backend);
    vtkNew<vtkCallbackCommand> stop;
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void*, void* progress)
      {
        if (*static_cast<double*>(progress) > 0.5)
        {
          static_cast<vtkAlgorithm*>(caller)->AbortExecuteOn();
        }
      });
    const unsigned long tag = filter->AddObserver(vtkCommand::ProgressEvent, stop);
    filter->Update();
    EXPECT_EQ(
      filter->GetErrorCode(), vtkErrorCode::UserError + static_cast<unsigned long>(Failure::Cancelled));
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    filter->RemoveObserver(tag);
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    EXPECT_EQ(filter->GetRayCastCount(), 2);
    EXPECT_EQ(valuesOf(filter), diameters(mesh, backend));
    EXPECT_TRUE(ear.errors.empty());
  }
}

TEST(ShapeDiameter, RefusesBadMeshesWithOneMessage)
{
  const auto quad = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  for (const auto& p : { Vector3(0, 0, 0), Vector3(1, 0, 0), Vector3(1, 1, 0), Vector3(0, 1, 0) })
  {
    points->InsertNextPoint(p.data());
  }
  vtkNew<vtkCellArray> quads;
  quads->InsertNextCell({ 0, 1, 2, 3 });
  quad->SetPoints(points);
  quad->SetPolys(quads);
  Mesh sphere = icosphere(1);
  sphere.points[7][1] = std::nan("");
  const auto nan = toPolyData(sphere);
  const auto lines = toPolyData(icosphere(1));
  vtkNew<vtkCellArray> line;
  line->InsertNextCell({ 0, 1 });
  lines->SetLines(line);
  const auto outOfRange = toPolyData(icosphere(1));
  vtkNew<vtkCellArray> polys;
  polys->InsertNextCell({ 0, 1, 99 });
  outOfRange->SetPolys(polys);
  const Mesh good = icosphere(1);
  std::vector<Vector3> badNormals = good.points;
  badNormals[3][0] = std::numeric_limits<double>::infinity();
  const std::pair<vtkSmartPointer<vtkPolyData>, const char*> cases[] = { { quad, "Cell 0" },
    { nan, "Point 7" },
    { lines, "lines" },
    { outOfRange, "Cell 0" },
    { toPolyData(good, &badNormals), "Normal 3" } };
  for (const auto& bad : cases)
  {
    vtkNew<Filter> filter;
    Ear ear(filter);
    filter->SetInputData(toPolyData(good));
    filter->Update();
    filter->SetInputData(bad.first);
    filter->Update();
    ASSERT_EQ(ear.errors.size(), 1u);
    EXPECT_NE(ear.errors[0].find(bad.second), std::string::npos) << ear.errors[0];
    EXPECT_EQ(filter->GetErrorCode(), vtkErrorCode::UserError + static_cast<unsigned long>(Failure::BadMesh));
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    filter->SetInputData(toPolyData(good));
    filter->Update();
    EXPECT_EQ(filter->GetErrorCode(), 0u);
    EXPECT_EQ(arrayOf(filter)->GetNumberOfTuples(), good.vertexCount());
  }
}

TEST(ShapeDiameter, OddMeshesGiveFiniteValues)
{
  Mesh degenerate = icosphere(2);
  degenerate.triangles.push_back({ 0, 0, 1 });
  degenerate.triangles.push_back({ 2, 3, 2 });
  degenerate.points.push_back({ 0, 0, 0 }); // loose
  Mesh insideOut = icosphere(2);
  for (Triangle& t : insideOut.triangles)
  {
    std::swap(t[0], t[1]);
  }
  const Mesh flat{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } } };
  const Mesh point{ { { 4, 4, 4 } }, {} };
  const Mesh collapsed{ { { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } }, { { 0, 1, 2 } } };
  Mesh twice = icosphere(2);
  twice.triangles.insert(twice.triangles.end(), twice.triangles.begin(), twice.triangles.end());
  for (const Mesh& mesh : { degenerate, insideOut, flat, point, collapsed, twice })
  {
    for (const int backend : backends)
    {
      vtkNew<Filter> filter;
      Ear ear(filter);
      filter->SetInputData(toPolyData(mesh));
      filter->SetBackend(backend);
      filter->Update();
      EXPECT_TRUE(ear.errors.empty());
      const auto values = valuesOf(filter);
      EXPECT_EQ(static_cast<int>(values.size()), mesh.vertexCount());
      for (const double d : values)
      {
        EXPECT_TRUE(std::isfinite(d) && d >= 0.0);
      }
    }
  }
  // Every facet twice: the inside is as thick as before.
  const Mesh once = icosphere(2);
  EXPECT_EQ(diameters(toPolyData(twice, &once.points), Filter::BACKEND_EMBREE),
    diameters(toPolyData(once, &once.points), Filter::BACKEND_EMBREE));
}

TEST(ShapeDiameter, DirtyMeshesGiveFiniteValuesOrOneMessage)
{
  int read_ = 0;
  for (const char* name : { "dirty_degenerate_triangles.ply",

         "dirty_duplicate_vertices.obj",
         "dirty_holes.obj",
         "dirty_inconsistent_winding.stl",
         "dirty_index_out_of_range.obj",
         "dirty_inside_out.obj",
         "dirty_islands_unreferenced.ply",
         "dirty_klein_bottle.obj",
         "dirty_mixed_polygons.obj",
         "dirty_nan_inf.ply",
         "dirty_noise_spikes.stl",
         "dirty_nonmanifold_edges.obj",
         "dirty_points_only.ply",
         "dirty_self_intersecting.ply",
         "dirty_far_from_origin.obj",
         "dirty_teapot_unwelded.stl",
         "rod_needles.stl",
         "single_triangle.obj" })
  {
    const auto mesh = read(name);
    if (!mesh)
    {
      continue;
    }
    ++read_;
    vtkNew<Filter> filter;
    Ear ear(filter);
    filter->SetInputData(mesh);
    filter->Update();
    EXPECT_LE(ear.errors.size(), 1u) << name;
    if (ear.errors.empty())
    {
      for (const double d : valuesOf(filter))
      {
        EXPECT_TRUE(std::isfinite(d) && d >= 0.0) << name;
      }
    }
  }
  if (read_ == 0)
  {
    GTEST_SKIP() << "no shared data: set OVERSKETCH_DATA";
  }
}

TEST(ShapeDiameter, NoPointsIsNoError)
{
  vtkNew<Filter> filter;
  Ear ear(filter);
  vtkNew<vtkPolyData> nothing;
  filter->SetInputData(nothing);
  filter->Update();
  EXPECT_TRUE(ear.errors.empty() && ear.warnings.empty());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(filter->GetRayCastCount(), 0);
}

TEST(ShapeDiameter, ParametersAreClampedAndPrinted)
{
  vtkNew<Filter> filter;
  EXPECT_EQ(filter->GetRayCount(), 32);
  EXPECT_EQ(filter->GetConeAngle(), 60.0);
  EXPECT_FALSE(filter->GetInverseAngleWeights());
  EXPECT_EQ(filter->GetBackend(), Filter::BACKEND_AUTO);
  filter->SetRayCount(0);
  EXPECT_EQ(filter->GetRayCount(), 1);
  filter->SetConeAngle(360.0);
  EXPECT_EQ(filter->GetConeAngle(), 179.9);
  filter->SetBackend(17);
  EXPECT_EQ(filter->GetBackend(), Filter::BACKEND_EMBREE);
  filter->SetBackendToOpenCL();
  EXPECT_EQ(filter->GetBackend(), Filter::BACKEND_OPENCL);
  filter->SetBackendToAuto();
  EXPECT_EQ(filter->GetBackend(), Filter::BACKEND_AUTO);
  std::ostringstream print;
  filter->Print(print);
  for (const char* name : { "RayCount",
         "ConeAngle",
         "InverseAngleWeights",
         "Backend",
         "BackendUsed",
         "RayCastCount",
         "TracedRayCount" })
  {
    EXPECT_NE(print.str().find(std::string(name) + ": "), std::string::npos) << name;
  }
  // The extremes compute.
  filter->SetInputData(toPolyData(icosphere(1)));
  filter->Update();
  EXPECT_EQ(valuesOf(filter).size(), 42u);
  filter->SetRayCount(4096);
  filter->SetConeAngle(0.1);
  filter->Update();
  EXPECT_EQ(filter->GetTracedRayCount(), 4096 * 42);
}
