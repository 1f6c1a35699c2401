// Bones and poses: what a limb is, how it bends, what stays, on a capsule that is seen from the side.
#include "Pose/pose.h"

#include "Harness/shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace oversketch;
using oversketch_test::capsule;
using oversketch_test::fact;
using oversketch_test::joined;
using oversketch_test::orthographicView;
using oversketch_test::perspectiveView;
using oversketch_test::pi;

namespace
{

constexpr double radius = 0.25, half = 2.0;

double volumeOf(const Mesh& mesh)
{
  double volume = 0.0;
  for (const Triangle& t : mesh.triangles)
  {
    volume += mesh.points[t[0]].dot(mesh.points[t[1]].cross(mesh.points[t[2]])) / 6.0;
  }
  return volume;
}

// The capsule from the front, 100 px a unit, its middle at (400, 300); a bone from there to the right.
struct Posing
{
  explicit Posing(const Mesh& shape = capsule(radius, half, 48, 121),
    const View& from = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0),
    const Polyline& line = { { 400, 300 }, { 620, 300 } })
    : mesh(shape)
    , adjacency(buildAdjacency(mesh))
    , view(from)
    , bone(boneUnder(SurfaceRays(std::make_shared<const Mesh>(mesh)), view, line))
    , limb(limbOf(mesh, adjacency, bone))
  {
  }
  Mesh posedAlong(const Polyline& course, const PoseOptions& options = {})
  {
    this->made = posed(
      valuesAt(this->mesh.points, this->limb.vertices), this->limb, this->bone, this->view, course, options);
    Mesh result = this->mesh;
    for (std::size_t i = 0; i < this->limb.vertices.size(); ++i)
    {
      result.points[this->limb.vertices[i]] = this->made.places[i];
    }
    return result;
  }

  Mesh mesh;
  Adjacency adjacency;
  View view;
  Bone bone;
  Limb limb;
  Posed made;
};

} // namespace

TEST(Bone, IsTheMiddleOfWhatItIsDrawnOver)
{
  const Posing posing(capsule(radius, half, 48, 121),
    orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0),
    { { 400, 310 }, { 700, 310 } }); // beside the axis, and beyond the tip
  for (std::size_t i = 0; i < posing.bone.places.size(); ++i)
  {
    EXPECT_NEAR(posing.bone.places[i][1], 0.1, 1e-9);
    EXPECT_NEAR(posing.bone.places[i][2], 0.0, 1e-3) << i;
  }
  EXPECT_NEAR(posing.bone.thickness.front(), 2.0 * std::sqrt(radius * radius - 0.01), 2e-3);
  EXPECT_LT(posing.bone.places.back()[0], half + radius);
  EXPECT_GT(posing.bone.places.back()[0], half);
  EXPECT_LT((posing.bone.across - Vector3(1, 0, 0)).norm(), 1e-3);
}

TEST(Bone, OfAModelTurnedInsideOutIsTheSame)
{
  Mesh turned = capsule(radius, half, 48, 121);
  for (Triangle& t : turned.triangles)
  {
    std::swap(t[0], t[1]);
  }
  const Posing posing, inside(turned);
  ASSERT_EQ(posing.bone.places.size(), inside.bone.places.size());
  for (std::size_t i = 0; i < posing.bone.places.size(); ++i)
  {
    EXPECT_LT((posing.bone.places[i] - inside.bone.places[i]).norm(), 1e-9);
  }
}

TEST(Limb, IsWhatTheSurfaceJoinsToTheTip)
{
  // A second capsule crosses the plane at the joint, too, and is nobody's.
  const Mesh one = capsule(radius, half, 48, 121);
  const Posing posing(joined(one, one, { 0.0, 1.0, 0.0 }));
  std::size_t beyond = 0;
  for (const Vector3& p : one.points)
  {
    beyond += p[0] > 0.0;
  }
  EXPECT_EQ(posing.limb.vertices.size(), beyond);
  for (std::size_t i = 0; i < posing.limb.vertices.size(); ++i)
  {
    const Vector3& p = posing.mesh.points[posing.limb.vertices[i]];
    EXPECT_GT(p[0], 0.0);
    EXPECT_LT(posing.limb.vertices[i], one.vertexCount());
    EXPECT_NEAR(posing.limb.parameter[i], std::min(p[0], 2.2), 0.02) << p.transpose();
  }
}

// From the torus' side the joint's plane cuts a ring that is whole all the same: half of it goes along.
TEST(Limb, OfARingEndsAtThePlane)
{
  const Posing posing(oversketch_test::torus(1.0, 0.25, 96, 32),
    orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0),
    { { 300, 301 }, { 301, 340 }, { 320, 370 } });
  EXPECT_NEAR(static_cast<double>(posing.limb.vertices.size()) / posing.mesh.vertexCount(), 0.5, 0.1);
  for (const int v : posing.limb.vertices)
  {
    EXPECT_GT(posing.bone.across.dot(posing.mesh.points[v] - posing.bone.places.front()), 0.0);
  }
}

TEST(Pose, ARightAngleIsRigidBeyondTheJointAndKeepsTheVolume)
{
  Posing posing;
  const Mesh bent = posing.posedAlong({ { 400, 300 }, { 400, 520 } });
  double worst = 0.0;
  for (int v = 0; v < bent.vertexCount(); ++v)
  {
    const Vector3& before = posing.mesh.points[v];
    const Vector3& after = bent.points[v];
    if (before[0] < 0.0)
    {
      EXPECT_EQ(before, after);
    }
    else if (before[0] > 2.4 * radius) // the softness is 2 radii
    {
      worst = std::max(worst, (after - Vector3(-before[1], before[0], before[2])).norm());
    }
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_NEAR(volumeOf(bent) / volumeOf(posing.mesh), 1.0, 0.05);
  fact("volume of a capsule bent by 90 degrees", std::to_string(volumeOf(bent) / volumeOf(posing.mesh)));
  EXPECT_EQ(posing.made.joints, 1);
  EXPECT_NEAR(posing.made.bend, 90.0, 1e-6);
}

TEST(Pose, TheBoneItselfMovesNothing)
{
  Polyline wavy;
  for (int i = 0; i <= 110; ++i)
  {
    wavy.emplace_back(400 + 2 * i, 300 + 6.0 * std::sin(0.1 * i));
  }
  for (const View& view :
    { orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0), perspectiveView({ 1, 2, 5 }, { 0, 1, 0 }, 60.0) })
  {
    Posing posing(capsule(radius, half, 48, 121), view, wavy);
    EXPECT_EQ(posing.posedAlong(wavy).points, posing.mesh.points);
    EXPECT_EQ(posing.made.joints, 0);
  }
}

TEST(Pose, TwoBendsLayTheLimbAlongTheCourse)
{
  Posing posing;
  // Up by one unit and on to the right: what is beyond the second bend lies as before, one unit higher.
  const Mesh bent = posing.posedAlong({ { 400, 300 }, { 400, 400 }, { 700, 400 } });
  double worst = 0.0;
  const Vector3 tip = bent.points[posing.mesh.vertexCount() - 1]; // capsule's last point
  for (int v = 0; v < bent.vertexCount(); ++v)
  {
    const Vector3& before = posing.mesh.points[v];
    if (before[0] > 1.5)
    {
      worst = std::max(worst, ((bent.points[v] - tip) - (before - Vector3(half + radius, 0, 0))).norm());
    }
  }
  EXPECT_LT(worst, 1e-6);
  EXPECT_NEAR(tip[1], 1.0, 1e-6);
  EXPECT_NEAR(tip[0], half + radius - 1.0, 0.05); // the corner is cut by a step of the bone
  EXPECT_NEAR(volumeOf(bent) / volumeOf(posing.mesh), 1.0, 0.05);
}

TEST(Pose, ALongerCourseStretchesOnRequestAlone)
{
  Posing posing;
  const Polyline course{ { 400, 300 }, { 400, 740 } };
  const int tip = posing.mesh.vertexCount() - 1;
  EXPECT_NEAR(posing.posedAlong(course).points[tip][1], half + radius, 1e-6);
  EXPECT_NEAR(posing.posedAlong(course, { 1.0, true }).points[tip][1], half + radius + 2.2, 1e-4);
}

TEST(Pose, ASofterJointBendsOverMore)
{
  Posing posing;
  const auto bending = [&](double softness)
  {
    const Mesh bent = posing.posedAlong({ { 400, 300 }, { 400, 520 } }, { softness, false });
    int count = 0;
    for (int v = 0; v < bent.vertexCount(); ++v)
    {
      const Vector3& p = posing.mesh.points[v];
      count += p[0] > 0.0 && (bent.points[v] - Vector3(-p[1], p[0], p[2])).norm() > 1e-6;
    }
    return count;
  };
  EXPECT_GT(bending(2.0), 1.7 * bending(1.0));
  EXPECT_LT(bending(0.5), 0.6 * bending(1.0));
}

TEST(Pose, ACurlOfMoreThanAFullTurnIsOne)
{
  Posing posing;
  Polyline spiral{ { 400, 300 } };
  for (int i = 1; i <= 220; ++i) // 410 degrees
  {
    const double angle = 410.0 / 180.0 * pi * i / 220;
    spiral.push_back(spiral.back() + Vector2(std::cos(angle), std::sin(angle)));
  }
  const Mesh bent = posing.posedAlong(spiral);
  EXPECT_NEAR(posing.made.bend, 410.0, 10.0); // half a step less
  const Vector3 tip = bent.points[posing.mesh.vertexCount() - 1];
  const Vector2 end = (spiral.back() - Vector2(400, 300)) / 100.0;
  EXPECT_LT((tip.head<2>() - end).norm(), 0.15);
}

TEST(Pose, ABegunBesideTheJointEndsWhereItIsDrawn)
{
  Posing posing;
  const Mesh bent = posing.posedAlong({ { 410, 290 }, { 400, 520 } }, { 1.0, true });
  EXPECT_NEAR(bent.points[posing.mesh.vertexCount() - 1][0], 0.0, 1e-4);
}

TEST(Pose, BadHandsAreRefused)
{
  const auto rays = SurfaceRays(std::make_shared<const Mesh>(capsule(radius, half, 48, 121)));
  const View view = orthographicView({ 0, 0, 1 }, { 0, 1, 0 }, 100.0);
  EXPECT_THROW(boneUnder(rays, view, { { 10, 10 }, { 90, 10 } }), Error);
  Posing posing;
  posing.view = orthographicView({ 1, 0, 0 }, { 0, 1, 0 }, 100.0); // from the bone's end
  EXPECT_THROW(posing.posedAlong({ { 400, 300 }, { 400, 520 } }), Error);
}
