// As families_test.cpp, over more levels.

#include <gtest/gtest.h>

#include "families.h"

namespace hearth::extremes {
namespace {

constexpr std::uint64_t kFirst = 20;
constexpr std::uint64_t kLast = 140;

TEST(SameLevels, underOtherNamesAndInAnotherOrder) {
  LightDifference light;
  for (std::uint64_t seed = kFirst; seed <= kLast; ++seed) {
    expectNamesMeanNothing(seed);
    light += expectOrderMeansLittle(seed);
  }
  EXPECT_LE(light.over2 * 100'000, light.pixels) << light.over2;
}

TEST(SameLevels, withEveryWallCutInTwo) {
  for (std::uint64_t seed = kFirst; seed <= kLast; ++seed) expectCutsMeanNothing(seed);
}

TEST(SameLevels, wherever) {
  LightDifference light;
  for (std::uint64_t seed = kFirst; seed <= kLast; ++seed)
    for (const double metres : {0x1p7, 0x1p14, 0x1p20, 3e6})
      light += expectDistanceMeansLittle(seed, metres);
  EXPECT_LE(light.over2 * 100'000, light.pixels) << light.over2;
}

TEST(SameLevels, ofAnySize) {
  // Of this one a sample lies in a corner in which an opening begins, a micrometre off it whatever
  // the size, and so now in the shadow of the lattice that hangs there, now not.
  constexpr std::uint64_t kLatticeInTheCorner = 85;
  LightDifference light;
  LightDifference underSky;
  int alike = 0;
  for (std::uint64_t seed = kFirst; seed <= kLast; ++seed) {
    (hasLightOfSky(seed) ? underSky : light) += expectSmallnessMeansLittle(seed);
    if (seed != kLatticeInTheCorner) alike += expectLargenessMeansNothing(seed);
  }
  EXPECT_LE(light.over2 * 10'000, light.pixels) << light.over2;
  // Whether its lattice divides a cell may hang on the micrometre.
  EXPECT_LE(underSky.over2 * 200, underSky.pixels) << underSky.over2;
  EXPECT_GE(alike, 40);
}

TEST(SameLevels, turnedAndMirrored) {
  // Of this one two slopes, whose heights are written in tenths of a millimetre, miss each other by
  // 8 micrometres at their seam. Turned by 137.9 degrees, a sample lies in the shadow of that step.
  constexpr std::uint64_t kStepInTheSeam = 124;
  for (std::uint64_t seed = kFirst; seed <= kLast; ++seed) {
    expectDirectionMeansNothing(seed, 90);
    if (seed != kStepInTheSeam) expectDirectionMeansNothing(seed, 137.9);
    expectHandednessMeansNothing(seed);
  }
}

}  // namespace
}  // namespace hearth::extremes
