// Small levels in which it is easy to take the light of a texel elsewhere than the format says.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "agreement/compare_level.h"
#include "agreement/panel.h"
#include "support/level_text.h"

namespace hearth::agreement {
namespace {

using test::sectorText;

constexpr std::string_view kWall = "{'texture':'#808080'}";

/// Holds what a camera, "x,y,z,angle,pitch", sees of sectors in the light of one lamp.
void expectAgreement(std::string_view sectors, std::string_view lamp, std::string_view camera) {
  const LoadedLevel level = test::levelFrom(
      fmt::format("{{'shots':[{{'name':'view','camera':[{}],'size':[160,100]}}],'sectors':{{{}}}}}",
                  camera, sectors),
      fmt::format("{{'lights':[{{{}}}],'bake':{{'texel':0.25}}}}", lamp));
  const Tally tally = compareLevel(level, "small level", 1);
  EXPECT_EQ(tally.holes, 0);
  EXPECT_EQ(tally.missed(), 0) << tally.firstMiss << '\n' << table(tally);
}

/// Two sectors beside one another with slopes of these heights, the second 4 m on along x.
std::string slopes(std::string_view first, std::string_view second) {
  const auto slope = [](std::string_view heights) {
    return fmt::format(",'slopeFloor':{{'z':[{}],'sidewall':'#808080'}}", heights);
  };
  const auto walls = [](std::string_view one, std::string_view three) {
    return fmt::format("[{0},{1},{0},{2}]", kWall, one, three);
  };
  return sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3, walls("{'next':'b'}", kWall), slope(first)) +
         "," +
         sectorText("b", "4,0, 12,0, 12,4, 4,4", 0, 3, walls(kWall, "{'next':'a'}"), slope(second));
}

TEST(SmallLevels, agreeOnACornerThatTwoSlopesShareButForNoise) {
  expectAgreement(slopes("0,0,1,1", "0.0003,0.0003,1.0003,1.0003"),
                  "'x':4.2,'y':3.9,'z':1.3,'falloff':3", "3.3,3.3,1.9,45,-45");
}

TEST(SmallLevels, agreeOnTheGridOfARunOfSlopesThatAreParallelButForNoise) {
  expectAgreement(slopes("0,0,1,1", "0,0.0009,1.0009,1"),
                  "'x':11,'y':1,'z':0.65,'intensity':2000,'falloff':20", "9.5,1,1.5,0,-30");
}

TEST(SmallLevels, agreeWhereAHoleTouchesTheBorderInTheMiddleOfATexel) {
  // So that the floor has two corners there, of which the lamp lights one.
  const std::string room =
      "'a':{'floor':{'texture':'#808080'},'ceiling':{'z':3,'texture':'#808080'},'loops':{"
      "'border':{'v':[0,0, 3.875,0, 3.875,1.875, 3.875,4, 0,4],'walls':{'texture':'#808080'}},"
      "'hole':{'v':[2,0.475, 2,3.275, 3.875,1.875],'walls':{'texture':'#808080'}}}}";
  expectAgreement(room, "'x':3,'y':0.5,'z':1", "3.4,1.2,0.9,54.9,-45");
  expectAgreement(room, "'x':3,'y':3.5,'z':1", "3.4,2.6,0.9,303.2,-45");
}

TEST(SmallLevels, moveSamplesIntoTheTipOfASharpCorner) {
  const LoadedLevel loaded =
      test::levelFrom("{'light':1,'sectors':{" + sectorText("a", "0,0, 8,0, 8,0.05", 0, 3) + "}}");
  const Panel floor = panelOf(loaded.scene(), loaded.level.sectors[0].floorSurface.value());
  const std::vector<Vec2> places = floor.movedInside({0, 0}, 1e-6, {-0.1, 0.1});
  ASSERT_EQ(places.size(), 1U);
  EXPECT_TRUE(floor.contains(places[0]));
  EXPECT_NEAR(length(floor.nearestOnEdge(places[0]) - places[0]), 1e-6, 1e-9);
}

TEST(SmallLevels, agreeOnWallsThatAreInLineWithTheLongerOneButForNoise) {
  // The second is 0.48 mm off the line of the first, which is 1.28 mm off that of the second.
  expectAgreement(sectorText("a", "0,0, 1.6,0, 2.2,0.00048, 2.2,3, 0,3", 0, 3),
                  "'x':1.9,'y':0.3,'z':1.5,'falloff':3", "1.6,1.5,1.5,285,0");
}

TEST(SmallLevels, agreeOnWallsThatLeaveTheLineOfTheLongestBitByBit) {
  expectAgreement(sectorText("a", "0,0, 1,0, 1.237,0.00016, 1.947,0.00064, 1.947,3, 0,3", 0, 3),
                  "'x':1.5,'y':0.3,'z':1.5,'falloff':3", "1.2,1.5,1.5,285,0");
}

}  // namespace
}  // namespace hearth::agreement
