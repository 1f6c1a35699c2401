#include "Harness/forest_shapes.h"
#include "Stellar/defects.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::string defectsOf(const Mesh& mesh)
{
  try
  {
    checkManifold(mesh);
  }
  catch (const Error& e)
  {
    EXPECT_EQ(e.failure(), Failure::BadMesh);
    return e.what();
  }
  return {};
}

#define EXPECT_DEFECT(mesh, words)                                                                           \
  EXPECT_NE(defectsOf(mesh).find(words), std::string::npos) << defectsOf(mesh)

} // namespace

TEST(D2_7, DefectsAreCountedAndNamed)
{
  const Mesh good = icosphere(2);
  EXPECT_EQ(defectsOf(good), "");
  EXPECT_EQ(defectsOf(quadPairs(3, 2)), "");
  EXPECT_EQ(defectsOf({}), "");

  Mesh turned = good;
  std::swap(turned.triangles[7][0], turned.triangles[7][1]);
  EXPECT_DEFECT(turned, "3 edges whose triangles face opposite ways (");
  for (std::size_t t = 0; t < turned.triangles.size(); t += 2)
  {
    std::swap(turned.triangles[t][0], turned.triangles[t][1]);
  }
  EXPECT_DEFECT(turned, ", …)");

  Mesh fin = good;
  fin.points.emplace_back(3, 0, 0);
  fin.triangles.push_back({ good.triangles[0][0], good.triangles[0][1], good.vertexCount() });
  const auto edge = std::minmax(good.triangles[0][0], good.triangles[0][1]);
  EXPECT_DEFECT(fin,
    "1 edge of more than two triangles (" + std::to_string(edge.first) + "-" + std::to_string(edge.second) +
      ")");

  Mesh twice = good;
  twice.triangles[5] = { 3, 3, 4 };
  EXPECT_DEFECT(twice, "1 triangle with a point twice (5)");

  Mesh flat = quadPairs(1, 1);
  flat.points.push_back(0.5 * (flat.points[0] + flat.points[1]));
  flat.triangles.push_back({ 0, 4, 1 });
  EXPECT_DEFECT(flat, "1 triangle without area (2)");

  Mesh repeated = good;
  repeated.triangles.push_back(good.triangles[9]);
  EXPECT_DEFECT(repeated, "1 repeated triangle (" + std::to_string(good.triangleCount()) + ")");
  const Mesh pillow{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 2, 1, 0 } } };
  EXPECT_DEFECT(pillow, "1 repeated triangle (1)");

  Mesh pinched = joined(good, good, Vector3(9, 0, 0));
  for (Triangle& t : pinched.triangles)
  {
    std::replace(t.begin(), t.end(), good.vertexCount() + 4, 4);
  }
  EXPECT_DEFECT(pinched, "1 point where pieces only touch (4)");

  Mesh nowhere = good;
  nowhere.triangles[3][1] = good.vertexCount();
  nowhere.triangles[6][1] = -1;
  EXPECT_DEFECT(nowhere, "2 triangles that name no point (3, 6)");

  Mesh infinite = good;
  infinite.points[8].y() = std::numeric_limits<double>::quiet_NaN();
  infinite.points[11].z() = std::numeric_limits<double>::infinity();
  EXPECT_DEFECT(infinite, "2 points that are not finite (8, 11)");
  fact("D2_7",
    "turned, crowded, degenerate, flat, repeated, pinched, absent and infinite: each counted and named");
}

TEST(D2_7, RealDefectsAreThoseOfTheirDescription)
{
  if (sharedData("meshes/dirty_nonmanifold_edges.obj").empty())
  {
    GTEST_SKIP() << "no shared data";
  }
  EXPECT_DEFECT(sharedMesh("dirty_nonmanifold_edges.obj"), "60 edges of more than two triangles (");
  EXPECT_DEFECT(sharedMesh("dirty_nonmanifold_vertex.off"), "1 point where pieces only touch (");
  EXPECT_DEFECT(sharedMesh("dirty_duplicate_faces.off"), "190 repeated triangles (");
  EXPECT_DEFECT(sharedMesh("dirty_moebius.off"), "edges whose triangles face opposite ways (");
  EXPECT_DEFECT(sharedMesh("dirty_index_out_of_range.obj"), "that name no point (");
  for (const char* sound : { "dirty_tiny_scale.off",
         "dirty_far_from_origin.obj",
         "dirty_inside_out.obj",
         "skull_genus2.off",
         "plane_many_holes.off" })
  {
    EXPECT_EQ(defectsOf(sharedMesh(sound)), "") << sound;
  }
  fact("D2_7", "60 fins, 1 pinched point and 190 repeated triangles of shared meshes counted exactly");
}

TEST(Defects, AreaDoesNotUnderflow)
{
  Mesh tiny = icosphere(1, 1e-200), huge = icosphere(1, 1e150);
  EXPECT_EQ(defectsOf(tiny), "");
  EXPECT_EQ(defectsOf(huge), "");
}
