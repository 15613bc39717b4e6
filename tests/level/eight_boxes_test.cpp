// Boxes in single precision, as rays meet them.

#include "level/eight_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace hearth {
namespace {

class EightBoxesTest : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vec3 point(double size) {
    return {number(-size, size), number(-size, size), number(-size, size)};
  }

  std::mt19937_64 random_{11};
};

EightBoxes filledWith(const Box3& box) {
  EightBoxes boxes{};
  for (std::size_t i = 0; i < EightBoxes::kCount; ++i) boxes.set(i, FloatBox::around(box));
  return boxes;
}

bool isMet(const Box3& box, Vec3 origin, Vec3 direction, double tFrom = 0, double tTo = 1) {
  const std::uint32_t bits =
      BoxRay(FaceRay(origin, direction), {}, tFrom, tTo).met(filledWith(box));
  EXPECT_TRUE(bits == 0 || bits == 0xff);
  return bits != 0;
}

constexpr Box3 kCube{{-1, -1, -1}, {1, 1, 1}};

TEST_F(EightBoxesTest, holdWhatIsRoundedToThem) {
  for (const double size : {1e-42, 1e-9, 1.0, 1e9, 1e37, 1e300})
    for (int i = 0; i < 100; ++i) {
      Box3 box;
      box.add(point(size));
      box.add(point(size));
      Box3 grown = filledWith(box)[5];
      const Box3 before = grown;
      grown.add(box);
      EXPECT_EQ(grown, before) << size;
    }
}

TEST_F(EightBoxesTest, areMetByRaysToPointsInThem) {
  for (const double size : {1e-3, 1.0, 1e3, 1e6})
    for (int i = 0; i < 2000; ++i) {
      Box3 box;
      box.add(point(size));
      // Some of them are flat, or lines.
      Vec3 other = point(size);
      if (i % 3 == 0) other.x = box.min.x;
      if (i % 5 == 0) other.z = box.min.z;
      box.add(other);
      const auto between = [&](double low, double high) {
        const double k = i % 7 == 0 ? 1.0 : number(0, 1);
        return std::clamp(low + k * (high - low), low, high);
      };
      const Vec3 target{between(box.min.x, box.max.x), between(box.min.y, box.max.y),
                        between(box.min.z, box.max.z)};
      Vec3 origin = 2.0 * point(size);
      if (i % 11 == 0) origin.y = target.y;
      if (i % 13 == 0) origin.x = target.x;
      const Vec3 direction = target - origin;
      EXPECT_TRUE(isMet(box, origin, 2 * direction));
      EXPECT_TRUE(isMet(box, origin, direction, 0, 1));
      EXPECT_TRUE(isMet(box, origin, direction, 1, 2));
    }
}

TEST_F(EightBoxesTest, areNotMetByRaysBesideThemOrThatEndBefore) {
  constexpr double kBeside = 1.00001;
  for (const double sign : {-1.0, 1.0}) {
    EXPECT_FALSE(isMet(kCube, {sign * kBeside, 0, -5}, {0, 0, 10}));
    EXPECT_FALSE(isMet(kCube, {0, -5, sign * kBeside}, {0, 10, 0}));
    EXPECT_FALSE(isMet(kCube, {-5, sign * kBeside, 0}, {10, 0, -0.0}));
    EXPECT_TRUE(isMet(kCube, {sign, 0, -5}, {0, 0, 10}));
    EXPECT_TRUE(isMet(kCube, {sign, 0, -5}, {0, -0.0, 10}));
    EXPECT_FALSE(isMet(kCube, {sign * 5, 0, 0}, {-sign, 0, 0}, 0, 3.9999));
    EXPECT_TRUE(isMet(kCube, {sign * 5, 0, 0}, {-sign, 0, 0}, 0, 4));
    EXPECT_TRUE(isMet(kCube, {sign * 5, 0, 0}, {-sign, 0, 0}, 6, 9));
    EXPECT_FALSE(isMet(kCube, {sign * 5, 0, 0}, {-sign, 0, 0}, 6.0001, 9));
    EXPECT_FALSE(isMet(kCube, {sign * 5, 0, 0}, {sign, 0, 0}, 0, 100));
  }
}

TEST_F(EightBoxesTest, areMetWhateverTheLengthOfTheDirection) {
  for (double scale = 1e-300; scale < 1e300; scale *= 1e10) {
    const double tTo = 10 / scale;
    EXPECT_TRUE(isMet(kCube, {-5, 0.5, 0.25}, {scale, 0, 0}, 0, tTo)) << scale;
    EXPECT_TRUE(isMet(kCube, {-5, 0.5, 0.25}, {scale, 1e-3 * scale, -1e-30 * scale}, 0, tTo));
    EXPECT_TRUE(isMet(kCube, {-5, 0.5, 0}, {1, std::min(0.1, scale), 0}, 0, 4)) << scale;
  }
  constexpr double kEndless = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(isMet(kCube, {-5, 0, 0}, {1, 0, 0}, 0, kEndless));
  EXPECT_FALSE(isMet(kCube, {-5, 0, 0}, {-1, 0, 0}, 0, kEndless));
}

TEST_F(EightBoxesTest, areSeenFromNearTheirMiddle) {
  const Vec3 middle{1e6, -2e6, 3e6};
  const EightBoxes boxes = filledWith(kCube);
  const auto isMetFrom = [&](double y) {
    const FaceRay ray(middle + Vec3{-5, y, 0}, {10, 0, 0});
    return BoxRay(ray, middle, 0, 1).met(boxes) != 0;
  };
  EXPECT_TRUE(isMetFrom(1));
  EXPECT_FALSE(isMetFrom(1.00001));
}

TEST_F(EightBoxesTest, areMetUpToWhereTheRayIsMovedTo) {
  BoxRay ray(FaceRay({-5, 0, 0}, {1, 0, 0}), {}, 0, 3);
  const EightBoxes boxes = filledWith(kCube);
  EXPECT_EQ(ray.met(boxes), 0U);
  ray.endAt(4);
  EXPECT_EQ(ray.met(boxes), 0xffU);
  EXPECT_FALSE(ray.runsDown(0));
  EXPECT_TRUE(BoxRay(FaceRay({}, {1, 2, -1e-300}), {}, 0, 1).runsDown(2));
}

TEST_F(EightBoxesTest, areMetOneByOne) {
  EightBoxes boxes{};
  for (std::size_t i = 0; i < EightBoxes::kCount; ++i) {
    const double x = static_cast<double>(i);
    boxes.set(i, FloatBox::around({{x, 0, 0}, {x + 0.5, 1, 1}}));
  }
  const FaceRay ray({1.75, 0.5, 0.5}, {10, 0, 0});
  EXPECT_EQ(BoxRay(ray, {}, 0, 0.35).met(boxes), 0b00111100U);
}

}  // namespace
}  // namespace hearth
