#include "expect_movers_hold.h"

namespace hearth::movers {
namespace {

TEST(MoversOfRandomLevels, standAtTheirEndsAsIfAuthoredThereAndBetweenThemAsTruthHasIt) {
  expectMoversHold(30, 25);
}

}  // namespace
}  // namespace hearth::movers
