// Facts of image-assisted.md, section 9, its amendment: no face turns over.
#include "Planar/guard.h"

#include "Harness/polygon_shapes.h"
#include "Harness/refine_runs.h"
#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A star's base vertices: `count` at equal angles, the first a tip, and what the guard asks for: the sample
// in the middle of each part of the stroke that it hands back.
struct StarSamples
{
  StarSamples(const DrawnStroke& star, int count)
    : lengths(arcLengths(star.points, true))
  {
    for (int i = 0; i < count; ++i)
    {
      const double angle = turn * i / count;
      int nearest = 0;
      for (int s = 0; s < static_cast<int>(star.points.size()); ++s)
      {
        const auto off = [&](int at)
        {
          const Vector2 d = star.points[at] - Vector2(0.5, 0.5);
          return -(d[0] * std::cos(angle) + d[1] * std::sin(angle)) / d.norm();
        };
        nearest = off(s) < off(nearest) ? s : nearest;
      }
      samples.insert(nearest);
    }
  }

  void refineAt(const StrokeSplit& split)
  {
    const auto at = [&](double length)
    { return std::lower_bound(lengths.begin(), lengths.end(), length - 1e-12) - lengths.begin(); };
    const int count = static_cast<int>(lengths.size()) - 1;
    int from = static_cast<int>(at(split.start));
    int to = split.end > lengths.back() - 1e-12 ? count + static_cast<int>(at(split.end - lengths.back()))
                                                : static_cast<int>(at(split.end));
    samples.insert((from + to) / 2 % count);
  }

  std::vector<double> lengths;
  std::set<int> samples;
};

PlanarRefineResult refine(const CoarseDrawing& drawing,
  int levels,
  bool guard,
  const Context& context = Context())
{
  PlanarRefineOptions options;
  options.levels = levels;
  options.guard = guard;
  return refinePlanar(drawing.mesh, drawing.strokes, options, context);
}

// A square whose lower side has a tip of this height, 0.02 wide, between places that three levels put points
// on.
CoarseDrawing tippedSquare(double height)
{
  Polyline points;
  std::vector<int> corners;
  const Polyline square{ { 0.1, 0.1 }, { 0.9, 0.1 }, { 0.9, 0.9 }, { 0.1, 0.9 } };
  for (int k = 0; k < 4; ++k)
  {
    corners.push_back(static_cast<int>(points.size()));
    for (int i = 0; i < 160; ++i)
    {
      points.push_back(square[k] + (square[(k + 1) % 4] - square[k]) * i / 160.0);
      points.back()[1] -= k == 0 ? std::max(0.0, height * (1.0 - std::abs(i - 90) / 2.0)) : 0.0;
    }
  }
  return polygonDrawing(closedStroke(points), corners);
}

} // namespace

TEST(Guard, HandsBackWhatTheRefinedEdgesMiss)
{
  for (const auto& [height, levels, guard, handed] :
    std::vector<std::tuple<double, int, bool, bool>>{ { 0.03, 3, true, true },
      { 0.03, 3, false, false },
      { 0.03, 0, true, false },
      { 0.0035, 3, true, false },
      { 0.0045, 3, true, true } })
  {
    const CoarseDrawing drawing = tippedSquare(height);
    const PlanarRefineResult result = refine(drawing, levels, guard);
    ASSERT_EQ(result.splits.size(), handed ? 1U : 0U) << height << ' ' << levels;
    EXPECT_EQ(result.mesh.points.empty(), handed);
    EXPECT_EQ(result.inverted, 0);
    if (handed)
    {
      EXPECT_EQ(result.splits[0].start, drawing.mesh.edges[0].start);
      EXPECT_EQ(result.splits[0].end, drawing.mesh.edges[0].end);
    }
  }
}

TEST(Guard, HandsBackWhereStrokesLeaveNoRoom)
{
  int mostRounds = 0, mostInverted = 0;
  struct Star
  {
    double a;
    int tips, base;
  };
  for (const auto& [a, tips, base] :
    std::vector<Star>{ { 0.4, 7, 7 }, { 0.4, 7, 14 }, { 0.5, 9, 18 }, { 0.2, 12, 12 }, { 0.2, 12, 24 } })
  {
    const DrawnStroke star = starStroke(a, tips);
    StarSamples samples(star, base);
    const auto drawing = [&] {
      return polygonDrawing(star, { samples.samples.begin(), samples.samples.end() });
    };
    const int published = refine(drawing(), 3, false).inverted;
    EXPECT_GT(published, 0) << tips;
    int rounds = 0;
    PlanarRefineResult result = refine(drawing(), 3, true);
    while (!result.splits.empty() && ++rounds <= 24)
    {
      EXPECT_TRUE(result.mesh.points.empty());
      mostInverted = std::max(mostInverted, result.inverted);
      const std::size_t before = samples.samples.size();
      for (const StrokeSplit& split : result.splits)
      {
        samples.refineAt(split);
      }
      ASSERT_GT(samples.samples.size(), before);
      ASSERT_FALSE(drawing().mesh.faces.empty());
      result = refine(drawing(), 3, true);
    }
    EXPECT_LE(rounds, 24);
    EXPECT_EQ(result.inverted, 0);
    ASSERT_FALSE(result.mesh.faces.empty());
    for (const PlanarFace& face : result.mesh.faces)
    {
      EXPECT_GT(signedArea(result.mesh.points[face.corners[0]].place,
                  result.mesh.points[face.corners[1]].place,
                  result.mesh.points[face.corners[2]].place),
        1e-12);
    }
    mostRounds = std::max(mostRounds, rounds);
  }
  EXPECT_GE(mostRounds, 2);
  EXPECT_GT(mostInverted, 0);
}

TEST(C9_5, NoTriangleOfAStarTurnsOver)
{
  std::string figures;
  for (const auto& [a, tips] :
    std::vector<std::pair<double, int>>{ { 0.3, 5 }, { 0.4, 7 }, { 0.5, 9 }, { 0.2, 12 } })
  {
    const double swing = a;
    const int n = tips;
    const UnitDrawing drawing(
      { polarStroke(0.5, 0.5, [&](double angle) { return 0.3 * (1.0 + swing * std::cos(n * angle)); }) });
    for (const DeltaMode mode : { DeltaMode::Fixed, DeltaMode::Adaptive })
    {
      PlanarRefineOptions options;
      options.guard = false;
      const Rebuilt published = rebuilt(drawing, mode, options);
      options.guard = true;
      const Rebuilt run = rebuilt(drawing, mode, options);
      EXPECT_TRUE(mode == DeltaMode::Adaptive || published.result.inverted > 0);
      EXPECT_TRUE(run.result.splits.empty());
      EXPECT_FALSE(run.result.mesh.faces.empty());
      EXPECT_TRUE(invertedFaces(run.result.mesh, 1e-12, Context()).empty());
      figures += (figures.empty() ? "a " : "; a ") + digits(a) + ", n " + std::to_string(n) +
                 (mode == DeltaMode::Fixed ? " fixed: " : " adaptive: ") +
                 std::to_string(published.result.inverted) + " of " + std::to_string(published.base) +
                 " base triangles, none after " + std::to_string(run.rounds) + " rounds of " +
                 std::to_string(run.base);
    }
  }
  fact("C9_5", "inverted triangles of stars, k = 3: " + figures);
}

TEST(Guard, NothingTurnsOverInRestlessDrawings)
{
  // Outlines of several waves; a wavy feature near the rim, a closed one with an open one in it.
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high)
  { return low + (high - low) * static_cast<double>(random()) / 4294967296.0; };
  int published = 0, rounds = 0, faces = 0;
  for (int run = 0; run < 6; ++run)
  {
    const double a = uniform(0.05, 0.25), b = uniform(0.0, 0.1), phase = uniform(0.0, turn);
    const int n = 2 + static_cast<int>(random() % 6), m = 8 + static_cast<int>(random() % 8);
    const auto radius = [&](double angle)
    { return 0.3 * (1.0 + a * std::cos(n * angle + phase) + b * std::cos(m * angle)); };
    Polyline wave, inner;
    const double from = uniform(0.0, turn), share = uniform(0.75, 0.93);
    for (int i = 0; i <= 200; ++i)
    {
      const double angle = from + 2.0 * i / 200;
      wave.push_back(Vector2(0.5, 0.5) + (share + 0.04 * std::sin(30.0 * angle)) * radius(angle) *
                                           Vector2(std::cos(angle), std::sin(angle)));
      inner.emplace_back(0.5 + 0.03 * std::cos(0.02 * i), 0.46 + 0.0004 * i);
    }
    const double size = uniform(0.4, 0.6);
    const UnitDrawing drawing({ polarStroke(0.5, 0.5, radius),
      evenStroke(wave, false),
      polarStroke(0.5, 0.5, [&](double angle) { return size * radius(angle); }),
      evenStroke(inner, false) });
    for (const DeltaMode mode : { DeltaMode::Adaptive, DeltaMode::Fixed })
    {
      for (const DartMode darts : { DartMode::Local, DartMode::Off })
      {
        PlanarRefineOptions options;
        options.quads = run % 3 == 2;
        options.guard = false;
        published += rebuilt(drawing, mode, options, darts).result.inverted;
        options.guard = true;
        const Rebuilt made = rebuilt(drawing, mode, options, darts);
        EXPECT_TRUE(made.result.splits.empty()) << run;
        EXPECT_TRUE(invertedFaces(made.result.mesh, 1e-12, Context()).empty()) << run;
        faces += static_cast<int>(made.result.mesh.faces.size());
        rounds = std::max(rounds, made.rounds);
      }
    }
  }
  EXPECT_GT(published, 0);
  EXPECT_GE(rounds, 1);
  std::cout << published << " inverted without guard, none of " << faces << " with it, at most " << rounds
            << " rounds\n";
}
