#include "import/doom/patch.h"

#include <gtest/gtest.h>

#include "patch_builder.h"

namespace hearth::doom {
namespace {

Palette testPalette() {
  Palette palette;
  for (int i = 0; i < 256; ++i) palette[static_cast<std::size_t>(i)] = colorOf(i);
  return palette;
}

Picture emptyPicture(int width, int height) { return {ImageSize{width, height}, colorOf(0)}; }

/// Rows of the picture: a letter for each pixel, `a` for colour 1; `.` is a hole.
std::vector<std::string> rowsOf(const Picture& picture) {
  std::vector<std::string> rows;
  for (int y = 0; y < picture.image.height(); ++y) {
    rows.emplace_back();
    for (int x = 0; x < picture.image.width(); ++x) {
      const int color = picture.image.at(x, y).r;
      EXPECT_EQ(picture.image.at(x, y), colorOf(color));
      const auto i = static_cast<std::size_t>(y * picture.image.width() + x);
      if (!picture.isOpaque[i]) {
        EXPECT_EQ(color, 0);
      }
      rows.back() += picture.isOpaque[i] ? static_cast<char>('a' + color - 1) : '.';
    }
  }
  return rows;
}

using Rows = std::vector<std::string>;

/// Of pictures with up to four columns: patches begin at their top.
const std::vector<int> kTops(4, 0);

/// What shows of a patch without mistakes.
Rows drawn(const std::string& patch, int width, int height, int left = 0, int top = 0) {
  Picture picture = emptyPicture(width, height);
  const std::vector<int> tops(static_cast<std::size_t>(width), top);
  EXPECT_EQ(drawPatch(bytesOf(patch), left, tops, testPalette(), picture), std::nullopt);
  return rowsOf(picture);
}

/// What is told of a patch that is drawn over a picture of 4 x 4 pixels.
std::string mistakeOf(const std::string& patch) {
  Picture picture = emptyPicture(4, 4);
  return drawPatch(bytesOf(patch), 0, kTops, testPalette(), picture).value_or("");
}

/// a c
/// b d
/// . e
const std::string kLetters = patchOf(3, {{{0, {1, 2}}}, {{0, {3, 4, 5}}}});

TEST(Patch, hasItsColumnsFromLeftToRightAndPixelsFromTopToBottom) {
  EXPECT_EQ(drawn(kLetters, 2, 3), (Rows{"ac", "bd", ".e"}));
}

TEST(Patch, hasHolesBetweenItsPosts) {
  EXPECT_EQ(drawn(patchOf(6, {{{1, {1}}, {3, {2, 3}}}, {}}), 2, 6),
            (Rows{"..", "a.", "..", "b.", "c.", ".."}));
}

TEST(Patch, mayHavePostsWithoutPixels) {
  EXPECT_EQ(drawn(patchOf(2, {{{0, {}}, {1, {1}}}}), 1, 2), (Rows{".", "a"}));
}

TEST(Patch, isDrawnOverWhatIsThere) {
  Picture picture = emptyPicture(2, 3);
  const std::string below = plainPatch(2, 3, 26);
  ASSERT_FALSE(drawPatch(bytesOf(below), 0, kTops, testPalette(), picture));
  ASSERT_FALSE(drawPatch(bytesOf(kLetters), 0, kTops, testPalette(), picture));
  EXPECT_EQ(rowsOf(picture), (Rows{"ac", "bd", "ze"}));
}

TEST(Patch, isCutOffAtEachBorder) {
  EXPECT_EQ(drawn(kLetters, 3, 3, 1, 1), (Rows{"...", ".ac", ".bd"}));
  EXPECT_EQ(drawn(kLetters, 2, 2, -1, 0), (Rows{"c.", "d."}));
  EXPECT_EQ(drawn(kLetters, 2, 2, 1, 0), (Rows{".a", ".b"}));
  EXPECT_EQ(drawn(kLetters, 2, 1, 0, 0), (Rows{"ac"}));
}

TEST(Patch, losesItsLowerRowsAtTheUpperBorderAsInDoom) {
  EXPECT_EQ(drawn(kLetters, 2, 3, 0, -1), (Rows{"ac", ".d", ".."}));
  EXPECT_EQ(drawn(kLetters, 2, 3, 0, -2), (Rows{".c", "..", ".."}));
  EXPECT_EQ(drawn(patchOf(4, {{{0, {1, 2}}, {3, {3, 4}}}}), 1, 3, 0, -1), (Rows{"a", ".", "c"}));
}

TEST(Patch, mayBeginInAnotherRowInEachColumn) {
  Picture picture = emptyPicture(2, 3);
  ASSERT_FALSE(drawPatch(bytesOf(kLetters), 0, std::vector<int>{1, 0}, testPalette(), picture));
  EXPECT_EQ(rowsOf(picture), (Rows{".c", "ad", "be"}));
}

TEST(Patch, mayLieOutsideOnAnySide) {
  for (const auto& [left, top] : std::initializer_list<std::pair<int, int>>{
           {2, 0}, {-2, 0}, {0, 3}, {0, -3}, {INT16_MIN, INT16_MIN}, {INT16_MAX, INT16_MAX}})
    EXPECT_EQ(drawn(kLetters, 2, 2, left, top), (Rows{"..", ".."})) << left << ' ' << top;
}

TEST(Patch, mayBeTallerThanRowsFitInAByte) {
  const std::vector<int> upper(250, 1);
  // 250 rows, then 10 from row 250, then one 200 below that, one as far below again.
  const std::string patch =
      patchOf(700, {{{0, upper}, {250, std::vector<int>(10, 2)}, {200, {3}}, {200, {4}}}});
  const Rows rows = drawn(patch, 1, 700);
  for (std::size_t y = 0; y < rows.size(); ++y) {
    const std::string expected = y < 250    ? "a"
                                 : y < 260  ? "b"
                                 : y == 450 ? "c"
                                 : y == 650 ? "d"
                                            : ".";
    ASSERT_EQ(rows[y], expected) << y;
  }
}

TEST(Patch, takesTheSameRowAgainForAsFarBelow) {
  const Rows rows = drawn(patchOf(401, {{{200, {1}}, {200, {2}}}}), 1, 401);
  EXPECT_EQ(rows[200], "a");
  EXPECT_EQ(rows[400], "b");
}

TEST(Patch, showsPostsBelowItsOwnHeight) {
  EXPECT_EQ(drawn(patchOf(1, {{{0, {1}}, {2, {2}}}}), 1, 3), (Rows{"a", ".", "b"}));
}

TEST(Patch, isRefusedWhenItsHeaderIsCutShort) {
  EXPECT_EQ(mistakeOf(""), "has 0 bytes, too few for a patch");
  EXPECT_EQ(mistakeOf("1234567"), "has 7 bytes, too few for a patch");
  EXPECT_EQ(mistakeOf(kLetters.substr(0, 15)), "has 15 bytes, too few for 2 columns");
}

TEST(Patch, isRefusedWhenItsSizeMakesNoSense) {
  const auto header = [](int width, int height) {
    return LumpBuilder().int16(width).int16(height).repeat(0, 16390).content();
  };
  EXPECT_EQ(mistakeOf(header(0, 3)), "is no patch: a side of 0 x 3 pixels is not within 1..4096");
  EXPECT_EQ(mistakeOf(header(-2, 3)), "is no patch: a side of -2 x 3 pixels is not within 1..4096");
  EXPECT_EQ(mistakeOf(header(3, 0)), "is no patch: a side of 3 x 0 pixels is not within 1..4096");
  EXPECT_EQ(mistakeOf(header(4097, 3)),
            "is no patch: a side of 4097 x 3 pixels is not within 1..4096");
  EXPECT_EQ(mistakeOf(header(3, 32767)),
            "is no patch: a side of 3 x 32767 pixels is not within 1..4096");
  EXPECT_EQ(mistakeOf(plainPatch(4096, 1, 1)), "");
}

TEST(Patch, tellsTheFirstColumnThatLiesOutsideAndDrawsTheOthers) {
  for (const std::int64_t begin : {std::int64_t{-1}, std::int64_t{30}, std::int64_t{INT32_MAX}}) {
    LumpBuilder patch;
    patch.int16(3).int16(1).int32(0).int32(begin).int32(begin).int32(20);
    patch.append(columnOf({{0, {1, 2, 3}}})).repeat(0, 2);
    ASSERT_EQ(patch.size(), 30U);
    Picture picture = emptyPicture(3, 2);
    EXPECT_EQ(drawPatch(bytesOf(patch.content()), 0, kTops, testPalette(), picture),
              fmt::format("has column 0 at byte {} of 30", begin));
    EXPECT_EQ(rowsOf(picture), (Rows{"..a", "..b"}));
  }
}

TEST(Patch, tellsAColumnThatBreaksOffAndDrawsWhatIsWhole) {
  const std::string whole = patchOf(4, {{{0, {1}}, {2, {2, 3}}}});
  for (std::size_t cut = 1; cut <= 12; ++cut) {
    const std::string patch = whole.substr(0, whole.size() - cut);
    const std::string expected =
        cut == 12 ? "has column 0 at byte 12 of 12" : "breaks off in column 0";
    Picture picture = emptyPicture(1, 4);
    EXPECT_EQ(drawPatch(bytesOf(patch), 0, kTops, testPalette(), picture), expected) << cut;
    const Rows rows = cut == 1  ? Rows{"a", ".", "b", "c"}
                      : cut < 8 ? Rows{"a", ".", ".", "."}
                                : Rows{".", ".", ".", "."};
    EXPECT_EQ(rowsOf(picture), rows) << cut;
  }
}

TEST(Patch, isNotFollowedThroughALargeLumpWithoutEnd) {
  // Posts without pixels, four bytes each.
  const auto withPosts = [](std::size_t count) {
    LumpBuilder patch;
    patch.int16(1).int16(1).int32(0).int32(12).repeat(0, 4 * count).bytes({255});
    return patch.content();
  };
  EXPECT_EQ(mistakeOf(withPosts(5120)), "");
  EXPECT_EQ(mistakeOf(withPosts(5121)), "breaks off in column 0");
}

}  // namespace
}  // namespace hearth::doom
