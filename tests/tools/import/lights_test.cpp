#include "import/doom/lights.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "map_builder.h"
#include "pictures_builder.h"

namespace hearth::doom {

namespace {

using Json = nlohmann::ordered_json;

/// A centimetre or so, by which lights are off the places of the map.
constexpr double kBeside = 0.02;

WadBuilder picturesWad() {
  WadBuilder wad;
  wad.add("PLAYPAL", palette()).add("PNAMES", patchNames({"PATCH"}));
  wad.add("TEXTURE1", texturesOf({definition("LITE", 8, 8, {{0, 0, 0}}),
                                  definition("SKY1", 8, 8, {{0, 0, 0}})}));
  wad.add("PATCH", plainPatch(8, 8, 9));
  return wad.add("F_START").add("LAVA", flatOf(1)).add("F_END");
}

class LightsOfAMap : public testing::Test, protected MapBuilder {
 protected:
  LightsOfAMap() : wad_(opened(picturesWad())), pictures_(*Pictures::read(wad_)) {}

  /// With the images of LITE and LAVA.
  Json file() {
    findings_.clear();
    Materials materials(pictures_, map.name, findings_);
    materials.wall("LITE", {});
    materials.flat("LAVA");
    materials.sky();
    return lightsJson(GroundPlan::of(map, Doors::Open, findings_).value(), table_, materials,
                      settings_, findings_);
  }
  Json lights() { return file()["lights"]; }

  Wad wad_;
  Pictures pictures_;
  LightTable table_;
  LightSettings settings_;
  Findings findings_;
};

TEST_F(LightsOfAMap, standWhereThingsShine) {
  walls(sector(32), square(0, 0, 256));
  table_.things[2028] = {.color = "#102030", .height = 1.5};
  map.things.push_back({64, 96, 0, 2028, 7});
  map.things.push_back({64, 96, 0, 2029, 7});
  const Json made = lights();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_NEAR(made[0]["x"], 2, kBeside);
  EXPECT_NEAR(made[0]["y"], -3, kBeside);
  EXPECT_EQ(made[0]["z"], 2.5);
  EXPECT_EQ(made[0]["sector"], "0");
  EXPECT_EQ(made[0]["color"], "#102030");
}

TEST_F(LightsOfAMap, stayBelowTheCeiling) {
  walls(sector(0, 32), square(0, 0, 256));
  table_.things[2028] = {.height = 1.5};
  map.things.push_back({64, 96, 0, 2028, 7});
  EXPECT_EQ(lights().at(0)["z"], 0.75);
}

TEST_F(LightsOfAMap, areNoneOfThingsThatComeOnlyWithOthersOrLieOutside) {
  walls(sector(), square(0, 0, 256));
  table_.things[2028] = {};
  map.things.push_back({64, 96, 0, 2028, 7 | 16});
  map.things.push_back({640, 96, 0, 2028, 7});
  EXPECT_TRUE(lights().empty());
}

TEST_F(LightsOfAMap, areOfTheThingsOfTheGame) {
  walls(sector(), square(0, 0, 256));
  table_.things[2028] = {};
  map.things.push_back({64, 96, 0, 2028, 4});
  map.things.push_back({64, 96, 0, 2028, 7 | 16});
  EXPECT_EQ(lights().size(), 0U);
  settings_.game = {.skill = 5, .isMultiplayer = true};
  EXPECT_EQ(lights().size(), 2U);
}

TEST_F(LightsOfAMap, growWeakerUntilTheirReach) {
  walls(sector(), square(0, 0, 256));
  table_.things[2028] = {.intensity = 200, .falloff = 1, .reach = 9};
  map.things.push_back({64, 96, 0, 2028, 7});
  const Json curve = lights().at(0)["curve"];
  EXPECT_EQ(curve.front(), (Json{0, 200}));
  EXPECT_EQ(curve.back(), (Json{9, 0}));
  for (std::size_t i = 1; i < curve.size(); ++i)
    EXPECT_LT(curve[i][1].get<double>(), curve[i - 1][1].get<double>());
}

TEST_F(LightsOfAMap, mayBeDarkOrFallOffByHardlyAnything) {
  walls(sector(), square(0, 0, 256));
  map.things.push_back({64, 96, 0, 2028, 7});
  for (const Glow& glow : {Glow{.intensity = 0, .falloff = 1}, Glow{.falloff = 1e-300}}) {
    table_.things[2028] = glow;
    const Json curve = lights().at(0)["curve"];
    for (const Json& point : curve) EXPECT_TRUE(point[1].is_number() && point[1] >= 0) << curve;
  }
}

TEST_F(LightsOfAMap, areNoMoreThanALevelMayHave) {
  walls(sector(-32768, 32767), square(-16000, -16000, 32000));
  for (Side& side : map.sides) side.middle = "LITE";
  table_.walls["LITE"] = {};
  EXPECT_EQ(lights().size(), 100'000U);
  EXPECT_EQ(std::ranges::count(findings_, Outcome::Dropped, &Finding::outcome), 1);
}

TEST_F(LightsOfAMap, areFoundQuicklyOnTheLargestFloor) {
  walls(sector(0, 32767), square(-32767, -32767, 65534));
  table_.flats["FLOOR"].every = 0.25;  // 67 million squares
  EXPECT_EQ(lights().size(), 100'000U);
  EXPECT_EQ(std::ranges::count(findings_, Outcome::Dropped, &Finding::outcome), 1);
}

TEST_F(LightsOfAMap, areOnFloorsBetweenPillars) {
  const auto room = sector();
  walls(room, square(0, 0, 512));
  for (auto corners = square(128, 128, 256); const std::size_t i : {3U, 2U, 1U, 0U})
    line(corners[i], corners[(i + 3) % 4], room);
  table_.flats["FLOOR"] = {};
  EXPECT_EQ(lights().size(), 64U - 16U) << "one for each square of 2 m that is no pillar";
}

TEST_F(LightsOfAMap, areEvenlyBeforeWallsThatShine) {
  walls(sector(0, 64), {{0, 0}, {0, 256}, {128, 256}, {128, 0}});
  map.sides[0].middle = "LITE";  // on the left, 8 m
  table_.walls["LITE"] = {.every = 4};
  const Json made = lights();
  ASSERT_EQ(made.size(), 2U);
  for (const Json& light : made) {
    EXPECT_NEAR(light["x"], 0.25, kBeside);
    EXPECT_EQ(light["z"], 1);
  }
  EXPECT_NEAR(made[0]["y"], -2, kBeside);
  EXPECT_NEAR(made[1]["y"], -6, kBeside);
}

TEST_F(LightsOfAMap, areBeforeWallsInNarrowPlaces) {
  walls(sector(0, 64), {{0, 0}, {0, 64}, {4, 64}, {4, 0}});
  map.sides[0].middle = "LITE";
  table_.walls["LITE"] = {};
  const Json made = lights();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_LT(made[0]["x"], 0.125);
}

TEST_F(LightsOfAMap, stayInSectorsThatAreHardlyWiderThanTheirDistance) {
  walls(sector(), {{0, 0}, {256, 250}, {258, 250}, {2, 0}});  // 44 mm
  map.sides[0].middle = "LITE";
  table_.walls["LITE"] = {};
  Findings findings;
  const auto plan = GroundPlan::of(map, Doors::Open, findings).value();
  const Json made = lights();
  EXPECT_FALSE(made.empty());
  for (const Json& light : made) EXPECT_TRUE(plan.contains(0, {light["x"], light["y"]})) << light;
}

TEST_F(LightsOfAMap, areBelowCeilingsAndAboveFloorsThatShine) {
  walls(sector(0, 128), square(0, 0, 128));
  map.sectors[0].ceilingFlat = "TLITE";
  map.sectors[0].floorFlat = "LAVA";
  table_.flats["TLITE"] = {};
  table_.flats["LAVA"] = {.every = 4};
  const Json made = lights();
  ASSERT_EQ(made.size(), 5U);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(made[i]["z"], 3.75);
  EXPECT_EQ(made[4]["z"], 0.25);
  EXPECT_NEAR(made[4]["x"], 2, kBeside) << "in the middle";
}

TEST_F(LightsOfAMap, areInTheMiddleOfASmallPanelWhereverItLies) {
  walls(sector(0, 128), square(50, 50, 64));
  map.sectors[0].ceilingFlat = "TLITE";
  table_.flats["TLITE"] = {};
  const Json made = lights();
  ASSERT_EQ(made.size(), 1U);
  EXPECT_NEAR(made[0]["x"], 82 / 32.0, kBeside);
}

TEST_F(LightsOfAMap, areNoneInClosedSectors) {
  walls(sector(0, 0), square(0, 0, 128));
  map.sectors[0].ceilingFlat = "TLITE";
  table_.flats["TLITE"] = {};
  EXPECT_TRUE(lights().empty());
}

/// A room with a wall, a floor and a thing that shine.
class AreaLightsOfAMap : public LightsOfAMap {
 protected:
  AreaLightsOfAMap() {
    walls(sector(0, 128), square(0, 0, 256));
    map.sides[0].middle = "LITE";
    map.sectors[0].floorFlat = "LAVA";
    map.things.push_back({64, 96, 0, 2028, 7});
    table_.walls["LITE"] = {.color = "#4060ff", .emit = 300};
    table_.flats["LAVA"] = {.color = "#ff4000", .emit = 150};
    table_.things[2028] = {.emit = 100};
    table_.sky = {.color = "#c0d0ff", .intensity = 70};
    table_.sun = {.angle = 120, .pitch = 40, .color = "#fff0d0", .intensity = 110, .size = 1};
    settings_.from = LightFrom::Areas;
  }
};

TEST_F(AreaLightsOfAMap, areItsWallsAndFlatsThemselves) {
  const Json made = file();
  EXPECT_EQ(made["emit"], (Json{{"wall-lite", {{"intensity", 300.0}, {"color", "#4060ff"}}},
                                {"flat-lava", {{"intensity", 150.0}, {"color", "#ff4000"}}}}));
  EXPECT_EQ(made["lights"].size(), 1U) << "the thing";
}

TEST_F(AreaLightsOfAMap, stayPointsWhereTheTableHasNoEmission) {
  table_.walls["LITE"].emit = 0;
  const Json made = file();
  EXPECT_FALSE(made["emit"].contains("wall-lite"));
  EXPECT_GT(made["lights"].size(), 1U);
}

TEST_F(AreaLightsOfAMap, areNoneOfImagesThatCannotBeDrawn) {
  map.sides[0].middle = "NONE";
  table_.walls["NONE"] = {.emit = 300};
  EXPECT_FALSE(file()["emit"].contains("wall-none"));
}

TEST_F(AreaLightsOfAMap, areTheSkyAndASunWhereItHasASky) {
  EXPECT_FALSE(file().contains("sky"));
  EXPECT_FALSE(file().contains("suns"));
  map.sectors[0].ceilingFlat = kSkyFlat;
  const Json made = file();
  EXPECT_EQ(made["sky"], (Json{{"intensity", 70.0}, {"color", "#c0d0ff"}}));
  EXPECT_EQ(made["suns"], (Json{{{"angle", 120.0},
                                 {"pitch", 40.0},
                                 {"intensity", 110.0},
                                 {"color", "#fff0d0"},
                                 {"size", 1.0}}}));
  table_.sun.reset();
  table_.sky.intensity = 0;
  EXPECT_FALSE(file().contains("sky"));
  EXPECT_FALSE(file().contains("suns"));
}

TEST_F(AreaLightsOfAMap, haveTheHueOfTheSkyUnlessTheTableHasAnother) {
  table_.sky.color.reset();
  map.sectors[0].ceilingFlat = kSkyFlat;
  const Rgb sky = colorOf(9);
  const double most = std::max({sky.r, sky.g, sky.b});
  const auto part = [&](double channel) { return std::lround(255 * channel / most); };
  EXPECT_EQ(file()["sky"]["color"],
            fmt::format("#{:02x}{:02x}{:02x}", part(sky.r), part(sky.g), part(sky.b)));
}

TEST_F(AreaLightsOfAMap, areAskedFor) {
  settings_.from = LightFrom::Points;
  map.sectors[0].ceilingFlat = kSkyFlat;
  const Json made = file();
  for (const char* key : {"emit", "sky", "suns"}) EXPECT_FALSE(made.contains(key)) << key;
}

}  // namespace

}  // namespace hearth::doom
