// The steps from rows to pixels, one by one.

#include "render/row_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "row_batches.h"

namespace hearth {
namespace {

using test::setRows;

/// The column of an image of so many that texel coordinate `x` falls into.
int repeated(double x, int size) {
  RowBatch batch{};
  setRows(batch, {0});
  rowKernels().findTexels(batch, {.u = {.place = {x, 0}}}, Texture(Image(size, 1)));
  return batch.texels.upperLeft[0];
}

/// A pixel of this colour in light that is the same everywhere.
Rgb shaded(Rgb color, std::uint8_t level, double sectorLight) {
  const Lightmap even{.rect = {0, 0, 1, 1}, .levels = {level}};
  RowBatch batch{};
  batch.count = 1;
  rowKernels().showEvenly(batch, &even, sectorLight);
  Pixel pixel = 0;
  rowKernels().shadeColor(&pixel, batch, color);
  return colorOf(pixel);
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

/// The number of a texel in a large lightmap is no float.
TEST(RowKernels, findTexelsOfLargeLightmaps) {
  Lightmap lightmap;
  lightmap.rect = {0, 0, 5001, 4001};
  lightmap.channels = 3;
  RowBatch batch{};
  setRows(batch, {4000.25, 3999.75});
  rowKernels().findLightTexels(batch, {.isPlane = true, .s = {4800.5, 0}, .t = {0.5, 1}}, lightmap,
                               LightFilter::Bilinear);
  EXPECT_EQ(batch.lightTexels[0], 3U * (3999 * 5001 + 4800));
  EXPECT_EQ(batch.lightTexels[1], 3U * (3999 * 5001 + 4800));
  EXPECT_EQ(batch.betweenLightTexels.down[0], 1);
  EXPECT_EQ(batch.betweenLightTexels.down[1], 0.75F);
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

TEST(RowKernels, findTheTexelsThatAModuloOfEachRowGives) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1e6, 1e6);
  for (const int width : {1, 7, 64, 100})
    for (const int height : {1, 3, 128, 1000}) {
      std::vector<double> parameters;
      for (std::size_t i = 0; i < RowBatch::kRows - 1; ++i)
        parameters.push_back(i % 3 == 0 ? std::round(anywhere(random)) : anywhere(random));
      std::ranges::sort(parameters);
      RowBatch batch{};
      setRows(batch, parameters);
      rowKernels().findTexels(
          batch, {.isPlane = true, .u = {.place = {0.25, 1}}, .v = {.place = {-3, 0.5}}},
          Texture(Image(width, height)));
      for (std::size_t k = 0; k < batch.count; ++k) {
        EXPECT_EQ(batch.texels.upperLeft[k] / height, modulo(0.25 + parameters[k], width));
        EXPECT_EQ(batch.texels.upperLeft[k] % height, modulo(-3 + parameters[k] * 0.5, height));
      }
    }
}

/// Measures at which a coordinate is a whole texel, apart from roundings and 2^-20 to 2^-40 of one.
std::vector<double> parametersNearTexels(const ImageAxis& along, std::mt19937& random) {
  std::uniform_int_distribution<int> texels(-3000, 3000);
  std::uniform_int_distribution<int> bits(20, 40);
  std::vector<double> parameters;
  for (std::size_t i = 0; i < RowBatch::kRows; ++i) {
    const double beside = std::ldexp(static_cast<double>(i % 3) - 1, -bits(random));
    const double place =
        (texels(random) + beside + along.offset) / along.texelsPerPlace + along.origin;
    parameters.push_back((place - along.place.atZero) / along.place.per);
  }
  std::ranges::sort(parameters);
  return parameters;
}

TEST(RowKernels, findTheTexelsOfEachRowHoweverNearToTheNextTheyAre) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> places(-200, 200);
  std::uniform_real_distribution<double> scales(0.1, 100);
  const auto someAxis = [&] {
    return ImageAxis{{places(random), scales(random)}, places(random), scales(random), 7.25};
  };
  for (int i = 0; i < 300; ++i)
    for (const auto& [width, height] : {std::pair(64, 128), {1, 2}, {65536, 1}, {72, 100}, {3, 64}})
      for (const bool isPlane : {false, true}) {
        const SpanMapping mapping{.isPlane = isPlane, .u = someAxis(), .v = someAxis()};
        RowBatch batch{};
        setRows(batch, parametersNearTexels(i % 2 == 0 ? mapping.u : mapping.v, random));
        const Texture image(Image(width, height));
        rowKernels().findTexels(batch, mapping, image);
        for (std::size_t k = 0; k < batch.count; ++k) {
          const double u = mapping.u.at(isPlane ? batch.parameters[k] : 0);
          const double v = mapping.v.at(batch.parameters[k]);
          ASSERT_EQ(batch.texels.upperLeft[k], modulo(u, width) * height + modulo(v, height))
              << u << ' ' << v << ' ' << width << 'x' << height;
        }
      }
}

TEST(RowKernels, findDepthsThatAreThoseOfEachRow) {
  const SpanMapping slope{.isPlane = true, .height = -1.5, .rise = 0.125, .depth = 20};
  std::vector<double> raySlopes;
  for (int row = 0; row < 100; ++row) raySlopes.push_back((50 - row) / 160.0);
  RowBatch batch{};
  setRows(batch, raySlopes);
  rowKernels().findDepths(batch, slope, batch.parameters);
  for (std::size_t k = 0; k < batch.count; ++k)
    EXPECT_EQ(batch.parameters[k], slope.depthAt(raySlopes[k])) << k;
}

TEST(RowKernels, findPlacesInALightmapAndKeepThemThere) {
  const Lightmap lightmap{.rect = {-2, 5, 4, 3}, .levels = std::vector<std::uint8_t>(12)};
  RowBatch batch{};
  setRows(batch, {-100, -1.5, -1.25, 1.5, 100});
  rowKernels().findLightTexels(batch, {.isPlane = true, .s = {0, 1}, .t = {6.75, 0}}, lightmap,
                               LightFilter::Bilinear);
  const std::vector<std::size_t> columns{0, 0, 0, 2, 2};
  const std::vector<double> fractions{0, 0, 0.25, 1, 1};
  for (std::size_t k = 0; k < batch.count; ++k) {
    EXPECT_EQ(batch.lightTexels[k], 4 + columns[k]) << k;
    EXPECT_EQ(batch.betweenLightTexels.across[k], fractions[k]) << k;
    EXPECT_EQ(batch.betweenLightTexels.down[k], 0.25F);
  }
}

/// The levels that are shown at the centres of a lightmap's texels, row by row.
std::vector<Rgb> levelsShown(const Lightmap& lightmap) {
  std::vector<Rgb> found;
  for (int row = 0; row < lightmap.rect.height; ++row)
    for (int column = 0; column < lightmap.rect.width; ++column) {
      RowBatch batch{};
      setRows(batch, {0});
      rowKernels().findLightTexels(batch, {.s = {column + 0.5, 0}, .t = {row + 0.5, 0}}, lightmap,
                                   LightFilter::Bilinear);
      rowKernels().findShown(batch, lightmap, 0);
      Pixel pixel = 0;
      rowKernels().shadeColor(&pixel, batch, {255, 255, 255});
      found.push_back(colorOf(pixel));
    }
  return found;
}

TEST(RowKernels, showEachTexelOfALightmapInItsChannels) {
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

TEST(RowKernels, writeNoPixelBehindTheLastRow) {
  for (std::size_t rows = 1; rows <= RowBatch::kRows; ++rows) {
    RowBatch batch{};
    batch.count = rows;
    rowKernels().showEvenly(batch, nullptr, 1);
    std::vector<Pixel> pixels(rows + RowBatch::kMaxLanes, 77);
    rowKernels().shadeColor(pixels.data(), batch, {1, 2, 3});
    for (std::size_t k = 0; k < pixels.size(); ++k)
      ASSERT_EQ(colorOf(pixels[k]), (k < rows ? Rgb{1, 2, 3} : Rgb{77, 0, 0})) << rows << ' ' << k;
  }
}

TEST(Shaded, isHalfUp) {
  EXPECT_EQ(shaded({1, 3, 255}, 0, 0.5), (Rgb{1, 2, 128}));
  EXPECT_EQ(shaded({1, 3, 254}, 0, 0.498), (Rgb{0, 1, 126}));
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
