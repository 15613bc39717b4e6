#include <gtest/gtest.h>

#include "places.h"

namespace hearth::test {

namespace {

/// A hall whose wall opens to two rooms: both lead back, one over the half of its wall only.
constexpr std::string_view kHalfWayBack = R"({ 'light': 0.5, 'sectors': {
  'hall': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [0,0, 6,0, 6,4, 0,4], 'walls': [
      {'texture': '#808080'},
      {'next': 'room'},
      {'texture': '#808080'},
      {'texture': '#808080'}]}}},
  'room': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
    'loops': {'border': {'v': [6,0, 9,0, 9,4, 6,4, 6,2], 'walls': [
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'texture': '#808080'},
      {'next': 'hall'},
      {'texture': '#707070'}]}}}
}})";

TEST(OneWayPortals, AreFoundOverThePartThatDoesNotLeadBack) {
  EXPECT_EQ(placesOf(findOneWayPortals, kHalfWayBack),
            (Places{"5:7 /sectors/hall/loops/border/walls/1 [one-way-portal]"}));
  EXPECT_EQ(firstMessage(findOneWayPortals, kHalfWayBack),
            "the portal to sector \"room\" does not lead back from (6, 0) to (6, 2)");
}

TEST(OneWayPortals, ThatEndFiveCentimetresApartAreToldToEndInOnePoint) {
  const std::string nearly = with(kHalfWayBack, "6,4, 6,2]", "6,4, 6,0.05]");
  EXPECT_EQ(advicesOf(findOneWayPortals, nearly),
            std::vector<std::string>{"let the portals of both sectors end in one point: (6, 0) "
                                     "misses (6, 0.05) by 0.05 m"});
}

TEST(OneWayPortals, AreNoneWhereAllOfThemLeadBack) {
  const std::string mended = with(kHalfWayBack, "{'texture': '#707070'}", "{'next': 'hall'}");
  EXPECT_EQ(placesOf(findOneWayPortals, mended), Places{});
}

TEST(OneWayPortals, AreTheLoadersToTellWhereNoPartLeadsBack) {
  const std::string whole = with(kHalfWayBack, "{'next': 'hall'}", "{'texture': '#808080'}");
  EXPECT_EQ(placesOf(findOneWayPortals, whole), Places{});
}

/// Three rooms side by side; the second one leads on to the third.
constexpr std::string_view kUnlinked = R"({ 'light': 0.5,
  'player': {'x': 1, 'y': 1, 'z': 1.6},
  'sectors': {
    'first': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
      'loops': {'border': {'v': [0,0, 2,0, 2,2, 0,2], 'walls': [
        {'texture': '#808080'}, {'texture': '#707070'}, {'texture': '#808080'}, {'texture': '#808080'}]}}},
    'second': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
      'loops': {'border': {'v': [2,0, 4,0, 4,2, 2,2], 'walls': [
        {'texture': '#808080'}, {'next': 'third'}, {'texture': '#808080'}, {'texture': '#606060'}]}}},
    'third': { 'floor': {'texture': '#808080'}, 'ceiling': {'texture': '#808080'},
      'loops': {'border': {'v': [4,0, 6,0, 6,2, 4,2], 'walls': [
        {'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'second'}]}}}
}})";

TEST(UnreachableSectors, AreFoundOnceForAllThatHangTogether) {
  EXPECT_EQ(placesOf(findUnreachable, kUnlinked), (Places{"7:5 /sectors/second [unreachable]"}));
  EXPECT_EQ(firstMessage(findUnreachable, kUnlinked),
            "no links lead from the player to sector \"second\" and 1 other linked with it");
}

TEST(UnreachableSectors, AreThoseOutsideTheLargestPartWithoutAPlayer) {
  const std::string level = with(kUnlinked, "'player': {'x': 1, 'y': 1, 'z': 1.6},", "");
  EXPECT_EQ(placesOf(findUnreachable, level), (Places{"4:5 /sectors/first [unreachable]"}));
}

TEST(UnreachableSectors, AreReachedByALinkThatLeadsThere) {
  const std::string mended = with(kUnlinked, "{'texture': '#707070'}", "{'next': 'second'}");
  EXPECT_EQ(placesOf(findUnreachable, mended), Places{});
}

TEST(UnreachableSectors, AreNotReachedByALinkThatOnlyLeadsAway) {
  const std::string oneWay = with(kUnlinked, "{'texture': '#606060'}", "{'next': 'first'}");
  EXPECT_EQ(placesOf(findUnreachable, oneWay), (Places{"7:5 /sectors/second [unreachable]"}));
}

/// A cellar under a room, with or without a hole between them.
constexpr std::string_view kCellar = R"({ 'light': 0.5,
  'player': {'x': 1, 'y': 1, 'z': 1.6},
  'sectors': {
    'room': { 'floor': {'texture': '#707070'}, 'ceiling': {'z': 3, 'texture': '#808080'},
      'loops': {'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': {'texture': '#808080'}}}},
    'cellar': { 'floor': {'z': -3, 'texture': '#808080'}, 'ceiling': {'z': 0, 'texture': '#606060'},
      'loops': {'border': {'v': [0,0, 4,0, 4,4, 0,4], 'walls': {'texture': '#808080'}}}}
}})";

TEST(UnreachableSectors, AreReachedThroughFlatPortals) {
  EXPECT_EQ(placesOf(findUnreachable, kCellar), (Places{"6:5 /sectors/cellar [unreachable]"}));
  const std::string open = with(with(kCellar, "'texture': '#707070'", "'next': 'room-cellar'"),
                                "'texture': '#606060'", "'next': 'room-cellar'");
  EXPECT_EQ(placesOf(findUnreachable, open), Places{});
}

}  // namespace

}  // namespace hearth::test
