// Strokes that cross, span and bound together: section 17 of image-assisted.md.
#include "Harness/drawing_shapes.h"
#include "Planar/arrange.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Frame& arrangeFrame()
{
  static const Frame made = frameOf({ Vector2::Zero(), Vector2(1024.0, 1024.0) });
  return made;
}

std::vector<ArrangedCurve> arranged(const std::vector<DrawnStroke>& strokes)
{
  return arrange(arrangeFrame(), strokes, 20.0, Context());
}

std::vector<DrawnStroke> curvesAsStrokes(const std::vector<ArrangedCurve>& curves)
{
  std::vector<DrawnStroke> strokes;
  strokes.reserve(curves.size());
  for (const ArrangedCurve& one : curves)
  {
    strokes.push_back(one.curve);
  }
  return strokes;
}

int closedOnes(const std::vector<ArrangedCurve>& curves)
{
  return static_cast<int>(
    std::count_if(curves.begin(), curves.end(), [](const ArrangedCurve& one) { return one.curve.closed; }));
}

double enclosed(const Polyline& points)
{
  double area = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector2 &a = points[i], &b = points[(i + 1) % points.size()];
    area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
  }
  return std::abs(area);
}

// An arc of a circle, both ends drawn [rad].
DrawnStroke arc(const Vector2& centre, double radius, double from, double to)
{
  DrawnStroke stroke;
  const int steps = std::max(4, static_cast<int>(std::abs(to - from) * radius / 5.0));
  for (int i = 0; i <= steps; ++i)
  {
    const double angle = from + (to - from) * i / steps;
    stroke.points.emplace_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return stroke;
}

DrawnStroke line(const Vector2& from, const Vector2& to)
{
  DrawnStroke stroke;
  const int steps = std::max(1, static_cast<int>((to - from).norm() / 5.0));
  for (int i = 0; i <= steps; ++i)
  {
    stroke.points.emplace_back(from + (to - from) * i / steps);
  }
  return stroke;
}

// Nothing meets but in common samples, and nothing is rejected as crossing.
void expectApart(const std::vector<DrawnStroke>& strokes)
{
  const Classification classes = classify(arrangeFrame(), strokes, 0.05, Context());
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    EXPECT_NE(classes.strokes[i].rejection, Rejection::Crosses) << i << " " << classes.strokes[i].other;
    EXPECT_NE(classes.strokes[i].rejection, Rejection::CrossesItself) << i;
    EXPECT_NE(classes.strokes[i].rejection, Rejection::Areas) << i;
  }
}

std::set<std::pair<double, double>> allPlaces(const std::vector<ArrangedCurve>& curves)
{
  std::set<std::pair<double, double>> places;
  for (const ArrangedCurve& one : curves)
  {
    for (const Vector2& p : one.curve.points)
    {
      places.emplace(p[0], p[1]);
    }
  }
  return places;
}

} // namespace

TEST(Arrange, WhatMeetsNothingStaysAsItIs)
{
  const std::vector<DrawnStroke> strokes{ closedStroke(ringAt(500, 500, 400)),
    closedStroke(ringAt(350, 500, 120)),
    line({ 600, 300 }, { 640, 600 }),
    openStroke({ { 400, 900 } }),         // of one place
    line({ 900, 900 }, { 1100, 1000 }) }; // leaves the canvas
  const std::vector<ArrangedCurve> curves = arranged(strokes);
  ASSERT_EQ(curves.size(), strokes.size());
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    EXPECT_EQ(curves[i].stroke, static_cast<int>(i));
    EXPECT_EQ(curves[i].curve.closed, strokes[i].closed);
    EXPECT_TRUE(curves[i].curve.nodes.empty());
    EXPECT_EQ(curves[i].curve.points, strokes[i].points);
  }
}

TEST(Arrange, OverlappingCirclesAreOneOutlineAndTwoCurvesInIt)
{
  const double r = 200.0, half = 120.0; // of the distance of the centres
  const std::vector<ArrangedCurve> curves = arranged(
    { closedStroke(ringAt(512 - half, 512, r, 4000)), closedStroke(ringAt(512 + half, 512, r, 4000)) });
  ASSERT_EQ(curves.size(), 3u);
  EXPECT_EQ(closedOnes(curves), 1);
  const double lens = 2.0 * r * r * std::acos(half / r) - 2.0 * half * std::sqrt(r * r - half * half);
  const double both = turn * r * r - lens;
  for (const ArrangedCurve& one : curves)
  {
    ASSERT_EQ(one.curve.nodes.size(), 2u);
    for (const int node : one.curve.nodes)
    {
      const Vector2& p = one.curve.points[node];
      EXPECT_NEAR(p[0], 512.0, 0.01);
      EXPECT_NEAR(std::abs(p[1] - 512.0), std::sqrt(r * r - half * half), 0.01);
    }
    if (one.curve.closed)
    {
      EXPECT_NEAR(enclosed(one.curve.points), both, 1e-5 * both);
    }
    else
    {
      EXPECT_EQ(one.curve.nodes.back(), static_cast<int>(one.curve.points.size()) - 1);
      EXPECT_NEAR(2.0 * enclosed(one.curve.points), lens, 1e-5 * both);
    }
  }
  expectApart(curvesAsStrokes(curves));
}

TEST(Arrange, SeveralStrokesBoundOneObject)
{
  // Three arcs of one circle: a gap of 12 px, an overlap, and one that runs 10 px past the next.
  const Vector2 centre(512, 512);
  DrawnStroke second = arc(centre, 300, 0.36 * turn, 0.7 * turn);
  second.points.insert(second.points.begin(), second.points.front() * 2.0 - second.points[1]);
  const std::vector<DrawnStroke> strokes{
    arc(centre, 300, 0.0, 0.36 * turn - 12.0 / 300.0), second, arc(centre, 303, 0.68 * turn, 1.002 * turn)
  };
  const std::vector<ArrangedCurve> curves = arranged(strokes);
  EXPECT_EQ(closedOnes(curves), 1);
  const DrawnStroke& outline = curves.front().curve;
  ASSERT_TRUE(outline.closed);
  EXPECT_NEAR(enclosed(outline.points), 0.5 * turn * 300.0 * 300.0, 0.03 * 0.5 * turn * 300.0 * 300.0);
  const Classification classes = classify(arrangeFrame(), curvesAsStrokes(curves), 0.05, Context());
  EXPECT_EQ(classes.objects, 1);
  EXPECT_EQ(classes.strokes[0].role, Role::Boundary);
  expectApart(curvesAsStrokes(curves));
}

TEST(Arrange, ASpanningStrokeEndsAtTheRimsThatItRunsPast)
{
  const std::vector<ArrangedCurve> curves =
    arranged({ closedStroke(ringAt(512, 512, 300)), line({ 512, 200 }, { 512, 824 }) });
  ASSERT_EQ(curves.size(), 2u);
  EXPECT_TRUE(curves[0].curve.closed);
  EXPECT_EQ(curves[0].curve.nodes.size(), 2u);
  const Polyline& across = curves[1].curve.points;
  EXPECT_NEAR(across.front()[1], 212.0, 0.1);
  EXPECT_NEAR(across.back()[1], 812.0, 0.1);
  // Drawn to 8 px from it, it goes on.
  const std::vector<ArrangedCurve> shorter =
    arranged({ closedStroke(ringAt(512, 512, 300)), line({ 512, 220 }, { 512, 804 }) });
  ASSERT_EQ(shorter.size(), 2u);
  EXPECT_EQ(shorter[1].curve.nodes.size(), 2u);
  // A long way past, it leaves a piece outside.
  const std::vector<ArrangedCurve> longer =
    arranged({ closedStroke(ringAt(512, 512, 300)), line({ 512, 100 }, { 512, 600 }) });
  ASSERT_EQ(longer.size(), 3u);
  const Classification classes = classify(arrangeFrame(), curvesAsStrokes(longer), 0.05, Context());
  EXPECT_EQ(classes.strokes[1].rejection, Rejection::Outside);
  EXPECT_EQ(classes.strokes[2].role, Role::OpenFeature);
}

TEST(Arrange, AClosedStrokeThatIsReachedStaysOne)
{
  // Two lines from a circle inside to the outline: the circle may still be a hole.
  const std::vector<ArrangedCurve> curves = arranged({ closedStroke(ringAt(512, 512, 300)),
    closedStroke(ringAt(512, 512, 80)),
    line({ 594, 512 }, { 808, 512 }),
    line({ 430, 512 }, { 216, 512 }) });
  ASSERT_EQ(curves.size(), 4u);
  EXPECT_EQ(closedOnes(curves), 2);
  const Classification classes = classify(arrangeFrame(), curvesAsStrokes(curves), 0.05, Context());
  EXPECT_EQ(classes.strokes[1].role, Role::ClosedFeature);
  EXPECT_EQ(classes.strokes[2].role, Role::OpenFeature);
  // A stroke through it as well.
  const std::vector<ArrangedCurve> crossed = arranged({ closedStroke(ringAt(512, 512, 300)),
    closedStroke(ringAt(512, 512, 80)),
    line({ 512, 350 }, { 512, 700 }) });
  EXPECT_EQ(closedOnes(crossed), 2);
  EXPECT_EQ(crossed.size(), 5u);
}

TEST(Arrange, TwoPartsThatHangByAPointAreNamed)
{
  DrawnStroke eight;
  eight.closed = true;
  for (int i = 0; i < 400; ++i)
  {
    const double t = turn * i / 400;
    eight.points.emplace_back(500.0 + 300.0 * std::sin(t), 500.0 + 200.0 * std::sin(2.0 * t));
  }
  try
  {
    arranged({ closedStroke(ringAt(150, 900, 60)), eight });
    ADD_FAILURE() << "no error";
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    const std::string text = error.what();
    EXPECT_NE(text.find("stroke 1 meets itself near (500, 500)"), std::string::npos) << text;
  }
}

TEST(Arrange, TwoLinesDrawnForOneLeaveNoSlivers)
{
  // The lower half of an outline drawn twice, a few px apart.
  const Vector2 centre(512, 512);
  DrawnStroke again = arc(centre, 300, 0.55 * turn, 0.95 * turn);
  for (std::size_t i = 0; i < again.points.size(); ++i)
  {
    again.points[i] += 1.5 * std::sin(0.7 * static_cast<double>(i)) * (again.points[i] - centre).normalized();
  }
  const std::vector<ArrangedCurve> curves = arranged({ closedStroke(ringAt(512, 512, 300)), again });
  EXPECT_EQ(curves.size(), 1u);
  EXPECT_EQ(closedOnes(curves), 1);
}

TEST(Arrange, OrderAndDirectionDoNotMatter)
{
  std::mt19937 random(5);
  const std::vector<DrawnStroke> strokes{ closedStroke(ringAt(400, 500, 250)),
    closedStroke(ringAt(640, 520, 240)),
    line({ 180, 420 }, { 860, 610 }),
    arc({ 400, 700 }, 150, 0.02 * turn, 0.49 * turn),
    line({ 300, 480 }, { 420, 430 }) };
  const std::set<std::pair<double, double>> places = allPlaces(arranged(strokes));
  const std::size_t count = arranged(strokes).size();
  for (int run = 0; run < 20; ++run)
  {
    std::vector<DrawnStroke> other = strokes;
    std::shuffle(other.begin(), other.end(), random);
    for (DrawnStroke& stroke : other)
    {
      if (random() % 2)
      {
        std::reverse(stroke.points.begin(), stroke.points.end());
      }
    }
    const std::vector<ArrangedCurve> curves = arranged(other);
    EXPECT_EQ(curves.size(), count);
    EXPECT_TRUE(allPlaces(curves) == places);
  }
}

TEST(Arrange, ScribblesMeetInCommonSamplesAlone)
{
  int made = 0, refused = 0, nodes = 0;
  for (int run = 0; run < 60; ++run)
  {
    SCOPED_TRACE(run);
    std::mt19937 random(static_cast<unsigned>(run));
    const auto in = [&](double least, double most)
    { return least + (most - least) * static_cast<double>(random()) / 4294967296.0; };
    std::vector<DrawnStroke> strokes;
    for (int s = 0; s < 1 + run % 7; ++s)
    {
      DrawnStroke stroke;
      stroke.closed = random() % 2 == 0;
      const Vector2 middle(in(250, 750), in(250, 750));
      const double size = in(60, 200), waves = 1.0 + static_cast<double>(random() % 4), shift = in(0.0, turn);
      for (int i = 0; i < 240; ++i)
      {
        const double t = (stroke.closed ? 1.0 : 0.8) * turn * i / 240;
        stroke.points.push_back(middle + size * Vector2(std::cos(t), std::sin(t)) +
                                0.3 * size * Vector2(std::sin(waves * t + shift), 0));
      }
      strokes.push_back(std::move(stroke));
    }
    try
    {
      const std::vector<DrawnStroke> curves = curvesAsStrokes(arranged(strokes));
      ++made;
      for (const DrawnStroke& curve : curves)
      {
        nodes += static_cast<int>(curve.nodes.size());
      }
      expectApart(curves);
    }
    catch (const Error& error)
    {
      ++refused;
      EXPECT_NE(std::string(error.what()).find("hang together"), std::string::npos) << error.what();
    }
  }
  std::cout << made << " arranged, " << refused << " refused, " << nodes << " nodes\n";
  EXPECT_GT(made, 40);
  EXPECT_GT(nodes, 200);
}
