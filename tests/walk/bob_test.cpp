// How steps move what is seen.

#include "walk/bob.h"

#include <algorithm>

#include "walks.h"

namespace hearth {
namespace {

using test::kForward;
using test::kRun;
using test::standing;

LoadedLevel hall(double ceiling, const std::string& player = "") {
  return test::levelFrom("{'light':1," + player + "'sectors':{" +
                         test::sectorText("hall", "0,0, 90,0, 90,4, 0,4", 0, ceiling) + "}}");
}

struct Heights {
  double lowest = 0;
  double highest = 0;
  double last = 0;
};

/// Of the eye above where it would be, in metres, over three seconds after one of speeding up.
Heights liftsOf(const Scene& scene, const WalkInput& input, double fraction) {
  Walker walker = standing(scene, "hall", {1, 2, 0});
  Gait gait;
  Heights lifts;
  for (int tick = 0; tick < 4 * kTicksPerSecond; ++tick) {
    const Walker before = walker;
    walker = walked(scene, walker, input);
    gait = walkedOn(gait, before, walker);
    const Eye eye = eyeOf(scene, walker);
    const Eye moved = bobbed(scene, eye, gait, fraction);
    EXPECT_TRUE(contains(scene, scene[moved.sector], moved.point, kPositionSlack));
    EXPECT_EQ(moved.point.xy(), eye.point.xy());
    lifts.last = moved.point.z - eye.point.z;
    if (tick < kTicksPerSecond) continue;
    lifts.lowest = std::min(lifts.lowest, lifts.last);
    lifts.highest = std::max(lifts.highest, lifts.last);
  }
  return lifts;
}

TEST(Bob, LiftsTheEyeAsTheWalkerIsFast) {
  const LoadedLevel loaded = hall(4);
  const Heights running = liftsOf(loaded.scene(), kRun, 1);
  EXPECT_NEAR(running.highest, 0.064, 0.002);
  EXPECT_NEAR(running.lowest, -0.064, 0.002);
  EXPECT_NEAR(liftsOf(loaded.scene(), kForward, 1).highest, 0.032, 0.001);
  EXPECT_NEAR(liftsOf(loaded.scene(), kRun, 0.25).highest, 0.016, 0.001);
}

TEST(Bob, IsNothingAtRestAndInFlight) {
  const LoadedLevel loaded = hall(4);
  EXPECT_EQ(liftsOf(loaded.scene(), {}, 1).highest, 0);
  WalkInput fly = kRun;
  fly.up = kFullSpeed;
  Walker walker = standing(loaded.scene(), "hall", {1, 2, 0});
  walker.isFlying = true;
  Gait gait;
  for (int tick = 0; tick < 64; ++tick) {
    const Walker before = walker;
    walker = walked(loaded.scene(), walker, fly);
    gait = walkedOn(gait, before, walker);
  }
  EXPECT_LT(gait.swing, 0.01);
}

TEST(Bob, ComesToRestWithTheWalker) {
  const LoadedLevel loaded = hall(4);
  Gait gait{1.3, 1};
  const Walker walker = standing(loaded.scene(), "hall", {1, 2, 0});
  for (int tick = 0; tick < kTicksPerSecond; ++tick) gait = walkedOn(gait, walker, walker);
  EXPECT_EQ(gait.stride, 1.3);
  EXPECT_LT(gait.swing, 0.001);
}

TEST(Bob, StaysBelowTheCeiling) {
  const LoadedLevel loaded = hall(1.8, "'player':{'x':1,'y':2,'z':1.8,'height':1.8,'eye':1.8},");
  const Heights lifts = liftsOf(loaded.scene(), kRun, 1);
  EXPECT_LT(lifts.highest, 1e-5);
  EXPECT_LT(lifts.lowest, -0.06);
}

}  // namespace
}  // namespace hearth
