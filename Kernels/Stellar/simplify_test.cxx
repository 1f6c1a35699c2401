#include "Harness/forest_shapes.h"
#include "Stellar/refine.h"
#include "Stellar/simplify.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double radius = 0.1;

FeatureCurves wave()
{
  FeatureCurve curve;
  for (int i = 0; i <= 60; ++i)
  {
    curve.points.emplace_back(0.1 + 0.8 * i / 60, 0.5 + 0.2 * std::sin(0.1 * i), 0.0);
  }
  curve.measure();
  return { curve };
}

Forest refinedSheet(const RefineOptions& options)
{
  return refine(quadForest(8, 8), wave(), options, {}, Context());
}

RefineOptions sheetOptions()
{
  RefineOptions options;
  options.radius = radius;
  return options;
}

// Raises the sheet along the wave.
void raise(Forest& forest, double height)
{
  const FeatureCurves curves = wave();
  const CurveSearch search(curves);
  forest.displacement.assign(forest.vertices.size(), Vector3::Zero());
  for (std::size_t v = 0; v < forest.vertices.size(); ++v)
  {
    const double x = search.nearest(0, forest.vertices[v].position).distance / radius;
    forest.displacement[v].z() = x < 1.0 ? height * std::pow(1.0 - x, 1.5) : 0.0;
    forest.vertices[v].position += forest.displacement[v];
    forest.vertices[v].moved = x < 1.0 ? Forest::Displaced : 0;
  }
}

SimplifyOptions simplifyOptions()
{
  SimplifyOptions options;
  options.tolerance = 1e-4 * std::sqrt(2.0);
  options.radius = radius;
  return options;
}

} // namespace

TEST(D11_1, AFlatPlaneGoesBackToItsBase)
{
  const Forest forest = refinedSheet(sheetOptions());
  int welded = 0;
  const Forest back = *simplify(forest, {}, simplifyOptions(), twoThreads(), &welded);
  EXPECT_TRUE(sameForest(back, canonical(quadForest(8, 8), Context()).forest));
  EXPECT_EQ(welded, forest.vertexCount() - back.vertexCount());
  fact("D11_1",
    "flat plane of " + std::to_string(forest.faceCount()) + " faces, no curve: the base of " +
      std::to_string(back.faceCount()) + " byte for byte");
}

TEST(D11_1, WhatACurveRaisedStays)
{
  Forest forest = refinedSheet(sheetOptions());
  raise(forest, 0.05);
  const FeatureCurves curves = wave();
  const CurveSearch search(curves);
  int inside = 0, welded = 0;
  for (const Forest::Vertex& v : forest.vertices)
  {
    inside += search.nearest(0, Vector3(v.position.x(), v.position.y(), 0)).distance < radius;
  }
  const Forest after = simplify(forest, curves, simplifyOptions(), Context(), &welded).value_or(forest);
  EXPECT_EQ(after.broken(), "");
  int stayed = 0;
  for (std::size_t v = 0; v < after.vertices.size(); ++v)
  {
    const Vector3 before = after.vertices[v].position - after.displacement[v];
    stayed += search.nearest(0, before).distance < radius;
  }
  EXPECT_EQ(stayed, inside);
  EXPECT_GT(inside, 500);
  // Without the curve, what is straight along the ridge would go too.
  const Forest bare = *simplify(forest, {}, simplifyOptions(), Context());
  EXPECT_LT(bare.vertexCount(), after.vertexCount());
  fact("D11_1",
    "raised by r/2: all " + std::to_string(inside) + " vertices inside r stay, " + std::to_string(welded) +
      " of " + std::to_string(forest.vertexCount()) + " go");
}

TEST(D11_2, ASecondRunChangesNothingAndRefinementBringsNothingBack)
{
  std::string reached;
  for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
  {
    RefineOptions fine = sheetOptions();
    fine.distance = kind;
    SimplifyOptions coarse = simplifyOptions();
    coarse.distance = kind;
    // Finer than the rule asks for at first, so that there is something to weld.
    RefineOptions wide = fine;
    wide.radius = 2 * radius;
    wide.targetEdgeLength = radius / 4;
    const Forest forest = refine(quadForest(8, 8), wave(), wide, {}, Context());
    int first = 0, second = 0;
    const Forest once = *simplify(forest, wave(), coarse, Context(), &first);
    EXPECT_FALSE(simplify(once, wave(), coarse, Context(), &second));
    EXPECT_GT(first, 100);
    EXPECT_EQ(second, 0);
    int sweeps = -1;
    const Forest again = refine(once, wave(), fine, {}, Context(), &sweeps);
    EXPECT_EQ(sweeps, 0);
    EXPECT_TRUE(sameForest(again, once));
    reached += (reached.empty() ? "" : "; ") + std::to_string(first) + " welds, then " +
               std::to_string(second) + ", then a refinement of " + std::to_string(sweeps) + " sweeps";
  }
  fact("D11_2", reached);
}

TEST(Simplify, SnappedVerticesAndCrestsStayUnlessAskedFor)
{
  Forest forest = quadForest(1, 1);
  refineAll(forest, 2);
  std::vector<int> finest;
  for (int v = 0; v < forest.vertexCount(); ++v)
  {
    if (forest.vertices[v].level == 2)
    {
      finest.push_back(v);
    }
  }
  ASSERT_EQ(finest.size(), 4u);
  forest.vertices[finest[0]].moved = Forest::Crest;
  forest.vertices[finest[1]].curveId = 0;
  forest.vertices[finest[1]].moved = Forest::Placed;
  SimplifyOptions options = simplifyOptions();
  int welded = 0;
  simplify(forest, {}, options, Context(), &welded);
  EXPECT_EQ(welded, 2); // and not the middle, which these two hang on
  options.weldSnapped = true;
  EXPECT_EQ(simplify(forest, {}, options, Context(), &welded)->faceCount(), 2);
}

TEST(Simplify, TheErrorIsTheDistanceFromTheTrianglesThatComeBack)
{
  for (double height : { 0.009, 0.011 })
  {
    Forest forest = quadForest(1, 1);
    refineAll(forest, 1);
    forest.vertices[4].position.z() += height;
    SimplifyOptions options;
    options.tolerance = 0.01;
    int welded = 0;
    simplify(forest, {}, options, Context(), &welded);
    EXPECT_EQ(welded, height < 0.01 ? 1 : 0);
  }
}

TEST(Simplify, WhatTheDisplacementKnewSparesTheSearchAndChangesNothing)
{
  std::vector<Vector3> arc;
  for (int i = 0; i <= 100; ++i)
  {
    arc.emplace_back(std::cos(0.02 * i), std::sin(0.02 * i), 0.1 * std::sin(0.2 * i));
  }
  const FeatureCurves curves{ featureCurve(arc) };
  DisplaceOptions rise;
  SimplifyOptions options = simplifyOptions();
  rise.radius = options.radius = radius;
  // Finer than is needed, and farther, so that there is something to weld.
  RefineOptions fine = sheetOptions();
  fine.radius = 2.0 * radius;
  fine.targetEdgeLength = radius / 4.0;
  Forest before = refine(baseOf(icosphere(4)), curves, fine, {}, Context());
  needBaseNormals(before, Context());
  const CurvesReached reached = reachedBy(before, curves, rise, Context());
  const DisplacedFrom from{ before, reached };
  const ReachOptions reach{ radius, CurveDistance::Straight, true };
  Forest after;
  int spared = 0, welds = 0, off = 0;
  for (int i = 0; i < 12; ++i)
  {
    rise.height = 0.07 * std::sin(1.0 + i);
    options.tolerance = i % 2 ? 1e-3 : 0.0;
    displace(before, curves, reached, rise, Context(), after);
    for (const int v : reached.changing)
    {
      off += putBack(after, v) != before.vertices[v].position;
    }
    spared += stillNeeded(
      before, reached.needed, after, reached.changing, reached.faces, curves, reach, twoThreads());
    int known = 0, unknown = 0;
    const auto with = simplify(after, curves, options, twoThreads(), &known, &from),
               without = simplify(after, curves, options, Context(), &unknown);
    EXPECT_EQ(known, unknown);
    ASSERT_EQ(with.has_value(), without.has_value());
    EXPECT_TRUE(!with || sameForest(*with, *without));
    welds += known;
  }
  EXPECT_EQ(spared, 12);
  EXPECT_GT(welds, 100);
  EXPECT_GT(off, 100); // so rounding was of matter
}

TEST(Simplify, WhatCannotBeIsRefused)
{
  const Forest forest = quadForest(2, 2);
  SimplifyOptions options;
  for (double bad : { -1.0, double(NAN), double(INFINITY) })
  {
    options.tolerance = bad;
    EXPECT_THROW(simplify(forest, {}, options, Context()), Error);
  }
  options.tolerance = 0.1;
  options.radius = 0.0;
  EXPECT_NO_THROW(simplify(forest, {}, options, Context()));
  EXPECT_THROW(simplify(forest, wave(), options, Context()), Error);
}
