// The steps from the rows of a group to its pixels, one by one.

#include "render/pixel_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "image/pixel_rows.h"
#include "pixel_blocks.h"
#include "render/texel_fetch.h"

namespace hearth {
namespace {

using test::inAllColumns;
using test::minusFraction;
using test::pixelOfRow;
using test::setFull;
using test::setRows;

/// The column of an image of so many that texel coordinate `x` falls into.
int repeated(double x, int size) {
  PixelBlock block{};
  setRows(block, {0});
  pixelKernels().findTexels(block, inAllColumns({.u = {.place = {x, 0}}}), Texture(Image(size, 1)));
  return static_cast<int>(block.texels[0][0]);
}

/// The first pixel of a block of one row that shows an image, or white.
Rgb pixelOf(PixelBlock& block, const Texture* image, const GroupLight& light) {
  setFull(block);
  std::vector<std::uint32_t> row(PixelBlock::kLanes);
  const GroupTexels texels{image, false, false, image == nullptr};
  if (image) fetchColors(block, texels);
  pixelKernels().shade(block, texels, light, row.data());
  return fromXrgb(row[0]);
}

/// A pixel of this colour in light that is the same everywhere.
Rgb shadedIn(Rgb color, std::uint8_t level, Vec3 evenLight) {
  const Lightmap even{.rect = {0, 0, 1, 1}, .levels = {level}};
  Image image(1, 1);
  image.at(0, 0) = color;
  const Texture texture(image);
  PixelBlock block{};
  block.rows = 1;
  return pixelOf(block, &texture, {&even, evenLight, false});
}

Rgb shaded(Rgb color, std::uint8_t level, double evenLight) {
  return shadedIn(color, level, {evenLight, evenLight, evenLight});
}

TEST(Repeated, isATrueModulo) {
  for (const int size : {1, 12, 16, 100}) {
    const double x = size;
    EXPECT_EQ(repeated(0.0, size), 0);
    EXPECT_EQ(repeated(x - 0.01, size), size - 1);
    EXPECT_EQ(repeated(x, size), 0);
    EXPECT_EQ(repeated(-0.01, size), size - 1);
    EXPECT_EQ(repeated(-x, size), 0);
    EXPECT_EQ(repeated(std::nextafter(x, 0), size), size - 1);
    EXPECT_EQ(repeated(-1e-300, size), size - 1);
  }
  EXPECT_EQ(repeated(-1e9 - 0.5, 100), 99);
}

TEST(Repeated, missesNoMultipleOfTheSize) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 10'000; ++i) {
    const int size = std::uniform_int_distribution(1, 3000)(random);
    const auto times = std::uniform_int_distribution<std::int64_t>(-(1LL << 38), 1LL << 38)(random);
    const auto x = static_cast<double>(times * size);
    ASSERT_EQ(repeated(x, size), 0) << x << ' ' << size;
    ASSERT_EQ(repeated(x - 1, size), size - 1) << x << ' ' << size;
  }
}

TEST(Repeated, staysInTheImageHoweverFarAway) {
  for (const double x : {1e15, -1e15, 1e16, 1e19, -1e19, 1e300, -1e300})
    for (const int size : {1, 3, 64, 100, 1048575}) {
      EXPECT_GE(repeated(x, size), 0) << x << ' ' << size;
      EXPECT_LT(repeated(x, size), size) << x << ' ' << size;
    }
}

int modulo(double x, int size) {
  const double rest = std::fmod(std::floor(x), size);
  return static_cast<int>(rest < 0 ? rest + size : rest);
}

TEST(PixelKernels, findTheTexelsThatAModuloOfEachRowGives) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1e6, 1e6);
  for (const int width : {1, 7, 64, 100})
    for (const int height : {1, 3, 128, 1000}) {
      std::vector<double> parameters;
      for (int i = 0; i < PixelBlock::kRows - 1; ++i)
        parameters.push_back(i % 3 == 0 ? std::round(anywhere(random)) : anywhere(random));
      PixelBlock block{};
      setRows(block, parameters);
      pixelKernels().findTexels(
          block,
          inAllColumns({.isPlane = true, .u = {.place = {0.25, 1}}, .v = {.place = {-3, 0.5}}}),
          Texture(Image(width, height)));
      for (std::size_t k = 0; k < parameters.size(); ++k) {
        const auto texel = static_cast<int>(block.texels[0][pixelOfRow(k)]);
        EXPECT_EQ(texel / height, modulo(0.25 + parameters[k], width));
        EXPECT_EQ(texel % height, modulo(-3 + parameters[k] * 0.5, height));
      }
    }
}

/// Random axes of images. Their texel coordinate is `start` at `first`, and rises by `perStep` for
/// each `step` of the parameter.
class SomeAxes {
 public:
  ImageAxis through(double first, double start, double step, double perStep) {
    ImageAxis along{{0, places_(random_)}, places_(random_), 0, 7.25};
    along.texelsPerPlace = perStep / (step * along.place.per);
    along.place.atZero =
        (start + along.offset) / along.texelsPerPlace + along.origin - first * along.place.per;
    return along;
  }

  /// A whole number, or beside one by 2^-8 to 2^-45.
  double nearAWhole(int least, int most) {
    const int whole = std::uniform_int_distribution(least, most)(random_);
    const int side = std::uniform_int_distribution(-1, 1)(random_);
    return whole + std::ldexp(side, -std::uniform_int_distribution(8, 45)(random_));
  }

 private:
  std::mt19937 random_{1};
  std::uniform_real_distribution<double> places_{0.1, 200};
};

const std::vector<std::pair<int, int>> kSizes{{64, 128}, {1, 2}, {2, 65536}, {72, 100}, {3, 64}};

/// Compares texels in fixed point, where they can be told, with those in double precision.
class LinearTexels {
 public:
  void compare(const GroupMapping& mapping, const std::vector<double>& raySlopes, int rows,
               ImageSize size) {
    const Texture image(Image(size.width, size.height));
    PixelBlock block{};
    block.rows = rows;
    block.raySlopes = raySlopes.data();
    ++asked_;
    if (!pixelKernels().findLinearTexels(block, mapping, image)) return;
    ++told_;
    const auto found = block.texels[0];
    pixelKernels().findParameters(block, mapping);
    pixelKernels().findTexels(block, mapping, image);
    for (std::size_t k = 0; k < block.count(); ++k)
      ASSERT_EQ(found[k], block.texels[0][k]) << k << ' ' << size.width << 'x' << size.height;
  }

  /// Whether both happen: texels that fixed point tells, and such that it cannot tell.
  void expectSomeToBeTold() const {
    EXPECT_GT(told_, 50);
    EXPECT_LT(told_, asked_);
  }

 private:
  int asked_ = 0;
  int told_ = 0;
};

TEST(PixelKernels, findTheTexelsDownWallsHoweverNearToTheNextTheyAre) {
  SomeAxes some;
  LinearTexels linear;
  std::vector<double> raySlopes;
  for (int row = 0; row < PixelBlock::kRows + PixelBlock::kSpareRows; ++row)
    raySlopes.push_back((7.5 - row) / 160);
  for (const bool isSky : {false, true})
    for (const auto& [width, height] : kSizes)
      for (int i = 0; i < 500; ++i) {
        const double start = some.nearAWhole(-300, 300);
        const double perRow = some.nearAWhole(-9, 9);
        const SpanMapping mapping{
            .isSky = isSky,
            .u = {.place = {some.nearAWhole(-99, 99), 0}},
            .v = some.through(raySlopes[0], start, raySlopes[1] - raySlopes[0], perRow)};
        linear.compare(inAllColumns(mapping), raySlopes, 1 + i % PixelBlock::kRows,
                       {width, height});
      }
  linear.expectSomeToBeTold();
}

TEST(PixelKernels, findTheTexelsAcrossFlatsHoweverNearToTheNextTheyAre) {
  SomeAxes some;
  LinearTexels linear;
  std::vector<double> raySlopes;
  for (int row = 0; row < PixelBlock::kRows + PixelBlock::kSpareRows; ++row)
    raySlopes.push_back(-0.25 - row / 160.0);
  const double depth = -1 / raySlopes[0];
  for (const auto& [width, height] : kSizes)
    for (int i = 0; i < 500; ++i) {
      GroupMapping mapping = inAllColumns({.isPlane = true, .height = -1, .depth = 1e9});
      // In the first row, whole texels lie between neighbouring columns.
      for (LaneImageAxis* const axis : {&mapping.u, &mapping.v}) {
        const double start = some.nearAWhole(-300, 300);
        const double perColumn = some.nearAWhole(-9, 9) / depth;
        for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane)
          axis->place.per[lane] = start / depth + static_cast<double>(lane) * perColumn;
      }
      linear.compare(mapping, raySlopes, 1 + i % PixelBlock::kRows, {width, height});
    }
  linear.expectSomeToBeTold();
}

/// Far from the origin the places themselves are rounded, before their image's edge is subtracted.
TEST(PixelKernels, findTheTexelsOfImagesWhoseEdgeIsFarAway) {
  LinearTexels linear;
  std::vector<double> raySlopes;
  for (int row = 0; row < PixelBlock::kRows + PixelBlock::kSpareRows; ++row)
    raySlopes.push_back(-0.25 - row / 160.0);
  constexpr int kTexelsPerMetre = 1024;
  for (const bool isPlane : {false, true})
    for (const double far : {0.0, 1e7})
      for (int exponent = 15; exponent < 30; ++exponent)
        for (int whole = -9; whole <= 9; ++whole) {
          GroupMapping mapping = inAllColumns({.isPlane = isPlane, .height = -1, .depth = 1e9});
          for (LaneImageAxis* const axis : {&mapping.u, &mapping.v}) {
            axis->texelsPerPlace = kTexelsPerMetre;
            axis->origin.fill(far);
            axis->place.atZero.fill(far);
          }
          if (isPlane) mapping.v.offset = 0.37;
          // The first column of a plane's first row, or the first row of a wall, shows the middle
          // of a texel. To the next one it is slightly less than to the edge of a texel.
          const double metres = (whole + 0.5 - std::ldexp(1, -exponent)) / kTexelsPerMetre;
          for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane)
            if (isPlane)
              mapping.u.place.per[lane] = -raySlopes[0] * static_cast<double>(lane) * metres;
            else
              mapping.v.place.per[lane] = -160 * metres;
          (isPlane ? mapping.u : mapping.v).offset = isPlane ? -0.5 : -0.5 - 40 * (whole + 0.5);
          linear.compare(mapping, raySlopes, 1 + (whole + 9) % 4, {64, 64});
        }
  linear.expectSomeToBeTold();
}

TEST(PixelKernels, findDepthsThatAreThoseOfEachRow) {
  const SpanMapping slope{.isPlane = true, .height = -1.5, .rise = 0.125, .depth = 20};
  std::vector<double> raySlopes;
  for (int row = 0; row < PixelBlock::kRows; ++row) raySlopes.push_back((9 - row) / 60.0);
  PixelBlock block{};
  block.rows = PixelBlock::kRows;
  block.raySlopes = raySlopes.data();
  pixelKernels().findParameters(block, inAllColumns(slope));
  for (std::size_t k = 0; k < block.count(); ++k)
    EXPECT_EQ(block.parameters[k], slope.depthAt(raySlopes[k / PixelBlock::kLanes])) << k;
}

/// The number of a texel in a large lightmap is no float.
TEST(PixelKernels, findTexelsOfLargeLightmaps) {
  Lightmap lightmap;
  lightmap.rect = {0, 0, 5001, 4001};
  lightmap.channels = 3;
  PixelBlock block{};
  setRows(block, {4000.25, 3999.75});
  pixelKernels().findLightTexels(block,
                                 inAllColumns({.isPlane = true, .s = {4800.5, 0}, .t = {0.5, 1}}),
                                 lightmap, LightFilter::Bilinear);
  for (const std::size_t row : {0, 1})
    EXPECT_EQ(block.lightTexels[pixelOfRow(row)], 3U * (3999 * 5001 + 4800));
  EXPECT_EQ(block.betweenLightTexels.down[pixelOfRow(0)], minusFraction(1));
  EXPECT_EQ(block.betweenLightTexels.down[pixelOfRow(1)], minusFraction(0.75));
}

TEST(PixelKernels, findPlacesInALightmapAndKeepThemThere) {
  const Lightmap lightmap{.rect = {-2, 5, 4, 3}, .levels = std::vector<std::uint8_t>(12)};
  PixelBlock block{};
  setRows(block, {-100, -1.5, -1.25, 1.5, 100});
  pixelKernels().findLightTexels(block,
                                 inAllColumns({.isPlane = true, .s = {0, 1}, .t = {6.75, 0}}),
                                 lightmap, LightFilter::Bilinear);
  const std::vector<std::size_t> columns{0, 0, 0, 2, 2};
  const std::vector<double> fractions{0, 0, 0.25, 1, 1};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const std::size_t pixel = pixelOfRow(k);
    EXPECT_EQ(block.lightTexels[pixel], 4 + columns[k]) << k;
    EXPECT_EQ(block.betweenLightTexels.across[pixel], minusFraction(fractions[k])) << k;
    EXPECT_EQ(block.betweenLightTexels.down[pixel], minusFraction(0.25));
  }
}

/// Texels of a block from the left or upper edge of a lightmap, in 2^-15.
std::pair<int, int> placeOf(const PixelBlock& block, std::size_t pixel, const Lightmap& lightmap) {
  const auto texel = static_cast<int>(block.lightTexels[pixel]) / lightmap.channels;
  const PixelBlock::Mix& mix = block.betweenLightTexels;
  return {texel % lightmap.rect.width * 0x8000 - static_cast<std::int16_t>(mix.across[pixel]),
          texel / lightmap.rect.width * 0x8000 - static_cast<std::int16_t>(mix.down[pixel])};
}

/// Fixed point knows them to 2^-16, and steps add up.
TEST(PixelKernels, findTheSamePlacesInALightmapInFixedPoint) {
  std::vector<double> raySlopes;
  for (int row = 0; row < PixelBlock::kRows + PixelBlock::kSpareRows; ++row)
    raySlopes.push_back(-0.25 - row / 160.0);
  const Lightmap lightmap{
      .rect = {3, -7, 20, 30}, .levels = std::vector<std::uint8_t>(1800), .channels = 3};
  GroupMapping floor =
      inAllColumns({.isPlane = true, .height = -1, .depth = 1e9, .s = {1.7, 0}, .t = {-9.3, 5.7}});
  for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane)
    floor.s.per[lane] = 4 + 0.19 * static_cast<double>(lane);
  const GroupMapping wall = inAllColumns({.s = {5.8, 0}, .t = {-20.3, -70.1}});
  for (const GroupMapping& mapping : {floor, wall}) {
    PixelBlock exact{};
    exact.rows = PixelBlock::kRows;
    exact.raySlopes = raySlopes.data();
    PixelBlock mixed = exact;
    PixelBlock nearest = exact;
    const PixelKernels& kernels = pixelKernels();
    kernels.findParameters(exact, mapping);
    kernels.findLightTexels(exact, mapping, lightmap, LightFilter::Bilinear);
    ASSERT_TRUE(kernels.findLinearLightTexels(mixed, mapping, lightmap, LightFilter::Bilinear));
    ASSERT_TRUE(kernels.findLinearLightTexels(nearest, mapping, lightmap, LightFilter::Nearest));
    constexpr int kHalf = 0x4000;
    for (std::size_t k = 0; k < exact.count(); ++k) {
      const auto [x, y] = placeOf(exact, k, lightmap);
      const auto [mixedX, mixedY] = placeOf(mixed, k, lightmap);
      EXPECT_NEAR(mixedX, x, 8) << k;
      EXPECT_NEAR(mixedY, y, 8) << k;
      const auto [nearestX, nearestY] = placeOf(nearest, k, lightmap);
      EXPECT_EQ(nearestX % 0x8000 + nearestY % 0x8000, 0) << k << ": centres";
      EXPECT_NEAR(nearestX, x, kHalf + 8) << k;
      EXPECT_NEAR(nearestY, y, kHalf + 8) << k;
    }
  }
}

/// The levels that are shown at the centres of a lightmap's texels, row by row.
std::vector<Rgb> levelsShown(const Lightmap& lightmap) {
  std::vector<Rgb> found;
  for (int row = 0; row < lightmap.rect.height; ++row)
    for (int column = 0; column < lightmap.rect.width; ++column) {
      PixelBlock block{};
      setRows(block, {0});
      pixelKernels().findLightTexels(block,
                                     inAllColumns({.s = {column + 0.5, 0}, .t = {row + 0.5, 0}}),
                                     lightmap, LightFilter::Bilinear);
      found.push_back(pixelOf(block, nullptr, {&lightmap, {}, true}));
    }
  return found;
}

TEST(PixelKernels, showEachTexelOfALightmapInItsChannels) {
  const Lightmap white{.rect = {0, 0, 3, 2}, .levels = {1, 2, 3, 40, 50, 60}};
  EXPECT_EQ(levelsShown(white),
            (std::vector<Rgb>{
                {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {40, 40, 40}, {50, 50, 50}, {60, 60, 60}}));
  const Lightmap colored{.rect = {0, 0, 2, 2},
                         .levels = {1, 2, 3, 14, 15, 16, 127, 128, 129, 253, 254, 255},
                         .channels = 3};
  EXPECT_EQ(levelsShown(colored),
            (std::vector<Rgb>{{1, 2, 3}, {14, 15, 16}, {127, 128, 129}, {253, 254, 255}}));
}

/// Rows that share their texels and rows that do not.
TEST(PixelKernels, mixTheLightOfEachPixelWhateverLightTheRowAboveHas) {
  std::mt19937 random(1);
  for (const int channels : {1, 3}) {
    Lightmap lightmap{.rect = {0, 0, 9, 5}, .levels = {}, .channels = channels};
    for (int i = 0; i < 9 * 5 * channels; ++i)
      lightmap.levels.push_back(static_cast<std::uint8_t>(random()));
    for (const double step : {0.01, 0.1, 0.7, 3.0}) {
      std::vector<double> parameters;
      for (int row = 0; row < PixelBlock::kRows; ++row) parameters.push_back(row * step);
      GroupMapping mapping = inAllColumns({.t = {0.6, 1}});
      for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane)
        mapping.s.atZero[lane] = 0.5 + static_cast<double>(lane) * 1.03;
      PixelBlock block{};
      setRows(block, parameters);
      pixelKernels().findLightTexels(block, mapping, lightmap, LightFilter::Bilinear);
      setFull(block);
      std::vector<std::uint32_t> rows(block.count());
      constexpr GroupTexels kWhite{nullptr, false, false, true};
      pixelKernels().shade(block, kWhite, {&lightmap, {}, false}, rows.data());
      std::vector<std::uint32_t> columnRows(block.count());
      pixelKernels().shade(block, kWhite, {&lightmap, {}, true}, columnRows.data());
      EXPECT_EQ(columnRows, rows);
      for (std::size_t k = 0; k < block.count(); ++k) {
        const SpanMapping at = mapping.of(k % PixelBlock::kLanes);
        const double parameter = parameters[k / PixelBlock::kLanes];
        const Rgb shown = fromXrgb(rows[k]);
        const auto light = [&](int channel) {
          return lightmap.sample(at.s.at(parameter), at.t.at(parameter),
                                 channels == 1 ? 0 : channel);
        };
        EXPECT_NEAR(shown.r, light(0), 0.525) << k;
        EXPECT_NEAR(shown.g, light(1), 0.525) << k;
        EXPECT_NEAR(shown.b, light(2), 0.525) << k;
      }
    }
  }
}

TEST(PixelKernels, writeNoPixelThatDoesNotShowTheSurface) {
  constexpr std::uint32_t kUntouched = 77;
  std::mt19937 random(1);
  std::uniform_int_distribution<int> anyRow(0, PixelBlock::kRows + 10);
  Image image(1, 2);
  image.at(0, 0) = {1, 2, 3};
  image.makeHole(0, 1);
  const Texture texture(image);
  for (int i = 0; i < 200; ++i) {
    PixelBlock block{};
    block.firstRow = 5;
    block.rows = 1 + i % PixelBlock::kRows;
    setFull(block);
    for (std::size_t lane = 0; lane < PixelBlock::kLanes; ++lane) {
      block.columns.rows.begin[lane] = anyRow(random);
      block.columns.rows.end[lane] = anyRow(random);
    }
    block.columns.fullBegin = std::ranges::max(block.columns.rows.begin);
    block.columns.fullEnd = std::ranges::min(block.columns.rows.end);
    const bool haveHoles = i % 2 == 0;
    for (std::size_t k = 0; haveHoles && k < block.count(); ++k) block.texels[0][k] = k % 3 == 0;
    std::vector<std::uint32_t> rows(block.count(), kUntouched);
    const GroupTexels texels{&texture, false, haveHoles, false};
    fetchColors(block, texels);
    pixelKernels().shade(block, texels, {nullptr, {1, 1, 1}, false}, rows.data());
    for (std::size_t k = 0; k < block.count(); ++k) {
      const int row = block.firstRow + static_cast<int>(k) / PixelBlock::kLanes;
      const std::size_t lane = k % PixelBlock::kLanes;
      const bool isShown = block.columns.rows.begin[lane] <= row &&
                           row < block.columns.rows.end[lane] && block.texels[0][k] == 0;
      ASSERT_EQ(rows[k], isShown ? toXrgb({1, 2, 3}) : kUntouched) << i << ' ' << k;
    }
  }
}

TEST(Shaded, addsEvenLightToEachChannel) {
  EXPECT_EQ(shadedIn({200, 100, 255}, 0, {0.5, 0.25, 1}), (Rgb{100, 25, 255}));
  EXPECT_EQ(shadedIn({200, 100, 255}, 51, {0.5, 0.25, 1}), (Rgb{140, 45, 255}));
  EXPECT_EQ(shadedIn({200, 100, 60}, 255, {0.5, 0.25, 0}), (Rgb{200, 100, 60}));
}

TEST(Shaded, isHalfUp) {
  EXPECT_EQ(shaded({1, 3, 255}, 0, 0.5), (Rgb{1, 2, 128}));
  EXPECT_EQ(shaded({1, 3, 254}, 0, 0.49), (Rgb{0, 1, 124}));
}

TEST(Shaded, losesNoHalfThatAnAuthorsDecimalsMake) {
  for (int percent = 0; percent <= 100; ++percent)
    for (int level = 0; level < 256; ++level) {
      const auto value = static_cast<std::uint8_t>(level);
      const int exact = (level * percent + 50) / 100;
      EXPECT_EQ(shaded({value, 0, 0}, 0, percent / 100.0).r, exact) << level << ' ' << percent;
    }
}

TEST(Shaded, leavesAFullyLitTextureAsItIs) {
  for (int level = 0; level < 256; ++level) {
    const auto value = static_cast<std::uint8_t>(level);
    const Rgb color{value, 255, value};
    EXPECT_EQ(shaded(color, 255, 0), color);
    EXPECT_EQ(shaded(color, 0, 1), color);
    EXPECT_EQ(shaded(color, 200, 0.5), color);
    EXPECT_EQ(shaded({255, value, 0}, value, 0).r, value);
  }
}

}  // namespace
}  // namespace hearth
