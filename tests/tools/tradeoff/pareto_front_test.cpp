#include "measure/tradeoff/pareto_front.h"

#include <gtest/gtest.h>

#include <array>

namespace hearth {
namespace {

TEST(Front, isWhatNothingElseIsBetterThan) {
  const std::array points{CostAndError{1, 9}, CostAndError{2, 5}, CostAndError{3, 5},
                          CostAndError{4, 6}, CostAndError{5, 1}};
  EXPECT_EQ(onParetoFront(points), (std::vector{true, true, false, false, true}));
}

TEST(Front, holdsAllThatAreAlike) {
  const std::array points{CostAndError{1, 1}, CostAndError{1, 1}};
  EXPECT_EQ(onParetoFront(points), (std::vector{true, true}));
  EXPECT_TRUE(onParetoFront({}).empty());
}

}  // namespace
}  // namespace hearth
