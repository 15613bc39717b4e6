#include <fmt/format.h>
#include <gtest/gtest.h>

#include "image/image_file.h"
#include "load_text.h"
#include "support/temporary_folder.h"

/// What sprites become. What is wrong with some is told in bad/.
namespace hearth {
namespace {

const std::string kRoom = "0,0, 4,0, 4,4, 0,4";
const std::string kEast = "4,0, 8,0, 8,4, 4,4";
const std::string kSolid = "{'texture': '#808080'}";

std::string levelText(std::string_view things, std::string_view sectors) {
  return fmt::format("{{'light': 1, 'things': [{}], 'sectors': {{{}}}}}", things, sectors);
}

LoadedLevel withThings(std::string_view things, std::string_view sectors = sectorText("a", kRoom)) {
  LoadResult result = loadText(levelText(things, sectors));
  if (result.loaded) return *std::move(result.loaded);
  ADD_FAILURE() << listed(result);
  std::abort();
}

Sprite onlySprite(std::string_view thing, std::string_view sectors = sectorText("a", kRoom)) {
  const LoadedLevel loaded = withThings(thing, sectors);
  EXPECT_EQ(loaded.level.sprites.size(), 1U);
  return loaded.level.sprites.at(0);
}

/// Two rooms that are open to each other, the second one on a floor of its own height.
std::string twoRooms(double eastFloor) {
  const std::string toEast =
      fmt::format("[{0}, {{'next': 'b', 'texture': '#808080'}}, {0}, {0}]", kSolid);
  const std::string toWest =
      fmt::format("[{0}, {0}, {0}, {{'next': 'a', 'texture': '#808080'}}]", kSolid);
  return sectorText("a", kRoom, toEast) + "," +
         sectorText("b", kEast, toWest,
                    fmt::format("'floor': {{'z': {}, 'texture': '#808080'}}", eastFloor));
}

TEST(SpriteLoad, takesDefaultsForAllButItsImageAndPlace) {
  const Sprite sprite = onlySprite("{'sprite': '#c04020', 'x': 1, 'y': 2}");
  EXPECT_EQ(sprite.name, "");
  EXPECT_EQ(sprite.position, (Vec3{1, 2, 0}));
  EXPECT_EQ(sprite.sector, SectorId(0));
  EXPECT_EQ(sprite.angle, 0);
  EXPECT_EQ(sprite.facing, Facing::Camera);
  EXPECT_EQ(sprite.offset, Vec2{});
  ASSERT_EQ(sprite.frames.size(), 1U);
  ASSERT_EQ(sprite.frames[0].size(), 1U);
  EXPECT_EQ(sprite.frames[0][0].size, (Vec2{1.0 / 64, 1.0 / 64})) << "of one texel";
  EXPECT_FALSE(sprite.isBright);
  EXPECT_FALSE(sprite.body);
}

TEST(SpriteLoad, takesEveryKey) {
  const Sprite sprite = onlySprite(
      "{'name': 'lamp', 'sprite': '#c04020', 'x': 1, 'y': 2, 'z': 1.5, 'sector': 'a', 'angle': -90,"
      " 'size': [0.5, 2], 'offset': [0.25, -0.125], 'facing': 'angle', 'bright': true,"
      " 'radius': 0.25, 'height': 0.75}");
  EXPECT_EQ(sprite.name, "lamp");
  EXPECT_EQ(sprite.position, (Vec3{1, 2, 1.5}));
  EXPECT_EQ(sprite.angle, -90);
  EXPECT_EQ(sprite.facing, Facing::Angle);
  EXPECT_EQ(sprite.frames[0][0].size, (Vec2{0.5, 2}));
  EXPECT_EQ(sprite.offset, (Vec2{0.25, -0.125}));
  EXPECT_TRUE(sprite.isBright);
  ASSERT_TRUE(sprite.body);
  EXPECT_EQ(sprite.body->radius, 0.25);
  EXPECT_EQ(sprite.body->height, 0.75);
}

TEST(SpriteLoad, takesTheFacingsByTheirNames) {
  const auto facing = [](std::string_view name) {
    return onlySprite(fmt::format("{{'sprite': '#c04020', 'x': 1, 'y': 1, 'facing': '{}'}}", name))
        .facing;
  };
  EXPECT_EQ(facing("camera"), Facing::Camera);
  EXPECT_EQ(facing("angle"), Facing::Angle);
  EXPECT_EQ(facing("flat"), Facing::Flat);
}

TEST(SpriteLoad, keepsItsImagesByFrameAndSideAndReadsEachOnce) {
  const LoadedLevel loaded = withThings(
      "{'frames': [['#000001', '#000002'], '#000003', ['#000002', '#000001']], 'fps': 2.5,"
      " 'x': 1, 'y': 1}");
  const Sprite& sprite = loaded.level.sprites.at(0);
  EXPECT_EQ(sprite.framesPerSecond, 2.5);
  std::string names;
  for (const std::vector<SpriteView>& views : sprite.frames) {
    for (const SpriteView& view : views) names += loaded.level.textures[view.texture.index()];
    names += " ";
  }
  EXPECT_EQ(names, "#000001#000002 #000003 #000002#000001 ");
  EXPECT_EQ(loaded.level.textures.size(), 3U + 2U) << "two of the room";
}

TEST(SpriteLoad, takesAListOfOneViewForThatImage) {
  EXPECT_EQ(onlySprite("{'sprite': ['#c04020'], 'x': 1, 'y': 1}").frames[0].size(), 1U);
}

TEST(SpriteLoad, takesTheSizeOfEachImageAt64TexelsAMetre) {
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writePng(folder.path() / "wide.png", Image(96, 32)));
  ASSERT_TRUE(writePng(folder.path() / "high.png", Image(16, 128)));
  std::string text =
      levelText("{'sprite': ['wide', 'high'], 'x': 1, 'y': 1}", sectorText("a", kRoom));
  std::ranges::replace(text, '\'', '"');
  const LoadResult result = loadLevel(folder.write("level.json", text));
  ASSERT_TRUE(result.loaded) << listed(result);
  const std::vector<SpriteView>& views = result.loaded->level.sprites.at(0).frames.at(0);
  EXPECT_EQ(views[0].size, (Vec2{1.5, 0.5}));
  EXPECT_EQ(views[1].size, (Vec2{0.25, 2}));
  EXPECT_EQ(result.loaded->textures[views[1].texture.index()].height(), 128) << "it is decoded";
}

TEST(SpriteLoad, standsOnTheFloorOfTheSectorThatItIsFoundIn) {
  const Sprite sprite = onlySprite("{'sprite': '#c04020', 'x': 6, 'y': 1}", twoRooms(0.5));
  EXPECT_EQ(sprite.sector, SectorId(1));
  EXPECT_EQ(sprite.position.z, 0.5);
}

TEST(SpriteLoad, standsOnASlope) {
  const Sprite sprite =
      onlySprite("{'sprite': '#c04020', 'x': 3, 'y': 1}",
                 sectorText("a", kRoom, kSolid, "'slopeFloor': {'z': [0, 2, 2, 0]}"));
  EXPECT_EQ(sprite.position.z, 1.5);
}

TEST(SpriteLoad, onTheBorderOfTwoSectorsOfOneFloorTakesTheFirstOrTheNamedOne) {
  EXPECT_EQ(onlySprite("{'sprite': '#c04020', 'x': 4, 'y': 1}", twoRooms(0)).sector, SectorId(0));
  EXPECT_EQ(onlySprite("{'sprite': '#c04020', 'x': 4, 'y': 1, 'sector': 'b'}", twoRooms(0)).sector,
            SectorId(1));
}

TEST(SpriteLoad, onTheEdgeOfAStepAsksForASectorOrAHeight) {
  const LoadResult result =
      loadText(levelText("{'sprite': '#c04020', 'x': 4, 'y': 1}", twoRooms(0.5)));
  ASSERT_EQ(countErrors(result), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].message, "(4, 1) lies in several sectors: \"a\", \"b\"");
  EXPECT_EQ(result.diagnostics[0].advice, "say in which with \"sector\", or how high with \"z\"");
  EXPECT_EQ(
      onlySprite("{'sprite': '#c04020', 'x': 4, 'y': 1, 'sector': 'b'}", twoRooms(0.5)).position.z,
      0.5);
}

TEST(SpriteLoad, fallsThroughOpenFloorsToTheOneThatBears) {
  const std::string storeys =
      sectorText(
          "up", kRoom, kSolid,
          "'floor': {'z': 4, 'next': 'up-down'}, 'ceiling': {'z': 8, 'texture': '#404040'}") +
      "," + sectorText("down", kRoom, kSolid, "'ceiling': {'z': 4, 'next': 'up-down'}");
  const Sprite found = onlySprite("{'sprite': '#c04020', 'x': 1, 'y': 1}", storeys);
  EXPECT_EQ(found.sector, SectorId(1));
  EXPECT_EQ(found.position.z, 0);
  const Sprite named = onlySprite("{'sprite': '#c04020', 'x': 1, 'y': 1, 'sector': 'up'}", storeys);
  EXPECT_EQ(named.sector, SectorId(0));
  EXPECT_EQ(named.position.z, 4);
}

TEST(SpriteLoad, outsideOnThePlanIsNearestToASectorOnThePlan) {
  const LoadResult result = loadText(levelText(
      "{'sprite': '#c04020', 'x': 9, 'y': 1}",
      sectorText("low", kRoom) + "," +
          sectorText("high", kEast, kSolid,
                     "'floor': {'z': 50, 'texture': '#808080'}, 'ceiling': {'z': 60, 'texture': "
                     "'#404040'}")));
  ASSERT_EQ(countErrors(result), 1U) << listed(result);
  EXPECT_EQ(result.diagnostics[0].message,
            "(9, 1) lies in no sector; the nearest is \"high\", 1 m away");
}

TEST(SpriteLoad, keepsTheOrderOfTheFileAndIgnoresComments) {
  const LoadedLevel loaded = withThings(
      "{'//': 'left of the door', 'name': 'first', 'sprite': '#c04020', 'x': 1, 'y': 1},"
      "{'name': 'second', '$id': 7, 'sprite': '#c04020', 'x': 1, 'y': 1}");
  ASSERT_EQ(loaded.level.sprites.size(), 2U);
  EXPECT_EQ(loaded.level.sprites[0].name, "first");
  EXPECT_EQ(loaded.level.sprites[1].name, "second");
}

TEST(SpriteLoad, mayShareItsName) {
  EXPECT_EQ(withThings("{'name': 'torch', 'sprite': '#c04020', 'x': 1, 'y': 1},"
                       "{'name': 'torch', 'sprite': '#c04020', 'x': 2, 'y': 1}")
                .level.sprites.size(),
            2U);
}

TEST(SpriteLoad, hasASurfaceAfterAllOthers) {
  const LoadedLevel loaded = withThings(
      "{'sprite': '#c04020', 'x': 1, 'y': 1, 'facing': 'flat'},"
      "{'sprite': '#c04020', 'x': 2, 'y': 1, 'z': 1, 'size': [1, 2], 'offset': [0, 0.25]}");
  const Level& level = loaded.level;
  ASSERT_EQ(level.surfaces.size(), 6U + 2U) << "of the room: four walls and two flats";
  EXPECT_EQ(level.surfaces[6].kind, SurfaceKind::FlatSprite);
  EXPECT_EQ(level.surfaces[7].kind, SurfaceKind::CameraSprite);
  EXPECT_EQ(&level.spriteOf(SurfaceId(7)), &level.sprites[1]);
  EXPECT_EQ(loaded.scene().geometryOf(SurfaceId(7)).zBottom, 1.25);
  EXPECT_EQ(loaded.scene().geometryOf(SurfaceId(7)).zTop, 3.25);
}

TEST(SpriteLoad, ofALevelWithoutThingsIsNone) {
  EXPECT_EQ(withThings("").level.sprites.size(), 0U);
  EXPECT_EQ(loadSectors(sectorText("a", kRoom)).level.sprites.size(), 0U);
}

LoadResult withImagesAtMost(std::size_t images, std::string_view things) {
  LoadLimits limits;
  limits.spriteImages = images;
  return loadText(levelText(things, sectorText("a", kRoom)), "", limits);
}

TEST(SpriteLoad, ofMoreImagesThanTheLimitIsRefusedOnce) {
  const std::string two = "{'sprite': ['#000001', '#000001'], 'x': 1, 'y': 1}";
  const std::string frames =
      "{'frames': [['#000001', '#000001'], '#000001'], 'fps': 1, 'x': 1, 'y': 1}";
  EXPECT_TRUE(withImagesAtMost(5, two + "," + frames).loaded);
  for (const std::string& things : {two + "," + frames + "," + two, frames + "," + frames}) {
    const LoadResult result = withImagesAtMost(4, things);
    ASSERT_EQ(result.diagnostics.size(), 1U) << listed(result);
    EXPECT_EQ(result.diagnostics[0].message, "more than 4 images of sprites");
    EXPECT_EQ(result.diagnostics[0].advice, "raise the limit with --max-sprite-images");
  }
  EXPECT_EQ(withImagesAtMost(2, "0, 0, 0").diagnostics.size(), 1U)
      << "more things than images: not one of them is looked at";
}

}  // namespace
}  // namespace hearth
