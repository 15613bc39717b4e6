// Where masked middle textures hang.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "level/masked_middle.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::levelFrom;
using test::sectorText;

/// West and east of x = 4, with a masked middle texture on the west's portal, which is 3 m high.
LoadedLevel roomsWith(std::string_view middle, double eastFloor = 0, double eastCeiling = 3) {
  const std::string solid = "{'texture':'#808080'}";
  return levelFrom(fmt::format(
      "{{'light':1,'sectors':{{{},{}}}}}",
      sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                 fmt::format("[{0},{{'next':'east','texture':'#808080','middle':{1}}},{0},{0}]",
                             solid, middle)),
      sectorText("east", "4,0, 8,0, 8,4, 4,4", eastFloor, eastCeiling,
                 fmt::format("[{0},{0},{0},{{'next':'west','texture':'#808080'}}]", solid))));
}

/// "from to" of all that show.
std::string heightsOf(const LoadedLevel& loaded) {
  std::string text;
  const Scene scene = loaded.scene();
  for (const SurfaceId id : scene.shownSurfaces())
    if (scene[id].kind == SurfaceKind::MaskedMiddle)
      text += fmt::format("{} {};", scene.geometryOf(id).zBottom, scene.geometryOf(id).zTop);
  return text;
}

TEST(MiddleTexture, HangsOneRepeatFromTheTopOfItsOpening) {
  EXPECT_EQ(heightsOf(roomsWith("'#808080 1,1'")), "2 3;");
  EXPECT_EQ(heightsOf(roomsWith("'#808080 1,1'", 0, 2.5)), "1.5 2.5;");
  EXPECT_EQ(heightsOf(roomsWith("{'name':'#808080','scale':[1,1],'zref':1.5}")), "0.5 1.5;");
}

TEST(MiddleTexture, IsCutOffAtItsOpening) {
  EXPECT_EQ(heightsOf(roomsWith("'#808080 1,9'", 0.5, 2.5)), "0.5 2.5;");
  EXPECT_EQ(heightsOf(roomsWith("{'name':'#808080','scale':[1,2],'zref':4}", 0, 2.5)), "2 2.5;");
}

TEST(MiddleTexture, DoesNotShowWhereItIsOutsideItsOpening) {
  EXPECT_EQ(heightsOf(roomsWith("{'name':'#808080','scale':[1,1],'zref':0}")), "");
  EXPECT_EQ(heightsOf(roomsWith("{'name':'#808080','scale':[1,1],'zref':5}")), "");
  EXPECT_EQ(heightsOf(roomsWith("'#808080 1,1'", 1, 1)), "") << "there is no opening";
}

TEST(MiddleTexture, LiesInTheWayOfLightFromBothSides) {
  const LoadedLevel rooms = roomsWith("'#808080 1,1'");
  const Scene scene = rooms.scene();
  int openings = 0;
  for (const Segment& segment : rooms.level.segments)
    for (const LightOpening& opening : scene.lightOpeningsOf(segment)) {
      ++openings;
      ASSERT_EQ(scene.maskedMiddlesIn(opening).size(), 1U);
      EXPECT_EQ(scene[scene.maskedMiddlesIn(opening).front()].kind, SurfaceKind::MaskedMiddle);
    }
  EXPECT_EQ(openings, 2);
}

TEST(MiddleTexture, HasItsHolesWhereItsMappingPutsThem) {
  LoadedLevel rooms =
      roomsWith("{'name':'#808080','scale':[2,1],'offset':[1,0],'along':0.25,'zref':3}");
  TexelHoles holes(4, 2);  // of half a metre each
  holes.setHole(0, 1);
  rooms.level.holes.assign(rooms.level.textures.size(), holes);
  const Scene scene = rooms.scene();
  const std::vector<SurfaceId> shown = scene.shownSurfaces();
  const SurfaceId middle = *std::ranges::find(shown, SurfaceKind::MaskedMiddle,
                                              [&](SurfaceId id) { return scene[id].kind; });
  const auto isSolid = [&](double y, double z) { return isSolidAt(scene, middle, {4, y, z}); };
  // Its column 0 begins where s + 0.25 is half a metre, and comes again after 2 m.
  EXPECT_TRUE(isSolid(0.24, 2.25));
  EXPECT_FALSE(isSolid(0.26, 2.25));
  EXPECT_FALSE(isSolid(0.74, 2.25));
  EXPECT_TRUE(isSolid(0.76, 2.25));
  EXPECT_FALSE(isSolid(2.5, 2.25));
  EXPECT_TRUE(isSolid(0.5, 2.75)) << "the upper row";
}

}  // namespace
}  // namespace hearth
