#include "Region/flow.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace oversketch;

namespace
{

struct Link
{
  int a, b;
  double capacity;
};

struct Network
{
  std::vector<double> source, sink;
  std::vector<Link> links;

  double cost(const std::vector<char>& side) const
  {
    double sum = 0.0;
    for (std::size_t v = 0; v < side.size(); ++v)
    {
      sum += side[v] ? this->sink[v] : this->source[v];
    }
    for (const Link& link : this->links)
    {
      sum += side[link.a] != side[link.b] ? link.capacity : 0.0;
    }
    return sum;
  }

  std::vector<char> cut() const
  {
    FlowGraph graph(static_cast<int>(this->source.size()));
    graph.source = this->source;
    graph.sink = this->sink;
    for (const Link& link : this->links)
    {
      graph.addEdge(link.a, link.b, link.capacity);
    }
    return graph.sourceSide();
  }
};

} // namespace

TEST(Flow, TheCutIsTheLeastOfAllAndTheSmallestOfThose)
{
  std::mt19937 random(3);
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  for (int round = 0; round < 400; ++round)
  {
    const int count = 2 + below(9);
    Network network{ std::vector<double>(count, 0.0), std::vector<double>(count, 0.0), {} };
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
    const std::vector<char> found = network.cut();
    const double cost = network.cost(found);
    for (unsigned set = 0; set < 1u << count; ++set)
    {
      std::vector<char> side(count);
      for (int v = 0; v < count; ++v)
      {
        side[v] = static_cast<char>(set >> v & 1u);
      }
      ASSERT_GE(network.cost(side), cost);
      if (network.cost(side) == cost)
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
  Network network{ std::vector<double>(width * height, 0.0), std::vector<double>(width * height, 0.0), {} };
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
  const std::vector<char> side = network.cut();
  for (int v = 0; v < width * height; ++v)
  {
    ASSERT_EQ(side[v] != 0, v % width <= narrow) << v;
  }
}

TEST(Flow, WithoutASourceNothingIsOnItsSide)
{
  FlowGraph graph(2);
  graph.addEdge(0, 1, 5.0);
  graph.sink[1] = 2.0;
  EXPECT_EQ(graph.sourceSide(), (std::vector<char>{ 0, 0 }));
  EXPECT_TRUE(FlowGraph(0).sourceSide().empty());
}
