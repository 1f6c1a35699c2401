// Facts of image-assisted.md, section 3.
#include "Stroke/livewire.h"

#include "Harness/shapes.h"
#include "Stroke/path_search.h"

#include <opencv2/imgproc/segmentation.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

using namespace oversketch;

namespace
{

constexpr double pi = 3.14159265358979323846;

// Cost of a given path, by its formula.
double pathCost(const EdgeFeatures& features, const PathField& field, const std::vector<Pixel>& path)
{
  double cost = 0.0;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    const Pixel &p = path[i - 1], &q = path[i];
    const auto place = [&](const Pixel& a) { return static_cast<std::size_t>(a[1]) * features.width + a[0]; };
    const Vector2 way = (q - p).cast<double>().normalized();
    const auto along = [&](const Pixel& a)
    {
      const Vector2 tangent(features.gy[place(a)], -static_cast<double>(features.gx[place(a)]));
      const double length = tangent.norm();
      return length > 0.0 ? std::clamp(tangent.dot(way) / length, -1.0, 1.0) : 0.0;
    };
    double dp = along(p), dq = along(q);
    if (dp < 0.0)
    {
      dp = -dp;
      dq = -dq;
    }
    const double flat =
      1.0 - (features.greatest > 0.0f ? features.magnitude[place(q)] / double(features.greatest) : 0.0);
    const bool diagonal = p[0] != q[0] && p[1] != q[1];
    const int at = indexOf(field, q);
    cost += (at >= 0 && field.states[at] == PathField::Edge ? 0.0 : PathWeights::edge) +
            PathWeights::turn * (std::acos(dp) + std::acos(dq)) / PathWeights::straightAngle +
            PathWeights::gradient * (diagonal ? flat : flat * std::sqrt(0.5));
  }
  return cost;
}

// Grey values of a function of the pixel's place, averaged over 4 x 4 places of it.
EdgeFeatures pictureOf(int width, int height, const std::function<double(double, double)>& value)
{
  std::vector<std::uint8_t> grey(static_cast<std::size_t>(width) * height);
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      double sum = 0.0;
      for (int k = 0; k < 16; ++k)
      {
        const int column = k % 4, row = k / 4;
        sum += value(x + (column - 1.5) / 4.0, y + (row - 1.5) / 4.0);
      }
      grey[static_cast<std::size_t>(y) * width + x] = static_cast<std::uint8_t>(std::lround(sum / 16.0));
    }
  }
  return edgeFeatures(grey, width, height);
}

Polyline ring(const Vector2& centre, double radius, int count)
{
  Polyline points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(
      centre + radius * Vector2(std::cos(2.0 * pi * i / count), std::sin(2.0 * pi * i / count)));
  }
  return points;
}

Polyline straight(const Vector2& a, const Vector2& b, int steps)
{
  Polyline points;
  for (int i = 0; i <= steps; ++i)
  {
    points.push_back(a + (b - a) * i / steps);
  }
  return points;
}

std::vector<int> every(int step, int count)
{
  std::vector<int> seeds;
  for (int i = 0; i < count; i += step)
  {
    seeds.push_back(i);
  }
  return seeds;
}

double farthest(const SnappedStroke& result, const Polyline& stroke, bool closed)
{
  const NearestPlace nearest(stroke, closed);
  double worst = 0.0;
  for (const Vector2& p : result.points)
  {
    worst = std::max(worst, nearest(p).distance);
  }
  return worst;
}

} // namespace

TEST(C3_1, ACircleBesideADiscComesToItsEdge)
{
  std::string figure;
  for (const double sigma : { 1.0, 0.0 })
  {
    for (const double angle : { pi / 4.0, pi })
    {
      const Vector2 centre(200.3, 199.6);
      const double radius = 120.0;
      const EdgeFeatures picture = pictureOf(400,
        400,
        [&](double x, double y) { return (Vector2(x, y) - centre).norm() < radius ? 200.0 : 50.0; });
      const Polyline stroke = ring(centre, radius + 5.0, 150);
      LivewireRules rules;
      rules.sigma = sigma;
      rules.edgeAngle = angle;
      rules.together = sigma > 0.0 || angle < pi; // the last one as published
      const SnappedStroke result = snapped(picture, stroke, true, every(19, 150), rules, Context());
      ASSERT_GT(result.points.size(), 500u);
      ASSERT_EQ(result.snapped.size(), result.points.size());
      ASSERT_EQ(result.origins.size(), result.points.size());
      EXPECT_EQ(std::count(result.snapped.begin(), result.snapped.end(), 0), 0);
      double sum = 0.0, turned = 0.0;
      for (std::size_t i = 0; i < result.points.size(); ++i)
      {
        const Vector2 p = result.points[i] - centre;
        const Vector2 q = result.points[(i + 1) % result.points.size()] - centre;
        sum += std::abs(p.norm() - radius);
        turned += std::atan2(p[0] * q[1] - p[1] * q[0], p.dot(q));
        EXPECT_LT((p - q).norm(), 4.0);
        EXPECT_LT((result.origins[i].of(stroke) - result.points[i]).norm(), 12.0);
      }
      const double mean = sum / static_cast<double>(result.points.size());
      EXPECT_LE(mean, 1.5);
      EXPECT_NEAR(turned, 2.0 * pi, 1e-6);
      EXPECT_LE(farthest(result, stroke, true), 10.0 + 1e-9);
      figure += (figure.empty() ? "" : ", ") + std::to_string(mean);
    }
  }
  oversketch_test::fact("C3_1",
    "circle 5 px outside a disc: on its edge everywhere, mean distance " + figure +
      " px (smoothed, with any angle; not smoothed, with any angle)");
}

TEST(C3_2, AConstantPictureChangesNothing)
{
  const EdgeFeatures picture = pictureOf(300, 200, [](double, double) { return 90.0; });
  for (const bool closed : { false, true })
  {
    const Polyline stroke = ring(Vector2(150.2, 99.7), 80.1, 90);
    LivewireRules published;
    published.together = false;
    EXPECT_EQ(snapped(picture, stroke, closed, every(10, 90), published, Context()).points, stroke);
    const SnappedStroke result = snapped(picture, stroke, closed, every(10, 90), {}, Context());
    EXPECT_EQ(result.points, stroke);
    EXPECT_EQ(std::count(result.snapped.begin(), result.snapped.end(), 1), 0);
    // One that leaves the picture, too, and one that is wholly beside it.
    for (const Vector2& centre : { Vector2(290.0, 10.0), Vector2(-500.0, 1e7) })
    {
      const Polyline beside = ring(centre, 80.1, 90);
      EXPECT_EQ(snapped(picture, beside, closed, every(10, 90), {}, Context()).points, beside);
    }
  }
  for (const int size : { 1, 2, 5 }) // tiny pictures
  {
    const EdgeFeatures tiny = pictureOf(size, 1, [](double x, double) { return x > 1.0 ? 255.0 : 0.0; });
    const Polyline stroke = ring(Vector2(0.0, 0.0), 3.0, 20);
    EXPECT_EQ(snapped(tiny, stroke, true, {}, {}, Context()).points, stroke);
  }
  oversketch_test::fact(
    "C3_2", "constant picture, open and closed, leaving it and beside it: output is input to the bit");
}

TEST(C3_3, OnlyTheHalfOnTheEdgeChanges)
{
  // The edge y = 100 fades away at x = 200.
  const EdgeFeatures picture =
    pictureOf(400, 200, [](double x, double y) { return y < 100.0 || x > 200.0 ? 60.0 : 190.0; });
  const Polyline stroke = straight(Vector2(20.0, 104.0), Vector2(380.0, 104.0), 90);
  const SnappedStroke result = snapped(picture, stroke, false, every(15, 91), {}, Context());
  double onEdge = 0.0;
  int same = 0, moved = 0;
  for (std::size_t i = 0; i < result.points.size(); ++i)
  {
    const Vector2 p = result.points[i];
    if (result.snapped[i])
    {
      EXPECT_LT(p[0], 212.0);
      ++moved;
      onEdge = p[0] < 190.0 ? std::max(onEdge, std::abs(p[1] - 99.5)) : onEdge;
    }
    else
    {
      EXPECT_GT(p[0], 190.0);
      EXPECT_NE(std::find(stroke.begin(), stroke.end(), p), stroke.end());
      ++same;
    }
  }
  for (const Vector2& p : stroke)
  {
    if (p[0] > 214.0)
    {
      EXPECT_NE(std::find(result.points.begin(), result.points.end(), p), result.points.end());
    }
  }
  EXPECT_LE(onEdge, 1.5);
  EXPECT_GT(moved, 150);
  EXPECT_EQ(result.points.back(), stroke.back());
  oversketch_test::fact("C3_3",
    std::to_string(moved) + " points on the edge's half within " + std::to_string(onEdge) + " px of it, " +
      std::to_string(same) + " samples of the other to the bit");
}

TEST(C3_4, AStrongerEdgeOutOfReachNeverAttracts)
{
  double worst = 0.0;
  int near = 0;
  for (unsigned seed = 0; seed < 12; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-2.0, 2.0);
    // A weak edge at 100, a strong one 15 px farther.
    const EdgeFeatures picture =
      pictureOf(500, 220, [](double, double y) { return y < 100.0 ? 60.0 : (y < 115.0 ? 100.0 : 255.0); });
    Polyline stroke = straight(Vector2(10.0, 99.0), Vector2(490.0, 99.0), 120);
    for (Vector2& p : stroke)
    {
      p[1] += noise(random);
    }
    LivewireRules rules;
    rules.edgeAngle = seed % 2 ? pi : pi / 4.0;
    rules.together = seed < 6;
    const SnappedStroke result = snapped(picture, stroke, false, every(11, 121), rules, Context());
    worst = std::max(worst, farthest(result, stroke, false));
    for (std::size_t i = 0; i < result.points.size(); ++i)
    {
      near += result.snapped[i];
      EXPECT_LT(result.points[i][1], 111.5);
    }
  }
  EXPECT_LE(worst, 10.0);
  EXPECT_GT(near, 1000);
  oversketch_test::fact("C3_4",
    "a stronger edge 15 px away: no point farther than " + std::to_string(worst) +
      " px from the stroke, rho 10");
}

TEST(C3_5, NoPathCostsMoreThanIntelligentScissors)
{
  int shorter = 0, equal = 0;
  double most = 0.0;
  for (unsigned seed = 0; seed < 6; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(20.0, 140.0), size(8.0, 40.0), grey(0.0, 255.0);
    std::vector<std::array<double, 4>> discs(9);
    for (auto& disc : discs)
    {
      disc = { place(random), place(random), size(random), grey(random) };
    }
    const int width = 160, height = 150;
    const EdgeFeatures picture = pictureOf(width,
      height,
      [&](double x, double y)
      {
        double value = 30.0;
        for (const auto& disc : discs)
        {
          value = std::hypot(x - disc[0], y - disc[1]) < disc[2] ? disc[3] : value;
        }
        return value;
      });
    PathField field{ 0, 0, width, height, {}, {} };
    for (const std::uint8_t edge : picture.edges)
    {
      field.states.push_back(edge ? PathField::Edge : PathField::Plain);
    }
    // The same features as OpenCV's scissors take them.
    cv::Mat plain(height, width, CV_8UC1), direction(height, width, CV_32FC2), flat(height, width, CV_32FC1);
    for (int y = 0; y < height; ++y)
    {
      for (int x = 0; x < width; ++x)
      {
        const std::size_t i = static_cast<std::size_t>(y) * width + x;
        const float g = picture.magnitude[i];
        plain.at<std::uint8_t>(y, x) = picture.edges[i] ? 0 : 1;
        direction.at<cv::Vec2f>(y, x) =
          g > 0.0f ? cv::Vec2f(picture.gx[i] / g, picture.gy[i] / g) : cv::Vec2f(0.0f, 0.0f);
        flat.at<float>(y, x) = 1.0f - g / picture.greatest;
      }
    }
    cv::segmentation::IntelligentScissorsMB scissors;
    scissors.applyImageFeatures(plain, direction, flat);
    std::uniform_int_distribution<int> px(0, width - 1), py(0, height - 1);
    for (int source = 0; source < 4; ++source)
    {
      const Pixel from(px(random), py(random));
      scissors.buildMap(cv::Point(from[0], from[1]));
      for (int target = 0; target < 10; ++target)
      {
        const Pixel to(px(random), py(random));
        std::vector<cv::Point> contour;
        scissors.getContour(cv::Point(to[0], to[1]), contour);
        std::vector<Pixel> theirs;
        theirs.reserve(contour.size());
        for (const cv::Point& p : contour)
        {
          theirs.emplace_back(p.x, p.y);
        }
        ASSERT_EQ(theirs.front(), from);
        ASSERT_EQ(theirs.back(), to);
        const std::vector<Pixel> ours =
          PathSearch()(picture, field, { { from, 0.0 } }, { to }, Context()).pathTo(to);
        ASSERT_EQ(ours.front(), from);
        ASSERT_EQ(ours.back(), to);
        const double a = pathCost(picture, field, ours), b = pathCost(picture, field, theirs);
        EXPECT_LE(a, b + 1e-9);
        shorter += a < b - 1e-9;
        equal += std::abs(a - b) <= 1e-9;
        most = b > 0.0 ? std::max(most, b / a - 1.0) : most;
      }
    }
  }
  // The formulas agree, or theirs would be far dearer.
  EXPECT_LT(most, 0.05);
  oversketch_test::fact("C3_5",
    "240 paths over whole pictures: " + std::to_string(equal) + " cost the same, " + std::to_string(shorter) +
      " less (theirs up to " + std::to_string(100.0 * most) + " % more), none more");
}

TEST(C3_6, AStrokeAcrossAnEdgeIsLeftAlone)
{
  const EdgeFeatures picture =
    pictureOf(300, 300, [](double x, double y) { return x < 150.0 ? 40.0 : 100.0 + 0.4 * y; });
  const Polyline stroke = straight(Vector2(100.0, 150.2), Vector2(200.0, 150.2), 25);
  EXPECT_EQ(snapped(picture, stroke, false, { 0, 8, 12, 17 }, {}, Context()).points, stroke);
  // One that ends just past the edge, with its end's seed on it: with any angle that is drawn along the edge.
  const Polyline ending = straight(Vector2(100.0, 150.2), Vector2(151.0, 150.2), 25);
  EXPECT_EQ(snapped(picture, ending, false, { 0, 12 }, {}, Context()).points, ending);
  LivewireRules any;
  any.edgeAngle = pi;
  any.together = false;
  const SnappedStroke along = snapped(picture, ending, false, { 0, 12 }, any, Context());
  EXPECT_NE(along.points, ending);
  EXPECT_GE(std::count(along.snapped.begin(), along.snapped.end(), 1), 5);
  oversketch_test::fact("C3_6",
    "strokes across a step edge and up to it are unchanged to the bit; with EdgeAngle 180 the latter is "
    "drawn " +
      std::to_string(farthest(along, ending, false)) + " px along it");
}

TEST(Livewire, RefusesAndIsCancelled)
{
  const EdgeFeatures picture = pictureOf(60, 60, [](double x, double) { return x < 30.0 ? 40.0 : 210.0; });
  const Polyline stroke = straight(Vector2(29.0, 5.0), Vector2(29.0, 55.0), 25);
  EXPECT_THROW(snapped(picture, stroke, false, { 5, 4 }, {}, Context()), Error);
  EXPECT_THROW(snapped(picture, stroke, false, { 26 }, {}, Context()), Error);
  EXPECT_THROW(snapped(picture, { { 0.0, std::nan("") }, { 1.0, 1.0 } }, false, {}, {}, Context()), Error);
  EXPECT_THROW(edgeFeatures(Shades(), 0, 0), Error);
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(snapped(picture, stroke, false, {}, {}, cancelled), Error);
  // Brightness: weights of the colours, alpha over white, the upper byte of 16 bits.
  const std::vector<std::uint8_t> colours{ 255, 0, 0, 255, 0, 255, 0, 255, 9, 9, 9, 0 };
  EXPECT_EQ(luminance(PictureView<std::uint8_t>{ colours.data(), 3, 1, 4 }),
    (std::vector<std::uint8_t>{ 76, 150, 255 }));
  const std::vector<std::uint16_t> deep{ 0x1234, 0xffff };
  EXPECT_EQ(
    luminance(PictureView<std::uint16_t>{ deep.data(), 2, 1, 1 }), (std::vector<std::uint8_t>{ 0x12, 0xff }));
}

// A seed that moves to a stronger edge beside the way of the two paths that meet there leaves no way there
// and back: what is snapped does not cross or touch itself.
TEST(Livewire, SeedsLeaveNoSpurs)
{
  for (unsigned seed = 0; seed < 8; ++seed)
  {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> noise(-3.0, 3.0);
    const Vector2 centre(150.0, 150.0);
    // Rays of other brightness make spots on the disc's edge and beside it where the gradient is greatest.
    const EdgeFeatures picture = pictureOf(300,
      300,
      [&](double x, double y)
      {
        const double r = (Vector2(x, y) - centre).norm(), a = std::atan2(y - 150.0, x - 150.0);
        const bool spot = std::abs(r - 107.0) < 2.0 && std::cos(12.0 * a) > 0.9;
        return spot ? 255.0 : (r < 100.0 ? 150.0 : 60.0);
      });
    Polyline stroke = ring(centre, 102.0, 110);
    for (Vector2& p : stroke)
    {
      p += Vector2(noise(random), noise(random)) * 0.5;
    }
    LivewireRules rules;
    rules.sigma = 0.0;
    rules.together = seed % 2 == 0;
    const SnappedStroke result = snapped(picture, stroke, true, every(9, 110), rules, Context());
    const int count = static_cast<int>(result.points.size());
    int touching = 0, snappedCount = 0;
    for (int i = 0; i < count; ++i)
    {
      snappedCount += result.snapped[i];
      for (int j = i + 1; j < count; ++j)
      {
        touching += result.points[i] == result.points[j];
      }
    }
    EXPECT_EQ(touching, 0) << seed;
    EXPECT_GT(snappedCount, 300);
  }
}

// Beside the edge that is drawn along is a stronger one, 6 px farther, in pieces where the seeds are: as
// published seeds on it draw the path there. With all parts together the path stays.
TEST(Livewire, StaysOnTheEdgeThatIsNearBesideAStrongerOne)
{
  const EdgeFeatures picture = pictureOf(500,
    200,
    [](double x, double y)
    {
      const bool piece = std::fmod(x, 120.0) < 40.0;
      return y < 100.0 ? 60.0 : (y > 107.0 && piece ? 255.0 : 110.0);
    });
  const Polyline stroke = straight(Vector2(10.0, 98.5), Vector2(490.0, 98.5), 120);
  const auto farthestOff = [&](bool together)
  {
    LivewireRules rules;
    rules.together = together;
    double worst = 0.0;
    for (const Vector2& p : snapped(picture, stroke, false, every(30, 121), rules, Context()).points)
    {
      worst = std::max(worst, std::abs(p[1] - 99.5));
    }
    return worst;
  };
  EXPECT_GT(farthestOff(false), 5.0);
  EXPECT_LE(farthestOff(true), 1.5);
}

// Red beside a green as bright has an edge by its colours alone.
TEST(Livewire, ColoursHaveEdgesWhereBrightnessHasNone)
{
  const int width = 200, height = 120;
  std::vector<std::uint8_t> colours, flat;
  for (int i = 0; i < width * height; ++i)
  {
    const bool above = i / width >= 60;
    const std::array<std::uint8_t, 4> pixel{
      static_cast<std::uint8_t>(above ? 196 : 0), static_cast<std::uint8_t>(above ? 0 : 100), 30, 255
    };
    colours.insert(colours.end(), pixel.begin(), pixel.begin() + 3);
    flat.insert(flat.end(), pixel.begin(), pixel.end());
  }
  const PictureView<std::uint8_t> view{ colours.data(), width, height, 3 };
  const Polyline stroke = straight(Vector2(10.0, 64.0), Vector2(190.0, 64.0), 45);
  const auto moved = [&](const EdgeFeatures& features)
  {
    const SnappedStroke result = snapped(features, stroke, false, every(15, 46), {}, Context());
    EXPECT_LE(farthest(result, stroke, false), 10.0);
    return std::count(result.snapped.begin(), result.snapped.end(), 1);
  };
  EXPECT_EQ(moved(edgeFeatures(luminance(view), width, height)), 0);
  const EdgeFeatures edges = edgeFeatures(shades(view), width, height);
  EXPECT_GT(moved(edges), 150);
  EXPECT_FLOAT_EQ(edges.greatest, 4.0f * 196.0f);
  // Opaque, the same; through alpha, as on white; grey, one value a pixel.
  const PictureView<std::uint8_t> opaque{ flat.data(), width, height, 4 };
  EXPECT_EQ(shades(opaque).values, colours);
  const std::vector<std::uint8_t> faint{ 10, 20, 30, 0, 10, 20, 30, 255 }, grey{ 7, 255, 90, 255 };
  EXPECT_EQ(shades(PictureView<std::uint8_t>{ faint.data(), 2, 1, 4 }).values,
    (std::vector<std::uint8_t>{ 255, 255, 255, 10, 20, 30 }));
  const Shades one = shades(PictureView<std::uint8_t>{ grey.data(), 2, 1, 2 });
  EXPECT_EQ(one.channels, 1);
  EXPECT_EQ(one.values, (std::vector<std::uint8_t>{ 7, 90 }));
}
