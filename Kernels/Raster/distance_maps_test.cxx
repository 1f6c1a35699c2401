// Facts of image-assisted.md, section 11.
#include "Raster/distance_maps.h"

#include "Harness/drawing_shapes.h"
#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

Polyline boxAt(double x0, double y0, double x1, double y1)
{
  Polyline points;
  const std::array<Vector2, 4> corners{ Vector2(x0, y0), Vector2(x1, y0), Vector2(x1, y1), Vector2(x0, y1) };
  for (int side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 40; ++i)
    {
      points.push_back(corners[side] + (corners[(side + 1) % 4] - corners[side]) * i / 40.0);
    }
  }
  return points;
}

double greatest(const std::vector<float>& values)
{
  return *std::max_element(values.begin(), values.end());
}

} // namespace

TEST(C11_1, ADiscsDistanceSkeletonAndThickness)
{
  double over = -1e9, under = 1e9, off = 0.0, least = 1e9, most = -1e9;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> shift(-0.5, 0.5);
  for (const double radius : { 50.0, 77.7, 120.0, 200.0, 300.4, 410.0 })
  {
    for (int run = 0; run < 4; ++run)
    {
      const Vector2 centre(514.0 + shift(random), 514.0 + shift(random));
      const DistanceMaps maps = distanceMaps(
        pixelFrame(), { { ringAt(centre[0], centre[1], radius, 720), 0 } }, ThicknessMode::Local, Context());
      over = std::max(over, greatest(maps.distance) - radius);
      under = std::min(under, greatest(maps.distance) - radius);
      for (int y = 0; y < maps.frame.height; ++y)
      {
        for (int x = 0; x < maps.frame.width; ++x)
        {
          const std::size_t at = maps.frame.index(x, y);
          if (maps.skeleton[at])
          {
            off = std::max(off, (Vector2(x, y) - centre).norm());
          }
          if (maps.distance[at] > 0.0f)
          {
            least = std::min(least, maps.thickness[at] - radius);
            most = std::max(most, maps.thickness[at] - radius);
          }
        }
      }
    }
  }
  EXPECT_LE(over, 0.0);
  EXPECT_GE(under, -1.5);
  EXPECT_LE(off, 2.0);
  EXPECT_GE(least, -3.0);
  EXPECT_LE(most, 0.0);
  fact("C11_1",
    "24 discs of 50 to 410 px: greatest T " + digits(under) + " to " + digits(over) +
      " px off R, skeleton within " + digits(off) + " px of the centre, D " + digits(least) + " to " +
      digits(most) + " off R");
}

TEST(C11_2, ARectanglesSkeletonHas549Pixels)
{
  const double x0 = 300.0, y0 = 400.0, width = 400.0, height = 160.0;
  const DistanceMaps maps = distanceMaps(
    pixelFrame(), { { boxAt(x0, y0, x0 + width, y0 + height), 0 } }, ThicknessMode::Local, Context());
  int ridge = 0, plateau = 0, compared = 0;
  double worst = 0.0;
  for (int y = 401; y < 560; ++y)
  {
    for (int x = 301; x < 700; ++x)
    {
      const std::size_t at = maps.frame.index(x, y);
      ridge += maps.skeleton[at];
      plateau += maps.skeleton[at] && y == 480 && x >= 380 && x <= 620;
      const double u = x - x0, v = y - y0;
      const double left = u, right = width - u, low = v, high = height - v;
      const double t = std::min({ left, right, low, high });
      EXPECT_EQ(maps.distance[at], t);
      if (t > 3.0)
      {
        // The foot lies on the nearest side, as far from its ends as this.
        const double along =
          std::min(low, high) <= std::min(left, right) ? std::min(left, right) : std::min(low, high);
        const double expected = std::min(along, 80.0);
        worst = std::max(worst, std::abs(maps.thickness[at] - expected));
        ++compared;
      }
    }
  }
  EXPECT_EQ(ridge, 549);
  EXPECT_EQ(plateau, 241);
  EXPECT_EQ(worst, 0.0);
  EXPECT_EQ(std::count(maps.skeleton.begin(), maps.skeleton.end(), 1), 549);
  fact("C11_2",
    "400 x 160 px: 549 skeleton pixels, 241 of them the plateau; D exact at all " + std::to_string(compared) +
      " samples more than 3 px inside");
}

TEST(C11_3, AnAnnulusIsHalfAsThickAsItsWidth)
{
  const DistanceMaps maps = distanceMaps(pixelFrame(),
    { { ringAt(514, 514, 200), 0 }, { ringAt(514, 514, 100), 0 } },
    ThicknessMode::Local,
    Context());
  EXPECT_GE(greatest(maps.distance), 49.0);
  EXPECT_LE(greatest(maps.distance), 51.0);
  EXPECT_EQ(maps.distance[maps.frame.index(514, 514)], 0.0f);
  EXPECT_EQ(maps.object[maps.frame.index(514, 514)], -1);
  EXPECT_EQ(maps.object[maps.frame.index(514 + 150, 514)], 0);
  fact("C11_3", "annulus 200 / 100: greatest T " + digits(greatest(maps.distance), 5) + " px");
}

TEST(C11_4, OnlyHolesChangeTheDistance)
{
  const Frame frame = pixelFrame();
  std::vector<DrawnStroke> strokes{ closedStroke(ringAt(514, 514, 400)) };
  const auto mapsOf = [&](const std::vector<Treatment>& treatments)
  {
    const Classification roles = classify(frame, strokes, 0.05, Context());
    return distanceMaps(frame, rimsOf(roles, strokes, treatments), ThicknessMode::Local, Context());
  };
  const DistanceMaps plain = mapsOf({ Treatment::Fill });
  strokes.push_back(closedStroke(ringAt(450, 514, 120)));
  strokes.push_back(closedStroke(ringAt(450, 514, 40)));
  strokes.push_back(openStroke({ { 700, 500 }, { 760, 620 } }));
  using List = std::vector<Treatment>;
  const Treatment fill = Treatment::Fill, hole = Treatment::Hole, tunnel = Treatment::Tunnel;
  EXPECT_EQ(mapsOf(List{ fill, fill, fill, fill }).distance, plain.distance);
  EXPECT_EQ(mapsOf(List{ fill, tunnel, fill, fill }).distance, plain.distance);
  EXPECT_EQ(mapsOf(List{ hole, fill, fill, hole }).distance, plain.distance); // of no closed feature
  const DistanceMaps holed = mapsOf(List{ fill, hole, fill, fill });
  EXPECT_NE(holed.distance, plain.distance);
  EXPECT_EQ(holed.distance[frame.index(450, 514 + 80)], 0.0f);
  // What lies in a hole is an island, but for a hole's own.
  EXPECT_NEAR(holed.distance[frame.index(450, 514)], 40.0, 1.0);
  DistanceMaps bare = mapsOf(List{ fill, hole, hole, fill });
  EXPECT_EQ(bare.distance[frame.index(450, 514)], 0.0f);
  for (std::size_t i = 0; i < bare.distance.size(); ++i)
  {
    const int x = static_cast<int>(i) % frame.width - 450, y = static_cast<int>(i) / frame.width - 514;
    bare.distance[i] = x * x + y * y < 60 * 60 ? holed.distance[i] : bare.distance[i];
  }
  EXPECT_EQ(bare.distance, holed.distance);
  fact("C11_4",
    "features, tunnels: T the same to the bit; a hole changes it, an island in it nothing round the hole");
}

TEST(Distance, IsThatOfEveryPairOfPixels)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> wobble(0.55, 1.0), place(0.0, 1.0);
  for (int run = 0; run < 20; ++run)
  {
    const Frame frame = pixelFrame(90, 70);
    Polyline points = ringAt(45, 35, 30, 40);
    for (Vector2& p : points)
    {
      p = Vector2(45, 35) + wobble(random) * (p - Vector2(45, 35));
    }
    const std::vector<Rim> rims{ { points, 0 }, { ringAt(5 + 3 * place(random), 60, 4), 1 } };
    const DistanceMaps maps = distanceMaps(frame, rims, ThicknessMode::Local, Context());
    std::vector<Place> black;
    for (const Rim& rim : rims)
    {
      const std::vector<Place> line = linePixels(onRaster(frame, rim.points), true);
      black.insert(black.end(), line.begin(), line.end());
    }
    for (int y = 0; y < frame.height; ++y)
    {
      for (int x = 0; x < frame.width; ++x)
      {
        const std::size_t at = frame.index(x, y);
        int least = 1 << 30;
        for (const Place& p : black)
        {
          least = std::min(least, (p[0] - x) * (p[0] - x) + (p[1] - y) * (p[1] - y));
        }
        const double expected = maps.object[at] < 0 ? 0.0 : std::sqrt(static_cast<float>(least));
        EXPECT_NEAR(maps.distance[at], expected, 1e-5) << run << " " << x << " " << y;
        EXPECT_GE(maps.thickness[at], maps.distance[at]);
      }
    }
    const DistanceMaps again = distanceMaps(frame, rims, ThicknessMode::Local, twoThreads());
    EXPECT_EQ(again.distance, maps.distance);
    EXPECT_EQ(again.thickness, maps.thickness);
    EXPECT_EQ(again.skeleton, maps.skeleton);
    const DistanceMaps global = distanceMaps(frame, rims, ThicknessMode::Global, Context());
    for (std::size_t i = 0; i < frame.count(); ++i)
    {
      EXPECT_GE(global.thickness[i], maps.thickness[i]);
    }
  }
}

TEST(Distance, RefusesWhatLeavesTheCanvas)
{
  const Frame frame = pixelFrame(90, 70);
  EXPECT_THROW(distanceMaps(frame, { { ringAt(80, 35, 30), 0 } }, ThicknessMode::Local, Context()), Error);
  EXPECT_THROW(
    distanceMaps(frame, { { { { 5, 5 }, { 9, 9 } }, 0 } }, ThicknessMode::Local, Context()), Error);
  EXPECT_EQ(greatest(distanceMaps(frame, {}, ThicknessMode::Local, Context()).distance), 0.0);
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(distanceMaps(frame, { { ringAt(45, 35, 30), 0 } }, ThicknessMode::Local, cancelled), Error);
}
