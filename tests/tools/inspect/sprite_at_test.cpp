// The sprite that is pointed at.

#include "viewer/inspect/sprite_at.h"

#include <gtest/gtest.h>

#include <string>

#include "loaded.h"
#include "support/level_text.h"
#include "viewer/inspect/places.h"
#include "viewer/inspect/words.h"

namespace hearth {
namespace {

const std::string kSolid = "{'texture':'#808080'}";

/// Two rooms of 4 by 4 m that are open to each other, and a third one that overlaps the east one.
SourcedResult roomsWith(const std::string& things) {
  return test::levelWithSourceFrom(
      "{'light':0.5,'things':[" + things + "],\n'sectors':{" +
      test::sectorText("west", "0,0, 4,0, 4,4, 0,4", 0, 3,
                       "[" + kSolid + ",{'next':'east'}," + kSolid + "," + kSolid + "]") +
      "," +
      test::sectorText("east", "4,0, 8,0, 8,4, 4,4", 0, 3,
                       "[" + kSolid + "," + kSolid + "," + kSolid + ",{'next':'west'}]") +
      "," + test::sectorText("other", "5,0, 8,0, 8,4, 5,4", 0, 3) + "}}");
}

/// What a look from the west along `direction` meets within 100 m.
std::optional<std::size_t> metIn(const LoadedLevel& level, Vec3 direction) {
  const auto textures = drawnTextures(level.textures, TextureFilter::Nearest);
  const auto hit =
      spriteAt(level.scene(), textures, {SectorId(0), {1, 2, 1}, direction, {0, 1}}, 100);
  if (!hit) return std::nullopt;
  return hit->sprite;
}

TEST(SpriteAt, IsTheNearestOne) {
  const SourcedResult rooms = roomsWith(
      "{'sprite':'#c04020','x':6,'y':2,'size':[1,2],'sector':'east'},{'sprite':'#c04020','x':3,'y':"
      "2,'size':[1,2]"
      "}");
  EXPECT_EQ(metIn(*rooms.result.loaded, {1, 0, 0}), 1U);
  EXPECT_EQ(metIn(*rooms.result.loaded, {1, 0.3, 0}), std::nullopt) << "beside the images";
  EXPECT_EQ(metIn(*rooms.result.loaded, {-1, 0, 0}), std::nullopt) << "behind the eye";
}

TEST(SpriteAt, OfTwoAtOnePlaceIsTheLater) {
  const std::string one = "{'sprite':'#c04020','x':3,'y':2,'size':[1,2]}";
  EXPECT_EQ(metIn(*roomsWith(one + "," + one).result.loaded, {1, 0, 0}), 1U);
}

TEST(SpriteAt, IsSeenThroughAnOpeningButNotInARoomThatMerelyOverlaps) {
  const std::string one = "{'sprite':'#c04020','x':6,'y':2,'size':[1,2],'sector':";
  EXPECT_EQ(metIn(*roomsWith(one + "'east'}").result.loaded, {1, 0, 0}), 0U);
  EXPECT_EQ(metIn(*roomsWith(one + "'other'}").result.loaded, {1, 0, 0}), std::nullopt);
}

TEST(SpriteAt, IsFoundWhereItLiesOnTheFloor) {
  const SourcedResult rooms =
      roomsWith("{'sprite':'#c04020','x':3,'y':2,'size':[1,1],'facing':'flat'}");
  EXPECT_EQ(metIn(*rooms.result.loaded, {2, 0, -1}), 0U);
  EXPECT_EQ(metIn(*rooms.result.loaded, {4, 0, -1}), std::nullopt);
}

TEST(SpriteAt, IsNotFoundBehindWhatElseIsMet) {
  const SourcedResult rooms =
      roomsWith("{'sprite':'#c04020','x':6,'y':2,'size':[1,2],'sector':'east'}");
  const LoadedLevel& level = *rooms.result.loaded;
  const auto textures = drawnTextures(level.textures, TextureFilter::Nearest);
  const SpriteLook look{SectorId(0), {1, 2, 1}, {1, 0, 0}, {0, 1}};
  EXPECT_TRUE(spriteAt(level.scene(), textures, look, 5));
  EXPECT_FALSE(spriteAt(level.scene(), textures, look, 4.9)) << "a surface is met before";
}

TEST(SpriteAt, HasItsPlaceInTheFileAndWords) {
  const SourcedResult rooms = roomsWith(
      "{'sprite':'#c04020','x':1,'y':3},\n{'name':'lamp','sprite':['#c04020','#a04020'],'x':3,'y':"
      "2,"
      "'bright':true}");
  const auto ending = [](const std::string& place) { return place.substr(place.find(".json")); };
  EXPECT_EQ(ending(placeOfSprite(rooms.source, 1)), ".json:2 /things/1");
  EXPECT_EQ(ending(placeOfSpriteImage(rooms.source, 1)), ".json:2 /things/1/sprite/0");
  const Level& level = rooms.result.loaded->level;
  EXPECT_EQ(spriteWords(level, 0), "camera sprite \"#c04020\"");
  EXPECT_EQ(spriteWords(level, 1), "camera sprite \"lamp\"");
  BakedLight light;
  light.lightmaps.resize(level.surfaces.size());
  EXPECT_EQ(spriteBrightnessWords(level, 1, light), "bright: shows as it is");
  EXPECT_TRUE(spriteBrightnessWords(level, 0, light).ends_with("the sector's own light gives 128"))
      << spriteBrightnessWords(level, 0, light);
}

}  // namespace
}  // namespace hearth
