#include "Harness/forest_shapes.h"
#include "Stellar/refine.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

FeatureCurves lineAcross()
{
  return { featureCurve({ { 0.0, 0.3, 0 }, { 1.0, 0.3, 0 } }) };
}

// Only generations end the refinement.
RefineOptions toGeneration(double radius, int generation)
{
  RefineOptions options;
  options.radius = radius;
  options.maximumGeneration = generation;
  options.targetEdgeLength = 1e-12;
  return options;
}

Forest refined(const Forest& forest,
  const FeatureCurves& curves,
  const RefineOptions& options,
  const Context& context = Context())
{
  return refine(forest, curves, options, {}, context);
}

double longestEdge(const Forest& forest)
{
  double longest = 0.0;
  for (const auto& [a, b] : edgesOf(forest))
  {
    longest = std::max(longest, (forest.vertices[a].position - forest.vertices[b].position).norm());
  }
  return longest;
}

double refinementEdge(const Forest& forest, const Forest::Face& face)
{
  return (forest.vertices[face.v[1]].position - forest.vertices[face.v[2]].position).norm();
}

} // namespace

TEST(D8_1, CountsOfTheUnitSquare)
{
  std::string reached;
  const int expected[][2] = { { 1216, 2368 }, { 764, 1472 } };
  for (int i = 0; i < 2; ++i)
  {
    const double r = i == 0 ? 0.1 : 0.05;
    const Forest forest = refined(quadForest(8, 8), lineAcross(), toGeneration(r, 6));
    EXPECT_EQ(forest.broken(), "");
    EXPECT_EQ(forest.vertexCount(), expected[i][0]);
    EXPECT_EQ(forest.faceCount(), expected[i][1]);
    reached += (i ? "; r = 0.05: " : "r = 0.1: ") + std::to_string(forest.vertexCount()) + " points, " +
               std::to_string(forest.faceCount()) + " faces";
  }
  fact("D8_1", reached);
}

TEST(D8_2, TheBandIsFullyRefinedOnceAndNothingElseIs)
{
  const Mesh mesh = icosphere(3);
  const Forest base = baseOf(mesh);
  FeatureCurve curve;
  for (int i = 0; i <= 40; ++i)
  {
    const double t = 1.2 * i / 40;
    curve.points.push_back(Vector3(std::cos(t), std::sin(t), 0.3 * std::sin(5 * t)).normalized());
  }
  curve.measure();
  const FeatureCurves curves{ curve };
  const CurveSearch search(curves);
  const double r = 0.06, edge = longestEdge(base);
  std::string reached;
  for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
  {
    RefineOptions options = toGeneration(r, 7);
    options.distance = kind;
    const Forest forest = refined(base, curves, options);
    EXPECT_EQ(forest.broken(), "");
    int touching = 0;
    double farthest = 0.0;
    for (const Forest::Face& face : forest.faces)
    {
      double least = std::numeric_limits<double>::infinity();
      for (int v : face.v)
      {
        least = std::min(least, search.nearest(0, forest.vertices[v].position).distance);
      }
      EXPECT_LE(face.gen, 7);
      if (least < (kind == CurveDistance::Straight ? r : 0.8 * r))
      {
        EXPECT_EQ(face.gen, 7);
        ++touching;
      }
      if (face.path > 1)
      {
        farthest = std::max(farthest, least);
      }
    }
    EXPECT_GT(touching, 1000);
    EXPECT_LE(farthest, r + 3 * edge);
    int sweeps = -1;
    const Forest again = refine(forest, curves, options, {}, Context(), &sweeps);
    EXPECT_TRUE(sameForest(again, forest));
    EXPECT_EQ(sweeps, 0);
    // Base points are where they were, roots that were not reached are as they were.
    const std::vector<int> under = facesUnder(base, forest);
    int kept = 0;
    for (int f = 0; f < forest.faceCount(); ++f)
    {
      const Forest::Face &face = forest.faces[f], &root = base.faces[under[f]];
      if (face.path == 1)
      {
        ++kept;
        EXPECT_TRUE(std::equal(face.v, face.v + 3, root.v));
      }
    }
    EXPECT_GT(kept, base.faceCount() / 2);
    for (int v = 0; v < base.vertexCount(); ++v)
    {
      EXPECT_EQ(forest.vertices[v].position, base.vertices[v].position);
    }
    reached += (kind == CurveDistance::Straight ? "straight: " : "; geodesic: ") + std::to_string(touching) +
               " faces at dist < r, all of generation 7; again: no change; refined faces within r + " +
               std::to_string((farthest - r) / edge) + " base edges; " + std::to_string(kept) + " of " +
               std::to_string(base.faceCount()) + " base faces untouched";
  }
  fact("D8_2", reached);
}

TEST(D8_3, AParallelSheetIsNotRefined)
{
  const Forest base = forestOfPairs(joined(quadPairs(8, 8), quadPairs(8, 8), Vector3(0, 0, 0.04)));
  const auto above = [&](bool asPublished)
  {
    RefineOptions options = toGeneration(0.1, 6);
    options.connectedOnly = options.seedCurveFaces = !asPublished;
    int count = 0;
    for (const Forest::Face& face : refined(base, lineAcross(), options).faces)
    {
      count += face.root >= 128 && face.path > 1;
    }
    return count;
  };
  EXPECT_EQ(above(false), 0);
  EXPECT_GT(above(true), 1000);
  fact("D8_3",
    "faces refined on a sheet at 0.4 r: " + std::to_string(above(false)) + ", as published " +
      std::to_string(above(true)));
}

TEST(Refine, ACurveBetweenVerticesIsFoundByItsFaces)
{
  // r is far smaller than a face, so no vertex is in reach at first.
  const FeatureCurves curves{ featureCurve({ { 0.31, 0.36, 0 }, { 0.33, 0.43, 0 } }) };
  RefineOptions options;
  options.radius = 0.004;
  int sweeps = 0;
  const Forest forest = refine(quadForest(2, 2), curves, options, {}, Context(), &sweeps);
  EXPECT_GT(sweeps, 10);
  for (const Forest::Face& face : forest.faces)
  {
    for (int v : face.v)
    {
      if (CurveSearch(curves).nearest(0, forest.vertices[v].position).distance < options.radius &&
          face.gen < options.maximumGeneration)
      {
        EXPECT_LE(refinementEdge(forest, face), options.radius / 4);
      }
    }
  }
  options.seedCurveFaces = false; // as published
  EXPECT_EQ(refined(quadForest(2, 2), curves, options).faceCount(), 8);
}

TEST(Refine, TargetLengthsFollowRadiusAndSharpness)
{
  const auto longestInside = [&](double sharpness, bool fineFoot, std::optional<double> own)
  {
    FeatureCurves curves = lineAcross();
    curves[0].sharpness = own;
    RefineOptions options;
    options.radius = 0.1;
    options.sharpness = sharpness;
    options.fineFoot = fineFoot;
    const Forest forest = refined(quadForest(8, 8), curves, options);
    double longest = 0.0;
    for (const Forest::Face& face : forest.faces)
    {
      for (int v : face.v)
      {
        if (std::abs(forest.vertices[v].position.y() - 0.3) < 0.1)
        {
          longest = std::max(longest, refinementEdge(forest, face));
        }
      }
    }
    return longest;
  };
  for (double sharp : { 1.0, 1.5, 2.0 })
  {
    EXPECT_LE(longestInside(sharp, true, {}), 0.025);
    EXPECT_GT(longestInside(sharp, true, {}), 0.0125);
  }
  EXPECT_LE(longestInside(0.3, true, {}), 0.0125);
  EXPECT_GT(longestInside(0.3, false, {}), 0.0125);
  EXPECT_LE(longestInside(3.0, true, {}), 0.0125);
  EXPECT_GT(longestInside(3.0, false, {}), 0.0125);
  EXPECT_LE(longestInside(1.5, true, 0.3), 0.0125); // the curve's own goes first
}

// A profile that ends in a cliff: where the feature ends, teeth are as wide as edges are long.
TEST(Refine, TheFootOfASteepProfileIsFineAndNothingElse)
{
  const auto longest = [](double sharpness, bool fineFoot, bool atFoot)
  {
    RefineOptions options;
    options.radius = 0.1;
    options.sharpness = sharpness;
    options.fineFoot = fineFoot;
    const Forest forest = refined(quadForest(8, 8), lineAcross(), options);
    double length = 0.0;
    for (const Forest::Face& face : forest.faces)
    {
      int inside = 0;
      for (int v : face.v)
      {
        inside += std::abs(forest.vertices[v].position.y() - 0.3) < 0.1 ? 1 : 0;
      }
      if (inside > 0 && (inside < 3) == atFoot)
      {
        length = std::max(length, refinementEdge(forest, face));
      }
    }
    return length;
  };
  EXPECT_LE(longest(0.5, true, true), 0.1 / 32);
  EXPECT_GT(longest(0.5, true, false), 0.1 / 16); // inside it is an eighth
  EXPECT_LE(longest(0.5, true, false), 0.1 / 8);
  EXPECT_GT(longest(0.5, false, true), 0.1 / 8);
  EXPECT_GT(longest(1.0, true, true), 0.1 / 8);
}

// Two lines that cross: where one ends in the midst of the other there is no cliff, since the nearest counts.
TEST(Refine, AFootInTheMidstOfAnotherCurveIsNone)
{
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.31, 0 }, { 0.9, 0.31, 0 } }),
    featureCurve({ { 0.47, 0.05, 0 }, { 0.47, 0.95, 0 } }) };
  RefineOptions options;
  options.radius = 0.1;
  options.sharpness = 0.5;
  const Forest forest = refined(quadForest(8, 8), curves, options);
  const CurveSearch search(curves);
  int hidden = 0, seen = 0;
  for (const Forest::Face& face : forest.faces)
  {
    double least[3];
    bool foot = false;
    for (int k = 0; k < 2; ++k)
    {
      int inside = 0;
      for (int i = 0; i < 3; ++i)
      {
        const double d = search.nearest(k, forest.vertices[face.v[i]].position).distance;
        least[i] = k == 0 ? d : std::min(least[i], d);
        inside += d < 0.1;
      }
      foot = foot || (inside > 0 && inside < 3);
    }
    const double farthest = *std::max_element(least, least + 3);
    if (foot && farthest >= 0.1)
    {
      ++seen;
      EXPECT_LE(refinementEdge(forest, face), 0.1 / 32);
    }
    else if (foot && farthest < 0.06) // beyond what the visible foot's fine faces spread to
    {
      ++hidden;
      EXPECT_GT(refinementEdge(forest, face), 0.1 / 32);
    }
  }
  EXPECT_GT(seen, 1000);
  EXPECT_GT(hidden, 20);
}

TEST(Refine, MovedToAnyPlaceAndScaleItIsTheSame)
{
  const Mesh mesh = icosphere(2);
  const auto faces = [&](double scale, const Vector3& shift)
  {
    Mesh moved = mesh;
    for (Vector3& p : moved.points)
    {
      p = scale * p + shift;
    }
    FeatureCurve curve = featureCurve({ { 1, 0, 0.1 }, { 0.8, 0.6, 0.1 }, { 0.6, 0.6, 0.5 } });
    for (Vector3& p : curve.points)
    {
      p = scale * p + shift;
    }
    curve.measure();
    RefineOptions options;
    options.radius = 0.1 * scale;
    const Forest forest = refined(baseOf(moved), { curve }, options);
    std::vector<std::pair<int, std::uint64_t>> leaves;
    for (const Forest::Face& face : forest.faces)
    {
      leaves.emplace_back(face.root, face.path);
    }
    return leaves;
  };
  const auto home = faces(1.0, Vector3::Zero());
  EXPECT_GT(home.size(), 1000u);
  EXPECT_EQ(faces(std::ldexp(1.0, -40), Vector3::Zero()), home);
  EXPECT_EQ(faces(std::ldexp(1.0, 60), Vector3::Zero()), home);
}

TEST(Refine, ThreadsChangeNothing)
{
  const FeatureCurves curves{ featureCurve({ { 1, 0, 0.1 }, { 0.8, 0.6, 0.1 }, { 0.6, 0.6, 0.5 } }),
    featureCurve({ { 0, 1, 0 }, { 0.3, 0.9, 0.3 }, { 0, 0.9, -0.4 } }, true) };
  RefineOptions options;
  options.radius = 0.1;
  for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
  {
    options.distance = kind;
    const Forest base = baseOf(icosphere(3));
    const Forest one = refined(base, curves, options), two = refined(base, curves, options, twoThreads());
    EXPECT_GT(one.faceCount(), 2 * base.faceCount());
    EXPECT_TRUE(sameForest(one, two));
    // Continued from arrays it is the same too.
    EXPECT_TRUE(sameForest(refined(rebuild(emit(one), Context()), curves, options), one));
  }
}

TEST(Refine, WhatCannotBeIsRefused)
{
  const Forest base = quadForest(4, 4);
  const auto failure = [&](const FeatureCurves& curves, const std::function<void(RefineOptions&)>& change)
  {
    RefineOptions options;
    options.radius = 0.1;
    change(options);
    try
    {
      refined(base, curves, options);
    }
    catch (const Error& e)
    {
      return std::make_pair(e.failure(), std::string(e.what()));
    }
    return std::make_pair(Failure::Unexpected, std::string());
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (double r : { 0.0, -1.0, nan, inf })
  {
    EXPECT_EQ(failure(lineAcross(), [&](RefineOptions& o) { o.radius = r; }).first, Failure::BadStroke) << r;
  }
  EXPECT_EQ(failure(lineAcross(), [&](RefineOptions& o) { o.sharpness = nan; }).first, Failure::BadStroke);
  EXPECT_EQ(
    failure(lineAcross(), [&](RefineOptions& o) { o.maximumGeneration = 63; }).first, Failure::BadStroke);
  FeatureCurves broken = lineAcross();
  broken[0].points[1].x() = nan;
  EXPECT_EQ(failure(broken, [](RefineOptions&) {}).first, Failure::BadStroke);
  // The limit of faces speaks before memory goes.
  const auto many = failure(lineAcross(),
    [](RefineOptions& o)
    {
      o.targetEdgeLength = 1e-12;
      o.maximumGeneration = 62;
      o.maximumFaces = 5000;
    });
  EXPECT_EQ(many.first, Failure::BadRegion);
  EXPECT_NE(many.second.find("MaximumFaces"), std::string::npos);
  // With what is allowed by default it is foreseen, or this would take gigabytes.
  const auto foreseen = failure(lineAcross(),
    [](RefineOptions& o) { o.targetEdgeLength = 1e-12, o.radius = 10.0, o.maximumGeneration = 20; });
  EXPECT_EQ(foreseen.first, Failure::BadRegion);
  EXPECT_NE(foreseen.second.find("(4000000) new triangles, about"), std::string::npos) << foreseen.second;
  // A radius of nothing, and one of everything.
  RefineOptions options;
  options.radius = 1e-300;
  EXPECT_EQ(refined(base, lineAcross(), options).broken(), "");
  options.radius = 20.0;
  options.maximumGeneration = 2;
  EXPECT_EQ(refined(base, lineAcross(), options).faceCount(), 32);
  // No curve refines nothing.
  options.radius = 0.1;
  EXPECT_TRUE(sameForest(refined(base, {}, options), base));
}

TEST(Refine, CurvesThatTheMeshWasNotSnappedToAreRefused)
{
  Forest forest = quadForest(8, 8);
  const FeatureCurves curves = lineAcross();
  forest.vertices[30].position = curves[0].position(0.4);
  forest.vertices[30].curveParam = 0.4;
  forest.vertices[30].curveId = 0;
  forest.vertices[30].moved = Forest::Placed;
  EXPECT_NO_THROW(checkSnapped(forest, curves));
  forest.vertices[30].curveParam = 0.8;
  EXPECT_THROW(checkSnapped(forest, curves), Error);
  forest.vertices[30].curveParam = 0.4;
  forest.vertices[30].curveId = 1;
  EXPECT_THROW(checkSnapped(forest, curves), Error);
}

TEST(Refine, ScribblesRingsAndWhatLeavesTheMeshEnd)
{
  std::mt19937 random(61);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  FeatureCurve scribble, ring, over;
  for (int i = 0; i < 20000; ++i)
  {
    const double t = 0.05 * i;
    scribble.points.emplace_back(0.5 + 0.3 * std::sin(t) * std::cos(0.0137 * t),
      0.5 + 0.3 * std::sin(1.1 * t + 0.001 * i),
      1e-4 * unit(random));
  }
  scribble.measure();
  for (int i = 0; i < 50; ++i)
  {
    ring.points.emplace_back(
      0.5 + 0.2 * std::cos(2 * pi * i / 50), 0.5 + 0.2 * std::sin(2 * pi * i / 50), 0.0);
  }
  ring.closed = true;
  ring.measure();
  over =
    featureCurve({ { 0.5, 0.5, 0 }, { 0.5, 0.5, 0 }, { 0.9, 0.9, 0 }, { 1.5, 0.9, 0 }, { 1.5, 1.5, 9 } });
  for (const FeatureCurves& curves :
    { FeatureCurves{ scribble }, FeatureCurves{ ring }, FeatureCurves{ over } })
  {
    for (CurveDistance kind : { CurveDistance::Straight, CurveDistance::Geodesic })
    {
      RefineOptions options;
      options.radius = 0.03;
      options.distance = kind;
      const Forest forest = refined(quadForest(16, 16), curves, options);
      EXPECT_EQ(forest.broken(), "");
      EXPECT_GT(forest.faceCount(), 2000);
      EXPECT_TRUE(sameForest(refined(forest, curves, options), forest));
    }
  }
}

TEST(Refine, ItCanBeCancelled)
{
  Context context;
  int left = 30;
  context.cancelled = [&] { return left-- <= 0; };
  RefineOptions options;
  options.radius = 0.05;
  EXPECT_THROW(refined(quadForest(64, 64), lineAcross(), options, context), Error);
}
