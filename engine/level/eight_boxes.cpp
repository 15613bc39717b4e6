#include "level/eight_boxes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace hearth {

namespace {

using Float = std::numeric_limits<float>;

/// Whether single precision says where a ray is along an axis. It does of one that runs across.
bool isInRange(double perUnit) {
  const double size = std::abs(perUnit);
  return std::isinf(size) || (size >= Float::min() && size <= Float::max());
}

}  // namespace

BoxRay::BoxRay(const FaceRay& ray, Vec3 middle, double tFrom, double tTo)
    : tFrom_(floatBelow(tFrom)) {
  endAt(tTo);
  const Vec3 origin = ray.origin() - middle;
  const Vec3 perUnit = ray.perUnit();
  const auto set = [&](std::size_t axis, double from, double per) {
    perUnit_[axis] = static_cast<float>(per);
    // With an origin that is no number, an axis excludes no box.
    above_[axis] = isInRange(per) ? floatAbove(from) : Float::quiet_NaN();
    below_[axis] = isInRange(per) ? floatBelow(from) : Float::quiet_NaN();
  };
  set(0, origin.x, perUnit.x);
  set(1, origin.y, perUnit.y);
  set(2, origin.z, perUnit.z);
}

void BoxRay::endAt(double tTo) { tTo_ = floatAbove(tTo); }

BoxRay::Slabs BoxRay::slabsOf(const EightBoxes& boxes, std::size_t axis) const {
  const EightBoxes::Bounds& min = boxes.min[axis];
  const EightBoxes::Bounds& max = boxes.max[axis];
  return runsDown(axis) ? Slabs{max, min, below_[axis], above_[axis], perUnit_[axis]}
                        : Slabs{min, max, above_[axis], below_[axis], perUnit_[axis]};
}

// Compilers make vectors of the loop, whichever instruction set they compile for. With a choice
// between a bit and 0, g++ 12 does not.
std::uint32_t BoxRay::met(const EightBoxes& boxes) const {
  constexpr float kSlack = 1 + 8 * Float::epsilon();  // three roundings of each end
  constexpr std::array<std::uint32_t, EightBoxes::kCount> kBits{1, 2, 4, 8, 16, 32, 64, 128};
  const Slabs x = slabsOf(boxes, 0);
  const Slabs y = slabsOf(boxes, 1);
  const Slabs z = slabsOf(boxes, 2);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < EightBoxes::kCount; ++i) {
    float tNear = tFrom_;
    float tFar = tTo_;
    x.clip(i, tNear, tFar);
    y.clip(i, tNear, tFar);
    z.clip(i, tNear, tFar);
    const bool isMet = tNear <= tFar * kSlack + Float::min();
    bits |= kBits[i] & (0U - std::uint32_t{isMet});
  }
  return bits;
}

}  // namespace hearth
