// Facts of image-assisted.md, section 9: refinement with Loop's masks, snapping, what is shared of a snap.
#include "Planar/refine.h"

#include "Harness/polygon_shapes.h"
#include "Harness/shapes.h"
#include "Planar/guard.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

PlanarMesh refined(const CoarseDrawing& drawing, int levels, bool guard = true, double share = 0.3)
{
  PlanarRefineOptions options;
  options.levels = levels;
  options.guard = guard;
  options.snapShare = share;
  const PlanarRefineResult result = refinePlanar(drawing.mesh, drawing.strokes, options, Context());
  EXPECT_TRUE(result.splits.empty());
  return result.mesh;
}

bool sameBits(const PlanarMesh& a, const PlanarMesh& b)
{
  return a.points.size() == b.points.size() && a.faces.size() == b.faces.size() &&
         std::equal(a.points.begin(),
           a.points.end(),
           b.points.begin(),
           [](const PlanarPoint& p, const PlanarPoint& q) {
             return p.place == q.place && p.kind == q.kind && p.stroke == q.stroke && p.param == q.param;
           }) &&
         std::equal(a.faces.begin(),
           a.faces.end(),
           b.faces.begin(),
           [](const PlanarFace& f, const PlanarFace& g)
           { return f.corners == g.corners && f.region == g.region && f.base == g.base; });
}

int borderEdges(const PlanarMesh& mesh)
{
  const FaceEdges links = faceEdges(mesh);
  return static_cast<int>(std::count_if(
    links.edges.begin(), links.edges.end(), [](const FaceEdge& edge) { return edge.faces[1] < 0; }));
}

std::vector<CoarseDrawing> soundDrawings()
{
  return { squareDrawing(),
    discDrawing(0.3),
    discDrawing(0.2, 13),
    bowDrawing(),
    gridDrawing(5, Cells::Triangles, false, 1),
    gridDrawing(6, Cells::Triangles, true, 2) };
}

// How far a stroke's points are from it, and whether its edges hold together.
double farthestFromStrokes(const CoarseDrawing& drawing, const PlanarMesh& mesh)
{
  const std::vector<StrokeByLength> curves(drawing.strokes.begin(), drawing.strokes.end());
  double worst = 0.0;
  for (const PlanarPoint& point : mesh.points)
  {
    if (point.stroke >= 0)
    {
      EXPECT_LE(point.param, curves[point.stroke].length());
      EXPECT_TRUE(!curves[point.stroke].closed() || point.param < curves[point.stroke].length());
      worst = std::max(worst, (point.place - curves[point.stroke].at(point.param)).norm());
    }
  }
  for (const StrokeEdge& edge : mesh.edges)
  {
    EXPECT_LT(edge.start, edge.end);
    EXPECT_LT(edge.start, curves[edge.stroke].length());
    worst = std::max(worst, (mesh.points[edge.from].place - curves[edge.stroke].at(edge.start)).norm());
    worst = std::max(worst, (mesh.points[edge.to].place - curves[edge.stroke].at(edge.end)).norm());
  }
  return worst;
}

} // namespace

TEST(C9_1, EveryFaceBecomesFour)
{
  int compared = 0;
  for (const CoarseDrawing& drawing : soundDrawings())
  {
    for (int k = 1; k <= 5; ++k)
    {
      const PlanarMesh mesh = refined(drawing, k);
      const std::size_t parts = std::size_t(1) << (2 * k);
      EXPECT_EQ(mesh.faces.size(), drawing.mesh.faces.size() * parts);
      EXPECT_EQ(mesh.edges.size(), drawing.mesh.edges.size() << k);
      EXPECT_EQ(borderEdges(mesh), borderEdges(drawing.mesh) << k);
      std::map<int, std::size_t> ofBase;
      for (const PlanarFace& face : mesh.faces)
      {
        ++ofBase[face.base];
        EXPECT_EQ(face.region, 0);
        EXPECT_EQ(face.object, 0);
      }
      EXPECT_EQ(ofBase.size(), drawing.mesh.faces.size());
      for (const auto& [base, count] : ofBase)
      {
        EXPECT_EQ(count, parts) << base;
      }
      EXPECT_EQ(
        std::count_if(mesh.points.begin(), mesh.points.end(), [](const PlanarPoint& p) { return p.isBase; }),
        static_cast<long>(drawing.mesh.points.size()));
      ++compared;
    }
  }
  fact("C9_1",
    std::to_string(compared) +
      " meshes of levels 1 to 5: F 4^k faces, B 2^k border edges, each base 4^k times");
}

TEST(C9_2, InsertedPointsAreRegular)
{
  int inner = 0, outer = 0;
  for (const CoarseDrawing& drawing : soundDrawings())
  {
    const PlanarMesh mesh = refined(drawing, 3);
    const FaceEdges links = faceEdges(mesh);
    for (std::size_t p = drawing.mesh.points.size(); p < mesh.points.size(); ++p)
    {
      const bool rim = isRim(mesh.points[p].kind);
      EXPECT_EQ(links.atPoint.size(static_cast<int>(p)), rim ? 4 : 6);
      ++(rim ? outer : inner);
    }
  }
  fact("C9_2",
    "all " + std::to_string(inner) + " inserted inner points have 6 edges, all " + std::to_string(outer) +
      " on the boundary 4");
}

TEST(C9_3, PointsOfStrokesLieOnThem)
{
  double worst = 0.0;
  for (const CoarseDrawing& drawing : soundDrawings())
  {
    for (int k = 0; k <= 5; ++k)
    {
      worst = std::max(worst, farthestFromStrokes(drawing, refined(drawing, k)));
    }
  }
  EXPECT_LE(worst, 1e-12);
  const CoarseDrawing square = squareDrawing();
  for (int k = 0; k <= 6; ++k)
  {
    const PlanarMesh mesh = refined(square, k);
    EXPECT_EQ(areaOf(mesh), 0.25) << k;
    for (int corner = 0; corner < 4; ++corner)
    {
      EXPECT_EQ(mesh.points[corner].place, square.mesh.points[corner].place);
    }
  }
  fact("C9_3",
    "levels 0 to 5: points of strokes off S(t) by at most " + digits(worst) +
      "; a square keeps its corners and its area to the bit, levels 0 to 6");
}

TEST(C9_4, AnOctagonBecomesItsCircle)
{
  double worst = 0.0;
  for (const double radius : { 0.1, 0.3, 0.45 })
  {
    for (const int first : { 0, 13 })
    {
      const CoarseDrawing disc = discDrawing(radius, first);
      const PlanarMesh mesh = refined(disc, 3);
      EXPECT_EQ(borderEdges(mesh), 64);
      EXPECT_EQ(std::count_if(
                  mesh.points.begin(), mesh.points.end(), [](const PlanarPoint& p) { return isRim(p.kind); }),
        64);
      const double ideal = 32.0 * radius * radius * std::sin(turn / 64.0);
      // Places between two samples are up to this much inside the circle.
      const double resampling = 1.0 - std::cos(turn / 512.0);
      EXPECT_NEAR(areaOf(mesh) / ideal, 1.0, 2.0 * resampling);
      worst = std::max(worst, std::abs(areaOf(mesh) / ideal - 1.0));
      double farthest = 0.0;
      for (const PlanarPoint& point : mesh.points)
      {
        farthest = std::max(
          farthest, isRim(point.kind) ? std::abs((point.place - Vector2(0.5, 0.5)).norm() - radius) : 0.0);
      }
      EXPECT_LE(farthest, resampling * radius);
    }
  }
  fact("C9_4",
    "8 base points of a circle, k = 3: 64 boundary points, area 32 R^2 sin(2 pi/64) within " + digits(worst));
}

TEST(Refine, LargeFacesAreThoseOverASixteenthOfTheCanvas)
{
  const PlanarMesh mesh = squareDrawing().mesh;
  double area = 0.0;
  for (const PlanarFace& face : mesh.faces)
  {
    area += signedArea(mesh.points[face.corners[0]].place,
      mesh.points[face.corners[1]].place,
      mesh.points[face.corners[2]].place);
  }
  const double side = std::sqrt(area / static_cast<double>(mesh.faces.size()));
  EXPECT_TRUE(hasLargeFaces(mesh, 15.99 * side));
  EXPECT_FALSE(hasLargeFaces(mesh, 16.01 * side));
}

TEST(PlanarRefine, TheSketchSaysTheLevels)
{
  // A side of 0.5 becomes less than 0.02 by 5 levels; on a canvas 8 times as large it is that much shorter.
  EXPECT_EQ(levelsOfSketch(squareDrawing().mesh, 1.0), 5);
  EXPECT_EQ(levelsOfSketch(squareDrawing().mesh, 8.0), 2);
  EXPECT_EQ(levelsOfSketch(squareDrawing().mesh, 100.0), 0);
  int compared = 0;
  double worst = 0.0;
  for (const CoarseDrawing& drawing : soundDrawings())
  {
    const int levels = levelsOfSketch(drawing.mesh, 1.0);
    ASSERT_GE(levels, 1);
    const auto longestOf = [&drawing](int k, bool onStrokes)
    {
      const PlanarMesh mesh = refined(drawing, k);
      double longest = 0.0;
      for (const StrokeEdge& edge : mesh.edges)
      {
        longest = std::max(longest, edge.end - edge.start);
      }
      for (const FaceEdge& edge : faceEdges(mesh).edges)
      {
        const double length = (mesh.points[edge.from].place - mesh.points[edge.to].place).norm();
        longest = onStrokes ? longest : std::max(longest, length);
      }
      return longest;
    };
    EXPECT_LT(longestOf(levels, true), 0.02) << "no part of a stroke between two points is 4 h long";
    EXPECT_GE(longestOf(levels - 1, false), 0.015) << "one level less leaves an edge that long";
    worst = std::max(worst, longestOf(levels, false));
    ++compared;
  }
  EXPECT_GE(compared, 5);
  EXPECT_LT(worst, 0.02 * 1.5) << "masks stretch edges on no stroke a little";
  // However long the edges are beside the canvas, over 2^20 faces are not made.
  const CoarseDrawing many = gridDrawing(6, Cells::Triangles, true, 4);
  for (const int levels : { 5, 6 })
  {
    const PlanarMesh mesh = refined(many, levels);
    const int more = levelsOfSketch(mesh, 0.001);
    EXPECT_LE(mesh.faces.size() << (2 * more), std::size_t(1) << 20);
    EXPECT_GT(mesh.faces.size() << (2 * more + 2), std::size_t(1) << 20);
  }
}

TEST(C9_6, AShareOfASnapGoesToItsNeighbours)
{
  const double share = 0.3;
  double worst = 0.0, most = 0.0;
  int moved = 0;
  for (const CoarseDrawing& drawing : { bowDrawing(), gridDrawing(6, Cells::Triangles, true, 4) })
  {
    CoarseDrawing without = drawing; // its feature: what the masks alone do
    for (PlanarPoint& point : without.mesh.points)
    {
      if (point.kind == BoundaryKind::Feature)
      {
        point.kind = BoundaryKind::Interior;
        point.stroke = -1;
      }
    }
    auto& edges = without.mesh.edges;
    edges.erase(std::remove_if(edges.begin(), edges.end(), [](const StrokeEdge& e) { return e.stroke == 1; }),
      edges.end());
    const PlanarMesh masks = refined(without, 1, false), none = refined(drawing, 1, false, 0.0),
                     some = refined(drawing, 1, false, share);
    const FaceEdges links = faceEdges(some);
    for (int p = 0; p < static_cast<int>(some.points.size()); ++p)
    {
      Vector2 sum = Vector2::Zero();
      int count = 0;
      for (const int e : links.atPoint[p])
      {
        const int q = links.edges[e].other(p);
        if (some.points[q].kind == BoundaryKind::Feature)
        {
          sum += none.points[q].place - masks.points[q].place;
          ++count;
        }
      }
      const bool free = some.points[p].kind == BoundaryKind::Interior;
      const Vector2 expected = free && count > 0 ? Vector2(share * sum / count) : Vector2(0, 0);
      const Vector2 found = some.points[p].place - none.points[p].place;
      worst = std::max(worst, (found - expected).norm());
      most = std::max(most, found.norm());
      moved += found.norm() > 0.0;
    }
  }
  EXPECT_LE(worst, 1e-15);
  EXPECT_GT(most, 0.01);
  fact("C9_6",
    std::to_string(moved) + " free points beside features moved by 0.3 of the mean snap there, up to " +
      digits(most) + ", exact to " + digits(worst));
}

TEST(C9_7, TheGuardChangesNothingWhereNothingTurnsOver)
{
  int compared = 0, mended = 0;
  std::vector<CoarseDrawing> drawings = soundDrawings();
  for (unsigned seed = 10; seed < 30; ++seed)
  {
    drawings.push_back(gridDrawing(5, seed % 3 == 0 ? Cells::Mixed : Cells::Triangles, seed % 2 == 0, seed));
  }
  for (const CoarseDrawing& drawing : drawings)
  {
    for (int k = 0; k <= 4; ++k)
    {
      const PlanarMesh without = refined(drawing, k, false), with = refined(drawing, k, true);
      const bool upright = invertedFaces(without, 1e-12, Context()).empty();
      EXPECT_EQ(sameBits(without, with), upright);
      EXPECT_TRUE(invertedFaces(with, 1e-12, Context()).empty());
      ++(upright ? compared : mended);
    }
  }
  EXPECT_GE(compared, 100);
  EXPECT_GE(mended, 1);
  fact("C9_7",
    std::to_string(compared) +
      " meshes without inverted faces: the same bits with and without guard; of the other " +
      std::to_string(mended) + " the guard mends each");
}

TEST(Refine, ThreadsDoNotMatter)
{
  CoarseDrawing drawing = gridDrawing(6, Cells::Mixed, true, 5);
  PlanarRefineOptions options;
  options.levels = 4;
  EXPECT_TRUE(sameBits(refinePlanar(drawing.mesh, drawing.strokes, options, Context()).mesh,
    refinePlanar(drawing.mesh, drawing.strokes, options, twoThreads()).mesh));
  drawing = bowDrawing();
  EXPECT_TRUE(sameBits(refinePlanar(drawing.mesh, drawing.strokes, options, Context()).mesh,
    refinePlanar(drawing.mesh, drawing.strokes, options, twoThreads()).mesh));
}

TEST(Refine, AFeatureThatEndsOnTheRimLeavesItsPointThere)
{
  // The bow's first end, drawn short of the left side, is a point of that.
  CoarseDrawing drawing = bowDrawing();
  drawing.strokes[1].points.front() = Vector2(0.001, 0.4);
  PlanarPoint& end = drawing.mesh.points[4];
  end.place = drawing.strokes[0].points[180];
  end.kind = BoundaryKind::Object;
  end.stroke = 0;
  end.param = 3.6;
  StrokeEdge& side = drawing.mesh.edges[3];
  drawing.mesh.edges.push_back({ 4, side.to, 0, 3.6, side.end });
  side.to = 4;
  side.end = 3.6;
  auto& faces = drawing.mesh.faces;
  faces.erase(faces.begin() + 3); // between the side and the end
  // The feature's lengths anew.
  const std::vector<double> lengths = arcLengths(drawing.strokes[1].points);
  drawing.mesh.points[5].param = lengths[20];
  drawing.mesh.points[6].param = lengths[40];
  drawing.mesh.edges[4] = { 4, 5, 1, 0.0, lengths[20] };
  drawing.mesh.edges[5] = { 5, 6, 1, lengths[20], lengths[40] };
  const PlanarMesh mesh = refined(drawing, 3);
  EXPECT_EQ(mesh.points[4].place, drawing.strokes[0].points[180]);
  StrokeByLength curve(drawing.strokes[1]);
  curve.moveEnd(false, mesh.points[4].place); // whose first piece goes there
  int onFeature = 0;
  for (const PlanarPoint& point : mesh.points)
  {
    if (point.stroke == 1)
    {
      EXPECT_EQ(point.kind, BoundaryKind::Feature);
      EXPECT_LE((point.place - curve.at(point.param)).norm(), 1e-12);
      ++onFeature;
    }
  }
  EXPECT_EQ(onFeature, 16);
  EXPECT_NEAR(areaOf(mesh), 1.0, 1e-12);
}

TEST(Refine, ChordsAreSplitAtLevelZeroOnly)
{
  const DrawnStroke star = starStroke(0.3, 5);
  std::vector<int> samples;
  const int count = static_cast<int>(star.points.size());
  samples.reserve(20);
  for (int i = 0; i < 20; ++i)
  {
    samples.push_back(count * i / 20);
  }
  CoarseDrawing fan = polygonDrawing(star, samples), quads = squareDrawing();
  ASSERT_EQ(fan.mesh.faces.size(), 18u);
  // A square's left half as a quad, its right half as two triangles.
  quads.mesh = PlanarMesh();
  quads.tie({ 0, 32, 64, 128, 160, 192 }, BoundaryKind::Object);
  quads.addFace({ 0, 1, 4, 5 });
  quads.addFace({ 1, 2, 3, -1 });
  quads.addFace({ 1, 3, 4, -1 });
  const auto chords = [](const PlanarMesh& mesh)
  {
    const FaceEdges links = faceEdges(mesh);
    return std::count_if(links.edges.begin(),
      links.edges.end(),
      [&](const FaceEdge& edge)
      { return edge.stroke < 0 && isRim(mesh.points[edge.from].kind) && isRim(mesh.points[edge.to].kind); });
  };
  EXPECT_EQ(chords(fan.mesh), 17);
  EXPECT_EQ(chords(quads.mesh), 2);
  for (const CoarseDrawing& drawing : { fan, quads })
  {
    const PlanarMesh split = refined(drawing, 0);
    EXPECT_EQ(chords(split), 0);
    EXPECT_EQ(split.points.size(), drawing.mesh.points.size() + chords(drawing.mesh));
    EXPECT_EQ(split.faces.size(), drawing.mesh.faces.size() + 2 * chords(drawing.mesh));
    EXPECT_TRUE(invertedFaces(split, 1e-12, Context()).empty());
    EXPECT_NEAR(areaOf(split), areaOf(drawing.mesh), 1e-15);
    EXPECT_TRUE(sameBits(splitChords(split), split));
  }
  for (int k = 1; k <= 3; ++k) // in spite of the quad's three edges on the rim
  {
    EXPECT_EQ(chords(refined(quads, k)), 0);
  }
}

TEST(Refine, RefusesWhatIsNotSound)
{
  const auto expect =
    [](const CoarseDrawing& drawing, const std::string& words, const PlanarRefineOptions& options = {})
  {
    try
    {
      refinePlanar(drawing.mesh, drawing.strokes, options, Context());
      ADD_FAILURE() << "taken: " << words;
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  CoarseDrawing square = squareDrawing();
  square.mesh.faces[2].corners[1] = 9;
  expect(square, "face 2 has a corner that is no point");
  square = squareDrawing();
  square.mesh.faces[1].corners = { 1, 4, 2, -1 };
  expect(square, "turn different ways");
  square = squareDrawing();
  square.mesh.faces.push_back(square.mesh.faces[0]);
  square.mesh.faces[4].corners = { 1, 0, 3, -1 };
  square.mesh.faces.push_back({ { 0, 1, 2, -1 }, 0, 0, 5 });
  expect(square, "has more than two faces");
  square = squareDrawing();
  square.mesh.points[4].place[0] = std::nan("");
  expect(square, "point 4 is not finite");
  square = squareDrawing();
  square.mesh.edges.pop_back();
  expect(square, "on the border and on no stroke");
  square = squareDrawing();
  square.mesh.edges[0].to = 2;
  expect(square, "is no face's");
  square = squareDrawing();
  square.mesh.edges[1] = square.mesh.edges[0];
  expect(square, "is there twice");
  square = squareDrawing();
  square.mesh.points[2].stroke = -1;
  expect(square, "an end of it on none");
  square = squareDrawing();
  square.mesh.edges[3].end += 2.0;
  expect(square, "is no part of stroke 0");
  square = squareDrawing();
  square.strokes.clear();
  expect(square, "point 0 lies on stroke 0 of 0");
  PlanarRefineOptions options;
  options.levels = 11;
  expect(squareDrawing(), "levels is 11", options);
  options.levels = 9;
  expect(gridDrawing(9, Cells::Triangles, false, 1), "ask for fewer levels", options);
  options = PlanarRefineOptions();
  options.snapShare = 1.5;
  expect(squareDrawing(), "the snap's share is 1.5", options);
  options = PlanarRefineOptions();
  options.canvasSide = 0.0;
  expect(squareDrawing(), "the canvas's longest side", options);

  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(refinePlanar(squareDrawing().mesh, squareDrawing().strokes, {}, cancelled), Error);
  EXPECT_TRUE(refinePlanar(PlanarMesh(), {}, {}, Context()).mesh.points.empty());
}
