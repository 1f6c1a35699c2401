// Every mesh of the shared data, the dirty ones too, under three strokes: a sound result or one clear
// message. Meant for the sanitizers as well. Skipped, saying so, where the folder is absent.
#include "hostile_meshes.h"

#include "Silhouette/outline.h"
#include "vtkOversketchFilterTools.h"
#include "vtkOversketchOneStroke.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <unistd.h>

#include <filesystem>

using namespace oversketch_test;
namespace fs = std::filesystem;

namespace
{

// A quarter of the longest loop of the outline, its middle pushed 15 px to the left; a diagonal where there
// is no loop.
std::vector<Vector2> strokeAlong(const Mesh& mesh, const View& view)
{
  const std::vector<OutlineLoop> loops = traceOutline(mesh, view, outlineWindow(mesh, view, {}));
  const auto longest = std::max_element(loops.begin(),
    loops.end(),
    [](const OutlineLoop& a, const OutlineLoop& b) { return a.points.size() < b.points.size(); });
  if (longest == loops.end() || longest->points.size() < 60)
  {
    return { { 100, 100 }, { 300, 320 }, { 600, 500 } };
  }
  std::vector<Vector2> stroke;
  const std::size_t count = longest->points.size() / 4;
  for (std::size_t i = 0; i < count; i += 3)
  {
    const double s = std::sin(pi * static_cast<double>(i) / static_cast<double>(count));
    stroke.push_back(longest->points[i] + Vector2(-15.0 * s, 5.0 * s));
  }
  return stroke;
}

struct Hostile : HostileMesh
{
};

} // namespace

TEST_P(Hostile, ThreeStrokesGiveASoundResultOrOneMessage)
{
  const vtkSmartPointer<vtkPolyData> polyData = read();
  if (!polyData)
  {
    return;
  }
  const Mesh mesh = MeshOf(polyData);
  const fs::path out =
    fs::temp_directory_path() / ("oversketch-hostile-" + std::to_string(::getpid()) + "-" + GetParam());
  fs::remove_all(out);
  fs::create_directories(out);
  for (int which = 0; which < 3; ++which)
  {
    const View view = wholeView(mesh, which == 1);
    const std::vector<Vector2> samples =
      which == 2 ? std::vector<Vector2>{ { 120, 420 }, { 400, 290 }, { 690, 330 } } : strokeAlong(mesh, view);
    vtkNew<vtkOversketchOneStroke> system;
    Ear ear(system);
    system->SetInputData(0, polyData);
    system->SetStrokeData(toStroke(samples, view));
    system->Update();
    vtkPolyData* result = system->GetOutput();
    if (system->GetErrorCode() != 0 || !ear.errors.empty())
    {
      EXPECT_EQ(ear.errors.size(), 1u) << (ear.errors.empty() ? "no message" : ear.errors[1]);
      EXPECT_EQ(result->GetNumberOfPoints(), 0);
      EXPECT_NE(system->GetErrorCode(), 0u);
      const auto unexpected = static_cast<unsigned long>(Failure::Unexpected);
      EXPECT_NE(system->GetErrorCode() - 40000, unexpected) << ear.errors[0];
      std::cout << "stroke " << which << ": " << (ear.errors.empty() ? "" : ear.errors[0]);
      continue;
    }
    ASSERT_NO_THROW(MeshOf(result));
    EXPECT_GE(result->GetNumberOfPolys(), polyData->GetNumberOfPolys() / 2);
    for (const char* extension : { ".ply", ".glb", ".off" })
    {
      const fs::path file = out / ("result" + std::to_string(which) + extension);
      oversketch_files::Notes notes;
      oversketch_files::writeMesh(result, file.string(), notes);
      EXPECT_TRUE(fs::exists(file));
    }
  }
  for (const auto& entry : fs::directory_iterator(out))
  {
    EXPECT_EQ(entry.path().stem().string().rfind("result", 0), 0u) << "left behind: " << entry.path();
  }
  fs::remove_all(out);
}

INSTANTIATE_TEST_SUITE_P(SharedData, Hostile, testing::ValuesIn(meshNames()), meshTestName);
