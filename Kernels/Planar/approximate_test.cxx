// Facts of image-assisted.md, section 6.
#include "Harness/planar_shapes.h"
#include "Planar/approximate.h"
#include "Planar/pieces.h"
#include "Planar/predicates.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

ApproximationRules fixedRules(double tolerance = 0.05)
{
  return { DeltaMode::Fixed, 0.25 * pi, tolerance };
}

// Of a polyline's segment, how far its samples are from it at most.
double deviation(const DrawnStroke& stroke, int from, int to)
{
  const int count = static_cast<int>(stroke.points.size());
  const NearestPlace segment({ stroke.points[from % count], stroke.points[to % count] });
  double most = 0.0;
  for (int i = from; i <= to; ++i)
  {
    most = std::max(most, segment(stroke.points[i % count]).distance);
  }
  return most;
}

// Segments of a polyline: numbers of samples, of a closed one's last the first plus the count.
std::vector<std::array<int, 2>> segmentsOf(const StrokePolyline& polyline, const DrawnStroke& stroke)
{
  std::vector<std::array<int, 2>> result;
  const std::size_t n = polyline.samples.size();
  for (std::size_t i = 0; i + 1 < n + (polyline.closed ? 1 : 0); ++i)
  {
    const int to =
      i + 1 < n ? polyline.samples[i + 1] : polyline.samples[0] + static_cast<int>(stroke.points.size());
    result.push_back({ polyline.samples[i], to });
  }
  return result;
}

DrawnStroke flower(double amplitude, int petals)
{
  return polarStroke(0.5, 0.5, [=](double a) { return 0.3 * (1.0 + amplitude * std::cos(petals * a)); });
}

bool meetSomewhere(const std::vector<StrokeLine>& lines)
{
  std::vector<std::array<Vector2, 2>> segments;
  for (const StrokeLine& line : lines)
  {
    const std::size_t n = line.places.size();
    for (std::size_t i = 0; i + 1 < n + (line.closed ? 1 : 0); ++i)
    {
      segments.push_back({ line.places[i], line.places[(i + 1) % n] });
    }
  }
  for (std::size_t i = 0; i < segments.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if (segmentsMeet(segments[i][0], segments[i][1], segments[j][0], segments[j][1]))
      {
        return true;
      }
    }
  }
  return false;
}

} // namespace

TEST(C6_1, CornersOfASquareAndAHexagon)
{
  for (const DeltaMode mode : { DeltaMode::Adaptive, DeltaMode::Fixed })
  {
    for (const int shift : { 0, 1, 57 }) // samples that the stroke begins off its corner
    {
      for (const int sides : { 4, 6 })
      {
        DrawnStroke stroke = sides == 4 ? squareStroke(0.1, 0.9) : polygonStroke(0.5, 0.5, 0.4, 6);
        const std::vector<int> exact = approximateAlone(stroke.points, true, 1.0);
        ASSERT_EQ(static_cast<int>(exact.size()), sides);
        std::set<std::pair<double, double>> expected;
        for (int i = 0; i < sides; ++i)
        {
          const Vector2 p = stroke.points[exact[i]];
          expected.emplace(p[0], p[1]);
        }
        EXPECT_EQ(exact[0], 0);
        std::rotate(stroke.points.begin(), stroke.points.begin() + shift, stroke.points.end());
        const UnitDrawing drawing({ stroke });
        ApproximationRules rules;
        rules.mode = mode;
        std::set<std::pair<double, double>> found;
        const StrokePolyline polyline = drawing.polylines(rules)[0];
        for (const int sample : polyline.samples)
        {
          found.emplace(stroke.points[sample][0], stroke.points[sample][1]);
        }
        EXPECT_EQ(found, expected);
      }
    }
  }
  fact("C6_1", "square 4 vertices, hexagon 6, their corners, wherever the stroke begins; both modes");
}

TEST(C6_2, VerticesOfACircle)
{
  const auto vertices = [](double radius, const ApproximationRules& rules)
  { return UnitDrawing({ circleStroke(0.5, 0.5, radius) }).polylines(rules)[0].samples.size(); };
  EXPECT_EQ(vertices(0.1, fixedRules()), 4u);
  EXPECT_EQ(vertices(0.15, fixedRules()), 4u);
  for (const double radius : { 0.2, 0.25, 0.3, 0.35, 0.4, 0.45 })
  {
    EXPECT_EQ(vertices(radius, fixedRules()), 8u) << radius;
  }
  EXPECT_EQ(vertices(0.4, fixedRules(0.01)), 16u);
  int radii = 0;
  for (int i = 30; i <= 450; i += 10)
  {
    EXPECT_EQ(vertices(i / 1000.0, {}), 8u) << i;
    ++radii;
  }
  fact("C6_2",
    "circle, fixed 0.05: 4 vertices at 0.1 and 0.15, 8 at 0.2 to 0.45; 0.01: 16 at 0.4; adaptive: 8 at " +
      std::to_string(radii) + " radii from 0.03 to 0.45");
}

TEST(C6_3, EverySampleIsNearItsSegment)
{
  int segments = 0, shorter = 0;
  double share = 0.0;
  for (const double tolerance : { 0.05, 0.02, 0.006 })
  {
    for (const int petals : { 3, 5, 7 })
    {
      const UnitDrawing drawing({ flower(0.4, petals),
        evenStroke({ { 0.4, 0.4 }, { 0.45, 0.55 }, { 0.6, 0.6 } }, false),
        circleStroke(0.5, 0.45, 0.03) });
      for (const StrokePolyline& polyline : drawing.polylines(fixedRules(tolerance)))
      {
        const DrawnStroke& stroke = drawing.strokes[polyline.stroke];
        EXPECT_TRUE(std::is_sorted(polyline.samples.begin(), polyline.samples.end()));
        EXPECT_GE(polyline.samples.front(), 0);
        EXPECT_LT(polyline.samples.back(), static_cast<int>(stroke.points.size()));
        for (const auto& [from, to] : segmentsOf(polyline, stroke))
        {
          const double most = deviation(stroke, from, to);
          ++segments;
          if (to - from <= 3) // under 2 h, perhaps
          {
            ++shorter;
            continue;
          }
          EXPECT_LE(most, tolerance);
          share = std::max(share, most / tolerance);
        }
      }
    }
  }
  fact("C6_3",
    std::to_string(segments) + " segments of 27 polylines, fixed 0.006 to 0.05: samples within " +
      digits(share, 3) + " delta of theirs, " + std::to_string(shorter) + " segments too short to ask");
  EXPECT_GT(share, 0.5);
}

TEST(C6_4, ATwelveSidedOneHasNoCorner)
{
  for (const double radius : { 0.2, 0.4, 0.48 })
  {
    EXPECT_TRUE(corners(polygonStroke(0.5, 0.5, radius, 12).points, true).empty());
    EXPECT_EQ(corners(polygonStroke(0.5, 0.5, radius, 6).points, true).size(), 6u);
  }
  fact("C6_4", "12-gon of radius 0.2 to 0.48: no corner found");
}

TEST(Approximate, CornersAreClusteredOncePerRun)
{
  // Two right angles 12 samples apart are two corners, 3 samples apart one.
  const auto steps = [](int between)
  {
    Polyline points;
    Vector2 place(0.0, 0.0);
    const auto walk = [&](int count, const Vector2& way)
    {
      for (int i = 0; i < count; ++i)
      {
        place += way;
        points.push_back(place);
      }
    };
    walk(20, { 1, 0 });
    walk(between, { 0, 1 });
    walk(20, { 1, 0 });
    return points;
  };
  EXPECT_EQ(corners(steps(12), false), (std::vector<int>{ 19, 31 }));
  EXPECT_EQ(corners(steps(3), false).size(), 1u);
  EXPECT_TRUE(corners(circleStroke(0.5, 0.5, 0.02).points, true).empty()); // turns sharply all along
  EXPECT_TRUE(corners({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }, true).empty());
  EXPECT_TRUE(corners({}, false).empty());
  EXPECT_EQ(approximateAlone(circleStroke(0.5, 0.5, 0.02).points, true, 1.0).size(), 3u);
  EXPECT_EQ(approximateAlone({ { 0, 0 } }, false, 1.0), std::vector<int>{ 0 });
  EXPECT_TRUE(approximateAlone({}, true, 1.0).empty());
}

TEST(Approximate, AdaptivePiecesAreAFourthAsFarAsTheBodyIsThick)
{
  const UnitDrawing drawing({ flower(0.5, 5) });
  const DrawnStroke& stroke = drawing.strokes[0];
  const StrokePolyline polyline = drawing.polylines()[0];
  EXPECT_GT(polyline.samples.size(), drawing.polylines(fixedRules())[0].samples.size());
  for (const auto& [from, to] : segmentsOf(polyline, stroke))
  {
    // At least as thick as at any sample's pixel and those beside it, and no less than the lower bound.
    double thickest = 0.0;
    for (int i = from; i <= to; ++i)
    {
      const Vector2 pixel = drawing.maps.frame.toPixels(stroke.points[i % stroke.points.size()]);
      for (int k = 0; k < 9; ++k)
      {
        thickest = std::max(thickest,
          drawing.maps.frame.spacing *
            drawing.maps
              .thickness[drawing.maps.frame.index(static_cast<int>(std::lround(pixel[0])) + k % 3 - 1,
                static_cast<int>(std::lround(pixel[1])) + k / 3 - 1)]);
      }
    }
    EXPECT_LE(deviation(stroke, from, to), std::max(0.0025, std::min(0.05, 0.25 * thickest)));
  }
}

TEST(Approximate, StraightOpenFeaturesHaveAVertexWhereverTheBodyIsAsThick)
{
  for (const double half : { 0.015, 0.05, 0.1, 0.2 })
  {
    const UnitDrawing drawing(
      { evenStroke(
          { { 0.05, 0.5 - half }, { 0.95, 0.5 - half }, { 0.95, 0.5 + half }, { 0.05, 0.5 + half } }, true),
        evenStroke({ { 0.25, 0.5 }, { 0.75, 0.5 } }, false) });
    const DrawnStroke& line = drawing.strokes[1];
    const auto arcs = segmentsOf(drawing.polylines()[1], line);
    const double longest = std::max(half, 0.04) + 0.005; // a sample, as the map's pixels are places too
    for (const auto& [from, to] : arcs)
    {
      const double arc = (line.points[to] - line.points[from]).norm();
      EXPECT_LE(arc, longest) << half;
      EXPECT_GE(arc, 0.45 * longest) << half;
    }
    EXPECT_EQ(segmentsOf(drawing.polylines(fixedRules())[1], line).size(), 1u) << "as published";
  }
}

TEST(Approximate, ARimHasVerticesWhereAFreeEndIsNearIt)
{
  const DrawnStroke body = evenStroke({ { 0.05, 0.3 }, { 0.95, 0.3 }, { 0.95, 0.7 }, { 0.05, 0.7 } }, true);
  const auto rim = [&](double top, const ApproximationRules& rules)
  {
    const UnitDrawing drawing({ body, evenStroke({ { 0.4, 0.45 }, { 0.4, top } }, false) });
    const StrokePolyline polyline = drawing.polylines(rules)[0];
    Polyline places;
    for (const int sample : polyline.samples)
    {
      places.push_back(body.points[sample]);
    }
    return places;
  };
  ApproximationRules unjoined;
  unjoined.joinDistance = 0.0;
  const std::size_t corners = 4;
  EXPECT_EQ(rim(0.67, {}).size(), corners) << "far enough";
  EXPECT_EQ(rim(0.695, {}).size(), corners + 1) << "joined";
  EXPECT_EQ(rim(0.688, fixedRules()).size(), corners) << "as published";
  for (const double top : { 0.675, 0.688, 0.6995 })
  {
    const Polyline places = rim(top, unjoined);
    EXPECT_GT(places.size(), corners) << top;
    EXPECT_LT(places.size(), corners + 10) << top;
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      const Vector2 &a = places[i], &b = places[(i + 1) % places.size()];
      const double length = (b - a).norm(), distance = NearestPlace({ a, b })({ 0.4, top }).distance;
      EXPECT_TRUE(distance >= 0.0299 * length || length <= 0.0201) << top << ", a piece of " << length;
    }
    const auto isElsewhere = [](const Vector2& place) { return place[1] < 0.69; };
    EXPECT_EQ(std::count_if(places.begin(), places.end(), isElsewhere), 2) << "the other sides stay";
  }
}

TEST(Approximate, WhatIsHandedBackBecomesFiner)
{
  // The stroke's first sample is no vertex's neighbour in particular: intervals go over it too.
  const UnitDrawing drawing({ polarStroke(
    0.5, 0.5, [](double) { return 0.4; }, 0.2) });
  const DrawnStroke& stroke = drawing.strokes[0];
  const std::vector<double> lengths = arcLengths(stroke.points, true);
  const StrokePolyline coarse = drawing.polylines()[0];
  ASSERT_EQ(coarse.samples.size(), 8u);
  for (const auto& [from, to] : segmentsOf(coarse, stroke))
  {
    const int count = static_cast<int>(stroke.points.size());
    const double end = lengths[to % count] + (to >= count ? lengths.back() : 0.0);
    std::size_t before = 8;
    for (int halvings = 1; halvings <= 14; ++halvings)
    {
      const StrokePolyline finer = drawing.polylines({}, { { 0, lengths[from], end, halvings } })[0];
      // The others stay; this one only gains.
      for (const int sample : coarse.samples)
      {
        EXPECT_TRUE(std::binary_search(finer.samples.begin(), finer.samples.end(), sample));
      }
      for (const int sample : finer.samples)
      {
        const bool inside = (sample > from && sample < to) || (sample + count > from && sample + count < to);
        EXPECT_TRUE(inside || std::binary_search(coarse.samples.begin(), coarse.samples.end(), sample));
      }
      EXPECT_GE(finer.samples.size(), before);
      before = finer.samples.size();
    }
    EXPECT_EQ(before, 8u + (to - from - 1)); // at single samples
  }
  EXPECT_EQ(drawing.polylines({}, { { 5, 0.0, 1.0, 3 } })[0].samples, coarse.samples);
}

TEST(Approximate, PolylinesOfStrokesThatDoNotMeetDoNotMeet)
{
  // A feature that follows the outline closely, and a closed one in a bump that its chord cuts off.
  Polyline along;
  for (int i = 10; i < 90; ++i)
  {
    const double a = turn * i / 200, r = 0.3 * (1.0 + 0.3 * std::cos(5 * a)) - 0.012;
    along.emplace_back(0.5 + r * std::cos(a), 0.5 + r * std::sin(a));
  }
  const UnitDrawing close({ flower(0.3, 5), evenStroke(along, false) });
  EXPECT_FALSE(meetSomewhere(close.lines(fixedRules())));
  EXPECT_FALSE(meetSomewhere(close.lines()));

  const std::vector<StrokeLine> coarse = UnitDrawing({ circleStroke(0.5, 0.5, 0.4) }).lines(fixedRules());
  const Vector2 off = (0.5 * (coarse[0].places[1] + coarse[0].places[2]) - Vector2(0.5, 0.5)).normalized();
  for (const double distance : { 0.37, 0.386 }) // on the chord, and wholly beyond it
  {
    const Vector2 centre = Vector2(0.5, 0.5) + distance * off;
    const UnitDrawing bump({ circleStroke(0.5, 0.5, 0.4), circleStroke(centre[0], centre[1], 0.008) });
    const std::vector<StrokeLine> lines = bump.lines(fixedRules());
    EXPECT_FALSE(meetSomewhere(lines));
    EXPECT_GT(lines[0].places.size(), 8u) << distance;
    EXPECT_LT(lines[0].places.size(), 20u) << distance;
    // On the inner side of every segment of the convex outline.
    for (std::size_t i = 0; i < lines[0].places.size(); ++i)
    {
      const Vector2 &a = lines[0].places[i], &b = lines[0].places[(i + 1) % lines[0].places.size()];
      for (const Vector2& p : lines[1].places)
      {
        EXPECT_GT(orientation(a, b, p), 0);
      }
    }
  }
  // Two strokes that run over each other, which no classification would let through.
  const UnitDrawing alone({ circleStroke(0.5, 0.5, 0.4) });
  std::vector<DrawnStroke> twice{ alone.strokes[0], alone.strokes[0] };
  std::vector<StrokeClass> classes{ alone.classes.strokes[0], alone.classes.strokes[0] };
  try
  {
    approximate(
      twice, classes, { Treatment::Fill, Treatment::Fill }, alone.maps, {}, 1.0, fixedRules(), Context());
    ADD_FAILURE();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_NE(std::string(error.what()).find("stroke 0 comes so near stroke 1"), std::string::npos)
      << error.what();
  }
}

TEST(Approximate, OpenEndsJoinTheRim)
{
  const auto open = [](double to) { return evenStroke({ { 0.5, 0.5 }, { 0.5 + to, 0.503 } }, false); };
  for (const double gap : { 0.006, 0.0095, 0.0105, 0.02 })
  {
    const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.4), open(0.4 - gap) });
    const std::vector<StrokePolyline> polylines = drawing.polylines();
    const StrokeJoin join = polylines[1].joins[1];
    EXPECT_EQ(polylines[1].joins[0].stroke, -1);
    EXPECT_EQ(join.stroke, gap < 0.01 ? 0 : -1);
    if (gap < 0.01)
    {
      const std::vector<int>& rim = polylines[0].samples;
      EXPECT_TRUE(std::binary_search(rim.begin(), rim.end(), join.sample));
      EXPECT_EQ(drawing.lines()[1].places.back(), drawing.strokes[0].points[join.sample]);
      EXPECT_LE((drawing.strokes[0].points[join.sample] - drawing.strokes[1].points.back()).norm(), 0.01);
      EXPECT_FALSE(meetSomewhere(drawing.lines()));
    }
  }
  // How near is a rule; without it ends stay where they are drawn, even on the rim itself.
  const UnitDrawing far({ circleStroke(0.5, 0.5, 0.4), open(0.38) });
  const UnitDrawing touching({ circleStroke(0.5, 0.5, 0.4), open(0.399) });
  const auto joinsAt = [](const UnitDrawing& drawing, double distance)
  {
    ApproximationRules rules;
    rules.joinDistance = distance;
    return approximate(drawing.strokes,
             drawing.classes.strokes,
             drawing.treatments,
             drawing.maps,
             {},
             1.0,
             rules,
             Context())[1]
             .joins[1]
             .stroke == 0;
  };
  EXPECT_FALSE(joinsAt(far, 0.015));
  EXPECT_TRUE(joinsAt(far, 0.03));
  EXPECT_TRUE(joinsAt(touching, 0.01));
  EXPECT_FALSE(joinsAt(touching, 0.0));
  // A hole's rim is joined too, a closed feature that stays filled is not.
  for (const Treatment treatment : { Treatment::Fill, Treatment::Hole })
  {
    const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.4),
                                circleStroke(0.6, 0.5, 0.1),
                                evenStroke({ { 0.3, 0.5 }, { 0.493, 0.5 } }, false) },
      { Treatment::Fill, treatment, Treatment::Fill });
    EXPECT_EQ(drawing.polylines()[2].joins[1].stroke, treatment == Treatment::Hole ? 1 : -1);
  }
}

TEST(Approximate, WhatLiesInAHoleHasNoPolyline)
{
  const std::vector<DrawnStroke> strokes{ circleStroke(0.5, 0.5, 0.1),
    circleStroke(0.5, 0.5, 0.4),
    circleStroke(0.5, 0.5, 0.2),
    evenStroke({ { 0.48, 0.5 }, { 0.52, 0.5 } }, false),
    evenStroke({ { 0.2, 0.45 }, { 0.2, 0.55 } }, false),
    evenStroke({ { 0.34, 0.47 }, { 0.34, 0.53 } }, false) };
  const Treatment fill = Treatment::Fill;
  EXPECT_EQ(UnitDrawing(strokes).polylines().size(), 6u);
  const UnitDrawing holed(strokes, { fill, fill, Treatment::Hole, fill, fill, fill });
  std::vector<int> left;
  for (const StrokePolyline& polyline : holed.polylines())
  {
    left.push_back(polyline.stroke);
  }
  EXPECT_EQ(left, (std::vector<int>{ 0, 1, 2, 3, 4 })) << "an island in it has one, and what lies in that";
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(
    approximate(strokes, holed.classes.strokes, holed.treatments, holed.maps, {}, 1.0, {}, cancelled), Error);
}
