// The pictures of Freedoom, a game for Doom's engine that is free.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "import/doom/findings.h"
#include "import/doom/materials.h"
#include "import/doom/pictures.h"
#include "import/doom/sprites.h"
#include "import/doom/thing_types.h"

namespace hearth::doom {
namespace {

class Freedoom : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    const std::filesystem::path path = std::filesystem::path("/usr/share/games/doom") / GetParam();
    ASSERT_TRUE(std::filesystem::exists(path))
        << path << " is missing: tools/setup test installs the package freedoom";
    auto wad = Wad::open(path, 1 << 26);
    ASSERT_TRUE(wad) << wad.error();
    wad_.emplace(std::move(*wad));
    auto pictures = Pictures::read(*wad_);
    ASSERT_TRUE(pictures) << pictures.error();
    pictures_.emplace(std::move(*pictures));
  }

  const Pictures& pictures() const { return *pictures_; }

 private:
  std::optional<Wad> wad_;
  std::optional<Pictures> pictures_;
};

bool hasSeveralColors(const Image& image) {
  return std::ranges::any_of(image.pixels(), [&](Rgb c) { return c != image.at(0, 0); });
}

std::array<int, 3> channelSums(const Image& image) {
  std::array<int, 3> sums{};
  for (const Rgb color : image.pixels()) {
    sums[0] += color.r;
    sums[1] += color.g;
    sums[2] += color.b;
  }
  return sums;
}

TEST_P(Freedoom, hasWallTexturesThatAllCanBeDrawn) {
  EXPECT_GT(pictures().walls().size(), 900U);
  for (const auto& [name, definition] : pictures().walls()) {
    const auto wall = pictures().wall(name);
    ASSERT_TRUE(wall) << wall.error();
    EXPECT_TRUE(wall->mistakes.empty()) << wall->mistakes.front();
    EXPECT_NE(std::ranges::find(wall->isOpaque, true), wall->isOpaque.end()) << name;
  }
}

TEST_P(Freedoom, hasFlatsThatAllCanBeDrawn) {
  EXPECT_GT(pictures().flats().size(), 200U);
  for (const auto& [name, bytes] : pictures().flats()) {
    const auto flat = pictures().flat(name);
    ASSERT_TRUE(flat) << flat.error();
    EXPECT_FALSE(flat->hasHoles()) << name;
  }
}

// The sizes are Doom's own: maps are made for them.
TEST_P(Freedoom, hasTexturesOfTheSizesThatMapsExpect) {
  EXPECT_EQ(pictures().sizeOfWall("STARTAN3"), (ImageSize{128, 128}));
  EXPECT_EQ(pictures().sizeOfWall("DOOR3"), (ImageSize{64, 72}));
  EXPECT_EQ(pictures().sizeOfWall("EXITSIGN"), (ImageSize{64, 16}));
  EXPECT_EQ(pictures().sizeOfWall("SKY1"), (ImageSize{256, 128}));
  EXPECT_EQ(pictures().sizeOfWall("MIDGRATE"), (ImageSize{128, 128}));
}

TEST_P(Freedoom, hasHolesInGratesAndNoneInDoors) {
  EXPECT_TRUE(pictures().wall("MIDGRATE")->hasHoles());
  EXPECT_FALSE(pictures().wall("BIGDOOR2")->hasHoles());
  EXPECT_FALSE(pictures().wall("STARTAN3")->hasHoles());
  EXPECT_TRUE(hasSeveralColors(pictures().wall("STARTAN3")->image));
}

// Nukage is green, lava and blood are red.
TEST_P(Freedoom, hasTheColorsThatNamesPromise) {
  const auto nukage = pictures().flat("NUKAGE1");
  ASSERT_TRUE(nukage) << nukage.error();
  const auto [red, green, blue] = channelSums(nukage->image);
  EXPECT_GT(green, red);
  EXPECT_GT(green, blue);
  for (const char* name : {"LAVA1", "BLOOD1"}) {
    const auto flat = pictures().flat(name);
    ASSERT_TRUE(flat) << flat.error();
    const auto sums = channelSums(flat->image);
    EXPECT_GT(sums[0], 2 * sums[1]) << name;
    EXPECT_GT(sums[0], 2 * sums[2]) << name;
  }
}

// Phase 1 lacks things of Doom II.
TEST_P(Freedoom, hasSpritesOfAllThings) {
  Findings findings;
  Materials materials(pictures(), "MAP01", findings);
  Sprites sprites(pictures(), materials, findings);
  int missing = 0;
  for (const ThingType& type : thingTypes()) {
    if (*type.sprite == '\0') continue;
    const auto look = sprites.lookOf(type);
    missing += look ? 0 : 1;
    const bool hasSides = look && look->hasSides();
    EXPECT_TRUE(!look || hasSides == (type.isMonster && !type.hangs)) << type.name;
  }
  EXPECT_EQ(missing, std::string(GetParam()) == "freedoom2.wad" ? 0 : 23);
  EXPECT_TRUE(findings.empty());
}

std::string nameOf(const testing::TestParamInfo<const char*>& file) {
  return std::filesystem::path(file.param).stem();
}

INSTANTIATE_TEST_SUITE_P(Both, Freedoom, testing::Values("freedoom1.wad", "freedoom2.wad"), nameOf);

}  // namespace
}  // namespace hearth::doom
