// Coloured light, baked and read at points of the world.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>

#include "render/renderer.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

const std::string kRoom = fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                                      sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3));

std::array<double, 3> rgbAt(const BakedRoom& room, SurfaceKind kind, Vec3 p) {
  return {room.at(kind, p, "", 0), room.at(kind, p, "", 1), room.at(kind, p, "", 2)};
}

const Lightmap& mapAt(const BakedRoom& room, SurfaceKind kind, Vec3 p) {
  return *room.light().lightmaps[room.surfaceAt(kind, p, "")->index()];
}

TEST(ColoredLight, isMultipliedByItsColourInEachChannel) {
  const BakedRoom room(kRoom, "[{'x':2,'y':2,'z':1,'intensity':200,'color':'#ff8000'}]");
  EXPECT_EQ(rgbAt(room, SurfaceKind::Floor, {3, 1, 0}),
            (std::array<double, 3>{200, 100, 0}));  // 200 * 128/255 = 100.4
}

TEST(ColoredLight, addsUpByChannelAndIsClampedOnce) {
  const BakedRoom room(kRoom,
                       "[{'x':2,'y':2,'z':1,'intensity':200,'color':'#ff0000'},"
                       "{'x':4,'y':2,'z':1,'intensity':100.3,'color':'#ff00ff'},"
                       "{'x':3,'y':2,'z':1,'intensity':10.3}]");
  EXPECT_EQ(rgbAt(room, SurfaceKind::Floor, {3, 1, 0}), (std::array<double, 3>{255, 10, 111}));
}

TEST(ColoredLight, takesThreeChannelsOnlyWhereItReaches) {
  // The red lamp lies in the floor's plane: it lights everything but the floor.
  const BakedRoom room(
      kRoom,
      "[{'x':2,'y':2,'z':0,'intensity':200,'color':'#ff0000'},{'x':4,'y':2,'z':1,'intensity':20}]");
  EXPECT_EQ(mapAt(room, SurfaceKind::Floor, {3, 1, 0}).channels, 1);
  EXPECT_EQ(mapAt(room, SurfaceKind::Ceiling, {3, 1, 3}).channels, 3);
  EXPECT_EQ(room.light().stats.coloredSurfaces, 5U) << "the ceiling and four walls";
}

TEST(ColoredLight, thatIsStoppedOnItsWayTakesOneChannel) {
  // Both rooms' walls run along one another; no light crosses.
  const std::string rooms = fmt::format("{{'light': 0, 'sectors': {{{}, {}}}}}",
                                        sectorText("west", "0,0, 6,0, 6,4, 0,4", 0, 3),
                                        sectorText("east", "6,0, 9,0, 9,4, 6,4", 0, 3));
  const BakedRoom baked(rooms, "[{'x':5,'y':2,'z':1,'color':'#00ff00'},{'x':7,'y':2,'z':1}]");
  for (std::size_t i = 0; i < baked.light().lightmaps.size(); ++i) {
    const auto& map = baked.light().lightmaps[i];
    if (!map) continue;
    const bool isWest = baked.level()[baked.level().surfaces[i].sector].name == "west";
    EXPECT_EQ(map->channels, isWest ? 3 : 1);
  }
}

TEST(ColoredLight, thatIsGreyIsWhiteLightOfLessStrength) {
  const BakedRoom room(kRoom, "[{'x':2,'y':2,'z':1,'intensity':255,'color':'#646464'}]");
  EXPECT_EQ(mapAt(room, SurfaceKind::Floor, {3, 1, 0}).channels, 1);
  EXPECT_EQ(room.at(SurfaceKind::Floor, {3, 1, 0}), 100);
}

TEST(ColoredLight, isDrawnInEveryChannelWithTheSectorsLight) {
  const std::string room = fmt::format("{{'light': 0.2, 'sectors': {{{}}}}}",
                                       sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3));
  const BakedRoom baked(room, "[{'x':2,'y':2,'z':1,'intensity':200,'color':'#ff8000'}]");
  const std::vector<Image> textures(baked.level().textures.size(), Image(1, 1, Rgb{100, 100, 200}));
  const Renderer renderer(baked.scene(), textures, baked.light());
  const Camera camera{SectorId(0), {3, 2, 1.5}, 0, -40, 90, 9, 9};
  EXPECT_EQ(renderer.draw(camera, LightMode::Only).at(4, 4), (Rgb{251, 151, 51}));
  EXPECT_EQ(renderer.draw(camera, LightMode::Both).at(4, 4), (Rgb{98, 59, 40}));
  EXPECT_EQ(renderer.draw(camera, Channel::Light).at(4, 4), (Rgb{200, 100, 0}));
}

}  // namespace
}  // namespace hearth
