// What a level looks like does not depend on how and where it is written: see families.h.

#include "families.h"

#include <gtest/gtest.h>

namespace hearth::extremes {
namespace {

TEST(SameLevel, underOtherNames) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) expectNamesMeanNothing(seed);
}

TEST(SameLevel, withSectorsAndLightsInAnotherOrder) {
  LightDifference light;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) light += expectOrderMeansLittle(seed);
  EXPECT_LE(light.over2 * 100'000, light.pixels) << light.over2;
}

TEST(SameLevel, withEveryWallCutInTwo) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) expectCutsMeanNothing(seed);
}

TEST(SameLevel, byAnyNumberOfThreads) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) expectThreadsMeanNothing(seed);
}

TEST(SameLevel, atAnyDistanceUpToAThousandKilometres) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    for (const double metres : {0x1p7, 0x1p14, 0x1p20}) expectPlaceMeansNothing(seed, metres);
}

TEST(SameLevel, atTheFarthestDistanceButForRounding) {
  LightDifference light;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) light += expectDistanceMeansLittle(seed, 3e6);
  EXPECT_EQ(light.over2, 0);
}

TEST(SameLevel, ofAThousandthOfItsSizeButForAMicrometre) {
  // Rays arrive a micrometre inside edges, which here is a hundredth of a texel.
  LightDifference light;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) light += expectSmallnessMeansLittle(seed);
  EXPECT_LE(light.over2 * 10'000, light.pixels) << light.over2;
}

TEST(SameLevel, ofAThousandTimesItsSize) {
  int alike = 0;
  for (std::uint64_t seed = 1; seed <= 15; ++seed) alike += expectLargenessMeansNothing(seed);
  EXPECT_GE(alike, 6);
}

TEST(SameLevel, turnedByQuartersAndByOddAngles) {
  for (const double degrees : {90.0, 180.0, 270.0, 1.0, 37.3})
    for (std::uint64_t seed = 1; seed <= 2; ++seed) expectDirectionMeansNothing(seed, degrees);
}

TEST(SameLevel, inAMirror) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) expectHandednessMeansNothing(seed);
}

TEST(SameLevel, withASectorOfAllFeaturesThatNobodySees) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) expectUnseenSectorMeansNothing(seed);
}

}  // namespace
}  // namespace hearth::extremes
