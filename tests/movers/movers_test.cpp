#include "expect_movers_hold.h"

namespace hearth::movers {
namespace {

/// Few: under the sanitizers 30 would take five minutes.
TEST(MoversOfRandomLevels, standAtTheirEndsAsIfAuthoredThereAndBetweenThemAsTruthHasIt) {
  expectMoversHold(10, 9);
}

}  // namespace
}  // namespace hearth::movers
