#include "image/compare.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace hearth {
namespace {

/// `#` is a pixel that differs from black by 9 levels.
Image drawn(const std::vector<std::string>& rows) {
  Image image(static_cast<int>(rows.front().size()), static_cast<int>(rows.size()));
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const bool set = rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)] == '#';
      if (set) image.at(x, y) = {0, 9, 0};
    }
  }
  return image;
}

std::int64_t largestPatch(const std::vector<std::string>& rows) {
  const Image image = drawn(rows);
  return compare(Image(image.width(), image.height()), image).largestPatch;
}

TEST(Compare, EqualPicturesDoNotDiffer) {
  const Image image(5, 4, {1, 2, 3});
  EXPECT_EQ(compare(image, image), PictureDifference{});
  EXPECT_EQ(compare(Image(), Image()), PictureDifference{});
}

TEST(Compare, CountsByTheChannelThatDiffersMost) {
  const Image expected(5, 1, {100, 100, 100});
  Image actual = expected;
  actual.at(0, 0) = {102, 99, 100};  // 2: not over 2
  actual.at(1, 0) = {100, 97, 100};  // 3: over 2
  actual.at(2, 0) = {101, 101, 92};  // 8: not over 8
  actual.at(3, 0) = {109, 100, 100};
  EXPECT_EQ(
      compare(expected, actual),
      (PictureDifference{.differing = 4, .over2 = 3, .over8 = 1, .largest = 9, .largestPatch = 4}));
}

TEST(Compare, DoesNotDependOnWhichPictureIsExpected) {
  const Image black(3, 3);
  const Image white(3, 3, {255, 255, 255});
  EXPECT_EQ(compare(black, white), compare(white, black));
  EXPECT_EQ(compare(black, white).largest, 255);
}

TEST(Compare, PatchesJoinThroughEdgesOnly) {
  EXPECT_EQ(largestPatch({"#.", ".#"}), 1);
  EXPECT_EQ(largestPatch({"#.", "##"}), 3);
}

TEST(Compare, PatchesDoNotWrapAroundTheBorder) {
  EXPECT_EQ(largestPatch({"#..#", "#..#"}), 2);
  EXPECT_EQ(largestPatch({"..##", "##.."}), 2);
}

TEST(Compare, FindsTheLargestOfSeveralPatches) {
  EXPECT_EQ(largestPatch({
                "##...#",  //
                "#..#.#",  //
                "...###",  //
                "##...#",
            }),
            7);
}

TEST(Compare, TakesPatchesOfPixelsThatDifferByMoreThanIsSaid) {
  const Image expected(5, 1);
  Image actual = expected;
  for (int i = 0; i < 5; ++i) actual.at(i, 0) = {static_cast<std::uint8_t>(i + 1), 0, 0};
  EXPECT_EQ(compare(expected, actual).largestPatch, 5);
  EXPECT_EQ(compare(expected, actual, 3).largestPatch, 2);
  EXPECT_EQ(compare(expected, actual, 5).largestPatch, 0);
}

TEST(Compare, APatchMayBeAsLargeAsThePicture) {
  const Image black(1000, 1000);
  const Image grey(1000, 1000, {1, 1, 1});
  EXPECT_EQ(compare(black, grey).largestPatch, 1'000'000);
}

TEST(AmplifiedDifference, ShowsEveryLevelOfEveryChannel) {
  const Image expected(4, 1, {100, 100, 100});
  Image actual = expected;
  actual.at(1, 0) = {101, 100, 98};
  actual.at(2, 0) = {107, 92, 0};
  actual.at(3, 0) = {255, 100, 99};
  const Image difference = amplifiedDifference(expected, actual);
  EXPECT_EQ(difference.at(0, 0), (Rgb{0, 0, 0}));
  EXPECT_EQ(difference.at(1, 0), (Rgb{88, 0, 112}));
  EXPECT_EQ(difference.at(2, 0), (Rgb{232, 255, 255}));
  EXPECT_EQ(difference.at(3, 0), (Rgb{255, 0, 88}));
  EXPECT_EQ(amplifiedDifference(actual, expected), difference);
}

TEST(CompareDeathTest, SizesMustBeEqual) {
  EXPECT_DEATH(compare(Image(2, 3), Image(3, 2)), "width");
  EXPECT_DEATH(amplifiedDifference(Image(2, 3), Image(3, 2)), "width");
}

}  // namespace
}  // namespace hearth
