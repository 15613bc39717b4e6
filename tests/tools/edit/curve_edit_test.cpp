// Points of a curve that are added and taken out.

#include "viewer/edit/curve_edit.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace hearth {
namespace {

using Curve = std::vector<CurvePoint>;

const Curve kCurve{{0, 210}, {1, 130}, {2.5, 30}, {2.5, 10}};

TEST(CurveEdit, AddsAPointOnTheCurveAsItIs) {
  EXPECT_EQ(withPointBehind(kCurve, 1),
            (Curve{{0, 210}, {1, 130}, {1.75, 80}, {2.5, 30}, {2.5, 10}}));
  EXPECT_EQ(withPointBehind(kCurve, 3).back(), (CurvePoint{3.5, 10}));
}

TEST(CurveEdit, KeepsTheLightAndTheOrderWhereverAPointIsAdded) {
  LightSource before;
  before.curve = {{0, 210}, {0.0003, 130.25}, {0.0004, 130.75}, {1.1111, 3}, {1.1111, 1}, {9, 0.7}};
  for (std::size_t i = 0; i < before.curve.size(); ++i) {
    LightSource after;
    after.curve = withPointBehind(before.curve, i);
    EXPECT_EQ(after.curve.size(), before.curve.size() + 1);
    EXPECT_TRUE(std::ranges::is_sorted(after.curve, {}, &CurvePoint::distance)) << i;
    for (const double distance : {0.0, 0.5, 1.0, 1.2, 4.0, 10.0, 11.0})
      EXPECT_NEAR(after.brightnessAt(distance), before.brightnessAt(distance), 2e-3)
          << i << ' ' << distance;
  }
}

TEST(CurveEdit, TakesAPointOut) {
  EXPECT_EQ(withoutPoint(kCurve, 2), (Curve{{0, 210}, {1, 130}, {2.5, 10}}));
  EXPECT_EQ(withoutPoint({{0, 1}, {2, 3}}, 0), (Curve{{2, 3}}));
}

}  // namespace
}  // namespace hearth
