// Facts of editors.md, section 13, area selection (7a).
#include "Shading/scan_fill.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

using namespace oversketch;
using oversketch_test::fact;

namespace
{

using Pixels = std::set<Pixel>;
using Polygon = std::vector<Pixel>;

Pixels filled(const Polygon& polygon)
{
  Pixels pixels;
  for (const Span& span : scanFill(polygon))
  {
    for (int x = span.begin; x < span.end; ++x)
    {
      EXPECT_TRUE(pixels.insert({ x, span.y }).second);
    }
  }
  return pixels;
}

const Polygon square{ { 0, 0 }, { 10, 0 }, { 10, 10 }, { 0, 10 } };
const Polygon pentagram{ { 100, 180 }, { 53, 35 }, { 176, 125 }, { 24, 125 }, { 147, 35 } };

// Even-odd, of one pixel: edges that cross its row, y0 <= y < y1, at or before it.
bool inside(const Polygon& polygon, const Pixel& p)
{
  bool odd = false;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    Pixel a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if (a[1] > b[1])
    {
      std::swap(a, b);
    }
    if (a[1] <= p[1] && p[1] < b[1])
    {
      const long long cross = static_cast<long long>(p[0] - a[0]) * (b[1] - a[1]) -
                              static_cast<long long>(b[0] - a[0]) * (p[1] - a[1]);
      odd = odd != (cross >= 0);
    }
  }
  return odd;
}

Polygon randomPolygon(std::mt19937& random, int size)
{
  Polygon polygon(3 + random() % 20);
  for (Pixel& p : polygon)
  {
    p = { static_cast<int>(random() % size) - size / 4, static_cast<int>(random() % size) - size / 4 };
  }
  return polygon;
}

} // namespace

TEST(B7_6, CountsOfKnownShapes)
{
  const Pixels ten = filled(square);
  EXPECT_EQ(ten.size(), 100u);
  EXPECT_TRUE(ten.count({ 0, 0 }));
  EXPECT_FALSE(ten.count({ 10, 0 }));
  EXPECT_FALSE(ten.count({ 0, 10 }));
  EXPECT_EQ(filled({ { 0, 0 }, { 10, 0 }, { 0, 10 } }).size(), 55u);
  EXPECT_EQ(filled({ { 0, 0 }, { 10, 10 }, { 10, 0 }, { 0, 10 } }).size(), 50u);
  const Pixels star = filled(pentagram);
  EXPECT_EQ(star.size(), 4935u);
  EXPECT_FALSE(star.count({ 100, 100 }));
  Polygon twice = square;
  twice.insert(twice.end(), square.begin(), square.end());
  EXPECT_TRUE(filled(twice).empty());
  EXPECT_TRUE(filled({}).empty());
  EXPECT_TRUE(filled({ { 3, 4 } }).empty());
  EXPECT_TRUE(filled({ { 3, 4 }, { 9, 17 } }).empty());
  EXPECT_TRUE(filled({ { 3, 4 }, { 9, 17 }, { 3, 4 }, { 9, 17 } }).empty());
  fact("B7_6",
    "square 100, triangle 55, bow-tie 50, pentagram 4935 with its centre out, a square traced twice 0 "
    "pixels");
}

TEST(B7_7, PolygonsThatShareAnEdgeShareNoPixel)
{
  std::mt19937 random(9);
  int pairs = 0;
  for (int round = 0; round < 500; ++round)
  {
    // A polygon cut along the chord of two corners.
    const Polygon whole = randomPolygon(random, 60);
    const std::size_t count = whole.size(), first = random() % count, second = random() % count;
    const std::size_t i = std::min(first, second), j = std::max(first, second);
    const Polygon one(whole.begin() + i, whole.begin() + j + 1);
    Polygon other(whole.begin() + j, whole.end());
    other.insert(other.end(), whole.begin(), whole.begin() + i + 1);
    const Pixels a = filled(one), b = filled(other);
    Pixels either;
    std::set_symmetric_difference(
      a.begin(), a.end(), b.begin(), b.end(), std::inserter(either, either.begin()));
    EXPECT_EQ(either, filled(whole));
    ++pairs;
  }
  // Beside each other they are disjoint and complete together.
  const Polygon left{ { 0, 0 }, { 17, 0 }, { 5, 23 }, { 0, 23 } },
    right{ { 17, 0 }, { 30, 0 }, { 30, 23 }, { 5, 23 } };
  Pixels both = filled(left);
  const Pixels beside = filled(right);
  const std::size_t sum = both.size() + beside.size();
  both.insert(beside.begin(), beside.end());
  EXPECT_EQ(both.size(), sum);
  EXPECT_EQ(both, filled({ { 0, 0 }, { 30, 0 }, { 30, 23 }, { 0, 23 } }));
  fact("B7_7",
    std::to_string(pairs) +
      " polygons cut along a chord: the parts make the whole, no pixel twice or left out");
}

TEST(B7_8, OrderAndStartOfVerticesDoNotMatter)
{
  std::mt19937 random(4);
  for (int round = 0; round < 300; ++round)
  {
    Polygon polygon = randomPolygon(random, 80);
    const Pixels pixels = filled(polygon);
    std::rotate(polygon.begin(), polygon.begin() + 1 + random() % (polygon.size() - 1), polygon.end());
    EXPECT_EQ(filled(polygon), pixels);
    std::reverse(polygon.begin(), polygon.end());
    EXPECT_EQ(filled(polygon), pixels);
  }
  fact("B7_8", "300 polygons reversed and begun elsewhere: the same pixels");
}

TEST(B7_6, AsExactEvenOddOnTwoThousandPolygons)
{
  std::mt19937 random(1);
  for (int round = 0; round < 2000; ++round)
  {
    const int size = 20 + static_cast<int>(random() % 60);
    const Polygon polygon = randomPolygon(random, size);
    const std::vector<char> mask = filledMask(polygon, 50, 40);
    const Pixels pixels = filled(polygon);
    for (int y = -size / 4 - 1; y <= size; ++y)
    {
      for (int x = -size / 4 - 1; x <= size; ++x)
      {
        const bool is = inside(polygon, { x, y });
        ASSERT_EQ(pixels.count({ x, y }), is ? 1u : 0u);
        if (x >= 0 && x < 50 && y >= 0 && y < 40)
        {
          ASSERT_EQ(mask[y * 50 + x], is ? 1 : 0);
        }
      }
    }
  }
  fact("B7_6", "2,000 random polygons: as exact even-odd says, pixel by pixel");
}

TEST(ScanFill, LongThinAndFarPolygons)
{
  // A sliver of a million pixels: exact to the last.
  const Polygon sliver{ { -1000000, -3 }, { 1000000, 4 }, { 999999, 4 } };
  for (const Span& span : scanFill(sliver))
  {
    EXPECT_TRUE(inside(sliver, { span.begin, span.y }));
    EXPECT_FALSE(inside(sliver, { span.begin - 1, span.y }));
    EXPECT_TRUE(inside(sliver, { span.end - 1, span.y }));
    EXPECT_FALSE(inside(sliver, { span.end, span.y }));
  }
  EXPECT_THROW(scanFill({ { 0, 0 }, { 5, 1000001 }, { 9, 3 } }), Error);
  EXPECT_EQ(filledMask(square, 0, 0).size(), 0u);
  // Spans ascend and do not touch.
  const std::vector<Span> spans = scanFill(pentagram);
  for (std::size_t i = 1; i < spans.size(); ++i)
  {
    EXPECT_TRUE(
      spans[i - 1].y < spans[i].y || (spans[i - 1].y == spans[i].y && spans[i - 1].end < spans[i].begin));
  }
}
