#include "level/face_ray.h"

#include <cmath>
#include <utility>

namespace hearth {

FaceRay::FaceRay(Vec3 origin, Vec3 direction)
    : origin_(origin),
      perUnit_{1 / direction.x, 1 / direction.y, 1 / direction.z},
      along_(&Vec3::z),
      right_(&Vec3::x),
      up_(&Vec3::y) {
  const auto isLonger = [&](double Vec3::*a, double Vec3::*b) {
    return std::abs(direction.*a) > std::abs(direction.*b);
  };
  if (isLonger(&Vec3::x, along_)) along_ = &Vec3::x, right_ = &Vec3::y, up_ = &Vec3::z;
  if (isLonger(&Vec3::y, along_)) along_ = &Vec3::y, right_ = &Vec3::z, up_ = &Vec3::x;
  // So that the front of a face turns the same way whichever way the ray goes.
  if (direction.*along_ < 0) std::swap(right_, up_);
  perAlong_ = 1 / direction.*along_;
  shear_ = perAlong_ * Vec2{direction.*right_, direction.*up_};
}

}  // namespace hearth
