#include "Silhouette/match.h"
#include "Silhouette/shape_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

using namespace oversketch;

namespace
{

// A body of 300 x 100 px with two legs below, 60 px wide and 200 px long, 40 px apart: x from 70 to 130 and
// from 170 to 230, y from 0 to 200. A point every 2 px, covered pixels on the left.
MatchCandidate twoLegs()
{
  const Polyline corners{ { 0, 200 },
    { 70, 200 },
    { 70, 0 },
    { 130, 0 },
    { 130, 200 },
    { 170, 200 },
    { 170, 0 },
    { 230, 0 },
    { 230, 200 },
    { 300, 200 },
    { 300, 300 },
    { 0, 300 } };
  MatchCandidate loop;
  loop.closed = loop.outline = true;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Vector2 step = corners[(i + 1) % corners.size()] - corners[i];
    const int count = static_cast<int>(step.norm() / 2.0);
    for (int k = 0; k < count; ++k)
    {
      loop.display.push_back(corners[i] + step * k / count);
    }
  }
  loop.bound.assign(loop.display.size(), 1);
  return loop;
}

// Along a leg's outline whose left side is at x, from 20 px below the body round its foot and up again.
Polyline roundLeg(double x, const Vector2& shift)
{
  const Polyline corners{ { x, 180 }, { x, 0 }, { x + 60, 0 }, { x + 60, 180 } };
  Polyline stroke = uniformPolyline(corners, 4.0);
  for (Vector2& p : stroke)
  {
    p += shift;
  }
  return stroke;
}

Polyline lineOf(const std::vector<MatchCandidate>& candidates, const MatchedSection& section)
{
  Polyline line;
  for (const Blend& place : section.places)
  {
    line.push_back(place.of(candidates[section.candidate].display));
  }
  return line;
}

MatchRules rules(bool compareShapes)
{
  MatchRules made;
  made.compareShapes = compareShapes;
  return made;
}

std::string refusalOf(const std::vector<MatchCandidate>& candidates,
  const Polyline& stroke,
  const MatchRules& rules)
{
  try
  {
    matchStroke(candidates, stroke, rules);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::NoMatch);
    return error.what();
  }
  return {};
}

} // namespace

TEST(ShapeSearch, AShiftedCopyCostsOneAndAHalfTimesItsShift)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  CandidatePart leg; // the left leg: 70 px of belly, 20 px down, then 180 + 60 + 180 px
  leg.candidate = 0;
  leg.begin = 90.0;
  leg.length = 420.0;
  for (const Vector2& shift : { Vector2(0, 0), Vector2(12, 0), Vector2(-9, 12), Vector2(15, -20) })
  {
    scorePart(candidates, roundLeg(70, shift), leg);
    EXPECT_NEAR(leg.score, 1.5 * shift.norm(), 0.1) << shift.transpose(); // corners lie between samples
    EXPECT_NEAR((leg.shift - shift).norm(), 0.0, 0.1);
  }
}

TEST(ShapeSearch, LinesRoundALimbAreWoundApartWhereTheirSidesAreExchanged)
{
  const Polyline leg = roundLeg(70, Vector2(0, 0)), other = roundLeg(170, Vector2(15, -20));
  const Polyline back(leg.rbegin(), leg.rend());
  EXPECT_FALSE(woundApart(leg, leg));
  EXPECT_FALSE(woundApart(leg, other));
  EXPECT_TRUE(woundApart(leg, back));
  EXPECT_TRUE(woundApart(back, other));
  // Bent over by a half circle it goes round the same way.
  Polyline bent = leg;
  for (Vector2& p : bent)
  {
    const double angle = (180.0 - p[1]) / 180.0 * 3.14159, radius = 200.0 - p[0];
    p = Vector2(200.0 - radius * std::cos(angle), 180.0 - radius * std::sin(angle));
  }
  EXPECT_FALSE(woundApart(leg, bent));
  EXPECT_TRUE(woundApart(back, bent));
  // One side of a limb may be bent either way.
  const Polyline up = uniformPolyline({ { 0, 0 }, { 50, 40 }, { 100, 0 } }, 2.0),
                 down = uniformPolyline({ { 0, 0 }, { 50, -40 }, { 100, 0 } }, 2.0);
  EXPECT_FALSE(woundApart(up, down));
}

TEST(ShapeSearch, FindsTheShapeWhereverItIs)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  const std::vector<CandidatePart> found = findShapes(candidates, roundLeg(170, Vector2(10, 5)));
  ASSERT_FALSE(found.empty());
  // 70 + 200 + 60 + 200 + 40 + 20 px to where the right leg's outline is as high as the stroke's begin.
  EXPECT_NEAR(found.front().begin, 590.0, 20.0);
  EXPECT_NEAR(found.front().length, 420.0, 40.0);
  EXPECT_TRUE(std::is_sorted(found.begin(),
    found.end(),
    [](const CandidatePart& a, const CandidatePart& b) { return a.score < b.score; }));
}

TEST(Match, AStrokeBesideItsLegTakesTheLegAndNotWhatItsEndsAreNearTo)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  // 45 px aside: its ends, at x = 115 and 175, are nearest to the two sides of the crotch, at 130 and 170.
  const Polyline stroke = roundLeg(70, Vector2(45, 0));
  const auto reachesOverTheGap = [](const Polyline& line)
  { return std::any_of(line.begin(), line.end(), [](const Vector2& p) { return p[0] > 150.0; }); };
  EXPECT_TRUE(reachesOverTheGap(lineOf(candidates, matchStroke(candidates, stroke, rules(false)))));
  for (const bool backwards : { false, true })
  {
    Polyline drawn = stroke;
    if (backwards)
    {
      std::reverse(drawn.begin(), drawn.end());
    }
    const MatchedSection section = matchStroke(candidates, drawn, rules(true));
    const Polyline line = lineOf(candidates, section);
    EXPECT_FALSE(reachesOverTheGap(line));
    EXPECT_NEAR(arcLengths(line).back(), 420.0, 42.0);
    EXPECT_NEAR(line.front()[0], backwards ? 130.0 : 70.0, 1e-9);
    EXPECT_NEAR(line.back()[0], backwards ? 70.0 : 130.0, 1e-9);
    EXPECT_GT(section.distance, 0.0);
  }
}

TEST(Match, AStrokeOnItsSectionIsMatchedAsWithoutComparing)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  for (const double x : { 70.0, 170.0 })
  {
    const Polyline stroke = roundLeg(x, Vector2(1.5, -2.0));
    const MatchedSection plain = matchStroke(candidates, stroke, rules(false)),
                         compared = matchStroke(candidates, stroke, rules(true));
    ASSERT_EQ(plain.places.size(), compared.places.size());
    EXPECT_EQ(lineOf(candidates, plain), lineOf(candidates, compared));
    EXPECT_EQ(plain.distance, compared.distance);
  }
}

TEST(Match, TheSecondSectionIsTheOtherLegAndThereIsALastOne)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  const Polyline stroke = roundLeg(70, Vector2(5, 0));
  MatchRules one = rules(true);
  const MatchedSection first = matchStroke(candidates, stroke, one);
  ASSERT_GT(first.rivals, 1);
  bool otherLeg = false;
  for (one.rank = 1; one.rank < first.rivals; ++one.rank)
  {
    const Polyline line = lineOf(candidates, matchStroke(candidates, stroke, one));
    const auto onLeg = [](const Vector2& p) { return p[0] >= 169.0 && p[0] <= 231.0 && p[1] < 190.0; };
    const auto count = static_cast<std::size_t>(std::count_if(line.begin(), line.end(), onLeg));
    otherLeg = otherLeg || 10 * count > 8 * line.size();
  }
  EXPECT_TRUE(otherLeg);
  one.rank = first.rivals;
  EXPECT_NE(refusalOf(candidates, stroke, one).find("no number " + std::to_string(first.rivals + 1)),
    std::string::npos);
}

// Wherever the pen began on the way round, and whichever way it went.
TEST(ShapeSearch, AClosedStrokeIsOpenedWhereItGoesOverTheBase)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  Polyline round{ { 100, 190 }, { 70, 190 }, { 70, -40 }, { 130, -40 }, { 130, 190 }, { 100, 190 } };
  round = uniformPolyline(round, 2.0);
  round.pop_back(); // the first one again
  for (const bool backwards : { false, true })
  {
    for (const int begin : { 0, 40, 150, 290 })
    {
      Polyline drawn = round;
      std::rotate(drawn.begin(), drawn.begin() + begin, drawn.end());
      if (backwards)
      {
        std::reverse(drawn.begin(), drawn.end());
      }
      const Polyline open = openStroke(candidates, drawn);
      const Vector2 left(70, 190), right(130, 190);
      EXPECT_LT((open.front() - (backwards ? right : left)).norm(), 16.0) << begin;
      EXPECT_LT((open.back() - (backwards ? left : right)).norm(), 16.0) << begin;
      for (const Vector2& p : open)
      {
        EXPECT_FALSE(p[1] > 150.0 && p[0] > 86.0 && p[0] < 114.0) << p.transpose();
      }
      const MatchedSection section = matchStroke(candidates, open, rules(true));
      for (const Vector2& p : lineOf(candidates, section))
      {
        EXPECT_TRUE(p[0] > 55.0 && p[0] < 145.0 && p[1] < 201.0) << p.transpose();
      }
    }
  }
}

TEST(Match, AStrokeFarFromEverythingIsRefusedWithItsDistance)
{
  std::vector<MatchCandidate> candidates{ twoLegs() };
  candidates.emplace_back();                           // a curve without points is no curve
  const Polyline stroke{ { 400, 250 }, { 500, 250 } }; // the body ends at x = 300
  MatchRules gated = rules(true);
  gated.maximumGap = 60.0;
  EXPECT_NE(refusalOf(candidates, stroke, gated).find("100 px from any outline"), std::string::npos);
  gated.maximumGap = 101.0;
  const Polyline along{ { 400, 210 }, { 400, 290 } };
  EXPECT_EQ(refusalOf(candidates, along, gated), "");
}

TEST(Match, SettledEndsDoNotPassEachOtherRoundAWholeLoop)
{
  MatchCandidate ring;
  ring.closed = ring.outline = true;
  for (int i = 0; i < 360; ++i)
  {
    const double a = i * std::acos(-1.0) / 180.0;
    ring.display.emplace_back(100.0 * std::cos(a), 100.0 * std::sin(a));
  }
  ring.bound.assign(ring.display.size(), 1);
  Polyline stroke; // 350 degrees of a ring 30 px aside
  for (int i = 0; i <= 350; i += 2)
  {
    stroke.push_back(ring.display[static_cast<std::size_t>(i)] + Vector2(30, 0));
  }
  const MatchedSection section = matchStroke({ ring }, stroke, rules(true));
  const double length = arcLengths(lineOf({ ring }, section)).back();
  EXPECT_GT(length, 400.0);
  EXPECT_LE(length, 2.0 * std::acos(-1.0) * 100.0);
}

TEST(ShapeSearch, ALineAcrossTheOutlineLooksLikeNoPartOfAStraightOne)
{
  MatchCandidate straight;
  for (int i = 0; i <= 300; ++i)
  {
    straight.display.emplace_back(2.0 * i, 0.0);
  }
  straight.bound.assign(straight.display.size(), 1);
  EXPECT_TRUE(findShapes({ straight }, { { 300, -50 }, { 300, 50 } }).empty());
  EXPECT_FALSE(findShapes({ straight }, { { 250, 20 }, { 350, 20 } }).empty());
}

TEST(ShapeSearch, WhatIsOfTheSameShapeButFarAwayIsNotMeant)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  EXPECT_FALSE(
    findShapes(candidates, roundLeg(170, Vector2(0, -100))).empty()); // of 420 px, 105 are a quarter
  EXPECT_TRUE(findShapes(candidates, roundLeg(170, Vector2(0, -250))).empty());
}

// A hand that begins a stroke beside the leg's other side: the ends alone would put its left side where the
// right one was drawn, and turn it inside out.
TEST(Match, NoSideOfALimbIsTakenForItsOther)
{
  const std::vector<MatchCandidate> candidates{ twoLegs() };
  const Polyline crossed =
    uniformPolyline({ { 77, 180 }, { 123, 150 }, { 123, 5 }, { 77, 5 }, { 77, 150 }, { 123, 180 } }, 4.0);
  for (const bool reversed : { false, true })
  {
    Polyline stroke = crossed;
    if (reversed)
    {
      std::reverse(stroke.begin(), stroke.end());
    }
    const MatchedSection section = matchStroke(candidates, stroke, rules(true));
    const Polyline line = lineOf(candidates, section);
    EXPECT_FALSE(woundApart(line, stroke));
    EXPECT_NEAR(arcLengths(line).back(), 420.0, 60.0); // the whole leg, from its other side
    EXPECT_NEAR(line.front()[0], reversed ? 70.0 : 130.0, 1.0);
    EXPECT_NEAR(line.back()[0], reversed ? 130.0 : 70.0, 1.0);
  }
}
