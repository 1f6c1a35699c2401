#include "Stellar/smooth.h"

#include "Harness/feature_shapes.h"
#include "Stellar/quality.h"
#include "Stellar/snap.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// Mean over the faces with a snapped vertex of their smallest angles, and the smallest [degrees].
std::pair<double, double> anglesAtCurve(const Forest& forest)
{
  double sum = 0.0, least = 60.0;
  int count = 0;
  for (const Forest::Face& face : forest.faces)
  {
    if (face.root < 0)
    {
      continue;
    }
    const auto at = [&](int i) -> const Forest::Vertex& { return forest.vertices[face.v[i]]; };
    if (at(0).curveId >= 0 || at(1).curveId >= 0 || at(2).curveId >= 0)
    {
      const double angle =
        std::asin(std::sqrt(narrowness(at(0).position, at(1).position, at(2).position))) * 180.0 / pi;
      sum += angle;
      least = std::min(least, angle);
      ++count;
    }
  }
  return { sum / count, least };
}

Forest snappedSquare(const FeatureCurves& curves)
{
  Forest forest = squareForest(16, 1.0 / 6.0);
  refineNear(forest, curves, 0.06, 0.015);
  snap(forest, curves, {}, {}, Context());
  return forest;
}

} // namespace

TEST(D9_3, APlaneStaysPlaneAndItsTrianglesOpen)
{
  double before = 0.0, after = 0.0, least = 60.0, leastBefore = 60.0;
  int cases = 0, rises = 0;
  for (const bool spirals : { false, true })
    for (const FeatureCurve& curve : planarCurves(spirals))
    {
      Forest forest = snappedSquare({ curve });
      const Forest start = forest;
      const std::pair<double, double> narrow = anglesAtCurve(forest);
      SmoothOptions options;
      options.iterations = 5;
      const SmoothReport report = smooth(forest, options, {}, Context());
      EXPECT_GT(report.moved, 0);
      for (std::size_t v = 0; v < forest.vertices.size(); ++v)
      {
        const Forest::Vertex& vertex = forest.vertices[v];
        EXPECT_EQ(vertex.position.z(), 0.0);
        if (vertex.curveId >= 0 || forest.onBoundary(static_cast<int>(v)))
        {
          EXPECT_EQ(vertex.position, start.vertices[v].position);
        }
      }
      for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
      {
        EXPECT_TRUE(!forest.isFace(f) || forest.facetNormal(f).z() > 0.0);
      }
      const std::pair<double, double> open = anglesAtCurve(forest);
      EXPECT_GT(open.first, narrow.first);
      EXPECT_GE(open.second, std::min(5.0, narrow.second));
      rises += open.second > narrow.second ? 1 : 0;
      before += narrow.first;
      after += open.first;
      leastBefore = std::min(leastBefore, narrow.second);
      least = std::min(least, open.second);
      ++cases;
    }
  std::ostringstream text;
  text << "85 planar curves, 5 iterations: z 0, mean smallest angle at C " << before / cases << " -> "
       << after / cases << ", the least " << leastBefore << " -> " << least << ", which rises in " << rises;
  fact("D9_3", text.str());
  EXPECT_GT(rises, cases / 2);
}

TEST(Smooth, ReachesTheRingsThatItIsTold)
{
  const FeatureCurves curves{ featureCurve({ { 0.2, 0.33, 0 }, { 0.8, 0.41, 0 } }) };
  const Forest start = snappedSquare(curves);
  int last = 0;
  for (const int rings : { 0, 1, 2, 5, -1 })
  {
    Forest forest = start;
    SmoothOptions options;
    options.rings = rings;
    const int moved = smooth(forest, options, {}, Context()).moved;
    EXPECT_TRUE(rings == 0 ? moved == 0 : moved > last) << rings;
    last = moved;
  }
}

TEST(Smooth, OnASphereStaysOnItsSource)
{
  // An octahedron's eight faces are four pairs; the source is the unit sphere over them.
  Forest forest = baseOf(octahedron());
  const Forest base = forest;
  MidpointRule rule;
  rule.sourceTolerance = 1e-9;
  rule.source = [&base](const SourcePlace& place)
  {
    const int* v = base.faces[place.root].v;
    Vector3 sum = Vector3::Zero();
    for (int i = 0; i < 3; ++i)
    {
      sum += place.weights[i] * base.vertices[v[i]].position;
    }
    return Vector3(sum.normalized());
  };
  for (int g = 0; g < 8; ++g)
  {
    const int count = static_cast<int>(forest.faces.size());
    for (int f = 0; f < count; ++f)
      if (forest.faces[f].gen == g)
        forest.refine(f, rule);
  }
  SmoothOptions options;
  options.rings = -1;
  Forest on = forest, off = forest;
  EXPECT_GT(smooth(on, options, rule, Context()).moved, 500);
  EXPECT_GT(smooth(off, options, {}, Context()).moved, 500);
  double worstOn = 0.0, worstOff = 0.0;
  for (int v = 0; v < on.vertexCount(); ++v)
  {
    worstOn = std::max(worstOn, std::abs(on.vertices[v].position.norm() - 1.0));
    worstOff = std::max(worstOff, std::abs(off.vertices[v].position.norm() - 1.0));
  }
  EXPECT_LT(worstOn, 1e-12);
  EXPECT_GT(worstOff, 1e-6);
}

TEST(Smooth, RefusesWhatIsNoOption)
{
  Forest forest = squareForest(2);
  SmoothOptions options;
  options.relaxation = std::nan("");
  EXPECT_THROW(smooth(forest, options, {}, Context()), Error);
  options.relaxation = 1.0;
  options.iterations = -1;
  EXPECT_THROW(smooth(forest, options, {}, Context()), Error);
  Forest empty;
  EXPECT_EQ(smooth(empty, {}, {}, Context()).moved, 0);
}
