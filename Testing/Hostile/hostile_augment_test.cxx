// Every mesh of the shared data, the dirty ones too, under six strokes that augment it: a 4-8 mesh of the
// same topology or one message; and under the same that relax it: its points, finite, or one message. Meant
// for the sanitizers as well. Skipped, saying so, where the folder is absent.
#include "hostile_meshes.h"
#include "sound.h"

#include "vtkOversketchAugment.h"
#include "vtkOversketchFilterTools.h"
#ifdef OVERSKETCH_WITH_POSE
#include "vtkOversketchPose.h"
#endif
#ifdef OVERSKETCH_WITH_RELAX
#include "vtkOversketchRelax.h"
#endif

#include "vtkFloatArray.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <utility>

using namespace oversketch_test;

namespace
{

// Strokes about a place of the picture.
std::vector<std::pair<const char*, std::vector<Vector2>>> hostileStrokes(const Vector2& at)
{
  std::vector<Vector2> line, ring, scribble, away, many;
  for (int i = 0; i <= 60; ++i)
  {
    const double s = i / 60.0, a = 2.0 * pi * s;
    line.emplace_back(at + Vector2(160.0 * (s - 0.5), 60.0 * (s - 0.5)));
    ring.emplace_back(at + Vector2(40.0 * std::cos(a), 30.0 * std::sin(a)));
    away.emplace_back(at + s * (Vector2(820.0, 310.0) - at));
  }
  for (int i = 0; i <= 400; ++i)
  {
    const double a = i / 30.0;
    scribble.emplace_back(at + Vector2(50.0 * std::sin(3.1 * a), 45.0 * std::sin(4.3 * a)));
  }
  for (int i = 0; i < 100000; ++i)
  {
    const double s = i / 1e5;
    many.emplace_back(at + 60.0 * s * Vector2(std::cos(25.0 * s), std::sin(25.0 * s)));
  }
  return { { "line", line },
    { "ring", ring },
    { "scribble", scribble },
    { "into the air", away },
    { "one point", { at, at, at } },
    { "100,000 samples", many } };
}

struct HostileAugment : HostileMesh
{
};

} // namespace

TEST_P(HostileAugment, SixStrokesGiveASoundMeshOrOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const View view = wholeView(mesh, GetParam().size() % 2 == 1);
  for (const auto& [name, samples] : hostileStrokes(frontOf(mesh, view)))
  {
    SCOPED_TRACE(name);
    vtkNew<vtkOversketchAugment> system;
    Ear ear(system);
    system->SetInputData(0, polyData);
    system->SetStrokesData(toStroke(samples, view));
    const std::clock_t start = std::clock();
    system->Update();
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, longestRun);
    if (system->GetErrorCode() == 0 && ear.errors.empty())
    {
      EXPECT_STRNE(name, "one point");
      expectSound48(system->GetInnerOutput("Base"), system->GetInnerOutput("Simplify"), system->GetOutput());
      continue;
    }
    ASSERT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors[1]);
    EXPECT_EQ(system->GetOutput()->GetNumberOfPoints(), 0);
    EXPECT_NE(system->GetErrorCode(), codeOf(Failure::Unexpected)) << ear.errors[0];
    if (system->GetErrorCode() == codeOf(Failure::BadMesh)) // defects are counted
    {
      EXPECT_NE(ear.errors[0].find_first_of("0123456789"), std::string::npos) << ear.errors[0];
    }
    std::cout << name << ": " << ear.errors[0];
  }
}

#ifdef OVERSKETCH_WITH_RELAX
TEST_P(HostileAugment, SixStrokesRelaxItOrGiveOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const View view = wholeView(mesh, GetParam().size() % 2 == 1);
  // Of some meshes every third point is masked.
  const bool isMasked = GetParam().size() % 3 == 0;
  vtkNew<vtkFloatArray> mask;
  mask->SetName("Mask");
  for (vtkIdType i = 0; i < polyData->GetNumberOfPoints(); ++i)
  {
    mask->InsertNextValue(i % 3 == 0 ? 1.0f : 0.0f);
  }
  if (isMasked)
  {
    polyData->GetPointData()->AddArray(mask);
  }
  vtkNew<vtkOversketchRelax> system;
  system->SetInputData(0, polyData);
  for (const auto& [name, samples] : hostileStrokes(frontOf(mesh, view)))
  {
    SCOPED_TRACE(name);
    Ear ear(system);
    system->SetStrokesData(toStroke(samples, view));
    const std::clock_t start = std::clock();
    system->Update();
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, longestRun);
    vtkPolyData* output = system->GetOutput();
    if (system->GetErrorCode() == 0 && ear.errors.empty())
    {
      ASSERT_EQ(output->GetNumberOfPoints(), polyData->GetNumberOfPoints());
      EXPECT_EQ(output->GetPolys(), polyData->GetPolys());
      for (vtkIdType i = 0; isMasked && i < output->GetNumberOfPoints(); i += 3)
      {
        EXPECT_EQ(Vector3(output->GetPoint(i)), Vector3(polyData->GetPoint(i))) << i;
      }
      double box[6];
      output->GetBounds(box);
      EXPECT_TRUE(std::all_of(box, box + 6, [](double side) { return std::isfinite(side); }));
      EXPECT_LT(output->GetLength(), 1.5 * polyData->GetLength());
      continue;
    }
    ASSERT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors[1]);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_NE(system->GetErrorCode(), codeOf(Failure::Unexpected)) << ear.errors[0];
  }
}
#endif

#ifdef OVERSKETCH_WITH_POSE
TEST_P(HostileAugment, SixStrokesPoseItOrGiveOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const View view = wholeView(mesh, GetParam().size() % 2 == 1);
  vtkNew<vtkOversketchPose> system;
  system->SetInputData(0, polyData);
  for (const auto& [name, samples] : hostileStrokes(frontOf(mesh, view)))
  {
    SCOPED_TRACE(name);
    Ear ear(system);
    system->SetBoneData(toStroke(samples, view));
    system->SetPoseData(toStroke({ samples.rbegin(), samples.rend() }, view));
    const std::clock_t start = std::clock();
    system->Update();
    EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, longestRun);
    vtkPolyData* output = system->GetOutput();
    if (system->GetErrorCode() == 0 && ear.errors.empty())
    {
      ASSERT_EQ(output->GetNumberOfPoints(), polyData->GetNumberOfPoints());
      EXPECT_EQ(output->GetPolys(), polyData->GetPolys());
      double box[6];
      output->GetBounds(box);
      EXPECT_TRUE(std::all_of(box, box + 6, [](double side) { return std::isfinite(side); }));
      EXPECT_LT(output->GetLength(), 4.0 * polyData->GetLength());
      continue;
    }
    ASSERT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors[1]);
    EXPECT_EQ(output->GetNumberOfPoints(), 0);
    EXPECT_NE(system->GetErrorCode(), codeOf(Failure::Unexpected)) << ear.errors[0];
  }
}
#endif

INSTANTIATE_TEST_SUITE_P(SharedData, HostileAugment, testing::ValuesIn(meshNames()), meshTestName);
