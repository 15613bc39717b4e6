#include "render/frustum.h"

#include <gtest/gtest.h>

#include <random>

namespace hearth {
namespace {

constexpr int kWidth = 320;
constexpr int kHeight = 200;
constexpr PictureRect kRect{{80, 200}, 20, 180};

class FrustumOfARect : public testing::Test {
 protected:
  double number(double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random_);
  }
  Vec3 point(double reach) {
    return {number(-reach, reach), number(-reach, reach), number(-reach, reach)};
  }
  Box3 box() {
    Box3 box;
    const Vec3 at = point(10);
    box.add(at);
    box.add(at + point(3));
    return box;
  }
  Vec3 pointIn(const Box3& box) {
    return {number(box.min.x, box.max.x), number(box.min.y, box.max.y),
            number(box.min.z, box.max.z)};
  }
  Projection projection() {
    const Vec3 eye = point(2);
    return Projection({SectorId(0), eye, number(0, 360), number(-60, 60), 90, kWidth, kHeight},
                      eye);
  }
  /// Whether a point lies in the rectangle, up to so many pixels beside it.
  static bool shows(const Projection& projection, Vec3 p, double beside) {
    const CameraPoint at = projection.toCamera(p.xy());
    if (at.depth <= 0) return false;
    const double column = projection.columnOf(at);
    const double row = projection.rowOf(p.z, at.depth);
    return column >= kRect.columns.begin - beside && column <= kRect.columns.end + beside &&
           row >= kRect.rowBegin - beside && row <= kRect.rowEnd + beside;
  }

  std::mt19937_64 random_{1};
};

TEST_F(FrustumOfARect, mayShowEachBoxOfWhichAPointShows) {
  int shown = 0;
  int hidden = 0;
  for (int i = 0; i < 20000; ++i) {
    const Projection projection = this->projection();
    const Frustum frustum(projection, kRect);
    const Box3 box = this->box();
    hidden += frustum.mayShow(box) ? 0 : 1;
    for (int k = 0; k < 10; ++k) {
      if (!shows(projection, pointIn(box), 0)) continue;
      ASSERT_TRUE(frustum.mayShow(box)) << i;
      ++shown;
    }
  }
  EXPECT_GT(shown, 5000);
  EXPECT_GT(hidden, 10000);
}

TEST_F(FrustumOfARect, holdsNoBoxOfWhichAPointLiesFartherOutside) {
  int held = 0;
  for (int i = 0; i < 20000; ++i) {
    const Projection projection = this->projection();
    const Frustum frustum(projection, kRect);
    const Box3 box = this->box();
    if (!frustum.holds(box)) continue;
    ++held;
    EXPECT_TRUE(frustum.mayShow(box));
    for (int k = 0; k < 10; ++k) EXPECT_TRUE(shows(projection, pointIn(box), 1.001)) << i;
  }
  EXPECT_GT(held, 200);
}

}  // namespace
}  // namespace hearth
