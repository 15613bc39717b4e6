// Suns, as they are baked.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "light/baking/sun_visibility.h"
#include "light/rays/sky_shaft.h"
#include "support/baked_room.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::levelFrom;
using test::sectorText;

constexpr double kDegree = std::numbers::pi / 180;
/// Level ground under the sky, 3 m high.
std::string yardSector(std::string_view name, std::string_view vertices,
                       std::string_view walls = "{'texture':'#808080'}") {
  return fmt::format(
      "'{}':{{'floor':{{'texture':'#808080'}},"
      "'ceiling':{{'z':3,'texture':'sky','parallax':true}},"
      "'loops':{{'border':{{'v':[{}],'walls':{}}}}}}}",
      name, vertices, walls);
}

std::string levelText(std::string_view sectors, std::string_view things = "") {
  return fmt::format("{{'light':0,'textures':'{}','sectors':{{{}}},'things':[{}]}}",
                     test::inTree("textures").string(), sectors, things);
}

/// A yard of 20 x 20 m whose walls end in the sky.
std::string yard() { return levelText(yardSector("yard", "0,0, 20,0, 20,20, 0,20")); }

std::string sunText(double angle, double pitch, std::string_view more = "",
                    std::string_view bake = "{}") {
  return fmt::format("{{'lights':[],'suns':[{{'angle':{},'pitch':{}{}}}],'bake':{}}}", angle, pitch,
                     more, bake);
}

TEST(Sun, LightsWhatSeesTheSkyTowardsIt) {
  const BakedRoom room(yard(), sunText(0, 45, ",'intensity':200,'color':'#ff8000'"));
  EXPECT_EQ(room.at(SurfaceKind::Floor, {10, 10, 0}), 200);
  EXPECT_NEAR(room.at(SurfaceKind::Floor, {10, 10, 0}, "", 1), 200 * 128 / 255.0, 0.5);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {10, 10, 0}, "", 2), 0);
  EXPECT_EQ(room.at(SurfaceKind::Solid, {0, 10, 1}), 200) << "it looks towards the sun";
  EXPECT_EQ(room.at(SurfaceKind::Solid, {20, 10, 1}), 0) << "the sun is behind it";
  EXPECT_EQ(room.at(SurfaceKind::Solid, {10, 0, 1}), 0) << "the sun is in its plane";
}

TEST(Sun, MakesShadowsAsLongAsAWallIsHighOverTheTangent) {
  for (const double pitch : {10.0, 30.0, 60.0}) {
    const BakedRoom room(yard(), sunText(0, pitch));
    const double shadow = 3 / std::tan(pitch * kDegree);
    EXPECT_EQ(room.at(SurfaceKind::Floor, {20 - shadow + 0.2, 10, 0}), 0) << pitch;
    EXPECT_EQ(room.at(SurfaceKind::Floor, {20 - shadow - 0.2, 10, 0}), 255) << pitch;
  }
}

TEST(Sun, LambertMultipliesByTheCosine) {
  const BakedRoom room(yard(), sunText(0, 30, ",'intensity':200", "{'lambert':true}"));
  EXPECT_NEAR(room.at(SurfaceKind::Floor, {5, 10, 0}), 100, 0.5);
  EXPECT_NEAR(room.at(SurfaceKind::Solid, {0, 10, 1}), 200 * std::cos(30 * kDegree), 0.5);
}

/// On level ground behind a wall, in levels of 255.
TEST(Sun, WithASizeShowsTheSegmentOfItsDiscOverAWall) {
  for (const double size : {0.5, 4.0, 20.0}) {
    const LoadedLevel loaded = levelFrom(yard(), sunText(0, 45, fmt::format(",'size':{}", size)));
    const SunVisibility sun(loaded.scene(), *loaded.level.lights[0].sun, 36, false);
    double greatest = 0;
    for (double part = -0.97; part < 1; part += 0.03) {
      const double away = 3 / std::tan((45 + part * size / 2) * kDegree);
      std::int64_t rays = 0;
      const double found = sun.seenFraction(
          {{20 - away, 10, 0}, SectorId(0), {{20 - away, 10, 0}, {0, 0, 1}}}, rays);
      const double seen = (std::acos(part) - part * std::sqrt(1 - part * part)) / std::numbers::pi;
      greatest = std::max(greatest, 255 * std::abs(found - seen));
    }
    // Of a wide disc the wall's edge, a straight line in the plane of a picture, is bent.
    EXPECT_LT(greatest, size < 10 ? 1 : 3) << size;
  }
}

TEST(Sun, OfADiscBelowAPlaneTheRestIsSeen) {
  const LoadedLevel loaded = levelFrom(yard(), sunText(0, 5, ",'size':20"));
  const SunVisibility sun(loaded.scene(), *loaded.level.lights[0].sun, 36, false);
  EXPECT_DOUBLE_EQ(sun.fractionInFront({0, 0, 1}), 1 - sun.fractionInFront({0, 0, -1}));
  EXPECT_NEAR(sun.fractionInFront({0, 1, 0}), 0.5, 1e-12);
  const double h = std::sin(5 * kDegree) / std::sin(10 * kDegree);
  EXPECT_NEAR(sun.fractionInFront({0, 0, -1}),
              (std::acos(h) - h * std::sqrt(1 - h * h)) / std::numbers::pi, 1e-12);
}

TEST(Sun, ShinesThroughAWindowAndNowhereElse) {
  const auto walls = [](std::string_view next) {
    return fmt::format(
        "[{{'texture':'#808080'}},{{'walls':[{{'z':1,'texture':'#808080'}},{{'z':2,'next':'{}'}},"
        "{{'texture':'#808080'}}]}},{{'texture':'#808080'}},{{'texture':'#808080'}}]",
        next);
  };
  const std::string level =
      levelText(sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 3, walls("yard")) + "," +
                yardSector("yard", "16,8, 8,8, 8,0, 16,0", walls("room")));
  const BakedRoom room(level, sunText(0, 45));
  // From 1 to 2 m above the floor at x = 8.
  EXPECT_EQ(room.at(SurfaceKind::Floor, {6.5, 4, 0}, "room"), 255);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {7.5, 4, 0}, "room"), 0);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {5.5, 4, 0}, "room"), 0);
  EXPECT_EQ(room.at(SurfaceKind::Ceiling, {6.5, 4, 3}, "room"), 0);
}

/// Two sectors of 8 m side by side, with these flats and an opening between them.
std::string twoSectors(std::string_view west, std::string_view east) {
  return levelText(fmt::format(
      "'west':{{{},'loops':{{'border':{{'v':[0,0, 8,0, 8,8, 0,8],'walls':[{{'texture':'#808080'}},"
      "{{'next':'east','texture':'#808080'}},{{'texture':'#808080'}},{{'texture':'#808080'}}]}}}}}}"
      ","
      "'east':{{{},'loops':{{'border':{{'v':[8,0, 16,0, 16,8, "
      "8,8],'walls':[{{'texture':'#808080'}},"
      "{{'texture':'#808080'}},{{'texture':'#808080'}},{{'next':'west','texture':'#808080'}}]}}}}}"
      "}",
      west, east));
}

TEST(Sun, IsSeenThroughTheStepBetweenTwoSkyCeilings) {
  const auto flats = [](double ceiling) {
    return fmt::format(
        "'floor':{{'texture':'#808080'}},'ceiling':{{'z':{},'texture':'sky','parallax':true}}",
        ceiling);
  };
  const BakedRoom room(twoSectors(flats(8), flats(3)), sunText(0, 30));
  // The ray from x = 4 comes to the lower sky, that from x = 1 to the step.
  EXPECT_EQ(room.at(SurfaceKind::Floor, {4, 4, 0}, "west"), 255);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {1, 4, 0}, "west"), 255);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {15, 4, 0}, "east"), 0);
}

TEST(Sun, IsSeenThroughTheStepBetweenTwoSkyFloors) {
  const auto flats = [](double floor) {
    return fmt::format(
        "'floor':{{'z':{},'texture':'sky','parallax':true}},"
        "'ceiling':{{'z':8,'texture':'#808080'}}",
        floor);
  };
  const BakedRoom room(twoSectors(flats(0), flats(3)), sunText(0, 10));
  // The ray ends there, 2.4 m high, though it would come out of the eastern floor again.
  EXPECT_EQ(room.at(SurfaceKind::Solid, {0, 4, 1}, "west"), 255);
  EXPECT_EQ(room.at(SurfaceKind::Solid, {0, 4, 2.5}, "west"), 0) << "over the step";
}

/// A box of 1 m on the ground, whose shadow is as long.
TEST(Sun, ThrowsShadowsOfMeshesAndLightsThem) {
  for (const char* size : {"0", "1"}) {
    const std::string level =
        levelText(yardSector("yard", "0,0, 20,0, 20,20, 0,20"), "{'mesh':'box.obj','x':10,'y':10}");
    const BakedRoom room(levelFrom(level,
                                   sunText(0, 45, fmt::format(",'size':{}", size), "{'texel':0.1}"),
                                   {{"box.obj", test::kBoxModel}}));
    EXPECT_EQ(room.at(SurfaceKind::Floor, {9, 10, 0}), 0);
    EXPECT_EQ(room.at(SurfaceKind::Floor, {8.2, 10, 0}), 255);
    EXPECT_EQ(room.at(SurfaceKind::Floor, {10.9, 10, 0}), 255);
    EXPECT_EQ(room.onMesh({10, 10, 1}, {0, 0, 1}), 255);
    EXPECT_EQ(room.onMesh({10.5, 10, 0.5}, {1, 0, 0}), 255);
    EXPECT_EQ(room.onMesh({9.5, 10, 0.5}, {-1, 0, 0}), 0);
  }
}

TEST(Sun, IsNotSeenInARoomWithoutSky) {
  const BakedRoom room(levelText(sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 3)), sunText(0, 90));
  for (const auto& map : room.light().lightmaps) EXPECT_FALSE(map);
}

/// The light of a sprite is that of its middle: here the origin, which suns have instead of a
/// place.
TEST(Sun, ThatIsLeftOutLightsNoSpriteEither) {
  const std::string level = levelText(
      "'yard':{'floor':{'z':-0.5,'texture':'#808080'},"
      "'ceiling':{'z':3,'texture':'sky','parallax':true},"
      "'loops':{'border':{'v':[-9,-9, 9,-9, 9,9, -9,9],'walls':{'texture':'#808080'}}}}",
      "{'sprite':'straw','x':0,'y':0,'z':-0.5,'size':[1,1]}");
  const LoadedLevel loaded = levelFrom(level, sunText(0, 45, ",'intensity':90"));
  const std::size_t sprite = loaded.level.sprites.at(0).surface.index();
  BakeSettings settings = loaded.level.bake;
  EXPECT_EQ(bake(loaded.scene(), settings, 1).lightmaps[sprite]->at(0, 0), 90);
  settings.cutOff = 100;
  EXPECT_FALSE(bake(loaded.scene(), settings, 1).lightmaps[sprite]);
}

TEST(Sun, AtTheZenithLightsTheFloorUpToTheWalls) {
  for (const double size : {0.0, 20.0}) {
    const BakedRoom room(yard(), sunText(0, 90, fmt::format(",'size':{}", size)));
    EXPECT_EQ(room.at(SurfaceKind::Floor, {10, 10, 0}), 255);
    const SunVisibility sun(room.scene(), *room.level().lights[0].sun, 36, false);
    std::int64_t rays = 0;
    const double atWall =
        sun.seenFraction({{1e-6, 10, 0}, SectorId(0), {{0, 0, 0}, {0, 0, 1}}}, rays);
    EXPECT_NEAR(atWall, size == 0 ? 1 : 0.5, 0.01) << "half of the disc is behind the wall";
  }
}

TEST(SkyShaft, DecidesBlocksInTheOpenAndInTheShadow) {
  const LoadedLevel loaded = levelFrom(yard(), sunText(0, 45, ",'size':1"));
  const SunVisibility sun(loaded.scene(), *loaded.level.lights[0].sun, 36, false);
  const auto outcomeOf = [&](double from, double to) {
    const std::array<SectorId, 1> sectors{SectorId(0)};
    TargetBox box{
        {Vec3{from, 8, 0}, Vec3{to, 8, 0}, Vec3{from, 12, 0}, Vec3{to, 12, 0}}, 4, {0, 0, 1}};
    return SkyShaft(loaded.scene()).follow(sun.cone(), {box, sectors}, nullptr);
  };
  EXPECT_EQ(outcomeOf(2, 15), TargetVisibility::Lit);
  EXPECT_EQ(outcomeOf(18, 19.9), TargetVisibility::Dark);
  EXPECT_EQ(outcomeOf(14, 19), TargetVisibility::Unknown);
}

}  // namespace
}  // namespace hearth
