// Facts of image-assisted.md, section 5.
#include "Raster/classify.h"
#include "Raster/distance_maps.h"
#include "Stroke/meetings.h"

#include "Harness/drawing_shapes.h"
#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

constexpr double share = 0.05;

std::vector<DrawnStroke> figureSix()
{
  return { closedStroke(ringAt(500, 500, 400)),
    closedStroke(ringAt(350, 500, 120)),
    openStroke({ { 320, 470 }, { 350, 520 }, { 390, 530 } }),
    openStroke({ { 600, 300 }, { 650, 400 }, { 640, 600 } }) };
}

std::vector<int> rolesOf(const Classification& result)
{
  std::vector<int> roles;
  for (const StrokeClass& stroke : result.strokes)
  {
    roles.push_back(static_cast<int>(stroke.role));
  }
  return roles;
}

// The tree by the strokes' own names: of each stroke, its role and the stroke round the region it lies in.
std::set<std::array<int, 3>> treeOf(const Classification& result, const std::vector<int>& names)
{
  std::set<std::array<int, 3>> tree;
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    const StrokeClass& stroke = result.strokes[i];
    const int region = stroke.role == Role::Boundary ? -1 : stroke.region;
    tree.insert(
      { names[i], static_cast<int>(stroke.role), region < 0 ? -1 : names[result.regions[region].stroke] });
  }
  return tree;
}

// Two discs and a bridge of two lines `gap` px apart.
DrawnStroke dumbbell(double gap)
{
  Polyline points;
  const double radius = 150.0, angle = std::asin(0.5 * gap / radius);
  for (int i = 0; i <= 180; ++i)
  {
    const double a = angle + (turn - 2.0 * angle) * i / 180;
    points.emplace_back(250.0 + radius * std::cos(a), 500.0 + radius * std::sin(a));
  }
  for (int i = 0; i <= 180; ++i)
  {
    const double a = 0.5 * turn + angle + (turn - 2.0 * angle) * i / 180;
    points.emplace_back(750.0 + radius * std::cos(a), 500.0 + radius * std::sin(a));
  }
  return closedStroke(points);
}

DrawnStroke figureEight()
{
  Polyline points;
  for (int i = 0; i < 200; ++i)
  {
    const double a = turn * (i + 0.3) / 200;
    points.emplace_back(500.0 + 300.0 * std::sin(a), 500.0 + 200.0 * std::sin(2.0 * a));
  }
  return closedStroke(points);
}

} // namespace

TEST(C5_1, TopologyOfTheSixthFigure)
{
  for (const double s : { share, 0.0 })
  {
    const Classification result = classify(pixelFrame(), figureSix(), s, Context());
    EXPECT_EQ(result.blobs, 7);
    EXPECT_EQ(result.objects, 1);
    EXPECT_EQ(rolesOf(result), (std::vector<int>{ 1, 2, 3, 3 }));
    EXPECT_EQ(result.strokes[2].region, result.strokes[1].childRegion);
    EXPECT_EQ(result.strokes[3].region, result.strokes[0].region);
    EXPECT_EQ(result.regions[0].features, (std::vector<int>{ 1, 3 }));
    EXPECT_EQ(result.labels[pixelFrame().index(0, 0)], 0);
    EXPECT_EQ(result.labels[pixelFrame().index(350, 520)], -3);
  }
  fact("C5_1",
    "closed round closed and open, and an open one: 7 blobs, 1 object, roles 1, 2, 3, 3, published and "
    "amended");
}

TEST(C5_2, OrderAndDirectionDoNotMatter)
{
  std::vector<DrawnStroke> strokes = figureSix();
  strokes.push_back(closedStroke(ringAt(950, 950, 40)));
  strokes.push_back(closedStroke(ringAt(350, 400, 10)));
  strokes.push_back(openStroke({ { 20, 20 }, { 90, 30 } })); // outside
  std::vector<int> names(strokes.size());
  std::iota(names.begin(), names.end(), 0);
  const Classification first = classify(pixelFrame(), strokes, share, Context());
  const auto tree = treeOf(first, names);
  std::mt19937 random(4);
  for (int run = 0; run < 30; ++run)
  {
    std::vector<int> order = names;
    std::shuffle(order.begin(), order.end(), random);
    std::vector<DrawnStroke> other;
    for (const int i : order)
    {
      other.push_back(strokes[i]);
      if (random() % 2)
      {
        std::reverse(other.back().points.begin(), other.back().points.end());
      }
    }
    const Classification result = classify(pixelFrame(), other, run % 2 ? share : 0.0, Context());
    EXPECT_EQ(treeOf(result, order), tree);
    EXPECT_EQ(result.objects, first.objects);
    EXPECT_EQ(result.blobs, first.blobs);
  }
  fact("C5_2", "7 strokes in 30 orders, turned at random: the same roles and tree");
}

TEST(C5_3, NestedCirclesAreAChain)
{
  std::vector<DrawnStroke> strokes;
  for (int k = 0; k < 8; ++k)
  {
    strokes.push_back(closedStroke(ringAt(500, 500, 40.0 + 50.0 * ((3 * k) % 8))));
    const Classification result = classify(pixelFrame(), strokes, share, Context());
    EXPECT_EQ(result.objects, 1);
    std::vector<int> depths;
    for (const Region& region : result.regions)
    {
      depths.push_back(region.depth);
      EXPECT_LE(region.children.size(), 1u);
    }
    std::sort(depths.begin(), depths.end());
    for (int i = 0; i <= k; ++i)
    {
      EXPECT_EQ(depths[i], i);
    }
  }
  fact("C5_3", "1 to 8 nested circles in any order: a chain of that depth, one object");
}

TEST(C5_4, DisjointCirclesAreTwoObjects)
{
  const Classification result = classify(pixelFrame(),
    { closedStroke(ringAt(250, 500, 200)), closedStroke(ringAt(750, 500, 200)) },
    share,
    Context());
  EXPECT_EQ(result.objects, 2);
  EXPECT_EQ(rolesOf(result), (std::vector<int>{ 1, 1 }));
  EXPECT_NE(result.strokes[0].object, result.strokes[1].object);
  fact("C5_4", "two disjoint circles: two objects");
}

TEST(C5_5, ThinLinesDoNotLeak)
{
  int runs = 0;
  for (int x = 0; x < 16; ++x)
  {
    for (int y = 0; y < 16; ++y)
    {
      for (const double radius : { 3.0, 17.3, 40.0 })
      {
        const DrawnStroke circle = closedStroke(ringAt(60 + x / 16.0, 60 + y / 16.0, radius, 90));
        const Classification result = classify(pixelFrame(120, 120), { circle }, 0.0, Context());
        EXPECT_EQ(result.blobs, 3) << x << " " << y << " " << radius;
        EXPECT_EQ(result.strokes[0].role, Role::Boundary);
        ++runs;
      }
    }
  }
  const DrawnStroke diamond = closedStroke({ { 60, 10 }, { 110, 60 }, { 60, 110 }, { 10, 60 } });
  EXPECT_EQ(classify(pixelFrame(120, 120), { diamond }, 0.0, Context()).blobs, 3);
  fact("C5_5", std::to_string(runs) + " circles at all sixteenths of a pixel and a diamond: no leak");
}

TEST(C5_6, ANeckThatMergesIsNoFault)
{
  const std::vector<DrawnStroke> strokes{ dumbbell(0.8) };
  const Classification amended = classify(pixelFrame(), strokes, share, Context());
  EXPECT_EQ(amended.strokes[0].role, Role::Boundary);
  EXPECT_EQ(amended.objects, 1);
  EXPECT_EQ(amended.regions.size(), 1u); // one disc: with its back, chi 2
  EXPECT_EQ(amended.strokes[0].contacts.size(), 3u);
  const Classification published = classify(pixelFrame(), strokes, 0.0, Context());
  EXPECT_EQ(published.strokes[0].role, Role::Rejected);
  EXPECT_EQ(published.strokes[0].rejection, Rejection::Areas);
  EXPECT_NE(rejectionText(published, 0, strokes).text().find("Stroke 0 touches 3 areas"), std::string::npos);
  fact("C5_6",
    "a dumbbell whose neck merges touches 3 blobs: role 1, one object of one region; as published rejected");
}

TEST(C5_7, AFigureEightIsNamed)
{
  for (const double s : { share, 0.0 })
  {
    const std::vector<DrawnStroke> strokes{ closedStroke(ringAt(500, 500, 450)), figureEight() };
    const Classification result = classify(pixelFrame(), strokes, s, Context());
    EXPECT_EQ(result.strokes[1].role, Role::Rejected);
    EXPECT_EQ(result.strokes[1].rejection, Rejection::CrossesItself);
    EXPECT_EQ(result.strokes[0].role, Role::Boundary);
    EXPECT_EQ(rejectionText(result, 1, strokes).text().rfind("Stroke 1 crosses itself near (5", 0), 0u);
    EXPECT_EQ(rejectionText(result, 0, strokes), "");
  }
  fact("C5_7", "a figure eight: role -1, \"stroke 1 crosses itself near (500, 500)\"");
}

TEST(Classify, HostileStrokesAreRejectedByName)
{
  const Polyline outer = ringAt(500, 500, 300);
  const std::vector<DrawnStroke> strokes{ closedStroke(outer),
    closedStroke(outer),
    openStroke({ { 5, 5 } }),
    openStroke({ { 9, 9 }, { 9, 9 } }),
    openStroke({ { 0, std::nan("") }, { 9, 9 } }),
    closedStroke(ringAt(1000, 1000, 60)),
    closedStroke(ringAt(900, 100, 1)),
    openStroke({ { 850, 200 }, { 900, 210 } }),
    closedStroke({ { 100, 100 }, { 150, 100 } }),
    openStroke({ { 480, 480 }, { 520, 520 }, { 500, 500 } }),
    closedStroke({}) };
  const Classification result = classify(pixelFrame(), strokes, share, Context());
  const std::vector<Rejection> expected{ Rejection::Crosses,
    Rejection::Crosses,
    Rejection::TooShort,
    Rejection::TooShort,
    Rejection::OffCanvas,
    Rejection::OffCanvas,
    Rejection::TooSmall,
    Rejection::Outside,
    Rejection::TooShort,
    Rejection::CrossesItself,
    Rejection::TooShort };
  for (std::size_t i = 0; i < strokes.size(); ++i)
  {
    EXPECT_EQ(result.strokes[i].rejection, expected[i]) << i;
    EXPECT_EQ(result.strokes[i].role, Role::Rejected) << i;
    EXPECT_EQ(rejectionText(result, static_cast<int>(i), strokes)
                .text()
                .rfind("Stroke " + std::to_string(i) + " ", 0),
      0u);
  }
  EXPECT_EQ(result.objects, 0);
  EXPECT_EQ(classify(pixelFrame(), {}, share, Context()).blobs, 1);
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(classify(pixelFrame(), strokes, share, cancelled), Error);
}

TEST(Classify, TheFrameFitsTheCanvas)
{
  for (const double scale : { 1.0, 1e-6, 5e6 })
  {
    const Canvas canvas{ Vector2(scale, -3.0 * scale), Vector2(2.0 * scale, scale) };
    const Frame frame = frameOf(canvas);
    EXPECT_EQ(frame.width, 1028);
    EXPECT_EQ(frame.height, 516);
    const Polyline corners{ canvas.corner, canvas.corner + canvas.size };
    const Polyline places = onRaster(frame, corners);
    ASSERT_EQ(places.size(), 2u) << scale;
    EXPECT_NEAR(frame.toPixels(corners[0])[0], 1.5, 1e-6);
    EXPECT_NEAR((frame.toWorld(frame.toPixels(corners[1])) - corners[1]).norm() / scale, 0.0, 1e-12);
    EXPECT_TRUE(onRaster(frame, { canvas.corner - 0.01 * canvas.size }).empty());
  }
  EXPECT_THROW(frameOf({ Vector2::Zero(), Vector2(1.0, 0.0) }), Error);
  EXPECT_THROW(frameOf({}, 8), Error);
}
