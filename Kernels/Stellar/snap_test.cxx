#include "Stellar/snap.h"

#include "Harness/features.h"
#include "Mesh/context.h"
#include "Stellar/quality.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

void refineNear(Forest& forest, const FeatureCurves& curves, double radius, double target)
{
  const CurveSearch search(curves);
  for (bool more = true; more;)
  {
    more = false;
    std::vector<int> marked;
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      const int* v = forest.faces[f].v;
      if ((forest.vertices[v[1]].position - forest.vertices[v[2]].position).norm() > target)
        for (int i = 0; i < 3; ++i)
          if (search.nearest(0, forest.vertices[v[i]].position, radius).segment >= 0)
          {
            marked.push_back(f);
            break;
          }
    }
    for (const int f : marked)
    {
      const Forest::Face& face = forest.faces[f];
      if ((forest.vertices[face.v[1]].position - forest.vertices[face.v[2]].position).norm() > target)
      {
        forest.refine(f, {});
        more = true;
      }
    }
  }
}

// 60 lines across the square and 25 spirals in it, the same on every machine.
std::vector<FeatureCurve> planarCurves(bool spirals)
{
  std::mt19937 random(7);
  const auto uniform = [&] { return static_cast<double>(random()) / 4294967296.0; };
  std::vector<FeatureCurve> curves;
  for (int i = 0; i < (spirals ? 25 : 60); ++i)
  {
    std::vector<Vector3> points;
    if (spirals)
    {
      const Vector3 middle(0.4 + 0.2 * uniform(), 0.4 + 0.2 * uniform(), 0.0);
      const double start = 2.0 * pi * uniform(), turns = 2.0 + uniform();
      for (int k = 0; k <= 300; ++k)
      {
        const double t = k / 300.0, a = start + 2.0 * pi * turns * t, r = 0.02 + 0.33 * t;
        points.push_back(middle + Vector3(r * std::cos(a), r * std::sin(a), 0.0));
      }
    }
    else
    {
      points = { { 0.05 + 0.9 * uniform(), 0.05 + 0.9 * uniform(), 0.0 }, Vector3::Zero() };
      do
      {
        points[1] = { 0.05 + 0.9 * uniform(), 0.05 + 0.9 * uniform(), 0.0 };
      } while ((points[1] - points[0]).norm() < 0.4);
    }
    curves.push_back(featureCurve(points));
  }
  return curves;
}

struct Planar
{
  SnapReport report;
  int before = 0, degenerate = 0, flipped = 0, snapped = 0, faces = 0;
  double smallest = 60.0, offCurve = 0.0, finest = 60.0;
  int gaps = 0; // neighbours along the curve that no edge joins
};

// A curve that all edges follow is a chain of edges, from each vertex on it to the next.
int gapsOf(const Forest& forest)
{
  std::vector<std::pair<double, int>> along;
  for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
  {
    if (forest.vertices[v].curveId >= 0)
    {
      along.emplace_back(forest.vertices[v].curveParam, v);
    }
  }
  std::sort(along.begin(), along.end());
  int gaps = 0;
  for (std::size_t i = 1; i < along.size(); ++i)
  {
    gaps += forest.faceWithEdge(along[i - 1].second, along[i].second) < 0 ? 1 : 0;
  }
  return gaps;
}

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
