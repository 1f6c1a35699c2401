#include "Stellar/displace.h"

#include "Harness/face_quality.h"
#include "Harness/feature_shapes.h"
#include "Stellar/snap.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

DisplaceOptions shapeOf(double radius, double height, double sharpness)
{
  DisplaceOptions options;
  options.radius = radius;
  options.height = height;
  options.sharpness = sharpness;
  return options;
}

// The square from (-1, -1) to (1, 1), fine enough that |y| takes r / 2 and 3 r / 4 for r = 0.5.
Forest flatField()
{
  Forest forest = quadForest(32, 32, 2.0, 2.0);
  for (Forest::Vertex& v : forest.vertices)
  {
    v.position -= Vector3(1.0, 1.0, 0.0);
  }
  needBaseNormals(forest, Context());
  return forest;
}

const FeatureCurves& lineAlongX()
{
  static const FeatureCurves curves{ featureCurve({ { -2, 0, 0 }, { 0.3, 0, 0 }, { 2, 0, 0 } }) };
  return curves;
}

void expectRefused(const FeatureCurves& curves, const DisplaceOptions& options, const std::string& words)
{
  Forest forest = flatField();
  try
  {
    displace(forest, curves, options, Context());
    FAIL() << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
  for (const Forest::Vertex& v : forest.vertices)
  {
    EXPECT_EQ(v.position.z(), 0.0);
  }
}

} // namespace

TEST(D10_1, ALineRaisesItsProfileOverAPlane)
{
  const Forest plane = flatField();
  const double r = 0.5, h = 0.3;
  double worst = 0.0;
  int inside = 0;
  for (const double s : { 0.0, 0.3, 0.5, 1.0, 1.5, 2.0 })
  {
    Forest forest = plane;
    const DisplaceReport report = displace(forest, lineAlongX(), shapeOf(r, h, s), Context());
    EXPECT_EQ(report.peak, 1.0);
    EXPECT_EQ(report.flipped, 0);
    int moved = 0;
    for (std::size_t i = 0; i < plane.vertices.size(); ++i)
    {
      const Vector3 &p = plane.vertices[i].position, &q = forest.vertices[i].position;
      EXPECT_EQ(p.x(), q.x());
      EXPECT_EQ(p.y(), q.y());
      const double y = std::abs(p.y());
      if (y >= r)
      {
        EXPECT_EQ(q.z(), 0.0);
        EXPECT_EQ(forest.feature[i], 0.0);
        EXPECT_FALSE(forest.vertices[i].moved & Forest::Displaced);
        continue;
      }
      ++moved;
      EXPECT_TRUE(forest.vertices[i].moved & Forest::Displaced);
      EXPECT_EQ(forest.displacement[i], Vector3(q - p));
      const double law = h * std::pow(1.0 - y / r, s);
      worst = std::max(worst, std::abs(q.z() - law));
      if (s == 2.0 && y == 0.5 * r)
      {
        EXPECT_NEAR(q.z(), h / 4.0, 1e-15);
      }
      if (s == 0.5 && y == 0.75 * r)
      {
        EXPECT_NEAR(q.z(), h / 2.0, 1e-15);
      }
      if (s == 0.0)
      {
        EXPECT_EQ(q.z(), h);
      }
    }
    EXPECT_EQ(report.moved, moved);
    inside += moved;
  }
  EXPECT_LT(worst, 1e-15);

  Forest roof = plane, polyline = plane;
  DisplaceOptions options = shapeOf(r, h, 7.0);
  options.profile = Profile::polyline("0 1, 1 0");
  displace(polyline, lineAlongX(), options, Context());
  displace(roof, lineAlongX(), shapeOf(r, h, 1.0), Context());
  for (std::size_t i = 0; i < plane.vertices.size(); ++i)
  {
    EXPECT_EQ(roof.vertices[i].position, polyline.vertices[i].position);
  }
  std::ostringstream text;
  text << "plane, s = 0 to 2: z within " << worst << " of h (1 - |y| / r)^s at " << inside
       << " vertices, x and y and |y| >= r bitwise the same, \"0 1, 1 0\" is s = 1 to the bit";
  fact("D10_1", text.str());
}

TEST(D10_2, SnappedTheCrestReachesTheHeight)
{
  const double h = 0.1;
  double least = 1.0, most = 0.0;
  int cases = 0;
  for (const bool spirals : { false, true })
    for (const FeatureCurve& curve : planarCurves(spirals))
    {
      const FeatureCurves curves{ curve };
      Forest rough = squareForest(16, 1.0 / 6.0, ++cases);
      refineNear(rough, curves, 0.06, 0.015);
      needBaseNormals(rough, Context());
      Forest snapped = rough;
      snap(snapped, curves, {}, {}, Context());
      const auto peakOf = [&](Forest& forest)
      {
        displace(forest, curves, shapeOf(0.06, h, 1.5), Context());
        double peak = 0.0;
        for (const Forest::Vertex& v : forest.vertices)
        {
          peak = std::max(peak, v.position.z());
        }
        return peak;
      };
      EXPECT_NEAR(peakOf(snapped), h, 1e-12);
      const double without = peakOf(rough);
      EXPECT_LT(without, h);
      least = std::min(least, without / h);
      most = std::max(most, without / h);
      // The whole crest stands at h, so its edges do.
      int crest = 0;
      for (std::size_t i = 0; i < snapped.vertices.size(); ++i)
      {
        EXPECT_EQ(snapped.vertices[i].curveId, -1);
        if (snapped.vertices[i].moved & Forest::Crest)
        {
          ++crest;
          EXPECT_NEAR(snapped.vertices[i].position.z(), h, 1e-12);
          EXPECT_EQ(snapped.feature[i], 1.0);
        }
      }
      EXPECT_GT(crest, 10);
      EXPECT_FALSE(snapped.hasBaseNormals);
    }
  std::ostringstream text;
  text << cases << " planar curves: snapped every crest is h to 1e-12; not snapped the greatest is " << least
       << " to " << most << " h";
  fact("D10_2", text.str());
}

TEST(D10_3, OppositeHeightsAreOppositeAndASphereRisesRadially)
{
  Forest sphere = baseOf(icosphere(5));
  for (Forest::Vertex& v : sphere.vertices)
  {
    v.baseNormal = v.position.normalized();
  }
  sphere.hasBaseNormals = true;
  std::vector<Vector3> ring;
  for (int i = 0; i < 200; ++i)
  {
    const double a = 2.0 * pi * i / 200.0;
    ring.emplace_back(std::cos(a) * std::cos(0.3), std::sin(a) * std::cos(0.3), std::sin(0.3));
  }
  const FeatureCurves curves{ featureCurve(ring, true) };
  Forest up = sphere, down = sphere;
  const DisplaceReport report = displace(up, curves, shapeOf(0.4, 0.2, 1.5), Context());
  displace(down, curves, shapeOf(0.4, -0.2, 1.5), Context());
  double aside = 0.0, off = 0.0;
  for (std::size_t i = 0; i < sphere.vertices.size(); ++i)
  {
    EXPECT_EQ(up.displacement[i], Vector3(-down.displacement[i]));
    const Vector3 &before = sphere.vertices[i].position, &after = up.vertices[i].position;
    aside = std::max(aside, before.normalized().cross(after).norm());
    off = std::max(off, std::abs(after.norm() - before.norm() - 0.2 * up.feature[i]));
  }
  EXPECT_GT(report.moved, 1000);
  EXPECT_LT(aside, 1e-12);
  EXPECT_LT(off, 1e-12);
  std::ostringstream text;
  text << "h and -h opposite to the bit; " << report.moved << " vertices of a sphere move aside by " << aside
       << ", |v'| off |v| + h Phi by " << off;
  fact("D10_3", text.str());
}

TEST(D10_4, ASilhouettesVectorsReplaceTheHeight)
{
  const Vector3 shift(0.1, -0.2, 0.4);
  double worst = 0.0;
  int moved = 0;
  for (const double h : { 0.0, 0.3, -7.0 })
  {
    Forest forest = flatField();
    const Forest before = forest;
    std::vector<std::vector<Vector3>> sketch{ lineAlongX()[0].points };
    for (Vector3& p : sketch[0])
    {
      p += shift;
    }
    DisplaceOptions options = shapeOf(0.5, h, 1.5);
    options.sketch = &sketch;
    moved = displace(forest, lineAlongX(), options, Context()).moved;
    for (std::size_t i = 0; i < forest.vertices.size(); ++i)
    {
      const Vector3 move = forest.vertices[i].position - before.vertices[i].position;
      worst = std::max(worst, (move - forest.feature[i] * shift).norm());
    }
  }
  EXPECT_GT(moved, 100);
  EXPECT_LT(worst, 1e-15);

  // Between samples the sketch is interpolated as the curve is: a tilted one is followed exactly.
  Forest forest = flatField();
  const std::vector<std::vector<Vector3>> tilted{ { { -2, 0, -1 }, { 0.3, 0, 0.15 }, { 2, 0, 1 } } };
  DisplaceOptions options = shapeOf(0.5, 0.0, 1.5);
  options.sketch = &tilted;
  displace(forest, lineAlongX(), options, Context());
  for (std::size_t i = 0; i < forest.vertices.size(); ++i)
  {
    const Vector3& p = forest.vertices[i].position;
    EXPECT_NEAR(p.z(), forest.feature[i] * 0.5 * p.x(), 1e-15);
  }
  std::ostringstream text;
  text << "sketch C + t, h = 0, 0.3, -7: moves off Phi t by " << worst;
  fact("D10_4", text.str());
}

TEST(D10_5, CrossingsAreLevelAndPublishedTwiceAsHigh)
{
  const double h = 0.2;
  const FeatureCurves cross{ featureCurve({ { -0.9, 0, 0 }, { 0.9, 0, 0 } }),
    featureCurve({ { 0, -0.9, 0 }, { 0, 0.9, 0 } }) };
  Forest level = flatField(), sum = flatField();
  DisplaceOptions options = shapeOf(0.3, h, 1.5);
  EXPECT_EQ(displace(level, cross, options, Context()).peak, 1.0);
  options.combine = Combine::Sum;
  EXPECT_EQ(displace(sum, cross, options, Context()).peak, 2.0);
  const auto heightOf = [](const Forest& forest)
  {
    double z = 0.0;
    for (const Forest::Vertex& v : forest.vertices)
    {
      z = std::max(z, v.position.z());
    }
    return z;
  };
  EXPECT_NEAR(heightOf(level), h, 1e-15);
  EXPECT_NEAR(heightOf(sum), 2.0 * h, 1e-15);

  // A second stroke along the flank of a ridge: the ridge's own normals, not the plane's.
  Forest ridge = flatField();
  displace(ridge, lineAlongX(), shapeOf(0.5, 0.3, 1.0), Context());
  const Forest first = ridge;
  needBaseNormals(ridge, Context());
  const FeatureCurves flank{ featureCurve({ { -2, 0.25, 0.15 }, { 2, 0.25, 0.15 } }) };
  displace(ridge, flank, shapeOf(0.1, 0.05, 1.5), Context());
  const Vector3 normal = Vector3(0, 0.3, 0.5).normalized(); // of the flank, z = 0.3 (1 - y / 0.5)
  double turned = 0.0;
  int moved = 0;
  for (std::size_t i = 0; i < ridge.vertices.size(); ++i)
  {
    const Vector3 move = ridge.vertices[i].position - first.vertices[i].position;
    const bool border = std::abs(first.vertices[i].position.x()) == 1.0;
    if (ridge.feature[i] > 0.0 && !border)
    {
      ++moved;
      turned = std::max(turned, (move.normalized() - normal).norm());
    }
  }
  EXPECT_GT(moved, 50);
  EXPECT_LT(turned, 1e-12);
  std::ostringstream text;
  text << "two crossing lines: peak " << heightOf(level) / h << " h, published " << heightOf(sum) / h
       << " h; a second stroke on a flank rises along its normal to " << turned;
  fact("D10_5", text.str());
}

TEST(Displace, CurvesHaveTheirOwnValues)
{
  FeatureCurves curves{ featureCurve({ { -0.9, -0.5, 0 }, { 0.9, -0.5, 0 } }),
    featureCurve({ { -0.9, 0.5, 0 }, { 0.9, 0.5, 0 } }) };
  curves[1].radius = 0.25;
  curves[1].height = -0.1;
  curves[1].sharpness = 0.0;
  curves[0].pressure = { 0.0, 1.0 };
  curves[1].pressure = { 0.5, 0.5 };
  Forest forest = flatField();
  DisplaceOptions options = shapeOf(0.125, 0.2, 1.0);
  options.usePressure = true;
  displace(forest, curves, options, Context());
  for (const Forest::Vertex& v : forest.vertices)
  {
    const Vector3& p = v.position;
    if (std::abs(p.x()) <= 0.9)
    {
      const double first = 0.2 * (p.x() + 0.9) / 1.8 * std::max(0.0, 1.0 - std::abs(p.y() + 0.5) / 0.125);
      const double second = std::abs(p.y() - 0.5) < 0.25 ? -0.05 : 0.0;
      EXPECT_NEAR(p.z(), first + second, 1e-15);
    }
  }
}

TEST(Displace, TaperedLinesEndInPoints)
{
  const FeatureCurves curves{ featureCurve({ { -0.5, 0, 0 }, { 0.5, 0, 0 } }) };
  Forest forest = flatField();
  DisplaceOptions options = shapeOf(0.25, 0.2, 1.0);
  options.taper = 0.25;
  displace(forest, curves, options, Context());
  int beyond = 0, within = 0;
  for (const Forest::Vertex& v : forest.vertices)
  {
    const Vector3& p = v.position;
    const double end = 0.5 - std::abs(p.x());
    const double share = end >= 0.25 ? 1.0 : std::sin(2.0 * pi * std::max(0.0, end));
    const double height =
      share > 0.0 ? 0.2 * share * share * std::max(0.0, 1.0 - std::abs(p.y()) / (0.25 * share)) : 0.0;
    EXPECT_NEAR(p.z(), height, 1e-14);
    beyond += end < 0.0 && end > -0.25 && std::abs(p.y()) < 0.1;
    within += height > 0.0 && share < 1.0;
  }
  EXPECT_GT(beyond, 10) << "a round end would reach them";
  EXPECT_GT(within, 10);
}

TEST(Displace, PublishedNormalsAreThoseOfTheLeaves)
{
  Forest forest = flatField();
  for (Forest::Vertex& v : forest.vertices)
  {
    v.baseNormal = Vector3::UnitX();
  }
  Forest current = forest;
  DisplaceOptions options = shapeOf(0.5, 0.01, 1.0);
  displace(forest, lineAlongX(), options, Context());
  options.along = RiseAlong::Current;
  displace(current, lineAlongX(), options, Context());
  for (std::size_t i = 0; i < forest.vertices.size(); ++i)
  {
    EXPECT_EQ(forest.displacement[i], Vector3(0.01 * forest.feature[i], 0, 0));
    EXPECT_EQ(current.displacement[i], Vector3(0, 0, 0.01 * forest.feature[i]));
  }
}

TEST(Displace, CountsFacesThatTurn)
{
  // A bowl with h far beyond its radius of curvature turns over; a plane never does.
  Forest bowl = baseOf(icosphere(4));
  std::vector<Vector3> ring;
  for (int i = 0; i < 100; ++i)
  {
    const double a = 2.0 * pi * i / 100.0;
    ring.emplace_back(std::cos(a), std::sin(a), 0.0);
  }
  const FeatureCurves curves{ featureCurve(ring, true) };
  const std::vector<Vector3> before = positionsOf(bowl);
  const DisplaceReport report = displace(bowl, curves, shapeOf(0.8, -1.9, 0.0), Context());
  EXPECT_GT(report.flipped, 100);
  EXPECT_LE(report.flipped, flippedFaces(bowl, before, positionsOf(bowl)));
}

TEST(Displace, ASteepFlankOverAFallingSlopeHasNotTurnedOver)
{
  // A slope of 30 degrees and, across it, a flank of some 80 the other way: over 90 degrees, and all look up.
  Forest slope = baseOf(quadPairs(64, 64));
  for (Forest::Vertex& vertex : slope.vertices)
  {
    vertex.position.z() = std::tan(30.0 * pi / 180.0) * vertex.position.x();
    vertex.baseNormal = Vector3::UnitZ();
  }
  slope.hasBaseNormals = true;
  std::vector<Vector3> line;
  for (int i = 0; i <= 100; ++i)
  {
    line.emplace_back(0.5, 0.01 * i, 0.5 * std::tan(30.0 * pi / 180.0));
  }
  const std::vector<Vector3> before = positionsOf(slope);
  const DisplaceReport report =
    displace(slope, { featureCurve(line, false) }, shapeOf(0.15, 0.6, 0.2), Context());
  EXPECT_GT(flippedFaces(slope, before, positionsOf(slope)), 10);
  EXPECT_EQ(report.flipped, 0);
}

TEST(Displace, KeepsToTheSheetThatTheCurveIsOn)
{
  // Two sheets nearer to each other than the radius, the stroke on the upper one.
  Forest forest = forestOfPairs(joined(quadPairs(16, 16), quadPairs(16, 16), Vector3(0, 0, -0.1)));
  const FeatureCurves curves{ featureCurve({ { 0.2, 0.51, 0 }, { 0.8, 0.52, 0 } }) };
  const Forest start = forest;
  DisplaceOptions options = shapeOf(0.3, 0.01, 1.5);
  const int own = displace(forest, curves, options, Context()).moved;
  const std::size_t half = forest.vertices.size() / 2;
  for (std::size_t v = 0; v < forest.vertices.size(); ++v)
  {
    EXPECT_EQ(v >= half && forest.feature[v] != 0.0, false);
  }
  forest = start;
  options.connectedOnly = false;
  EXPECT_GT(displace(forest, curves, options, Context()).moved, 1.5 * own);
  forest = start;
  options.connectedOnly = true;
  options.distance = CurveDistance::Geodesic;
  const int geodesic = displace(forest, curves, options, Context()).moved;
  EXPECT_LE(geodesic, own);
  EXPECT_GT(geodesic, 0.9 * own);
}

TEST(Displace, AnotherHeightNeedsNoNewDistances)
{
  Forest start = baseOf(icosphere(4));
  needBaseNormals(start, Context());
  std::vector<Vector3> arc;
  for (int i = 0; i <= 100; ++i)
  {
    const double a = 0.02 * i;
    arc.emplace_back(std::cos(a), std::sin(a), 0.0);
  }
  const FeatureCurves curves{ featureCurve(arc) };
  const CurvesReached reached = reachedBy(start, curves, shapeOf(0.2, 0.0, 1.5), Context());
  Forest again; // goes from one to the next
  for (const double h : { 0.1, -0.05 })
    for (const double s : { 0.3, 1.5 })
    {
      Forest once = start;
      const DisplaceReport report = displace(once, curves, shapeOf(0.2, h, s), twoThreads());
      const Forest::Face* faces = again.faces.data();
      const DisplaceReport same = displace(start, curves, reached, shapeOf(0.2, h, s), Context(), again);
      EXPECT_TRUE(sameForest(once, again));
      EXPECT_EQ(report.flipped, same.flipped);
      EXPECT_EQ(report.crestSum, same.crestSum);
      EXPECT_TRUE(!faces || faces == again.faces.data());
    }
}

TEST(Displace, AFeatureStopsWithinTheRoomOfItsCurve)
{
  const double none = std::numeric_limits<double>::infinity();
  FeatureCurves curves = lineAlongX();
  curves[0].room = { { none, none }, { 0.2, none }, { none, none } };
  DisplaceOptions options = shapeOf(0.5, -1.0, 1.0);
  Forest forest = flatField();
  DisplaceReport report = displace(forest, curves, options, Context());
  EXPECT_EQ(report.heldBack, 1);
  EXPECT_NEAR(report.leastShare, 0.08, 1e-12);
  for (const Forest::Vertex& v : forest.vertices)
  {
    // Along the line 0.08 deep at x = 0.3, and from there deeper by no more than the way.
    const double depth = std::min(1.0, 0.08 + std::abs(v.position.x() - 0.3));
    EXPECT_GE(v.position.z(), -depth - 1e-12);
    if (v.position.y() == 0.0)
    {
      EXPECT_NEAR(v.position.z(), -depth, 1e-12);
    }
  }
  // Upwards there is room; as published nothing is asked.
  options.height = 1.0;
  forest = flatField();
  report = displace(forest, curves, options, Context());
  EXPECT_EQ(report.heldBack, 0);
  EXPECT_EQ(report.leastShare, 1.0);
  options.height = -1.0;
  options.holdBack = false;
  forest = flatField();
  EXPECT_EQ(displace(forest, curves, options, Context()).heldBack, 0);
  EXPECT_EQ(
    std::min_element(forest.vertices.begin(),
      forest.vertices.end(),
      [](const Forest::Vertex& a, const Forest::Vertex& b) { return a.position.z() < b.position.z(); })
      ->position.z(),
    -1.0);
}

TEST(Displace, CanBeCancelled)
{
  Forest forest = flatField();
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(displace(forest, lineAlongX(), shapeOf(0.5, 0.1, 1.0), context), Error);
}

TEST(Displace, RefusesWhatIsNoShape)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (const double r : { 0.0, -1.0, std::nan(""), inf })
  {
    expectRefused(lineAlongX(), shapeOf(r, 1.0, 1.0), "radius of feature curve 0");
  }
  expectRefused(lineAlongX(), shapeOf(1.0, inf, 1.0), "height of feature curve 0");
  expectRefused(lineAlongX(), shapeOf(1.0, 1.0, -0.1), "sharpness");
  DisplaceOptions options = shapeOf(1.0, 1.0, 1.0);
  std::vector<std::vector<Vector3>> sketch;
  options.sketch = &sketch;
  expectRefused(lineAlongX(), options, "sketch");
  sketch = { lineAlongX()[0].points };
  sketch[0].back().x() = std::nan("");
  expectRefused(lineAlongX(), options, "sketch");
  expectRefused({ featureCurve({ { 0, 0, 0 }, { 0, std::nan(""), 0 } }) }, shapeOf(1, 1, 1), "curve 0");

  // Tiny and huge radii do nothing, or take everything.
  Forest forest = flatField();
  EXPECT_LE(displace(forest, lineAlongX(), shapeOf(1e-300, 1.0, 1.5), Context()).moved, 33);
  forest = flatField();
  EXPECT_EQ(displace(forest, lineAlongX(), shapeOf(1e300, 1.0, 1.5), Context()).moved, 33 * 33);
  Forest empty;
  EXPECT_EQ(displace(empty, lineAlongX(), shapeOf(1, 1, 1), Context()).moved, 0);
  EXPECT_EQ(displace(forest, {}, shapeOf(1, 1, 1), Context()).moved, 0);
}
