// What a model wears of its picture.
#include "Raster/skin.h"

#include "Harness/shapes.h"

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

} // namespace

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
