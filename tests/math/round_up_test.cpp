#include "math/round_up.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hearth {
namespace {

TEST(RoundedUp, isThatOfTheStandardLibrary) {
  for (const double whole : {0.0, 1.0, 2.0, 1079.0, 2147483000.0})
    for (const double x : {whole, std::nextafter(whole, 1e10), whole + 0.25, whole + 0.5,
                           std::nextafter(whole + 1, 0)})
      EXPECT_EQ(roundedUp(x), static_cast<int>(std::ceil(x))) << x;
}

}  // namespace
}  // namespace hearth
