// Saved bakes: what is written is read again, and nothing else is.

#include "light/saved_bake.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <zlib.h>

#include <filesystem>
#include <functional>

#include "random_levels/random_level.h"
#include "render/renderer.h"
#include "support/baked_room.h"
#include "support/level_text.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::sectorText;

constexpr std::string_view kSettings = "--samples 4";
// Where the fields lie: the table of saved_bake.md.
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kSettingsBytesAt = 12;
constexpr std::size_t kGeometryAt = 24;
constexpr std::size_t kTexelAt = 32;
constexpr std::size_t kLightmapsAt = 40;
constexpr std::size_t kFirstMapAt = 44 + kSettings.size();
constexpr std::ptrdiff_t kMapHeader = 6;  // bytes: numbers below 128 take one each

void expectSameLight(const BakedLight& a, const BakedLight& b) {
  ASSERT_EQ(a.lightmaps.size(), b.lightmaps.size());
  for (std::size_t i = 0; i < a.lightmaps.size(); ++i) {
    ASSERT_EQ(a.lightmaps[i].has_value(), b.lightmaps[i].has_value()) << i;
    if (!a.lightmaps[i]) continue;
    EXPECT_EQ(a.lightmaps[i]->rect, b.lightmaps[i]->rect);
    EXPECT_EQ(a.lightmaps[i]->channels, b.lightmaps[i]->channels);
    EXPECT_EQ(a.lightmaps[i]->levels, b.lightmaps[i]->levels);
    EXPECT_EQ(a.lightmaps[i]->fractions, b.lightmaps[i]->fractions);
  }
}

struct SavedSize {
  std::int64_t file = 0;   ///< bytes
  std::int64_t light = 0;  ///< lit texels, times their channels
  double perLevel() const { return static_cast<double>(file) / static_cast<double>(light); }
};

/// Bakes, saves, reads and draws.
SavedSize expectRoundTrip(const LoadedLevel& loaded, int bits = 8) {
  const Level& level = loaded.level;
  BakeSettings settings = level.bake;
  settings.bits = bits;
  const BakedLight light = bake(level, settings, 2);
  const std::string bytes = encodeBake(level, light, level.bake.texel, kSettings);
  const auto read = decodeBake(level, bytes);
  EXPECT_TRUE(read) << read.error();
  if (!read) return {};
  expectSameLight(light, *read);
  EXPECT_EQ(light.stats.litSurfaces, read->stats.litSurfaces);
  EXPECT_EQ(light.stats.bytes, read->stats.bytes);
  const Renderer baked(level, loaded.textures, light);
  const Renderer again(level, loaded.textures, *read);
  for (const Shot& shot : level.shots)
    EXPECT_EQ(baked.draw(cameraOf(shot), LightMode::Both),
              again.draw(cameraOf(shot), LightMode::Both))
        << shot.name;
  return {std::ssize(bytes), statsOf(test::withAllTexels(light)).bytes};
}

TEST(SavedBake, ofTheTutorialDrawsTheSamePictures) {
  const LoadResult result = loadLevel(HEARTH_SOURCE_DIR "/levels/tutorial.json");
  ASSERT_TRUE(result.loaded);
  EXPECT_LE(expectRoundTrip(*result.loaded).perLevel(), 1.5);
  EXPECT_LE(expectRoundTrip(*result.loaded, 16).perLevel(), 1.5);
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
  EXPECT_LE(saved.perLevel(), 1.5);
}

/// A room open to its sky, lit red and white from its middle; all of its light is in `bytes`.
class SavedRoom : public testing::Test {
 protected:
  static std::string roomText(std::string_view eastEnd) {
    return fmt::format("{{'light': 0, 'sectors': {{{}}}}}",
                       sectorText("room", fmt::format("0,0, {0},0, {0},2, 0,2", eastEnd), 0, 2,
                                  "{'texture': '#808080'}"));
  }
  static BakedRoom roomOf(std::string_view eastEnd) {
    return {
        roomText(eastEnd),
        "{'lights': [{'x':1,'y':1,'z':0,'color':'#ff8000'},{'x':1,'y':1,'z':0.5,'intensity':9}],"
        " 'bake': {'texel': 1}}"};
  }

  std::string saved() const { return encodeBake(room_.level(), room_.light(), 1, kSettings); }

  /// What is wrong with the bytes after a change, behind a checksum that is right.
  std::string mistakeAfter(const std::function<void(std::string&)>& change) const {
    std::string bytes = saved();
    change(bytes);
    return mistakeIn(sealed(std::move(bytes)));
  }

  std::string mistakeIn(std::string_view bytes) const {
    const auto read = decodeBake(room_.level(), bytes);
    return read ? "" : read.error();
  }

  static void put(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t size = 4) {
    for (std::size_t i = 0; i < size; ++i) bytes[at + i] = static_cast<char>(number >> (8 * i));
  }

  /// The length and the checksum as they must be.
  static std::string sealed(std::string bytes) {
    put(bytes, 16, bytes.size(), 8);
    const std::size_t end = bytes.size() - 4;
    put(bytes, end, crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), end));
    return bytes;
  }

  const BakedRoom room_ = roomOf("2");
};

TEST_F(SavedRoom, isReadWithOneChannelAndWithThree) {
  const auto read = decodeBake(room_.level(), saved());
  ASSERT_TRUE(read) << read.error();
  expectSameLight(room_.light(), *read);
  EXPECT_EQ(read->stats.litSurfaces, 6U);
  EXPECT_EQ(read->stats.coloredSurfaces, 5U) << "all but the floor, in which the red lamp lies";
}

TEST_F(SavedRoom, isReadWithItsLightmapsInAnyOrderAndAnyOfThemMissing) {
  BakedLight light = room_.light();
  light.lightmaps[0].reset();
  const auto read = decodeBake(room_.level(), encodeBake(room_.level(), light, 1, ""));
  ASSERT_TRUE(read) << read.error();
  expectSameLight(light, *read);

  // The floor's, of one channel, behind that of the ceiling, of three.
  std::string bytes = saved();
  const auto first = bytes.begin() + kFirstMapAt;
  const std::ptrdiff_t texels =
      room_.light().surfaces[0]->texels.width * room_.light().surfaces[0]->texels.height;
  std::rotate(first, first + kMapHeader + texels, first + 2 * kMapHeader + 4 * texels);
  const auto turned = decodeBake(room_.level(), sealed(bytes));
  ASSERT_TRUE(turned) << turned.error();
  expectSameLight(room_.light(), *turned);
}

TEST_F(SavedRoom, isRefusedByALevelOfOtherGeometry) {
  // A tenth of a millimetre moves no texel and is another room all the same.
  const BakedRoom moved = roomOf("1.9999");
  ASSERT_EQ(moved.light().surfaces[0]->texels, room_.light().surfaces[0]->texels);
  const auto read = decodeBake(moved.level(), saved());
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(),
            "was baked for other geometry than the level has now, with the settings "
            "\"--samples 4\"");
}

TEST_F(SavedRoom, isTakenByALevelOfOtherLightAndTextures) {
  std::string text = roomText("2");
  for (std::size_t at = 0; (at = text.find("#808080", at)) != std::string::npos;)
    text.replace(at, 7, "#123456");
  const LoadedLevel other = test::levelFrom(text, "[{'x':0.5,'y':1,'z':1}]");
  const auto read = decodeBake(other.level, saved());
  ASSERT_TRUE(read) << read.error();
  expectSameLight(room_.light(), *read);
}

TEST_F(SavedRoom, tellsWhatIsNoneOrOfAnotherVersion) {
  EXPECT_EQ(mistakeIn("\x89PNG\r\n\x1a\n and more"), "is no saved bake");
  EXPECT_EQ(mistakeIn("{}"), "is no saved bake");
  EXPECT_EQ(mistakeIn(""), "is cut short: 0 of 48 bytes are there");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { put(bytes, kVersionAt, 3); }),
            "is a saved bake of version 3, and only versions 1 and 2 can be read");
  EXPECT_EQ(mistakeIn(std::string("\x89HEARTH\n\x03\0\0\0", 12)),
            "is a saved bake of version 3, and only versions 1 and 2 can be read");
}

TEST_F(SavedRoom, isRefusedWithOneByteMoreOrAnyNumberLess) {
  const std::string bytes = saved();
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_TRUE(mistakeIn(std::string_view(bytes).substr(0, size)).starts_with("is cut short: "))
        << size;
  EXPECT_EQ(mistakeIn(bytes + '\0'), "goes on for 1 bytes after its end");
}

TEST_F(SavedRoom, isRefusedWithAnyByteAltered) {
  const std::string bytes = saved();
  for (std::size_t i = 0; i < bytes.size(); ++i)
    for (const int change : {0x01, 0x80, 0xff}) {
      std::string altered = bytes;
      altered[i] = static_cast<char>(altered[i] ^ change);
      EXPECT_NE(mistakeIn(altered), "") << i;
    }
  std::string texel = bytes;
  texel[kFirstMapAt + kMapHeader] ^= 1;
  EXPECT_EQ(mistakeIn(texel), "was altered: its checksum is not that of its bytes");
}

TEST(SavedBake, hasAllTexelsOfEvenLight) {
  const BakedRoom room(
      "{'light':0,'sectors':{" + sectorText("room", "0,0, 6,0, 6,4, 0,4", 0, 3) + "}}",
      "[{'x':2,'y':2,'z':1,'intensity':77}]");
  const BakedLight& light = room.light();
  EXPECT_EQ(light.stats.bytes, std::ssize(light.lightmaps)) << "one texel a surface";
  const auto encoded = [&](const BakedLight& baked) {
    return encodeBake(room.level(), baked, room.level().bake.texel, kSettings);
  };
  EXPECT_EQ(encoded(light), encoded(test::withAllTexels(light)));
  const auto read = decodeBake(room.level(), encoded(light));
  ASSERT_TRUE(read) << read.error();
  expectSameLight(light, *read);
}

TEST_F(SavedRoom, isRefusedOrReadWholeBehindARightChecksum) {
  // What another program may have got wrong: no byte of it can do harm.
  const std::string bytes = saved();
  for (std::size_t i = 0; i < bytes.size() - 4; ++i)
    for (int value = 0; value < 256; ++value) {
      std::string altered = bytes;
      altered[i] = static_cast<char>(value);
      const auto read = decodeBake(room_.level(), sealed(std::move(altered)));
      if (!read) continue;
      for (const auto& map : read->lightmaps)
        if (map) {
          const std::int64_t texels = map->isEven() ? 1 : map->rect.count();
          EXPECT_EQ(std::ssize(map->levels), texels * map->channels);
        }
    }
}

TEST_F(SavedRoom, tellsWhatIsWrongInItsHeader) {
  const auto withTexel = [this](double texel) {
    return mistakeAfter([texel](std::string& bytes) {
      put(bytes, kTexelAt, std::bit_cast<std::uint64_t>(texel), 8);
    });
  };
  EXPECT_EQ(withTexel(0), "has texels that cannot be: 0 m is no size");
  EXPECT_EQ(withTexel(-1), "has texels that cannot be: -1 m is no size");
  EXPECT_EQ(withTexel(NAN), "has texels that cannot be: nan m is no size");
  EXPECT_EQ(withTexel(INFINITY), "has texels that cannot be: inf m is no size");
  EXPECT_TRUE(withTexel(1e-9).starts_with("has texels that cannot be: a level that reaches "));
  EXPECT_TRUE(withTexel(0.5).starts_with("was baked for other geometry"));
  EXPECT_TRUE(mistakeAfter([](std::string& bytes) {
                put(bytes, kGeometryAt, 0);
              }).starts_with("was baked for other geometry"));
  EXPECT_EQ(mistakeAfter([](std::string& bytes) {
              bytes.insert(kFirstMapAt, 1000, ' ');
              put(bytes, kSettingsBytesAt, 1001);
            }),
            "has settings of 1001 bytes, where at most 1000 can be");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) {
              bytes.resize(kFirstMapAt + 4);
              put(bytes, kSettingsBytesAt, kSettings.size() + 1);
            }),
            "has settings of 12 bytes, where at most 11 can be");
}

TEST_F(SavedRoom, tellsWhatIsWrongInALightmap) {
  const auto withField = [this](int field, const std::string& number) {
    return mistakeAfter([&](std::string& bytes) {
      bytes.replace(kFirstMapAt + static_cast<std::size_t>(field), 1, number);
    });
  };
  const std::string most = "\xff\xff\xff\xff\x0f";  // 2^32 - 1
  EXPECT_EQ(withField(0, "\x06"), "has a lightmap for surface 6, of a level with 6");
  EXPECT_EQ(withField(0, most), "has a lightmap for surface 4294967295, of a level with 6");
  EXPECT_EQ(withField(0, "\x01"), "has a lightmap for surface 1 (ceiling) that has one already");
  const std::string rect =
      "has a lightmap for surface 0 (floor) with texels {} instead of "
      "(-1, -1) 4 x 4";
  EXPECT_EQ(withField(1, "\x04"), fmt::format(fmt::runtime(rect), "(2, -1) 4 x 4"));
  EXPECT_EQ(withField(2, "\x03"), fmt::format(fmt::runtime(rect), "(-1, -2) 4 x 4"));
  EXPECT_EQ(withField(3, most), fmt::format(fmt::runtime(rect), "(-1, -1) -1 x 4"));
  EXPECT_EQ(withField(4, "\x80\x80\x80\x80\x04"),
            fmt::format(fmt::runtime(rect), "(-1, -1) 4 x 1073741824"));
  const std::string channels =
      "has a lightmap for surface 0 (floor) with {} channels instead of 1 or 3";
  EXPECT_EQ(withField(5, std::string(1, '\0')), fmt::format(fmt::runtime(channels), 0));
  EXPECT_EQ(withField(5, "\x02"), fmt::format(fmt::runtime(channels), 2));
  EXPECT_EQ(withField(5, most), fmt::format(fmt::runtime(channels), 4294967295));
  const std::string noNumber = "has a lightmap that does not begin with six numbers";
  EXPECT_EQ(withField(0, "\xff\xff\xff\xff\x1f"), noNumber) << "of 33 bits";
  EXPECT_EQ(withField(0, "\x80\x80\x80\x80\x80\x01"), noNumber) << "of six bytes";
  EXPECT_EQ(mistakeAfter([](std::string& bytes) {
              bytes.resize(kFirstMapAt + 4 + 3);  // and the checksum
            }),
            noNumber);
}

TEST_F(SavedRoom, tellsWhichLightmapsDoNotFillIt) {
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { put(bytes, kLightmapsAt, 7); }),
            "has only 6 of the 7 lightmaps that it counts");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { put(bytes, kLightmapsAt, 0xffffffff); }),
            "has only 6 of the 4294967295 lightmaps that it counts");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { bytes.insert(bytes.size() - 4, "abc"); }),
            "has 3 bytes after its lightmaps");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { bytes.erase(bytes.size() - 5, 1); }),
            "has a lightmap for surface 5 (solid wall) that is cut short");
}

TEST_F(SavedRoom, isRefusedWithALightmapOfTheSky) {
  const std::string sky =
      "{'light': 0, 'sectors': {'room': {'floor': {'texture': '#808080'}, 'ceiling': {'z': 2, "
      "'texture': '#808080', 'parallax': true}, 'loops': {'border': {'v': [0,0, 2,0, 2,2, 0,2], "
      "'walls': {'texture': '#808080'}}}}}}";
  const BakedRoom yard(sky, "[{'x':1,'y':1,'z':1}]");
  BakedLight light = yard.light();
  light.lightmaps[1] = light.lightmaps[0];
  const auto read = decodeBake(yard.level(), encodeBake(yard.level(), light, 0.125, ""));
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error(), "has a lightmap for surface 1 (sky ceiling) that never shows light");
}

}  // namespace
}  // namespace hearth
