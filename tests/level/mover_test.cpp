#include "level/mover.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

using Shares = std::vector<double>;

TEST(RestStates, areOneWhereAllMoversRest) {
  for (const Shares& shares : {Shares{}, Shares{0}, Shares{1}, Shares{1, 0, 1}}) {
    const RestStates states(shares);
    ASSERT_EQ(states.count(), 1U);
    EXPECT_EQ(states.shares(0), shares);
    EXPECT_EQ(states.weights()[0], 1);
  }
}

TEST(RestStates, areTheEndsOfAMoverBetweenThem) {
  const RestStates states(Shares{0.25});
  ASSERT_EQ(states.count(), 2U);
  EXPECT_EQ(states.shares(0), Shares{0});
  EXPECT_EQ(states.weights()[0], 0.75);
  EXPECT_EQ(states.shares(1), Shares{1});
  EXPECT_EQ(states.weights()[1], 0.25);
}

TEST(RestStates, takeMoversToTheirOtherEndByFallingShare) {
  const RestStates states(Shares{0.25, 0.75, 1, 0});
  ASSERT_EQ(states.count(), 3U);
  EXPECT_EQ(states.shares(0), (Shares{0, 0, 1, 0}));
  EXPECT_EQ(states.weights()[0], 0.25);
  EXPECT_EQ(states.shares(1), (Shares{0, 1, 1, 0}));
  EXPECT_EQ(states.weights()[1], 0.5);
  EXPECT_EQ(states.shares(2), (Shares{1, 1, 1, 0}));
  EXPECT_EQ(states.weights()[2], 0.25);
}

TEST(RestStates, moveMoversOfOneShareTogether) {
  const RestStates states(Shares{0.5, 0.5});
  ASSERT_EQ(states.count(), 2U);
  EXPECT_EQ(states.shares(0), (Shares{0, 0}));
  EXPECT_EQ(states.shares(1), (Shares{1, 1}));
}

TEST(RestStates, areTheSameWhileTheMoversKeepTheirOrder) {
  const RestStates states(Shares{0.25, 0.75});
  EXPECT_TRUE(states.areStatesOf(RestStates(Shares{0.5, 0.9})));
  EXPECT_FALSE(states.areStatesOf(RestStates(Shares{0.75, 0.25})));
  EXPECT_FALSE(states.areStatesOf(RestStates(Shares{0.25, 1})));
}

TEST(RestStates, areTheStagesAroundAMover) {
  const RestStates states(Shares{0.375}, 3);
  ASSERT_EQ(states.count(), 2U);
  EXPECT_EQ(states.shares(0), Shares{0.25});
  EXPECT_EQ(states.shares(1), Shares{0.5});
  EXPECT_EQ(states.weights()[0], 0.5);
  EXPECT_EQ(states.weights()[1], 0.5);
}

TEST(RestStates, takeMoversToTheirNextStageByTheFallingPartOfTheirWay) {
  const RestStates states(Shares{0.875, 0.125}, 1);
  ASSERT_EQ(states.count(), 3U);
  EXPECT_EQ(states.shares(0), (Shares{0.5, 0}));
  EXPECT_EQ(states.shares(1), (Shares{1, 0}));
  EXPECT_EQ(states.shares(2), (Shares{1, 0.5}));
  EXPECT_EQ(states.weights()[0], 0.25);
  EXPECT_EQ(states.weights()[1], 0.5);
  EXPECT_EQ(states.weights()[2], 0.25);
}

TEST(RestStates, areOneAtEachStage) {
  for (int stages = 0; stages <= kMaxMoverStages; ++stages)
    for (int i = 0; i <= stages + 1; ++i) {
      const Shares shares{1.0 * i / (stages + 1)};
      const RestStates states(shares, stages);
      ASSERT_EQ(states.count(), 1U) << i << " of " << stages;
      EXPECT_EQ(states.shares(0), shares);
    }
}

TEST(RestStates, areOthersBetweenOtherStages) {
  EXPECT_TRUE(RestStates(Shares{0.3}).areStatesOf(RestStates(Shares{0.6})));
  EXPECT_FALSE(RestStates(Shares{0.3}, 1).areStatesOf(RestStates(Shares{0.6}, 1)));
}

}  // namespace
}  // namespace hearth
