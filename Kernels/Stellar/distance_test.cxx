#include "Harness/forest_shapes.h"
#include "Stellar/crossed_faces.h"
#include "Stellar/distance.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::vector<Reached> reachedBy(const Forest& forest,
  const FeatureCurves& curves,
  const ReachOptions& options,
  const Context& context = Context())
{
  const CurveSearch search(curves);
  const CrossedFaces crossed(forest, search, context);
  return CurveReach(forest, search).find(0, crossed.faces(0), options, context);
}

// A cylinder of radius 1 round the z axis, and a line along it at angle 0, with normals.
FeatureCurve lineAlongCylinder(double length)
{
  FeatureCurve curve = featureCurve({ { 1, 0, 0.02 }, { 1, 0, length - 0.02 } });
  curve.normals.assign(2, Vector3(1, 0, 0));
  return curve;
}

} // namespace

TEST(CrossedFaces, FacesAreThoseThatALineCrosses)
{
  const Forest forest = quadForest(8, 8);
  const FeatureCurves curves{ featureCurve({ { 0.03, 0.3, 0 }, { 0.91, 0.62, 0 } }) };
  const CurveSearch search(curves);
  const std::vector<int> faces = CrossedFaces(forest, search, Context()).faces(0);
  // Sampled densely: what holds a sample is passed through.
  std::set<int> expected;
  for (int i = 0; i <= 100000; ++i)
  {
    const Vector3 x = curves[0].position(curves[0].length * i / 100000);
    const int cell = int(x.y() * 8) * 8 + int(x.x() * 8);
    const double u = x.x() * 8 - int(x.x() * 8), v = x.y() * 8 - int(x.y() * 8);
    expected.insert(2 * cell + (v > u));
  }
  EXPECT_EQ(faces, std::vector<int>(expected.begin(), expected.end()));
}

TEST(CrossedFaces, OtherSheetsAndTheFarSideOfAPlateAreNotPassed)
{
  // Three sheets closer to each other than their edges are long; the line is on the middle one.
  Mesh sheets = quadPairs(4, 4);
  for (double z : { 0.05, -0.05 })
  {
    sheets = joined(sheets, quadPairs(4, 4), Vector3(0, 0, z));
  }
  const Forest forest = forestOfPairs(sheets);
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.3, 0 }, { 0.5, 0.35, 0 }, { 0.9, 0.3, 0 } }) };
  const CurveSearch search(curves);
  const std::vector<int> faces = CrossedFaces(forest, search, Context()).faces(0);
  EXPECT_FALSE(faces.empty());
  for (int f : faces)
  {
    EXPECT_LT(f, 32);
  }
  // A closed plate, thinner than its edges are long: the side that looks away is not passed.
  FeatureCurve up = featureCurve({ { 1, 0, 0.02 }, { 1, 0, 1.98 } });
  up.normals.assign(2, Vector3(1, 0, 0));
  Mesh plate = cylinder(1.0, 2.0, 4, 2);
  for (Vector3& p : plate.points)
  {
    p.x() = p.x() > 0.5 ? 1.0 : p.x() < -0.5 ? 0.9 : 0.95;
  }
  const Forest thin = baseOf(plate);
  const FeatureCurves along{ up };
  const CurveSearch alongSearch(along);
  const std::vector<int> outer = CrossedFaces(thin, alongSearch, Context()).faces(0);
  EXPECT_FALSE(outer.empty());
  for (int f : outer)
  {
    EXPECT_GT(thin.facetNormal(f).x(), 0.0);
  }
}

TEST(CrossedFaces, GoesOnToTheChildren)
{
  Forest forest = quadForest(4, 4);
  const FeatureCurves curves{ featureCurve({ { 0.05, 0.3, 0 }, { 0.4, 0.71, 0 }, { 0.95, 0.12, 0 } }) };
  const CurveSearch search(curves);
  CrossedFaces crossed(forest, search, Context());
  std::mt19937 random(3);
  for (int i = 0; i < 200; ++i)
  {
    std::vector<Forest::Birth> births;
    forest.refine(anyFace(forest, random), {}, &births);
    crossed.follow(births);
  }
  EXPECT_EQ(crossed.faces(0), CrossedFaces(forest, search, twoThreads()).faces(0));
}

TEST(CrossedFaces, ACurveThatFloatsStillFindsTheSurface)
{
  const Forest forest = quadForest(16, 16);
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.3, 0.2 }, { 0.9, 0.3, 0.2 } }) };
  const CurveSearch search(curves);
  EXPECT_EQ(
    CrossedFaces(forest, search, Context()).faces(0).size(), 27u); // 13 cells of two, and the half of one
}

TEST(Distance, AFrontBehindAnEdgeIsExactInThePlane)
{
  std::mt19937 random(4);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  int straight = 0;
  for (int i = 0; i < 1000; ++i)
  {
    const double c = 0.1 + unit(random), sx = 3 * unit(random) - 1, sy = -unit(random),
                 vx = 3 * unit(random) - 1, vy = unit(random);
    const double found = unfoldedDistance(std::hypot(sx, sy), std::hypot(sx - c, sy), c, vx, vy);
    const double across = sx + (vx - sx) * -sy / (vy - sy);
    if (across > 1e-9 && across < c - 1e-9)
    {
      EXPECT_NEAR(found, std::hypot(vx - sx, vy - sy), 1e-9);
      ++straight;
    }
    else if (across < -1e-9 || across > c + 1e-9)
    {
      EXPECT_FALSE(std::isfinite(found));
    }
  }
  EXPECT_GT(straight, 250);
  EXPECT_FALSE(std::isfinite(unfoldedDistance(1.0, 5.0, 1.0, 0.5, 1.0)));
  EXPECT_FALSE(std::isfinite(unfoldedDistance(1.0, 1.0, 0.0, 0.5, 1.0)));
}

TEST(Distance, AFrontOnAPlaneIsNeverShortAndSeldomLong)
{
  Mesh mesh = quadPairs(60, 60);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0 / 6, 1.0 / 6);
  for (Vector3& p : mesh.points)
  {
    p += Vector3(unit(random), unit(random), 0) / 60;
  }
  const Forest forest = baseOf(mesh);
  const FeatureCurves curves{ featureCurve({ { 0.4, 0.5, 0 }, { 0.6, 0.52, 0 } }) };
  const CurveSearch search(curves);
  ReachOptions options;
  options.radius = 0.3;
  options.kind = CurveDistance::Geodesic;
  double least = 2.0, most = 0.0;
  int count = 0, rough = 0;
  for (const Reached& r : reachedBy(forest, curves, options))
  {
    const double exact = search.nearest(0, forest.vertices[r.vertex].position).distance;
    if (exact > 0.0)
    {
      least = std::min(least, r.distance / exact);
      most = std::max(most, r.distance / exact);
      ++count;
      rough += r.distance > 1.05 * exact;
    }
  }
  EXPECT_GE(least, 1.0);
  EXPECT_LE(most, 1.2); // beside the ends, where the front starts from three or four vertices
  EXPECT_LE(rough, count / 50);
}

TEST(D8_3, ASheetBesideTheStrokeIsOutOfReach)
{
  Mesh sheets = joined(quadPairs(8, 8), quadPairs(8, 8), Vector3(0, 0, 0.04));
  const Forest forest = forestOfPairs(sheets);
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.3, 0 }, { 0.9, 0.3, 0 } }) };
  const auto countAbove = [&](const ReachOptions& options)
  {
    int above = 0;
    for (const Reached& r : reachedBy(forest, curves, options))
    {
      above += forest.vertices[r.vertex].position.z() > 0.02;
    }
    return above;
  };
  EXPECT_GT(countAbove({ 0.1, CurveDistance::Straight, false }), 0);
  EXPECT_EQ(countAbove({ 0.1, CurveDistance::Straight, true }), 0);
  EXPECT_EQ(countAbove({ 0.1, CurveDistance::Geodesic, true }), 0);
  fact("D8_3",
    "sheet at 0.4 r beside a stroke: " + std::to_string(countAbove({ 0.1, CurveDistance::Straight, true })) +
      " vertices reached, as published " +
      std::to_string(countAbove({ 0.1, CurveDistance::Straight, false })));
}

TEST(D8_3, AFrontGoesRoundACylinder)
{
  const Forest forest = baseOf(cylinder(1.0, 2.0, 96, 24));
  const FeatureCurves curves{ lineAlongCylinder(2.0) };
  const double r = 1.9;
  double geodesic = 0.0, straight = 0.0, least = 2.0, most = 0.0;
  for (const Reached& reached : reachedBy(forest, curves, { r, CurveDistance::Geodesic, true }))
  {
    const Vector3& p = forest.vertices[reached.vertex].position;
    const double angle = std::abs(std::atan2(p.y(), p.x()));
    geodesic = std::max(geodesic, angle);
    if (angle > 0.1 && p.z() > 0.02 && p.z() < 1.98)
    {
      least = std::min(least, reached.distance / angle);
      most = std::max(most, reached.distance / angle);
    }
  }
  for (const Reached& reached : reachedBy(forest, curves, { r, CurveDistance::Straight, true }))
  {
    const Vector3& p = forest.vertices[reached.vertex].position;
    straight = std::max(straight, std::abs(std::atan2(p.y(), p.x())));
  }
  EXPECT_LE(geodesic, 1.02 * r);
  EXPECT_GE(geodesic, 0.95 * r);
  EXPECT_NEAR(2 * std::sin(straight / 2), r, 0.1); // 2 rho sin(theta / 2)
  EXPECT_GE(least, 0.98);
  EXPECT_LE(most, 1.02);
  fact("D8_3",
    "cylinder, r = 1.9 rho: a front reaches " + std::to_string(geodesic / r) +
      " r (limit 1.02), its distances " + std::to_string(least) + " to " + std::to_string(most) +
      " of rho theta; straight reaches " + std::to_string(straight / r) + " r round");
}

TEST(Distance, ASnappedVertexIsOnItsCurve)
{
  Forest forest = quadForest(8, 8);
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.3, 0 }, { 0.9, 0.3, 0 } }) };
  const int v = 9 * 3 + 4; // near it
  forest.vertices[v].curveId = 0;
  forest.vertices[v].curveParam = 0.123;
  for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
  {
    bool found = false;
    for (const Reached& r : reachedBy(forest, curves, { 0.2, kind, true }))
    {
      if (r.vertex == v)
      {
        EXPECT_EQ(r.distance, 0.0);
        EXPECT_EQ(r.parameter, 0.123);
        found = true;
      }
    }
    EXPECT_TRUE(found);
  }
}

// Lines that cross a coarse mesh in bends, some between sheets, so that what a radius reaches is in pieces at
// times; in half of the runs most new vertices lie far off, so that what was whole comes apart.
TEST(Distance, WhatIsFollowedIsWhatIsFoundAnew)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.02, 0.98);
  const auto place = [&] { return Vector3(unit(random), unit(random), 0.0); };
  std::size_t found = 0;
  for (int run = 0; run < 60; ++run)
  {
    Forest forest = run % 3 ? quadForest(6, 6)
                            : forestOfPairs(joined(quadPairs(6, 6), quadPairs(6, 6), Vector3(0, 0, 0.04)));
    const FeatureCurves curves{ featureCurve({ place(), place(), place() }),
      featureCurve({ place(), place() }) };
    const CurveSearch search(curves);
    CrossedFaces crossed(forest, search, Context());
    CurveReach followed(forest, search, true);
    const MidpointRule far{ nullptr,
      [&](const SourcePlace& at) { return Vector3(at.position + Vector3(0, 0, unit(random) < 0.6)); },
      1e9 };
    const ReachOptions options{ 0.02 + 0.2 * unit(random), CurveDistance::Straight, true };
    for (int sweep = 0; sweep < 12; ++sweep)
    {
      for (int k = 0; k < 2; ++k)
      {
        CurveReach anew(forest, search);
        const std::vector<Reached>& all = anew.find(k, crossed.faces(k), options, Context());
        const std::vector<Reached>& kept = followed.find(k, crossed.faces(k), options, twoThreads());
        ASSERT_EQ(kept.size(), all.size()) << "run " << run << ", sweep " << sweep << ", curve " << k;
        found += all.size();
        for (std::size_t i = 0; i < all.size(); ++i)
        {
          ASSERT_EQ(kept[i].vertex, all[i].vertex);
          ASSERT_EQ(kept[i].distance, all[i].distance);
          ASSERT_EQ(kept[i].parameter, all[i].parameter);
          ASSERT_EQ(followed.distance(all[i].vertex), all[i].distance);
        }
      }
      std::vector<Forest::Birth> births;
      for (int i = 0; i < 1 << (sweep / 2); ++i)
      {
        forest.refine(anyFace(forest, random), run % 2 ? MidpointRule() : far, &births);
      }
      crossed.follow(births);
      followed.follow(births);
    }
  }
  EXPECT_GT(found, 10000u);
}

TEST(Distance, ThreadsChangeNothing)
{
  const Forest forest = baseOf(icosphere(5));
  const FeatureCurves curves{ featureCurve({ { 1, 0, 0 }, { 0.8, 0.6, 0 }, { 0.6, 0.64, 0.48 } }) };
  for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
  {
    for (bool connected : { true, false })
    {
      const ReachOptions options{ 0.5, kind, connected };
      const auto one = reachedBy(forest, curves, options),
                 two = reachedBy(forest, curves, options, twoThreads());
      ASSERT_EQ(one.size(), two.size());
      EXPECT_GT(one.size(), 1000u);
      for (std::size_t i = 0; i < one.size(); ++i)
      {
        EXPECT_EQ(one[i].vertex, two[i].vertex);
        EXPECT_EQ(one[i].distance, two[i].distance);
        EXPECT_EQ(one[i].parameter, two[i].parameter);
      }
    }
  }
}
