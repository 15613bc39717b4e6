// Light that bounces, as it is baked, against closed forms.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <stop_token>
#include <string>
#include <vector>

#include "light/bake_part.h"
#include "light/bake_progress.h"
#include "light/bakery.h"
#include "light/baking/bounces.h"
#include "light/light_hash.h"
#include "light/rebake.h"
#include "same_bakes.h"
#include "support/baked_room.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::levelFrom;

std::string surfaces(std::string_view texture) {
  return fmt::format("'floor':{{'texture':'{0}'}},'ceiling':{{'z':3,'texture':'{0}'}}", texture);
}

/// A room like an L, 8 m long and wide, in one colour.
std::string cornerRoom(std::string_view texture, std::string_view things = "") {
  return fmt::format(
      "{{'light':0,'sectors':{{'hall':{{{},'loops':{{'border':{{"
      "'v':[0,0, 8,0, 8,3, 3,3, 3,8, 0,8],'walls':{{'texture':'{}'}}}}}}}}}},'things':[{}]}}",
      surfaces(texture), texture, things);
}

/// A light whose level is the same everywhere, and bounces.
std::string lampText(int bounces, double reflectance = 1, std::string_view more = "") {
  return fmt::format(
      "{{'lights':[{{'x':1.5,'y':1.5,'z':1.5,'intensity':40{}}}],"
      "'bake':{{'texel':0.25,'bounces':{},'reflectance':{}}}}}",
      more, bounces, reflectance);
}

double geometricSum(double reflectance, int bounces) {
  double sum = 0;
  for (int k = 0; k <= bounces; ++k) sum += std::pow(reflectance, k);
  return sum;
}

/// All of the room sees the lamp, so all surfaces reflect the same.
TEST(Bounces, GiveAClosedRoomOfOneColourTheGeometricSum) {
  const double reflectance = 153 / 255.0;
  for (const int bounces : {0, 1, 3, 16}) {
    const BakedRoom room(cornerRoom("#999999"), lampText(bounces));
    const double sum = 40 * geometricSum(reflectance, bounces);
    for (const Vec3 p : {Vec3{4, 1.5, 0}, Vec3{2.9, 2.9, 0}, Vec3{0.1, 7.9, 0}}) {
      EXPECT_NEAR(room.at(SurfaceKind::Floor, p), sum, 1) << bounces;
      EXPECT_NEAR(room.at(SurfaceKind::Ceiling, {p.x, p.y, 3}), sum, 1) << bounces;
    }
    EXPECT_NEAR(room.at(SurfaceKind::Solid, {0, 4, 1}), sum, 1) << bounces;
    EXPECT_NEAR(room.at(SurfaceKind::Solid, {3, 5, 2}), sum, 1) << bounces;
  }
}

TEST(Bounces, ReflectAsMuchAsTheLightsFileSaysAndNoMoreThanMost) {
  const BakedRoom half(cornerRoom("#999999"), lampText(3, 0.5));
  EXPECT_NEAR(half.at(SurfaceKind::Floor, {4, 1.5, 0}), 40 * geometricSum(0.3, 3), 1);
  const BakedRoom white(cornerRoom("#ffffff"), lampText(3));
  EXPECT_NEAR(white.at(SurfaceKind::Floor, {4, 1.5, 0}), 40 * geometricSum(0.95, 3), 1);
}

TEST(Bounces, TakeTheColourOfWhatReflects) {
  const BakedRoom room(cornerRoom("#cc6600"), lampText(2));
  for (const int channel : {0, 1, 2}) {
    const double reflectance = std::array{0.8, 0.4, 0.0}[static_cast<std::size_t>(channel)];
    EXPECT_NEAR(room.at(SurfaceKind::Floor, {4, 1.5, 0}, "", channel),
                40 * geometricSum(reflectance, 2), 1);
  }
}

/// A mesh of the room's colour changes nothing, and gets as much itself where it sees the lamp.
TEST(Bounces, AreReflectedByMeshesToo) {
  const BakedRoom room(
      levelFrom(cornerRoom("#999999", "{'mesh':'box.obj','x':6,'y':1.5,'texture':'#999999'}"),
                lampText(3, 1), {{"box.obj", test::kBoxModel}}));
  const BakedRoom without(cornerRoom("#999999"), lampText(3));
  EXPECT_GT(room.at(SurfaceKind::Floor, {5.45, 1.5, 0}),
            0.9 * without.at(SurfaceKind::Floor, {5.45, 1.5, 0}));
  const BakedRoom black(
      levelFrom(cornerRoom("#999999", "{'mesh':'box.obj','x':6,'y':1.5,'texture':'#000000'}"),
                lampText(3, 1), {{"box.obj", test::kBoxModel}}));
  EXPECT_LT(black.at(SurfaceKind::Floor, {5.45, 1.5, 0}),
            room.at(SurfaceKind::Floor, {5.45, 1.5, 0}) - 10);
}

/// Of two rooms that share a wall without thickness, and nothing else, one is lit.
TEST(Bounces, DoNotLeakThroughThinWalls) {
  const std::string level = fmt::format(
      "{{'light':0,'sectors':{{'lit':{{{0},'loops':{{'border':{{'v':[0,0, 4,0, 4,4, 0,4],"
      "'walls':{{'texture':'#cccccc'}}}}}}}},'sealed':{{{0},'loops':{{'border':{{"
      "'v':[4,0, 8,0, 8,4, 4,4],'walls':{{'texture':'#cccccc'}}}}}}}}}}}}",
      surfaces("#cccccc"));
  const LoadedLevel rooms =
      levelFrom(level, "{'lights':[{'x':2,'y':2,'z':1.5}],'bake':{'bounces':4}}");
  const BakedLight baked = bake(rooms.scene(), rooms.level.bake, 2);
  for (std::size_t i = 0; i < baked.surfaces.size(); ++i)
    if (baked.surfaces[i]) {
      EXPECT_EQ(baked.lightmaps[i].has_value(), rooms.level[SurfaceId(i)].sector == SectorId(0))
          << i;
    }
}

TEST(Bounces, GiveTheSameBytesWithAnyThreadsInPartsAndInRebakes) {
  const std::string things =
      "{'mesh':'box.obj','x':6,'y':1.5,'texture':'#cc6600'},"
      "{'sprite':'#00ff00','x':2,'y':2,'size':[1,1]}";
  const std::vector<test::NamedText> models{{"box.obj", test::kBoxModel}};
  const LoadedLevel level = levelFrom(cornerRoom("#999999", things), lampText(2), models);
  const BakeSettings& settings = level.level.bake;
  const BakedLight whole = bake(level.scene(), settings, 1);
  test::expectSame(level.scene(), bake(level.scene(), settings, 4), whole);
  const BakeInParts parts(level.scene(), settings, "");
  const std::vector<std::string> both{bakePart(parts, {1, 2}, 2), bakePart(parts, {2, 2}, 1)};
  const auto joined = joinParts(parts, both, 2);
  ASSERT_TRUE(joined.has_value());
  for (std::size_t i = 0; i < whole.lightmaps.size(); ++i) {
    ASSERT_EQ(joined->lightmaps[i].has_value(), whole.lightmaps[i].has_value()) << i;
    if (whole.lightmaps[i]) {
      EXPECT_EQ(joined->lightmaps[i]->levels, whole.lightmaps[i]->levels);
    }
  }

  LightMemory memory;
  const LoadedLevel brighter =
      levelFrom(cornerRoom("#999999", things), lampText(2, 1, ",'falloff':0.1"), models);
  const LoadedLevel white = levelFrom(cornerRoom("#dddddd", things), lampText(2), models);
  for (const LoadedLevel* edited : {&level, &brighter, &white, &level})
    test::expectSame(edited->scene(), *Rebake(memory, edited->scene(), settings, 2).finish(),
                     bake(edited->scene(), settings, 2));
  EXPECT_EQ(Rebake(memory, level.scene(), settings, 2).texelLightsLeft(), 0);
  EXPECT_NE(lightHash(level.scene(), settings), lightHash(white.scene(), settings));
}

TEST(Bounces, CountWhatReflectsAsTexelsOfTheBake) {
  const auto texelsOf = [](int bounces) {
    const LoadedLevel room = levelFrom(cornerRoom("#999999"), lampText(bounces));
    BakeProgress progress;
    bake(room.scene(), room.level.bake, 2, &progress);
    EXPECT_EQ(progress.texelsDone(), progress.texels()) << bounces;
    return progress.texels();
  };
  const std::int64_t direct = texelsOf(0);
  const std::int64_t once = texelsOf(1);
  EXPECT_GT(once, direct);
  EXPECT_EQ(texelsOf(3) - direct, 3 * (once - direct));
}

TEST(Bounces, CanBeStoppedAndFoundLater) {
  const LoadedLevel room = levelFrom(cornerRoom("#999999"), lampText(3));
  Bounces bounces(room.scene(), room.level.bake, 2);
  BakeProgress progress;
  std::stop_source stop;
  stop.request_stop();
  EXPECT_FALSE(bounces.find(progress, stop.get_token()));
  EXPECT_EQ(progress.texelsDone(), 0);
  EXPECT_TRUE(bounces.find(progress));
  EXPECT_NE(bounces.irradiance(), nullptr);
}

/// Light beyond full brightness need not be known to a level.
TEST(Bounces, TakeNoMoreSlicesOfALightHoweverBrightItIs) {
  const auto slicesOf = [](std::string_view intensity) {
    const LoadedLevel level =
        levelFrom(cornerRoom("#999999"),
                  fmt::format("{{'lights':[{{'x':1.5,'y':1.5,'z':1.5,'intensity':{},'falloff':1}}],"
                              "'bake':{{'texel':0.25,'bounces':1}}}}",
                              intensity));
    return bake(level.scene(), level.level.bake, 2).stats.rays;
  };
  EXPECT_LE(slicesOf("1e38"), 2 * slicesOf("250"));
}

TEST(Bounces, LeaveTheHashOfALevelWithoutThemAlone) {
  const LoadedLevel grey = levelFrom(cornerRoom("#999999"), lampText(0));
  const LoadedLevel white = levelFrom(cornerRoom("#dddddd"), lampText(0));
  EXPECT_EQ(lightHash(grey.scene(), grey.level.bake), lightHash(white.scene(), white.level.bake));
}

}  // namespace
}  // namespace hearth
