#include "Stellar/profile.h"

#include "Mesh/context.h"

#include <gtest/gtest.h>

#include <limits>

using namespace oversketch;

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
