#include "Stellar/snap.h"

#include "Harness/face_quality.h"
#include "Harness/feature_shapes.h"
#include "Stellar/smooth.h"

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
    sum.finest = std::min(sum.finest, faceQuality(forest).smallestAngle);
    const SnapReport report = snap(forest, curves, options, {}, Context());
    EXPECT_EQ(forest.broken(), "");
    sum.report.crossings += report.crossings;
    sum.report.residual += report.residual;
    sum.report.refused += report.refused;
    sum.report.facesAdded += report.facesAdded;
    sum.faces += forest.faceCount();
    sum.gaps += gapsOf(forest);
    const FaceQuality quality = faceQuality(forest);
    sum.smallest = std::min(sum.smallest, quality.smallestAngle);
    sum.degenerate += quality.degenerate;
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      sum.flipped += forest.isFace(f) && forest.facetNormal(f).z() < 0.0 ? 1 : 0;
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
      for (const Forest* ends : { &before, &static_cast<const Forest&>(forest) })
        forest.link(v,
          [&](int w)
          {
            const Vector3 edge = ends->vertices[w].position - at;
            nearest = std::min(nearest, edge.cross(move).norm() / edge.norm());
            EXPECT_LT(move.norm(), 0.1);
          });
      offEdge = std::max(offEdge, nearest);
    }
    forest = before;
    const SnapReport report = snap(forest, curves, {}, {}, Context());
    crossed += report.residual;
    followed -= report.snapped;
    refineNear(forest, curves, 0.06, 0.0075);
    EXPECT_EQ(forest.broken(), "");
    for (const Forest::Vertex& v : forest.vertices)
      if (v.curveId >= 0)
      {
        ++followed;
        EXPECT_TRUE(v.moved & Forest::Placed);
        offCurve = std::max(offCurve, (curve.position(v.curveParam) - v.position).norm());
      }
    gaps += gapsOf(forest);
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      flipped += forest.isFace(f) && forest.facetNormal(f).z() <= 0.0 ? 1 : 0;
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
    coarse += faceQuality(forest).degenerate;
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

namespace
{

// An eight, a closed ring, a line along an edge and one along diagonals.
FeatureCurves manyCurves()
{
  std::vector<Vector3> eight, ring;
  for (int i = 0; i < 200; ++i)
  {
    const double a = 2.0 * pi * i / 200.0;
    eight.emplace_back(0.45 + 0.3 * std::sin(a), 0.52 + 0.2 * std::sin(2.0 * a), 0.0);
    ring.emplace_back(0.6 + 0.27 * std::cos(a), 0.45 + 0.27 * std::sin(a), 0.0);
  }
  return { featureCurve(eight, true),
    featureCurve(ring, true),
    featureCurve({ { 0.1, 0.25, 0 }, { 0.9, 0.25, 0 } }),
    featureCurve({ { 0.1, 0.1, 0 }, { 0.9, 0.9, 0 } }) };
}

Forest refinedSquare(const FeatureCurves& curves, double jitter = 1.0 / 6.0)
{
  Forest forest = squareForest(16, jitter);
  refineNear(forest, curves, 0.06, 0.015);
  return forest;
}

} // namespace

TEST(Snap, TwoThreadsAndASecondTimeAreTheSame)
{
  const FeatureCurves curves = manyCurves();
  Forest one = refinedSquare(curves), two = one;
  const SnapReport first = snap(one, curves, {}, {}, Context());
  snap(two, curves, {}, {}, twoThreads());
  EXPECT_TRUE(sameForest(one, two));
  EXPECT_GT(first.snapped, 500);
  EXPECT_LE(first.residual, 0.01 * first.crossings);

  const FeatureCurves single{ curves[1] };
  Forest once = refinedSquare(single);
  EXPECT_EQ(snap(once, single, {}, {}, Context()).residual, 0);
  Forest twice = once;
  const SnapReport second = snap(twice, single, {}, {}, Context());
  EXPECT_EQ(second.crossings + second.snapped + second.residual + second.facesAdded, 0);
  EXPECT_TRUE(sameForest(once, twice));
}

// 30 pairs of lines, most of which cross: an edge along one of them is crossed by the other far from its ends
// unless a vertex goes along the one to where they meet.
TEST(D9_1, CurvesThatMeetLeaveNoCrossing)
{
  const std::vector<FeatureCurve> lines = planarCurves(false);
  int crossings = 0, without = 0, left = 0, added = 0, faces = 0, flipped = 0, meetings = 0, met = 0;
  double smallest = 60.0;
  for (int i = 0; i < 30; ++i)
  {
    const FeatureCurves curves{ lines[i], lines[i + 30] };
    const Forest start = refinedSquare(curves);
    SnapOptions none;
    none.maximumResidualRounds = 0;
    Forest plain = start, forest = start;
    without += snap(plain, curves, none, {}, Context()).residual;
    const SnapReport report = snap(forest, curves, {}, {}, Context());
    EXPECT_EQ(forest.broken(), "");
    crossings += report.crossings;
    left += report.residual;
    added += report.facesAdded;
    faces += forest.faceCount();
    smallest = std::min(smallest, faceQuality(forest).smallestAngle);
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      flipped += forest.isFace(f) && forest.facetNormal(f).z() <= 0.0 ? 1 : 0;
    }
    // Where the lines meet, by Cramer's rule.
    const Vector3 p = curves[0].points[0], x = curves[0].points[1] - p, q = curves[1].points[0],
                  y = curves[1].points[1] - q;
    const double whole = x.cross(y).z(), s = (q - p).cross(y).z() / whole, u = (q - p).cross(x).z() / whole;
    const bool meet = s > 0.05 && s < 0.95 && u > 0.05 && u < 0.95;
    double nearest = std::numeric_limits<double>::infinity();
    for (const Forest::Vertex& at : forest.vertices)
    {
      if (at.curveId >= 0)
      {
        EXPECT_LE((curves[at.curveId].position(at.curveParam) - at.position).norm(), 1e-12);
        nearest = std::min(nearest, (at.position - p - s * x).norm());
      }
    }
    meetings += meet ? 1 : 0;
    met += meet && nearest < 0.005 ? 1 : 0; // a third of an edge
  }
  std::ostringstream text;
  text << "30 pairs of lines, " << meetings << " that meet: " << crossings << " crossings, residual "
       << without << " -> " << left << ", " << added << " of " << faces << " faces added, smallest angle "
       << smallest;
  fact("D9_1", text.str());
  EXPECT_GT(meetings, 10);
  EXPECT_EQ(met, meetings);
  EXPECT_GT(without, 20);
  EXPECT_LE(left, 0.001 * crossings);
  EXPECT_LT(added, 0.005 * faces);
  EXPECT_EQ(flipped, 0);
  EXPECT_GT(smallest, 4.0);
}

TEST(Snap, ScaleAndPlaceDoNotMatter)
{
  const FeatureCurves curves = manyCurves();
  const Forest start = refinedSquare(curves);
  Forest home = start;
  const SnapReport report = snap(home, curves, {}, {}, Context());
  for (const double scale : { std::ldexp(1.0, -60), std::ldexp(1.0, 60) })
  {
    Forest forest = start;
    for (Forest::Vertex& v : forest.vertices)
    {
      v.position *= scale;
    }
    FeatureCurves scaled = curves;
    for (FeatureCurve& curve : scaled)
    {
      for (Vector3& p : curve.points)
      {
        p *= scale;
      }
      curve.measure();
    }
    EXPECT_EQ(snap(forest, scaled, {}, {}, Context()).snapped, report.snapped);
    ASSERT_EQ(forest.faces.size(), home.faces.size());
    for (std::size_t v = 0; v < home.vertices.size(); ++v)
    {
      EXPECT_EQ(forest.vertices[v].position, Vector3(scale * home.vertices[v].position));
      EXPECT_EQ(forest.vertices[v].curveId, home.vertices[v].curveId);
    }
  }
  // A million units away six digits are gone, and nothing else.
  Forest far = start;
  const Vector3 away(1e6, -1e6, 1e6);
  for (Forest::Vertex& v : far.vertices)
  {
    v.position += away;
  }
  FeatureCurves moved = curves;
  for (FeatureCurve& curve : moved)
  {
    for (Vector3& p : curve.points)
    {
      p += away;
    }
    curve.measure();
  }
  const SnapReport there = snap(far, moved, {}, {}, Context());
  EXPECT_LE(there.residual, 0.01 * there.crossings);
  EXPECT_NEAR(there.snapped, report.snapped, 0.02 * report.snapped);
  EXPECT_GT(faceQuality(far).smallestAngle, 4.0);
}

TEST(Snap, ARoundThatDoesNotHelpLeavesNoTrace)
{
  int takenBack = 0;
  for (const double angle : { 15.0, 35.0 })
    for (const FeatureCurve& curve : planarCurves(true))
    {
      const FeatureCurves curves{ curve };
      const Forest start = refinedSquare(curves);
      SnapOptions options;
      options.minimumAngle = angle;
      options.maximumResidualRounds = 0;
      Forest last = start;
      SnapReport before = snap(last, curves, options, {}, Context());
      for (int rounds = 1; rounds < 4 && before.residual > 0; ++rounds)
      {
        options.maximumResidualRounds = rounds;
        Forest next = start;
        const SnapReport after = snap(next, curves, options, {}, Context());
        EXPECT_LE(after.residual, before.residual);
        if (after.residual == before.residual)
        {
          ++takenBack;
          EXPECT_EQ(after.facesAdded, before.facesAdded);
          EXPECT_TRUE(sameBytes(canonicalLeaves(next), canonicalLeaves(last)));
          break;
        }
        last = next;
        before = after;
      }
    }
  EXPECT_GT(takenBack, 5);
}

TEST(Snap, BordersAndCornersStay)
{
  const FeatureCurves curves{ featureCurve({ { -0.1, 0.313, 0 }, { 1.1, 0.42, 0 } }),
    featureCurve({ { 0.004, -0.1, 0 }, { 0.003, 1.1, 0 } }),
    featureCurve({ { -0.005, 0.01, 0 }, { 0.01, -0.004, 0 } }) };
  Forest forest = refinedSquare(curves);
  const Forest before = forest;
  const SnapReport report = snap(forest, curves, {}, {}, Context());
  int alongBorder = 0;
  for (std::size_t v = 0; v < before.vertices.size(); ++v)
  {
    const Vector3 &p = before.vertices[v].position, &q = forest.vertices[v].position;
    for (int axis = 0; axis < 2; ++axis)
    {
      if (p[axis] == 0.0 || p[axis] == 1.0)
      {
        EXPECT_EQ(p[axis], q[axis]);
        alongBorder += p == q ? 0 : 1;
      }
    }
    if (v == 0)
    {
      EXPECT_EQ(p, q);
    }
  }
  EXPECT_GE(alongBorder, 2);
  EXPECT_LE(report.residual, 0.02 * report.crossings);
  EXPECT_GT(faceQuality(forest).smallestAngle, 4.0);
}

// Of two parts of a square that meet at x = 1/2, what is on the seam slides along it and does not leave it.
TEST(Snap, SeamsKeepTheirLine)
{
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.313, 0 }, { 0.9, 0.42, 0 } }),
    featureCurve({ { 0.45, 0.1, 0 }, { 0.55, 0.9, 0 } }) };
  const Forest start = refinedSquare(curves, 0.0);
  std::vector<int> parts(start.rootCount, 0);
  for (const Forest::Face& face : start.faces)
  {
    double middle = 0.0;
    for (const int v : face.v)
    {
      middle += start.vertices[v].position.x() / 3.0;
    }
    parts[face.root] = middle > 0.5;
  }
  for (const bool seams : { true, false })
  {
    SnapOptions options;
    options.parts = seams ? parts : std::vector<int>();
    SmoothOptions even;
    even.parts = options.parts;
    Forest forest = start;
    const SnapReport report = snap(forest, curves, options, {}, Context());
    smooth(forest, even, {}, Context());
    EXPECT_EQ(forest.broken(), "");
    EXPECT_LE(report.residual, 0.01 * report.crossings);
    EXPECT_GT(faceQuality(forest).smallestAngle, 4.0);
    int left = 0, along = 0;
    for (int v = 0; v < static_cast<int>(forest.vertices.size()); ++v)
    {
      const bool on = forest.onSeam(v, parts);
      left += on && forest.vertices[v].position.x() != 0.5 ? 1 : 0;
      along += on && v < static_cast<int>(start.vertices.size()) && forest.vertices[v].position.x() == 0.5 &&
                   forest.vertices[v].position != start.vertices[v].position
                 ? 1
                 : 0;
    }
    EXPECT_EQ(left > 0, !seams) << left;
    EXPECT_TRUE(along > 0 || !seams);
  }
  SnapOptions wrong;
  wrong.parts = { 0, 1 };
  Forest forest = start;
  EXPECT_THROW(snap(forest, curves, wrong, {}, Context()), Error);
  SmoothOptions other;
  other.parts = { 0, 1 };
  EXPECT_THROW(smooth(forest, other, {}, Context()), Error);
}

TEST(Snap, TheOtherSideOfAThinPlateIsLeftAlone)
{
  // Two sheets, back to back, nearer to each other than half an edge.
  Mesh plate = quadPairs(8, 8);
  const int points = plate.vertexCount(), triangles = plate.triangleCount();
  for (int i = 0; i < points; ++i)
  {
    const Vector3 p = plate.points[i];
    plate.points.emplace_back(p - Vector3(0, 0, 0.01));
  }
  for (int i = 0; i < triangles; ++i)
  {
    const Triangle t = plate.triangles[i];
    plate.triangles.push_back({ t[0] + points, t[2] + points, t[1] + points });
  }
  FeatureCurves curves{ featureCurve({ { 0.1, 0.33, 0 }, { 0.9, 0.41, 0 } }) };
  curves[0].normals = { Vector3::UnitZ(), Vector3::UnitZ() };
  Forest forest = forestOfPairs(plate);
  snap(forest, curves, {}, {}, Context());
  int above = 0, below = 0;
  for (const Forest::Vertex& v : forest.vertices)
  {
    (v.position.z() < -0.005 ? below : above) += v.curveId >= 0 ? 1 : 0;
  }
  EXPECT_GT(above, 5);
  EXPECT_EQ(below, 0);
}

TEST(Snap, BadHandsAreBorne)
{
  // A scribble of a hundred thousand samples, repeated points among them.
  std::mt19937 random(3);
  std::vector<Vector3> scribble{ { 0.5, 0.5, 0.0 } };
  while (scribble.size() < 100000)
  {
    const double x = static_cast<double>(random()) / 4294967296.0 - 0.5,
                 y = static_cast<double>(random()) / 4294967296.0 - 0.5;
    const Vector3 next = scribble.back() + 0.005 * Vector3(x, y, 0.0);
    scribble.push_back(
      random() % 10 == 0 || next.x() < 0.1 || next.x() > 0.9 || next.y() < 0.1 || next.y() > 0.9
        ? scribble.back()
        : next);
  }
  // Ends in one point; is longer than the mesh; stands on it; lies beside it.
  const std::vector<FeatureCurves> hands{ { featureCurve(scribble) },
    { featureCurve({ { 0.3, 0.3, 0 }, { 0.3, 0.3, 0 }, { 0.3, 0.300001, 0 } }) },
    { featureCurve({ { -1e9, 0.31, 0 }, { 1e9, 0.32, 0 } }) },
    { featureCurve({ { 0.4, 0.4, -5 }, { 0.4, 0.4, 5 } }) },
    { featureCurve({ { 3, 3, 0 }, { 4, 3, 0 } }) },
    {} };
  for (std::size_t i = 0; i < hands.size(); ++i)
  {
    SCOPED_TRACE(i);
    Forest forest = squareForest(32, 1.0 / 6.0);
    snap(forest, hands[i], {}, {}, Context());
    EXPECT_EQ(forest.broken(), "");
    EXPECT_GT(faceQuality(forest).smallestAngle, 4.0);
    for (int f = 0; f < static_cast<int>(forest.faces.size()); ++f)
    {
      EXPECT_TRUE(!forest.isFace(f) || forest.facetNormal(f).z() > 0.0);
    }
  }
  Forest empty;
  EXPECT_EQ(snap(empty, hands[0], {}, {}, Context()).crossings, 0);

  Forest forest = squareForest(2);
  EXPECT_THROW(
    snap(forest, { featureCurve({ { 0, 0, 0 }, { std::nan(""), 0, 0 } }) }, {}, {}, Context()), Error);
  SnapOptions options;
  options.minimumAngle = std::nan("");
  EXPECT_THROW(snap(forest, {}, options, {}, Context()), Error);
  options.minimumAngle = 5.0;
  options.maximumResidualRounds = -1;
  EXPECT_THROW(snap(forest, {}, options, {}, Context()), Error);
}

TEST(Snap, TrianglesWithoutAreaDoNoHarm)
{
  // Collapsed and collinear ones in the way of the curve.
  Forest forest = squareForest(8);
  forest.vertices[40].position = forest.vertices[41].position;
  forest.vertices[31].position = forest.vertices[30].position;
  const FeatureCurves curves{ featureCurve({ { 0.1, 0.4, 0 }, { 0.9, 0.6, 0 } }) };
  snap(forest, curves, {}, {}, Context());
  EXPECT_EQ(forest.broken(), "");
  for (const Forest::Vertex& v : forest.vertices)
  {
    EXPECT_TRUE(v.position.allFinite());
  }
}

TEST(Snap, CanBeCancelled)
{
  const FeatureCurves curves = manyCurves();
  Forest forest = refinedSquare(curves);
  Context context;
  int looks = 0;
  context.cancelled = [&looks] { return ++looks > 2; };
  try
  {
    snap(forest, curves, {}, {}, context);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::Cancelled);
  }
}
