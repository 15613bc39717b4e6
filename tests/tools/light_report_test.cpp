#include "cli/info/light_report.h"

#include <gtest/gtest.h>

#include "loaded.h"
#include "support/level_text.h"

namespace hearth {

namespace {

/// Two rooms of 6 surfaces that see nothing of each other.
LoadedLevel twoRooms(const std::string& lights) {
  return test::levelFrom("{'light': 0.1, 'sectors': {" +
                             test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "," +
                             test::sectorText("b", "10,0, 14,0, 14,4, 10,4", 0, 3) + "}}",
                         lights);
}

/// With shadows.
LoadedLevel roomWithCorner(const std::string& lights) {
  return test::levelFrom("{'light': 0.1, 'sectors': {" +
                             test::sectorText("l", "0,0, 4,0, 4,4, 2,4, 2,2, 0,2", 0, 3) + "}}",
                         lights);
}

LightReport reportOf(const LoadedLevel& loaded, const BakeSettings& settings = {.texel = 0.5}) {
  return lightReport(loaded.scene(), bake(loaded.scene(), settings, 2));
}

TEST(LightReport, SaysWhySurfacesHaveNoLightmap) {
  const LightReport report = reportOf(twoRooms("[{'x':2,'y':2,'z':1,'falloff':1}]"));
  EXPECT_EQ(report.all.white, 6);
  EXPECT_EQ(report.all.unfaced, 1) << "the far room's west wall";
  EXPECT_EQ(report.all.unreached, 5);
  EXPECT_EQ(report.all.bare, 0);
  EXPECT_EQ(report.all.surfaces(), 12);
  EXPECT_EQ(report.all.whiteTexels, report.all.bytes);
  EXPECT_EQ(report.all.skippedTexels, report.all.whiteTexels) << "the rooms are alike";
}

TEST(LightReport, TakesASurfaceThatNoLightCouldReachForOneThatNoneFaces) {
  const LoadedLevel hall = test::levelFrom(
      "{'light': 0.1, 'sectors': {" + test::sectorText("hall", "0,0, 40,0, 40,4, 0,4", 0, 3) + "}}",
      "[{'x':2,'y':2,'z':2,'curve':[[0,255],[6,0]]}]");
  const LightReport report = reportOf(hall);
  EXPECT_EQ(report.all.unfaced, 1) << "the wall at the far end, in front of which the light is";
  EXPECT_EQ(report.all.unreached, 0);
  EXPECT_EQ(report.all.white, 5);
}

TEST(LightReport, CountsTheOneTexelOfASpriteWhichHasNoOutline) {
  const LoadedLevel room = test::levelFrom(
      "{'light': 0.1, 'things': [{'sprite': '#c04020', 'x': 1, 'y': 1},"
      "{'sprite': '#c04020', 'x': 3, 'y': 1}], 'sectors': {" +
      test::sectorText("a", "0,0, 4,0, 4,4, 0,4", 0, 3) + "}}");
  BakedLight light = bake(room.scene(), {.texel = 0.5}, 1);
  light.lightmaps[room.level.sprites[0].surface.index()] = Lightmap{{0, 0, 1, 1}, {200, 100, 0}, 3};
  const LightReport report = lightReport(room.scene(), light);
  const SurfaceReport& sprites = report.kinds[static_cast<std::size_t>(SurfaceKind::CameraSprite)];
  EXPECT_EQ(sprites.colored, 1);
  EXPECT_EQ(sprites.coloredTexels, 1);
  EXPECT_EQ(sprites.bytes, 3);
  EXPECT_EQ(sprites.bare, 1) << "no light reaches the other one";
}

TEST(LightReport, HasThreeChannelsOnlyWhereColorArrives) {
  const LightReport report =
      reportOf(twoRooms("[{'x':2,'y':2,'z':1,'falloff':1,'color':'#ff8000'},"
                        "{'x':12,'y':2,'z':1,'falloff':1}]"));
  EXPECT_EQ(report.all.colored, 6);
  EXPECT_EQ(report.all.white, 6);
  EXPECT_EQ(report.all.bytes, 4 * report.all.whiteTexels);
  EXPECT_EQ(report.coloredLights, 1);
}

TEST(LightReport, HasOneValueForALightmapThatIsEven) {
  const LightReport report = reportOf(
      twoRooms("[{'x':2,'y':2,'z':1,'color':'#ff8000'},{'x':12,'y':2,'z':1,'falloff':1}]"));
  EXPECT_EQ(report.all.even, 6) << "in the first room light does not fall off";
  EXPECT_EQ(report.all.bytes, 6 * 3 + report.all.whiteTexels);
  EXPECT_EQ(report.all.sparedBytes(), 3 * report.all.coloredTexels - 6 * 3);
}

TEST(LightReport, TellsSpheresFromPoints) {
  const LightReport report =
      reportOf(roomWithCorner("[{'x':1,'y':1,'z':1},{'x':3,'y':3,'z':1,'radius':0.2}]"));
  EXPECT_EQ(report.points.lights, 1);
  EXPECT_GT(report.points.raysPerSample(), 0);
  EXPECT_LE(report.points.raysPerSample(), 1);
  EXPECT_EQ(report.spheres.lights, 1);
  EXPECT_GT(report.spheres.raysPerSample(), 10 * report.points.raysPerSample());
  EXPECT_EQ(report.points.rays + report.spheres.rays, report.all.rays);
}

TEST(LightReport, TellsWhatBouncesCost) {
  const LoadedLevel room = roomWithCorner("[{'x':1,'y':1,'z':1}]");
  EXPECT_EQ(reportOf(room).bounced.lights, 0);
  BakeSettings settings{.texel = 0.5};
  settings.bounces = 2;
  const LightReport report = reportOf(room, settings);
  EXPECT_EQ(report.bounced.lights, 1);
  EXPECT_GT(report.bounced.samples, 0);
  EXPECT_GT(report.bounced.rays, 0);
  EXPECT_EQ(report.points.rays + report.bounced.rays, report.all.rays);
}

TEST(LightReport, CountsLightsThatReachNothing) {
  const LoadedLevel rooms = twoRooms(
      "[{'x':2,'y':2,'z':1},{'x':2,'y':2,'z':1,'intensity':0},{'x':2,'y':2,'z':1,'color':'#000000'}"
      ","
      "{'x':2,'y':2,'z':1,'curve':[[0,0],[9,0]]},{'x':2,'y':2,'z':1,'curve':[[0,0],[1,9]]}]");
  BakedLight light = bake(rooms.scene(), {.texel = 0.5}, 1);
  EXPECT_EQ(lightReport(rooms.scene(), light).uselessLights, 3);
  light.lightCosts[0].seenSamples = 0;
  EXPECT_EQ(lightReport(rooms.scene(), light).uselessLights, 4);
}

TEST(LightReport, OfALevelWithoutLightsCostsNothing) {
  const LightReport report = reportOf(twoRooms("[]"));
  EXPECT_EQ(report.all.rays, 0);
  EXPECT_EQ(report.all.bytes, 0);
  EXPECT_EQ(report.points.raysPerSample(), 0);
}

TEST(LightReport, AddsUpToTheStatisticsOfTheBake) {
  const LoadedLevel rooms = loaded("tests/levels/rooms.json");
  const BakedLight light = bake(rooms.scene(), {.texel = 0.25}, 2);
  const LightReport report = lightReport(rooms.scene(), light);
  SurfaceReport sum;
  for (const SurfaceReport& kind : report.kinds) sum += kind;
  EXPECT_EQ(sum.surfaces(), std::ssize(rooms.scene().shownSurfaces()));
  EXPECT_EQ(sum.surfaces() - sum.bare, static_cast<std::int64_t>(light.stats.surfaces));
  EXPECT_EQ(sum.white + sum.colored, static_cast<std::int64_t>(light.stats.litSurfaces));
  EXPECT_EQ(sum.whiteTexels + sum.coloredTexels + sum.skippedTexels, light.stats.texels);
  EXPECT_EQ(sum.bytes, light.stats.bytes);
  EXPECT_EQ(sum.rays, light.stats.rays);
  EXPECT_EQ(sum.bytes, report.all.bytes);
}

}  // namespace

}  // namespace hearth
