#include "random_levels/random_level.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "image/image_file.h"
#include "load/load.h"

namespace hearth {
namespace {

constexpr std::uint64_t kLevels = 500;
constexpr std::uint64_t kFewLevels = 150;  // where the sanitizers would take long
constexpr double kLeastFraction = 0.05;

TEST(RandomLevel, SameSeedGivesSameBytes) {
  for (const std::uint64_t seed : {0u, 1u, 77u, 4000000000u}) {
    const RandomLevel a = makeRandomLevel(seed);
    const RandomLevel b = makeRandomLevel(seed);
    EXPECT_EQ(a.levelJson, b.levelJson);
    EXPECT_EQ(a.lightsJson, b.lightsJson);
    EXPECT_EQ(a.features, b.features);
  }
}

TEST(RandomLevel, NeighbouringSeedsGiveDifferentLevels) {
  EXPECT_NE(makeRandomLevel(1).levelJson, makeRandomLevel(2).levelJson);
}

TEST(RandomLevel, IsMadeAnewWhereAMeshLeavesNoRoomForSectors) {
  const RandomLevel level = makeRandomLevel(16944);
  EXPECT_GE(nlohmann::json::parse(level.levelJson)["sectors"].size(), 3u);
}

TEST(RandomLevel, EveryFeatureIsInATwentiethOfTheLevels) {
  std::map<Feature, std::uint64_t> counts;
  for (std::uint64_t seed = 0; seed < kLevels; ++seed) {
    for (const Feature feature : makeRandomLevel(seed).features) ++counts[feature];
  }
  for (const auto& [feature, name] : kFeatures) {
    EXPECT_GE(static_cast<double>(counts[feature]), kLeastFraction * kLevels) << name;
  }
}

TEST(RandomLevel, HasMeshesInThreeOfTen) {
  int withMeshes = 0;
  for (std::uint64_t seed = 0; seed < kLevels; ++seed) {
    const auto json = nlohmann::json::parse(makeRandomLevel(seed).levelJson);
    const auto things = json.value("things", nlohmann::json::array());
    const auto isMesh = [](const nlohmann::json& thing) { return thing.contains("mesh"); };
    const auto meshes = std::count_if(things.begin(), things.end(), isMesh);
    EXPECT_LE(meshes, 4) << seed;
    withMeshes += meshes > 0 ? 1 : 0;
  }
  EXPECT_NEAR(withMeshes, 0.3 * kLevels, 0.05 * kLevels);
}

TEST(RandomLevel, EveryFeatureHasOneName) {
  std::set<std::string_view> names;
  for (std::size_t i = 0; i < kFeatures.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(kFeatures[i].first), i);
    EXPECT_TRUE(names.insert(kFeatures[i].second).second) << kFeatures[i].second;
  }
}

TEST(RandomLevel, FilesParseAndHoldTheViews) {
  for (std::uint64_t seed = 0; seed < kFewLevels; ++seed) {
    const RandomLevel level = makeRandomLevel(seed);
    const auto json = nlohmann::json::parse(level.levelJson, nullptr, false);
    const auto lights = nlohmann::json::parse(level.lightsJson, nullptr, false);
    ASSERT_TRUE(json.is_object()) << seed;
    ASSERT_TRUE(lights.is_object() || lights.is_array()) << seed;
    EXPECT_GE(level.views.size(), 4u) << seed;
    ASSERT_EQ(json["shots"].size(), level.views.size()) << seed;
    EXPECT_EQ(json["shots"][0]["camera"][0].get<double>(), level.views[0].x) << seed;
    EXPECT_GE(json["sectors"].size(), 3u) << seed;
  }
}

/// Levels on disk, as a program would load them.
class RandomLevelFiles : public testing::Test {
 protected:
  void SetUp() override {
    const auto written = writeRandomLevelTextures(folder_ / "textures");
    ASSERT_TRUE(written) << written.error();
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  LoadResult load(const RandomLevel& level) const {
    const auto written = writeRandomLevel(folder_, level);
    EXPECT_TRUE(written) << written.error();
    return loadLevel(folder_ / (level.name + ".json"));
  }

 private:
  std::filesystem::path folder_ = std::filesystem::path(testing::TempDir()) /
                                  testing::UnitTest::GetInstance()->current_test_info()->name();
};

bool warnsOf(const LoadResult& result, std::string_view what) {
  return std::any_of(result.diagnostics.begin(), result.diagnostics.end(),
                     [&](const Diagnostic& d) { return d.message.find(what) != d.message.npos; });
}

TEST_F(RandomLevelFiles, LoadWithoutAnError) {
  for (std::uint64_t seed = 0; seed < kLevels; ++seed) {
    const LoadResult result = load(makeRandomLevel(seed));
    for (const Diagnostic& diagnostic : result.diagnostics) {
      EXPECT_FALSE(diagnostic.isError) << format(diagnostic);
    }
    EXPECT_TRUE(result.loaded) << seed;
  }
}

TEST_F(RandomLevelFiles, LoadWithTheWarningsThatTheirFeaturesPromise) {
  for (std::uint64_t seed = 0; seed < kFewLevels; ++seed) {
    const RandomLevel level = makeRandomLevel(seed);
    const LoadResult result = load(level);
    const auto& features = level.features;
    EXPECT_EQ(warnsOf(result, "one-way portal"), features.contains(Feature::OneWayPortal)) << seed;
    EXPECT_EQ(warnsOf(result, "the wrong way"), features.contains(Feature::WrongWinding)) << seed;
  }
}

TEST(RandomLevelTextures, AreWrittenWithNoTwoTexelsAlike) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "random_level_textures";
  const auto written = writeRandomLevelTextures(folder);
  ASSERT_TRUE(written) << written.error();
  std::set<std::uint32_t> colours;
  std::vector<RandomTexture> textures(kRandomLevelTextures.begin(), kRandomLevelTextures.end());
  textures.insert(textures.end(), kRandomLevelMiddles.begin(), kRandomLevelMiddles.end());
  for (const RandomTexture& texture : textures) {
    const auto image = readImage(folder / (std::string(texture.name) + ".png"), 1 << 20);
    ASSERT_TRUE(image) << image.error();
    EXPECT_EQ(image->width(), texture.width);
    EXPECT_EQ(image->height(), texture.height);
    for (const Rgb c : image->pixels()) {
      const std::uint32_t colour = std::uint32_t{c.r} << 16 | std::uint32_t{c.g} << 8 | c.b;
      EXPECT_TRUE(colours.insert(colour).second) << texture.name;
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(WriteRandomLevel, SaysWhichFolderItCannotMake) {
  const auto written = writeRandomLevel("/dev/null/levels", makeRandomLevel(1));
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().find("/dev/null/levels"), std::string::npos) << written.error();
}

}  // namespace
}  // namespace hearth
