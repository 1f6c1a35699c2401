// What the readers make of files whose meaning is plain: positions known by hand.
#include "made_files.h"
#include "mesh_file.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <gtest/gtest.h>

#include <array>

using namespace oversketch_files;
using namespace oversketch_files_test;

namespace
{

std::array<double, 3> pointOf(vtkPolyData* mesh, vtkIdType at)
{
  std::array<double, 3> point;
  mesh->GetPoint(at, point.data());
  return point;
}

void expectPoint(vtkPolyData* mesh, vtkIdType at, double x, double y, double z)
{
  const std::array<double, 3> point = pointOf(mesh, at), expected{ x, y, z };
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_NEAR(point[k], expected[k], 1e-6) << "point " << at << ", " << k;
  }
}

std::vector<vtkIdType> cornersOf(vtkPolyData* mesh, vtkIdType cell)
{
  vtkNew<vtkIdList> ids;
  mesh->GetPolys()->GetCellAtId(cell, ids);
  return { ids->begin(), ids->end() };
}

} // namespace

TEST(Gltf, NodesMoveWhatHangsOnThem)
{
  // A child half as large, within a parent turned by 90 degrees about z and moved by (10, 0, 0).
  const auto mesh = readText(gltf(R"("scenes":[{"nodes":[1]}],
    "nodes":[{"mesh":0,"scale":[0.5,0.5,0.5],"translation":[0,2,0]},
             {"children":[0],"translation":[10,0,0],"rotation":[0,0,0.70710678118654752,0.70710678118654752]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"mode":6}]}])"));
  ASSERT_EQ(mesh->GetNumberOfPoints(), 4);
  expectPoint(mesh, 0, 8, 0, 0);
  expectPoint(mesh, 1, 8, 0.5, 0);
  expectPoint(mesh, 2, 7.5, 0.5, 0);
  ASSERT_TRUE(mesh->GetPointData()->GetNormals());
  EXPECT_NEAR(mesh->GetPointData()->GetNormals()->GetComponent(2, 2), 1.0, 1e-6);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(cornersOf(mesh, 1), (std::vector<vtkIdType>{ 0, 2, 3 }));
}

TEST(Gltf, AStripTurnsEverySecondTriangle)
{
  const auto mesh = readText(gltf(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0},"mode":5,"indices":2}]}])",
    std::string("\0\1\3\2", 4),
    R"(,{"bufferView":2,"componentType":5121,"type":"SCALAR","count":4})"));
  ASSERT_EQ(mesh->GetNumberOfPolys(), 2);
  EXPECT_EQ(cornersOf(mesh, 0), (std::vector<vtkIdType>{ 0, 1, 3 }));
  EXPECT_EQ(cornersOf(mesh, 1), (std::vector<vtkIdType>{ 1, 2, 3 }));
}

TEST(Gltf, MorphTargetsAndSparseNumbersAreAdded)
{
  // The target is sparse, nothing but (0, 0, 4) at point 2, and weighs a half.
  const auto mesh = readText(gltf(R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
    "meshes":[{"weights":[0.5],"primitives":[{"attributes":{"POSITION":0},"mode":6,"targets":[{"POSITION":2}]}]}])",
    bytesOf<float>({ 0, 0, 4 }) + std::string("\2\0\0\0", 4),
    R"(,{"componentType":5126,"type":"VEC3","count":4,"sparse":{"count":1,
        "indices":{"bufferView":2,"byteOffset":12,"componentType":5121},"values":{"bufferView":2}}})"));
  expectPoint(mesh, 2, 1, 1, 2);
  expectPoint(mesh, 3, 0, 1, 0);
}

TEST(Gltf, ASkinFollowsItsJoints)
{
  // Points 0 and 1 hang on a joint at rest, 2 and 3 on one that is moved by (0, 0, 5), 3 by half of each.
  const std::string joints{ 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0 };
  const auto mesh =
    readText(gltf(R"("scenes":[{"nodes":[0,1,2]}],"nodes":[{"mesh":0,"skin":0},{},{"translation":[0,0,5]}],
    "skins":[{"joints":[1,2]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"JOINTS_0":2,"WEIGHTS_0":3},"mode":6}]}])",
      joints + bytesOf<float>({ 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0.5F, 0.5F, 0, 0 }),
      R"(,{"bufferView":2,"componentType":5121,"type":"VEC4","count":4},
        {"bufferView":2,"byteOffset":16,"componentType":5126,"type":"VEC4","count":4})"));
  expectPoint(mesh, 1, 1, 0, 0);
  expectPoint(mesh, 2, 1, 1, 5);
  expectPoint(mesh, 3, 0, 1, 2.5);
}

TEST(Gltf, ANormalStaysWhereAScaleIsZero)
{
  const auto mesh = readText(gltf(R"("nodes":[{"mesh":0,"scale":[1,0,0]}],
    "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":1},"mode":6}]}])"));
  ASSERT_TRUE(mesh->GetPointData()->GetNormals());
  EXPECT_EQ(mesh->GetPointData()->GetNormals()->GetComponent(1, 2), 1.0);
}

TEST(Gltf, ManyNodesMayNotAskForMoreThanTheFileCanHold)
{
  std::string nodes = R"({"mesh":0})";
  for (int i = 0; i < 2000; ++i)
  {
    nodes += R"(,{"mesh":0})";
  }
  std::string primitives = R"({"attributes":{"POSITION":0},"mode":6})";
  for (int i = 0; i < 1000; ++i)
  {
    primitives += R"(,{"attributes":{"POSITION":0},"mode":6})";
  }
  try
  {
    readText(gltf(R"("nodes":[)" + nodes + R"(],"meshes":[{"primitives":[)" + primitives + "]}]"));
    FAIL() << "8,000,000 points were read";
  }
  catch (const Failed& failed)
  {
    EXPECT_NE(std::string(failed.what()).find("asks for more numbers"), std::string::npos) << failed.what();
  }
}

TEST(Polygons, OfTooManyCornersAreRefused)
{
  std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n10001";
  for (int i = 0; i < 10001; ++i)
  {
    text += " " + std::to_string(i % 3);
  }
  EXPECT_THROW(readText(text, "made.off"), Failed);
}

TEST(Ply, DoublesBytesAndCornersCoordinatesAreKept)
{
  const std::string text =
    "ply\nformat ascii 1.0\ncomment made by hand\nelement vertex 4\nproperty double x\n"
    "property double y\nproperty double z\nproperty uchar red\nproperty uchar green\n"
    "property uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n"
    "property list uchar float texcoord\nend_header\n"
    "0.1 0 0 255 0 7\n1 0 0 0 0 0\n1 1 0 0 0 0\n0 1 1e-300 1 2 3\n"
    "3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0.5 0 1 1 0 1\n";
  const auto mesh = readText(text, "made.ply");
  ASSERT_EQ(mesh->GetNumberOfPoints(), 5) << "vertex 0 has two pairs of coordinates, the others one";
  EXPECT_EQ(pointOf(mesh, 0)[0], 0.1) << "to the bit";
  EXPECT_EQ(pointOf(mesh, 4)[0], 0.1);
  EXPECT_EQ(cornersOf(mesh, 0), (std::vector<vtkIdType>{ 0, 1, 2 }));
  EXPECT_EQ(cornersOf(mesh, 1), (std::vector<vtkIdType>{ 4, 2, 3 }));
  vtkDataArray* coordinates = mesh->GetPointData()->GetTCoords();
  ASSERT_TRUE(coordinates);
  EXPECT_EQ(coordinates->GetComponent(0, 0), 0.0);
  EXPECT_EQ(coordinates->GetComponent(4, 0), 0.5);
  vtkDataArray* colours = coloursOf(mesh);
  ASSERT_TRUE(colours);
  EXPECT_EQ(colours->GetComponent(4, 2), 7.0);
  EXPECT_EQ(colours->GetComponent(3, 1), 2.0);
}

TEST(Ply, BigAndLittleEndsAreRead)
{
  for (const bool big : { false, true })
  {
    const auto put = [&](std::string& to, const void* value, std::size_t size)
    {
      std::string bytes(static_cast<const char*>(value), size); // this machine is little-endian
      to += big ? std::string(bytes.rbegin(), bytes.rend()) : bytes;
    };
    std::string text = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                       "_endian 1.0\nelement vertex 3\nproperty float x\nproperty short y\nproperty float z\n"
                       "element face 1\nproperty list ushort uint vertex_index\nend_header\n";
    for (int i = 0; i < 3; ++i)
    {
      const float x = 1.5F * static_cast<float>(i), z = static_cast<float>(i * i);
      const auto y = static_cast<short>(-300 * i);
      put(text, &x, 4);
      put(text, &y, 2);
      put(text, &z, 4);
    }
    const unsigned short count = 3;
    put(text, &count, 2);
    for (const unsigned id : { 2U, 1U, 0U })
    {
      put(text, &id, 4);
    }
    const auto mesh = readText(text, "made.ply");
    expectPoint(mesh, 2, 3, -600, 4);
    EXPECT_EQ(cornersOf(mesh, 0), (std::vector<vtkIdType>{ 2, 1, 0 }));
  }
}
