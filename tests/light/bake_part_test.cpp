// Bakes in parts: together they are the whole bake to the byte, whoever baked them; what is no part
// of it is refused.

#include "light/bake_part.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "light/baking/texel_sums.h"
#include "light/byte_stream.h"
#include "light/parts/light_tile.h"
#include "light/parts/part_frame.h"
#include "light/parts/sums_as_bytes.h"
#include "light/saved_bake.h"
#include "load/load.h"
#include "support/in_tree.h"
#include "support/level_text.h"
#include "support/models.h"

namespace hearth {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view kSettingsText = "as in the test";

/// Two rooms with a crate, models of small faces, sprites, coloured lights, a ball and a grille.
LoadedLevel furnishedRooms() {
  return test::levelFrom(
      "{'light':0.1,'sectors':{" +
          test::sectorText("hall", "0,0, 6,0, 6,5, 3,4, 0,5", 0, 3,
                           "[{'texture':'#808080'},{'next':'room','texture':'#808080'},"
                           "{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'}]") +
          "," +
          test::sectorText("room", "6,0, 10,0, 11,5, 6,5", 0.3, 2.8,
                           "[{'texture':'#808080'},{'texture':'#808080'},{'texture':'#808080'},"
                           "{'next':'hall','texture':'#808080'}]") +
          "},'things':[{'name':'crate','mesh':'box.obj','x':2,'y':2,'z':0,'angle':30},"
          "{'name':'dice','mesh':'box.obj','scale':0.1,'x':4,'y':1,'z':0},"
          "{'name':'board','sprite':'#c04040','size':[0.5,1],'x':8,'y':2,'z':0.3}]}",
      "[{'x':1,'y':1,'z':2.5,'falloff':0.3,'color':'#ffc080'},{'x':9,'y':3,'z':2},"
      "{'x':5,'y':3,'z':2.2,'radius':0.2,'falloff':0.5}]",
      {{"box.obj", test::kBoxModel}});
}

/// With the instruction sets of the processor in turn.
class BakePart : public testing::Test {
 protected:
  ~BakePart() override { use(0); }

  static void use(std::int64_t set) {
    hwy::SetSupportedTargetsForTest(set);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }

  /// All parts, each baked with another instruction set and number of threads.
  static std::vector<std::string> partsOf(const BakeInParts& bake, std::uint32_t count) {
    const std::vector<std::int64_t> sets = hwy::SupportedAndGeneratedTargets();
    std::vector<std::string> parts;
    for (std::uint32_t part = 1; part <= count; ++part) {
      use(sets[part % sets.size()]);
      parts.push_back(bakePart(bake, {part, count}, 1 + static_cast<int>(part % 4)));
      EXPECT_EQ(partNumberOf(bake, parts.back()), (PartNumber{part, count}));
    }
    use(0);
    return parts;
  }

  static void expectWhole(const LoadedLevel& loaded, const BakeSettings& settings,
                          const std::vector<std::uint32_t>& counts) {
    const Scene scene = loaded.scene();
    const BakeInParts bake(scene, settings, std::string(kSettingsText));
    const std::string whole =
        encodeBake(scene, hearth::bake(scene, settings, 2), settings.texel, kSettingsText);
    for (const std::uint32_t count : counts) {
      const auto joined = joinParts(bake, partsOf(bake, count), 2);
      ASSERT_TRUE(joined) << count << ": part " << joined.error().part << ' '
                          << joined.error().what;
      EXPECT_EQ(encodeBake(scene, *joined, settings.texel, kSettingsText), whole) << count;
    }
  }
};

TEST_F(BakePart, areTheWholeBakeTogether) {
  const LoadedLevel rooms = furnishedRooms();
  for (const BakeSettings& settings :
       {BakeSettings{}, BakeSettings{.texel = 0.21, .samples = 4, .lambert = true},
        BakeSettings{.texel = 0.3, .samples = std::nullopt}, BakeSettings{.softSamples = 0},
        BakeSettings{.texel = 0.4, .cutOff = 8}})
    expectWhole(rooms, settings, {1, 2, 3, 7, 64});
  expectWhole(rooms, {.texel = 0.25}, {1000});
}

TEST_F(BakePart, areTheWholeBakeOfLevelsWithAllFeatures) {
  for (const char* name : {"gaol", "tutorial", "dark-spots"}) {
    const LoadedLevel loaded =
        loadLevel(test::inTree(fmt::format("levels/{}.json", name))).loaded.value();
    BakeSettings settings = loaded.level.bake;
    settings.texel = 0.4;
    expectWhole(loaded, settings, {2, 7});
  }
}

TEST_F(BakePart, doNotDependOnThreadsOrInstructionSets) {
  const LoadedLevel rooms = furnishedRooms();
  const BakeInParts bake(rooms.scene(), {}, "");
  const std::string expected = bakePart(bake, {2, 3}, 1);
  for (const std::int64_t set : hwy::SupportedAndGeneratedTargets())
    for (const int threads : {1, 3}) {
      use(set);
      EXPECT_EQ(bakePart(bake, {2, 3}, threads), expected) << hwy::TargetName(set) << threads;
    }
}

TEST_F(BakePart, tellTheirProgress) {
  const LoadedLevel rooms = furnishedRooms();
  const BakeInParts bake(rooms.scene(), {}, "");
  BakeProgress progress;
  (void)bakePart(bake, {1, 2}, 2, &progress);
  EXPECT_GT(progress.texels(), 1000);
  EXPECT_EQ(progress.texelsDone(), progress.texels());
}

/// The bytes with others at some place, and the checksum that belongs to them.
std::string altered(std::string bytes, std::size_t at, std::string_view with) {
  bytes.replace(at, with.size(), with);
  bytes.resize(bytes.size() - 4);
  put(bytes, checksum(bytes));
  return bytes;
}

class BakePartMistakes : public testing::Test {
 protected:
  std::string mistakeIn(std::string_view bytes) const {
    const auto number = partNumberOf(bake_, bytes);
    return number ? "" : number.error();
  }

  /// What the join says of the part, which has been accepted.
  std::string mistakeInSums(const std::string& bytes) const {
    EXPECT_EQ(mistakeIn(bytes), "");
    const auto joined = joinParts(bake_, {&bytes, 1}, 1);
    return joined ? "" : joined.error().what;
  }

  LoadedLevel rooms_ = furnishedRooms();
  BakeInParts bake_{rooms_.scene(), {.texel = 0.5}, "these settings"};
  std::string part_ = bakePart(bake_, {1, 1}, 1);
};

TEST_F(BakePartMistakes, refuseWhatIsCutShort) {
  EXPECT_EQ(mistakeIn(part_), "");
  for (std::size_t length = 0; length < part_.size(); length += 1 + length / 64)
    EXPECT_NE(mistakeIn(part_.substr(0, length)), "") << length;
  EXPECT_EQ(mistakeIn(part_.substr(0, 100)),
            fmt::format("is cut short: 100 of {} bytes are there", part_.size()));
  EXPECT_EQ(mistakeIn(part_ + "abc"), "goes on for 3 bytes after its end");
}

TEST_F(BakePartMistakes, refuseWhatWasAltered) {
  for (std::size_t at = 0; at < part_.size(); at += 1 + at / 64) {
    std::string bytes = part_;
    bytes[at] = static_cast<char>(bytes[at] ^ 4);
    EXPECT_NE(mistakeIn(bytes), "") << at;
  }
  EXPECT_EQ(mistakeIn(part_.substr(0, part_.size() - 1) + static_cast<char>(part_.back() ^ 1)),
            "was altered: its checksum is not that of its bytes");
  EXPECT_EQ(mistakeIn("a text, or whatever"), "is no part of a bake");
}

TEST_F(BakePartMistakes, refusePartsOfOtherBakes) {
  const auto partOf = [](const LoadedLevel& rooms, const BakeSettings& settings,
                         std::string_view text) {
    return bakePart({rooms.scene(), settings, std::string(text)}, {1, 2}, 1);
  };
  const BakeSettings settings{.texel = 0.5};
  EXPECT_EQ(mistakeIn(partOf(rooms_, settings, "these settings")), "");
  EXPECT_EQ(mistakeIn(partOf(rooms_, settings, "others")),
            "was baked with other settings: \"others\", not \"these settings\"");
  EXPECT_EQ(mistakeIn(partOf(rooms_, {.texel = 0.5, .lambert = true}, "these settings")),
            "was baked with other lights than the level has now");
  LoadedLevel dimmer = furnishedRooms();
  dimmer.level.lights[1].intensity = 100;
  EXPECT_EQ(mistakeIn(partOf(dimmer, settings, "these settings")),
            "was baked with other lights than the level has now");
  const LoadedLevel other =
      test::levelFrom("{'sectors':{" + test::sectorText("hall", "0,0, 6,0, 6,5, 0,5", 0, 3) + "}}");
  EXPECT_EQ(mistakeIn(partOf(other, settings, "these settings")),
            "was baked for other geometry than the level has now");
}

TEST_F(BakePartMistakes, refuseOtherVersions) {
  EXPECT_EQ(mistakeIn(altered(part_, 8, std::string_view("\1\0\0\0", 4))),
            "is a part of a bake of version 1, and only version 2 can be read");
  EXPECT_EQ(mistakeIn(altered(part_, 12, "\x4d\xcf\x13\0"sv)).substr(0, 46),
            "was baked by version 1.298.253 of the program,");
}

TEST_F(BakePartMistakes, refuseHeadersThatNoPartHas) {
  const std::string mistake = "has a header that no part has";
  const auto number = [](std::uint32_t part, std::uint32_t parts) {
    std::string bytes;
    put(bytes, part);
    put(bytes, parts);
    return bytes;
  };
  EXPECT_EQ(mistakeIn(altered(part_, 28, number(0, 1))), mistake);
  EXPECT_EQ(mistakeIn(altered(part_, 28, number(2, 1))), mistake);
  EXPECT_EQ(mistakeIn(altered(part_, 28, number(1, kMaxParts + 1))), mistake);
  EXPECT_EQ(mistakeIn(altered(part_, 24, "\xff\xff\xff\xff")), mistake);
}

TEST_F(BakePartMistakes, refuseSumsThatCannotBe) {
  const std::size_t first =
      part_.find("these settings") + std::string_view("these settings").size();
  EXPECT_EQ(mistakeInSums(part_), "");
  // Channels, then the place and size of what is lit.
  ASSERT_EQ(part_[first], 3);
  for (const std::string_view sums :
       {"\2"sv, "\4"sv, "\3\x7f"sv, "\3\0\0\0\0"sv, "\3\0\0\x7f\x7f"sv})
    EXPECT_EQ(mistakeInSums(altered(part_, first, sums)).substr(0, 23), "has no sums for tile 1 ")
        << sums.size();
  // Sums of less than nothing, and of more than there can be.
  for (const std::string_view sum : {"\1"sv, "\xff\xff\xff\xff\xff\xff\xff\xff\xff\1"sv})
    EXPECT_NE(mistakeInSums(altered(part_, first + 5, sum)), "") << sum.size();
}

/// An L, of which the second row of tiles begins with texels that no pixel reads.
TEST_F(BakePart, keepsLightInPlaceWhereTilesBeginWithUnusedTexels) {
  const LoadedLevel loaded = test::levelFrom(
      "{'light':0,'sectors':{" + test::sectorText("l", "0,0, 9,0, 9,9, 3,9, 3,5, 0,5", 0, 3) + "}}",
      "[{'x':5,'y':4,'z':2,'falloff':0.4}]");
  BakeSettings settings = loaded.level.bake;
  settings.texel = 0.1;
  const BakedLight whole = bake(loaded.scene(), settings, 1);
  const BakeInParts inParts(loaded.scene(), settings, "");
  const std::string part = bakePart(inParts, {1, 1}, 1);
  const auto joined = joinParts(inParts, {&part, 1}, 1);
  ASSERT_TRUE(joined);
  for (std::size_t i = 0; i < whole.lightmaps.size(); ++i) {
    ASSERT_EQ(joined->lightmaps[i].has_value(), whole.lightmaps[i].has_value()) << i;
    if (whole.lightmaps[i]) {
      EXPECT_EQ(joined->lightmaps[i]->levels, whole.lightmaps[i]->levels) << i;
    }
  }
}

TEST_F(BakePartMistakes, refuseTilesOfOneSurfaceWithOtherChannels) {
  const BakeSettings settings{.texel = 0.05};
  const BakeInParts bake(rooms_.scene(), settings, "");
  const LevelInTiles level(rooms_.scene(), settings, 1);
  const auto second = std::ranges::adjacent_find(
      level.tiles, [](const LightTile& a, const LightTile& b) { return a.map == b.map; });
  ASSERT_NE(second, level.tiles.end()) << "a surface of several tiles";
  for (const auto& [firstChannels, otherChannels] : {std::pair{1, 3}, std::pair{3, 1}}) {
    std::string sums;
    for (const LightTile& tile : level.tiles) {
      TexelSums lit(tile.texels,
                    tile.map == second->map && &tile != &*second ? otherChannels : firstChannels);
      for (double& unit : lit.units()) unit = 5 << 20;
      putSums(sums, lit, tile.texels);
    }
    const std::string part = framed(bake, {1, 1}, {&sums, 1});
    EXPECT_EQ(partNumberOf(bake, part), (PartNumber{1, 1}));
    const auto joined = joinParts(bake, {&part, 1}, 1);
    ASSERT_FALSE(joined);
    EXPECT_EQ(joined.error().part, 0U);
    EXPECT_EQ(joined.error().what, "has white and coloured sums of one surface");
  }
}

}  // namespace
}  // namespace hearth
