#include "light/baking/light_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace hearth {
namespace {

std::uint8_t meanOf(const std::vector<double>& levels, int samples) {
  LightSum sum;
  for (const double level : levels) sum.add(level);
  return sum.mean(samples);
}

TEST(LightSum, addsLightsTooWeakToShowAlone) {
  EXPECT_EQ(meanOf(std::vector<double>(255, 0.4), 1), 102);
}

TEST(LightSum, doesNotDependOnOrder) {
  std::mt19937 random(7);
  std::vector<double> levels;
  for (int i = 0; i < 1000; ++i) levels.push_back(static_cast<double>(random() % 1000) / 3777.0);
  const std::uint8_t expected = meanOf(levels, 1);
  for (int i = 0; i < 20; ++i) {
    std::shuffle(levels.begin(), levels.end(), random);
    EXPECT_EQ(meanOf(levels, 1), expected);
  }
}

TEST(LightSum, roundsHalfUpOnce) {
  EXPECT_EQ(meanOf({0.5}, 1), 1);
  EXPECT_EQ(meanOf({0.499}, 1), 0);
  EXPECT_EQ(meanOf({254.49999}, 1), 254);
  EXPECT_EQ(meanOf({1, 0, 0, 1}, 4), 1);
  EXPECT_EQ(meanOf({1, 0, 0, 0}, 4), 0);
}

TEST(LightSum, clampsTheMeanAndNotTheSamples) {
  EXPECT_EQ(meanOf({510, 0}, 2), 255) << "half of the texel at twice full light";
  EXPECT_EQ(meanOf({1000}, 1), 255);
}

TEST(LightSum, survivesAbsurdIntensities) {
  EXPECT_EQ(meanOf(std::vector<double>(10'000, 1e38), 1), 255);
  EXPECT_EQ(meanOf({1e-30}, 1), 0);
  std::vector<double> oneOfMany(4096, 0.0);
  oneOfMany[7] = 1e9;
  EXPECT_EQ(meanOf(oneOfMany, 4096), 255) << "clamped only after the mean";
}

}  // namespace
}  // namespace hearth
