// Facts of image-assisted.md, section 8.
#include "Harness/planar_shapes.h"
#include "Planar/darts.h"
#include "Planar/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

// A body with limbs, features and a hole, and a second object.
UnitDrawing sketchOfTwo()
{
  return UnitDrawing({ polarStroke(0.35, 0.5, [](double a) { return 0.22 * (1.0 + 0.4 * std::cos(5 * a)); }),
                       circleStroke(0.35, 0.45, 0.05),
                       evenStroke({ { 0.25, 0.55 }, { 0.35, 0.6 }, { 0.42, 0.55 } }, false),
                       circleStroke(0.82, 0.5, 0.15) },
    { Treatment::Fill, Treatment::Hole, Treatment::Fill, Treatment::Fill });
}

// The vertices of rims that point into their object and turn by over 45 degrees [px], by their angles.
std::vector<Vector2> inwardCorners(const UnitDrawing& drawing)
{
  std::vector<Vector2> corners;
  for (const StrokeLine& line : drawing.lines())
  {
    const bool hole = line.treatment == Treatment::Hole && line.role == Role::ClosedFeature;
    if (!line.closed || (line.role != Role::Boundary && !hole))
    {
      continue;
    }
    const std::size_t n = line.places.size();
    double whole = 0.0;
    std::vector<double> turns(n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Vector2 a = line.places[i] - line.places[(i + n - 1) % n],
                    b = line.places[(i + 1) % n] - line.places[i];
      turns[i] = std::remainder(std::atan2(b[1], b[0]) - std::atan2(a[1], a[0]), turn);
      whole += turns[i]; // a whole turn, to the left or the right
    }
    for (std::size_t i = 0; i < n; ++i)
    {
      if ((turns[i] * whole < 0.0) != hole && std::abs(turns[i]) > turn / 8)
      {
        corners.push_back(drawing.maps.frame.toPixels(line.places[i]));
      }
    }
  }
  return corners;
}

// What the rule asks of a pixel: the distance to keep, negative where no dart may lie.
std::vector<double> radiiOf(const UnitDrawing& drawing, DartMode mode)
{
  const DistanceMaps& maps = drawing.maps;
  std::vector<double> greatest(static_cast<std::size_t>(drawing.classes.objects), 0.0);
  for (std::size_t i = 0; i < maps.object.size(); ++i)
  {
    if (maps.object[i] >= 0)
    {
      greatest[maps.object[i]] = std::max<double>(greatest[maps.object[i]], maps.distance[i]);
    }
  }
  std::vector<std::vector<std::array<Vector2, 2>>> segments(greatest.size());
  for (const StrokeLine& line : drawing.lines())
  {
    for (std::size_t k = 0; k + (line.closed ? 0 : 1) < line.places.size(); ++k)
    {
      segments[line.object].push_back({ maps.frame.toPixels(line.places[k]),
        maps.frame.toPixels(line.places[(k + 1) % line.places.size()]) });
    }
  }
  const std::vector<Vector2> corners = inwardCorners(drawing);
  const double longer = std::max(maps.frame.width, maps.frame.height);
  std::vector<std::pair<Vector2, double>> sizes; // vertices, and the mean of the pieces that end there
  for (const StrokeLine& line : drawing.lines())
  {
    const std::size_t n = line.places.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const bool first = !line.closed && i == 0, last = !line.closed && i + 1 == n;
      const double before = first ? 0.0 : (line.places[i] - line.places[(i + n - 1) % n]).norm();
      const double after = last ? 0.0 : (line.places[(i + 1) % n] - line.places[i]).norm();
      const double mean = (before + after) / (first || last ? 1.0 : 2.0) / maps.frame.spacing;
      sizes.emplace_back(maps.frame.toPixels(line.places[i]), std::max(0.03 * longer, mean));
    }
  }
  std::vector<double> radii(maps.object.size(), -1.0);
  for (int y = 0; y < maps.frame.height; ++y)
  {
    for (int x = 0; x < maps.frame.width; ++x)
    {
      const std::size_t i = maps.frame.index(x, y);
      const int object = maps.object[i];
      if (object < 0 || maps.distance[i] == 0.0f)
      {
        continue;
      }
      double radius = 0.5 * greatest[object];
      if (mode == DartMode::Local)
      {
        double corner = 1e9;
        for (const Vector2& place : corners)
        {
          corner = std::min(corner, (place - Vector2(x, y)).norm());
        }
        corner = std::max(corner, 0.05 * longer);
        for (const auto& [place, size] : sizes)
        {
          corner = std::min(corner, size + 0.35 * (place - Vector2(x, y)).norm());
        }
        radius = std::max(6.0, std::min(0.7 * maps.thickness[i], corner));
      }
      bool legal = maps.distance[i] >= radius;
      for (const auto& [a, b] : segments[object])
      {
        if (!legal || mode == DartMode::Published)
        {
          break;
        }
        const Vector2 way = b - a, offset = Vector2(x, y) - a;
        const double t = std::clamp(offset.dot(way) / way.squaredNorm(), 0.0, 1.0);
        legal = (offset - t * way).norm() >= 0.7 * radius;
      }
      radii[i] = legal ? radius : -1.0;
    }
  }
  return radii;
}

} // namespace

TEST(C8_1, EveryDistanceIsKeptAndNoLegalPixelIsLeft)
{
  const UnitDrawing drawing = sketchOfTwo();
  const DistanceMaps& maps = drawing.maps;
  ASSERT_FALSE(inwardCorners(drawing).empty());
  std::string figures;
  for (const DartMode mode : { DartMode::Local, DartMode::Published })
  {
    const std::vector<double> radii = radiiOf(drawing, mode);
    int count = 0, pixels = 0;
    for (const unsigned int seed : { 1u, 2u, 3u })
    {
      struct Dart
      {
        Vector2 place;
        double radius;
        int object;
      };
      std::vector<Dart> darts;
      for (const Vector2& world : throwDarts(maps, drawing.lines(), mode, seed, Context()))
      {
        const Vector2 p = maps.frame.toPixels(world);
        const std::size_t i =
          maps.frame.index(static_cast<int>(std::lround(p[0])), static_cast<int>(std::lround(p[1])));
        EXPECT_GT(radii[i], 0.0);
        darts.push_back({ p, radii[i], maps.object[i] });
      }
      for (std::size_t i = 0; i < darts.size(); ++i)
      {
        for (std::size_t j = 0; j < i; ++j)
        {
          EXPECT_TRUE(
            darts[i].object != darts[j].object ||
            (darts[i].place - darts[j].place).norm() >= std::max(darts[i].radius, darts[j].radius) - 1e-9);
        }
      }
      for (int y = 0; y < maps.frame.height; ++y)
      {
        for (int x = 0; x < maps.frame.width; ++x)
        {
          const std::size_t i = maps.frame.index(x, y);
          if (radii[i] < 0.0)
          {
            continue;
          }
          ++pixels;
          EXPECT_TRUE(std::any_of(darts.begin(),
            darts.end(),
            [&](const Dart& dart)
            {
              return dart.object == maps.object[i] &&
                     (dart.place - Vector2(x, y)).norm() < std::max(dart.radius, radii[i]) + 1e-9;
            }));
        }
      }
      count += static_cast<int>(darts.size());
    }
    figures += (figures.empty() ? "local: " : "; published: ") + std::to_string(count) +
               " darts of 3 seeds keep their distances, none of " + std::to_string(pixels) +
               " pixels is left";
  }
  fact("C8_1", figures);
}

TEST(C8_2, ADiscHasOneDart)
{
  double off = 0.0, published = 0.0;
  std::set<std::size_t> counts;
  for (const double radius : { 100.0, 173.3, 250.0, 400.0 })
  {
    const UnitDrawing drawing({ circleStroke(0.5, 0.5, radius / 1024.0) });
    for (unsigned int seed = 0; seed < 25; ++seed)
    {
      const auto darts = throwDarts(drawing.maps, drawing.lines(), DartMode::Local, seed, Context());
      ASSERT_EQ(darts.size(), 1u);
      const double distance = 1024.0 * (darts[0] - Vector2(0.5, 0.5)).norm();
      EXPECT_LE(distance, 0.3 * radius + 3.0);
      off = std::max(off, distance / radius);
      const auto others = throwDarts(drawing.maps, drawing.lines(), DartMode::Published, seed, Context());
      EXPECT_GE(others.size(), 1u);
      EXPECT_LE(others.size(), 7u);
      counts.insert(others.size());
      for (const Vector2& dart : others)
      {
        const double there = 1024.0 * (dart - Vector2(0.5, 0.5)).norm();
        EXPECT_LE(there, 0.5 * radius + 1.5); // T is up to 1.5 px less than the distance to the circle
        published = std::max(published, there / radius);
      }
    }
  }
  fact("C8_2",
    "discs of 100 to 400 px, 100 seeds: 1 dart, up to " + digits(off) +
      " R off the centre; published: " + std::to_string(*counts.begin()) + " to " +
      std::to_string(*counts.rbegin()) + " darts, up to " + digits(published) + " R off");
}

TEST(C8_3, ASeedGivesTheSameDarts)
{
  const UnitDrawing drawing = sketchOfTwo();
  const auto dartsOf = [&](unsigned int seed, const Context& context)
  { return throwDarts(drawing.maps, drawing.lines(), DartMode::Local, seed, context); };
  const auto first = dartsOf(7, Context());
  EXPECT_EQ(dartsOf(7, Context()), first);
  EXPECT_EQ(dartsOf(7, twoThreads()), first);
  EXPECT_NE(dartsOf(8, Context()), first);
  // Strokes in another order: the objects' numbers change, the darts do not.
  const std::vector<DrawnStroke>& s = drawing.strokes;
  const UnitDrawing other(
    { s[3], s[2], s[1], s[0] }, { Treatment::Fill, Treatment::Fill, Treatment::Hole, Treatment::Fill });
  EXPECT_EQ(throwDarts(other.maps, other.lines(), DartMode::Local, 7, Context()), first);
  EXPECT_TRUE(throwDarts(drawing.maps, drawing.lines(), DartMode::Off, 7, Context()).empty());
  fact("C8_3",
    "seed 7: the same " + std::to_string(first.size()) +
      " darts again, on two threads and with the strokes turned round");
}

TEST(Darts, AreCloserBesideShortPieces)
{
  // A feature 4 px inside a ball's rim: both have short pieces there, so that they do not meet.
  const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.3), circleStroke(0.5, 0.5, 0.296) });
  const std::vector<StrokeLine> lines = drawing.lines();
  const std::vector<Vector2> darts = throwDarts(drawing.maps, lines, DartMode::Local, 1, Context());
  const PlanarMesh mesh = triangulate(lines, darts, Context());
  std::vector<double> least;
  for (const PlanarFace& face : mesh.faces)
  {
    double angle = 180.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vector2& at = mesh.points[face.corners[k]].place;
      const Vector2 u = mesh.points[face.corners[(k + 1) % 3]].place - at,
                    v = mesh.points[face.corners[(k + 2) % 3]].place - at;
      angle = std::min(angle, std::atan2(u[0] * v[1] - u[1] * v[0], u.dot(v)) * 360.0 / turn);
    }
    const auto isDart = [&](int corner)
    { return corner >= 0 && mesh.points[corner].kind == BoundaryKind::Interior; };
    if (std::any_of(face.corners.begin(), face.corners.end(), isDart))
    {
      least.push_back(angle);
    }
  }
  ASSERT_GE(least.size(), 10u);
  std::nth_element(least.begin(), least.begin() + least.size() / 2, least.end());
  EXPECT_GE(least[least.size() / 2], 25.0); // one dart in the middle was the tip of needles
}

TEST(Darts, StopWhenAsked)
{
  const UnitDrawing drawing({ circleStroke(0.5, 0.5, 0.4) });
  Context cancelled;
  cancelled.cancelled = [] { return true; };
  EXPECT_THROW(throwDarts(drawing.maps, drawing.lines(), DartMode::Local, 1, cancelled), Error);
  EXPECT_TRUE(throwDarts(distanceMaps(pixelFrame(40, 40), {}, ThicknessMode::Local, Context()),
    {},
    DartMode::Published,
    1,
    Context())
                .empty());
}
