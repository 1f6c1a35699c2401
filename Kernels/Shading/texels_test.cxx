// The disc as a picture, areas on it, and layers as a text says them.
#include "Shading/texels.h"

#include "Harness/patches.h"
#include "Harness/threads.h"
#include "Mesh/context.h"
#include "Shading/fields.h"
#include "Shading/flatten.h"
#include "Shading/layer_list.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

std::string refusal(const std::string& text)
{
  try
  {
    layerList(text);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    return error.what();
  }
  return {};
}

} // namespace

TEST(Texels, ALinearFunctionIsItselfOnEveryTexelOfTheDisc)
{
  const Mesh patch = cap(4, 0.3);
  const std::vector<Vector2> disc = flattened(patch, {});
  std::vector<double> values;
  values.reserve(disc.size());
  for (const Vector2& p : disc)
    values.push_back(3.0 + p[0] - 2.0 * p[1]);
  const int size = 128;
  const std::vector<double> texels = onTexels(disc, patch.triangles, values, size, -9.0, {});
  EXPECT_EQ(texels, onTexels(disc, patch.triangles, values, size, -9.0, twoThreads()));
  int within = 0;
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
    {
      const Vector2 p = discPlace(i, j, size);
      const double value = texels[static_cast<std::size_t>(j) * size + i];
      if (value != -9.0)
      {
        ++within;
        EXPECT_NEAR(value, 3.0 + p[0] - 2.0 * p[1], 1e-7);
        EXPECT_LE(p.norm(), 1.01);
      }
      else
      {
        EXPECT_GT(p.norm(), 0.97) << "no hole inside";
      }
    }
  EXPECT_NEAR(within, 0.25 * pi * size * size, 0.01 * size * size);
}

TEST(Texels, BilinearValuesOfPlaces)
{
  const std::vector<double> image{ 0.0, 1.0, 2.0, 10.0, 11.0, 12.0 }; // 3 x 2
  const auto at = [&](double u, double v)
  {
    const TexelMix mix = texelsRound({ u, v }, 3, 2);
    return mix.of(std::array<double, 4>{
      image[mix.texels[0]], image[mix.texels[1]], image[mix.texels[2]], image[mix.texels[3]] });
  };
  EXPECT_EQ(at(0.5, 0.25), 1.0);
  EXPECT_DOUBLE_EQ(at(1.0 / 3.0, 0.25), 0.5);
  EXPECT_DOUBLE_EQ(at(0.5, 0.5), 6.0);
  EXPECT_EQ(at(0.0, 0.0), 0.0); // beyond the outermost centres they hold
  EXPECT_EQ(at(1.0, 1.0), 12.0);
  EXPECT_EQ(at(-5.0, 7.0), 10.0);
  const TexelMix one = texelsRound({ 0.7, 0.2 }, 1, 1);
  EXPECT_EQ(one.texels, (std::array<std::size_t, 4>{}));
}

TEST(AreaMask, BlendsInwardsFromItsBorder)
{
  // A disc of 40 texels' radius in the middle.
  const int size = 128;
  std::vector<char> selected(static_cast<std::size_t>(size) * size, 0);
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
      selected[static_cast<std::size_t>(j) * size + i] = std::hypot(i - 63.5, j - 63.5) < 40.0;
  const double feather = 0.125; // 8 texels
  const AreaMask mask(selected, size, feather, {}), hard(selected, size, 0.0, {});
  double last = 1.0;
  for (double r = 0.0; r < 50.0; r += 0.1)
  {
    const Vector2 uv(0.5 + r / size, 0.5);
    const double t = std::clamp((40.0 - r) / 8.0, 0.0, 1.0), share = mask.share(uv);
    EXPECT_NEAR(share, t * t * (3.0 - 2.0 * t), 0.2) << r;
    EXPECT_LE(share, last + 1e-12);
    EXPECT_LE(last - share, 0.05) << "no step at " << r;
    last = share;
    EXPECT_EQ(hard.share(uv), hard.selects(uv) ? 1.0 : 0.0);
    if (r > 41.0)
    {
      EXPECT_EQ(share, 0.0);
    }
    if (r < 31.0)
    {
      EXPECT_EQ(share, 1.0);
    }
  }
  const AreaMask two(selected, size, feather, twoThreads());
  EXPECT_EQ(two.share({ 0.77, 0.5 }), mask.share({ 0.77, 0.5 }));
  // One texel, and all of them.
  std::vector<char> one(static_cast<std::size_t>(size) * size, 0);
  one[64 * size + 64] = 1;
  EXPECT_GT(AreaMask(one, size, 0.01, {}).share({ 64.5 / size, 64.5 / size }), 0.0);
  const AreaMask all(std::vector<char>(one.size(), 1), size, 1.0, {});
  EXPECT_GT(all.share({ 0.5, 0.5 }), 0.999);
  EXPECT_LT(all.share({ 0.0, 0.5 }), 0.01);
}

TEST(AreaMask, DepthsAreTheExactDistances)
{
  // Against every pair, of random blots; a share tells a depth where the feather is wide.
  std::mt19937 random(3);
  const int size = 32;
  std::vector<char> selected(static_cast<std::size_t>(size) * size, 0);
  for (char& each : selected)
    each = random() % 12 != 0;
  const double feather = 1.0; // 16 texels
  const AreaMask mask(selected, size, feather, {});
  for (int j = 0; j < size; ++j)
    for (int i = 0; i < size; ++i)
    {
      double least = 1e9;
      for (int y = -1; y <= size; ++y)
        for (int x = -1; x <= size; ++x)
          if (x < 0 || y < 0 || x == size || y == size || !selected[static_cast<std::size_t>(y) * size + x])
            least = std::min(least, std::hypot(x - i, y - j));
      const double t = std::clamp((least - 0.5) / 16.0, 0.0, 1.0);
      EXPECT_NEAR(mask.share({ (i + 0.5) / size, (j + 0.5) / size }), t * t * (3.0 - 2.0 * t), 1e-6);
    }
}

TEST(LayerList, HandlesThenAreas)
{
  const LayerList list = layerList(" handle 0.4 0.2;; handle 0.7 1e-1 ;area 2 9; handle .3 -2\n; area 0;");
  ASSERT_EQ(list.handles.size(), 2u);
  EXPECT_EQ(list.handles[0].rest, 0.4);
  EXPECT_EQ(list.handles[1].place, 0.1);
  ASSERT_EQ(list.areas.size(), 2u);
  EXPECT_EQ(list.areas[0].area, 2);
  EXPECT_EQ(list.areas[0].levels, 9);
  ASSERT_EQ(list.areas[0].handles.size(), 1u);
  EXPECT_EQ(list.areas[0].handles[0].place, -2.0);
  EXPECT_EQ(list.areas[1].levels, 0);
  EXPECT_TRUE(list.areas[1].handles.empty());
  EXPECT_EQ(layerText(list), "handle 0.4 0.2; handle 0.7 0.1; area 2 9; handle 0.3 -2; area 0");
  const double third = 1.0 / 3.0; // to the bit
  EXPECT_EQ(layerList(layerText({ { { third, third } }, {} })).handles.at(0).place, third);
  EXPECT_TRUE(layerList("").handles.empty());
  EXPECT_TRUE(layerList(" ; ;").areas.empty());
}

TEST(LayerList, QuotesWhatIsNotUnderstood)
{
  for (const char* text : { "handle 0.4",
         "handle 0.4 0.2 0.1",
         "handle a b",
         "handle 0.4, 0.2",
         "area",
         "area x",
         "area 1 2 3",
         "area 0.5",
         "area 0 0",
         "area 0 -3",
         "level 3",
         "handle 0.4 0.2x" })
    EXPECT_NE(refusal(text).find("Layers says \"" + std::string(text) + "\""), std::string::npos) << text;
  EXPECT_NE(refusal("area 1; area 0; area 1 5").find("area 1 twice"), std::string::npos);
}

TEST(Sides, LeftIsLeftRoundEveryBend)
{
  // A hook round the pole of a sphere, counter-clockwise seen from outside: the pole is on its left, beside
  // all of it.
  const Drawn drawn = hook();
  const Adjacency adjacency = buildAdjacency(drawn.patch);
  const std::vector<signed char> side = chainSides(drawn.patch, adjacency, drawn.reference);
  const std::vector<int> back(drawn.reference.rbegin(), drawn.reference.rend());
  const std::vector<signed char> other = chainSides(drawn.patch, adjacency, back);
  int counted = 0;
  for (int ring = 1; ring <= 50; ++ring)
    for (int sector = 2; sector <= 148; ++sector)
    {
      const int v = 1 + (ring - 1) * 200 + sector;
      if (ring == 25)
      {
        EXPECT_EQ(side[v], 0);
      }
      else if (ring > 12 && std::min(sector, 150 - sector) > std::abs(ring - 25))
      {
        // Nearer to the curve beside it than round an end.
        EXPECT_EQ(side[v], ring < 25 ? 1 : -1) << ring << ", " << sector;
        EXPECT_EQ(other[v], -side[v]);
        ++counted;
      }
    }
  EXPECT_GT(counted, 3000);
  for (int v = 0; v < drawn.patch.vertexCount(); ++v)
    EXPECT_EQ(side[v] == 0, std::count(drawn.reference.begin(), drawn.reference.end(), v) == 1);
}

TEST(Shading, PaintsWhatItWeighs)
{
  const Mesh patch = cap(4, 0.3);
  const std::vector<Vector2> disc = flattened(patch, {});
  std::vector<double> shares;
  shares.reserve(disc.size());
  for (const Vector2& p : disc)
    shares.push_back(std::min(p.norm(), 1.0));
  const std::vector<char> inside(disc.size(), 1);
  const int size = 128;
  const ShadedPlaces places = shadedPlaces(disc, patch.triangles, shares, inside, size, {});
  const std::vector<double> exact = onTexels(disc, patch.triangles, shares, size, -1.0, {});
  // The right half has layers of its own, without a feather.
  std::vector<char> selected;
  selected.reserve(size * size);
  for (int i = 0; i < size * size; ++i)
    selected.push_back(i % size >= size / 2);
  const AreaShares half = areaShares(AreaMask(selected, size, 0.0, {}), places, {});
  const Layers whole(5, { { 0.4, 0.3 } }), own(9, { { 0.5, 0.7 } });
  for (const Falloff falloff : { Falloff::Smooth, Falloff::Linear })
  {
    const std::vector<ShadedArea> areas{ { own, &half } };
    const Shading shading(whole, areas, falloff);
    std::vector<float> weights(selected.size(), -1.0f), again = weights;
    std::vector<unsigned char> greys(selected.size(), 7), greysAgain = greys;
    shading.paint(places, weights.data(), greys.data(), {});
    shading.paint(places, again.data(), greysAgain.data(), twoThreads());
    EXPECT_EQ(weights, again);
    EXPECT_EQ(greys, greysAgain);
    int off = 0;
    for (std::size_t i = 0; i < selected.size(); ++i)
    {
      if (exact[i] < 0.0)
      {
        EXPECT_EQ(weights[i], -1.0f);
        EXPECT_EQ(greys[i], 7);
        continue;
      }
      const Layers& layers = selected[i] ? own : whole;
      EXPECT_NEAR(weights[i], layers.weight(exact[i], falloff), 3e-4);
      off += greys[i] != layers.grey(layers.level(exact[i]));
    }
    EXPECT_LE(off, 5) << "texels within 1 / 8192 of a boundary";
    const std::vector<double> values = shading.weights(places, {});
    EXPECT_EQ(values, shading.weights(places, twoThreads()));
    for (std::size_t v = 0; v < values.size(); ++v)
      EXPECT_EQ(values[v], (half.selects[v] ? own : whole).weight(shares[v], falloff));
  }
}
