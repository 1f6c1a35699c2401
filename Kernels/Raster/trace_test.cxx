// Outlines of things in pictures whose rims are known by formulas.
#include "Raster/trace.h"

#include "Harness/threads.h"
#include "Stroke/meetings.h"

#include <opencv2/core.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

using namespace oversketch;
using oversketch_test::twoThreads;

namespace
{

constexpr double near = 1.5; // px

using Colour = std::array<double, 3>;
using Inside = std::function<bool(const Vector2& place)>;
using Painting = std::function<Colour(const Vector2& place)>;

// Samples in memory, each the mean of 16 places of its pixel.
struct Picture
{
  int width = 300, height = 300, components = 3;
  std::vector<std::uint8_t> samples = {};

  PictureSamples view() const
  {
    return { this->samples.data(), this->width, this->height, this->components };
  }
};

Picture painted(const Inside& isIn,
  const Painting& in,
  const Painting& out,
  int components = 3,
  int side = 300)
{
  Picture picture{ side, side, components };
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      Colour sum{};
      double covered = 0.0;
      for (int k = 0; k < 16; ++k)
      {
        const Vector2 place(x - 0.375 + 0.25 * (k % 4), y - 0.375 + 0.25 * (k / 4));
        const bool inside = isIn(place);
        const Colour colour = inside ? in(place) : out(place);
        covered += inside ? 1.0 / 16.0 : 0.0;
        for (std::size_t c = 0; c < 3; ++c)
        {
          sum[c] += colour[c] / 16.0;
        }
      }
      for (int c = 0; c < components; ++c)
      {
        const bool isAlpha = components % 2 == 0 && c + 1 == components;
        const double value = isAlpha ? 255.0 * covered : sum[static_cast<std::size_t>(c)];
        picture.samples.push_back(static_cast<std::uint8_t>(std::lround(value)));
      }
    }
  }
  return picture;
}

Painting evenly(double r, double g, double b)
{
  return [=](const Vector2&) { return Colour{ r, g, b }; };
}

const Painting dark = evenly(40, 40, 40), white = evenly(250, 250, 250), red = evenly(200, 40, 40);

Inside disc(const Vector2& middle, double radius)
{
  return [=](const Vector2& place) { return (place - middle).norm() < radius; };
}

Inside polygon(const Polyline& corners)
{
  return [=](const Vector2& place)
  {
    bool inside = false;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      inside = inside != passesRight(place, corners[i], corners[(i + 1) % corners.size()]);
    }
    return inside;
  };
}

Polyline regular(int corners, const Vector2& middle, double radius, double turned)
{
  Polyline places;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = turned + 2.0 * M_PI * i / corners;
    places.emplace_back(middle + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

// The rim and the outline of it lie on each other.
void expectRim(const Polyline& traced, const Polyline& rim)
{
  const auto farthest = [](const Polyline& from, const Polyline& to)
  {
    const NearestPlace nearest(to, true);
    double most = 0.0;
    for (const Vector2& place : from)
    {
      most = std::max(most, nearest(place).distance);
    }
    return most;
  };
  ASSERT_GT(traced.size(), 8u);
  EXPECT_LT(farthest(traced, rim), near);
  EXPECT_LT(farthest(rim, traced), near);
}

void expectDisc(const Polyline& traced, const Vector2& middle, double radius)
{
  expectRim(traced, regular(720, middle, radius, 0.0));
}

std::vector<TracedRim> outlines(const Picture& picture, const std::optional<Vector2>& place = std::nullopt)
{
  return traced(picture.view(), place, Context());
}

const Vector2 middle(150.3, 148.7);

} // namespace

TEST(Trace, RimsAreWhereTheyAreInEveryKindOfPicture)
{
  for (const int components : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(components);
    for (const bool isPlaced : { false, true })
    {
      const auto rims = outlines(painted(disc(middle, 80.0), dark, white, components),
        isPlaced ? std::optional(middle) : std::nullopt);
      ASSERT_EQ(rims.size(), 1u);
      EXPECT_FALSE(rims[0].isHole);
      expectDisc(rims[0].points, middle, 80.0);
      // As a hand leaves samples.
      const std::vector<double> lengths = arcLengths(rims[0].points, true);
      for (std::size_t i = 1; i < lengths.size(); ++i)
      {
        EXPECT_GT(lengths[i] - lengths[i - 1], 1.5);
        EXPECT_LT(lengths[i] - lengths[i - 1], 6.5);
      }
    }
  }
}

TEST(Trace, CornersStay)
{
  for (const int corners : { 3, 4, 5 })
  {
    for (const double turned : { 0.0, 0.3, 0.7 })
    {
      SCOPED_TRACE(std::to_string(corners) + ", " + std::to_string(turned));
      const Polyline shape = regular(corners, middle, 90.0, turned);
      const auto rims = outlines(painted(polygon(shape), dark, white));
      ASSERT_EQ(rims.size(), 1u);
      expectRim(rims[0].points, shape);
      const NearestPlace nearest(rims[0].points, true);
      for (const Vector2& corner : shape)
      {
        EXPECT_LT(nearest(corner).distance, near);
      }
    }
  }
}

TEST(Trace, ARingHasAHoleAndSpecksAreNone)
{
  const auto ring = [](const Vector2& place)
  {
    const double from = (place - middle).norm();
    const bool isSpeck = (place - middle - Vector2(60.0, 0.0)).norm() < 2.0;
    return from > 40.0 && from < 80.0 && !isSpeck;
  };
  for (const int components : { 3, 4 })
  {
    const auto rims = outlines(painted(ring, dark, white, components), Vector2(middle + Vector2(0.0, 60.0)));
    ASSERT_EQ(rims.size(), 2u);
    EXPECT_FALSE(rims[0].isHole);
    EXPECT_TRUE(rims[1].isHole);
    expectDisc(rims[0].points, middle, 80.0);
    expectDisc(rims[1].points, middle, 40.0);
  }
  // Ground that is shut in is a thing, where it is meant.
  const auto inner = outlines(painted(ring, dark, white), middle);
  ASSERT_EQ(inner.size(), 1u);
  expectDisc(inner[0].points, middle, 40.0);
}

TEST(Trace, AWhiskerGoesAndALimbStays)
{
  const auto withBar = [](double wide)
  {
    return [wide](const Vector2& place)
    {
      const Vector2 from = place - middle;
      return from.norm() < 60.0 || (from[0] > 0.0 && from[0] < 120.0 && std::abs(from[1]) < 0.5 * wide);
    };
  };
  for (const int components : { 3, 4 })
  {
    const auto bare = outlines(painted(withBar(1.8), dark, white, components));
    ASSERT_EQ(bare.size(), 1u);
    expectDisc(bare[0].points, middle, 60.0);
    const auto limb = outlines(painted(withBar(6.0), dark, white, components));
    ASSERT_EQ(limb.size(), 1u);
    double farthest = 0.0;
    for (const Vector2& place : limb[0].points)
    {
      farthest = std::max(farthest, place[0] - middle[0]);
    }
    EXPECT_NEAR(farthest, 120.0, near);
  }
}

TEST(Trace, AThingMayTouchTheBorder)
{
  const Vector2 edge(0.0, 150.0);
  Polyline rim;
  for (int i = -180; i <= 180; ++i)
  {
    rim.emplace_back(edge + 60.0 * Vector2(std::cos(i * M_PI / 360.0), std::sin(i * M_PI / 360.0)));
  }
  for (const int components : { 3, 4 })
  {
    const auto rims = outlines(painted(disc(edge, 60.0), red, white, components), Vector2(20.0, 150.0));
    ASSERT_EQ(rims.size(), 1u);
    expectRim(rims[0].points, rim);
    for (const Vector2& place : rims[0].points)
    {
      EXPECT_GE(place[0], 0.0) << "in the picture";
    }
  }
}

TEST(Trace, NoiseDoesNotMoveARim)
{
  Picture picture = painted(disc(middle, 70.0), evenly(90, 90, 90), evenly(200, 200, 200), 1);
  std::minstd_rand numbers(7);
  for (std::uint8_t& sample : picture.samples)
  {
    sample = static_cast<std::uint8_t>(sample + static_cast<int>(numbers() % 9) - 4);
  }
  const auto rims = outlines(picture, middle);
  ASSERT_EQ(rims.size(), 1u);
  expectDisc(rims[0].points, middle, 70.0);
}

TEST(Trace, AnEvenThingIsFoundOnAGroundThatIsNone)
{
  const Painting light = [](const Vector2& place) {
    return Colour{ 40.0 + 0.6 * place[0], 45.0 + 0.6 * place[0], 40.0 + 0.3 * (place[0] + place[1]) };
  };
  const auto rims = outlines(painted(disc(middle, 70.0), red, light), Vector2(140.0, 160.0));
  ASSERT_EQ(rims.size(), 1u);
  expectDisc(rims[0].points, middle, 70.0);
}

TEST(Trace, APhotographsThingIsCutOut)
{
  // No tolerance has an even area round the place.
  const Painting coat = [](const Vector2& place) {
    return Colour{ 28.0 + 0.9 * place[0], 30.0, 0.9 * place[1] - 42.0 };
  };
  const Painting meadow = [](const Vector2& place) {
    return Colour{ 20.0, 60.0 + 0.5 * place[0], 30.0 + 0.5 * place[1] };
  };
  const Picture picture = painted(disc(middle, 70.0), coat, meadow);
  const std::uint64_t before = cv::theRNG().state;
  const auto rims = outlines(picture, middle);
  EXPECT_EQ(cv::theRNG().state, before) << "OpenCV's generator goes on as if nothing had been drawn";
  ASSERT_GE(rims.size(), 1u);
  expectDisc(rims[0].points, middle, 70.0);
  cv::theRNG().uniform(0, 9);
  const auto again = outlines(picture, middle);
  ASSERT_EQ(again.size(), rims.size());
  EXPECT_EQ(again[0].points, rims[0].points);
}

TEST(Trace, APlaceOnNothingMeansTheLargestThing)
{
  const auto two = [](const Vector2& place)
  { return (place - Vector2(90.0, 90.0)).norm() < 50.0 || (place - Vector2(220.0, 220.0)).norm() < 30.0; };
  for (const int components : { 1, 2 })
  {
    const Picture picture = painted(two, dark, white, components);
    for (const std::optional<Vector2>& place : { std::optional<Vector2>(),
           std::optional<Vector2>({ 10.0, 290.0 }),
           std::optional<Vector2>({ 90.0, 90.0 }) })
    {
      const auto rims = outlines(picture, place);
      ASSERT_EQ(rims.size(), 1u);
      expectDisc(rims[0].points, { 90.0, 90.0 }, 50.0);
    }
    const auto small = outlines(picture, Vector2(220.0, 220.0));
    ASSERT_EQ(small.size(), 1u);
    expectDisc(small[0].points, { 220.0, 220.0 }, 30.0);
  }
}

TEST(Trace, PalePartsAreNoHoles)
{
  const Painting pale = [](const Vector2& place) {
    return (place - middle).norm() < 30.0 ? Colour{ 215, 215, 215 } : Colour{ 40, 40, 40 };
  };
  const Picture picture = painted(disc(middle, 80.0), pale, white);
  for (const std::optional<Vector2>& place : { std::optional<Vector2>(), std::optional<Vector2>(middle) })
  {
    const auto rims = outlines(picture, place);
    ASSERT_EQ(rims.size(), 1u);
    expectDisc(rims[0].points, middle, 80.0);
  }
}

TEST(Trace, FewClearPixelsCutNothingOut)
{
  Picture picture = painted(disc(middle, 80.0), dark, white, 4);
  for (std::size_t i = 3; i < picture.samples.size(); i += 4)
  {
    picture.samples[i] = i < 400 ? 100 : 255;
  }
  const auto rims = outlines(picture);
  ASSERT_EQ(rims.size(), 1u);
  expectDisc(rims[0].points, middle, 80.0);
}

TEST(Trace, RaggedRimsMeetNothing)
{
  Picture picture = painted(disc(middle, 80.0), dark, white, 4);
  std::minstd_rand numbers(11);
  for (std::size_t i = 3; i < picture.samples.size(); i += 4)
  {
    const int x = static_cast<int>(i / 4) % 300, y = static_cast<int>(i / 4) / 300;
    const double from = (Vector2(x, y) - middle).norm();
    if (from > 74.0 && from < 90.0 && y < 120) // grass
    {
      picture.samples[i] = numbers() % 2 ? 255 : 0;
    }
  }
  std::vector<PlaneCurve> curves;
  for (const TracedRim& rim : outlines(picture))
  {
    curves.push_back({ rim.points, true });
  }
  ASSERT_GE(curves.size(), 1u);
  for (const Meeting& met : meetings(curves, Context()))
  {
    EXPECT_EQ(met.segment, -1);
  }
}

TEST(Trace, LinesAloneAreTakenWithWhatTheyEnclose)
{
  const auto line = [](const Vector2& place) { return std::abs((place - middle).norm() - 80.0) < 1.0; };
  const auto rims = outlines(painted(line, dark, white));
  ASSERT_EQ(rims.size(), 1u);
  expectDisc(rims[0].points, middle, 81.0);
}

TEST(Trace, WhereNothingIsItIsSaid)
{
  const auto refuses = [](const Picture& picture)
  {
    for (const std::optional<Vector2>& place :
      { std::optional<Vector2>(), std::optional<Vector2>({ 0.0, 0.0 }) })
    {
      try
      {
        outlines(picture, place);
        ADD_FAILURE();
      }
      catch (const Error& error)
      {
        EXPECT_EQ(error.failure(), Failure::BadStroke);
        EXPECT_NE(std::string(error.what()).find("nothing to trace"), std::string::npos) << error.what();
      }
    }
  };
  const Inside nowhere = [](const Vector2&) { return false; };
  for (const int components : { 1, 2, 3, 4 })
  {
    refuses(painted(nowhere, dark, white, components));
    refuses(painted(nowhere, dark, white, components, 1));
  }
  refuses(painted(disc(middle, 0.8), dark, white)); // a speck
}

TEST(Trace, ThreadsChangeNothing)
{
  const Picture picture = painted(disc(middle, 80.0), red, white);
  const auto one = outlines(picture), two = traced(picture.view(), std::nullopt, twoThreads());
  ASSERT_EQ(one.size(), two.size());
  EXPECT_EQ(one[0].points, two[0].points);
}
