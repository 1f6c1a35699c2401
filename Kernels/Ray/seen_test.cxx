#include "Harness/shapes.h"
#include "Ray/seen.h"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <numeric>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Counts of a ball's vertices that are seen, with what a formula says of each.
void expectSeen(const View& view, const std::function<bool(const Vector3&)>& isSeen)
{
  const auto ball = std::make_shared<const Mesh>(icosphere(4));
  const SurfaceRays rays(ball);
  std::vector<int> all(ball->points.size());
  std::iota(all.begin(), all.end(), 0);
  const std::vector<char> seen = seenVertices(rays, view, all);
  int wrong = 0;
  for (std::size_t v = 0; v < all.size(); ++v)
  {
    wrong += (seen[v] != 0) != isSeen(ball->points[v]);
  }
  // Of facets that pass for a ball those at the limb hide vertices, or leave them bare, that a ball would
  // not.
  EXPECT_LT(wrong, static_cast<int>(all.size()) / 20);
}

} // namespace

TEST(SeenVertices, AreTheHalfOfABallThatFacesAParallelView)
{
  expectSeen(orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0), [](const Vector3& p) { return p[2] > 0.0; });
}

TEST(SeenVertices, AreTheCapOfABallThatTheEyeSees)
{
  const View view = perspectiveView({ 0, 0, 2 }, { 0, 1, 0 }, 60.0);
  const double eye = view.eye().norm();
  expectSeen(view, [&](const Vector3& p) { return p.dot(view.eye() / eye) > 1.0 / eye; });
}

TEST(SeenVertices, OfASheetAreThereFromBothSides)
{
  Mesh sheet;
  sheet.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  sheet.triangles = { { 0, 1, 2 } };
  const SurfaceRays rays(std::make_shared<const Mesh>(sheet));
  for (const double side : { 1.0, -1.0 })
  {
    EXPECT_EQ(seenVertices(rays, orthographicView({ 0, 0, side }, { 0, 1, 0 }, 200.0), { 0, 1, 2 }),
      (std::vector<char>{ 1, 1, 1 }));
  }
}
