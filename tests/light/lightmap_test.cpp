#include "light/lightmap.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

const Lightmap kMap{{-1, 4, 3, 2}, {0, 100, 200, 40, 50, 60}};

TEST(Lightmap, givesATexelsOwnLevelAtItsCentre) {
  EXPECT_EQ(kMap.sample(-0.5, 4.5), 0);
  EXPECT_EQ(kMap.sample(0.5, 4.5), 100);
  EXPECT_EQ(kMap.sample(1.5, 5.5), 60);
}

TEST(Lightmap, interpolatesBetweenCentres) {
  EXPECT_DOUBLE_EQ(kMap.sample(0.0, 4.5), 50);
  EXPECT_DOUBLE_EQ(kMap.sample(0.5, 5.0), 75);
  EXPECT_DOUBLE_EQ(kMap.sample(1.0, 5.0), (100 + 200 + 50 + 60) / 4.0);
}

TEST(Lightmap, keepsChannelsApart) {
  const Lightmap map{{0, 0, 2, 2}, {0, 1, 2, 10, 11, 12, 20, 21, 22, 30, 31, 32}, 3};
  EXPECT_EQ(map.at(1, 0, 2), 12);
  for (int channel = 0; channel < 3; ++channel)
    EXPECT_DOUBLE_EQ(map.sample(1, 1, channel), 15 + channel);
}

TEST(Lightmap, isKeptAsOneTexelWhereAllAreTheSame) {
  const Lightmap white = compacted({{-1, 4, 3, 2}, std::vector<std::uint8_t>(6, 7)});
  EXPECT_EQ(white.levels, std::vector<std::uint8_t>{7});
  EXPECT_EQ(white.at(1, 5), 7);
  EXPECT_EQ(white.sample(0.75, 5.0), 7);
  const Lightmap colored = compacted({{0, 0, 2, 2}, {7, 8, 9, 7, 8, 9, 7, 8, 9, 7, 8, 9}, 3});
  EXPECT_EQ(colored.levels, (std::vector<std::uint8_t>{7, 8, 9}));
  EXPECT_EQ(colored.at(1, 1, 2), 9);
}

TEST(Lightmap, isKeptWholeWhereOneTexelDiffers) {
  for (std::size_t i = 0; i < 12; ++i) {
    Lightmap map{{0, 0, 2, 2}, {7, 8, 9, 7, 8, 9, 7, 8, 9, 7, 8, 9}, 3};
    map.levels[i] = 10;
    EXPECT_EQ(compacted(map).levels, map.levels) << i;
  }
}

TEST(Lightmap, ofWhiteLightAnswersForEveryChannel) { EXPECT_EQ(kMap.sample(0.0, 4.5, 2), 50); }

}  // namespace
}  // namespace hearth
