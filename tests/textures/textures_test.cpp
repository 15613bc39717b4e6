#include "textures/textures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "image/image_file.h"
#include "support/in_tree.h"
#include "textures/sprites.h"
#include "textures/turn.h"

namespace hearth::textures {
namespace {

int levelsApart(Rgb a, Rgb b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

/// How much neighbouring columns differ, in levels per channel: inside the image, and where its
/// right edge meets its left one.
struct Gradient {
  double inside = 0;
  double acrossEdge = 0;
};

Gradient alongRows(const Image& image) {
  std::int64_t inside = 0;
  std::int64_t across = 0;
  const int last = image.width() - 1;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < last; ++x) inside += levelsApart(image.at(x, y), image.at(x + 1, y));
    across += levelsApart(image.at(last, y), image.at(0, y));
  }
  return {static_cast<double>(inside) / (3.0 * last * image.height()),
          static_cast<double>(across) / (3.0 * image.height())};
}

Image transposed(const Image& image) {
  Image turned(image.height(), image.width());
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) turned.at(y, x) = image.at(x, y);
  }
  return turned;
}

double meanLevel(const Image& image) {
  std::int64_t sum = 0;
  for (const Rgb pixel : image.pixels()) sum += pixel.r + pixel.g + pixel.b;
  return static_cast<double>(sum) / (3.0 * static_cast<double>(image.pixels().size()));
}

std::vector<Texture> makeTexturesAndSprites() {
  std::vector<Texture> all = makeAll();
  for (Texture& sprite : makeSprites()) all.push_back(std::move(sprite));
  return all;
}

/// To the pixel: how a PNG is packed is zlib's business.
TEST(Textures, AreThoseOfTheTexturesFolder) {
  for (const Texture& texture : makeTexturesAndSprites()) {
    const auto kept = test::inTree("textures") / (texture.name + ".png");
    const auto image = readImage(kept, 1 << 20);
    ASSERT_TRUE(image) << image.error();
    EXPECT_TRUE(*image == texture.image)
        << kept << " is not what its generator makes: run hearth-textures textures";
  }
}

TEST(Textures, AreAllInTheTexturesFolder) {
  std::set<std::string> made;
  for (const Texture& texture : makeTexturesAndSprites()) made.insert(texture.name + ".png");
  std::set<std::string> kept;
  for (const auto& file : std::filesystem::directory_iterator(test::inTree("textures")))
    if (file.path().extension() == ".png") kept.insert(file.path().filename());
  EXPECT_EQ(made, kept);
}

TEST(Textures, AreOf128PixelsOrMore) {
  for (const Texture& texture : makeAll()) {
    EXPECT_GE(texture.image.width(), 128) << texture.name;
    EXPECT_GE(texture.image.height(), 128) << texture.name;
  }
}

TEST(Textures, HaveNoSeamAtTheirEdges) {
  for (const Texture& texture : makeAll()) {
    const Gradient rows = alongRows(texture.image);
    EXPECT_LE(rows.acrossEdge, 1.2 * rows.inside) << texture.name << ", left and right";
    if (texture.name == "sky") continue;
    const Gradient columns = alongRows(transposed(texture.image));
    EXPECT_LE(columns.acrossEdge, 1.2 * columns.inside) << texture.name << ", top and bottom";
  }
}

TEST(Textures, AreBrightEnoughForLightToDarkenThem) {
  for (const Texture& texture : makeAll()) {
    EXPECT_GE(meanLevel(texture.image), 110) << texture.name;
    EXPECT_LE(meanLevel(texture.image), 190) << texture.name;
  }
}

TEST(Textures, AQuarterTurnBringsTheLowerEdgeToTheLeft) {
  const Image slate = makeSlate();
  const Image west = turned(slate);
  const int last = kTileSide - 1;
  for (int i = 0; i < kTileSide; ++i) {
    ASSERT_EQ(west.at(0, i), slate.at(i, last)) << i;
    ASSERT_EQ(west.at(last, i), slate.at(i, 0)) << i;
  }
}

// A course of slates lies across the slope: it goes on along lines from the lower left to the upper
// right, and the slope falls to the lower right.
TEST(Textures, AnEighthTurnLaysRowsAcrossASlopeThatFallsToTheLowerRight) {
  Image tile(kTileSide, kTileSide);
  for (int y = 0; y < kTileSide; ++y)
    for (int x = 0; x < kTileSide; ++x) tile.at(x, y) = Rgb{static_cast<std::uint8_t>(y), 0, 0};
  const Image aslant = diagonal(tile);
  for (int i = 1; i < kTileSide; ++i) {
    ASSERT_EQ(aslant.at(i, 0), aslant.at(0, i)) << i;
    ASSERT_EQ(aslant.at(i, i).r, 4 * i % kTileSide) << i;
  }
}

TEST(Textures, TheSkyIsPlainWhereItIsRepeatedBeyondItsImage) {
  const Image sky = makeSky();
  for (const int row : {0, sky.height() - 1}) {
    for (int x = 1; x < sky.width(); ++x) ASSERT_EQ(sky.at(x, row), sky.at(0, row)) << x;
  }
}

TEST(Sprites, HaveHolesAndMore) {
  for (const Texture& sprite : makeSprites()) {
    int holes = 0;
    for (int y = 0; y < sprite.image.height(); ++y)
      for (int x = 0; x < sprite.image.width(); ++x) holes += sprite.image.isHole(x, y);
    EXPECT_GE(16 * holes, sprite.image.width() * sprite.image.height()) << sprite.name;
    EXPECT_LE(16 * holes, 15 * sprite.image.width() * sprite.image.height()) << sprite.name;
  }
}

std::vector<std::vector<Image>> animations() {
  std::vector<Image> flames;
  for (int frame = 0; frame < kFlameFrames; ++frame) flames.push_back(makeFlame(frame));
  std::vector<Image> candles;
  for (int frame = 0; frame < kCandleFlameFrames; ++frame)
    candles.push_back(makeCandleFlame(frame));
  return {flames, candles};
}

TEST(Sprites, FlamesRiseFromTheirLowerEdgeAndAreNotCutOffAtTheOthers) {
  for (const std::vector<Image>& flames : animations())
    for (const Image& flame : flames) {
      const int right = flame.width() - 1;
      const int bottom = flame.height() - 1;
      for (int x = 0; x <= right; ++x) EXPECT_TRUE(flame.isHole(x, 0)) << x;
      for (int y = 0; y <= bottom; ++y)
        EXPECT_TRUE(flame.isHole(0, y) && flame.isHole(1, y) && flame.isHole(right, y) &&
                    flame.isHole(right - 1, y))
            << y;
      EXPECT_FALSE(flame.isHole(right / 2, bottom));
    }
}

int pixelsApart(const Image& a, const Image& b) {
  int apart = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) apart += a.isHole(x, y) != b.isHole(x, y);
  return apart;
}

TEST(Sprites, FlamesMoveOnFromTheirLastFrameToTheFirst) {
  for (const std::vector<Image>& flames : animations()) {
    int most = 0;
    for (std::size_t i = 1; i < flames.size(); ++i)
      most = std::max(most, pixelsApart(flames[i - 1], flames[i]));
    const int atTheEnd = pixelsApart(flames.back(), flames.front());
    EXPECT_GT(atTheEnd, 0);
    EXPECT_LE(2 * atTheEnd, 3 * most);
  }
}

}  // namespace
}  // namespace hearth::textures
