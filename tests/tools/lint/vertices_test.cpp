#include <gtest/gtest.h>

#include "places.h"

namespace hearth::test {

namespace {

/// Two rooms with a doorway between them, whose corners at (5, 0) are to be one.
constexpr std::string_view kTwoRooms = R"({ 'light': 0.5, 'sectors': {
  'a': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'}, 'loops': {'border': {
      'v': [0,0, 5,0, 5,1, 5,3, 0,3], 'walls': [
      {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'b'}, {'texture': '#808080'},
      {'texture': '#808080'}]}}},
  'b': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'}, 'loops': {'border': {
      'v': [5.004,0, 9,0, 9,3, 5,3, 5,1], 'walls': [
      {'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'a'},
      {'texture': '#808080'}]}}}
}})";

TEST(NearMisses, AreFoundBetweenCornersOfLinkedSectors) {
  EXPECT_EQ(placesOf(findNearMisses, kTwoRooms),
            (Places{"3:18 /sectors/a/loops/border/v/2 [near-miss]"}));
  EXPECT_EQ(firstMessage(findNearMisses, kTwoRooms),
            "the vertex (5, 0) misses the vertex (5.004, 0) of sector \"b\" by 4 mm");
}

TEST(NearMisses, AreNoneWhereVerticesCoincideOrWouldBeWelded) {
  for (const char* x : {"5", "5.0009", "4.9991"})
    EXPECT_EQ(placesOf(findNearMisses, with(kTwoRooms, "5.004,0", std::string(x) + ",0")), Places{})
        << x;
}

TEST(NearMisses, AreNoneWhereThingsAreWellApart) {
  EXPECT_EQ(placesOf(findNearMisses, with(kTwoRooms, "5.004,0", "5.01,0")), Places{});
}

/// A room with a pillar, whose corner (4, 2) comes near the wall x = 4 of the room.
constexpr std::string_view kPillar = R"({ 'light': 0.5, 'sectors': {
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'}, 'loops': {
    'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': {'texture': '#808080'}},
    'pillar': {'v': [2,2, 3,3, 3.997,2, 3,1], 'walls': {'texture': '#808080'}}
  }}
}})";

TEST(NearMisses, AreFoundBetweenAVertexAndAWallOfOneSector) {
  EXPECT_EQ(placesOf(findNearMisses, kPillar),
            (Places{"4:32 /sectors/room/loops/pillar/v/4 [near-miss]"}));
  EXPECT_EQ(firstMessage(findNearMisses, kPillar),
            "the vertex (3.997, 2) misses a wall at (4, 2) of sector \"room\" by 3 mm");
}

TEST(NearMisses, AreNoneWhereAVertexLiesOnTheWall) {
  EXPECT_EQ(placesOf(findNearMisses, with(kPillar, "3.997,2", "4,2")), Places{});
}

TEST(NearMisses, AreFoundInAWallAsShortAsAHair) {
  const std::string level = with(kPillar, "0,0, 4,0, 4,4, 0,4", "0,0, 4,0, 4,4, 0.003,4, 0,4");
  EXPECT_EQ(placesOf(findNearMisses, with(level, "3.997,2", "3.5,2")),
            (Places{"3:37 /sectors/room/loops/border/v/6 [near-miss]"}));
}

TEST(NearMisses, AreNoneInAThinPane) {
  for (const char* pane : {"1,2, 1,2.003, 3,2.003, 3,2", "1,2, 1,2.003, 2,2.003, 3,2.003, 3,2"}) {
    const std::string level = with(kPillar, "2,2, 3,3, 3.997,2, 3,1", pane);
    EXPECT_EQ(placesOf(findNearMisses, level), Places{}) << pane;
  }
}

TEST(NearMisses, AreNoneBetweenSectorsThatKnowNothingOfEachOther) {
  const std::string unlinked = with(with(kTwoRooms, "{'next': 'b'}", "{'texture': '#808080'}"),
                                    "{'next': 'a'}", "{'texture': '#808080'}");
  EXPECT_EQ(placesOf(findNearMisses, unlinked), Places{});
}

}  // namespace

}  // namespace hearth::test
