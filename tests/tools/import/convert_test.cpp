#include "import/doom/convert.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "map_builder.h"
#include "pictures_builder.h"

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// Pictures of which walls are 64 x 128, but TALL, which has 256 rows, and skies.
WadBuilder picturesWad() {
  WadBuilder wad;
  wad.add("PLAYPAL", palette()).add("PNAMES", patchNames({"PATCH"}));
  std::vector<std::string> textures;
  for (const char* name : {"UPPER", "LOWER", "WALL"})
    textures.push_back(definition(name, 64, 128, {{0, 0, 0}}));
  textures.push_back(definition("TALL", 64, 256, {{0, 0, 0}}));
  textures.push_back(definition("SKY1", 256, 128, {{0, 0, 0}}));
  textures.push_back(definition("GRATE", 64, 128, {{0, 0, 0}}));
  wad.add("TEXTURE1", texturesOf(textures)).add("PATCH", plainPatch(64, 128, 9));
  return wad.add("F_START").add("FLOOR", flatOf(1)).add("CEIL", flatOf(2)).add("F_END");
}

class LevelOfAMap : public testing::Test, protected MapBuilder {
 protected:
  LevelOfAMap() : wad_(opened(picturesWad())), pictures_(*Pictures::read(wad_)) {}

  Json level(double ambient = 0.5) {
    findings_.clear();
    materials_.emplace(pictures_, map.name, findings_);
    const auto plan = GroundPlan::of(map, Doors::Open, findings_).value();
    return levelJson(plan, ambient, *materials_, findings_);
  }
  static Json wall(const Json& level, const char* sector, std::size_t i) {
    return level["sectors"][sector]["loops"]["border"]["walls"][i];
  }
  static double x(const Json& level, const char* sector, std::size_t i) {
    return level["sectors"][sector]["loops"]["border"]["v"][2 * i];
  }

  /// The wall of a sector that leads to another.
  static Json portal(const Json& level, const char* sector) {
    for (const Json& wall : level["sectors"][sector]["loops"]["border"]["walls"])
      if (wall.contains("next")) return wall;
    ADD_FAILURE() << sector << " leads nowhere";
    return {};
  }

  /// Two rooms of 2 m beside each other, of which the second one is less high; the line between
  /// them.
  Line& openRooms() {
    const auto a = sector(0, 128);
    const auto b = sector(32, 96);
    line({64, 0}, {0, 0}, a);
    line({0, 0}, {0, 64}, a);
    line({0, 64}, {64, 64}, a);
    line({64, 64}, {128, 64}, b);
    line({128, 64}, {128, 0}, b);
    line({128, 0}, {64, 0}, b);
    return line({64, 64}, {64, 0}, a, b);
  }

  Wad wad_;
  Pictures pictures_;
  Findings findings_;
  std::optional<Materials> materials_;
};

TEST_F(LevelOfAMap, hasAMetreTo32UnitsAndYDown) {
  walls(sector(-16, 128), {{32, 64}, {32, 128}, {96, 128}, {96, 64}});
  const Json sector = level()["sectors"]["0"];
  EXPECT_EQ(sector["floor"]["z"], -0.5);
  EXPECT_EQ(sector["ceiling"]["z"], 4);
  std::set<std::pair<double, double>> points;
  const Json& v = sector["loops"]["border"]["v"];
  for (std::size_t i = 0; i < v.size(); i += 2) points.emplace(v[i], v[i + 1]);
  EXPECT_EQ(points, (std::set<std::pair<double, double>>{{1, -2}, {1, -4}, {3, -4}, {3, -2}}));
}

TEST_F(LevelOfAMap, hasTheSectorsLightAsAShareOfTheMaps) {
  walls(sector(), square(0, 0, 64));
  map.sectors[0].light = 204;
  EXPECT_EQ(level(0.5)["sectors"]["0"]["light"], 0.4);
  EXPECT_EQ(level(1)["sectors"]["0"]["light"], 0.8);
}

TEST_F(LevelOfAMap, hangsWallsFromTheCeilingWithTheirOffsetsInTexels) {
  walls(sector(), square(0, 0, 64));
  for (Side& side : map.sides) {
    side.xOffset = 5;
    side.yOffset = -7;
  }
  EXPECT_EQ(wall(level(), "0", 0)["texture"],
            (Json{{"name", "wall-wall"}, {"scale", {2, 4}}, {"offset", {-5, 7}}}));
}

TEST_F(LevelOfAMap, standsWallsOnTheFloorWhereTheyAreUnpeggedBelow) {
  walls(sector(-32, 64), square(0, 0, 64));
  for (Line& line : map.lines) line.flags = 0x10;
  for (Side& side : map.sides) side.middle = "TALL";
  EXPECT_EQ(wall(level(), "0", 0)["texture"]["zref"], -1 + 8) << "the image is 8 m high";
}

TEST_F(LevelOfAMap, showsOnlyTheStepsThatThereAre) {
  openRooms();
  EXPECT_EQ(portal(level(), "0"), (Json{{"next", "1"},
                                        {"lower", {{"name", "wall-lower"}, {"scale", {2, 4}}}},
                                        {"upper", {{"name", "wall-upper"}, {"scale", {2, 4}}}}}));
  EXPECT_EQ(portal(level(), "1"), (Json{{"next", "0"}}));
}

TEST_F(LevelOfAMap, hangsStepsFromTheCeilingWhereTheyAreUnpegged) {
  Line& line = openRooms();
  line.flags = 0x18;
  const Json wall = portal(level(), "0");
  EXPECT_EQ(wall["upper"]["zref"], 4);
  EXPECT_EQ(wall["lower"]["zref"], 4);
}

TEST_F(LevelOfAMap, hangsLowerStepsBetweenSkiesFromTheCeilingBehind) {
  Line& line = openRooms();
  line.flags = 0x10;
  for (Sector& sector : map.sectors) sector.ceilingFlat = "F_SKY1";
  const Json wall = portal(level(), "0");
  EXPECT_EQ(wall["lower"]["zref"], 3);
  EXPECT_FALSE(wall.contains("upper")) << "sky shows";
}

TEST_F(LevelOfAMap, hasTheSkyAsDoomDrawsIt) {
  walls(sector(), square(0, 0, 64));
  map.sectors[0].ceilingFlat = "F_SKY1";
  const Json ceiling = level()["sectors"]["0"]["ceiling"];
  EXPECT_EQ(ceiling["parallax"], true);
  EXPECT_EQ(ceiling["texture"],
            (Json{{"name", "sky-sky1"}, {"scale", {0.25, 0.8}}, {"offset", {0, 28}}}));
}

TEST_F(LevelOfAMap, tellsOfStepsThatHaveNoTextureAndShowsTheFlatBehind) {
  Line& line = openRooms();
  sideOf(line).lower = "-";
  EXPECT_EQ(portal(level(), "0")["lower"], "flat-floor 2,2");
  const auto told = std::ranges::find(findings_, Part::Line, &Finding::part);
  ASSERT_NE(told, findings_.end());
  EXPECT_EQ(told->number, 6U);
}

TEST_F(LevelOfAMap, hangsMiddleTexturesFromTheLowerCeiling) {
  Line& line = openRooms();
  sideOf(line, 1).middle = "GRATE";
  sideOf(line, 1).xOffset = 3;
  sideOf(line, 1).yOffset = -8;
  EXPECT_EQ(
      portal(level(), "1")["middle"],
      (Json{{"name", "wall-grate"}, {"scale", {2, 4}}, {"offset", {-3, 0}}, {"zref", 3 - 0.25}}));
  EXPECT_FALSE(portal(level(), "0").contains("middle")) << "that side has none";
}

TEST_F(LevelOfAMap, standsMiddleTexturesOnTheHigherFloorWhereTheyAreUnpeggedBelow) {
  Line& line = openRooms();
  line.flags = 0x10;
  sideOf(line, 0).middle = "GRATE";
  sideOf(line, 0).yOffset = 16;
  EXPECT_EQ(portal(level(), "0")["middle"]["zref"], 1 + 4 + 0.5);
}

TEST_F(LevelOfAMap, leavesOutMiddleTexturesThatCannotBeDrawn) {
  Line& line = openRooms();
  sideOf(line, 1).middle = "GONE";
  EXPECT_FALSE(portal(level(), "1").contains("middle"));
  const auto told = std::ranges::find(findings_, Part::Texture, &Finding::part);
  ASSERT_NE(told, findings_.end());
  EXPECT_NE(told->what.find("left out"), std::string::npos) << told->what;
}

TEST_F(LevelOfAMap, tellsOfMiddleTexturesThatHangInNoOpening) {
  Line& line = openRooms();
  sideOf(line, 1).middle = "GRATE";
  map.sectors[1].ceiling = map.sectors[1].floor;
  level();
  const auto told = std::ranges::find(findings_, Part::Line, &Finding::part);
  ASSERT_NE(told, findings_.end());
  EXPECT_EQ(told->outcome, Outcome::Dropped);
  EXPECT_EQ(told->number, 6U);
}

TEST_F(LevelOfAMap, isGreyWhereThePicturesAreMissing) {
  walls(sector(), square(0, 0, 64));
  for (Side& side : map.sides) side.middle = "GONE";
  map.sectors[0].floorFlat = "GONE";
  const Json made = level();
  EXPECT_EQ(wall(made, "0", 0)["texture"], "#606060");
  EXPECT_EQ(made["sectors"]["0"]["floor"]["texture"], "#606060");
  EXPECT_EQ(std::ranges::count(findings_, Part::Texture, &Finding::part), 2) << "each is told once";
}

TEST_F(LevelOfAMap, hasThePlayerOfDoomWhereTheFirstOneStarts) {
  walls(sector(32), square(0, 0, 128));
  map.things.push_back({500, 500, 0, 1, 7});  // outside
  map.things.push_back({32, 64, 90, 1, 7});
  const Json player = level()["player"];
  EXPECT_EQ(player["x"], 1);
  EXPECT_EQ(player["y"], -2);
  EXPECT_EQ(player["z"], 1 + 41.0 / 32);
  EXPECT_EQ(player["angle"], 270) << "north";
  EXPECT_EQ(player["height"], 1.75);
  EXPECT_EQ(player["step"], 0.75);
  EXPECT_EQ(player["radius"], 0.5);
}

TEST_F(LevelOfAMap, hasThePlayerInAnotherStartWhereItsOwnHasNoRoom) {
  const auto low = sector(0, 55);
  const auto high = sector(0, 56);
  walls(low, square(0, 0, 64));
  walls(high, square(128, 0, 64));
  map.things.push_back({32, 32, 90, 1, 7});
  map.things.push_back({160, 32, 0, 11, 7});
  EXPECT_EQ(level()["player"]["sector"], "1");
  const auto told = std::ranges::find(findings_, Part::Thing, &Finding::part);
  ASSERT_NE(told, findings_.end());
  EXPECT_EQ(told->number, 1U);
  EXPECT_EQ(told->outcome, Outcome::Repaired);
}

TEST_F(LevelOfAMap, hasThePlayerBeforeTheLongestWallWithRoomWhereNoStartHas) {
  walls(sector(0, 0), square(0, 0, 640));
  walls(sector(0, 128), square(-64, 0, 40));
  walls(sector(0, 128), square(1024, 0, 128));
  map.things.push_back({32, 32, 90, 1, 7});
  const Json player = level()["player"];
  EXPECT_EQ(player["sector"], "2");
  EXPECT_EQ(player["z"], 41.0 / 32);
  const auto told = std::ranges::find(findings_, Part::Sector, &Finding::part);
  ASSERT_NE(told, findings_.end());
  EXPECT_EQ(told->number, 2U);
}

TEST_F(LevelOfAMap, hasNoPlayerWhereNoneHasRoom) {
  walls(sector(0, 40), square(0, 0, 128));
  map.things.push_back({32, 32, 90, 1, 7});
  EXPECT_FALSE(level().contains("player"));
  EXPECT_EQ(std::ranges::count(findings_, Outcome::Dropped, &Finding::outcome), 1);
}

TEST_F(LevelOfAMap, isGreyWhereItsImagesWouldHaveTooManyPixels) {
  walls(sector(), square(0, 0, 64));
  Findings findings;
  Materials materials(pictures_, map.name, findings, 64 * 128 + 64 * 64);
  EXPECT_EQ(materials.wall("WALL", {})["name"], "wall-wall");
  EXPECT_EQ(materials.wall("UPPER", {}), "#606060");
  EXPECT_EQ(materials.flat("FLOOR"), "flat-floor 2,2");
  EXPECT_EQ(materials.flat("CEIL"), "#606060");
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].what,
            "wall texture UPPER and the images before it have more pixels than a level's images "
            "may: it is grey");
}

TEST(FileNames, areOfOneFolder) {
  EXPECT_EQ(fileName("FLOOR5_2"), "floor5_2");
  EXPECT_EQ(fileName("../A.B"), "+2e+2e+2fa+2eb");
  EXPECT_NE(fileName("VILE[1"), fileName("VILE\\1"));
}

}  // namespace

}  // namespace hearth::doom
