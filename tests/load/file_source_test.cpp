// Levels need no disk: a program gives their files.

#include "files/file_source.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "load_text.h"
#include "support/in_tree.h"
#include "support/memory_files.h"

namespace hearth {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMaxBytes = 1 << 24;

class LevelInMemory : public testing::Test {
 protected:
  LevelInMemory() {
    for (const fs::path& file : onDisk_.files) {
      const fs::path folder = file.extension() == ".json" ? "levels" : "textures";
      memory_.add(folder / file.filename(), *DiskFiles().read(file, kMaxBytes));
    }
  }

  LoadResult load() const { return loadLevel("levels/tutorial.json", {}, memory_); }

  LoadedLevel onDisk_ = *loadLevel(test::inTree("levels/tutorial.json")).loaded;
  test::MemoryFiles memory_;
};

TEST_F(LevelInMemory, isTheLevelOnTheDisk) {
  const LoadResult result = load();
  ASSERT_TRUE(result.loaded) << listed(result);
  const LoadedLevel& loaded = *result.loaded;
  EXPECT_EQ(loaded.level.sectors.size(), onDisk_.level.sectors.size());
  EXPECT_EQ(loaded.level.lights.size(), onDisk_.level.lights.size());
  EXPECT_GT(loaded.level.lights.size(), 0U);
  EXPECT_EQ(loaded.lights, "levels/tutorial.lights.json");
  EXPECT_EQ(loaded.files.size(), onDisk_.files.size());
  ASSERT_EQ(loaded.textures.size(), onDisk_.textures.size());
  for (std::size_t i = 0; i < loaded.textures.size(); ++i)
    EXPECT_EQ(loaded.textures[i], onDisk_.textures[i]) << i;
}

TEST_F(LevelInMemory, isRefusedWhereAnImageIsMissing) {
  const fs::path image = *std::ranges::find_if(
      onDisk_.files, [](const fs::path& file) { return file.extension() == ".png"; });
  memory_.remove("textures" / image.filename());
  const LoadResult result = load();
  EXPECT_FALSE(result.loaded);
  EXPECT_NE(listed(result).find("there is no image \"" + image.stem().string() + "\""),
            std::string::npos)
      << listed(result);
}

TEST_F(LevelInMemory, isRefusedWhereAnImageIsCutShort) {
  const fs::path image = *std::ranges::find_if(
      onDisk_.files, [](const fs::path& file) { return file.extension() == ".png"; });
  std::string& bytes = memory_.at("textures" / image.filename());
  bytes.resize(bytes.size() / 2);
  const LoadResult result = load();
  EXPECT_FALSE(result.loaded);
  EXPECT_NE(listed(result).find("is damaged, cut short"), std::string::npos) << listed(result);
}

TEST_F(LevelInMemory, isSuggestedWhereItsExtensionIsLeftOut) {
  const LoadResult result = loadLevel("levels/tutorial", {}, memory_);
  EXPECT_NE(listed(result).find("did you mean levels/tutorial.json?"), std::string::npos)
      << listed(result);
}

TEST(DiskFiles, TellFoldersAndPipesFromFiles) {
  const DiskFiles disk;
  EXPECT_EQ(disk.kindOf(test::inTree("levels/tutorial.json")), FileKind::Regular);
  EXPECT_EQ(disk.kindOf(test::inTree("levels")), FileKind::Folder);
  EXPECT_EQ(disk.kindOf(test::inTree("levels/none.json")), FileKind::None);
  EXPECT_EQ(disk.kindOf("/dev/null"), FileKind::Other);
  EXPECT_EQ(disk.open("/dev/null").error().code, ReadErrorCode::NotRegular);
  EXPECT_EQ(disk.open(test::inTree("levels/none.json")).error().code, ReadErrorCode::Missing);
  EXPECT_TRUE(disk.namesIn(test::inTree("levels/none")).empty());
}

}  // namespace
}  // namespace hearth
