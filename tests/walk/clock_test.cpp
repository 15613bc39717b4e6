#include <gtest/gtest.h>

#include <limits>

#include "walk/walk_clock.h"

namespace hearth {
namespace {

TEST(WalkClock, CountsTicksAndFractionsOfThem) {
  WalkClock clock;
  EXPECT_EQ(clock.advance(100).ticks, 0) << "the first look starts it";
  const WalkClock::Due due = clock.advance(100 + 10.25 / 64);
  EXPECT_EQ(due.ticks, 10);
  EXPECT_EQ(due.fraction, 0.25);
  EXPECT_EQ(clock.advance(100 + 11.0 / 64).ticks, 1);
}

TEST(WalkClock, LosesNothingOfFramesOfAnyLength) {
  for (const double frame : {1e-4, 1.0 / 60, 0.15, 0.25}) {
    WalkClock clock;
    int ticks = 0;
    for (int i = 0; frame * i <= 30; ++i) ticks += clock.advance(frame * i).ticks;
    EXPECT_NEAR(ticks, 30 * 64, 64 * frame + 1) << frame;
  }
}

TEST(WalkClock, MakesUpForAQuarterOfASecondAndNoMore) {
  for (const double frame : {0.25, 0.3, 1.0, 10.0, 1e300}) {
    WalkClock clock;
    clock.advance(0);
    EXPECT_EQ(clock.advance(frame).ticks, 16) << frame;
    EXPECT_LT(clock.advance(frame).fraction, 1);
  }
}

TEST(WalkClock, GoesOnFromWhereItIsSetBackTo) {
  WalkClock clock;
  clock.advance(1000);
  EXPECT_EQ(clock.advance(1000).ticks, 0);
  EXPECT_EQ(clock.advance(-5).ticks, 0);
  EXPECT_EQ(clock.advance(-5 + 2.0 / 64).ticks, 2);
}

TEST(WalkClock, TakesNoNumberForNothing) {
  WalkClock clock;
  clock.advance(1);
  for (const double broken :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(clock.advance(broken).ticks, 0);
  EXPECT_EQ(clock.advance(1 + 3.0 / 64).ticks, 3);
}

}  // namespace
}  // namespace hearth
