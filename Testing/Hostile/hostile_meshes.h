// The meshes of the shared data, the dirty ones too, as parameters of tests, and a view of one. Header-only.
#ifndef oversketch_testing_hostile_hostile_meshes_h
#define oversketch_testing_hostile_hostile_meshes_h

#include "Harness/polydata.h"
#include "Harness/sequences.h"

#include "mesh_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

namespace oversketch_test
{

inline std::filesystem::path meshFolder()
{
  namespace fs = std::filesystem;
  const char* data = std::getenv("OVERSKETCH_DATA");
  return (data ? fs::path(data) : fs::path(OVERSKETCH_SOURCE_FOLDER) / ".." / "shared" / "data") / "meshes";
}

// The files' names; one that is empty where the folder is absent. With a seed of the day, OVERSKETCH_SEED, a
// eighth of them, another one each day; all in the full run, OVERSKETCH_FULL.
inline std::vector<std::string> meshNames()
{
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(meshFolder(), none))
  {
    if (entry.path().extension() != ".json" && entry.path().extension() != ".mtl")
    {
      names.push_back(entry.path().filename().string());
    }
  }
  std::sort(names.begin(), names.end());
  std::vector<std::string> today;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    if (isOfTheDay(i, 8))
    {
      today.push_back(names[i]);
    }
  }
  return today.empty() ? std::vector<std::string>{ "" } : today;
}

// The file's name as a test may be called.
inline std::string meshTestName(const testing::TestParamInfo<std::string>& test)
{
  std::string name = test.param.empty() ? "absent" : test.param;
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0; }, '_');
  return name;
}

// Null, saying why, where the reader refuses the file, which it must name.
inline vtkSmartPointer<vtkPolyData> readHostile(const std::string& name)
{
  oversketch_files::catchMessages();
  oversketch_files::Notes notes;
  try
  {
    return oversketch_files::readMesh((meshFolder() / name).string(), notes);
  }
  catch (const oversketch_files::Failed& failed)
  {
    EXPECT_NE(std::string(failed.what()).find(name), std::string::npos) << failed.what();
    std::cout << "refused: " << failed.what() << std::endl;
    return nullptr;
  }
}

// A test of each of the meshes.
class HostileMesh : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    if (GetParam().empty())
    {
      GTEST_SKIP() << "there is no folder " << meshFolder() << "; set OVERSKETCH_DATA";
    }
  }
  // Null where the reader refuses the file: then there is nothing more to test.
  static vtkSmartPointer<vtkPolyData> read() { return readHostile(GetParam()); }
};

// A view of the whole mesh in an 800 x 600 picture.
inline View wholeView(const Mesh& mesh, bool perspective)
{
  Vector3 low = Vector3::Constant(1e300), high = -low;
  for (const Vector3& p : mesh.points)
  {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double size = std::max((high - low).norm(), 1e-30);
  const Vector3 middle = (low + high) / 2.0;
  const View at = perspective
                    ? perspectiveView(Vector3(0.8, 0.5, 1.2).normalized() * 1.6 * size, { 0, 1, 0 }, 40)
                    : orthographicView({ 0.2, 0.1, 1 }, { 0, 1, 0 }, 500.0 / size);
  Eigen::Matrix4d shift = Eigen::Matrix4d::Identity();
  shift.topRightCorner<3, 1>() = -middle;
  return View(at.viewTransform() * shift, at.projectionTransform(), at.width(), at.height());
}

// Where the triangle lies that is in front of all others, in the picture.
inline Vector2 frontOf(const Mesh& mesh, const View& view)
{
  Vector2 found(400.0, 300.0);
  double nearest = -HUGE_VAL;
  for (const Triangle& t : mesh.triangles)
  {
    const Vector3 middle = (mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]]) / 3.0;
    if (const double depth = view.depth(middle); depth > nearest)
    {
      nearest = depth;
      found = view.toDisplay(middle).head<2>();
    }
  }
  return found;
}

constexpr double longestRun = 60.0; // [s of the processor] that a run may take, whatever else runs

} // namespace oversketch_test
#endif
