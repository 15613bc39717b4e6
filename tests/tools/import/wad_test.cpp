#include "import/doom/wad.h"

#include <gtest/gtest.h>

#include "wad_builder.h"

namespace hearth::doom {
namespace {

std::string textOf(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

/// A header alone, of a directory that may not be there.
std::string headerOf(std::int64_t count, std::int64_t directory) {
  return LumpBuilder().append("IWAD").int32(count).int32(directory).content();
}

/// A WAD of one lump, `begin` and `length` as its directory has them, in 40 bytes.
std::string wadWithLumpAt(std::int64_t begin, std::int64_t length) {
  LumpBuilder wad;
  wad.append(headerOf(1, 12)).int32(begin).int32(length).name("LUMP").repeat('x', 12);
  return wad.content();
}

std::string mistakeOf(const std::string& content) {
  const auto wad = openBytes(content);
  EXPECT_FALSE(wad);
  return wad ? "" : wad.error();
}

TEST(WadNumbers, haveTheirLowestByteFirstAndASign) {
  const std::string content =
      LumpBuilder().bytes({9, 0x34, 0x12, 0xFE, 0xFF, 0xFF, 0xFF}).content();
  const Bytes bytes = bytesOf(content);
  EXPECT_EQ(int16At(bytes, 1), 0x1234);
  EXPECT_EQ(int16At(bytes, 3), -2);
  EXPECT_EQ(int32At(bytes, 3), -2);
  EXPECT_EQ(int32At(bytes, 0), static_cast<std::int32_t>(0xFE123409));
}

TEST(WadNames, endAtAZeroOrAfterEightBytesAndAreInUpperCase) {
  const std::string content = LumpBuilder().name("e1m1").name("Floor7_12").content();
  EXPECT_EQ(nameAt(bytesOf(content), 0), "E1M1");
  EXPECT_EQ(nameAt(bytesOf(content), 8), "FLOOR7_1");
}

TEST(WadNames, canBePrinted) {
  const std::string content = LumpBuilder().name("A\x1b[1m\xff~ ").content();
  EXPECT_EQ(nameAt(bytesOf(content), 0), "A?[1M?~ ");
}

TEST(Wad, takesThePlaceOfWhatItIsLaidOver) {
  auto wad = openBytes(WadBuilder().add("MAP01", "mine").content("PWAD"));
  auto base = openBytes(WadBuilder().add("PLAYPAL", "colours").add("MAP01", "theirs").content());
  ASSERT_TRUE(wad && base);
  wad->layOver(*std::move(base));
  const Wad moved = *std::move(wad);
  ASSERT_EQ(moved.lumps().size(), 3U);
  EXPECT_EQ(textOf(moved.bytesOf("PLAYPAL")), "colours");
  EXPECT_EQ(textOf(moved.bytesOf("MAP01")), "mine");
  EXPECT_EQ(textOf(moved.lumps()[1].bytes), "theirs");
}

TEST(Wad, hasItsLumpsInOrder) {
  for (const char* kind : {"IWAD", "PWAD"}) {
    const auto wad =
        openBytes(WadBuilder().add("A", "one").add("B").add("C", "three").content(kind));
    ASSERT_TRUE(wad) << wad.error();
    ASSERT_EQ(wad->lumps().size(), 3U);
    EXPECT_EQ(wad->lumps()[0].name, "A");
    EXPECT_EQ(textOf(wad->lumps()[0].bytes), "one");
    EXPECT_EQ(wad->lumps()[1].name, "B");
    EXPECT_TRUE(wad->lumps()[1].bytes.empty());
    EXPECT_EQ(textOf(wad->lumps()[2].bytes), "three");
  }
}

TEST(Wad, mayBeEmpty) { EXPECT_TRUE(opened(WadBuilder()).lumps().empty()); }

TEST(Wad, findsTheLastLumpOfAName) {
  const Wad wad = opened(WadBuilder().add("A", "old").add("B", "other").add("A", "new"));
  EXPECT_EQ(wad.find("A"), 2U);
  EXPECT_EQ(textOf(wad.bytesOf("A")), "new");
  EXPECT_EQ(wad.find("C"), std::nullopt);
  EXPECT_TRUE(wad.bytesOf("C").empty());
}

TEST(Wad, hasNamesInUpperCase) {
  const Wad wad = opened(WadBuilder().add("PlayPal", "x"));
  EXPECT_EQ(wad.lumps()[0].name, "PLAYPAL");
  EXPECT_EQ(textOf(wad.bytesOf("PLAYPAL")), "x");
}

TEST(Wad, keepsItsLumpsWhenItIsMoved) {
  Wad wad = opened(WadBuilder().add("A", "one"));
  const Wad moved = std::move(wad);
  EXPECT_EQ(textOf(moved.bytesOf("A")), "one");
}

TEST(Wad, isTakenForWhatItsFirstBytesSay) {
  for (const char* content : {"", "WAD", "IWA", "ZWAD 12 bytes and more"})
    EXPECT_EQ(mistakeOf(content), "not a WAD: it begins with neither IWAD nor PWAD") << content;
}

TEST(Wad, isRefusedWhenItIsCutShort) {
  EXPECT_EQ(mistakeOf("IWAD1234567"), "cut short: its header has 12 bytes");
  const std::string whole = WadBuilder().add("A", "one").content();
  for (std::size_t size = 4; size < whole.size(); ++size)
    EXPECT_TRUE(mistakeOf(whole.substr(0, size)).starts_with("cut short")) << size;
}

TEST(Wad, isRefusedWhenItsDirectoryLiesOutside) {
  EXPECT_EQ(mistakeOf(headerOf(1, 12)),
            "cut short: 1 lumps from byte 12 on do not fit in 12 bytes");
  EXPECT_EQ(mistakeOf(headerOf(0, 13)),
            "cut short: 0 lumps from byte 13 on do not fit in 12 bytes");
  EXPECT_EQ(mistakeOf(headerOf(-1, 12)),
            "cut short: -1 lumps from byte 12 on do not fit in 12 bytes");
  EXPECT_EQ(mistakeOf(headerOf(0, -4)),
            "cut short: 0 lumps from byte -4 on do not fit in 12 bytes");
  EXPECT_EQ(mistakeOf(headerOf(INT32_MAX, INT32_MAX)),
            "cut short: 2147483647 lumps from byte 2147483647 on do not fit in 12 bytes");
}

TEST(Wad, isRefusedWhenALumpLiesOutside) {
  ASSERT_TRUE(openBytes(wadWithLumpAt(28, 12)));
  for (const auto& [begin, length] : std::initializer_list<std::pair<std::int64_t, std::int64_t>>{
           {29, 12}, {28, 13}, {-1, 2}, {28, -1}, {INT32_MAX, INT32_MAX}, {INT32_MIN, 1}})
    EXPECT_EQ(mistakeOf(wadWithLumpAt(begin, length)),
              "lump 0 (LUMP) lies outside of the file's 40 bytes")
        << begin << ' ' << length;
}

TEST(Wad, mayHaveLumpsWithoutBytesThatLieAnywhere) {
  EXPECT_TRUE(openBytes(wadWithLumpAt(-5, 0)));
  EXPECT_TRUE(openBytes(wadWithLumpAt(INT32_MAX, 0)));
}

TEST(Wad, isRefusedWhenItIsTooLongOrMissing) {
  const std::string content = WadBuilder().content();
  EXPECT_TRUE(openBytes(content, content.size()));
  const auto wad = openBytes(content, content.size() - 1);
  ASSERT_FALSE(wad);
  EXPECT_EQ(wad.error(), "12 bytes are more than 11");
  const auto missing = Wad::open("/nowhere/doom.wad", 100);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error(), "/nowhere/doom.wad: no such file");
}

}  // namespace
}  // namespace hearth::doom
