// Bakes are found again when nothing has changed that they depend on, and never otherwise.

#include "inputs/bake_cache.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <vector>

#include "light/light_hash.h"
#include "support/level_text.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;
using test::levelFrom;
using test::sectorText;

constexpr std::uint64_t kProgram = 7;

LoadedLevel room(
    std::string_view lights = "[{'x':2,'y':1,'z':1}, {'x':3,'y':2,'z':1,'radius':0.2}]",
    double ceiling = 3) {
  return levelFrom("{'sectors':{" + sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, ceiling) + "}}",
                   lights);
}

void bakeAndKeep(const BakeCache& cache, const Scene& scene, const BakeSettings& settings) {
  cache.keep(scene, settings, bake(scene, settings, 2));
}

void expectSame(const BakedLight& found, const BakedLight& expected) {
  ASSERT_EQ(found.lightmaps.size(), expected.lightmaps.size());
  for (std::size_t i = 0; i < found.lightmaps.size(); ++i) {
    ASSERT_EQ(found.lightmaps[i].has_value(), expected.lightmaps[i].has_value()) << i;
    if (found.lightmaps[i]) {
      EXPECT_EQ(found.lightmaps[i]->levels, expected.lightmaps[i]->levels) << i;
    }
  }
}

class BakeCacheTest : public testing::Test {
 protected:
  BakeCacheTest()
      : folder_(fs::temp_directory_path() / fmt::format("hearth-bake-cache-{}", ::getpid())),
        cache_(folder_, kProgram) {
    fs::remove_all(folder_);
  }
  ~BakeCacheTest() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const {
    if (!fs::exists(folder_)) return {};
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_)) files.push_back(entry.path());
    return files;
  }

  fs::path onlyFile() const {
    const std::vector<fs::path> all = files();
    EXPECT_EQ(all.size(), 1U);
    return all.front();
  }

  fs::path folder_;
  BakeCache cache_;
};

TEST_F(BakeCacheTest, hasWhatWasKept) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  for (const BakeSettings& settings :
       {loaded.level.bake, BakeSettings{.texel = 0.5}, BakeSettings{.texel = 0.5, .samples = 4}}) {
    EXPECT_FALSE(cache_.find(scene, settings));
    const BakedLight baked = bake(scene, settings, 2);
    cache_.keep(scene, settings, baked);
    const auto found = cache_.find(scene, settings);
    ASSERT_TRUE(found);
    expectSame(*found, baked);
  }
}

TEST_F(BakeCacheTest, hasNothingOfAnotherProgram) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(cache_, scene, loaded.level.bake);
  EXPECT_FALSE(BakeCache(folder_, kProgram + 1).find(scene, loaded.level.bake));
}

TEST_F(BakeCacheTest, hasNothingThatWasAlteredOrCutShort) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(cache_, scene, loaded.level.bake);
  const fs::path file = onlyFile();
  std::ifstream in(file, std::ios::binary);
  const std::string whole(std::istreambuf_iterator<char>(in), {});
  const auto write = [&](const std::string& bytes) {
    std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
  };
  for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 50) {
    std::string altered = whole;
    altered[i] = static_cast<char>(altered[i] ^ 0x10);
    write(altered);
    EXPECT_FALSE(cache_.find(scene, loaded.level.bake)) << i;
    write(whole.substr(0, i));
    EXPECT_FALSE(cache_.find(scene, loaded.level.bake)) << i;
  }
  bakeAndKeep(cache_, scene, loaded.level.bake);
  EXPECT_TRUE(cache_.find(scene, loaded.level.bake));
}

TEST_F(BakeCacheTest, letsThoseGoThatWereUsedLongestAgo) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  const auto at = [&](double texel) { return BakeSettings{.texel = texel}; };
  bakeAndKeep(cache_, scene, at(0.5));
  const std::uint64_t size = fs::file_size(onlyFile());
  fs::remove_all(folder_);
  const BakeCache small(folder_, kProgram, 3 * size + 100);
  const auto setAge = [&](const BakeSettings& settings, int hours) {
    for (const fs::path& file : files())
      if (file.filename().string().find(fmt::format("{:016x}", lightHash(scene, settings))) !=
          std::string::npos)
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
  };
  for (const double texel : {0.5, 0.501, 0.502}) bakeAndKeep(small, scene, at(texel));
  EXPECT_EQ(files().size(), 3U);
  setAge(at(0.5), 3);
  setAge(at(0.501), 2);
  setAge(at(0.502), 1);
  EXPECT_TRUE(small.find(scene, at(0.5)));  // used now
  bakeAndKeep(small, scene, at(0.503));
  EXPECT_EQ(files().size(), 3U);
  EXPECT_FALSE(small.find(scene, at(0.501)));
  for (const double texel : {0.5, 0.502, 0.503}) EXPECT_TRUE(small.find(scene, at(texel))) << texel;
}

TEST_F(BakeCacheTest, keepsNothingThatIsLargerThanAll) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(BakeCache(folder_, kProgram, 100), scene, loaded.level.bake);
  EXPECT_TRUE(files().empty());
}

TEST_F(BakeCacheTest, clearsAwayWhatStoppedProgramsLeft) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(cache_, scene, loaded.level.bake);
  const fs::path old = folder_ / "1.bake.5.tmp";
  const fs::path recent = folder_ / "2.bake.6.tmp";
  for (const fs::path& part : {old, recent}) std::ofstream(part) << "half";
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(2));
  bakeAndKeep(cache_, scene, {.texel = 1});
  EXPECT_FALSE(fs::exists(old));
  EXPECT_TRUE(fs::exists(recent));
}

TEST_F(BakeCacheTest, isNoneWhereItsFolderCannotBe) {
  std::ofstream(folder_) << "a file";
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(cache_, scene, loaded.level.bake);
  EXPECT_FALSE(cache_.find(scene, loaded.level.bake));
  EXPECT_TRUE(fs::is_regular_file(folder_));
}

TEST_F(BakeCacheTest, readsNoFolderThatLiesInPlaceOfABake) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  bakeAndKeep(cache_, scene, loaded.level.bake);
  const fs::path file = onlyFile();
  fs::remove(file);
  fs::create_directory(file);
  EXPECT_FALSE(cache_.find(scene, loaded.level.bake));
  bakeAndKeep(cache_, scene, loaded.level.bake);
  EXPECT_TRUE(fs::is_directory(file));
  EXPECT_EQ(files().size(), 1U);
}

TEST(LightHash, isAnotherWhenAnyPartOfALightIs) {
  const LoadedLevel loaded = room();
  const Level& level = loaded.level;
  const std::vector<std::function<void(LightSource&)>> changes = {
      [](LightSource& light) { light.position.x += 0.25; },
      [](LightSource& light) { light.position.y += 0.25; },
      [](LightSource& light) { light.position.z += 0.25; },
      [](LightSource& light) { light.intensity = 100; },
      [](LightSource& light) { light.falloff = 1; },
      [](LightSource& light) {
        light.curve = {{0, 100}};
      },
      [](LightSource& light) {
        light.curve = {{0, 100}, {1, 50}};
      },
      [](LightSource& light) { light.color[0] = 1; },
      [](LightSource& light) { light.color[2] = 1; },
      [](LightSource& light) { light.radius = 0.5; },
  };
  std::vector<std::uint64_t> hashes = {lightHash(loaded.scene(), level.bake)};
  for (const auto& change : changes)
    for (std::size_t i = 0; i < level.lights.size(); ++i) {
      Level changed = level;
      change(changed.lights[i]);
      hashes.push_back(lightHash({changed, loaded.geometry}, level.bake));
    }
  Level fewer = level;
  fewer.lights.pop_back();
  hashes.push_back(lightHash({fewer, loaded.geometry}, level.bake));
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

TEST(LightHash, isAnotherWithEverySettingAndWithTheGeometry) {
  const LoadedLevel loaded = room();
  const Scene scene = loaded.scene();
  std::vector<std::uint64_t> hashes = {
      lightHash(room("[{'x':2,'y':1,'z':1}, {'x':3,'y':2,'z':1,'radius':0.2}]", 3.25).scene(), {})};
  for (const BakeSettings& settings :
       {BakeSettings{}, BakeSettings{.texel = 0.25}, BakeSettings{.samples = 4},
        BakeSettings{.samples = std::nullopt}, BakeSettings{.softSamples = 64},
        BakeSettings{.cutOff = 1}, BakeSettings{.lambert = true},
        BakeSettings{.solidMaskedMiddles = true}, BakeSettings{.bounces = 1}})
    hashes.push_back(lightHash(scene, settings));
  std::ranges::sort(hashes);
  EXPECT_EQ(std::ranges::adjacent_find(hashes), hashes.end());
}

TEST(LightHash, isAnotherWithTheGatherErrorWhereLightIsGathered) {
  const LoadedLevel loaded = room();
  const auto hashOf = [&](int bounces, double gatherError) {
    return lightHash(loaded.scene(), {.bounces = bounces, .gatherError = gatherError});
  };
  EXPECT_EQ(hashOf(0, 2), hashOf(0, 1));
  EXPECT_NE(hashOf(1, 2), hashOf(1, 1));
}

TEST(LightHash, staysWithNamesTexturesShotsAndSectorLight) {
  const LoadedLevel loaded = room();
  const Level& level = loaded.level;
  Level changed = level;
  changed.name = "another";
  changed.textures.front() = "#123456";
  changed.shots.push_back({.name = "new", .sector = SectorId(0), .eye = {1, 1, 1}});
  changed.sectors[0].light = 0.25;
  EXPECT_EQ(lightHash({changed, loaded.geometry}, level.bake),
            lightHash(loaded.scene(), level.bake));
}

}  // namespace
}  // namespace hearth
