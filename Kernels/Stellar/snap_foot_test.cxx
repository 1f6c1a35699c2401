#include "Stellar/snap_foot.h"

#include "Harness/face_quality.h"
#include "Harness/feature_shapes.h"
#include "Stellar/displace.h"
#include "Stellar/snap.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double radius = 0.1;

FeatureCurves lineAcross()
{
  return { featureCurve({ { 0.0, 0.47, 0.0 }, { 1.0, 0.53, 0.0 } }) };
}

Forest refinedAndSnapped(const FeatureCurves& curves, double sharpness)
{
  RefineOptions options;
  options.radius = radius;
  options.sharpness = sharpness;
  Forest forest = refine(squareForest(16, 1.0 / 6.0), curves, options, {}, Context());
  snap(forest, curves, {}, {}, Context());
  return canonical(forest, Context()).forest; // no unused slots
}

FootOptions footOf(double sharpness)
{
  FootOptions options;
  options.radius = radius;
  options.sharpness = sharpness;
  return options;
}

// Edges with an end on either side of a distance from the first curve.
int crossed(const Forest& forest, const FeatureCurves& curves, double distance)
{
  const CurveSearch search(curves);
  const auto over = [&](int v) { return search.nearest(0, forest.vertices[v].position).distance - distance; };
  int count = 0;
  for (const Forest::Face& face : forest.faces)
  {
    for (int i = 0; i < 3; ++i)
    {
      const double a = over(face.v[i]), b = over(face.v[(i + 1) % 3]);
      count += face.v[i] < face.v[(i + 1) % 3] && a * b < 0.0 && std::min(std::abs(a), std::abs(b)) > 1e-9;
    }
  }
  return count;
}

// The feature's share of the height along a line at some distance from the curve: mean and standard
// deviation.
std::pair<double, double> heights(Forest forest,
  const FeatureCurves& curves,
  double sharpness,
  double distance)
{
  DisplaceOptions options;
  options.radius = radius;
  options.sharpness = sharpness;
  options.height = 1.0;
  displace(forest, curves, options, Context());
  const Vector3 along = (curves[0].points[1] - curves[0].points[0]).normalized();
  const Vector3 aside(-along.y(), along.x(), 0.0);
  double sum = 0.0, squares = 0.0;
  int count = 0;
  for (int i = 0; i < 400; ++i)
  {
    const Vector3 at = curves[0].points[0] + (0.2 + 0.6 * i / 400.0) * along + distance * aside;
    for (const Forest::Face& face : forest.faces)
    {
      Vector3 p[3];
      for (int k = 0; k < 3; ++k)
      {
        p[k] = forest.vertices[face.v[k]].position;
        p[k].z() = 0.0;
      }
      const double area = (p[1] - p[0]).cross(p[2] - p[0]).z();
      const double w1 = (at - p[0]).cross(p[2] - p[0]).z() / area,
                   w2 = (p[1] - p[0]).cross(at - p[0]).z() / area;
      if (w1 >= 0.0 && w2 >= 0.0 && w1 + w2 <= 1.0)
      {
        const double value = (1.0 - w1 - w2) * forest.feature[face.v[0]] + w1 * forest.feature[face.v[1]] +
                             w2 * forest.feature[face.v[2]];
        sum += value;
        squares += value * value;
        ++count;
        break;
      }
    }
  }
  EXPECT_EQ(count, 400);
  const double mean = sum / count;
  return { mean, std::sqrt(std::max(0.0, squares / count - mean * mean)) };
}

} // namespace

// Where it is steep the feature ends in a line of edges, and its wall is even.
TEST(Foot, ASteepFootHasNoTeeth)
{
  const FeatureCurves curves = lineAcross();
  for (const double sharpness : { 0.3, 0.5 })
  {
    const Forest before = refinedAndSnapped(curves, sharpness);
    Forest after = before.roomyCopy();
    const FootReport report = snapFoot(after, curves, footOf(sharpness), Context());
    EXPECT_EQ(after.broken(), "");
    const int was = crossed(before, curves, radius), left = crossed(after, curves, radius);
    EXPECT_LT(left, 0.03 * was);
    EXPECT_EQ(after.faceCount(), before.faceCount());
    EXPECT_GT(report.moved, 200);
    // Beyond the foot nothing rises, and within it all of it alike.
    const double beyondBefore = heights(before, curves, sharpness, 1.002 * radius).first,
                 beyondAfter = heights(after, curves, sharpness, 1.002 * radius).first;
    EXPECT_GT(beyondBefore, 0.01);
    EXPECT_LT(beyondAfter, 0.05 * beyondBefore);
    const double teethBefore = heights(before, curves, sharpness, 0.99 * radius).second,
                 teethAfter = heights(after, curves, sharpness, 0.99 * radius).second;
    EXPECT_LT(teethAfter, 0.6 * teethBefore);
    const double narrowest = faceQuality(after).smallestAngle;
    EXPECT_GE(narrowest, std::min(4.5, faceQuality(before).smallestAngle));
    // Old vertices kept their slots. On a plane nothing turns over, and the boundary keeps its shape.
    const std::vector<Vector3> from = positionsOf(before);
    for (int f = 0; f < static_cast<int>(after.faces.size()); ++f)
    {
      EXPECT_GT(after.facetNormal(f).z(), 0.0);
    }
    int moved = 0;
    for (int v = 0; v < static_cast<int>(from.size()); ++v)
    {
      const Vector3& to = after.vertices[v].position;
      EXPECT_EQ(to.z(), 0.0);
      for (int k = 0; k < 2; ++k)
      {
        EXPECT_TRUE((from[v][k] != 0.0 && from[v][k] != 1.0) || to[k] == from[v][k]);
      }
      moved += to != from[v] ? 1 : 0;
      EXPECT_TRUE(before.vertices[v].curveId < 0 || to == from[v]);
    }
    EXPECT_GT(moved, 200);
    RecordProperty("crossed", std::to_string(was) + " -> " + std::to_string(left));
    RecordProperty("beyond", std::to_string(beyondBefore) + " -> " + std::to_string(beyondAfter));
    RecordProperty("teeth", std::to_string(teethBefore) + " -> " + std::to_string(teethAfter));
  }
}

// A foot without a slope beyond bound is left to the bit, and so is the foot of a curve with a sharpness of
// its own beside a steep one.
TEST(Foot, OnlySteepFeetAreTouched)
{
  FeatureCurves curves = lineAcross();
  for (const double sharpness : { 1.0, 1.5, 3.0 })
  {
    Forest forest = refinedAndSnapped(curves, sharpness);
    const std::vector<Vector3> before = positionsOf(forest);
    EXPECT_EQ(snapFoot(forest, curves, footOf(sharpness), Context()).moved, 0);
    EXPECT_EQ(positionsOf(forest), before);
  }
  curves = { featureCurve({ { 0.2, 0.2, 0.0 }, { 0.8, 0.2, 0.0 } }),
    featureCurve({ { 0.2, 0.8, 0.0 }, { 0.8, 0.8, 0.0 } }) };
  curves[1].sharpness = 1.5;
  Forest forest = refinedAndSnapped(curves, 0.5);
  const std::vector<Vector3> before = positionsOf(forest);
  EXPECT_GT(snapFoot(forest, curves, footOf(0.5), Context()).moved, 100);
  for (int v = 0; v < static_cast<int>(before.size()); ++v)
  {
    EXPECT_TRUE(before[v].y() < 0.5 || forest.vertices[v].position == before[v]);
  }
}

TEST(Foot, OptionsOutOfTheirRangeAreRefused)
{
  const FeatureCurves curves = lineAcross();
  const auto refused = [&](const FootOptions& options)
  {
    Forest forest = squareForest(4);
    EXPECT_THROW(snapFoot(forest, curves, options, Context()), Error);
  };
  for (const double bad : { 0.0, -1.0, std::nan("") })
  {
    FootOptions options = footOf(0.5);
    options.radius = bad;
    refused(options);
  }
  FootOptions options = footOf(-1.0);
  refused(options);
  options = footOf(0.5);
  options.minimumAngle = 61.0;
  refused(options);
  options = footOf(0.5);
  options.parts = { 1 };
  refused(options);
}
