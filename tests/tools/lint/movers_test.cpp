#include <gtest/gtest.h>

#include "places.h"

namespace hearth::test {
namespace {

/// A hall with a trap that opens where somebody stands on it, and a loft far above the hall.
constexpr std::string_view kTrap = R"({ 'light': 0.5,
  'player': {'x': 1, 'y': 1, 'z': 1.6},
  'movers': {'trap': {'sectors': 'pit', 'part': 'floor', 'to': -1, 'trigger': 'enter',
    'zones': ['pit']}},
  'sectors': {
    'hall': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 9, 'texture': '#808080'},
      'loops': {'border': {'v': [0,0, 2,0, 2,2, 0,2], 'walls': [
        {'texture': '#808080'}, {'next': 'pit', 'texture': '#808080'}, {'texture': '#808080'},
        {'next': 'loft', 'texture': '#808080'}]}}},
    'pit': { 'floor': {'texture': '#808080'}, 'ceiling': {'z': 9, 'texture': '#808080'},
      'loops': {'border': {'v': [2,0, 4,0, 4,2, 2,2], 'walls': [
        {'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'},
        {'next': 'hall', 'texture': '#808080'}]}}},
    'loft': { 'floor': {'z': 6, 'texture': '#808080'}, 'ceiling': {'z': 9, 'texture': '#808080'},
      'loops': {'border': {'v': [-2,0, 0,0, 0,2, -2,2], 'walls': [
        {'texture': '#808080'}, {'next': 'hall', 'texture': '#808080'}, {'texture': '#808080'},
        {'texture': '#808080'}]}}}
}})";

TEST(IdleMovers, AreNoneWhereThePlayerEntersTheirZones) {
  EXPECT_EQ(placesOf(findIdleMovers, kTrap), Places{});
}

TEST(IdleMovers, AreThoseThatNothingStarts) {
  const std::string level =
      with(kTrap, "'trigger': 'enter',\n    'zones': ['pit']", "'trigger': 'none'");
  EXPECT_EQ(placesOf(findIdleMovers, level), (Places{"3:14 /movers/trap [idle-mover]"}));
  EXPECT_EQ(firstMessage(findIdleMovers, level), "nothing starts mover \"trap\"");
}

TEST(IdleMovers, AreNoneThatAWallStarts) {
  const std::string idle =
      with(kTrap, "'trigger': 'enter',\n    'zones': ['pit']", "'trigger': 'none'");
  EXPECT_EQ(placesOf(findIdleMovers, with(idle, "{'next': 'pit', 'texture'",
                                          "{'next': 'pit', 'use': 'trap', 'texture'")),
            Places{});
  EXPECT_EQ(placesOf(findIdleMovers, with(idle, "{'next': 'pit', 'texture'",
                                          "{'next': 'pit', 'cross': 'trap', 'texture'")),
            Places{});
}

TEST(Zones, AreFoundThatThePlayerCannotGetTo) {
  const std::string level = with(kTrap, "'zones': ['pit']", "'zones': ['pit', 'loft']");
  EXPECT_EQ(placesOf(findIdleMovers, level),
            (Places{"4:22 /movers/trap/zones/1 [unentered-zone]"}));
  EXPECT_EQ(firstMessage(findIdleMovers, level),
            "the player cannot get to zone \"loft\" of mover \"trap\"");
}

}  // namespace
}  // namespace hearth::test
