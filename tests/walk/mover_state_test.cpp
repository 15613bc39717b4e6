#include "walk/mover_state.h"

#include <gtest/gtest.h>

#include "walk/walk_input.h"

namespace hearth {
namespace {

/// A metre at a metre a second.
Mover slow(std::optional<double> wait = {}, MoverTrigger trigger = MoverTrigger::Use) {
  return {"gate", {SectorId(0)}, FlatPart::Ceiling, 1, 1, wait, trigger, {}};
}

MoverState after(const Mover& mover, MoverState state, int ticks) {
  for (int i = 0; i < ticks; ++i) state = moved(mover, 1, state);
  return state;
}

TEST(MoverState, isAtRestUntilItIsStarted) {
  EXPECT_EQ(after(slow(), firstState(slow()), 1000), (MoverState{0, 0, 0}));
}

TEST(MoverState, movesAtItsSpeedAndStays) {
  const MoverState set = started(slow(), firstState(slow()));
  EXPECT_EQ(after(slow(), set, 32).share, 0.5);
  EXPECT_EQ(after(slow(), set, 63).direction, 1);
  EXPECT_EQ(after(slow(), set, 64), (MoverState{1, 0, 0}));
  EXPECT_EQ(after(slow(), set, 5000), (MoverState{1, 0, 0}));
}

TEST(MoverState, waitsAndReturns) {
  const Mover gate = slow(2);
  const MoverState there = after(gate, started(gate, firstState(gate)), 64);
  EXPECT_EQ(after(gate, there, 2 * kTicksPerSecond).share, 1);
  EXPECT_EQ(after(gate, there, 2 * kTicksPerSecond).direction, -1);
  EXPECT_EQ(after(gate, there, 2 * kTicksPerSecond + 32).share, 0.5);
  EXPECT_EQ(after(gate, there, 2 * kTicksPerSecond + 64), (MoverState{0, 0, 0}));
}

TEST(MoverState, startedOnItsWayBackSetsOutAgain) {
  const Mover gate = slow(0);
  MoverState state = after(gate, {1, -1, 0}, 16);
  EXPECT_EQ(state.share, 0.75);
  state = started(gate, state);
  EXPECT_EQ(after(gate, state, 16).share, 1);
}

TEST(MoverState, startedWhileItWaitsWaitsAnew) {
  const Mover gate = slow(1);
  const MoverState waiting = after(gate, {1, 0, 0}, 50);
  EXPECT_EQ(after(gate, waiting, 14).direction, -1);
  EXPECT_EQ(after(gate, started(gate, waiting), 63).direction, 0);
}

TEST(MoverState, neverRestsInALoopUnlessItWaits) {
  const Mover loop = slow({}, MoverTrigger::Loop);
  EXPECT_EQ(firstState(loop).direction, 1);
  EXPECT_EQ(after(loop, firstState(loop), 64).share, 1);
  EXPECT_EQ(after(loop, firstState(loop), 65).direction, -1);
  EXPECT_EQ(after(loop, firstState(loop), 65 + 64).share, 0);
  const Mover waits = slow(1, MoverTrigger::Loop);
  EXPECT_EQ(after(waits, firstState(waits), 64 + 64 + 64).share, 0) << "after a second at its top";
  EXPECT_EQ(after(waits, firstState(waits), 64 + 64 + 64 + 64).direction, 1) << "and one below";
}

TEST(MoverState, jumpsWhereItsEndsAreOneHeight) {
  EXPECT_EQ(moved(slow(), 0, {0, 1, 0}), (MoverState{1, 0, 0}));
}

}  // namespace
}  // namespace hearth
