#include "level/plan_bounds.h"

#include <gtest/gtest.h>

#include "support/level_text.h"

namespace hearth {
namespace {

/// A hall of 30 m with two lights near its middle, and a closet of 1 m.
LoadedLevel hallAndCloset(double lightsApart) {
  return test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("hall", "0,0, 30,0, 30,30, 0,30", 0, 4) + "," +
          test::sectorText("closet", "40,0, 41,0, 41,1, 40,1", 0, 4) + "}}",
      "[{'x':15,'y':15,'z':3},{'x':" + std::to_string(15 + lightsApart) + ",'y':15,'z':3}]");
}

TEST(PlanBounds, HoldAllOfALevelWhoseLightsAreCloseTogether) {
  EXPECT_EQ(planBounds(hallAndCloset(0.5).level), (Box{{0, 0}, {41, 30}}));
}

TEST(PlanBounds, HoldAllOfAHallThatIsNotMuchLargerThanWhatStandsInIt) {
  EXPECT_EQ(planBounds(hallAndCloset(10).level), (Box{{0, 0}, {41, 30}}));
}

/// A camera may stand far out on a lake, which is itself too large to be shown.
TEST(PlanBounds, HoldAllLightsAndNoLakeUpToTheHorizon) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("hut", "0,0, 8,0, 8,8, 0,8", 0, 4) + "," +
          test::sectorText("lake", "10,-900, 990,-900, 990,900, 10,900", 0, 4) + "}}",
      "[{'x':4,'y':4,'z':3},{'x':24,'y':4,'z':3}]");
  EXPECT_EQ(planBounds(loaded.level), (Box{{0, 0}, {24, 8}}));
}

}  // namespace
}  // namespace hearth
