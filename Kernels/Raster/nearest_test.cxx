// The nearest of some pixels.
#include "Raster/nearest.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using oversketch_test::twoThreads;

namespace
{

constexpr int width = 61, height = 47;

int squared(int a, int b)
{
  const int dx = a % width - b % width, dy = a / width - b / width;
  return dx * dx + dy * dy;
}

} // namespace

// As far as what a look at all of them finds: a few pixels, many, lines of them, one, none.
TEST(Nearest, IsTheNearestOfAll)
{
  std::mt19937 random(7);
  for (const int each : { 1, 2, 5, 40, 700, width * height, 0 })
  {
    std::vector<std::uint8_t> chosen(width * height, 0);
    std::vector<int> all;
    for (int i = 0; i < width * height; ++i)
    {
      const bool isIn = each == 40 ? (i / width) % 20 == 3 && i % width > 9 && i % width < 50
                                   : each > 0 && (each == width * height ? i == 700 : random() % each == 0);
      chosen[i] = isIn ? 255 : 0;
      if (isIn)
      {
        all.push_back(i);
      }
    }
    const std::vector<int> nearest = nearestChosen(chosen, width, height, Context());
    EXPECT_EQ(nearest, nearestChosen(chosen, width, height, twoThreads()));
    for (int i = 0; i < width * height; ++i)
    {
      if (all.empty())
      {
        ASSERT_EQ(nearest[i], -1);
        continue;
      }
      ASSERT_TRUE(nearest[i] >= 0 && chosen[nearest[i]]) << i;
      int least = squared(i, all[0]);
      for (const int one : all)
      {
        least = std::min(least, squared(i, one));
      }
      ASSERT_EQ(squared(i, nearest[i]), least) << i << " of " << all.size();
    }
  }
}
