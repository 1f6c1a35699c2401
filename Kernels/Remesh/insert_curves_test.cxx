// Facts of editors.md, section 13, curves: inserting, embedding, cleaning, closing.
#include "Harness/mesh_curves.h"
#include "Remesh/curve_walk.h"

#include <gtest/gtest.h>

#include <random>
#include <sstream>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const InsertRules literal{ false, false, true, false };

std::string textOf(double x)
{
  std::ostringstream stream;
  stream.precision(4);
  stream << x;
  return stream.str();
}

// A hand's line: a wave with noise of a pixel.
Polyline shakyLine(const Vector2& a, const Vector2& b, unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> shake(-1.0, 1.0);
  const int count = static_cast<int>((b - a).norm() / 3.0);
  const Vector2 across = Vector2(a[1] - b[1], b[0] - a[0]).normalized();
  Polyline samples;
  for (int i = 0; i <= count; ++i)
  {
    const double t = static_cast<double>(i) / count;
    const double x = shake(random);
    samples.emplace_back(
      a + t * (b - a) + 25.0 * std::sin(2.0 * pi * t) * across + Vector2(x, shake(random)));
  }
  return samples;
}

InsertedCurves insertOne(const Mesh& mesh, const DrawnCurve& drawn, const InsertRules& rules = {})
{
  return insertCurves(mesh, { drawn.curve }, {}, rules);
}

double originError(const Mesh& input, const InsertedCurves& result)
{
  double worst = 0.0;
  for (int v = 0; v < result.mesh.vertexCount(); ++v)
  {
    Vector3 place = Vector3::Zero();
    double sum = 0.0;
    const int source = result.pointSources[v];
    for (const auto& part : source < 0 ? result.origins[v] : Mix{ { source, 1.0 } })
    {
      place += part.second * input.points[part.first];
      sum += part.second;
    }
    worst = std::max({ worst, (place - result.mesh.points[v]).norm(), std::abs(sum - 1.0) });
  }
  return worst;
}

bool refuses(const std::function<void()>& run, const std::string& words)
{
  try
  {
    run();
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    return error.failure() == Failure::BadStroke;
  }
  return false;
}

} // namespace

TEST(B2_4, CurvesAreChainsOfEdgesAndTrianglesStayWide)
{
  const Mesh sphere = icosphere(5);
  double literalAngle = 0.0, area = 0.0, change = 0.0, distance = 0.0;
  int added = 0;
  std::vector<double> angles; // of all curves
  for (int turn = 0; turn < 6; ++turn)
  {
    const View view = turn % 2 ? perspectiveView({ 3.0 - turn, 1.5, 2.5 }, { 0, 1, 0 }, 35.0)
                               : orthographicView({ 1.0 * turn, -2, 3 }, { 0, 1, 0 }, 240.0);
    const bool closed = turn >= 3;
    const Polyline stroke =
      closed ? circleOf({ 380, 310 }, 110) : shakyLine({ 280, 220 }, { 520, 380 }, 7u + turn);

    CurveRules published;
    published.spacing = 4.0;
    const DrawnCurve plain = drawnCurve(sphere, view, stroke, closed, published);
    ASSERT_EQ(plain.runs.size(), 1u);
    const InsertedCurves raw = insertOne(sphere, plain, literal);
    for (const SurfaceSample& sample : plain.runs[0].samples)
    {
      double nearest = 1.0;
      for (const int v : raw.curves[0].vertices)
      {
        nearest = std::min(nearest, (raw.mesh.points[v] - sample.position).norm());
      }
      distance = std::max(distance, nearest / boundingDiagonal(sphere));
    }
    area = std::max(area, std::abs(areaOf(raw.mesh) / areaOf(sphere) - 1.0));
    added = raw.mesh.vertexCount() - sphere.vertexCount();
    EXPECT_GT(added, 20);
    EXPECT_EQ(raw.mesh.triangleCount() - sphere.triangleCount(), 2 * added);
    EXPECT_EQ(eulerNumber(raw.mesh.triangles), 2);
    EXPECT_LT(originError(sphere, raw), 1e-12);
    const DrawnCurve again = drawnCurve(raw.mesh, view, stroke, closed, published);
    EXPECT_EQ(insertOne(raw.mesh, again, literal).mesh.vertexCount(), raw.mesh.vertexCount());
    const std::vector<double> rawAngles = anglesAlong(raw.mesh, raw.curves[0]);
    literalAngle = std::max(literalAngle, share(rawAngles, 0.05));

    const InsertedCurves result = insertOne(sphere, drawnCurve(sphere, view, stroke, closed));
    EXPECT_EQ(eulerNumber(result.mesh.triangles), 2);
    EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
    EXPECT_TRUE(soundCurve(result.curves[0]));
    EXPECT_EQ(result.curves[0].closed, closed);
    EXPECT_LT(originError(sphere, result), 1e-12);
    double near = 0.0; // the area of the triangles at the curve; only theirs can have changed
    for (const Triangle& t : trianglesAlong(result.mesh, result.curves[0]))
    {
      near += areaOf(result.mesh, t);
    }
    change = std::max(change, std::abs(areaOf(result.mesh) - areaOf(sphere)) / near);
    const std::vector<double> along = anglesAlong(result.mesh, result.curves[0]);
    angles.insert(angles.end(), along.begin(), along.end());
  }
  EXPECT_LT(distance, 1e-9);
  EXPECT_LT(area, 1e-10);
  EXPECT_LT(literalAngle, 3.0);
  std::sort(angles.begin(), angles.end());
  const double least = share(angles, 0.05);
  EXPECT_GE(least, 18.0);
  EXPECT_LT(change, 1e-3);
  fact("B2_4",
    "as published: points within " + textOf(distance) + " of the diagonal of a vertex, area within " +
      textOf(area) + ", two triangles for each vertex, none by a second run, p5 of the angles at most " +
      textOf(literalAngle) + " degrees; by default all segments are edges, p5 " + textOf(least) +
      ", the area at the curves within " + textOf(change));
}

TEST(B2_6, RingsHalfBesideTheModelCloseBehindIt)
{
  const Mesh sphere = icosphere(4);
  int discs = 0, refused = 0, joined = 0;
  double leastHidden = 1.0, mostHidden = 0.0;
  for (int camera = 0; camera < 12; ++camera)
  {
    const double angle = 2.0 * pi * camera / 12.0;
    const Vector3 from(std::cos(angle), 0.4 * std::sin(3.0 * angle), std::sin(angle));
    const View view = camera % 2 ? perspectiveView(5.0 * from, { 0, 1, 0 }, 30.0)
                                 : orthographicView(from, { 0, 1, 0 }, 220.0);
    // Its middle is on the outline.
    const double rim = view.perspective() ? 300.0 / std::tan(15.0 * pi / 180.0) / 5.0 : 220.0;
    const Vector2 middle = Vector2(400, 300) + rim * Vector2(std::cos(0.7 * camera), std::sin(0.7 * camera));
    const DrawnCurve drawn = drawnCurve(sphere, view, circleOf(middle, 0.35 * rim), true);
    ASSERT_EQ(drawn.runs.size(), 1u);
    InsertRules open;
    open.bridge = false;
    refused += refuses([&] { insertOne(sphere, drawn, open); }, "leaves the mesh");
    const Vector2 inwards = (Vector2(400, 300) - middle).normalized();
    // As published: closed over what is seen.
    open.join = true;
    const InsertedCurves seen = insertOne(sphere, drawn, open);
    EXPECT_EQ(seen.bridges, 0);
    EXPECT_EQ(looseSegments(seen.mesh, seen.curves[0]), 0);
    const std::vector<Triangle> half =
      sideOf(seen.mesh, seen.curves[0], seenAt(seen.mesh, view, middle + 0.2 * rim * inwards));
    joined += eulerNumber(half) == 1 && half.size() < seen.mesh.triangles.size() / 2;
    const InsertedCurves result = insertOne(sphere, drawn);
    EXPECT_EQ(result.bridges, 1);
    EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
    EXPECT_TRUE(soundCurve(result.curves[0]));
    const std::vector<Triangle> region =
      sideOf(result.mesh, result.curves[0], seenAt(result.mesh, view, middle + 0.2 * rim * inwards));
    double hidden = 0.0, whole = 0.0;
    for (const Triangle& t : region)
    {
      const Vector3 normal = (result.mesh.points[t[1]] - result.mesh.points[t[0]])
                               .cross(result.mesh.points[t[2]] - result.mesh.points[t[0]]);
      whole += areaOf(result.mesh, t);
      hidden += normal.dot(view.towardsViewer(result.mesh.points[t[0]])) < 0.0 ? areaOf(result.mesh, t) : 0.0;
    }
    discs += eulerNumber(region) == 1 && region.size() < result.mesh.triangles.size() / 2;
    leastHidden = std::min(leastHidden, hidden / whole);
    mostHidden = std::max(mostHidden, hidden / whole);
  }
  EXPECT_EQ(discs, 12);
  EXPECT_EQ(refused, 12);
  EXPECT_GE(joined, 8);
  EXPECT_GE(leastHidden, 0.15);
  EXPECT_LE(mostHidden, 0.35);

  // A ring with a small loop: the loop is gone.
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 220.0);
  Polyline ring = circleOf({ 400, 300 }, 100);
  Polyline loop; // clockwise, from where it leaves the ring
  for (int i = 0; i < 24; ++i)
  {
    const double angle = pi - 2.0 * pi * (i + 0.5) / 24;
    loop.emplace_back(518.0 + 16.0 * std::cos(angle), 300.0 + 16.0 * std::sin(angle));
  }
  ring.insert(ring.begin() + 1, loop.begin(), loop.end());
  const DrawnCurve looped = drawnCurve(sphere, view, ring, true);
  const InsertedCurves result = insertOne(sphere, looped);
  const std::vector<Triangle> region =
    sideOf(result.mesh, result.curves[0], seenAt(result.mesh, view, { 400, 300 }));
  EXPECT_EQ(eulerNumber(region), 1);
  for (const int v : result.curves[0].vertices)
  {
    EXPECT_LT((view.toDisplay(result.mesh.points[v]).head<2>() - Vector2(400, 300)).norm(), 110.0);
  }
  fact("B2_6",
    "rings of 0.35 of its radius half beside a sphere: " + std::to_string(discs) +
      " of 12 close to a disc, hidden share " + textOf(leastHidden) + " to " + textOf(mostHidden) +
      ", without bridges " + std::to_string(refused) + " are refused, or as published " +
      std::to_string(joined) + " joined over what is seen; a small loop is cut out");
}

// Rings round a sheet's corner and half beside its edge enclose what is on the sheet, up to its border.
TEST(InsertCurves, ARingThatLeavesASheetGoesAlongItsBorder)
{
  const Mesh sheet = gridSurface(
    40, 40, false, false, [](double u, double v) { return Vector3(4.0 * u - 2.0, 4.0 * v - 2.0, 0.0); });
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0);
  for (const auto& [middle, quarters] : { std::pair(Vector2(600, 500), 1), std::pair(Vector2(600, 290), 2) })
  {
    const DrawnCurve ring = drawnCurve(sheet, view, circleOf(middle, 90), true);
    const InsertedCurves result = insertOne(sheet, ring);
    EXPECT_EQ(result.bridges, 1);
    EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
    const std::vector<Triangle> region =
      sideOf(result.mesh, result.curves[0], seenAt(result.mesh, view, middle - Vector2(30, 30)));
    EXPECT_EQ(eulerNumber(region), 1);
    double area = 0.0;
    for (const Triangle& t : region)
    {
      area += areaOf(result.mesh, t);
    }
    EXPECT_NEAR(area, quarters * 0.25 * pi * 0.81, 0.02);
  }
}

TEST(InsertCurves, AStoredCurveKeepsItsEdges)
{
  const Mesh sphere = icosphere(4);
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 220.0);
  const InsertedCurves first = insertOne(sphere, drawnCurve(sphere, view, circleOf({ 400, 300 }, 120), true));
  // A line across it: what splits its edges joins it.
  const InsertedCurves second = insertCurves(first.mesh,
    { drawnCurve(first.mesh, view, shakyLine({ 250, 290 }, { 550, 310 }, 3), false).curve },
    first.curves,
    {});
  ASSERT_EQ(second.stored.size(), 1u);
  EXPECT_EQ(looseSegments(second.mesh, second.stored[0]), 0);
  EXPECT_EQ(looseSegments(second.mesh, second.curves[0]), 0);
  EXPECT_TRUE(soundCurve(second.stored[0]));
  int shared = 0;
  for (const int v : second.stored[0].vertices)
  {
    const std::vector<int>& line = second.curves[0].vertices;
    shared += std::find(line.begin(), line.end(), v) != line.end();
  }
  EXPECT_EQ(shared, 2);
  const std::vector<Triangle> region =
    sideOf(second.mesh, second.stored[0], seenAt(second.mesh, view, { 400, 330 }));
  EXPECT_EQ(eulerNumber(region), 1);
  EXPECT_LT(region.size(), second.mesh.triangles.size() / 3);

  // Together they are what they are one after the other, but for the cleaning in between.
  const std::vector<NewCurve> both{ drawnCurve(sphere, view, circleOf({ 400, 300 }, 120), true).curve,
    drawnCurve(sphere, view, shakyLine({ 250, 290 }, { 550, 310 }, 3), false).curve };
  const InsertedCurves together = insertCurves(sphere, both, {}, {});
  for (const MeshCurve& curve : together.curves)
  {
    EXPECT_EQ(looseSegments(together.mesh, curve), 0);
    EXPECT_TRUE(soundCurve(curve));
  }
  const InsertedCurves repeated = insertCurves(sphere, both, {}, {});
  EXPECT_EQ(together.mesh.points, repeated.mesh.points);
  EXPECT_EQ(together.mesh.triangles, repeated.mesh.triangles);
}

TEST(InsertCurves, CoarseTrianglesBordersAndBadHands)
{
  // Two triangles, and a coarse cube-like grid with a border: lines that end beside it.
  const Mesh square =
    gridSurface(1, 1, false, false, [](double u, double v) { return Vector3(2 * u - 1, 2 * v - 1, 0); });
  const View above = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 200.0);
  const InsertedCurves across =
    insertOne(square, drawnCurve(square, above, shakyLine({ 150, 280 }, { 650, 330 }, 1), false));
  EXPECT_EQ(looseSegments(across.mesh, across.curves[0]), 0);
  EXPECT_EQ(eulerNumber(across.mesh.triangles), 1);
  EXPECT_NEAR(areaOf(across.mesh), 4.0, 1e-9);
  for (const int end : { across.curves[0].vertices.front(), across.curves[0].vertices.back() })
  {
    EXPECT_NEAR(std::abs(across.mesh.points[end][0]), 1.0, 1e-3);
  }
  // A line that goes back over itself, and a figure eight: no vertex twice.
  Polyline back = shakyLine({ 250, 300 }, { 550, 300 }, 4);
  const Polyline there = shakyLine({ 550, 301 }, { 400, 299 }, 5);
  back.insert(back.end(), there.begin(), there.end());
  const Mesh sphere = icosphere(4);
  EXPECT_TRUE(refuses(
    [&] {
      insertOne(sphere, drawnCurve(sphere, above, circleOf({ 400, 300 }, 3.0, 20), false));
    },
    "less than a segment"));
  for (const Polyline& stroke : { back, circleOf({ 400, 300 }, 30.0, 60) })
  {
    const InsertedCurves result = insertOne(sphere, drawnCurve(sphere, above, stroke, false));
    EXPECT_TRUE(soundCurve(result.curves[0]));
    EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
    EXPECT_EQ(eulerNumber(result.mesh.triangles), 2);
  }
  Polyline eight;
  for (int i = 0; i < 100; ++i)
  {
    const double t = 2.0 * pi * i / 100;
    eight.emplace_back(400 + (t < pi ? 150 : 100) * std::sin(t), 300 + 80 * std::sin(2.0 * t));
  }
  const InsertedCurves lobe = insertOne(sphere, drawnCurve(sphere, above, eight, true));
  EXPECT_TRUE(soundCurve(lobe.curves[0]));
  const std::vector<Triangle> region =
    sideOf(lobe.mesh, lobe.curves[0], seenAt(lobe.mesh, above, { 470, 300 }));
  EXPECT_EQ(eulerNumber(region), 1);
  EXPECT_LT(region.size(), sphere.triangles.size() / 4);
}

TEST(InsertCurves, ALoopThatIsCutOutLeavesNoTriangleSplit)
{
  const Mesh sphere = icosphere(5);
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 220.0);
  DrawnCurve line = drawnCurve(sphere, view, shakyLine({ 300, 340 }, { 500, 340 }, 1), false);
  const DrawnCurve loop = drawnCurve(sphere, view, circleOf({ 400, 230 }, 40.0), true);
  CurveRun& run = line.curve.runs[0];
  const std::size_t middle = run.places.size() / 2;
  run.places[middle].weights = { 1.0, 0.0, 0.0 }; // a vertex, which it comes back to
  std::vector<SurfacePoint> astray = loop.curve.runs[0].places;
  astray.push_back(run.places[middle]);
  run.places.insert(
    run.places.begin() + static_cast<std::ptrdiff_t>(middle) + 1, astray.begin(), astray.end());
  run.parameters.clear();
  for (std::size_t i = 0; i < run.places.size(); ++i)
  {
    run.parameters.push_back(static_cast<double>(i) / static_cast<double>(run.places.size() - 1));
  }
  for (const InsertRules& rules : { InsertRules(), InsertRules{ true, true, true, false } })
  {
    const InsertedCurves result = insertOne(sphere, line, rules);
    EXPECT_EQ(eulerNumber(result.mesh.triangles), 2);
    EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
    EXPECT_LT(originError(sphere, result), 1e-12);
    std::set<Triangle> left;
    for (const Triangle& t : result.mesh.triangles)
    {
      const auto source = [&](int v) { return result.pointSources[v]; };
      left.insert({ source(t[0]), source(t[1]), source(t[2]) });
    }
    int lost = 0, looked = 0;
    for (const Triangle& t : sphere.triangles)
    {
      const Vector2 at = view.toDisplay(sphere.points[t[0]]).head<2>();
      if (sphere.points[t[0]][2] > 0.0 && at[1] < 280.0) // the line is above 305
      {
        ++looked;
        lost += left.count(t) == 0;
      }
    }
    EXPECT_GT(looked, 1000);
    EXPECT_EQ(lost, 0);
  }
}

TEST(InsertCurves, ARingRoundATipClosesBehindIt)
{
  // A finger: a ring in the picture round its tip holds all of the tip.
  const Mesh finger = gridSurface(24,
    40,
    true,
    false,
    [](double u, double v)
    {
      const double a = 2 * pi * u, bend = std::max(0.0, v - 0.8) / 0.2;
      const double r = 0.25 * std::sqrt(std::max(1e-4, 1.0 - bend * bend));
      return Vector3(r * std::cos(a), 2.0 * v, r * std::sin(a));
    });
  const View view = perspectiveView({ 0.6, 0.4, 8 }, { 0, 1, 0 }, 40.0);
  const Vector2 tip = view.toDisplay({ 0, 1.9, 0 }).head<2>();
  const DrawnCurve drawn = drawnCurve(finger, view, circleOf(tip, 45.0), true);
  ASSERT_GE(drawn.runs.size(), 1u);
  const InsertedCurves result = insertOne(finger, drawn);
  EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
  EXPECT_TRUE(soundCurve(result.curves[0]));
  const std::vector<Triangle> cap = sideOf(result.mesh, result.curves[0], seenAt(result.mesh, view, tip));
  double lowest = 2.0;
  for (const Triangle& t : cap)
  {
    lowest = std::min(lowest, result.mesh.points[t[0]][1]);
  }
  EXPECT_GT(lowest, 1.0); // not down the finger
  EXPECT_LT(lowest, 1.9);
}

TEST(InsertCurves, CreasesKeepTheirShape)
{
  // A roof: its ridge is an edge over 25 degrees and stays, wherever a curve crosses it.
  const Mesh roof = gridSurface(10,
    10,
    false,
    false,
    [](double u, double v) { return Vector3(2 * u - 1, 2 * v - 1, -std::abs(2 * u - 1)); });
  const View above = orthographicView({ 0.1, 0.2, 1 }, { 0, 1, 0 }, 200.0);
  const InsertedCurves result =
    insertOne(roof, drawnCurve(roof, above, shakyLine({ 280, 200 }, { 520, 420 }, 9), false));
  EXPECT_EQ(looseSegments(result.mesh, result.curves[0]), 0);
  EXPECT_NEAR(areaOf(result.mesh), areaOf(roof), 1e-9);
  for (const Vector3& p : result.mesh.points)
  {
    EXPECT_NEAR(p[2], -std::abs(p[0]), 1e-12);
  }
}

// A way that crossed a triangle twice would be cut by itself where it is made edges.
TEST(Walk, EachTwoPlacesOfAWayAreJoinedByAnEdge)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  int found = 0;
  for (int round = 0; round < 40; ++round)
  {
    Mesh mesh = round % 2 ? icosphere(3) : torus(1.0, 0.4, 24, 12);
    for (Vector3& p : mesh.points)
    {
      const double x = any(random), y = any(random), z = any(random);
      p += 0.02 * (round % 5) * Vector3(x, y, z);
    }
    const CurveMesh whole(mesh);
    const unsigned count = static_cast<unsigned>(mesh.points.size());
    for (int i = 0; i < 60; ++i)
    {
      const int from = static_cast<int>(random() % count), to = static_cast<int>(random() % count);
      const double x = any(random), y = any(random), z = any(random);
      const double a = any(random), b = any(random), c = any(random);
      WalkRules rules;
      rules.direction = [&](const Vector3&) { return Vector3(x, y, z); };
      rules.fixedPlane = i % 2 == 1;
      rules.start = i % 3 ? Vector3(a, b, c) : Vector3(Vector3::Zero());
      rules.snapLength = 1.0;
      rules.longest = 100.0;
      const auto way = from == to ? std::nullopt : walkPlane(whole, from, to, rules);
      if (way)
      {
        ++found;
        CurveMesh split = whole;
        std::vector<int> chain = makeWay(split, *way);
        chain.push_back(to);
        int before = from;
        for (const int v : chain)
        {
          EXPECT_TRUE(split.joined(before, v)) << "round " << round << ", way " << i;
          before = v;
        }
      }
    }
  }
  EXPECT_GT(found, 1500);
}
