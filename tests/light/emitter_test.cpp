// The light of surfaces that shine, as it is baked.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "light/gather/area_visibility.h"
#include "light/light_hash.h"
#include "light/rebake.h"
#include "same_bakes.h"
#include "support/baked_room.h"
#include "support/form_factor.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::factorOverCorner;
using test::levelFrom;

/// A room of black walls, 8 x 6 x 3 m, whose ceiling wears a texture.
std::string hallUnder(std::string_view ceiling, std::string_view more = "") {
  return fmt::format(
      "{{'light':0,'sectors':{{'hall':{{'floor':{{'texture':'#000000'}},"
      "'ceiling':{{'z':3,'texture':'{}'}},'loops':{{'border':{{'v':[0,0, 8,0, 8,6, 0,6],"
      "'walls':{{'texture':'#000000'}}}}}}}}}},'things':[{}]}}",
      ceiling, more);
}

std::string emitText(std::string_view emitters, std::string_view bake = "{}") {
  return fmt::format("{{'lights':[],'emit':{{{}}},'bake':{}}}", emitters, bake);
}

TEST(Emitters, GiveAClosedRoomOfThemTheirIntensity) {
  const BakedRoom room(hallUnder("#000000"), emitText("'#000000':{'intensity':100}"));
  for (const Vec3 p : {Vec3{4, 3, 0}, Vec3{0.1, 5.9, 0}}) {
    EXPECT_NEAR(room.at(SurfaceKind::Floor, p), 100, 1);
    EXPECT_NEAR(room.at(SurfaceKind::Ceiling, {p.x, p.y, 3}), 100, 1);
  }
  EXPECT_NEAR(room.at(SurfaceKind::Solid, {0, 3, 1.5}), 100, 1);
}

TEST(Emitters, GiveTheFormFactorOfACeilingInTheirColor) {
  const BakedRoom room(hallUnder("#ffffff"),
                       emitText("'#ffffff':{'intensity':250,'color':'#ff8000'}"));
  for (const Vec2 p : {Vec2{4, 3}, Vec2{1, 5}, Vec2{0.2, 0.2}}) {
    const double seen = factorOverCorner(p.x, p.y, 3) + factorOverCorner(8 - p.x, p.y, 3) +
                        factorOverCorner(p.x, 6 - p.y, 3) + factorOverCorner(8 - p.x, 6 - p.y, 3);
    EXPECT_NEAR(room.at(SurfaceKind::Floor, {p.x, p.y, 0}), 250 * seen, 1.5);
    EXPECT_NEAR(room.at(SurfaceKind::Floor, {p.x, p.y, 0}, "", 1), 250 * seen * 128 / 255, 1.5);
    EXPECT_EQ(room.at(SurfaceKind::Floor, {p.x, p.y, 0}, "", 2), 0);
  }
  EXPECT_EQ(room.at(SurfaceKind::Ceiling, {4, 3, 3}), 0) << "it does not see itself";
}

/// A lamp of 0.4 m in a hall of 24 x 24 m.
TEST(Emitters, AreSeenHoweverSmallTheyAre) {
  const auto walls = [](std::string_view more) {
    return fmt::format("'walls':{{'texture':'#000000'{}}}", more);
  };
  const BakedRoom room(
      fmt::format("{{'light':0,'sectors':{{'hall':{{'floor':{{'texture':'#000000'}},"
                  "'ceiling':{{'z':3,'texture':'#000000'}},'loops':{{"
                  "'border':{{'v':[-12,-12, 12,-12, 12,12, -12,12],{}}},"
                  "'lamp':{{'v':[-0.2,-0.2, -0.2,0.2, 0.2,0.2, 0.2,-0.2],{}}}}}}},"
                  "'lamp':{{'floor':{{'texture':'#000000'}},"
                  "'ceiling':{{'z':3,'texture':'#ffffff'}},'loops':{{"
                  "'border':{{'v':[-0.2,-0.2, 0.2,-0.2, 0.2,0.2, -0.2,0.2],{}}}}}}}}}}}",
                  walls(""), walls(",'next':'lamp'"), walls(",'next':'hall'")),
      emitText("'#ffffff':{'intensity':9000}", "{'texel':0.25}"));
  for (double x = 2; x < 12; x += 0.7)
    for (double y = 0; y <= x; y += 0.9) {
      const double square = x * x + y * y + 9;
      const double seen = 0.16 * 9 / (std::numbers::pi * square * square);
      EXPECT_NEAR(room.at(SurfaceKind::Floor, {x, y, 0}, "hall"), 9000 * seen, 1 + 360 * seen)
          << x << ' ' << y;
    }
}

/// A lamp of 0.4 m, and a room with no way to it.
TEST(Emitters, TakeNoMoreSlicesWhereTheyCannotBeSeen) {
  const auto slicesIn = [](std::string_view lamp) {
    const LoadedLevel loaded = levelFrom(
        fmt::format(
            "{{'light':0,'sectors':{{{},'lamp':{{'floor':{{'texture':'#000000'}},"
            "'ceiling':{{'z':3,'texture':'{}'}},'loops':{{'border':{{"
            "'v':[9,1.8, 9.4,1.8, 9.4,2.2, 9,2.2],'walls':{{'texture':'#000000'}}}}}}}}}}}}",
            test::sectorText("room", "0,0, 8,0, 8,8, 0,8", 0, 3), lamp),
        emitText("'#ffffff':{'intensity':9000}", "{}"));
    AreaVisibility areas(loaded.scene(), false);
    double fraction = 0;
    std::int64_t slices = 0;
    for (double x = 0.5; x < 8; ++x)
      areas.findOnSurface({x, 4, 0}, SectorId(0), {0, 0, 1}, {&fraction, 1}, slices);
    EXPECT_EQ(fraction, 0);
    return slices;
  };
  EXPECT_EQ(slicesIn("#ffffff"), slicesIn("#000000"));
}

TEST(Emitters, AreOfMeshesToo) {
  const std::string box = "{'mesh':'box.obj','x':4,'y':3,'texture':'#ff0000'}";
  const BakedRoom room(levelFrom(hallUnder("#000000", box), emitText("'#ff0000':{'intensity':250}"),
                                 {{"box.obj", test::kBoxModel}}));
  EXPECT_GT(room.at(SurfaceKind::Floor, {4.55, 3, 0}), 80);
  EXPECT_GT(room.at(SurfaceKind::Ceiling, {4, 3, 3}), 10);
  EXPECT_EQ(room.onMesh({4, 3, 1}, {0, 0, 1}), 0);
}

/// Of nothing but surfaces and meshes: a sky, a sprite and a middle texture are none.
TEST(Emitters, AreNotSkiesSpritesAndMiddleTextures) {
  const std::string level =
      "{'light':0,'sectors':{"
      "'west':{'floor':{'texture':'#808080'},'ceiling':{'z':3,'texture':'#00ff00','parallax':true},"
      "'loops':{'border':{'v':[0,0, 4,0, 4,4, 0,4],'walls':[{'texture':'#808080'},"
      "{'next':'east','middle':'#00ff00','upper':'#808080'},{'texture':'#808080'},"
      "{'texture':'#808080'}]}}},"
      "'east':{'floor':{'texture':'#808080'},'ceiling':{'z':3,'texture':'#808080'},"
      "'loops':{'border':{'v':[4,0, 8,0, 8,4, 4,4],'walls':[{'texture':'#808080'},"
      "{'texture':'#808080'},{'texture':'#808080'},"
      "{'next':'west','middle':'#00ff00'}]}}}},"
      "'things':[{'sprite':'#00ff00','x':2,'y':2,'size':[1,1]}]}";
  const BakedRoom room(level, emitText("'#00ff00':{'intensity':250}"));
  for (const auto& map : room.light().lightmaps) EXPECT_FALSE(map);
}

TEST(Emitters, AreBakedAgainWhereASurfaceChangesItsTexture) {
  const std::string lights = emitText("'#ffffff':{'intensity':250}");
  const std::string things = "{'mesh':'box.obj','x':4,'y':3,'texture':'#ff0000'}";
  const std::vector<test::NamedText> models{{"box.obj", test::kBoxModel}};
  const LoadedLevel dark = levelFrom(hallUnder("#eeeeee", things), lights, models);
  const LoadedLevel lit = levelFrom(hallUnder("#ffffff", things), lights, models);
  LightMemory memory;
  for (const LoadedLevel* level : {&dark, &lit, &dark})
    test::expectSame(level->scene(), *Rebake(memory, level->scene(), level->level.bake, 2).finish(),
                     bake(level->scene(), level->level.bake, 2));
  EXPECT_NE(lightHash(dark.scene(), dark.level.bake), lightHash(lit.scene(), lit.level.bake));
}

/// The two halves of a hall have one box.
TEST(Emitters, AreBakedAgainWhereTheOtherHalfOfACeilingShines) {
  const auto hallUnderHalves = [](std::string_view south, std::string_view north) {
    const auto half = [](std::string_view name, std::string_view next, std::string_view ceiling,
                         std::string_view corners) {
      return fmt::format(
          "'{}':{{'floor':{{'texture':'#000000'}},'ceiling':{{'z':3,'texture':'{}'}},'loops':{{"
          "'border':{{'v':[{}],'walls':[{{'next':'{}'}},{{'texture':'#000000'}},"
          "{{'texture':'#000000'}}]}}}}}}",
          name, ceiling, corners, next);
    };
    return levelFrom(fmt::format("{{'light':0,'sectors':{{{},{}}}}}",
                                 half("south", "north", south, "8,6, 0,0, 8,0"),
                                 half("north", "south", north, "0,0, 8,6, 0,6")),
                     emitText("'#ffffff':{'intensity':250}"));
  };
  const LoadedLevel southLit = hallUnderHalves("#ffffff", "#000000");
  const LoadedLevel northLit = hallUnderHalves("#000000", "#ffffff");
  LightMemory memory;
  for (const LoadedLevel* level : {&southLit, &northLit})
    test::expectSame(level->scene(), *Rebake(memory, level->scene(), level->level.bake, 2).finish(),
                     bake(level->scene(), level->level.bake, 2));
}

TEST(Emitters, AreBakedAgainWhereAMeshChangesItsTexture) {
  const std::string lights = emitText("'#ffffff':{'intensity':250},'#ff0000':{'intensity':50}");
  const auto withBox = [&](std::string_view texture) {
    return levelFrom(
        hallUnder("#000000",
                  fmt::format("{{'mesh':'box.obj','x':4,'y':3,'texture':'{}'}}", texture)),
        lights, {{"box.obj", test::kBoxModel}});
  };
  const LoadedLevel dim = withBox("#ff0000");
  const LoadedLevel lit = withBox("#ffffff");
  LightMemory memory;
  for (const LoadedLevel* level : {&dim, &lit})
    test::expectSame(level->scene(), *Rebake(memory, level->scene(), level->level.bake, 2).finish(),
                     bake(level->scene(), level->level.bake, 2));
  EXPECT_NE(lightHash(dim.scene(), dim.level.bake), lightHash(lit.scene(), lit.level.bake));
}

TEST(Emitters, LeaveTheHashOfALevelAloneInWhichNothingElseShines) {
  const std::string lights = emitText("'#ffffff':{'intensity':250}");
  const LoadedLevel one = levelFrom(hallUnder("#ffffff"), lights);
  LoadedLevel other = levelFrom(hallUnder("#ffffff"), lights);
  for (std::string& name : other.level.textures)
    if (name == "#000000") name = "#111111";
  EXPECT_EQ(lightHash(one.scene(), one.level.bake), lightHash(other.scene(), other.level.bake));
}

}  // namespace
}  // namespace hearth
