#include "image/halved.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

Image grays(int width, int height, std::initializer_list<int> levels) {
  Image image(width, height);
  auto level = levels.begin();
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x, ++level) {
      const auto gray = static_cast<std::uint8_t>(*level);
      image.at(x, y) = {gray, gray, gray};
    }
  return image;
}

TEST(Halved, HasTheMeansOfFourPixelsRoundedHalfUp) {
  EXPECT_EQ(halved(grays(4, 2,
                         {0, 2, 10, 11,  //
                          4, 6, 12, 13})),
            grays(2, 1, {3, 12}));
}

TEST(Halved, SharesPixelsOfOddSizesByWhatIsCovered) {
  // A pixel of the smaller picture is 5/2 wide.
  EXPECT_EQ(halved(grays(5, 1, {10, 20, 30, 40, 50})), grays(2, 1, {18, 42}));
  EXPECT_EQ(halved(grays(1, 3, {0, 60, 255})), grays(1, 1, {105}));
}

TEST(Halved, OfASinglePixelIsThat) { EXPECT_EQ(halved(grays(1, 1, {7})), grays(1, 1, {7})); }

TEST(Halved, KeepsChannelsApartAndPlainColoursAsTheyAre) {
  const Image plain(37, 22, {255, 128, 1});
  EXPECT_EQ(halved(plain), Image(18, 11, {255, 128, 1}));
}

}  // namespace
}  // namespace hearth
