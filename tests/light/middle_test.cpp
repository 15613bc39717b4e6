// Masked middle textures in the way of light, and in the light.

#include <gtest/gtest.h>

#include "light/geometry_hash.h"
#include "light/rebake.h"
#include "same_bakes.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

/// Rooms of 4 x 4 m and 3 m high side by side, with a wide opening at x = 4 between them.
LoadedLevel rooms(std::string_view ofWest, std::string_view ofEast, std::string_view lights) {
  const auto portal = [](std::string_view next, std::string_view more) {
    return std::string("{'next':'") + std::string(next) + "'" + std::string(more) + "}";
  };
  const std::string solid = "{'texture':'#808080'}";
  const auto walls = [&](int at, const std::string& opening) {
    std::string text = "[";
    for (int i = 0; i < 4; ++i) text += (i > 0 ? "," : "") + (i == at ? opening : solid);
    return text + "]";
  };
  return test::levelFrom(
      "{'light':0,'sectors':{" +
          sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3, walls(1, portal("east", ofWest))) + "," +
          sectorText("east", "4,0, 8,0, 8,4, 4,4", 0, 3, walls(3, portal("west", ofEast))) + "}}",
      lights);
}

/// Uprights of 1 m with gaps of 1 m; seen from the west, the first gap is at y = 0, from the east
/// at y = 4. They hang 2 m down.
constexpr std::string_view kUprights = ",'middle':'#808080 2,2'";
constexpr std::string_view kLampInEast = "[{'x':6,'y':2,'z':1.5,'intensity':200}]";

LoadedLevel withGaps(LoadedLevel loaded) {
  TexelHoles gaps(2, 1);
  gaps.setHole(0, 0);
  loaded.level.holes.assign(loaded.level.textures.size(), gaps);
  return loaded;
}

/// On the west wall, in the light of the lamp that crosses x = 4 at `y` and `z`.
double behind(const BakedRoom& room, double y, double z) {
  return room.at(SurfaceKind::Solid, {0, 2 + 3 * (y - 2), 1.5 + 3 * (z - 1.5)}, "west");
}

TEST(MiddleTextures, castTheirShadowAndLetLightThroughTheirHoles) {
  const BakedRoom room(withGaps(rooms(kUprights, "", kLampInEast)));
  EXPECT_EQ(behind(room, 1.7, 1.5), 0) << "an upright";
  EXPECT_EQ(behind(room, 2.3, 1.5), 200) << "a gap";
}

TEST(MiddleTextures, castTheirShadowToBothSides) {
  const BakedRoom room(withGaps(rooms("", kUprights, kLampInEast)));
  EXPECT_EQ(behind(room, 1.7, 1.5), 200) << "a gap, counted from the other end";
  EXPECT_EQ(behind(room, 2.3, 1.5), 0) << "an upright";
}

TEST(MiddleTextures, hangOnceFromTheTop) {
  const BakedRoom room(rooms(",'middle':'#808080 2,1.25'", "", kLampInEast));
  EXPECT_EQ(behind(room, 2, 1.85), 0) << "above 1.75";
  EXPECT_EQ(behind(room, 2, 1.65), 200) << "under it";
}

TEST(MiddleTextures, areSolidWhereTheSettingsSaySo) {
  const LoadedLevel loaded = withGaps(rooms(kUprights, "", kLampInEast));
  const BakedRoom room(loaded);
  BakeSettings settings = loaded.level.bake;
  settings.solidMaskedMiddles = true;
  const BakedLight solid = bake(loaded.scene(), settings, 2);
  const SurfaceId wall = room.surfaceAt(SurfaceKind::Solid, {0, 2, 1.5}, "west").value();
  EXPECT_TRUE(room.light().lightmaps[wall.index()]);
  const auto& lightmap = solid.lightmaps[wall.index()];
  const Vec2 texels = solid.surfaces[wall.index()]->grid.toTexels({0, 2.9, 1.5});
  EXPECT_EQ(lightmap ? lightmap->sample(texels.x, texels.y, 0) : 0, 0);
}

TEST(MiddleTextures, areLitFromTheirFrontHolesAndAll) {
  const BakedRoom room(withGaps(rooms("", kUprights, kLampInEast)));
  EXPECT_EQ(room.at(SurfaceKind::MaskedMiddle, {4, 2.3, 2}, "east"), 200);
  EXPECT_EQ(room.at(SurfaceKind::MaskedMiddle, {4, 1.7, 2}, "east"), 200)
      << "light is interpolated";
  const BakedRoom away(withGaps(rooms(kUprights, "", kLampInEast)));
  EXPECT_EQ(away.at(SurfaceKind::MaskedMiddle, {4, 2.3, 2}, "west"), 0);
}

TEST(MiddleTextures, changeNoLightOnTheWallRoundThem) {
  const std::string_view lamp = "[{'x':2,'y':2,'z':1,'intensity':200,'falloff':0.5}]";
  const std::string step = ",'texture':'#808080'";
  const auto atFoot = [&](std::string_view middle) {
    LoadedLevel loaded = test::levelFrom(
        "{'light':0,'sectors':{" +
            sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                       "[{'texture':'#808080'},{'next':'east','texture':'#808080'" +
                           std::string(middle) + "},{'texture':'#808080'},{'texture':'#808080'}]") +
            "," +
            sectorText("east", "4,0, 8,0, 8,4, 4,4", 0.95, 3,
                       "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                       "{'next':'west'}]") +
            "}}",
        lamp);
    return BakedRoom(std::move(loaded)).at(SurfaceKind::LowerStep, {4, 2, 0.94}, "west");
  };
  EXPECT_EQ(atFoot(kUprights), atFoot(""));
}

TEST(MiddleTextures, areAskedAboutAgainWhenTheirHolesHaveMoved) {
  LoadedLevel loaded = withGaps(rooms(kUprights, "", kLampInEast));
  const BakeSettings settings = loaded.level.bake;
  LightMemory memory;
  ASSERT_TRUE(Rebake(memory, loaded.scene(), settings, 2).finish());
  for (TexelHoles& holes : loaded.level.holes) {
    holes = TexelHoles(2, 1);
    holes.setHole(1, 0);
  }
  Rebake rebake(memory, loaded.scene(), settings, 2);
  EXPECT_GT(rebake.texelLightsLeft(), 0);
  const auto again = rebake.finish();
  const BakedLight fresh = bake(loaded.scene(), settings, 2);
  test::expectSame(loaded.scene(), *again, fresh);
}

TEST(GeometryHash, changesWithAMiddleTextureAndItsHoles) {
  const LoadedLevel none = rooms("", "", "[]");
  const LoadedLevel uprights = rooms(kUprights, "", "[]");
  const LoadedLevel wider = rooms(",'middle':'#808080 3,2'", "", "[]");
  const double texel = 0.125;
  EXPECT_NE(geometryHash(none.scene(), texel), geometryHash(uprights.scene(), texel));
  EXPECT_NE(geometryHash(uprights.scene(), texel), geometryHash(wider.scene(), texel));
  EXPECT_NE(geometryHash(uprights.scene(), texel), geometryHash(withGaps(uprights).scene(), texel));
}

}  // namespace
}  // namespace hearth
