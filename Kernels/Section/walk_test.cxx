// Facts of editors.md, section 13, profile: the cross-section.
#include "Section/walk.h"

#include "Harness/section_shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

double lengthOf(const std::vector<Vector3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

// A boundary like a clover with uneven leaves; the plane at 0.8 meets it four times.
EditScene clover()
{
  return sphereScene(
    24, 96, 0.3, [](double round) { return 0.8 * (1.0 + 0.3 * std::cos(4.0 * round + 0.5)); });
}

// Where the plane meets the boundary, by the frame's side, ascending.
std::vector<double> meetings(const Profiled& p)
{
  std::vector<double> found;
  const std::vector<int>& chain = p.scene.boundary;
  for (std::size_t i = 0; i < chain.size(); ++i)
  {
    const Vector3 a = p.scene.mesh.points[chain[i]], b = p.scene.mesh.points[chain[(i + 1) % chain.size()]];
    const double ha = p.frame.along.dot(a - p.frame.origin), hb = p.frame.along.dot(b - p.frame.origin);
    if ((ha >= 0.0) != (hb >= 0.0))
    {
      found.push_back(p.frame.side.dot(a + ha / (ha - hb) * (b - a)));
    }
  }
  std::sort(found.begin(), found.end());
  return found;
}

void expectRefused(const std::function<void()>& run, Failure failure, const std::string& words)
{
  try
  {
    run();
    ADD_FAILURE() << "not refused: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), failure);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(B8_2, TheSectionRunsFromBoundaryToBoundary)
{
  double off = 0.0, shortest = 1e9, longest = 0.0;
  // Through vertices and along edges, and through faces.
  for (const double uneven : { 0.0, 0.3 })
  {
    const Profiled p(sphereScene(30, 96, uneven));
    const Section section = p.section();
    ASSERT_GT(section.points.size(), 30u);
    for (const Vector3& point : section.points)
    {
      off = std::max(off, std::abs(point[0]));
    }
    const double length = lengthOf(section.points);
    shortest = std::min(shortest, length);
    longest = std::max(longest, length);
    for (std::size_t i = 1; i < section.points.size(); ++i)
    {
      EXPECT_GT(section.points[i][1], section.points[i - 1][1]); // ordered from left to right
    }
    EXPECT_NEAR(section.points.front()[2], 0.5, 1e-12);
    EXPECT_NEAR(section.points.back()[2], 0.5, 1e-12);
    for (std::size_t i = 0; i < section.points.size(); ++i)
    {
      EXPECT_LT((section.places[i].of(p.scene.mesh.points) - section.points[i]).norm(), 1e-15);
    }
  }
  EXPECT_LT(off, 1e-9);
  EXPECT_LE(longest, 2.0 * pi / 3.0);
  EXPECT_GT(shortest, 0.99 * 2.0 * pi / 3.0);

  const Profiled star(clover(), 0.8);
  const std::vector<double> met = meetings(star);
  ASSERT_EQ(met.size(), 4u);
  SectionRules outermost;
  outermost.ends = SectionRules::Ends::Outermost;
  outermost.halfSize = boundingDiagonal(star.scene.mesh);
  const Section inner = star.section(), outer = star.section(outermost);
  EXPECT_NEAR(outer.points.front().dot(star.frame.side), met.front(), 1e-12);
  EXPECT_NEAR(outer.points.back().dot(star.frame.side), met.back(), 1e-12);
  // The next ones on either side of the curve, which is in y = 0.
  EXPECT_NEAR(inner.points.front().dot(star.frame.side), met[0], 1e-12);
  EXPECT_NEAR(inner.points.back().dot(star.frame.side), met[1], 1e-12);
  EXPECT_LT(met[0], 0.0);
  EXPECT_GT(met[1], 0.0);
  fact("B8_2",
    "section within " + std::to_string(off * 1e15) + "e-15 of x = 0, " + std::to_string(shortest) + " to " +
      std::to_string(longest) +
      " long, from z = 0.5 to z = 0.5, in order; of four meetings the outer two as published, those next to "
      "the curve by default");
}

TEST(Walk, RunsToTheOtherSideWhereTheViewHasThatRight)
{
  const Profiled p(sphereScene(12, 48, 0.3), 0.37);
  SectionRules turned;
  turned.right = -p.frame.side + 3.0 * p.frame.along;
  const Section one = p.section(), other = p.section(turned);
  EXPECT_EQ(std::vector<Vector3>(other.points.rbegin(), other.points.rend()), one.points);
}

TEST(Walk, InThePlaneThroughTheCentreBothEndsAreTheSame)
{
  // The section in x = 0 goes through the sphere's centre: the same plane. Off the middle of a clover it is
  // another one, which joins the same ends.
  SectionRules published;
  published.ends = SectionRules::Ends::Outermost;
  published.plane = SectionRules::Plane::Centre;
  published.halfSize = 4.0;
  const Profiled middle(sphereScene(12, 48, 0.3));
  const Section there = middle.section(published), across = middle.section();
  EXPECT_NEAR(std::abs(there.normal[0]), 1.0, 1e-12);
  EXPECT_NEAR(lengthOf(there.points), lengthOf(across.points), 1e-9);
  published.centre = Vector3(0.3, 0.1, -0.2);
  const Section oblique = middle.section(published);
  EXPECT_LT((oblique.points.front() - across.points.front()).norm(), 1e-9);
  EXPECT_LT((oblique.points.back() - across.points.back()).norm(), 1e-9);
  EXPECT_GT(std::abs(oblique.points[oblique.points.size() / 2][0]), 0.01);
  for (const Vector3& point : oblique.points)
  {
    EXPECT_LT(std::abs((point - across.points.front()).dot(oblique.normal)), 1e-9);
  }
  published.centre = 0.5 * (across.points.front() + across.points.back());
  expectRefused([&] { middle.section(published); }, Failure::BadStroke, "lie on one line");
}

TEST(Walk, APlaneAlongFacesFollowsTheirEdges)
{
  // A flat strip with a ridge; the plane lies in the strip's vertical side wall's edge row y = const.
  const Mesh grid = gridSurface(
    8, 8, false, false, [](double u, double v) { return Vector3(8 * u, 8 * v, v == 0.5 ? 1.0 : 0.0); });
  const Adjacency links = buildAdjacency(grid);
  std::vector<int> ring;
  ring.reserve(32);
  for (int i = 0; i < 8; ++i)
    ring.push_back(i);
  for (int i = 0; i < 8; ++i)
    ring.push_back(9 * i + 8);
  for (int i = 8; i > 0; --i)
    ring.push_back(72 + i);
  for (int i = 8; i > 0; --i)
    ring.push_back(9 * i);
  const CurveFrame frame{ { 4, 4, 1 }, { 0, 1, 0 }, { -1, 0, 0 }, { 0, 0, 1 } };
  const Section section = Sectioner(grid, links, ring).at(frame, Binding::vertex(4 * 9 + 4));
  ASSERT_EQ(section.points.size(), 9u); // the row's vertices, one after the other
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(section.points[i], Vector3(8 - i, 4, 1));
    EXPECT_TRUE(section.places[i].onVertex());
  }
}

TEST(Walk, WhatHasNoSectionIsSaid)
{
  const Profiled p(sphereScene(12, 48, 0.3));
  std::vector<int> torn = p.scene.boundary;
  std::swap(torn[3], torn[20]);
  const auto with = [&](const std::vector<int>& boundary, const CurveFrame& frame, const SectionRules& rules)
  { return Sectioner(p.scene.mesh, p.links, boundary).at(frame, p.start, rules); };
  expectRefused(
    [&] { with(torn, p.frame, {}); }, Failure::BadStroke, "are not joined by an edge of the mesh");
  // A boundary that the plane does not meet: nothing, both ways.
  const auto aside = std::find_if(p.scene.mesh.triangles.begin(),
    p.scene.mesh.triangles.end(),
    [&](const Triangle& t)
    {
      return std::all_of(t.begin(), t.end(), [&](int v) { return p.scene.mesh.points[v][0] > 0.3; }) &&
             p.scene.mesh.points[t[0]][2] < -0.3;
    });
  ASSERT_NE(aside, p.scene.mesh.triangles.end());
  const std::vector<int> triangle(aside->begin(), aside->end());
  SectionRules outermost;
  outermost.ends = SectionRules::Ends::Outermost;
  outermost.halfSize = 4.0;
  EXPECT_TRUE(with(triangle, p.frame, {}).points.empty());
  EXPECT_TRUE(with(triangle, p.frame, outermost).points.empty());
  // A plane beside the surface.
  CurveFrame above = p.frame;
  above.along = Vector3::UnitZ();
  above.origin = Vector3(0, 0, 2);
  expectRefused([&] { with(p.scene.boundary, above, {}); }, Failure::BadStroke, "does not cut the surface");

  // An open mesh whose border comes before the boundary.
  Mesh open = p.scene.mesh;
  open.triangles.erase(std::remove_if(open.triangles.begin(),
                         open.triangles.end(),
                         [&](const Triangle& t)
                         {
                           const Vector3 m =
                             (open.points[t[0]] + open.points[t[1]] + open.points[t[2]]) / 3.0;
                           return m[2] > 0.0 && m[1] > 0.4 && m[1] < 0.6 && std::abs(m[0]) < 0.1;
                         }),
    open.triangles.end());
  const Adjacency links = buildAdjacency(open);
  expectRefused([&] { Sectioner(open, links, p.scene.boundary).at(p.frame, p.start); },
    Failure::BadMesh,
    "meets the mesh's border");
  // As published it is tried the other way round, over the far side of the sphere.
  const Section round = Sectioner(open, links, p.scene.boundary).at(p.frame, p.start, outermost);
  EXPECT_GT(lengthOf(round.points), 4.0 * pi / 3.0 * 0.98);
  // A fin along an edge of the way: three faces there.
  Mesh finned = p.scene.mesh;
  const Section way = p.section();
  const Binding& third = way.places[3];
  finned.points.emplace_back(0.0, 0.0, 3.0);
  finned.triangles.push_back({ third.vertices[0], third.vertices[1], finned.vertexCount() - 1 });
  const Adjacency finnedLinks = buildAdjacency(finned);
  expectRefused([&] { Sectioner(finned, finnedLinks, p.scene.boundary).at(p.frame, p.start); },
    Failure::BadMesh,
    "of more than two faces");
}
