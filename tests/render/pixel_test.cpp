#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "render/lit_pixel.h"
#include "row_batches.h"

namespace hearth {
namespace {

using test::batchOf;

Rgb shaded(Rgb color, double level, double sectorLight) {
  Rgb pixel;
  putShaded(&pixel, channelsOf(color),
            lightShares(sameChannels(static_cast<float>(level)),
                        sameChannels(static_cast<float>(sectorLight))));
  return pixel;
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

TEST(Repeated, staysInTheImageHoweverFarAway) {
  for (const double x : {1e15, -1e15, 1e16, 1e19, -1e19, 1e300, -1e300})
    for (const int size : {1, 3, 64, 100, 67108863}) {
      EXPECT_GE(repeated(x, size), 0) << x << ' ' << size;
      EXPECT_LT(repeated(x, size), size) << x << ' ' << size;
    }
}

TEST(RowBatch, findsTheTexelsThatAModuloOfEachRowGives) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> anywhere(-1e6, 1e6);
  for (const int width : {1, 7, 64, 100})
    for (const int height : {1, 3, 128, 1000}) {
      std::vector<double> measures;
      for (std::size_t i = 0; i < RowBatch::kRows - 1; ++i)
        measures.push_back(i % 3 == 0 ? std::round(anywhere(random)) : anywhere(random));
      RowBatch batch = batchOf(measures);
      findTexels(batch, {.u = {.place = {0.25, 1}}, .v = {.place = {-3, 0.5}}},
                 Image(width, height));
      const auto modulo = [](double x, int size) {
        const double rest = std::fmod(std::floor(x), size);
        return static_cast<int>(rest < 0 ? rest + size : rest);
      };
      for (std::size_t k = 0; k < measures.size(); ++k) {
        EXPECT_EQ(batch.texelColumn.texel[k], modulo(0.25 + measures[k], width));
        EXPECT_EQ(batch.texelRow.texel[k], modulo(-3 + measures[k] * 0.5, height));
      }
    }
}

TEST(RowBatch, findsPlacesInALightmapAndKeepsThemThere) {
  const TexelRect rect{-2, 5, 4, 3};
  RowBatch batch = batchOf({-100, -1.5, -1.25, 1.5, 100});
  findLightPlaces(batch, {.s = {0, 1}, .t = {6.75, 0}}, rect);
  const std::vector<int> columns{0, 0, 0, 2, 2};
  const std::vector<double> shares{0, 0, 0.25, 1, 1};
  for (std::size_t k = 0; k < batch.count; ++k) {
    EXPECT_EQ(batch.lightColumn.texel[k], columns[k]) << k;
    EXPECT_EQ(batch.lightColumn.share[k], shares[k]) << k;
    EXPECT_EQ(batch.lightRow.texel[k], 1);
    EXPECT_EQ(batch.lightRow.share[k], 0.25F);
  }
}

TEST(LightTexel, hasItsChannels) {
  const std::vector<std::uint8_t> levels{0, 1, 255, 10};
  alignas(16) float found[4];
  _mm_store_ps(found, lightTexel<3>(levels.data() + 1));
  EXPECT_EQ(found[0], 1);
  EXPECT_EQ(found[1], 255);
  EXPECT_EQ(found[2], 10);
  _mm_store_ps(found, lightTexel<1>(levels.data() + 2));
  for (int channel = 0; channel < 3; ++channel) EXPECT_EQ(found[channel], 255);
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
