// Facts of editors.md, section 13, flatten and texture: the fields.
#include "Shading/fields.h"

#include "Harness/patches.h"
#include "Harness/threads.h"
#include "Mesh/context.h"
#include "Shading/layers.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::vector<double> weightsOf(const CurveFields& fields, Falloff falloff)
{
  const Layers layers;
  std::vector<double> weights;
  for (const double s : fields.share)
  {
    weights.push_back(layers.weight(s, falloff));
  }
  return weights;
}

} // namespace

TEST(B6_2, AStripFallsEvenly)
{
  const Drawn drawn = strip(200, 20);
  double worst[2] = {}, smooth = 0.0;
  for (const bool filtered : { false, true })
  {
    FieldRules rules;
    rules.straight = true;
    rules.smoothing = filtered ? 0.15 : 0.0;
    const CurveFields fields = curveFields(drawn.patch, drawn.reference, rules, {});
    const std::vector<double> linear = weightsOf(fields, Falloff::Linear),
                              quintic = weightsOf(fields, Falloff::Smooth);
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const Vector3& p = drawn.patch.points[v];
      const double y = std::abs(p[1]);
      if (std::abs(p[0]) <= 5.0)
      {
        worst[filtered] = std::max(worst[filtered], std::abs(linear[v] - (1.0 - y)));
        smooth = std::max(smooth, std::abs(quintic[v] - (1.0 - y * y * y * (10.0 - 15.0 * y + 6.0 * y * y))));
        if (std::abs(y - 0.5) < 1e-9)
        {
          // On the border of nothing: half way is within the third of five levels.
          EXPECT_EQ(Layers().grey(Layers().level(fields.share[v])), 128);
        }
      }
    }
  }
  EXPECT_LT(worst[0], 1e-9);
  EXPECT_LT(worst[1], 1e-6);
  EXPECT_LT(smooth, 2e-6);
  fact("B6_2",
    "strip, straight distances: w = 1 - abs(y) within " + std::to_string(worst[0] * 1e9) + "e-9, smoothed " +
      std::to_string(worst[1] * 1e9) +
      "e-9, and 1 - 10 abs(y)^3 + 15 y^4 - 6 abs(y)^5; half way is grey 128");
}

TEST(CurveFields, LongDiagonalsLeaveNoRibs)
{
  // Rows of the strip drawn past each other, so that many an edge is not Delaunay; distances stay as they
  // were.
  Drawn drawn = strip(200, 20);
  for (Vector3& p : drawn.patch.points)
  {
    p[0] += 0.2 * std::sin(12.0 * std::abs(p[1]));
  }
  FieldRules rules;
  rules.straight = true;
  const CurveFields fields = curveFields(drawn.patch, drawn.reference, rules, {});
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
  {
    const Vector3& p = drawn.patch.points[v];
    if (std::abs(p[0]) <= 5.0)
    {
      EXPECT_NEAR(fields.share[v], std::abs(p[1]), 1e-6) << p;
    }
  }
}

TEST(B6_4, NoEdgeAlongTheCurves)
{
  std::string said;
  for (const int side : { 36, 72 })
  {
    const Drawn drawn = hill(side);
    const CurveFields fields = curveFields(drawn.patch, drawn.reference, {}, {});
    FieldRules published;
    published.smoothing = 0.0;
    const CurveFields rough = curveFields(drawn.patch, drawn.reference, published, {});
    const std::vector<double> w = weightsOf(fields, Falloff::Smooth),
                              linear = weightsOf(rough, Falloff::Linear);
    for (std::size_t v = 0; v < w.size(); ++v)
    {
      EXPECT_GE(fields.share[v], 0.0);
      EXPECT_LE(fields.share[v], 1.0);
    }
    for (const int v : drawn.reference)
    {
      EXPECT_EQ(w[v], 1.0);
      EXPECT_EQ(linear[v], 1.0);
    }
    for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    {
      const Vector3& p = drawn.patch.points[v];
      if (v % (side + 1) == 0 || v <= side)
      {
        EXPECT_EQ(w[v], 0.0) << p;
      }
    }
    const auto [inner, outer] = slopeJumps(drawn, w);
    const auto [innerLinear, outerLinear] = slopeJumps(drawn, linear);
    EXPECT_GE(innerLinear, 1.8);
    EXPECT_LE(innerLinear, 2.7);
    EXPECT_GE(outerLinear, 0.85);
    EXPECT_LE(outerLinear, 1.1);
    const bool many = drawn.patch.vertexCount() >= 4000;
    EXPECT_LE(inner, many ? 0.4 : 1.1);
    EXPECT_LE(outer, many ? 0.15 : 0.3);
    said += (said.empty() ? "" : "; ") + std::to_string(drawn.patch.vertexCount()) +
            " vertices: slope jump at the line " + std::to_string(innerLinear) + " to " +
            std::to_string(inner) + ", at the ring " + std::to_string(outerLinear) + " to " +
            std::to_string(outer);
  }
  fact("B6_4", said);
}

TEST(B6_5, TheParameterIsNotTorn)
{
  const Drawn drawn = hook();
  FieldRules published;
  published.parameterSmoothing = 0.0;
  const CurveFields torn = curveFields(drawn.patch, drawn.reference, published, {}),
                    fields = curveFields(drawn.patch, drawn.reference, {}, {});
  const double before = largestStep(drawn, torn.parameter), after = largestStep(drawn, fields.parameter);
  EXPECT_GE(before, 0.9);
  EXPECT_LE(after, 0.25);
  for (std::size_t i = 0; i < drawn.reference.size(); ++i)
  {
    EXPECT_NEAR(fields.parameter[drawn.reference[i]],
      static_cast<double>(i) / static_cast<double>(drawn.reference.size() - 1),
      1e-9);
  }
  fact("B6_5",
    "three quarters of a circle on a sphere: largest step of the parameter over an edge " +
      std::to_string(before) + " as published, " + std::to_string(after) + " smoothed");
}

TEST(Fields, DistancesOnASphere)
{
  // From a parallel of the hook's sphere, closed: the angle from it.
  const Drawn drawn = hook();
  const Adjacency adjacency = buildAdjacency(drawn.patch);
  std::vector<int> parallel;
  parallel.reserve(200);
  for (int s = 0; s < 200; ++s)
  {
    parallel.push_back(1 + 24 * 200 + s);
  }
  const ChainDistances found = chainDistances(drawn.patch, adjacency, parallel, true, false, {});
  double worst = 0.0;
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
  {
    const double down = std::acos(std::clamp(drawn.patch.points[v][2], -1.0, 1.0));
    const double exact = std::abs(down - 50.0 * pi / 180.0);
    worst = std::max(worst, std::abs(found.distance[v] - exact));
  }
  EXPECT_LT(worst, 0.001);
  // Through space it is shorter.
  const ChainDistances chords = chainDistances(drawn.patch, adjacency, parallel, true, true, {});
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
  {
    EXPECT_LE(chords.distance[v], found.distance[v]);
  }
  EXPECT_NEAR(chords.distance[0], 2.0 * std::sin(25.0 * pi / 180.0), 1e-3);
}

TEST(Fields, ThreadsChangeNoBit)
{
  const Drawn drawn = hill(40);
  const CurveFields one = curveFields(drawn.patch, drawn.reference, {}, {}),
                    two = curveFields(drawn.patch, drawn.reference, {}, twoThreads());
  EXPECT_EQ(one.share, two.share);
  EXPECT_EQ(one.parameter, two.parameter);
  Context stop;
  stop.cancelled = [] { return true; };
  EXPECT_THROW(curveFields(drawn.patch, drawn.reference, {}, stop), Error);
}

TEST(Fields, ReferencesThatAreNone)
{
  const Drawn drawn = strip(40, 4);
  const auto refused = [&](const std::vector<int>& reference)
  {
    try
    {
      curveFields(drawn.patch, reference, {}, {});
      return false;
    }
    catch (const Error& error)
    {
      return error.failure() == Failure::BadStroke;
    }
  };
  const int a = drawn.reference[3], b = drawn.reference[4], far = drawn.reference[9];
  EXPECT_TRUE(refused({}));
  EXPECT_TRUE(refused({ a }));
  EXPECT_TRUE(refused({ a, far }));
  EXPECT_TRUE(refused({ a, -1 }));
  EXPECT_TRUE(refused({ a, 100000 }));
  EXPECT_TRUE(refused({ 0, 1 })); // on the boundary
  EXPECT_FALSE(refused({ a, b }));
}
