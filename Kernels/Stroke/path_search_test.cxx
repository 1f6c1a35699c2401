#include "Stroke/path_search.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

using namespace oversketch;

namespace
{

constexpr std::array<std::array<int, 2>, 8> steps{
  { { -1, -1 }, { 0, -1 }, { 1, -1 }, { -1, 0 }, { 1, 0 }, { -1, 1 }, { 0, 1 }, { 1, 1 } }
};

// A picture of random edges; along some of its steps nothing is paid.
EdgeFeatures picture(int width, int height, std::mt19937& random)
{
  EdgeFeatures made;
  made.width = width;
  made.height = height;
  for (int i = 0; i < width * height; ++i)
  {
    made.gx.push_back(static_cast<float>(random() % 3) - 1.0f);
    made.gy.push_back(static_cast<float>(random() % 3) - 1.0f);
    made.magnitude.push_back(static_cast<float>(random() % 4));
    made.edges.push_back(random() % 2);
  }
  made.greatest = 3.0f;
  return made;
}

double turn(double tangent, double angle)
{
  const double a = std::abs(tangent - angle), pi = PathWeights::straightAngle;
  return std::isnan(a) ? 0.5 * pi : a > pi ? 2.0 * pi - a : a;
}

double stepCost(const EdgeFeatures& features, const PathField& field, int p, int q, int k)
{
  const double pi = PathWeights::straightAngle, angle = std::atan2(steps[k][1], steps[k][0]);
  double ap = turn(tangentOf(features, p), angle), aq = turn(tangentOf(features, q), angle);
  if (ap > 0.5 * pi)
  {
    ap = pi - ap;
    aq = pi - aq;
  }
  const bool diagonal = steps[k][0] != 0 && steps[k][1] != 0;
  const double flat = PathWeights::gradient * (1.0 - 1.0 / features.greatest * features.magnitude[q]);
  const double usual = (field.states[q] == PathField::Edge ? 0.0 : PathWeights::edge) +
                       PathWeights::turn * (ap + aq) / pi + (diagonal ? flat : flat * std::sqrt(0.5));
  return usual + (diagonal ? std::sqrt(2.0) : 1.0) * field.extra[q];
}

// By the book: an ordered set of all places, and no bound.
std::vector<Pixel> plainPath(const EdgeFeatures& features,
  const PathField& field,
  const std::vector<PathTree::Start>& starts,
  const Pixel& to)
{
  std::vector<double> reached(field.states.size(), std::numeric_limits<double>::infinity());
  std::vector<int> back(field.states.size(), -1);
  std::set<std::pair<double, int>> queue;
  for (const PathTree::Start& start : starts)
  {
    const int i = indexOf(field, start.pixel);
    if (field.states[i] != PathField::Outside && start.cost < reached[i])
    {
      reached[i] = start.cost;
      queue.emplace(start.cost, i);
    }
  }
  while (!queue.empty())
  {
    const auto [cost, p] = *queue.begin();
    queue.erase(queue.begin());
    for (int k = 0; k < 8 && cost == reached[p]; ++k)
    {
      const Pixel at(p % field.width + steps[k][0], p / field.width + steps[k][1]);
      const int q = indexOf(field, at);
      if (q < 0 || field.states[q] == PathField::Outside)
      {
        continue;
      }
      const double next = cost + stepCost(features, field, p, q, k);
      if (next < reached[q])
      {
        reached[q] = next;
        back[q] = p;
        queue.emplace(next, q);
      }
    }
  }
  std::vector<Pixel> path;
  const int end = indexOf(field, to);
  for (int at = end; at >= 0 && !std::isinf(reached[end]); at = back[at])
  {
    path.insert(path.begin(), Pixel(at % field.width, at / field.width));
  }
  return path;
}

} // namespace

// Ties and free steps included, whatever lies between the starts' costs, in the memory of the search before.
TEST(PathSearch, FindsWhatAPlainSearchFinds)
{
  std::mt19937 random(7);
  PathSearch search;
  int joined = 0;
  for (int run = 0; run < 60; ++run)
  {
    const int width = 1 + static_cast<int>(random() % 40), height = 1 + static_cast<int>(random() % 30);
    const EdgeFeatures features = picture(width, height, random);
    PathField field{ 0, 0, width, height, {}, {} };
    const bool dear = run % 3 == 0;
    for (const std::uint8_t edge : features.edges)
    {
      field.states.push_back(random() % 4 == 0 ? PathField::Outside
                             : edge            ? PathField::Edge
                                               : PathField::Plain);
      field.extra.push_back(run % 3 == 1 ? 0.0f : static_cast<float>(random() % 5) * (dear ? 30.0f : 0.1f));
    }
    const auto pixel = [&]
    { return Pixel(static_cast<int>(random() % width), static_cast<int>(random() % height)); };
    std::vector<PathTree::Start> starts;
    starts.reserve(5);
    for (int i = 0; i < 5; ++i)
    {
      starts.push_back({ pixel(), static_cast<double>(random() % 9) * (run % 2 == 0 ? 0.25 : 40.0) });
    }
    std::vector<Pixel> targets{ pixel(), pixel(), pixel(), starts.front().pixel };
    const PathTree tree = search(features, field, starts, targets, Context());
    for (const Pixel& target : targets)
    {
      const std::vector<Pixel> expected = plainPath(features, field, starts, target);
      EXPECT_EQ(tree.pathTo(target), expected);
      joined += expected.empty() ? 0 : 1;
    }
  }
  EXPECT_GT(joined, 60);
}
