// What a model wears of its picture.
#include "Raster/skin.h"

#include "Harness/threads.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using oversketch_test::twoThreads;

namespace
{

constexpr int side = 300;

// A disc of one colour on another, 2 px smaller than what is drawn round it.
std::vector<std::uint8_t> discPicture(int components, std::uint8_t outside)
{
  std::vector<std::uint8_t> samples;
  for (int y = 0; y < side; ++y)
  {
    for (int x = 0; x < side; ++x)
    {
      const bool inside = std::hypot(x + 0.5 - 150.0, y + 0.5 - 150.0) < 98.0;
      for (int k = 0; k < components; ++k)
      {
        const bool alpha = components % 2 == 0 && k + 1 == components;
        samples.push_back(static_cast<std::uint8_t>(alpha ? (inside ? 255 : 0) : inside ? 90 + k : outside));
      }
    }
  }
  return samples;
}

std::vector<PictureTriangle> discTriangles(double radius)
{
  std::vector<PictureTriangle> triangles;
  const Vector2 middle(150.0, 150.0);
  for (int i = 0; i < 64; ++i)
  {
    const double a = 2.0 * M_PI * i / 64, b = 2.0 * M_PI * (i + 1) / 64;
    triangles.push_back({ middle,
      middle + radius * Vector2(std::cos(a), std::sin(a)),
      middle + radius * Vector2(std::cos(b), std::sin(b)) });
  }
  return triangles;
}

// A disc whose colours `of` says, on another colour, and what lies r px from its middle of that skin from the
// rim.
template <typename Of>
std::vector<std::uint8_t> rimSkinOfDisc(int components, const Of& of, const Context& context = Context())
{
  std::vector<std::uint8_t> samples = discPicture(components, 7);
  const PictureSamples picture{ samples.data(), side, side, components };
  for (int at = 0; at < side * side; ++at)
  {
    const double x = at % side + 0.5 - 150.0, y = at / side + 0.5 - 150.0;
    for (int k = 0; k < picture.colours() && std::hypot(x, y) < 98.0; ++k)
    {
      samples[static_cast<std::size_t>(at) * components + k] = static_cast<std::uint8_t>(of(x, y, k));
    }
  }
  return rimSkinOf(picture, discTriangles(97.0), context);
}

} // namespace

TEST(SkinFromRim, GoesOnFromTheRim)
{
  for (const int components : { 1, 2, 3, 4 })
  {
    SCOPED_TRACE(components);
    const int colours = components - (components % 2 == 0 ? 1 : 0);
    const auto withEye = [](double x, double y, int k)
    { return std::hypot(x - 20.0, y + 10.0) < 30.0 ? 230 : 90 + k; };
    const std::vector<std::uint8_t> even = rimSkinOfDisc(components, withEye);
    EXPECT_EQ(even, rimSkinOfDisc(components, withEye, twoThreads()));
    EXPECT_EQ(even, rimSkinOfDisc(components, [](double, double, int k) { return 90 + k; }))
      << "the eye leaves nothing behind";
    for (int at = 0; at < side * side; ++at)
    {
      const double r = std::hypot(at % side + 0.5 - 150.0, at / side + 0.5 - 150.0);
      for (int k = 0; k < colours && (r < 96.0 || r > 104.0); ++k)
      {
        ASSERT_TRUE(even[at * colours + k] == (r < 96.0 ? 90 + k : 7) || (components % 2 == 0 && r > 104.0))
          << at << " " << r;
      }
    }
  }
}

TEST(SkinFromRim, OfTwoColoursHasBoth)
{
  const auto halves = [](double x, double, int) { return x < 0.0 ? 40 : 200; };
  const std::vector<std::uint8_t> made = rimSkinOfDisc(1, halves);
  for (int y = 70; y < 230; ++y)
  {
    const std::uint8_t* row = made.data() + static_cast<std::ptrdiff_t>(y) * side;
    EXPECT_NEAR(row[150 - 60], 40, 4) << y;
    EXPECT_NEAR(row[150 + 60], 200, 4) << y;
    int seam = 0; // the first of the brighter half
    for (int x = 60; x < 240 && seam == 0; ++x)
    {
      seam = row[x] > 120 ? x : 0;
      EXPECT_GE(row[x] + 3, row[x - 1]) << "it rises alone";
    }
    EXPECT_NEAR(seam, 150, 8) << y;
  }
}

TEST(SkinFromRim, KeepsTheOutmostPixels)
{
  // Fine stripes: there at the outline, where grey would be 60 off, and none in the middle.
  const auto striped = [](double x, double, int) { return static_cast<int>(x + 150.0) % 4 < 2 ? 60 : 180; };
  const std::vector<std::uint8_t> made = rimSkinOfDisc(1, striped);
  for (int x = 60; x < 240; ++x)
  {
    const int y = static_cast<int>(150.0 + std::sqrt(96.0 * 96.0 - (x - 149.5) * (x - 149.5)));
    EXPECT_NEAR(made[static_cast<std::size_t>(y) * side + x], striped(x + 0.5 - 150.0, 0.0, 0), 30) << x;
    const int beside = made[static_cast<std::size_t>(150) * side + x - 2];
    EXPECT_NEAR(made[static_cast<std::size_t>(150) * side + x], beside, std::abs(x - 150) < 60 ? 8 : 120)
      << x;
  }
  const std::vector<std::uint8_t> nothing = discPicture(3, 255);
  EXPECT_EQ(rimSkinOf({ nothing.data(), side, side, 3 }, {}, Context()), nothing);
}

TEST(Skin, IsOpaqueAndHasNoSeam)
{
  for (const int components : { 1, 2, 3, 4 })
  {
    for (const int outside : { 0, 255 })
    {
      const std::vector<std::uint8_t> samples = discPicture(components, static_cast<std::uint8_t>(outside));
      const PictureSamples picture{ samples.data(), side, side, components };
      // Transparent beyond the disc, which may be drawn too wide; else the line may be 2 px beside.
      const double radius = components % 2 == 0 ? 100.0 : 97.0;
      const std::vector<std::uint8_t> skin = skinOf(picture, discTriangles(radius), Context());
      const int colours = picture.colours();
      ASSERT_EQ(skin.size(), static_cast<std::size_t>(side * side * colours));
      EXPECT_EQ(skin, skinOf(picture, discTriangles(radius), twoThreads()));
      for (int y = 0; y < side; ++y)
      {
        for (int x = 0; x < side; ++x)
        {
          const double r = std::hypot(x + 0.5 - 150.0, y + 0.5 - 150.0);
          const std::size_t at = static_cast<std::size_t>(y * side + x) * colours;
          for (int k = 0; k < colours; ++k)
          {
            const bool worn = r < radius + 3.0 || components % 2 == 0;
            ASSERT_TRUE(!worn || skin[at + k] == 90 + k) << components << " " << x << " " << y;
            ASSERT_TRUE(worn || r < radius + 8.0 || skin[at + k] == outside) << "the picture stays";
          }
        }
      }
    }
  }
}

TEST(Skin, OfNothingIsThePicture)
{
  const std::vector<std::uint8_t> samples = discPicture(3, 255);
  EXPECT_EQ(skinOf({ samples.data(), side, side, 3 }, {}, Context()), samples);
  // What is thin keeps its colours along it.
  std::vector<std::uint8_t> striped(side * side, 10);
  for (int x = 20; x < 280; ++x)
  {
    for (int y = 149; y <= 151; ++y)
    {
      striped[y * side + x] = static_cast<std::uint8_t>(x % 200);
    }
  }
  const std::vector<PictureTriangle> thin{ { Vector2(20, 150), Vector2(280, 150), Vector2(280, 151) },
    { Vector2(20, 150), Vector2(280, 151), Vector2(20, 151) } };
  const std::vector<std::uint8_t> skin = skinOf({ striped.data(), side, side, 1 }, thin, Context());
  int same = 0;
  for (int x = 30; x < 270; ++x)
  {
    same += std::abs(skin[152 * side + x] - x % 200) <= 2;
  }
  EXPECT_GT(same, 230);
}
