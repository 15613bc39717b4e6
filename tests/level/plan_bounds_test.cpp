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

}  // namespace
}  // namespace hearth
