#include "level/mover.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

using Shares = std::vector<double>;

TEST(RestStates, areOneWhereAllMoversRest) {
  for (const Shares& shares : {Shares{}, Shares{0}, Shares{1}, Shares{1, 0, 1}}) {
    const auto states = restStatesAround(shares);
    ASSERT_EQ(states.size(), 1U);
    EXPECT_EQ(states[0].shares, shares);
    EXPECT_EQ(states[0].weight, 1);
  }
}

TEST(RestStates, areTheEndsOfAMoverBetweenThem) {
  const auto states = restStatesAround(Shares{0.25});
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].shares, Shares{0});
  EXPECT_EQ(states[0].weight, 0.75);
  EXPECT_EQ(states[1].shares, Shares{1});
  EXPECT_EQ(states[1].weight, 0.25);
}

TEST(RestStates, takeMoversToTheirOtherEndByFallingShare) {
  const auto states = restStatesAround(Shares{0.25, 0.75, 1, 0});
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states[0].shares, (Shares{0, 0, 1, 0}));
  EXPECT_EQ(states[0].weight, 0.25);
  EXPECT_EQ(states[1].shares, (Shares{0, 1, 1, 0}));
  EXPECT_EQ(states[1].weight, 0.5);
  EXPECT_EQ(states[2].shares, (Shares{1, 1, 1, 0}));
  EXPECT_EQ(states[2].weight, 0.25);
}

TEST(RestStates, moveMoversOfOneShareTogether) {
  const auto states = restStatesAround(Shares{0.5, 0.5});
  ASSERT_EQ(states.size(), 2U);
  EXPECT_EQ(states[0].shares, (Shares{0, 0}));
  EXPECT_EQ(states[1].shares, (Shares{1, 1}));
}

}  // namespace
}  // namespace hearth
