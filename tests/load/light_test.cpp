#include <gtest/gtest.h>

#include "load_text.h"

namespace hearth {
namespace {

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";
const std::string kEast = "4,0, 8,0, 8,4, 4,4";
const std::string kToEast =
    "[{'texture': '#808080'}, {'next': 'b'}, {'texture': '#808080'}, {'texture': '#808080'}]";
const std::string kToWest =
    "[{'texture': '#808080'}, {'texture': '#808080'}, {'texture': '#808080'}, {'next': 'a'}]";
const std::string kSky = "'ceiling': {'z': 4, 'texture': '#8080ff', 'parallax': true}";

TEST(Light, hasTheDefaultsOfItsKeys) {
  const Level level = loadSectors(sectorText("a", kRoom), "[{'x': 1, 'y': 2, 'z': 3}]").level;
  ASSERT_EQ(level.lights.size(), 1U);
  const LightSource& light = level.lights[0];
  EXPECT_EQ(light.position, (Vec3{1, 2, 3}));
  EXPECT_EQ(light.sector, SectorId(0));
  EXPECT_EQ(light.intensity, 255);
  EXPECT_EQ(light.falloff, 0);
  EXPECT_EQ(light.radius, 0);
  EXPECT_TRUE(light.curve.empty());
  EXPECT_EQ(light.color[0], 255);
  EXPECT_EQ(level.bake.texel, 0.125);
  EXPECT_EQ(level.bake.samples, 1);
  EXPECT_FALSE(level.bake.lambert);
  EXPECT_EQ(level.bake.bounces, 0);
}

TEST(Light, readsThatSamplesAreToBeAsManyAsNeeded) {
  const Level level =
      loadSectors(sectorText("a", kRoom), "{'lights': [], 'bake': {'samples': 'auto'}}").level;
  EXPECT_FALSE(level.bake.samples.has_value());
}

TEST(Light, readsEveryKey) {
  const Level level =
      loadSectors(sectorText("a", kRoom),
                  "{'version': 1, 'lights': [{'x': 1, 'y': 2, 'z': 3, 'sector': 'a', 'color': "
                  "'#0180fF', 'radius': 0.25, 'curve': [[0, 300], [2, 100], [2, 50]]}, {'x': 1, "
                  "'y': 1, 'z': 1, 'intensity': 1e38, 'falloff': 2}], 'bake': {'texel': 0.5, "
                  "'samples': 16, 'lambert': true, 'bounces': 3, 'reflectance': 0.8}}")
          .level;
  ASSERT_EQ(level.lights.size(), 2U);
  EXPECT_EQ(level.lights[0].color[0], 1);
  EXPECT_EQ(level.lights[0].color[1], 128);
  EXPECT_EQ(level.lights[0].color[2], 255);
  EXPECT_EQ(level.lights[0].radius, 0.25);
  ASSERT_EQ(level.lights[0].curve.size(), 3U);
  EXPECT_EQ(level.lights[0].curve[2].level, 50);
  EXPECT_EQ(level.lights[1].intensity, 1e38);
  EXPECT_EQ(level.lights[1].falloff, 2);
  EXPECT_EQ(level.bake.texel, 0.5);
  EXPECT_EQ(level.bake.samples, 16);
  EXPECT_TRUE(level.bake.lambert);
  EXPECT_EQ(level.bake.bounces, 3);
  EXPECT_EQ(level.bake.reflectance, 0.8);
}

TEST(Light, isAddedBySectorsThenByTheLevelThenNotAtAll) {
  const LoadResult result =
      loadText("{'light': 0.25, 'sectors': {" +
               sectorText("a", kRoom, "{'texture': '#808080'}", "'light': 0.75") + "," +
               sectorText("b", kEast) + "}}");
  ASSERT_TRUE(result.loaded) << listed(result);
  EXPECT_EQ(result.loaded->level.sectors[0].light, 0.75);
  EXPECT_EQ(result.loaded->level.sectors[1].light, 0.25);
  const LoadResult dark =
      loadText("{'sectors': {" + sectorText("a", kRoom) + "}}", "[{'x': 1, 'y': 1, 'z': 1}]");
  EXPECT_EQ(dark.loaded.value().level.sectors[0].light, 0);
  EXPECT_TRUE(dark.diagnostics.empty());
}

TEST(Light, isFullWithAWarningWhereALevelSaysNothingOfIt) {
  const LoadResult result = loadText("{'sectors': {" + sectorText("a", kRoom) + "}}");
  EXPECT_EQ(result.loaded.value().level.sectors[0].light, 1);
  EXPECT_EQ(countWarnings(result), 1U);
  const LoadResult zero = loadText("{'light': 0, 'sectors': {" + sectorText("a", kRoom) + "}}");
  EXPECT_EQ(zero.loaded.value().level.sectors[0].light, 0);
  EXPECT_EQ(countWarnings(zero), 0U);
}

TEST(Light, mayStandAboveTheSkyOfItsSector) {
  const std::string sectors =
      sectorText("a", kRoom, kToEast, kSky) + "," + sectorText("b", kEast, kToWest, kSky);
  EXPECT_EQ(loadSectors(sectors, "[{'x': 6, 'y': 1, 'z': 50}]").level.lights[0].sector,
            SectorId(1));
  EXPECT_EQ(
      loadSectors(sectors, "[{'sector': 'a', 'x': 1, 'y': 1, 'z': 50}]").level.lights[0].sector,
      SectorId(0));
}

TEST(Light, onTheBorderOfTwoSkyColumnsThatAreOpenToEachOtherBelongsToTheFirst) {
  const std::string sectors =
      sectorText("a", kRoom, kToEast, kSky) + "," + sectorText("b", kEast, kToWest, kSky);
  EXPECT_EQ(loadSectors(sectors, "[{'x': 4, 'y': 1, 'z': 50}]").level.lights[0].sector,
            SectorId(0));
}

TEST(Light, belongsToTheSectorThatContainsItBeforeASkyColumn) {
  const Level level =
      loadSectors(sectorText("yard", kRoom, "{'texture': '#808080'}", kSky) + "," +
                      sectorText("loft", "1,1, 3,1, 3,3, 1,3", "{'texture': '#808080'}",
                                 "'floor': {'z': 6, 'texture': '#111111'}, 'ceiling': {'z': 9, "
                                 "'texture': '#111111'}"),
                  "[{'x': 2, 'y': 2, 'z': 7}, {'x': 2, 'y': 2, 'z': 20}]")
          .level;
  EXPECT_EQ(level.lights[0].sector, SectorId(1));
  EXPECT_EQ(level.lights[1].sector, SectorId(0));
}

TEST(Light, mayStandBelowASkyFloor) {
  const Level level =
      loadSectors(sectorText("a", kRoom, "{'texture': '#808080'}",
                             "'floor': {'z': 0, 'texture': '#111111', 'parallax': true}"),
                  "[{'x': 2, 'y': 2, 'z': -7}]")
          .level;
  EXPECT_EQ(level.lights[0].sector, SectorId(0));
}

}  // namespace
}  // namespace hearth
