#include "ShapeDiameterTools.h"

#include "vtkFloatArray.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <sstream>

using namespace oversketch_test;

namespace
{

// Sees no OpenCL device while it lives.
struct NoDevice
{
  NoDevice() { setenv("OVERSKETCH_OPENCL", "off", 1); }
  ~NoDevice() { unsetenv("OVERSKETCH_OPENCL"); }
};

} // namespace

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
  filter->SetBackendToHost();
  again(5);
  copy->GetPoints()->Modified();
  copy->Modified();
  again(6);
  const Mesh sphere = icosphere(2);
  copy->GetPointData()->SetNormals(toPolyData(sphere, &sphere.points)->GetPointData()->GetNormals());
  again(7);
  again(7);
}

TEST(ShapeDiameter, OnDemandItCastsNoRayUntilAStepAsks)
{
  const auto mesh = toPolyData(icosphere(3));
  vtkNew<Filter> filter;
  filter->SetInputData(mesh);
  filter->OnDemandOn();
  filter->Update();
  EXPECT_EQ(filter->GetTracedRayCount(), 0);
  double range[2];
  arrayOf(filter)->GetRange(range);
  EXPECT_EQ(range[1], 0.0);
  filter->OnDemandOff();
  filter->Update();
  EXPECT_EQ(filter->GetTracedRayCount(), 32 * mesh->GetNumberOfPoints());
}

TEST(ShapeDiameter, GoesOnWithoutADeviceAndSaysSo)
{
  const auto mesh = toPolyData(torus(1.0, 0.4, 40, 20));
  const auto embree = diameters(mesh, Filter::Host);
  const NoDevice noDevice;
  for (const int backend : { Filter::Auto, Filter::OpenCL, Filter::Host })
  {
    vtkNew<Filter> filter;
    Ear ear(filter);
    filter->SetInputData(mesh);
    filter->SetBackend(backend);
    EXPECT_EQ(filter->GetBackendUsed(), Filter::Auto);
    filter->Update();
    filter->Modified();
    filter->Update();
    EXPECT_TRUE(ear.errors.empty());
    EXPECT_EQ(ear.warnings.size(), backend == Filter::Host ? 0u : 1u);
    EXPECT_EQ(filter->GetBackendUsed(), Filter::Host);
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
    expectCancel(filter, 0.5);
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
    filter->SetInputData(toPolyData(good));
    filter->Update();
    filter->SetInputData(bad.first);
    expectRefusal(filter, Failure::BadMesh, bad.second);
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
  const auto doubled = diameters(toPolyData(twice, &once.points), Filter::Host);
  const auto single = diameters(toPolyData(once, &once.points), Filter::Host);
  ASSERT_EQ(doubled.size(), single.size());
  for (std::size_t v = 0; v < single.size(); ++v)
  {
    EXPECT_NEAR(doubled[v], single[v], 1e-9); // rays are laid by sums over the facets
  }
}

TEST(ShapeDiameter, DirtyMeshesGiveFiniteValuesOrOneMessage)
{
  int Read = 0;
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
    ++Read;
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
  if (Read == 0)
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
  EXPECT_EQ(filter->GetBackend(), Filter::Auto);
  filter->SetRayCount(0);
  EXPECT_EQ(filter->GetRayCount(), 1);
  filter->SetConeAngle(360.0);
  EXPECT_EQ(filter->GetConeAngle(), 179.9);
  filter->SetBackend(17);
  EXPECT_EQ(filter->GetBackend(), Filter::Host);
  filter->SetBackendToOpenCL();
  EXPECT_EQ(filter->GetBackend(), Filter::OpenCL);
  filter->SetBackendToAuto();
  EXPECT_EQ(filter->GetBackend(), Filter::Auto);
  std::ostringstream print;
  filter->Print(print);
  for (const char* name : { "RayCount",
         "ConeAngle",
         "InverseAngleWeights",
         "Backend",
         "BackendUsed",
         "RayCastCount",
         "TracedRayCount",
         "OnDemand" })
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
