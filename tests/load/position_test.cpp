#include <gtest/gtest.h>

#include "load/positions.h"
#include "load_text.h"

namespace hearth {
namespace {

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";
const std::string kEast = "4,0, 8,0, 8,4, 4,4";
const std::string kToEast =
    "[{'texture': '#808080'}, {'next': 'b'}, {'texture': '#808080'}, {'texture': '#808080'}]";
const std::string kToWest =
    "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'a'}]";

LoadedLevel twoRooms() {
  return loadSectors(sectorText("a", kRoom, kToEast) + "," + sectorText("b", kEast, kToWest));
}

TEST(Position, isFoundWithAndWithoutTheNameOfItsSector) {
  const LoadedLevel loaded = twoRooms();
  EXPECT_EQ(locatePosition(loaded.scene(), {6, 1, 1}, std::nullopt), SectorId(1));
  EXPECT_EQ(locatePosition(loaded.scene(), {6, 1, 1}, "b"), SectorId(1));
}

TEST(Position, onACommonBoundaryTakesTheFirstSectorOrTheNamedOne) {
  const LoadedLevel loaded = twoRooms();
  EXPECT_EQ(locatePosition(loaded.scene(), {4, 1, 1}, std::nullopt), SectorId(0));
  EXPECT_EQ(locatePosition(loaded.scene(), {4, 1, 1}, "b"), SectorId(1));
  EXPECT_EQ(locatePosition(loaded.scene(), {4, 4, 0}, std::nullopt), SectorId(0));
}

TEST(Position, mayMissItsSectorByAMicrometre) {
  const LoadedLevel loaded = twoRooms();
  EXPECT_EQ(locatePosition(loaded.scene(), {-0.9e-6, 1, 4 + 0.9e-6}, "a"), SectorId(0));
  EXPECT_FALSE(locatePosition(loaded.scene(), {-1.1e-6, 1, 1}, "a"));
  EXPECT_FALSE(locatePosition(loaded.scene(), {1, 1, 4 + 1.1e-6}, std::nullopt));
}

TEST(Position, onAWallBetweenSectorsThatAreNotOpenToEachOtherAsksForASector) {
  const LoadedLevel loaded = loadSectors(sectorText("a", kRoom) + "," + sectorText("b", kEast));
  EXPECT_EQ(locatePosition(loaded.scene(), {4, 1, 1}, std::nullopt).error(),
            "(4, 1, 1) lies in several sectors: \"a\", \"b\", say in which with \"sector\"");
  EXPECT_EQ(locatePosition(loaded.scene(), {4, 1, 1}, "b"), SectorId(1));
}

TEST(Position, onAFlatPortalTakesTheFirstOfBothSides) {
  const LoadedLevel loaded =
      loadSectors(sectorText("up", kRoom, "{'texture': '#808080'}",
                             "'floor': {'z': 4, 'next': 'up-down'}, 'ceiling': {'z': 8, "
                             "'texture': '#404040'}") +
                  "," +
                  sectorText("down", kRoom, "{'texture': '#808080'}",
                             "'ceiling': {'z': 4, 'next': 'up-down'}"));
  EXPECT_EQ(locatePosition(loaded.scene(), {1, 1, 4}, std::nullopt), SectorId(0));
  EXPECT_EQ(locatePosition(loaded.scene(), {1, 1, 3}, std::nullopt), SectorId(1));
}

TEST(Position, doesNotCountTheInsideOfAHoleOrOfASlope) {
  const LoadedLevel loaded = loadSectors(
      sectorText("a", kRoom, "{'texture': '#808080'}", "'slopeFloor': {'z': [0, 2, 2, 0]}"));
  EXPECT_TRUE(locatePosition(loaded.scene(), {2, 1, 1}, std::nullopt));
  EXPECT_FALSE(locatePosition(loaded.scene(), {2, 1, 0.99}, std::nullopt));
}

TEST(Position, namesTheSectorThatContainsIt) {
  const LoadedLevel loaded = twoRooms();
  EXPECT_EQ(locatePosition(loaded.scene(), {6, 1, 1}, "a").error(),
            "(6, 1, 1) lies outside its sector \"a\", in \"b\", name that sector, or move it into "
            "\"a\"");
}

TEST(Position, namesTheNearestSectorWhenItIsInNone) {
  const LoadedLevel loaded = twoRooms();
  EXPECT_EQ(locatePosition(loaded.scene(), {6, -3, 8}, std::nullopt).error(),
            "(6, -3, 8) lies in no sector; the nearest is \"b\", 5 m away, move it inside a "
            "sector");
}

TEST(Position, inAnUnknownSectorGetsASuggestion) {
  const LoadedLevel loaded = loadSectors(sectorText("cellar", kRoom));
  EXPECT_EQ(locatePosition(loaded.scene(), {1, 1, 1}, "celar").error(),
            "there is no sector \"celar\", did you mean \"cellar\"?");
}

}  // namespace
}  // namespace hearth
