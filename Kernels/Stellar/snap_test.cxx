#include "Stellar/snap.h"

#include "Stellar/feature_shapes.h"
#include "Stellar/quality.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

struct Planar
{
  SnapReport report;
  int before = 0, degenerate = 0, flipped = 0, snapped = 0, faces = 0;
  double smallest = 60.0, offCurve = 0.0, finest = 60.0;
  int gaps = 0; // neighbours along the curve that no edge joins
};

Planar snapPlanar(bool spirals, const SnapOptions& options)
{
  Planar sum;
  unsigned seed = 0;
  for (const FeatureCurve& curve : planarCurves(spirals))
  {
    const FeatureCurves curves{ curve };
    Forest forest = squareForest(16, 1.0 / 6.0, ++seed);
    refineNear(forest, curves, 0.06, 0.015);
    sum.finest = std::min(sum.finest, faceQuality(forest, Context()).smallestAngle);
    const SnapReport report = snap(forest, curves, options, {}, Context());
    EXPECT_EQ(forest.broken(), "");
    sum.report.crossings += report.crossings;
    sum.report.residual += report.residual;
    sum.report.refused += report.refused;
    sum.report.facesAdded += report.facesAdded;
    sum.faces += forest.faceCount();
    sum.gaps += gapsOf(forest);
    const FaceQuality quality = faceQuality(forest, Context());
    sum.smallest = std::min(sum.smallest, quality.smallestAngle);
    sum.degenerate += quality.degenerate;
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      sum.flipped += forest.facetNormal(f).z() < 0.0 ? 1 : 0;
    }
    for (const Forest::Vertex& v : forest.vertices)
    {
      if (v.curveId >= 0)
      {
        ++sum.snapped;
        sum.offCurve = std::max(sum.offCurve, (curve.position(v.curveParam) - v.position).norm());
      }
    }
  }
  return sum;
}

} // namespace

TEST(D9_1, PlanarCurvesAreFollowedWithoutHarm)
{
  for (const bool spirals : { false, true })
  {
    SnapOptions none;
    none.maximumResidualRounds = 0;
    const Planar without = snapPlanar(spirals, none), with = snapPlanar(spirals, {});
    std::ostringstream text;
    text << (spirals ? "25 spirals" : "60 lines") << ": " << with.report.crossings << " crossings, residual "
         << without.report.residual << " -> " << with.report.residual << " (" << with.report.facesAdded
         << " of " << with.faces << " faces added, " << with.report.refused << " moves refused), flipped "
         << with.flipped << ", smallest angle " << with.smallest << " (before " << with.finest
         << "), off C by " << with.offCurve << ", " << with.gaps << " gaps (" << without.gaps << ") among "
         << with.snapped;
    fact("D9_1", text.str());
    EXPECT_EQ(with.report.residual, 0);
    EXPECT_EQ(with.flipped, 0);
    EXPECT_GT(with.smallest, 4.0);
    EXPECT_LE(with.offCurve, 1e-12);
    EXPECT_EQ(with.gaps, 0);
    EXPECT_EQ(without.gaps, without.report.residual);
    EXPECT_GT(without.report.residual, 0);
    EXPECT_GT(with.snapped, with.report.crossings / 3);
  }
}

TEST(D9_2, VerticesMoveAlongTheirEdgesAndRefiningFollows)
{
  double offEdge = 0.0, offCurve = 0.0;
  int snapped = 0, followed = 0, crossed = 0, gaps = 0, flipped = 0, faces = 0;
  unsigned seed = 0;
  for (const FeatureCurve& curve : planarCurves(true))
  {
    const FeatureCurves curves{ curve };
    Forest forest = squareForest(16, 1.0 / 6.0, ++seed);
    refineNear(forest, curves, 0.06, 0.03);
    const Forest before = forest;
    SnapOptions options;
    options.maximumResidualRounds = 0;
    snapped += snap(forest, curves, options, {}, Context()).snapped;
    for (int v = 0; v < static_cast<int>(before.vertices.size()); ++v)
    {
      const Vector3 at = before.vertices[v].position, move = forest.vertices[v].position - at;
      EXPECT_TRUE(move.isZero(0.0) || forest.vertices[v].curveId == 0);
      // Neighbours may have moved before, along their own edges.
      double nearest = std::numeric_limits<double>::infinity();
      for (const Forest& ends : { before, forest })
        forest.link(v,
          [&](int w)
          {
            const Vector3 edge = ends.vertices[w].position - at;
            nearest = std::min(nearest, edge.cross(move).norm() / edge.norm());
            EXPECT_LT(move.norm(), 0.1);
          });
      offEdge = std::max(offEdge, nearest);
    }
    forest = before;
    crossed += snap(forest, curves, {}, {}, Context()).residual;
    const int had = forest.vertexCount();
    refineNear(forest, curves, 0.06, 0.0075, { &curves, {}, 0.0 });
    EXPECT_EQ(forest.broken(), "");
    for (int v = had; v < static_cast<int>(forest.vertices.size()); ++v)
      if (forest.vertices[v].curveId >= 0)
      {
        ++followed;
        EXPECT_TRUE(forest.vertices[v].moved & Forest::Placed);
        offCurve = std::max(
          offCurve, (curve.position(forest.vertices[v].curveParam) - forest.vertices[v].position).norm());
      }
    gaps += gapsOf(forest);
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      flipped += forest.facetNormal(f).z() <= 0.0 ? 1 : 0;
    }
    faces += forest.faceCount();
  }
  std::ostringstream text;
  text << "25 spirals: " << snapped << " vertices moved off their edges by " << offEdge
       << "; refined to a quarter: " << followed << " more on C, off it by " << offCurve << ", " << gaps
       << " gaps from " << crossed << " residual crossings, " << flipped << " of " << faces
       << " faces flipped";
  fact("D9_2", text.str());
  EXPECT_LE(offEdge, 1e-12);
  EXPECT_LE(offCurve, 1e-12);
  EXPECT_GT(followed, 2 * snapped);
  EXPECT_EQ(crossed, 0);
  EXPECT_EQ(gaps, 0);
  EXPECT_EQ(flipped, 0);
}

TEST(D9_1, AsPublishedTrianglesCollapse)
{
  SnapOptions published;
  published.order = SnapOrder::AllAtOnce;
  const Planar lines = snapPlanar(false, published), spirals = snapPlanar(true, published);
  // On 512 triangles as they are, too.
  int coarse = 0;
  for (int i = 0; i < 200; ++i)
  {
    std::mt19937 random(100 + i);
    const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const bool across = i % 2 == 0;
    const double from = uniform(), to = uniform();
    const FeatureCurves curves{ featureCurve(
      across ? std::vector<Vector3>{ { -0.01, from, 0.0 }, { 1.01, to, 0.0 } }
             : std::vector<Vector3>{ { from, -0.01, 0.0 }, { to, 1.01, 0.0 } }) };
    Forest forest = squareForest(16, 1.0 / 6.0);
    const SnapReport report = snap(forest, curves, published, {}, Context());
    EXPECT_EQ(report.facesAdded + report.refused + report.residual, 0);
    coarse += faceQuality(forest, Context()).degenerate;
  }
  std::ostringstream text;
  text << "as published: lines " << lines.degenerate << " degenerate (about 8,600), spirals "
       << spirals.degenerate << " (10,500) and " << spirals.flipped
       << " flipped (2,300); 200 lines over 512 faces " << coarse << " degenerate (8,496)";
  fact("D9_1", text.str());
  EXPECT_GT(lines.degenerate, 5000);
  EXPECT_GT(spirals.degenerate, 5000);
  EXPECT_GT(spirals.flipped, 1000);
  EXPECT_GT(coarse, 5000);
}
