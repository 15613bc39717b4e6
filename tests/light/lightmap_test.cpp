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

}  // namespace
}  // namespace hearth
