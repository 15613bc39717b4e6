#include "import/doom/things.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>

#include "map_builder.h"
#include "pictures_builder.h"

namespace hearth::doom {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uint16_t kCandle = 34;
constexpr std::uint16_t kColumn = 48;
constexpr std::uint16_t kHangedSolid = 50;
constexpr std::uint16_t kHanged = 59;
constexpr std::uint16_t kHangedLow = 61;
constexpr std::uint16_t kKeycard = 5;
constexpr std::uint16_t kImp = 3001;

/// The image of the imp sinks 5 pixels into the floor, and is not in the middle.
WadBuilder spritesWad() {
  WadBuilder wad;
  wad.add("PLAYPAL", palette()).add("S_START");
  wad.add("CANDA0", plainPatch(16, 16, 1, {8, 16}));
  wad.add("ELECA0", plainPatch(32, 128, 2, {16, 128}));
  wad.add("GOR2A0", plainPatch(32, 64, 3, {16, 80}));
  wad.add("GOR3A0", plainPatch(32, 50, 3, {16, 83}));
  for (const char* lump : {"BKEYA0", "BKEYB0"}) wad.add(lump, plainPatch(16, 16, 4, {8, 24}));
  for (const char* frame : {"TROOA", "TROOB"})
    for (const char* side : {"1", "2", "3", "4", "5", "6", "7", "8"})
      wad.add(std::string(frame) + side, plainPatch(40, 61, 5, {16, 56}));
  return wad.add("S_END");
}

class ThingsOfAMap : public testing::Test, protected MapBuilder {
 protected:
  ThingsOfAMap() : wad_(opened(spritesWad())), pictures_(*Pictures::read(wad_)) {}

  Json things() {
    findings_.clear();
    const auto plan = GroundPlan::of(map, Doors::Closed, findings_).value();
    Materials materials(pictures_, map.name, findings_);
    Sprites sprites(pictures_, materials, findings_);
    return spritesJson(plan, sprites, settings_, findings_);
  }

  /// One thing in a room of 8 m; what the level has of it.
  Json thing(std::uint16_t type, int angle = 0, int floor = 32, int ceiling = 160) {
    map = {};
    walls(sector(floor, ceiling), square(0, 0, 256));
    map.things.push_back({64, 96, angle, type, 7});
    const Json made = things();
    return made.empty() ? Json() : made.at(0);
  }

  Wad wad_;
  Pictures pictures_;
  Findings findings_;
  ThingSettings settings_;
};

TEST_F(ThingsOfAMap, standOnTheFloorWhereTheMapHasThem) {
  EXPECT_EQ(thing(kCandle), (Json{{"name", "candle"},
                                  {"sprite", "sprite-canda0"},
                                  {"x", 2},
                                  {"y", -3},
                                  {"sector", "0"},
                                  {"size", {0.5, 0.5}},
                                  {"bright", true}}));
}

TEST_F(ThingsOfAMap, haveTheirImagesWhereTheirOffsetsPutThem) {
  const Json key = thing(kKeycard);
  EXPECT_EQ(key["frames"], (Json{"sprite-bkeya0", "sprite-bkeyb0"}));
  EXPECT_EQ(key["fps"], 3.5);
  EXPECT_EQ(key["offset"], (Json{0, 0.25}));
  EXPECT_FALSE(key.contains("bright")) << "only one of its frames is";
}

TEST_F(ThingsOfAMap, areSolidAsInDoomAndAsHighAsTheyLook) {
  const Json column = thing(kColumn);
  EXPECT_EQ(column["radius"], 0.5);
  EXPECT_EQ(column["height"], 4) << "as high as its image";
  EXPECT_FALSE(thing(kCandle).contains("radius"));
}

TEST_F(ThingsOfAMap, hangFromTheCeiling) {
  const Json hanged = thing(kHangedSolid);
  EXPECT_EQ(hanged["z"], (160 - 84) / 32.0);
  EXPECT_EQ(hanged["offset"], (Json{0, 0.5}));
  EXPECT_EQ(hanged["radius"], 0.5);
  EXPECT_EQ(hanged["height"], 84 / 32.0) << "one passes below";
}

TEST_F(ThingsOfAMap, doNotHangBelowTheFloor) { EXPECT_EQ(thing(kHanged, 0, 32, 64)["z"], 1); }

TEST_F(ThingsOfAMap, areRaisedOutOfTheFloor) {
  settings_.hasMonsters = true;
  const Json imp = thing(kImp);
  EXPECT_EQ(imp["size"], (Json{1.25, 61 / 32.0}));
  EXPECT_EQ(imp["offset"], (Json{4 / 32.0, 0}));
}

TEST_F(ThingsOfAMap, areLoweredOutOfTheCeiling) {
  const Json hanged = thing(kHangedLow);
  EXPECT_EQ(hanged["z"], (160 - 52) / 32.0);
  EXPECT_EQ(hanged["offset"], (Json{0, 2 / 32.0})) << "its image ends where it does";
}

TEST_F(ThingsOfAMap, faceWhereTheMapTurnsThemToAnEighthOfATurn) {
  settings_.hasMonsters = true;
  EXPECT_EQ(thing(kImp, 90)["angle"], 270) << "north";
  EXPECT_EQ(thing(kImp, 134)["angle"], 270);
  EXPECT_FALSE(thing(kCandle, 90).contains("angle")) << "it looks alike from all sides";
}

TEST_F(ThingsOfAMap, areMonstersOnlyIfTheyAreAskedFor) {
  EXPECT_TRUE(thing(kImp).is_null());
  EXPECT_TRUE(findings_.empty());
  settings_.hasMonsters = true;
  EXPECT_EQ(things().at(0)["frames"][1][0], "sprite-troob1");
}

TEST_F(ThingsOfAMap, areThoseOfTheGame) {
  walls(sector(), square(0, 0, 256));
  using Flags = std::initializer_list<std::uint16_t>;
  for (const std::uint16_t flags : Flags{1, 2, 4, 7 | 16})
    map.things.push_back({10 * flags, 96, 0, kCandle, flags});
  const auto placesInGame = [&](const Game& game) {
    settings_.game = game;
    Json places = Json::array();
    for (const Json& made : things()) places.push_back(made["x"].get<double>() * 32);
    return places;
  };
  EXPECT_EQ(placesInGame({}), (Json{20}));
  for (const int skill : {1, 2}) EXPECT_EQ(placesInGame({.skill = skill}), (Json{10}));
  for (const int skill : {4, 5}) EXPECT_EQ(placesInGame({.skill = skill}), (Json{40}));
  EXPECT_EQ(placesInGame({.skill = 3, .isMultiplayer = true}), (Json{20, 230}));
}

TEST_F(ThingsOfAMap, areNoStartsOfPlayersNorLandingsOfTeleports) {
  walls(sector(), square(0, 0, 256));
  using Types = std::initializer_list<std::uint16_t>;
  for (const std::uint16_t type : Types{1, 2, 3, 4, 11, 14, 87, 89})
    map.things.push_back({64, 96, 0, type, 7});
  EXPECT_TRUE(things().empty());
  EXPECT_TRUE(findings_.empty());
}

TEST_F(ThingsOfAMap, areReportedOncePerTypeIfTheyCannotBeShown) {
  walls(sector(), square(0, 0, 256));
  for (const std::uint16_t type : {kCandle, std::uint16_t{9999}, std::uint16_t{2035},
                                   std::uint16_t{9999}, std::uint16_t{9999}})
    map.things.push_back({64, 96, 0, type, 7});
  map.things.push_back({640, 96, 0, kCandle, 7});
  EXPECT_EQ(things().size(), 1U);
  ASSERT_EQ(findings_.size(), 3U);
  for (const Finding& finding : findings_) EXPECT_EQ(finding.outcome, Outcome::Dropped);
  EXPECT_EQ(findings_[0].number, 5U);
  EXPECT_EQ(findings_[0].what, "it stands in no sector");
  EXPECT_EQ(findings_[1].number, 1U);
  EXPECT_EQ(findings_[1].what, "its type, 9999, is unknown; 2 other things are dropped for that");
  EXPECT_EQ(findings_[2].number, 2U);
  EXPECT_EQ(findings_[2].what, "there is no sprite BAR1A");
}

TEST_F(ThingsOfAMap, areNoMoreThanTheLoaderTakes) {
  walls(sector(), square(0, 0, 256));
  for (int i = 0; i < 4; ++i) map.things.push_back({64, 96, 0, kKeycard, 7});
  settings_.maxImages = 5;
  EXPECT_EQ(things().size(), 2U) << "each has two frames";
  ASSERT_EQ(findings_.size(), 1U);
  EXPECT_EQ(findings_[0].number, 2U);
  EXPECT_EQ(findings_[0].what,
            "its sprite and those of what follows: with it, sprites have more than 5 images");
}

TEST(AllThings, areWhatTheMapSays) {
  Map map;
  map.things.push_back({32, 64, 180, 3004, 7});
  EXPECT_EQ(allThingsJson(map),
            (Json::array({{{"type", 3004}, {"x", 1}, {"y", -2}, {"angle", 180}, {"flags", 7}}})));
}

}  // namespace
}  // namespace hearth::doom
