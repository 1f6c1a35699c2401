#include "Harness/shapes.h"
#include "Silhouette/effect.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A model unit is a pixel, and the origin the middle of the picture, (400, 300).
const View effectView = orthographicView(Vector3(0, 0, 1), Vector3(0, 1, 0), 1.0);

// A disk of radius 100 px round a place.
void addDisk(Mesh& mesh, double x)
{
  constexpr int corners = 2000;
  const int middle = mesh.vertexCount();
  mesh.points.emplace_back(x, 0, 0);
  for (int i = 0; i < corners; ++i)
  {
    const double a = 2.0 * pi * i / corners;
    mesh.points.emplace_back(x + 100.0 * std::cos(a), 100.0 * std::sin(a), 0.0);
    mesh.triangles.push_back({ middle, middle + i + 1, middle + (i + 1) % corners + 1 });
  }
}

Polyline arcOver(double x, double radius, double from, double to)
{
  Polyline arc;
  for (int i = 0; i <= 400; ++i)
  {
    const double a = from + (to - from) * i / 400;
    arc.push_back(Vector2(400 + x + radius * std::cos(a), 300 + radius * std::sin(a)));
  }
  return arc;
}

// A square of 200 px with a vertex every 10.
constexpr int rows = 21;

Mesh square()
{
  return gridSurface(rows - 1,
    rows - 1,
    false,
    false,
    [](double u, double v) { return Vector3(200.0 * u - 100.0, 200.0 * v - 100.0, 0.0); });
}

const Polyline alongTheTop{ Vector2(290, 400), Vector2(400, 400), Vector2(510, 400) };

StrokeEffect effectOf(const Mesh& before, const Mesh& after, const std::vector<char>& region)
{
  StrokeEffect effect;
  measureMovement(before, after, region, effectView, alongTheTop, alongTheTop, effect);
  return effect;
}

// The square with all that lies in a strip of y moved by so much.
Mesh moved(const Mesh& mesh, double from, double to, const Vector3& by)
{
  Mesh result = mesh;
  for (Vector3& p : result.points)
  {
    p += p[1] >= from && p[1] <= to ? by : Vector3(0, 0, 0);
  }
  return result;
}

} // namespace

TEST(StrokeEffect, OutlineIsComparedWithTheStrokeOnTheWayBack)
{
  Mesh disk;
  addDisk(disk, 0.0);
  for (const double radius : { 100.0, 110.0, 90.0 })
  {
    EXPECT_NEAR(
      outlineBack({ disk, effectView, arcOver(0.0, radius, 0.0, pi) }), std::abs(radius - 100.0), 0.05);
    EXPECT_NEAR(
      outlineBack({ disk, effectView, arcOver(0.0, radius, pi, 0.0) }), std::abs(radius - 100.0), 0.05);
    EXPECT_NEAR(outlineBack({ disk, effectView, arcOver(0.0, radius, 1.5 * pi, 2.5 * pi) }),
      std::abs(radius - 100.0),
      0.05);
  }
  // Farther off than the picture that is looked at first.
  EXPECT_NEAR(outlineBack({ disk, effectView, arcOver(0.0, 180.0, 0.0, pi) }), 80.0, 0.1);
  // Straight over the disk: each of its places is nearer to the outline than the outline's are to it.
  const Polyline across{ Vector2(310, 300), Vector2(490, 300) };
  const double middle = 0.6 * 90.0; // half of what is between the two places nearest to the stroke's middle
  EXPECT_GT(outlineBack({ disk, effectView, across }), middle);
}

TEST(StrokeEffect, AStrokeFromOneOutlineToAnotherHasNoWayBack)
{
  Mesh disks;
  addDisk(disks, -150.0);
  addDisk(disks, 150.0);
  EXPECT_TRUE(std::isinf(outlineBack({ disks, effectView, { Vector2(200, 410), Vector2(600, 410) } })));
}

// A limb before another part of the model: the outline is broken there, its own silhouette is not.
TEST(StrokeEffect, AFurtherLineLeadsBackWhereTheOutlineDoesNot)
{
  Mesh disks;
  addDisk(disks, -150.0);
  addDisk(disks, 150.0);
  const Polyline stroke{ Vector2(200, 410), Vector2(600, 410) };
  OutlineLoop line;
  line.closed = false;
  line.points = { Vector2(200, 404), Vector2(600, 404) };
  EXPECT_NEAR(outlineBack({ disks, effectView, stroke }, { line }), 6.0, 0.1);
  line.points = { Vector2(200, 380), Vector2(600, 380) }; // the outline is over 2 px nearer to both ends
  EXPECT_TRUE(std::isinf(outlineBack({ disks, effectView, stroke }, { line })));
}

TEST(StrokeEffect, WhatMovesBesideTheStrokeIsFoundWithItsDistance)
{
  const Mesh mesh = square();
  const std::vector<char> all(mesh.points.size(), 1);
  const Vector3 up(0, 20, 0);
  // The top rows, down to 25 px from the stroke.
  EXPECT_EQ(effectOf(mesh, moved(mesh, 75.0, 100.0, up), all).strayDistance, 0.0);
  // Three rows more: the farthest was 60 px away and is 40 px away now.
  const StrokeEffect beside = effectOf(mesh, moved(mesh, 40.0, 100.0, up), all);
  EXPECT_NEAR(beside.strayDistance, 60.0, 1e-9);
  EXPECT_NEAR(beside.strayMovement, 20.0, 1e-9);
  ASSERT_EQ(remarks(beside).size(), 2u);
  EXPECT_NE(remarks(beside)[0].text().find("60 px beside the stroke moved too, by up to 20 px"), std::string::npos);
  // Not outside the region, nor by what nobody sees.
  EXPECT_EQ(
    effectOf(mesh, moved(mesh, 40.0, 100.0, up), std::vector<char>(mesh.points.size(), 0)).strayDistance,
    0.0);
  EXPECT_EQ(effectOf(mesh, moved(mesh, 40.0, 100.0, 0.12 * up), all).strayDistance, 0.0);
}

TEST(StrokeEffect, StretchAndShareAreThoseOfTheRegion)
{
  const Mesh mesh = square();
  Mesh wide = mesh, narrow = mesh;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    wide.points[v][0] *= 4.0;
    narrow.points[v] *= 0.1;
  }
  std::vector<char> upper(mesh.points.size(), 0);
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    upper[v] = mesh.points[v][1] >= 50.0;
  }
  EXPECT_NEAR(effectOf(mesh, mesh, upper).stretch, 1.0, 1e-12);
  EXPECT_NEAR(effectOf(mesh, wide, upper).stretch, 4.0, 1e-9);
  EXPECT_NEAR(effectOf(mesh, narrow, upper).stretch, 10.0, 1e-9);
  EXPECT_NEAR(effectOf(mesh, wide, upper).movedShare, 0.25, 1e-9);
  EXPECT_TRUE(tornBy(effectOf(mesh, wide, upper)).empty());
  EXPECT_EQ(tornBy(effectOf(mesh, narrow, upper)), "edges are stretched or squeezed 10 times");
  // All of the surface may move where nothing but what was meant did.
  const std::vector<char> all(mesh.points.size(), 1);
  EXPECT_TRUE(tornBy(effectOf(mesh, mesh, all)).empty());
  EXPECT_EQ(
    tornBy(effectOf(mesh, moved(mesh, -100.0, 100.0, Vector3(0, 20, 0)), all)), "100 % of the surface moved");
  // A vertex of each edge at one place is no division by zero.
  Mesh point = mesh;
  std::fill(point.points.begin(), point.points.end(), Vector3(0, 0, 0));
  EXPECT_NEAR(effectOf(mesh, point, upper).stretch, 1e6, 1.0);
}

// A limb drawn many times as long: its edges are stretched as often, and new triangles do not show it.
TEST(StrokeEffect, WhatWasMadeEvenAgainAndIsAsDrawnIsNotTorn)
{
  StrokeEffect effect;
  effect.stretch = 11.0;
  EXPECT_EQ(tornBy(effect), "edges are stretched or squeezed 11 times");
  effect.remeshed = true;
  EXPECT_TRUE(tornBy(effect).empty());
  effect.movedShare = 0.6;
  EXPECT_TRUE(tornBy(effect).empty());
  StrokeEffect wrong = effect;
  wrong.folds = 11;
  EXPECT_EQ(tornBy(wrong), "edges are stretched or squeezed 11 times");
  wrong = effect;
  wrong.outline = { 3.1, 4.0 };
  EXPECT_FALSE(tornBy(wrong).empty());
  wrong = effect;
  wrong.strayDistance = 26.0;
  EXPECT_FALSE(tornBy(wrong).empty());
  wrong = effect;
  wrong.back = 0.01;
  EXPECT_FALSE(tornBy(wrong).empty());
}

// A limb may be drawn through another one; two that are welded, or one that is twisted, miss the stroke
// besides.
TEST(StrokeEffect, WhatPassesThroughItselfIsTornUnlessAllElseIsAsDrawn)
{
  StrokeEffect effect;
  effect.crossings = 73;
  effect.movedShare = 0.5;
  EXPECT_FALSE(crossesWrongly(effect));
  EXPECT_TRUE(tornBy(effect).empty());
  StrokeEffect wrong = effect;
  wrong.folds = 11;
  EXPECT_TRUE(crossesWrongly(wrong));
  EXPECT_EQ(tornBy(wrong), "the surface passes through itself: 73 pairs of triangles cross");
  wrong.crossings = 10;
  EXPECT_FALSE(crossesWrongly(wrong));
  EXPECT_TRUE(tornBy(wrong).empty());
  wrong = effect;
  wrong.strayDistance = 26.0;
  EXPECT_TRUE(crossesWrongly(wrong));
}

TEST(StrokeEffect, OnlyWhatMovedBesideTheStrokeIsBeyondHelp)
{
  StrokeEffect effect;
  effect.outline = { 40.0, 90.0 };
  effect.movedShare = 0.9;
  EXPECT_FALSE(beyondHelp(effect));
  effect.strayDistance = 30.0;
  EXPECT_TRUE(beyondHelp(effect));
  effect.outline = { 9.0, 20.0 };
  EXPECT_TRUE(beyondHelp(effect));
  effect.movedShare = 0.3;
  EXPECT_FALSE(beyondHelp(effect));
}

TEST(StrokeEffect, RemarksNameWhatIsWrongAndNothingElse)
{
  StrokeEffect effect;
  EXPECT_TRUE(remarks(effect).empty());
  effect.outline = { 2.9, 8.0 };
  effect.outlineBack = 9.0;
  effect.folds = 2 * Judgement::tolerableFolds;
  effect.movedShare = 0.4;
  EXPECT_TRUE(remarks(effect).empty());
  effect.outline = { 40.4, 62.0 };
  effect.folds = 12;
  effect.movedShare = 0.5;
  EXPECT_EQ(remarks(effect),
    (std::vector<Message>{ "the outline misses the stroke by 40 px in the mean and by 62 px at worst",
      "50 % of the surface moved",
      "12 edges are folded over" }));
  effect = StrokeEffect();
  effect.outline = { 1.1, 12.8 };
  effect.back = 0.0124;
  effect.crossings = 31;
  EXPECT_EQ(remarks(effect),
    (std::vector<Message>{ "the outline misses the stroke by 13 px at worst",
      "1.2 % of what is seen of the model is turned inside out",
      "the surface passes through itself: 31 pairs of triangles cross" }));
  effect.outline = { 1.1, 8.0 };
  effect.back = 0.002;
  effect.crossings = 10;
  EXPECT_TRUE(remarks(effect).empty());
  effect.missed = 2.4;
  EXPECT_TRUE(remarks(effect).empty());
  effect.missed = 5.2;
  EXPECT_EQ(remarks(effect), (std::vector<Message>{ "the outline misses the stroke by 5 px at worst" }));
  effect = StrokeEffect();
  effect.outlineBack = 33.0;
  EXPECT_EQ(remarks(effect),
    (std::vector<Message>{ "between the stroke's ends the outline runs 33 px beside it" }));
  effect.outlineBack = std::numeric_limits<double>::infinity();
  ASSERT_EQ(remarks(effect).size(), 1u);
  EXPECT_EQ(remarks(effect)[0].text().find("inf"), std::string::npos);
}
