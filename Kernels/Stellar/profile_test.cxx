#include "Stellar/profile.h"

#include "Harness/feature_shapes.h"
#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;
using namespace oversketch_test;

namespace
{

void expectNoProfile(const std::string& text, const std::string& words)
{
  try
  {
    Profile::polyline(text);
    FAIL() << text;
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.failure(), Failure::BadStroke);
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

} // namespace

TEST(Profile, FollowsItsSharpness)
{
  EXPECT_EQ(Profile(1.0)(0.25), 0.75);
  EXPECT_EQ(Profile(2.0)(0.5), 0.25);
  EXPECT_EQ(Profile(0.5)(0.75), 0.5);
  EXPECT_EQ(Profile(0.0)(0.999), 1.0);
  for (const double s : { 0.0, 0.3, 1.0, 1.5, 1e300 })
  {
    EXPECT_EQ(Profile(s)(0.0), 1.0);
    EXPECT_EQ(Profile(s)(1.0), 0.0);
    EXPECT_EQ(Profile(s)(7.0), 0.0);
    EXPECT_EQ(Profile(s)(std::numeric_limits<double>::infinity()), 0.0);
  }
}

TEST(Profile, GoesThroughThePointsOfItsPolyline)
{
  const Profile profile = Profile::polyline(" 0 1, 0.5 -0.5 ,0.75 2,1 0.25");
  EXPECT_EQ(profile(0.0), 1.0);
  EXPECT_EQ(profile(0.25), 0.25);
  EXPECT_EQ(profile(0.5), -0.5);
  EXPECT_EQ(profile(0.625), 0.75);
  EXPECT_EQ(profile(0.875), 1.125);
  EXPECT_EQ(profile(1.0), 0.0);
}

TEST(Profile, RefusesWhatIsNone)
{
  for (const double s : { -1.0, -1e-300, std::nan(""), std::numeric_limits<double>::infinity() })
  {
    EXPECT_THROW(Profile{ s }, Error);
  }
  expectNoProfile("", "Point 0");
  expectNoProfile("0 1", "Point 0");
  expectNoProfile("0 1, 1", "Point 1 of the profile is not two numbers");
  expectNoProfile("0 1, 0.5 nan, 1 0", "Point 1 of the profile is not two numbers");
  expectNoProfile("0 1, 1e999 0", "Point 1 of the profile is not two numbers");
  expectNoProfile("0 1 2, 1 0", "Point 0 of the profile is not two numbers");
  expectNoProfile("0 1; 1 0", "Point 0 of the profile is not two numbers");
  expectNoProfile("0.1 1, 1 0", "Point 0 of the profile is not at x = 0");
  expectNoProfile("0 1, 0.5 1, 0.5 0, 1 0", "Point 2 of the profile has an x that is not above");
  expectNoProfile("0 1, 0.9 0", "not at x = 1");
  expectNoProfile("0 1, 1 0, 2 0", "not at x = 1");
}

TEST(Preview, StandsOnTheCurveAndEndsAtTheRadius)
{
  // The equator of the unit sphere: the crest is a wider circle, the feet are parallel ones in its tangent
  // planes.
  std::vector<Vector3> ring(90);
  for (int i = 0; i < 90; ++i)
  {
    ring[i] = { std::cos(2.0 * pi * i / 90.0), std::sin(2.0 * pi * i / 90.0), 0.0 };
  }
  FeatureCurve curve = featureCurve(ring, true);
  curve.normals = ring;
  curve.pressure.assign(90, 0.5);
  const FeaturePreview plain = previewFeature(curve, 0.1, 0.2),
                       pressed = previewFeature(curve, 0.1, 0.2, true);
  ASSERT_EQ(plain.crest.size(), 90u);
  for (int i = 0; i < 90; ++i)
  {
    EXPECT_LT((plain.crest[i] - 1.2 * ring[i]).norm(), 1e-14);
    EXPECT_LT((pressed.crest[i] - 1.1 * ring[i]).norm(), 1e-14);
    EXPECT_LT((plain.left[i] - ring[i] - Vector3(0, 0, 0.1)).norm(), 1e-14);
    EXPECT_LT((plain.right[i] - ring[i] + Vector3(0, 0, 0.1)).norm(), 1e-14);
  }
  curve.radius = 0.3;
  curve.height = -0.5;
  const FeaturePreview own = previewFeature(curve, 0.1, 0.2, false, 0.0, &ring);
  EXPECT_NEAR(own.left[7].z(), 0.3, 1e-14);
  EXPECT_EQ(own.crest[7], ring[7]);
  EXPECT_LT((previewFeature(curve, 0.1, 0.2).crest[7] - 0.5 * ring[7]).norm(), 1e-14);
}

TEST(Preview, OpenBentAndBareCurves)
{
  FeatureCurve curve = featureCurve({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 2, 0 } });
  EXPECT_EQ(previewFeature(curve, 1.0, 5.0).crest, curve.points);
  EXPECT_EQ(previewFeature(curve, 1.0, 5.0).left, curve.points);
  curve.normals.assign(4, Vector3(0, 0, 2));
  const FeaturePreview preview = previewFeature(curve, 1.0, 5.0);
  EXPECT_LT((preview.left[0] - Vector3(0, 1, 0)).norm(), 1e-15);
  EXPECT_LT((preview.left[3] - Vector3(0, 2, 0)).norm(), 1e-15);
  EXPECT_EQ(preview.crest[3], Vector3(1, 2, 5));
  // It ends in points, the longer way of which begins at the middle of so short a curve.
  const FeaturePreview pointed = previewFeature(curve, 1.0, 5.0, false, 2.0);
  EXPECT_EQ(pointed.crest[0], curve.points[0]);
  EXPECT_LT((pointed.left[3] - curve.points[3]).norm(), 1e-15);
  const double share = std::sin(0.5 * pi / 1.5);
  EXPECT_LT((pointed.crest[1] - Vector3(1, 0, 5.0 * share * share)).norm(), 1e-14);
}

TEST(Preview, RefusesWhatDisplaceDoes)
{
  const FeatureCurve curve = featureCurve({ { 0, 0, 0 }, { 1, 0, 0 } });
  const std::vector<Vector3> one(1);
  EXPECT_THROW(previewFeature(curve, 0.0, 1.0), Error);
  EXPECT_THROW(previewFeature(curve, std::nan(""), 1.0), Error);
  EXPECT_THROW(previewFeature(curve, 1.0, std::nan("")), Error);
  EXPECT_THROW(previewFeature(curve, 1.0, 1.0, false, 0.0, &one), Error);
  EXPECT_THROW(previewFeature(featureCurve({ { 0, 0, 0 } }), 1.0, 1.0), Error);
}
