#include "render/frustum.h"

#include <algorithm>

namespace hearth {

Frustum::Frustum(const Projection& projection, const PictureRect& rect) : eye_(projection.eye()) {
  // A pixel wider, so that nothing is left to rounding.
  const Vec2 left = projection.rayOf(rect.columns.begin - 1);
  const Vec2 right = projection.rayOf(rect.columns.end + 1);
  const Vec2 ahead = projection.direction();
  const double up = projection.raySlopeAt(rect.rowBegin - 1);
  const double down = projection.raySlopeAt(rect.rowEnd + 1);
  const Vec2 fromLeft = turned90(left);
  const Vec2 fromRight = -1 * turned90(right);
  inwards_ = {Vec3{fromLeft.x, fromLeft.y, 0}, Vec3{fromRight.x, fromRight.y, 0},
              Vec3{up * ahead.x, up * ahead.y, -1}, Vec3{-down * ahead.x, -down * ahead.y, 1},
              Vec3{ahead.x, ahead.y, 0}};
}

bool Frustum::mayShow(const Box3& box) const {
  return std::ranges::all_of(
      inwards_, [&](Vec3 inwards) { return dot(inwards, box.farthest(inwards) - eye_) >= 0; });
}

bool Frustum::holds(const Box3& box) const {
  return std::ranges::all_of(
      inwards_, [&](Vec3 inwards) { return dot(inwards, box.farthest(-1 * inwards) - eye_) > 0; });
}

}  // namespace hearth
