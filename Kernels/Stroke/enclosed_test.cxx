#include "Stroke/enclosed.h"

#include <gtest/gtest.h>

using namespace oversketch;

TEST(EnclosedBy, KnowsACornerThatALassoGoesRound)
{
  // An L; its last sample is joined to its first one.
  const std::vector<Vector2> lasso{ { 0, 0 }, { 4, 0 }, { 4, 1 }, { 1, 1 }, { 1, 4 }, { 0, 4 } };
  EXPECT_EQ(enclosedBy(lasso, { { 0.5, 3.5 }, { 3.5, 0.5 }, { 2, 2 }, { 0, 2 }, { -0.1, 2 }, { 1e30, 0.5 } }),
    (std::vector<char>{ 1, 1, 0, 1, 0, 0 }));
}

TEST(EnclosedBy, LeavesOutWhatIsGoneRoundTwice)
{
  const std::vector<Vector2> twice{
    { 0, 0 }, { 6, 0 }, { 6, 6 }, { 0, 6 }, { 0, 0 }, { 2, 2 }, { 4, 2 }, { 4, 4 }, { 2, 4 }, { 2, 2 }
  };
  EXPECT_EQ(enclosedBy(twice, { { 1, 3 }, { 3, 3 } }), (std::vector<char>{ 1, 0 }));
}

TEST(EnclosedBy, HasNothingInALineAndCanBeCancelled)
{
  EXPECT_EQ(enclosedBy({ { 0, 0 }, { 2, 0 } }, { { 1, 1 } }), (std::vector<char>{ 0 }));
  Context context;
  context.cancelled = [] { return true; };
  EXPECT_THROW(enclosedBy({ { 0, 0 }, { 2, 0 }, { 0, 2 } }, { { 1, 1 } }, context), Error);
}
