// Facts of editors.md, section 13, profile: what a new profile does.
#include "Section/profile.h"

#include "Harness/section_shapes.h"
#include "Harness/threads.h"
#include "Mesh/context.h"
#include "Stroke/resketch.h"

#include <gtest/gtest.h>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

bool still(const std::vector<Vector3>& moves)
{
  return std::all_of(moves.begin(), moves.end(), [](const Vector3& d) { return d == Vector3::Zero(); });
}

// The greatest and the mean distance of a cross-section of the moved mesh to the profile, in mean edges.
struct Gap
{
  double most = 0.0, mean = 0.0;
};
Gap gapOf(const Profiled& p,
  const FlatProfile& profile,
  const Polyline& target,
  const std::vector<Vector3>& moves)
{
  const double edge = p.scene.meanEdge() / profile.toWorld.col(0).norm();
  const NearestPlace nearest(target);
  const Section section = p.section(movedBy(p.scene.mesh, moves));
  Gap gap;
  for (const Vector3& point : section.points)
  {
    const double distance = nearest(p.flatPoint(profile, point)).distance / edge;
    gap.most = std::max(gap.most, distance);
    gap.mean += distance / static_cast<double>(section.points.size());
  }
  return gap;
}

int newFolds(const Mesh& before, const Mesh& after)
{
  int folds = 0;
  const Adjacency links = buildAdjacency(before);
  for (const MeshEdge& e : links.edges)
  {
    if (e.triangleCount == 2)
    {
      const int a = links.edgeTriangles[e.firstTriangle], b = links.edgeTriangles[e.firstTriangle + 1];
      folds += facetNormal(after, a).dot(facetNormal(after, b)) < -0.5 &&
                   facetNormal(before, a).dot(facetNormal(before, b)) >= -0.5
                 ? 1
                 : 0;
    }
  }
  return folds;
}

} // namespace

TEST(B8_3, TheMeshMatchesTheProfile)
{
  const Profiled p(sphereScene(40, 128, 0.3));
  const FlatProfile profile = p.flat(p.section());
  EXPECT_TRUE(still(p.moves(profile, p.change(profile, profile.points))));

  // 0.2 of the radius at the top.
  Polyline drawn = profile.points;
  for (std::size_t i = 0; i < drawn.size(); ++i)
  {
    drawn[i][1] += 0.2 / profile.toWorld.col(1).norm() * std::sin(pi * profile.t[i]);
  }
  const std::vector<Vector3> moves = p.moves(profile, p.change(profile, drawn));
  const Gap bump = gapOf(p, profile, drawn, moves);
  EXPECT_LT(bump.most, 0.1);
  for (int v = 0; v < p.scene.mesh.vertexCount(); ++v)
  {
    if (p.scene.region[v] != 2)
    {
      ASSERT_EQ(moves[v], Vector3::Zero());
    }
  }

  // An S: several arms cross the plane.
  const Profiled s(letterScene(80), 0.5);
  const FlatProfile old = s.flat(s.section());
  Gap worst;
  int folds = 0;
  for (const Vector2& way : { Vector2(0.0, 1.0), Vector2(0.6, 1.0) })
  {
    Polyline raised = old.points;
    const double height = 0.4 * 0.5; // of half the width
    for (std::size_t i = 0; i < raised.size(); ++i)
    {
      const double l2 = std::min(1.0, old.beside[i] * old.beside[i]);
      raised[i] += height * (1.0 - l2) * (1.0 - l2) * way;
    }
    const std::vector<Vector3> there = s.moves(old, s.change(old, raised));
    const Gap gap = gapOf(s, old, raised, there);
    worst.mean = std::max(worst.mean, gap.mean);
    worst.most = std::max(worst.most, gap.most);
    folds += newFolds(s.scene.mesh, movedBy(s.scene.mesh, there));
  }
  EXPECT_LT(worst.mean, 0.4);
  EXPECT_LE(folds, 5);
  fact("B8_3",
    "the same profile moves nothing; a bump of 0.2 on a sphere is met within " + std::to_string(bump.most) +
      " mean edges, an S raised by 0.4 of its half width on average within " + std::to_string(worst.mean) +
      ", " + std::to_string(folds) + " edges folded");
}

TEST(Profile, IsFlatAndWithinItsUnit)
{
  for (const double t : { 0.2, 0.5, 0.71 })
  {
    const Profiled p(sphereScene(30, 96, 0.3), t);
    const Section section = p.section();
    const FlatProfile profile = p.flat(section);
    EXPECT_EQ(profile.points.front(), Vector2::Zero());
    EXPECT_NEAR(profile.points.back()[1], 0.0, 1e-12);
    Eigen::AlignedBox2d box;
    double off = 0.0;
    const double edge = p.scene.meanEdge();
    for (std::size_t i = 0; i < profile.points.size(); ++i)
    {
      const Vector2& q = profile.points[i];
      box.extend(q);
      const Vector3 world = (profile.toWorld * Eigen::Vector4d(q[0], q[1], 0.0, 1.0)).head<3>();
      off = std::max(off, std::abs(world.norm() - 1.0));
      EXPECT_GE(q[1], -1e-12); // outward is up
      EXPECT_TRUE(i == 0 ? profile.t[i] == 0.0 : profile.t[i] > profile.t[i - 1]);
    }
    EXPECT_NEAR(box.sizes().maxCoeff(), 1.0, 1e-12);
    EXPECT_EQ(profile.t.back(), 1.0);
    EXPECT_LT(off, 0.1 * edge); // the spline keeps to the surface
    EXPECT_NEAR(profile.beside.front(), -1.0, 1e-12);
    EXPECT_NEAR(profile.beside.back(), 1.0, 1e-12);
    const Vector3 back = (profile.toWorld * Eigen::Vector4d(0.0, 0.0, 0.0, 1.0)).head<3>();
    EXPECT_EQ(back, section.points.front());
  }
}

TEST(Profile, AResketchMovesWhatItRedraws)
{
  const Profiled p(sphereScene(30, 96, 0.3));
  const FlatProfile profile = p.flat(p.section());
  // A bump over a part of the right half.
  Polyline stroke;
  for (int i = 0; i <= 40; ++i)
  {
    const double x = 0.65 + 0.15 * i / 40.0;
    stroke.emplace_back(x, 0.33 + 0.1 * std::sin(pi * i / 40.0));
  }
  ResketchRules rules;
  rules.spacing = 0.005;
  rules.reach = 1.0;
  const Resketched fresh = resketch(profile.points, stroke, rules);
  std::vector<double> source;
  for (const Origin& origin : fresh.origins)
  {
    source.push_back(origin.before.of(profile.t));
  }
  const ProfileChange change(profile, p.flatPoint(profile, p.frame.origin), fresh.points, source);
  const std::vector<Vector3> moves = p.moves(profile, change);
  int moved = 0;
  for (int v = 0; v < p.scene.mesh.vertexCount(); ++v)
  {
    const bool left = p.scene.side[v] * p.scene.distance[v] < -0.05 && p.scene.parameter[v] > 0.3 &&
                      p.scene.parameter[v] < 0.7;
    EXPECT_TRUE(!left || moves[v] == Vector3::Zero()) << v;
    moved += moves[v] != Vector3::Zero() ? 1 : 0;
  }
  EXPECT_GT(moved, 100);
  EXPECT_LT(gapOf(p, profile, change.target(), moves).most, 0.3); // a re-sketch has corners
}

TEST(Profile, EndsAreDrawnToTheOldOnes)
{
  const Profiled p(sphereScene(20, 64));
  const FlatProfile profile = p.flat(p.section());
  Polyline lifted = profile.points;
  for (Vector2& point : lifted)
  {
    point += Vector2(0.05, 0.3);
  }
  const ProfileChange change = p.change(profile, lifted);
  EXPECT_EQ(change.target().front(), profile.points.front());
  EXPECT_EQ(change.target().back(), profile.points.back());
  EXPECT_EQ(change.at(-1.0), Vector2::Zero());
  EXPECT_EQ(change.at(1.0), Vector2::Zero());
  EXPECT_EQ(change.at(7.0), Vector2::Zero());
  EXPECT_LT((change.at(0.0) - Vector2(0.05, 0.3)).norm(), 1e-12);
  EXPECT_LT((change.at(0.7) - Vector2(0.05, 0.3)).norm(), 1e-12);
}

TEST(Profile, OnlyWhatIsMetBeforeAnotherArmCounts)
{
  // The way beside the curve: to 0.8, back to 0.2 beside another arm, and on to the boundary.
  FlatProfile profile;
  std::vector<double> beside{ -1.0, -0.5, 0.0, 0.4, 0.8, 0.5, 0.2, 0.6, 1.0 };
  for (int i = 0; i <= 8; ++i)
  {
    profile.points.emplace_back(i / 8.0, 0.0);
    profile.t.push_back(i / 8.0);
  }
  profile.beside = beside;
  Polyline drawn = profile.points;
  for (std::size_t i = 1; i + 1 < drawn.size(); ++i)
  {
    drawn[i][1] = 0.1 * static_cast<double>(i);
  }
  const ProfileChange change(profile, { 0.25, 0.0 }, drawn, profile.t);
  EXPECT_NEAR(change.at(0.4)[1], 0.3, 1e-12);
  EXPECT_NEAR(change.at(0.8)[1], 0.4, 1e-12);
  EXPECT_NEAR(change.at(0.9)[1], 0.2, 1e-12); // runs out
  EXPECT_NEAR(change.at(-0.5)[1], 0.1, 1e-12);
}

// As the plane slides, what is kept of boundary and spline changes no bit; and control points are where a
// search for each would have them.
TEST(ProfileFit, WhatIsKeptChangesNoBit)
{
  const Profiled first(sphereScene(24, 96, 0.3), 0.5);
  const Sectioner sectioner(first.scene.mesh, first.links, first.scene.boundary);
  ProfileFit fit;
  for (const double t : { 0.5, 0.3, 0.7, 0.31 })
  {
    const Profiled p(first.scene, t);
    const Section kept = sectioner.at(p.frame, p.start), anew = p.section();
    ASSERT_GT(kept.points.size(), 10u);
    EXPECT_EQ(kept.points, anew.points);
    EXPECT_EQ(kept.places, anew.places);
    const std::vector<double> beside(kept.points.size(), 0.5);
    const FlatProfile flat = fit.flat(kept.points, beside, kept.normal, p.frame.outward);
    const FlatProfile again = ProfileFit().flat(anew.points, beside, anew.normal, p.frame.outward);
    EXPECT_EQ(flat.points, again.points);
    EXPECT_EQ(flat.t, again.t);
    EXPECT_EQ(flat.toWorld, again.toWorld);
    std::vector<double> lengths{ 0.0 };
    for (std::size_t i = 1; i < kept.points.size(); ++i)
    {
      lengths.push_back(lengths.back() + (kept.points[i] - kept.points[i - 1]).norm());
    }
    const int count = static_cast<int>(lengths.size()), steps = 2 * count;
    const std::vector<Blend> places = evenPlaces(lengths, count, steps);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(steps) + 1);
    for (int i = 0; i <= steps; ++i)
    {
      const Blend place = placeAt(lengths, count, lengths.back() * i / steps);
      EXPECT_TRUE(places[i].from == place.from && places[i].to == place.to && places[i].t == place.t) << i;
    }
  }
}

TEST(Profile, WhatIsNoneIsRefused)
{
  const Profiled p(sphereScene(12, 48));
  const FlatProfile profile = p.flat(p.section());
  const auto refused = [&](const Polyline& drawn, const std::vector<double>& source, const std::string& words)
  {
    try
    {
      const ProfileChange change(profile, Vector2::Zero(), drawn, source);
      ADD_FAILURE() << words;
    }
    catch (const Error& error)
    {
      EXPECT_EQ(error.failure(), Failure::BadStroke);
      EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
  };
  const double nan = std::nan("");
  refused({}, {}, "fewer than two points");
  refused({ { 0, 0 } }, { 0.0 }, "fewer than two points");
  refused({ { 0, 0 }, { 1, nan } }, { 0.0, 1.0 }, "Point 1 of the new profile is not finite");
  refused({ { 0, 0 }, { 1, 0 } }, { 0.0, nan }, "Point 1 of the new profile comes from a place outside");
  refused({ { 0, 0 }, { 1, 0 } }, { -0.5, 1.0 }, "Point 0 of the new profile comes from a place outside");
  refused({ { 0, 0 }, { 1, 0 }, { 2, 0 } },
    { 0.0, 1.0, 0.5 },
    "Point 2 of the new profile comes from a place before");
  EXPECT_THROW(ProfileFit().flat({}, {}, Vector3::UnitX(), Vector3::UnitZ()), Error);
  EXPECT_THROW(ProfileFit().flat(
                 { { 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 0 } }, { 0, 0, 0 }, Vector3::UnitX(), Vector3::UnitZ()),
    Error);
  // One that turns back in the plane is fine.
  Polyline loop{ { 0, 0 }, { 0.9, 0.2 }, { 0.1, 0.3 }, { 1.0, 0.0 } };
  EXPECT_NO_THROW(ProfileChange(profile, Vector2::Zero(), loop, { 0.0, 0.4, 0.6, 1.0 }));
}
