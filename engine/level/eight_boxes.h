#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "level/face_ray.h"
#include "level/float_box.h"
#include "math/box3.h"
#include "math/vec.h"

namespace hearth {

/// Up to eight boxes in single precision, so that a ray is tested against all of them at once. They
/// are relative to a point near them all.
struct EightBoxes {
  static constexpr std::size_t kCount = 8;
  using Bounds = std::array<float, kCount>;

  std::array<Bounds, 3> min;  ///< along x, y and z
  std::array<Bounds, 3> max;

  void set(std::size_t i, const FloatBox& box) {
    for (std::size_t axis = 0; axis < min.size(); ++axis) {
      min[axis][i] = box.min[axis];
      max[axis][i] = box.max[axis];
    }
  }
  Box3 operator[](std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }
};

/// A part of a ray that meets such boxes. Where it does, the answer is so whatever the rounding;
/// rarely it is so of a box beside the ray. All of its arithmetic is the same on every machine.
class BoxRay {
 public:
  /// The part from `tFrom` to `tTo`; boxes are relative to `middle`. `tFrom` is not negative.
  BoxRay(const FaceRay& ray, Vec3 middle, double tFrom, double tTo);

  void endAt(double tTo);
  /// Along an axis: 0 is x.
  bool runsDown(std::size_t axis) const { return perUnit_[axis] < 0; }
  /// A bit for each box that it may meet. Bits of boxes that are not set mean nothing.
  std::uint32_t met(const EightBoxes& boxes) const;

 private:
  /// Of the boxes along one axis, as the ray comes through them.
  struct Slabs {
    const EightBoxes::Bounds& near;
    const EightBoxes::Bounds& far;
    float toNear;  ///< seen from here
    float toFar;
    float perUnit;

    // Of a ray that runs within a side of a box a product may be no number, which changes nothing.
    void clip(std::size_t i, float& tNear, float& tFar) const {
      tNear = std::max(tNear, (near[i] - toNear) * perUnit);
      tFar = std::min(tFar, (far[i] - toFar) * perUnit);
    }
  };
  Slabs slabsOf(const EightBoxes& boxes, std::size_t axis) const;

  // By axis. The origin is rounded up where lower bounds are seen from it, else down.
  std::array<float, 3> above_;
  std::array<float, 3> below_;
  std::array<float, 3> perUnit_;
  float tFrom_;
  float tTo_;
};

}  // namespace hearth
