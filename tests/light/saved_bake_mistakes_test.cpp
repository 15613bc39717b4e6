// Saved bakes that are not what they should be: each is refused, and tells why.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "light/geometry_hash.h"
#include "light/saved_bake.h"
#include "saved_room.h"

namespace hearth {
namespace {

using test::BakedRoom;
using test::kChecksumBytes;
using test::kGeometryAt;
using test::kLightmapBytesAt;
using test::kLightmapsAt;
using test::kMuchLight;
using test::kSettings;
using test::kSettingsBytesAt;
using test::kTexelAt;
using test::kVersionAt;
using test::packed;
using test::put;
using test::SavedRoom;
using test::sealed;

TEST_F(SavedRoom, tellsWhatIsNoneOrOfAnotherVersion) {
  EXPECT_EQ(mistakeIn("\x89PNG\r\n\x1a\n and more"), "is no saved bake");
  EXPECT_EQ(mistakeIn("{}"), "is no saved bake");
  EXPECT_EQ(mistakeIn(""), "is cut short: 0 of 56 bytes are there");
  for (const int version : {0, 1, 2, 3, 4})
    EXPECT_EQ(
        mistakeAfter([&](std::string& bytes) {
          put(bytes, kVersionAt, static_cast<std::uint64_t>(version));
        }),
        fmt::format("is a saved bake of version {}, and only version 5 can be read", version));
  EXPECT_EQ(mistakeIn(std::string("\x89HEARTH\n\x06\0\0\0", 12)),
            "is a saved bake of version 6, and only version 5 can be read");
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
  std::string light = bytes;
  light[kPackedAt + 5] ^= 1;
  EXPECT_EQ(mistakeIn(light), "was altered: its checksum is not that of its bytes");
}

/// That light has one texel a surface, or all of them.
void expectWhole(const BakedLight& light) {
  for (const auto& map : light.lightmaps) {
    if (!map) continue;
    const std::int64_t texels = map->isUniform() ? 1 : map->rect.count();
    EXPECT_EQ(std::ssize(map->levels), texels * map->channels);
  }
}

TEST_F(SavedRoom, isRefusedOrReadWholeBehindARightChecksum) {
  // What another program may have got wrong: no byte of it can do harm.
  const std::string bytes = saved();
  for (std::size_t i = 0; i < bytes.size() - kChecksumBytes; ++i)
    for (int value = 0; value < 256; ++value) {
      std::string altered = bytes;
      altered[i] = static_cast<char>(value);
      if (const auto read = decodeBake(room_.scene(), sealed(std::move(altered)), kMuchLight))
        expectWhole(*read);
    }
}

TEST_F(SavedRoom, isRefusedOrReadWholeWithAnyByteOfItsLightmapsAltered) {
  const std::string all = lightmaps();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const int value : {0, 1, 2, 3, 4, 5, 6, 7, 0x7f, 0x80, 0x81, 0xfe, 0xff}) {
      std::string altered = all;
      altered[i] = static_cast<char>(value);
      if (const auto read = decodeBake(room_.scene(), withLightmaps(altered), kMuchLight))
        expectWhole(*read);
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
              bytes.insert(kPackedAt, 1000, ' ');
              put(bytes, kSettingsBytesAt, 1001);
            }),
            "has settings of 1001 bytes, where at most 1000 can be");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) {
              bytes.resize(kPackedAt + kChecksumBytes);
              put(bytes, kSettingsBytesAt, kSettings.size() + 1);
            }),
            "has settings of 12 bytes, where at most 11 can be");
}

TEST_F(SavedRoom, isRefusedForAMistakeInAnyOfItsBakes) {
  const std::string one = saved();
  EXPECT_EQ(mistakeIn(one + one), "");
  EXPECT_EQ(mistakeIn(one + one.substr(0, 9)), "is cut short: 9 of 56 bytes are there");
  EXPECT_EQ(mistakeIn(one + one.substr(0, one.size() - 1)),
            fmt::format("is cut short: {} of {} bytes are there", one.size() - 1, one.size()));
  EXPECT_EQ(mistakeIn(one + "HEARTH"), "goes on for 6 bytes after its end");
  std::string other = one;
  put(other, kTexelAt, std::bit_cast<std::uint64_t>(2.0), 8);
  EXPECT_EQ(mistakeIn(one + sealed(other)), "has bakes with texels of several sizes");
  other = one;
  other[kPackedAt] ^= 1;
  EXPECT_EQ(mistakeIn(one + other), "was altered: its checksum is not that of its bytes");
}

TEST_F(SavedRoom, isRefusedWithMoreLightThanTheLevelHas) {
  const auto claiming = [](std::uint64_t bytes) {
    return [=](std::string& file) { put(file, kLightmapBytesAt, bytes, 8); };
  };
  // Of each of the six surfaces at most six numbers of five bytes and 4 x 4 texels in colour.
  EXPECT_EQ(mistakeAfter(claiming(6 * (6 * 5 + 3 * 16) + 1)),
            "has lightmaps of 469 bytes, where at most 468 can be");
  EXPECT_EQ(mistakeAfter(claiming(UINT64_MAX)),
            "has lightmaps of 18446744073709551615 bytes, where at most 468 can be");
}

TEST_F(SavedRoom, isRefusedUnreadWithMoreLightThanIsAllowed) {
  const std::uint64_t size = lightmaps().size();
  EXPECT_TRUE(decodeBake(room_.scene(), saved(), size));
  const auto refused = decodeBake(room_.scene(), saved(), size - 1);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what,
            fmt::format("has lightmaps of {} bytes, more than {}", size, size - 1));
  EXPECT_TRUE(refused.error().isTooLarge);

  // Gigabytes, which texels that small would have.
  std::string vast = saved();
  const double texel = 1e-4;
  put(vast, kTexelAt, std::bit_cast<std::uint64_t>(texel), 8);
  put(vast, kGeometryAt, geometryHash(room_.scene(), texel), 8);
  put(vast, kLightmapBytesAt, 5'000'000'000, 8);
  const auto bomb = decodeBake(room_.scene(), sealed(vast), kMuchLight);
  ASSERT_FALSE(bomb);
  EXPECT_EQ(bomb.error().what, "has lightmaps of 5000000000 bytes, more than 16777216");
  EXPECT_TRUE(bomb.error().isTooLarge);
}

TEST_F(SavedRoom, tellsWhatIsWrongWithItsPacking) {
  const std::string all = lightmaps();
  const std::string stream = packed(all);
  const auto mistakeOf = [this](std::string_view packed) { return mistakeIn(withPacked(packed)); };
  EXPECT_EQ(mistakeOf(stream), "");
  for (std::size_t size = 0; size < stream.size(); ++size)
    EXPECT_EQ(mistakeOf(std::string_view(stream).substr(0, size)),
              "has lightmaps that cannot be unpacked")
        << size;
  EXPECT_EQ(mistakeOf(all), "has lightmaps that cannot be unpacked") << "not packed";
  std::string last = stream;
  last.back() = static_cast<char>(last.back() ^ 1);
  EXPECT_EQ(mistakeOf(last), "has lightmaps that cannot be unpacked") << "of another Adler-32";
  EXPECT_EQ(mistakeOf(stream + "abc"), "has 3 bytes after its lightmaps");
  EXPECT_EQ(mistakeOf(stream + stream),
            fmt::format("has {} bytes after its lightmaps", stream.size()));
  const std::string more =
      fmt::format("has lightmaps of more than the {} bytes that it counts", all.size());
  EXPECT_EQ(mistakeOf(packed(all + 'x')), more);
  EXPECT_EQ(mistakeOf(packed(all + std::string(1'000'000, 'x'))), more);
  EXPECT_EQ(mistakeOf(packed(all.substr(1))),
            fmt::format("has lightmaps of {} bytes, and not of the {} that it counts",
                        all.size() - 1, all.size()));
  EXPECT_EQ(mistakeAfter([](std::string& file) { put(file, kLightmapBytesAt, 0, 8); }),
            "has lightmaps of more than the 0 bytes that it counts");
}

TEST_F(SavedRoom, tellsWhatIsWrongInALightmap) {
  const auto withField = [this](int field, const std::string& number) {
    return mistakeAfterInLightmaps([&](std::string& lightmaps) {
      lightmaps.replace(static_cast<std::size_t>(field), 1, number);
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
  EXPECT_EQ(mistakeAfterInLightmaps([](std::string& lightmaps) { lightmaps.resize(3); }), noNumber);
}

TEST_F(SavedRoom, tellsWhichLightmapsDoNotFillIt) {
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { put(bytes, kLightmapsAt, 7); }),
            "has only 6 of the 7 lightmaps that it counts");
  EXPECT_EQ(mistakeAfter([](std::string& bytes) { put(bytes, kLightmapsAt, 0xffffffff); }),
            "has only 6 of the 4294967295 lightmaps that it counts");
  EXPECT_EQ(mistakeAfterInLightmaps([](std::string& lightmaps) { lightmaps += "abc"; }),
            "has 3 bytes after its lightmaps");
  EXPECT_EQ(mistakeAfterInLightmaps([](std::string& lightmaps) { lightmaps.pop_back(); }),
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
  const auto read =
      decodeBake(yard.scene(), encodeBake(yard.scene(), light, 0.125, ""), kMuchLight);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().what, "has a lightmap for surface 1 (sky ceiling) that never shows light");
}

}  // namespace
}  // namespace hearth
