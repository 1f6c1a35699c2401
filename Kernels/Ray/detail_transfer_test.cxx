#include "Harness/shapes.h"
#include "Harness/threads.h"
#include "Mesh/rotation.h"
#include "Ray/detail_transfer.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double tall = 6.0;

// The cylinder's axis is led along an arc of a right angle, in the plane of x and z.
Vector3 bent(const Vector3& p)
{
  const double radius = tall / (0.5 * pi), angle = p[2] / radius;
  return { radius - (radius - p[0]) * std::cos(angle), p[1], (radius - p[0]) * std::sin(angle) };
}

// A fine cylinder with bumps.
Mesh bumpy()
{
  Mesh mesh = cylinder(1.0, tall, 160, 240);
  for (Vector3& p : mesh.points)
  {
    const double bump = 1.0 + 0.02 * std::sin(40.0 * p[2]) * std::sin(12.0 * std::atan2(p[1], p[0]));
    p[0] *= bump;
    p[1] *= bump;
  }
  return mesh;
}

std::shared_ptr<const Mesh> coarse()
{
  return std::make_shared<const Mesh>(cylinder(1.0, tall, 40, 60));
}

std::vector<Vector3> bent(std::vector<Vector3> points)
{
  for (Vector3& p : points)
  {
    p = bent(p);
  }
  return points;
}

} // namespace

TEST(DetailTransfer, NothingMovesWhereTheSurfaceHasNot)
{
  const auto rest = coarse();
  const Mesh fine = bumpy();
  EXPECT_EQ(transferDetail(rest, rest->points, fine.points), fine.points);
  // Only its upper end moves.
  std::vector<Vector3> now = rest->points;
  for (Vector3& p : now)
  {
    p[0] += p[2] > 0.7 * tall ? 0.5 : 0.0;
  }
  const std::vector<Vector3> places = transferDetail(rest, now, fine.points);
  int kept = 0;
  for (int v = 0; v < fine.vertexCount(); ++v)
  {
    kept += places[v] == fine.points[v] ? 1 : 0;
    EXPECT_TRUE(fine.points[v][2] > 0.65 * tall || places[v] == fine.points[v]) << v;
  }
  EXPECT_LT(kept, fine.vertexCount());
}

TEST(DetailTransfer, ARigidMotionIsGivenAsItIs)
{
  const auto rest = coarse();
  const Mesh fine = bumpy();
  const Eigen::Quaterniond turn = rotationBetween({ 1, 0, 0 }, { -0.6, 0.3, 0.9 });
  const auto turned = [&](const Vector3& p) -> Vector3 { return turn * p + Vector3(3, -2, 5); };
  std::vector<Vector3> now = rest->points;
  std::transform(now.begin(), now.end(), now.begin(), turned);
  const std::vector<Vector3> places = transferDetail(rest, now, fine.points);
  for (int v = 0; v < fine.vertexCount(); ++v)
  {
    EXPECT_LT((places[v] - turned(fine.points[v])).norm(), 1e-6 * tall) << v;
  }
}

TEST(DetailTransfer, ABendTakesBumpsAlong)
{
  const auto rest = coarse();
  const Mesh fine = bumpy();
  const std::vector<Vector3> places = transferDetail(rest, bent(rest->points), fine.points);
  double worst = 0.0;
  for (int v = 0; v < fine.vertexCount(); ++v)
  {
    worst = std::max(worst, (places[v] - bent(fine.points[v])).norm());
  }
  EXPECT_LT(worst, 0.02); // of a radius of 1: what the coarse one's edges cut off, and bumps' stretch
}

TEST(DetailTransfer, IsTheSameForAnyThreadsAndEndsWhenCancelled)
{
  const auto rest = coarse();
  const Mesh fine = bumpy();
  const std::vector<Vector3> now = bent(rest->points);
  const std::vector<Vector3> places = transferDetail(rest, now, fine.points);
  EXPECT_EQ(transferDetail(rest, now, fine.points, withThreads(3)), places);
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(transferDetail(rest, now, fine.points, cancelled), Error);
}
