// Every mesh of the shared data, the dirty ones too, under lines and rings that nobody should draw: a
// sound mesh or one message. Meant for the sanitizers as well. Skipped, saying so, where the folder is
// absent.
#include "hostile_edit.h"

#include "Harness/shipped.h"

#include "vtkOversketchFilterTools.h"

#include <functional>
#include <utility>

using namespace oversketch_test;

namespace
{

struct HostileEdit : HostileMesh
{
};

std::string operation(const char* format, double length)
{
  std::array<char, 128> text{};
  std::snprintf(text.data(), text.size(), format, length);
  return text.data();
}

void draw(vtkOversketchEdit* system, const LineAndRing& curves)
{
  system->SetReferenceData(curves.line);
  system->SetBoundaryData(curves.ring);
}

// In double precision about a place, each point scaled.
vtkSmartPointer<vtkPolyData> placedAt(vtkPolyData* mesh, double scale, double shift)
{
  auto placed = vtkSmartPointer<vtkPolyData>::New();
  placed->ShallowCopy(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  Vector3 middle;
  mesh->GetCenter(middle.data());
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    points->InsertNextPoint(
      Vector3(scale * (Vector3(mesh->GetPoint(i)) - middle) + Vector3::Constant(shift)).data());
  }
  placed->SetPoints(points);
  return placed;
}

std::vector<Vector2> archOver()
{
  std::vector<Vector2> arch;
  for (int i = 0; i <= 60; ++i)
  {
    arch.emplace_back(i / 60.0, 0.5 * std::sin(pi * i / 60.0));
  }
  return arch;
}

} // namespace

TEST_P(HostileEdit, LinesAndRingsGiveASoundMeshOrOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const Topology topology = topologyOf(polyData);
  const std::string move = operation("move 0.5 n %.9g", 0.05 * boundingDiagonal(mesh));
  for (const LineAndRing& curves : hostileCurves(mesh, GetParam().size() % 2 == 1))
  {
    SCOPED_TRACE(curves.name);
    std::cout << curves.name << ": ";
    vtkNew<vtkOversketchEdit> system;
    system->SetInputData(0, polyData);
    draw(system, curves);
    system->SetOperations(move.c_str());
    std::cout << (soundOrRefused(system, polyData, topology) ? "stands\n" : "");
  }
}

TEST_P(HostileEdit, ModelsOfAnySizeAnywhereGiveASoundMeshOrOneMessage)
{
  const vtkSmartPointer<vtkPolyData> source = read();
  if (!source)
  {
    return;
  }
  const double size = std::max(boundingDiagonal(MeshOf(source)), 1e-30);
  for (const auto& [scale, shift] :
    { std::make_pair(1e-7 / size, 0.0), std::make_pair(5e6 / size, 0.0), std::make_pair(100.0 / size, 5e6) })
  {
    SCOPED_TRACE(std::to_string(scale) + " " + std::to_string(shift));
    const auto polyData = placedAt(source, scale, shift);
    const Mesh mesh = MeshOf(polyData);
    const Topology topology = topologyOf(polyData);
    vtkNew<vtkOversketchEdit> system;
    system->SetInputData(0, polyData);
    draw(system, hostileCurves(mesh, GetParam().size() % 2 == 0).front());
    system->SetOperations(operation("move 0.5 n %.9g", 0.05 * scale * size).c_str());
    std::cout << (soundOrRefused(system, polyData, topology) ? "stands\n" : "");
  }
}

INSTANTIATE_TEST_SUITE_P(SharedData, HostileEdit, testing::ValuesIn(meshNames()), meshTestName);

// Rings over meshes with handles and holes, from six sides, so large that they go round these.
TEST(HostileEditRings, RoundHandlesAndHolesGiveASoundMeshOrOneMessage)
{
  int stand = 0, discs = 0;
  for (const char* name :
    { "torus.obj", "knot_trefoil.ply", "plate_genus3.off", "plane_many_holes.off", "capsule_holes.off" })
  {
    if (!std::filesystem::exists(meshFolder() / name))
    {
      GTEST_SKIP() << "there is no " << meshFolder() / name << "; set OVERSKETCH_DATA";
    }
    const vtkSmartPointer<vtkPolyData> polyData = readHostile(name);
    ASSERT_TRUE(polyData);
    const Mesh mesh = MeshOf(polyData);
    const Topology topology = topologyOf(polyData);
    const double size = boundingDiagonal(mesh);
    Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
    shift.topRightCorner<3, 1>() = -Vector3(polyData->GetCenter());
    for (int side = 0; side < 6; ++side)
    {
      if (!isOfTheDay(side, 2))
      {
        continue;
      }
      Vector3 from = 0.1 * Vector3::Ones();
      from[side % 3] = side < 3 ? 1.0 : -1.0;
      const View at =
        orthographicView(from, side % 3 == 1 ? Vector3::UnitZ() : Vector3::UnitY(), 500.0 / size);
      const View view(at.viewTransform() * shift, at.projectionTransform(), at.width(), at.height());
      for (const double radius : { 30.0, 90.0, 170.0 })
      {
        SCOPED_TRACE(std::string(name) + ", side " + std::to_string(side) + ", " + std::to_string(radius));
        const Vector2 middle = frontOf(mesh, view);
        vtkNew<vtkOversketchEdit> system;
        system->SetInputData(0, polyData);
        draw(system,
          { "", toStroke(lineAbout(middle, 0.6 * radius), view), toStroke(ringAbout(middle, radius), view) });
        system->SetOperations(operation("move 0.5 n %.9g", 0.02 * size).c_str());
        Ear ear(system->GetStep("Enclose"));
        stand += soundOrRefused(system, polyData, topology);
        discs += ear.errors.empty() ? 0 : 1;
      }
    }
  }
  std::cout << stand << " regions stand, " << discs << " are no discs\n";
  EXPECT_GT(stand, 5);
  EXPECT_GT(discs, 5);
}

// Cancelled when a step begins, the edit ends silently and empty; asked again, it is what it would have been.
TEST(HostileEditCancelled, InEachStepAndThenWhole)
{
  const auto model = shippedModel("bear");
  const Mesh mesh = MeshOf(model);
  const LineAndRing curves = hostileCurves(mesh, false).front();
  const std::string move = operation("move 0.5 n %.9g", 0.04 * boundingDiagonal(mesh));
  const std::vector<std::pair<std::vector<const char*>, std::function<void(vtkOversketchEdit*)>>> ways = {
    { { "MeanEdge",
        "ReferenceFit",
        "ReferencePlace",
        "BoundaryPlace",
        "Refine",
        "ReferenceProject",
        "ReferenceInsert",
        "BoundaryFit",
        "BoundaryProject",
        "BoundaryInsert",
        "Enclose",
        "Flatten",
        "Distance",
        "Areas",
        "Shading",
        "Handles",
        "Deform",
        "Retriangulate" },
      [&](vtkOversketchEdit* system)
      {
        system->SetOperations(move.c_str());
        system->SetAreasData(flatCurve({ { -0.2, -0.2 }, { 0.4, -0.2 }, { 0.1, 0.3 } }));
        system->SetLayers("area 0 3");
      } },
    { { "Texture" },
      [&](vtkOversketchEdit* system)
      {
        system->SetOperations(move.c_str());
        system->SetWeightsData(imageOf(8, 8, VTK_UNSIGNED_CHAR, 1, 128.0));
      } },
    { { "Planes", "Section", "Redraw", "Bend" },
      [](vtkOversketchEdit* system) { system->SetProfileData(flatCurve(archOver())); } },
    { { "Refit", "Resketch", "Reproject", "Reinsert" },
      [&](vtkOversketchEdit* system)
      {
        const View view = wholeView(mesh, false);
        const Vector2 at = frontOf(mesh, view);
        std::vector<Vector2> bulge;
        for (int i = 0; i <= 30; ++i)
        {
          const double a = 0.6 * (i / 15.0 - 1.0);
          bulge.emplace_back(at + 56.0 * Vector2(1.2 * std::cos(a), std::sin(a)));
        }
        system->SetOperations(move.c_str());
        system->SetBoundaryData(toStrokes({ { ringAbout(at), view }, { bulge, view } }));
      } }
  };
  for (const auto& [steps, set] : ways)
  {
    const auto edited = [&, asked = set]
    {
      auto system = vtkSmartPointer<vtkOversketchEdit>::New();
      system->SetInputData(0, model);
      draw(system, curves);
      asked(system);
      return system;
    };
    const auto whole = edited();
    whole->Update();
    ASSERT_GT(whole->GetMovedPoints(), 0);
    for (const char* step : steps)
    {
      SCOPED_TRACE(step);
      const auto system = edited();
      vtkNew<vtkCallbackCommand> stop;
      stop->SetClientData(system);
      stop->SetCallback([](vtkObject*, unsigned long, void* self, void*)
        { static_cast<vtkAlgorithm*>(self)->AbortExecuteOn(); });
      vtkAlgorithm* stopped = system->GetStep(step);
      const unsigned long tag = stopped->AddObserver(vtkCommand::StartEvent, stop);
      Ear ear(system);
      system->Update();
      EXPECT_EQ(system->GetErrorCode(), codeOf(Failure::Cancelled));
      EXPECT_TRUE(ear.errors.empty()) << ear.errors[0];
      for (int port = 0; port < 3; ++port)
      {
        EXPECT_EQ(system->GetOutput(port)->GetNumberOfPoints(), 0);
      }
      stopped->RemoveObserver(tag);
      system->AbortExecuteOff();
      system->Modified();
      system->Update();
      EXPECT_EQ(system->GetErrorCode(), 0u);
      for (int port = 0; port < 3; ++port)
      {
        EXPECT_TRUE(identical(system->GetOutput(port), whole->GetOutput(port))) << port;
      }
    }
  }
}
