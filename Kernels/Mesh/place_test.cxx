#include "Mesh/place.h"

#include <gtest/gtest.h>

using oversketch::Mix;

TEST(Mix, NormalisedHasEachPointOnceAndNoRounding)
{
  const Mix mix = oversketch::normalisedMix({ { 7, 0.25 }, { 2, 0.5 }, { 7, 0.25 }, { 4, 1e-13 } });
  EXPECT_EQ(mix, (Mix{ { 2, 0.5 }, { 7, 0.5 } }));
  EXPECT_EQ(oversketch::normalisedMix({ { 3, 0.5 }, { 3, -0.5 }, { 1, 1.0 } }), (Mix{ { 1, 1.0 } }));
  EXPECT_TRUE(oversketch::normalisedMix({}).empty());
}

TEST(Mix, SamePlacesDifferByRoundingAlone)
{
  const Mix mix{ { 2, 0.5 }, { 7, 0.5 } };
  EXPECT_TRUE(oversketch::sameMix(mix, { { 2, 0.5 + 1e-12 }, { 7, 0.5 - 1e-12 } }));
  EXPECT_FALSE(oversketch::sameMix(mix, { { 2, 0.5 + 1e-6 }, { 7, 0.5 - 1e-6 } }));
  EXPECT_FALSE(oversketch::sameMix(mix, { { 2, 0.5 }, { 8, 0.5 } }));
  EXPECT_FALSE(oversketch::sameMix(mix, { { 2, 1.0 } }));
}
