#include "measure/tradeoff/errors.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hearth {
namespace {

/// Grey of 100 levels in light of half.
TruthPicture grey(int width, int height) {
  TruthPicture truth;
  truth.picture = Image(width, height, {100, 100, 100});
  truth.light.assign(truth.picture.pixels().size(), Vec3{127.5, 127.5, 127.5});
  return truth;
}

Image light(const TruthPicture& truth) {
  return {truth.picture.width(), truth.picture.height(), {128, 128, 128}};
}

TEST(Errors, areThoseOfRoundingWhereAllIsAsTruthShows) {
  const TruthPicture truth = grey(16, 8);
  ErrorSums sums;
  sums.add(truth, truth.picture, light(truth));
  const auto [ofLight, ofPicture] = sums.errors();
  EXPECT_DOUBLE_EQ(ofLight.max, 0.5);
  EXPECT_DOUBLE_EQ(ofLight.rms, 0.5);
  EXPECT_EQ(ofPicture.over2, 0);
  EXPECT_EQ(ofPicture.largestPatch, 0);
  EXPECT_TRUE(std::isinf(ofPicture.psnr));
  EXPECT_DOUBLE_EQ(ofPicture.ssim, 1);
}

TEST(Errors, areFractionsOfThePixelsOfAllPictures) {
  const TruthPicture truth = grey(10, 10);
  Image lit = truth.picture;
  for (int i = 0; i < 3; ++i) lit.at(i, 0) = {109, 100, 100};  // over 8, in one patch
  lit.at(9, 9) = {100, 100, 110};
  lit.at(5, 5) = {100, 97, 100};  // over 2 alone
  lit.at(6, 5) = {102, 100, 100};
  ErrorSums sums;
  sums.add(truth, lit, light(truth));
  sums.add(truth, truth.picture, light(truth));
  const PictureError error = sums.errors().picture;
  EXPECT_DOUBLE_EQ(error.over2, 5 / 200.0);
  EXPECT_DOUBLE_EQ(error.over8, 4 / 200.0);
  EXPECT_EQ(error.largestPatch, 3);
  EXPECT_LT(error.ssim, 1);
  const double squares = (3 * 81 + 100 + 9 + 4) / 3.0 / 200;
  EXPECT_NEAR(error.rms, std::sqrt(squares), 1e-12);
  EXPECT_NEAR(error.psnr, 10 * std::log10(255 * 255 / squares), 1e-9);
}

TEST(Errors, ofLightAreThoseOfTheChannelThatIsFarthestOff) {
  const TruthPicture truth = grey(10, 10);
  Image drawn = light(truth);
  drawn.at(3, 3) = {128, 0, 137};
  ErrorSums sums;
  sums.add(truth, truth.picture, drawn);
  const LightError error = sums.errors().light;
  EXPECT_DOUBLE_EQ(error.max, 127.5);
  EXPECT_DOUBLE_EQ(error.p99, 0.5) << "one pixel of a hundred is more";
}

}  // namespace
}  // namespace hearth
