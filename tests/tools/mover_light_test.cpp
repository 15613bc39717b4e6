// In which states of its movers a level is baked.

#include "settings/mover_light.h"

#include <gtest/gtest.h>

#include <vector>

namespace hearth {
namespace {

using States = std::vector<std::vector<double>>;

TEST(StatesToKeep, beginWithTheLevelAsAuthoredAndThenMoveOneMoverAfterTheOther) {
  EXPECT_EQ(statesToKeep(0, {}), (States{{}}));
  EXPECT_EQ(statesToKeep(2, {}), (States{{0, 0}, {1, 0}, {0, 1}, {1, 1}}));
  EXPECT_EQ(statesToKeep(3, {.states = 6}),
            (States{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}, {1, 0, 1}}));
}

TEST(StatesToKeep, haveEachMoverAtEachStage) {
  EXPECT_EQ(statesToKeep(1, {.stages = 3}), (States{{0}, {0.25}, {0.5}, {0.75}, {1}}));
  EXPECT_EQ(statesToKeep(2, {.stages = 1}).size(), 9U);
}

TEST(StatesToKeep, areNoMoreThanAsked) {
  EXPECT_EQ(statesToKeep(2, {.states = 1}), (States{{0, 0}}));
  EXPECT_EQ(statesToKeep(400, {.states = 1000}).size(), 1000U);
}

}  // namespace
}  // namespace hearth
