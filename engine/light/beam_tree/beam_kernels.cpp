// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: every lane is a beam or a
// sample of its own, and multiplications and additions are never fused.

#include "light/beam_tree/beam_kernels.h"

#include <algorithm>
#include <bit>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/beam_tree/beam_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/sampling/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

/// How far in front of a plane the hindmost and the foremost corner are.
template <typename D>
struct InFront {
  hn::Vec<D> least;
  hn::Vec<D> most;
};

/// In lanes that are beams: of an upright plane through the light.
template <typename D>
HWY_INLINE InFront<D> inFrontOfSide(D d, const CornerOffsets& corners, hn::Vec<D> normalX,
                                    hn::Vec<D> normalY) {
  const auto inFront = [&](std::size_t k) HWY_ATTR {
    return hn::Add(hn::Mul(hn::Set(d, corners.x[k]), normalX),
                   hn::Mul(hn::Set(d, corners.y[k]), normalY));
  };
  auto least = inFront(0);
  auto most = least;
  for (std::size_t k = 1; k < corners.count; ++k) {
    const auto next = inFront(k);
    least = hn::Min(least, next);
    most = hn::Max(most, next);
  }
  return {least, most};
}

std::size_t findSpanning(const CornerOffsets& corners, const BeamSides& beams, std::size_t count,
                         double margin, SpanningBeam* spanning) {
  std::size_t found = 0;
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto bitsOf = [d](auto mask) HWY_ATTR {
      std::uint8_t bits[8] = {};
      hn::StoreMaskBits(d, mask, bits);
      return std::uint32_t{bits[0]};
    };
    const auto most = hn::Set(d, margin);
    const auto ofBegin =
        inFrontOfSide(d, corners, hn::LoadU(d, beams.beginX + k), hn::LoadU(d, beams.beginY + k));
    const auto ofEnd =
        inFrontOfSide(d, corners, hn::LoadU(d, beams.endX + k), hn::LoadU(d, beams.endY + k));
    const auto least = hn::Neg(most);
    std::uint32_t left = bitsOf(hn::And(hn::Ge(ofBegin.most, least), hn::Ge(ofEnd.most, least)));
    if (left == 0) return;
    const std::uint32_t atBegin = bitsOf(hn::Le(ofBegin.least, most));
    const std::uint32_t atEnd = bitsOf(hn::Le(ofEnd.least, most));
    for (; left != 0; left &= left - 1) {
      const auto lane = static_cast<std::uint32_t>(std::countr_zero(left));
      spanning[found++] = {static_cast<std::uint32_t>(k) + lane,
                           (atBegin >> lane & 1) | (atEnd >> lane & 1) << 1};
    }
  });
  return found;
}

std::uint32_t findStraddled(const CornerOffsets& corners, const BeamBounds& bounds,
                            std::uint32_t asked, double margin, double reach) {
  using Tag = hn::CappedTag<double, 8>;
  const Tag d;
  std::uint32_t straddled = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const std::uint32_t bit = std::uint32_t{1} << std::min(i, kBoundBits - 1);
    if ((asked & bit) == 0) continue;
    const BeamBound bound = bounds[i];
    const double slack = bound.slack(margin, reach);
    bool isAnyNear = false;
    bool areAllInFront = true;
    for (std::size_t k = 0; k < corners.count; k += hn::Lanes(d)) {
      const Offsets<Tag> offsets = {hn::LoadU(d, corners.x + k), hn::LoadU(d, corners.y + k),
                                    hn::LoadU(d, corners.z + k)};
      const auto inFront = hn::Sub(dotOf(d, offsets, bound.normal), hn::Set(d, bound.offset));
      isAnyNear |= !hn::AllFalse(d, hn::Ge(inFront, hn::Set(d, -slack)));
      areAllInFront &= hn::AllTrue(d, hn::Gt(inFront, hn::Set(d, slack)));
    }
    if (!isAnyNear) return kBehindBound;
    if (!areAllInFront) straddled |= bit;
  }
  return straddled;
}

void findSeen(const SampleArrays& samples, std::size_t count, Vec3 light,
              std::span<const StraddledBounds> beams, const BoundingPlane* bounds, double* seen) {
  const hn::CappedTag<double, SampleArrays::kMaxLanes> d;
  for (std::size_t k = 0; k < count; k += hn::Lanes(d)) {
    const auto offsets = offsetsFrom(d, light, samples, k);
    auto areLit = hn::FirstN(d, 0);
    auto areUnknown = areLit;
    const BoundingPlane* next = bounds;
    for (const StraddledBounds& beam : beams) {
      auto areInside = hn::FirstN(d, beam.isDoubtful ? 0 : hn::Lanes(d));
      auto areNear = hn::FirstN(d, hn::Lanes(d));
      for (const BoundingPlane& bound : std::span(next, beam.count)) {
        const auto inFront = hn::Sub(dotOf(d, offsets, bound.normal), hn::Set(d, bound.offset));
        areInside = hn::And(areInside, hn::Gt(inFront, hn::Set(d, bound.slack)));
        areNear = hn::And(areNear, hn::Ge(inFront, hn::Set(d, -bound.slack)));
        if (hn::AllFalse(d, areNear)) break;
      }
      next += beam.count;
      areLit = hn::Or(areLit, areInside);
      if (hn::AllTrue(d, areLit)) break;
      areUnknown = hn::Or(areUnknown, areNear);
    }
    const auto unlit = hn::IfThenElseZero(areUnknown, hn::Set(d, kUnknownFraction));
    hn::StoreU(hn::IfThenElse(areLit, hn::Set(d, 1.0), unlit), d, seen + k);
  }
}

const BeamKernels& targetBeamKernels() {
  static constexpr BeamKernels kKernels{
      .findSpanning = findSpanning,
      .findStraddled = findStraddled,
      .findSeen = findSeen,
  };
  return kKernels;
}

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(targetBeamKernels);
}

const BeamKernels& beamKernels() { return HWY_DYNAMIC_DISPATCH(targetBeamKernels)(); }

}  // namespace hearth

#endif
