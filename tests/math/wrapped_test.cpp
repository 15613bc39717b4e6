#include "math/wrapped.h"

#include <gtest/gtest.h>

namespace hearth {
namespace {

TEST(Wrapped, IsTheRestOfADivisionThatRoundsDown) {
  EXPECT_EQ(wrapped(0, 5), 0);
  EXPECT_EQ(wrapped(4.999, 5), 4);
  EXPECT_EQ(wrapped(5, 5), 0);
  EXPECT_EQ(wrapped(-0.001, 5), 4);
  EXPECT_EQ(wrapped(-5, 5), 0);
  EXPECT_EQ(wrapped(-1e-300, 7), 6);
}

TEST(Wrapped, StaysWithinTheImageHoweverFarOffItIs) {
  for (const double x : {1e12, 1e15 + 3, 0x1p53 - 1, 0x1p60, 1e300})
    for (const int size : {1, 3, 7, 96, 4095})
      for (const double sign : {1, -1}) {
        EXPECT_GE(wrapped(sign * x, size), 0) << sign * x << ' ' << size;
        EXPECT_LT(wrapped(sign * x, size), size) << sign * x << ' ' << size;
      }
  EXPECT_EQ(wrapped(7e15 + 3, 7), 3);
}

}  // namespace
}  // namespace hearth
