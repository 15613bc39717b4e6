// Saved bakes: what is written is read again, by levels of the same geometry.

#include "light/saved_bake.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "saved_room.h"
#include "support/baked_room.h"
#include "support/hall_and_cellar.h"
#include "support/in_tree.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::kMuchLight;
using test::kSettings;
using test::SavedRoom;

void expectSameLight(const BakedLight& a, const BakedLight& b) {
  ASSERT_EQ(a.lightmaps.size(), b.lightmaps.size());
  for (std::size_t i = 0; i < a.lightmaps.size(); ++i) {
    ASSERT_EQ(a.lightmaps[i].has_value(), b.lightmaps[i].has_value()) << i;
    if (!a.lightmaps[i]) continue;
    EXPECT_EQ(a.lightmaps[i]->rect, b.lightmaps[i]->rect);
    EXPECT_EQ(a.lightmaps[i]->channels, b.lightmaps[i]->channels);
    EXPECT_EQ(a.lightmaps[i]->levels, b.lightmaps[i]->levels);
  }
}

struct SavedSize {
  std::int64_t file = 0;   ///< bytes
  std::int64_t light = 0;  ///< lit texels, times their channels
  double perLevel() const { return static_cast<double>(file) / static_cast<double>(light); }
};

/// Bakes, saves, reads and draws.
SavedSize expectRoundTrip(const LoadedLevel& loaded) {
  const Level& level = loaded.level;
  const Scene scene = loaded.scene();
  const BakedLight light = bake(scene, level.bake, 2);
  const std::string bytes = encodeBake(scene, light, level.bake.texel, kSettings);
  const auto read = decodeBake(scene, bytes, kMuchLight);
  EXPECT_TRUE(read) << read.error().what;
  if (!read) return {};
  expectSameLight(light, *read);
  EXPECT_EQ(light.stats.litSurfaces, read->stats.litSurfaces);
  EXPECT_EQ(light.stats.bytes, read->stats.bytes);
  const Renderer baked(scene, loaded.textures, light);
  const Renderer again(scene, loaded.textures, *read);
  for (const Shot& shot : level.shots)
    EXPECT_EQ(baked.draw(cameraOf(shot), LightMode::Both),
              again.draw(cameraOf(shot), LightMode::Both))
        << shot.name;
  return {std::ssize(bytes), statsOf(test::withAllTexels(light)).bytes};
}

TEST(SavedBake, ofTheTutorialDrawsTheSamePictures) {
  const LoadResult result = loadLevel(test::inTree("levels/tutorial.json"));
  ASSERT_TRUE(result.loaded);
  EXPECT_LE(expectRoundTrip(*result.loaded).perLevel(), 0.3);
}

TEST(SavedBake, ofRandomLevelsDrawTheSamePictures) {
  const auto folder =
      std::filesystem::temp_directory_path() / fmt::format("hearth-saved-bake-{}", ::getpid());
  ASSERT_TRUE(writeRandomLevelTextures(folder / "textures"));
  SavedSize saved;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RandomLevel random = makeRandomLevel(seed);
    ASSERT_TRUE(writeRandomLevel(folder, random));
    const LoadResult result = loadLevel(folder / (random.name + ".json"));
    ASSERT_TRUE(result.loaded) << seed;
    const SavedSize size = expectRoundTrip(*result.loaded);
    saved.file += size.file;
    saved.light += size.light;
  }
  std::filesystem::remove_all(folder);
  EXPECT_LE(saved.perLevel(), 0.4);
}

TEST(SavedBake, holdsALevelWithItsMoversAtRest) {
  const SourcedResult authored = test::hallAndCellar();
  std::string bytes;
  for (const std::vector<double>& shares : {std::vector{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}) {
    const LoadedLevel moved = *levelAt(*authored.result.loaded, authored.source, shares).loaded;
    bytes += encodeBake(moved.scene(), bake(moved.scene(), {}, 2), BakeSettings{}.texel, "");
  }
  for (const std::vector<double>& shares : {std::vector{1.0, 1.0}, {0.0, 0.0}, {1.0, 0.0}}) {
    const LoadedLevel moved = *levelAt(*authored.result.loaded, authored.source, shares).loaded;
    const auto read = decodeBake(moved.scene(), bytes, kMuchLight);
    ASSERT_TRUE(read) << read.error().what;
    expectSameLight(*read, bake(moved.scene(), {}, 2));
  }
  const LoadedLevel missing =
      *levelAt(*authored.result.loaded, authored.source, std::vector{0.0, 1.0}).loaded;
  const auto refused = decodeBake(missing.scene(), bytes, kMuchLight);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            "was baked for other geometry than the level has now, with the settings \"\"");
}

TEST_F(SavedRoom, isReadWithOneChannelAndWithThree) {
  const auto read = decodeBake(room_.scene(), saved(), kMuchLight);
  ASSERT_TRUE(read) << read.error().what;
  expectSameLight(room_.light(), *read);
  EXPECT_EQ(read->stats.litSurfaces, 6U);
  EXPECT_EQ(read->stats.coloredSurfaces, 5U) << "all but the floor, in which the red lamp lies";
}

TEST_F(SavedRoom, isReadWithItsLightmapsInAnyOrderAndAnyOfThemMissing) {
  BakedLight light = room_.light();
  light.lightmaps[0].reset();
  const auto read = decodeBake(room_.scene(), encodeBake(room_.scene(), light, 1, ""), kMuchLight);
  ASSERT_TRUE(read) << read.error().what;
  expectSameLight(light, *read);

  // The floor's, of one channel, behind that of the ceiling, of three.
  std::string bytes = lightmaps();
  const auto first = bytes.begin();
  const std::ptrdiff_t texels = room_.light().surfaces[0]->texels.count();
  std::rotate(first, first + kMapHeader + texels, first + 2 * kMapHeader + 4 * texels);
  const auto turned = decodeBake(room_.scene(), withLightmaps(bytes), kMuchLight);
  ASSERT_TRUE(turned) << turned.error().what;
  expectSameLight(room_.light(), *turned);
}

TEST_F(SavedRoom, isRefusedByALevelOfOtherGeometry) {
  // A tenth of a millimetre moves no texel and is another room all the same.
  const BakedRoom moved = roomOf("1.9999");
  ASSERT_EQ(moved.light().surfaces[0]->texels, room_.light().surfaces[0]->texels);
  const auto read = decodeBake(moved.scene(), saved(), kMuchLight);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().what,
            "was baked for other geometry than the level has now, with the settings "
            "\"--samples 4\"");
}

TEST_F(SavedRoom, isTakenByALevelOfOtherLightAndTextures) {
  std::string text = roomText("2");
  for (std::size_t at = 0; (at = text.find("#808080", at)) != std::string::npos;)
    text.replace(at, 7, "#123456");
  const LoadedLevel other = test::levelFrom(text, "[{'x':0.5,'y':1,'z':1}]");
  const auto read = decodeBake(other.scene(), saved(), kMuchLight);
  ASSERT_TRUE(read) << read.error().what;
  expectSameLight(room_.light(), *read);
}

TEST(SavedBake, hasAllTexelsOfEvenLight) {
  const BakedRoom room(
      "{'light':0,'sectors':{" + test::sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3) + "}}",
      "[{'x':2,'y':2,'z':1,'intensity':77}]");
  const BakedLight& light = room.light();
  EXPECT_EQ(light.stats.bytes, std::ssize(light.lightmaps)) << "one texel a surface";
  const auto encoded = [&](const BakedLight& baked) {
    return encodeBake(room.scene(), baked, room.level().bake.texel, kSettings);
  };
  EXPECT_EQ(encoded(light), encoded(test::withAllTexels(light)));
  EXPECT_LE(encoded(light).size(), 150U) << "for " << statsOf(test::withAllTexels(light)).bytes;
  const auto read = decodeBake(room.scene(), encoded(light), kMuchLight);
  ASSERT_TRUE(read) << read.error().what;
  expectSameLight(light, *read);
}

TEST_F(SavedRoom, hasDifferencesFromTheTexelAboveOrInTheFirstRowToTheLeft) {
  const std::string all = lightmaps();
  std::size_t at = 0;
  for (const auto& map : room_.light().lightmaps) {
    at += kMapHeader;
    const TexelRect& rect = map->rect;
    for (int j = rect.j0; j < rect.j0 + rect.height; ++j)
      for (int i = rect.i0; i < rect.i0 + rect.width; ++i)
        for (int channel = 0; channel < map->channels; ++channel) {
          const int neighbour = j > rect.j0   ? map->at(i, j - 1, channel)
                                : i > rect.i0 ? map->at(i - 1, j, channel)
                                              : 0;
          EXPECT_EQ(static_cast<std::uint8_t>(all[at]),
                    static_cast<std::uint8_t>(map->at(i, j, channel) - neighbour));
          ++at;
        }
  }
  EXPECT_EQ(at, all.size());
}

}  // namespace
}  // namespace hearth
