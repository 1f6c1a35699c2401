// Facts of image-assisted.md, sections 12 to 14 and 17: the surfaces made of a drawing's mesh.
#include "Harness/inflation_chain.h"
#include "Harness/shapes.h"
#include "Harness/solid_shape.h"
#include "Inflate/solid.h"
#include "Inflate/swap_edges.h"
#include "Inflate/unstretch.h"
#include "Mesh/shape.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

const Vector2 centre(514.0, 514.0);

std::vector<Circle> concentric(BoundaryKind inner)
{
  std::vector<Circle> circles{
    { 200.0, BoundaryKind::Object }, { 150.0, BoundaryKind::Interior }, { 100.0, inner }
  };
  if (inner != BoundaryKind::Hole)
  {
    circles.push_back({ 50.0, BoundaryKind::Interior });
  }
  return circles;
}

// The same for quads alone: a ring of them has no centre.
PlanarMesh quadAnnulus(int levels)
{
  PlanarMesh mesh;
  const int spokes = 12;
  for (const double radius : { 200.0, 150.0, 100.0 })
  {
    for (int i = 0; i < spokes; ++i)
    {
      addPoint(mesh,
        centre + radius * Vector2(std::cos(turn * i / spokes), std::sin(turn * i / spokes)),
        radius == 200.0   ? BoundaryKind::Object
        : radius == 100.0 ? BoundaryKind::Hole
                          : BoundaryKind::Interior,
        radius == 200.0   ? 0
        : radius == 100.0 ? 1
                          : -1);
    }
  }
  for (int ring = 0; ring < 2; ++ring)
  {
    for (int i = 0; i < spokes; ++i)
    {
      const int outer = ring * spokes, next = (i + 1) % spokes;
      addFace(mesh, { outer + spokes + i, outer + i, outer + next, outer + spokes + next });
    }
  }
  for (int i = 0; i < spokes; ++i)
  {
    mesh.edges.push_back({ i, (i + 1) % spokes, 0, 0.0, 0.0 });
    mesh.edges.push_back({ 2 * spokes + i, 2 * spokes + (i + 1) % spokes, 1, 0.0, 0.0 });
  }
  return refined(mesh,
    levels,
    [](int stroke, const Vector2& place)
    { return Vector2(centre + (stroke == 0 ? 200.0 : 100.0) * (place - centre).normalized()); });
}

void expectClosed(const Shape& shape, int chi)
{
  EXPECT_EQ(shape.loops, 0);
  EXPECT_EQ(shape.odd, 0);
  EXPECT_EQ(shape.pinched, 0);
  EXPECT_EQ(shape.chi, chi);
  EXPECT_GT(shape.volume, 0.0);
}

std::string messageOf(const std::function<void()>& work)
{
  try
  {
    work();
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadMesh);
    return error.what();
  }
  return "nothing was refused";
}

void expectRefused(const std::function<void()>& work, const std::string& words)
{
  const std::string message = messageOf(work);
  EXPECT_NE(message.find(words), std::string::npos) << message;
}

double areaOf(const PlanarMesh& mesh)
{
  double area = 0.0;
  for (const PlanarFace& face : mesh.faces)
  {
    for (int k = 1; k + 1 < face.count(); ++k)
    {
      const Vector2 a = mesh.points[face.corners[0]].place, u = mesh.points[face.corners[k]].place - a,
                    v = mesh.points[face.corners[k + 1]].place - a;
      area += 0.5 * (u[0] * v[1] - u[1] * v[0]);
    }
  }
  return area;
}

// Of the region of the inner circle.
std::vector<char> inside(const Solid& solid, const PlanarMesh& mesh)
{
  std::vector<char> removed;
  for (const SolidFace& face : solid.faces)
  {
    removed.push_back(mesh.faces[face.source].region == 1);
  }
  return removed;
}

// The points over those that lie on a spoke of the mesh as it was.
double edgeRatioOfSpoke(const Solid& solid, const PlanarMesh& mesh)
{
  std::vector<std::pair<double, Vector3>> spoke;
  for (const SolidPoint& point : solid.points)
  {
    const Vector2 d = mesh.points[point.planar].place - centre;
    if (point.side >= 0 && std::abs(d[1]) < 1e-6 && d[0] > -1e-6)
    {
      spoke.emplace_back(d[0], point.place);
    }
  }
  std::sort(spoke.begin(), spoke.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  EXPECT_EQ(spoke.size(), 9u);
  double shortest = 1e9, longest = 0.0;
  for (std::size_t i = 1; i < spoke.size(); ++i)
  {
    shortest = std::min(shortest, (spoke[i].second - spoke[i - 1].second).norm());
    longest = std::max(longest, (spoke[i].second - spoke[i - 1].second).norm());
  }
  return longest / shortest;
}

} // namespace

TEST(C12_4, InflatedSurfacesAreClosedAndMirrored)
{
  int faces = 0;
  for (const int holes : { 0, 1 })
  {
    const std::vector<Circle> circles = concentric(holes == 1 ? BoundaryKind::Hole : BoundaryKind::Feature);
    Chain chain(rimsOf(centre, circles));
    std::vector<PlanarMesh> meshes{ disc(centre, circles, 12, 1), disc(centre, circles, 12, 3) };
    if (holes == 1)
    {
      meshes.push_back(quadAnnulus(2));
    }
    for (const PlanarMesh& mesh : meshes)
    {
      const Solid solid = chain.solid(mesh);
      expectClosed(shapeOf(solid), 2 - 2 * holes);
      EXPECT_EQ(solid.faces.size(), 2 * mesh.faces.size());
      faces += static_cast<int>(solid.faces.size());
      std::vector<const SolidPoint*> fronts(mesh.points.size(), nullptr);
      for (const SolidPoint& point : solid.points)
      {
        EXPECT_EQ(point.side == 0, isRim(mesh.points[point.planar].kind));
        if (point.side >= 0)
        {
          fronts[point.planar] = &point;
        }
        else
        {
          ASSERT_NE(fronts[point.planar], nullptr);
          EXPECT_EQ(Vector3(point.place.cwiseProduct(Vector3(1, 1, -1))), fronts[point.planar]->place);
        }
      }
    }
  }
  fact("C12_4",
    "disc, annulus, of triangles and of quads, " + std::to_string(faces) +
      " faces: each edge in two, links single cycles, outward, chi 2 and 0, z mirrored to the bit");
}

TEST(C12_5, InsertedPointsAreRegular)
{
  const auto irregular = [](const Solid& solid, int regular)
  {
    const Shape shape = shapeOf(solid);
    int count = 0;
    for (std::size_t i = 0; i < solid.points.size(); ++i)
    {
      count += !solid.points[i].isBase && shape.valence.at(static_cast<int>(i)) != regular;
    }
    return count;
  };
  const PlanarMesh mesh = square(400.0, false, 2);
  const std::vector<double> ones(mesh.points.size(), 1.0);
  const Solid solid = inflate(mesh, ones);
  const Shape shape = shapeOf(solid);
  EXPECT_EQ(shape.triangles, 128);
  EXPECT_EQ(shape.points, 66);
  expectClosed(shape, 2);
  EXPECT_EQ(irregular(solid, 6), 0);
  const std::vector<Circle> circles = concentric(BoundaryKind::Hole);
  const PlanarMesh ring = disc(centre, circles, 12, 3);
  EXPECT_EQ(irregular(inflate(ring, std::vector<double>(ring.points.size(), 1.0)), 6), 0);
  const PlanarMesh quads = quadAnnulus(2);
  EXPECT_EQ(irregular(inflate(quads, std::vector<double>(quads.points.size(), 1.0)), 4), 0);
  fact("C12_5", "square, k = 2: 128 triangles, 66 vertices; all inserted vertices have 6 edges, of quads 4");
}

TEST(Inflate, RefusesWhatCannotBeSealed)
{
  const auto made = [](const PlanarMesh& mesh)
  { return [&mesh] { inflate(mesh, std::vector<double>(mesh.points.size(), 1.0)); }; };
  PlanarMesh mesh = square(4.0, true, 0);
  expectRefused(made(square(4.0, true, 0)), "of rims at opposite corners"); // two faces back to back
  mesh = rectangle(Vector2::Zero(), Vector2(4, 2), 2, 1, true, 0);
  expectRefused(made(mesh), "joins two points of rims inside the planar mesh");
  expectRefused(
    made(rectangle(Vector2::Zero(), Vector2(4, 2), 2, 1, true, 1)), "of rims at opposite corners");
  mesh = square(4.0, false, 1);
  mesh.points[4].kind = BoundaryKind::Hole; // the centre
  expectRefused(made(mesh), "trim the holes");
  mesh = square(4.0, false, 1);
  mesh.points[0].kind = BoundaryKind::TunnelRim;
  expectRefused(made(mesh), "a tunnel is cut out of the surface");
  mesh = square(4.0, false, 1);
  mesh.faces.push_back(mesh.faces[0]);
  expectRefused(made(mesh), "more than two faces");
  mesh = square(4.0, false, 1);
  mesh.faces[3].corners[1] = 99;
  expectRefused(made(mesh), "Face 3 has a corner that is no point");
}

TEST(C13_1, AnExtrusionsVolumeIsThatOfAPrism)
{
  double off = 0.0;
  for (const WallRows rows : { WallRows::Refined, WallRows::One })
  {
    for (const PlanarMesh& mesh : { square(3.0, false, 3),
           square(3.0, true, 2),
           disc(centre, concentric(BoundaryKind::Hole), 12, 2),
           disc(centre, concentric(BoundaryKind::TunnelRim), 9, 2),
           quadAnnulus(1) })
    {
      for (const double depth : { 0.3, 40.0 })
      {
        const double volume = shapeOf(extrude(mesh, depth, rows)).volume;
        off = std::max(off, std::abs(volume / (2.0 * depth * areaOf(mesh)) - 1.0));
      }
    }
  }
  EXPECT_LE(off, 1e-9);
  fact("C13_1", "squares, disc, annuli, two depths: volume / (2 depth area) - 1 up to " + digits(off));
}

TEST(C13_2, ASquareTwiceRefinedHas256Triangles)
{
  const double depth = 0.7;
  const Solid solid = extrude(square(3.0, false, 2), depth, WallRows::Refined);
  const Shape shape = shapeOf(solid);
  expectClosed(shape, 2);
  EXPECT_EQ(shape.triangles, 256);
  EXPECT_EQ(shape.points, 130);
  std::map<double, int> levels;
  for (const SolidPoint& point : solid.points)
  {
    ++levels[point.place[2]];
  }
  ASSERT_EQ(levels.size(), 5u);
  int r = -2;
  for (const auto& [z, count] : levels)
  {
    EXPECT_NEAR(z, depth * r++ / 2.0, 1e-15);
  }
  fact("C13_2", "square, k = 2: 256 triangles, 130 vertices, 5 equally spaced z");
}

TEST(C13_3, ExtrusionsAreRegularAndHolesHaveWalls)
{
  for (const bool quads : { false, true })
  {
    const PlanarMesh mesh = quads ? quadAnnulus(2) : disc(centre, concentric(BoundaryKind::Hole), 12, 2);
    const Solid solid = extrude(mesh, 30.0, WallRows::Refined);
    const Shape shape = shapeOf(solid);
    expectClosed(shape, 0);
    EXPECT_EQ(quads ? shape.triangles : shape.quads, 0);
    std::size_t walls = 0;
    for (std::size_t i = 0; i < solid.points.size(); ++i)
    {
      walls += solid.points[i].side == 0;
      if (!solid.points[i].isBase)
      {
        EXPECT_EQ(shape.valence.at(static_cast<int>(i)), quads ? 4 : 6);
      }
    }
    EXPECT_EQ(walls, 2u * 12u * 4u * 3u);
    expectClosed(shapeOf(extrude(mesh, 30.0, WallRows::One)), 0);
  }
  fact("C13_3", "annulus: chi 0, all inserted vertices have 6 edges, of quads 4");
}

TEST(C13_4, WallsAreRefinedAsTheMesh)
{
  std::string counts;
  for (const int k : { 0, 1, 2 })
  {
    for (const bool quads : { false, true })
    {
      for (const WallRows rows : { WallRows::Refined, WallRows::One })
      {
        const Solid solid = extrude(square(3.0, quads, k), 1.0, rows);
        const auto walls = std::count_if(
          solid.faces.begin(), solid.faces.end(), [](const SolidFace& face) { return face.side == 0; });
        const int across = 1 << k, down = rows == WallRows::One ? 1 : across;
        EXPECT_EQ(walls, 4 * (quads ? 1 : 2) * across * down);
        counts += !quads && rows == WallRows::Refined ? " " + std::to_string(walls / 4) : "";
      }
    }
  }
  fact(
    "C13_4", "wall faces for each base border edge, k = 0, 1, 2:" + counts + "; quads half; one row 2 2^k");
}

TEST(Extrude, RefusesNoDepthAndUnknownBases)
{
  PlanarMesh mesh = square(3.0, false, 2);
  for (const double depth : { 0.0, -1.0, std::nan("") })
  {
    EXPECT_THROW(extrude(mesh, depth, WallRows::Refined), Error);
  }
  mesh.points[1].isBase = false;
  expectRefused([&] { extrude(mesh, 1.0, WallRows::Refined); }, "IsBaseVertex");
  for (PlanarPoint& point : mesh.points)
  {
    point.isBase = false;
  }
  expectRefused([&] { extrude(mesh, 1.0, WallRows::Refined); }, "has no point of the coarse mesh");
  expectClosed(shapeOf(extrude(mesh, 1.0, WallRows::One)), 2);
}

TEST(C14_1, AHoleIsSealedAtItsRim)
{
  const std::vector<Circle> circles = concentric(BoundaryKind::Hole);
  const PlanarMesh mesh = disc(centre, circles, 24, 3);
  Chain chain(rimsOf(centre, circles));
  const Solid solid = chain.solid(mesh);
  expectClosed(shapeOf(solid), 0);
  double peak = 0.0;
  int rim = 0;
  for (const SolidPoint& point : solid.points)
  {
    peak = std::max(peak, point.place[2]);
    if (mesh.points[point.planar].kind == BoundaryKind::Hole)
    {
      EXPECT_EQ(point.place[2], 0.0);
      ++rim;
    }
  }
  EXPECT_EQ(rim, 24 * 8);
  EXPECT_NEAR(peak, 50.0, 2.0);
  fact("C14_1", "circles 200 / 100 px, a hole: rim at z = 0, peak " + digits(peak) + " px, closed, chi 0");
}

TEST(C14_2, ATunnelsRimStandsWhereItWould)
{
  const std::vector<Circle> circles = concentric(BoundaryKind::TunnelRim);
  const PlanarMesh mesh = disc(centre, circles, 12, 3);
  Chain chain(rimsOf(centre, circles));
  EXPECT_EQ(chain.maps.distance, Chain(rimsOf(centre, concentric(BoundaryKind::Feature))).maps.distance);
  const Solid whole = chain.solid(mesh);
  const std::vector<char> removed = inside(whole, mesh);
  const Solid open = tunnel(whole, removed, false), walled = tunnel(whole, removed, true);
  const Shape shape = shapeOf(open);
  EXPECT_EQ(shape.loops, 2);
  EXPECT_EQ(shape.odd + shape.pinched, 0);
  EXPECT_EQ(shape.chi, 0);
  EXPECT_EQ(static_cast<std::size_t>(shape.points), open.points.size());
  expectClosed(shapeOf(walled), 0);
  EXPECT_EQ(walled.faces.size(), open.faces.size() + 12u * 2u * 64u);
  double least = 1e9, most = 0.0;
  const Shape closed = shapeOf(walled);
  for (std::size_t i = 0; i < walled.points.size(); ++i)
  {
    const SolidPoint& point = walled.points[i];
    if (mesh.points[point.planar].kind == BoundaryKind::TunnelRim && point.side != 0)
    {
      least = std::min(least, std::abs(point.place[2]));
      most = std::max(most, std::abs(point.place[2]));
    }
    if (!point.isBase)
    {
      EXPECT_EQ(closed.valence.at(static_cast<int>(i)), 6);
    }
  }
  EXPECT_NEAR(least, 173.2, 3.0);
  EXPECT_NEAR(most, 173.2, 3.0);
  fact("C14_2",
    "circles 200 / 100 px, a tunnel: T unchanged, rim at " + digits(least, 5) + " to " + digits(most, 5) +
      " px; without walls 2 loops, chi 0; with them closed, chi 0, inserted vertices with 6 edges");
}

TEST(C14_3, AFilledRegionIsPartOfTheSurface)
{
  const std::vector<Circle> circles = concentric(BoundaryKind::Feature);
  Chain chain(rimsOf(centre, circles));
  const PlanarMesh mesh = disc(centre, circles, 12, 2);
  expectClosed(shapeOf(chain.solid(mesh)), 2);
  expectClosed(shapeOf(extrude(mesh, 20.0, WallRows::Refined)), 2);
  fact("C14_3", "circles 200 / 100 px, filled: closed, chi 2, inflated and extruded");
}

TEST(Tunnel, GoesThroughExtrusionsAndRefusesRims)
{
  const PlanarMesh mesh = disc(centre, concentric(BoundaryKind::TunnelRim), 12, 2);
  Solid block = extrude(mesh, 30.0, WallRows::Refined);
  const std::vector<char> removed = inside(block, mesh);
  const Solid walled = tunnel(block, removed, true);
  expectClosed(shapeOf(walled), 0);
  EXPECT_NEAR(shapeOf(walled).volume, shapeOf(block).volume * (1.0 - 0.25), 1e-2 * shapeOf(block).volume);
  // The other region: it reaches the rim.
  std::vector<char> outer;
  outer.reserve(removed.size());
  for (const char each : removed)
  {
    outer.push_back(each == 0);
  }
  for (std::size_t f = 0; f < outer.size(); ++f)
  {
    outer[f] = outer[f] != 0 && block.faces[f].side != 0; // but for the walls
  }
  expectRefused([&] { tunnel(block, std::vector<char>(block.faces.size(), 1), true); }, "whole surface");
  std::vector<char> front = removed;
  for (std::size_t f = 0; f < front.size(); ++f)
  {
    front[f] = front[f] != 0 && block.faces[f].side > 0;
  }
  expectRefused([&] { tunnel(block, front, true); }, "other faces of the front than of the back");
  expectRefused([&] { tunnel(block, outer, true); }, "The tunnel");
  // Nothing to remove changes nothing.
  const Solid same = tunnel(block, std::vector<char>(block.faces.size(), 0), true);
  EXPECT_EQ(cornersOf(same.faces), cornersOf(block.faces));
  block.points[5].planar = -1;
  expectRefused([&] { tunnel(block, removed, true); }, "PlanarId");
}

TEST(C17_1, UnstretchedRimsEvenOutASpoke)
{
  const std::vector<Circle> circles{ { 400.0, BoundaryKind::Object } };
  const PlanarMesh mesh = disc(centre, circles, 8, 3);
  Chain chain(rimsOf(centre, circles));
  UnstretchReport report;
  const PlanarMesh moved = chain.withMaps(
    Context(), [&](const HeightMaps& maps) { return unstretch(mesh, maps, Context(), &report); });
  const double before = edgeRatioOfSpoke(chain.solid(mesh), mesh),
               after = edgeRatioOfSpoke(chain.solid(moved), mesh);
  EXPECT_GT(before, 3.5);
  EXPECT_LT(after, 2.0);
  expectClosed(shapeOf(chain.solid(moved)), 2);
  fact("C17_1",
    "a spoke of a disc, k = 3: longest to shortest edge " + digits(before) + ", unstretched " +
      digits(after));
}

TEST(Unstretch, TurnsNoFaceAndMovesNoStroke)
{
  for (const int kind : { 0, 1, 2 })
  {
    const std::vector<Circle> circles = concentric(kind == 0 ? BoundaryKind::Hole : BoundaryKind::Feature);
    const PlanarMesh mesh = kind == 2 ? rectangle(Vector2(114, 434), Vector2(800, 160), 20, 4, true, 2)
                                      : disc(centre, circles, 8, 3);
    Chain chain(kind == 2 ? std::vector<Rim>{ rectangleRim(Vector2(114, 434), Vector2(800, 160)) }
                          : rimsOf(centre, circles));
    UnstretchReport report;
    const auto work = [&](const Context& context)
    {
      return chain.withMaps(
        context, [&](const HeightMaps& maps) { return unstretch(mesh, maps, context, &report); });
    };
    const PlanarMesh moved = work(Context());
    EXPECT_GT(report.moved, 50);
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      if (mesh.points[i].kind != BoundaryKind::Interior)
      {
        EXPECT_EQ(moved.points[i].place, mesh.points[i].place);
      }
    }
    const PlanarMesh twice = work(twoThreads());
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
    {
      EXPECT_EQ(moved.points[i].place, twice.points[i].place);
    }
    for (const PlanarFace& face : moved.faces)
    {
      for (int k = 0; k < (face.count() == 3 ? 1 : 4); ++k)
      {
        const auto at = [&](int corner) { return moved.points[face.corners[corner % face.count()]].place; };
        const Vector2 u = at(k + 1) - at(k), v = at(k + 2) - at(k);
        EXPECT_GT(u[0] * v[1] - u[1] * v[0], 0.0);
      }
    }
  }
}

TEST(SwapEdges, TakeTheDiagonalAlongARoundRim)
{
  // On a half ball of radius 400 the diagonal from 398 px off its axis to 300 lies far below, that across
  // not.
  const std::vector<Circle> circles{ { 400.0, BoundaryKind::Object } };
  Chain chain(rimsOf(centre, circles), true);
  PlanarMesh mesh;
  for (const Vector2& place : { Vector2(398, 0), Vector2(300, 0), Vector2(360, 40), Vector2(360, -40) })
  {
    mesh.points.emplace_back();
    mesh.points.back().place = centre + place;
  }
  for (const std::array<int, 4>& corners : { std::array<int, 4>{ 0, 2, 1, -1 }, { 0, 1, 3, -1 } })
  {
    mesh.faces.emplace_back();
    mesh.faces.back().corners = corners;
    mesh.faces.back().object = 0;
  }
  const auto swapped = [&](PlanarMesh& given)
  {
    const std::vector<double> heights = chain.heights(given);
    return chain.withMaps(Context(),
      [&](const HeightMaps& maps) { return swapEdges(given, heights, maps, chain.section, 1.0, Context()); });
  };
  const auto has = [](const PlanarMesh& given, int a, int b)
  {
    return std::all_of(given.faces.begin(),
      given.faces.end(),
      [&](const PlanarFace& face)
      {
        const auto& c = face.corners;
        return std::find(c.begin(), c.end(), a) != c.end() && std::find(c.begin(), c.end(), b) != c.end();
      });
  };
  PlanarMesh stays = mesh;
  stays.points[0].kind = stays.points[1].kind = BoundaryKind::Feature;
  EXPECT_EQ(swapped(stays), 0); // an edge of a stroke
  EXPECT_TRUE(has(stays, 0, 1));
  EXPECT_EQ(swapped(mesh), 1);
  EXPECT_TRUE(has(mesh, 2, 3));
  for (const PlanarFace& face : mesh.faces)
  {
    const auto at = [&](int k) { return mesh.points[face.corners[k]].place; };
    EXPECT_GT(signedArea(at(0), at(1), at(2)), 0.0);
  }
  EXPECT_EQ(swapped(mesh), 0);
}
