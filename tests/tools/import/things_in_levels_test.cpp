// What a player sees of imported things, once their level is loaded.

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>

#include "import/doom/import_map.h"
#include "level/sprite.h"
#include "load/load.h"
#include "map_builder.h"
#include "map_lumps.h"
#include "pictures_builder.h"

namespace hearth::doom {
namespace {

namespace fs = std::filesystem;

class ImportedThings : public testing::Test, protected MapBuilder {
 protected:
  ImportedThings() {
    wad_.add("PLAYPAL", palette()).add("S_START");
    for (const char* frame : {"TROOA", "TROOB"}) {
      for (const char* side : {"1", "2A8", "3A7", "4A6", "5"}) {
        std::string lump = std::string(frame) + side;
        if (lump.size() == 8) lump[6] = frame[4];
        wad_.add(lump, plainPatch(40, 56, 5, {20, 56}));
      }
    }
    wad_.add("CANDA0", plainPatch(16, 16, 1, {8, 16})).add("GOR2A0", plainPatch(8, 8, 1, {4, 8}));
    wad_.add("S_END");
    settings_.folder = folder_;
    settings_.things.hasMonsters = true;
    fs::remove_all(folder_);
  }
  ~ImportedThings() override { fs::remove_all(folder_); }

  const Level& level() {
    addMap(wad_, map);
    const Wad wad = opened(wad_);
    const auto imported = importMap({wad, *Pictures::read(wad), *parseLightTable(ownLightTable())},
                                    "MAP01", settings_);
    EXPECT_TRUE(imported) << imported.error();
    loaded_ = loadLevel(imported->level).loaded;
    EXPECT_TRUE(loaded_);
    return loaded_->level;
  }

  /// The file of the image that a place of the map sees of the first sprite.
  static std::string seenFrom(const Level& level, int x, int y) {
    return level.textures[viewOf(level.sprites.at(0), placeOf(x, y), 0).texture.index()];
  }

  WadBuilder wad_;
  ImportSettings settings_;
  fs::path folder_ = fs::path(testing::TempDir()) / fmt::format("hearth-things-{}", ::getpid());
  std::optional<LoadedLevel> loaded_;
};

/// Doom's rotations go round to the left: from the front over the thing's left side to its back.
TEST_F(ImportedThings, showTheSideOnWhichOneStands) {
  walls(sector(), square(0, 0, 256));
  map.things.push_back({128, 128, 90, 3001, 7});  // to the north
  const Level& made = level();
  EXPECT_EQ(seenFrom(made, 128, 200), "sprite-trooa1") << "before it";
  EXPECT_EQ(seenFrom(made, 60, 128), "sprite-trooa3") << "west of it, which is to its left";
  EXPECT_EQ(seenFrom(made, 128, 60), "sprite-trooa5") << "behind it";
  EXPECT_EQ(seenFrom(made, 200, 128), "sprite-trooa7") << "to its right";
  EXPECT_EQ(seenFrom(made, 200, 200), "sprite-trooa8");
}

TEST_F(ImportedThings, loadInSectorsWithoutAir) {
  walls(sector(64, 64), square(0, 0, 256));
  for (const std::uint16_t type : std::initializer_list<std::uint16_t>{3001, 34, 59})
    map.things.push_back({128, 128, 0, type, 7});
  EXPECT_EQ(level().sprites.size(), 3U);
}

TEST_F(ImportedThings, standInTheSectorOfTheMapOnTheBorderOfSeveral) {
  const auto low = sector(0);
  const auto high = sector(64);
  line({128, 0}, {0, 0}, low);
  line({0, 0}, {0, 128}, low);
  line({0, 128}, {128, 128}, low);
  line({128, 128}, {256, 128}, high);
  line({256, 128}, {256, 0}, high);
  line({256, 0}, {128, 0}, high);
  line({128, 128}, {128, 0}, low, high);
  map.things.push_back({128, 64, 0, 34, 7});
  map.things.push_back({127, 64, 0, 34, 7});
  map.things.push_back({129, 64, 0, 34, 7});
  const Level& made = level();
  ASSERT_EQ(made.sprites.size(), 3U);
  EXPECT_EQ(made.sprites[1].position.z, 0);
  EXPECT_EQ(made.sprites[2].position.z, 2);
}

}  // namespace
}  // namespace hearth::doom
