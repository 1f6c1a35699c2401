// Facts of editors.md, section 13, handles, and what of its texture's facts is of layers alone.
#include "Shading/layers.h"

#include "Harness/shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <random>

using namespace oversketch;
using oversketch_test::fact;

namespace
{

void expectBoundaries(const std::vector<LayerHandle>& handles, const std::vector<double>& expected)
{
  const std::vector<double> boundaries = Layers(5, handles).boundaries();
  ASSERT_EQ(boundaries.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
  {
    EXPECT_NEAR(boundaries[i], expected[i], 5e-7) << i;
  }
}

// Levels of some width.
int visible(const Layers& layers)
{
  std::vector<double> all{ 0.0 };
  all.insert(all.end(), layers.boundaries().begin(), layers.boundaries().end());
  all.push_back(1.0);
  int count = 0;
  for (std::size_t i = 1; i < all.size(); ++i)
  {
    EXPECT_LE(all[i - 1], all[i]);
    count += all[i] > all[i - 1];
  }
  return count;
}

} // namespace

TEST(B7_1, OneHandleMovesAllLayers)
{
  expectBoundaries({ { 0.4, 0.2 } }, { 0.1, 0.2, 0.466667, 0.733333 });
  fact("B7_1", "a handle at 0.4 dragged to 0.2: boundaries 0.1, 0.2, 0.466667, 0.733333");
}

TEST(B7_2, LayersVanishAndComeBack)
{
  expectBoundaries({ { 0.4, 0.0 } }, { 0.0, 0.0, 0.333333, 0.666667 });
  for (const double beyond : { 0.0, -0.7 })
  {
    const Layers gone(5, { { 0.4, beyond } });
    EXPECT_EQ(visible(gone), 3);
    EXPECT_NEAR(gone.weight(0.0, Falloff::Linear), 0.6, 1e-15);
    EXPECT_NEAR(gone.weight(0.0, Falloff::Smooth), 0.68256, 1e-15);
    EXPECT_EQ(gone.weight(1.0), 0.0);
    EXPECT_EQ(gone.level(0.0), 2); // the later level
  }
  const Layers plain(5), back(5, { { 0.4, 0.4 } });
  EXPECT_EQ(plain.boundaries(), back.boundaries());
  for (int i = 0; i <= 1000; ++i)
  {
    const double s = i / 1000.0;
    EXPECT_EQ(plain.weight(s), back.weight(s));
    EXPECT_EQ(back.restOf(s), s);
  }
  // To the far end: black, but for what is on it.
  const Layers out(5, { { 0.4, 2.0 } });
  EXPECT_EQ(visible(out), 2);
  EXPECT_EQ(out.weight(1.0), 0.0);
  EXPECT_NEAR(out.weight(1.0 - 1e-9, Falloff::Linear), 0.6, 1e-8);
  fact("B7_2",
    "dragged to 0 and beyond: boundaries 0, 0, 1/3, 2/3, weight at the curve 0.6, smooth 0.648; back at 0.4: "
    "boundaries and weights to the bit");
}

TEST(B7_3, OnlyWhatIsBetweenNeighboursMoves)
{
  const auto places = [](int which, double to)
  {
    std::vector<LayerHandle> handles{ { 0.2, 0.2 }, { 0.4, 0.4 }, { 0.8, 0.8 } };
    handles = grasped(handles, which);
    handles.back().place = to;
    return handles;
  };
  expectBoundaries(places(1, 0.5), { 0.2, 0.5, 0.65, 0.8 });
  expectBoundaries(places(2, 0.9), { 0.2, 0.4, 0.65, 0.9 });
  // Past its neighbours it is held at them.
  expectBoundaries(places(1, 0.95), { 0.2, 0.8, 0.8, 0.8 });
  expectBoundaries(places(1, -3.0), { 0.2, 0.2, 0.5, 0.8 });
  EXPECT_EQ(Layers(5, places(1, 0.95)).held().back().place, 0.8);
  fact("B7_3",
    "handles at 0.2, 0.4, 0.8: the middle one to 0.5 gives 0.2, 0.5, 0.65, 0.8, the outer to 0.9 gives 0.2, "
    "0.4, 0.65, 0.9");
}

TEST(B6_3, ThreeAndNineLevelsWeighAlike)
{
  double worst = 0.0;
  const Layers five(5), nine(9);
  bool otherGrey = false;
  for (int i = 0; i <= 1000; ++i)
  {
    const double s = i / 1000.0;
    for (const Falloff falloff : { Falloff::Smooth, Falloff::Linear })
    {
      worst = std::max(worst, std::abs(five.weight(s, falloff) - nine.weight(s, falloff)));
    }
    otherGrey = otherGrey || five.grey(five.level(s)) != nine.grey(nine.level(s));
  }
  EXPECT_LT(worst, 1e-12);
  EXPECT_TRUE(otherGrey);
  const std::vector<int> greys{ 255, 191, 128, 64, 0 };
  for (int level = 0; level < 5; ++level)
  {
    EXPECT_EQ(five.grey(level), greys[level]);
    EXPECT_EQ(five.level((level + 0.5) / 5.0), level);
  }
  EXPECT_EQ(five.grey(five.level(0.5)), 128);
  fact("B6_3", "5 and 9 levels: the same weights, other greys; those of five 255, 191, 128, 64, 0");
}

// Any drags: boundaries ascend, no level is added, weights fall from the curve to the boundary without a leap
// but where layers have vanished, and the smooth ones have no kink.
TEST(Layers, RandomDrags)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> value(0.0, 1.0);
  for (int round = 0; round < 500; ++round)
  {
    std::vector<LayerHandle> handles;
    for (int k = 0; k < 4; ++k)
    {
      const double rest = 0.01 + 0.98 * value(random);
      const auto near = [&](const LayerHandle& h) { return std::abs(h.rest - rest) < 0.01; };
      if (std::none_of(handles.begin(), handles.end(), near))
      {
        handles.push_back({ rest, rest });
      }
    }
    for (int drag = 0; drag < 6; ++drag)
    {
      handles = grasped(handles, static_cast<int>(random() % handles.size()));
      handles.back().place = 1.6 * value(random) - 0.3;
      const Layers layers(2 + static_cast<int>(random() % 9), handles);
      EXPECT_LE(visible(layers), static_cast<int>(layers.boundaries().size()) + 1);
      double before = 1.0, beforeLinear = 1.0;
      for (int i = 0; i <= 500; ++i)
      {
        const double s = i / 500.0, w = layers.weight(s), linear = layers.weight(s, Falloff::Linear);
        EXPECT_LE(w, before + 1e-15);
        EXPECT_LE(linear, beforeLinear + 1e-15);
        EXPECT_GE(linear, 0.0);
        before = w;
        beforeLinear = linear;
      }
      EXPECT_EQ(layers.weight(1.0), 0.0);
      for (double rest = 0.0; rest <= 1.0; rest += 0.05)
      {
        // phi^-1 phi is the identity where no layer has vanished.
        const double s = layers.placeOf(rest);
        const bool gone = std::any_of(handles.begin(),
          handles.end(),
          [&](const LayerHandle& h) { return std::abs(layers.placeOf(h.rest) - s) < 1e-9; });
        if (!gone && s > 1e-9 && s < 1.0 - 1e-9)
        {
          EXPECT_NEAR(layers.restOf(s), rest, 1e-9);
        }
      }
    }
  }
}

TEST(Layers, NoKinkAtAHandle)
{
  const Layers layers(5, { { 0.4, 0.6 } });
  const auto jump = [&](Falloff falloff)
  {
    const double h = 1e-6;
    return std::abs(layers.weight(0.6 + h, falloff) - 2.0 * layers.weight(0.6, falloff) +
                    layers.weight(0.6 - h, falloff)) /
           h;
  };
  EXPECT_LT(jump(Falloff::Smooth), 1e-4);
  EXPECT_GT(jump(Falloff::Linear), 0.5);
  EXPECT_NEAR(layers.weight(0.6, Falloff::Linear), 0.6, 1e-15); // still where it was placed
}

TEST(Layers, WhatCannotBeIsSaid)
{
  const auto refused = [](int levels, const std::vector<LayerHandle>& handles)
  {
    try
    {
      Layers layers(levels, handles);
      return false;
    }
    catch (const Error& error)
    {
      return error.failure() == Failure::BadStroke;
    }
  };
  EXPECT_TRUE(refused(1, {}));
  EXPECT_TRUE(refused(257, {}));
  EXPECT_TRUE(refused(5, { { 0.0, 0.2 } }));
  EXPECT_TRUE(refused(5, { { 1.0, 0.2 } }));
  EXPECT_TRUE(refused(5, { { 0.4, 0.4 }, { 0.4005, 0.5 } }));
  EXPECT_TRUE(refused(5, { { std::nan(""), 0.4 } }));
  EXPECT_TRUE(refused(5, { { 0.4, std::nan("") } }));
  EXPECT_FALSE(refused(2, { { 0.4, 0.4 }, { 0.402, 0.5 } }));
}
