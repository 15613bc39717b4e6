#include <fmt/format.h>
#include <gtest/gtest.h>

#include "places.h"
#include "support/level_text.h"

namespace hearth::test {
namespace {

/// What stands between a hall and a chamber, and the portal of the hall, and that of the chamber.
struct Between {
  std::string_view mover;
  double floor = 0;
  double ceiling = 4;
  std::string_view hallPortal{};
  std::string_view chamberPortal{};
  double chamberFloor = 0;
};

/// A hall, where the player is, a narrow sector and a chamber, in a row to the east. Nothing moves
/// but the narrow one.
std::string row(const Between& between) {
  const std::string solid = "{'texture': '#808080'}";
  const auto walls = [&](const std::string& east, const std::string& west) {
    return "[" + solid + "," + east + "," + solid + "," + west + "]";
  };
  const auto portal = [](std::string_view next, std::string_view more = "") {
    return fmt::format("{{'next': '{}', 'texture': '#808080'{}}}", next, more);
  };
  return fmt::format(
      "{{'light': 1, 'player': {{'x': 1, 'y': 1, 'z': 1.6}},\n'movers': {{'it': {{'sectors': "
      "'way', {}}}}}, 'sectors': {{{},{},{}}}}}",
      between.mover,
      sectorText("hall", "0,0, 9,0, 9,4, 0,4", 0, 4,
                 walls(portal("way", between.hallPortal), solid)),
      sectorText("way", "9,0, 10,0, 10,4, 9,4", between.floor, between.ceiling,
                 walls(portal("chamber"), portal("hall"))),
      sectorText("chamber", "10,0, 14,0, 14,4, 10,4", between.chamberFloor,
                 between.chamberFloor + 4, walls(solid, portal("way", between.chamberPortal))));
}

constexpr std::string_view kUse = ", 'use': 'it'";
constexpr std::string_view kCross = ", 'cross': 'it'";
const Places kFound{"2:12 /movers/it [shut-in]"};
const Places kNone;

std::string door(std::string_view more, std::string_view hallPortal,
                 std::string_view chamberPortal) {
  const std::string mover = fmt::format("'part': 'ceiling', 'to': 3{}", more);
  return row(
      {.mover = mover, .ceiling = 0, .hallPortal = hallPortal, .chamberPortal = chamberPortal});
}

TEST(ShutIn, IsWhoeverPassesADoorThatShutsAndOpensFromOneSideOnly) {
  const std::string level = door(", 'wait': 3", kUse, "");
  EXPECT_EQ(placesOf(findShutIn, level), kFound);
  EXPECT_EQ(firstMessage(findShutIn, level),
            "mover \"it\" shuts the player in: once it is back, nothing leads out of sector "
            "\"chamber\"");
}

TEST(ShutIn, IsNobodyByADoorThatOpensFromBothSides) {
  EXPECT_EQ(placesOf(findShutIn, door(", 'wait': 3", kUse, kUse)), kNone);
  EXPECT_EQ(placesOf(findShutIn, door(", 'wait': 3, 'trigger': 'use'", "", "")), kNone);
  EXPECT_EQ(placesOf(findShutIn, door(", 'wait': 3, 'trigger': 'loop'", "", "")), kNone);
}

TEST(ShutIn, IsNobodyByADoorThatStaysOpen) {
  EXPECT_EQ(placesOf(findShutIn, door("", kUse, "")), kNone);
}

TEST(ShutIn, IsWhoeverOpensADoorFromZonesThatAreAllOutside) {
  const std::string zones = ", 'wait': 3, 'trigger': 'enter', 'zones': ";
  EXPECT_EQ(placesOf(findShutIn, door(zones + "['hall']", "", "")), kFound);
  EXPECT_EQ(placesOf(findShutIn, door(zones + "['hall', 'chamber']", "", "")), kNone);
}

TEST(ShutIn, IsWhoeverCrossesIntoADoorThatShutsForEver) {
  const std::string_view closing = "'part': 'ceiling', 'to': 0";
  EXPECT_EQ(placesOf(findShutIn, row({.mover = closing, .chamberPortal = kCross})), kNone)
      << "who comes out of the chamber is in the larger part";
  const std::string level =
      with(row({.mover = closing}), "{'next': 'chamber',", "{'next': 'chamber', 'cross': 'it',");
  EXPECT_EQ(placesOf(findShutIn, level), kFound);
}

TEST(ShutIn, IsWhoeverSinksIntoAPitForEver) {
  const std::string pit = "'part': 'floor', 'to': -3, 'trigger': 'enter', 'zones': 'way'";
  const std::string level = row({.mover = pit, .chamberFloor = -3});
  EXPECT_EQ(placesOf(findShutIn, level), kFound);
  EXPECT_EQ(firstMessage(findShutIn, level),
            "mover \"it\" shuts the player in: once it has moved, nothing leads out of sector "
            "\"way\"");
}

/// It returns without whoever has left it.
TEST(ShutIn, IsWhoeverGetsOffALiftThatNothingBelowCalls) {
  const std::string lift = "'part': 'floor', 'to': -3, 'wait': 3, 'trigger': ";
  EXPECT_EQ(
      placesOf(findShutIn, row({.mover = lift + "'enter', 'zones': 'way'", .chamberFloor = -3})),
      kFound);
  EXPECT_EQ(placesOf(findShutIn, row({.mover = lift + "'use'", .chamberFloor = -3})), kNone);
  EXPECT_EQ(placesOf(findShutIn, row({.mover = lift + "'loop'", .chamberFloor = -3})), kNone);
}

TEST(ShutIn, IsNobodyByWhatIsLowEnoughToLeapOver) {
  const std::string pit = "'part': 'floor', 'to': -0.9, 'trigger': 'enter', 'zones': 'way'";
  EXPECT_EQ(placesOf(findShutIn, row({.mover = pit})), kNone);
}

TEST(ShutIn, IsNotSaidOfPitsInWhichNothingMoves) {
  const std::string door = "'part': 'ceiling', 'to': 3, 'wait': 3, 'trigger': 'use'";
  EXPECT_EQ(placesOf(findShutIn, row({.mover = door, .chamberFloor = -3})), kNone);
}

}  // namespace
}  // namespace hearth::test
