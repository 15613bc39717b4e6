#include "level/face_ray.h"

#include <array>
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

FaceRay::Place FaceRay::placeOf(Vec3 p) const {
  const Vec3 offset = p - origin_;
  const double along = offset.*along_;
  return {{offset.*right_ - along * shear_.x, offset.*up_ - along * shear_.y}, along};
}

std::optional<FaceRay::Crossing> FaceRay::crossingOf(const MeshFace& face) const {
  const std::array<Place, 3> places{placeOf(face.corners[0]), placeOf(face.corners[1]),
                                    placeOf(face.corners[2])};
  const double weight0 = cross(places[1].aside, places[2].aside);
  const double weight1 = cross(places[2].aside, places[0].aside);
  const double weight2 = cross(places[0].aside, places[1].aside);
  const auto [least, most] = std::minmax({weight0, weight1, weight2});
  if (least < 0 && most > 0) return std::nullopt;
  const double sum = weight0 + weight1 + weight2;
  if (!(std::abs(sum) > 0)) return std::nullopt;
  const double along =
      (weight0 * places[0].along + weight1 * places[1].along + weight2 * places[2].along) / sum;
  return Crossing{along * perAlong_, sum > 0};
}

}  // namespace hearth
