#include "Region/flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

// Of the cut between the nodes with 1 and the others.
double costOf(const FlowNetwork& network, const std::vector<char>& side)
{
  double sum = 0.0;
  for (std::size_t v = 0; v < side.size(); ++v)
  {
    sum += side[v] ? network.sink[v] : network.source[v];
  }
  for (const FlowNetwork::Link& link : network.links)
  {
    sum += side[link.a] != side[link.b] ? link.capacity : 0.0;
  }
  return sum;
}

} // namespace

TEST(Flow, TheCutIsTheLeastOfAllAndTheSmallestOfThose)
{
  std::mt19937 random(3);
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  for (int round = 0; round < 400; ++round)
  {
    const int count = 2 + below(9);
    FlowNetwork network{ std::vector<double>(count, 0.0), std::vector<double>(count, 0.0), {} };
    for (int v = 0; v < count; ++v)
    {
      (below(2) ? network.source : network.sink)[v] = below(3) ? 0 : below(6); // small: ties are frequent
      network.sink[v] += below(4) ? 0 : below(3);
    }
    for (int i = below(3 * count); i > 0; --i)
    {
      const int a = below(count), b = below(count);
      if (a != b)
      {
        network.links.push_back({ a, b, double(below(6)) });
      }
    }
    const std::vector<char> found = leastCut(network);
    const double cost = costOf(network, found);
    for (unsigned set = 0; set < 1u << count; ++set)
    {
      std::vector<char> side(count);
      for (int v = 0; v < count; ++v)
      {
        side[v] = static_cast<char>(set >> v & 1u);
      }
      ASSERT_GE(costOf(network, side), cost);
      if (costOf(network, side) == cost)
      {
        for (int v = 0; v < count; ++v)
        {
          ASSERT_LE(found[v], side[v]);
        }
      }
    }
  }
}

TEST(Flow, ALargeGridIsCutAtItsNarrowPlace)
{
  // Columns of edges of random capacity, those of column 150 a hundredth of them.
  constexpr int width = 200, height = 60, narrow = 150;
  std::mt19937 random(4);
  const auto capacity = [&] { return 1000.0 + static_cast<double>(random() % 1000u); };
  FlowNetwork network{
    std::vector<double>(width * height, 0.0), std::vector<double>(width * height, 0.0), {}
  };
  for (int y = 0; y < height; ++y)
  {
    network.source[y * width] = network.sink[y * width + width - 1] = 1e6;
    for (int x = 0; x < width; ++x)
    {
      if (x + 1 < width)
      {
        const double c = capacity();
        network.links.push_back({ y * width + x, y * width + x + 1, x == narrow ? std::floor(c / 100) : c });
      }
      if (y + 1 < height)
      {
        network.links.push_back({ y * width + x, (y + 1) * width + x, capacity() });
      }
    }
  }
  const std::vector<char> side = leastCut(network);
  for (int v = 0; v < width * height; ++v)
  {
    ASSERT_EQ(side[v] != 0, v % width <= narrow) << v;
  }
}

TEST(Flow, WithoutASourceNothingIsOnItsSide)
{
  const FlowNetwork network{ { 0.0, 0.0 }, { 0.0, 2.0 }, { { 0, 1, 5.0 } } };
  EXPECT_EQ(leastCut(network), (std::vector<char>{ 0, 0 }));
  EXPECT_TRUE(leastCut(FlowNetwork()).empty());
}
