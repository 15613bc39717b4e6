// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: every lane is a sample of
// its own, and multiplications and additions are never fused.

#include "light/sight/light_kernels.h"

#include <algorithm>
#include <bit>

#include "light/baking/light_sum.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/sight/light_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

/// Calls visit(d, k) for samples from k on, as many as d has lanes: those of a register, and one
/// by one for those that are left.
template <typename Visit>
HWY_INLINE void forEachLanes(std::size_t count, Visit&& visit) {
  const hn::ScalableTag<double> all;
  std::size_t k = 0;
  for (; k + hn::Lanes(all) <= count; k += hn::Lanes(all)) visit(all, k);
  for (; k < count; ++k) visit(hn::CappedTag<double, 1>(), k);
}

template <typename D>
struct Directions {
  hn::Vec<D> x;
  hn::Vec<D> y;
  hn::Vec<D> z;
};

template <typename D>
HWY_INLINE Directions<D> directionsTo(D d, const SampleArrays& samples, std::size_t k, Vec3 light) {
  return {hn::Sub(hn::LoadU(d, samples.x + k), hn::Set(d, light.x)),
          hn::Sub(hn::LoadU(d, samples.y + k), hn::Set(d, light.y)),
          hn::Sub(hn::LoadU(d, samples.z + k), hn::Set(d, light.z))};
}

/// As dot() of vec.h has it.
template <typename D>
HWY_INLINE hn::Vec<D> dotOf(D d, const Directions<D>& direction, Vec3 v) {
  return hn::Add(
      hn::Add(hn::Mul(direction.x, hn::Set(d, v.x)), hn::Mul(direction.y, hn::Set(d, v.y))),
      hn::Mul(direction.z, hn::Set(d, v.z)));
}

/// In lanes that are beams: how far in front of an upright plane through the light the foremost of
/// the corners is.
template <typename D>
HWY_INLINE hn::Vec<D> foremost(D d, const CornerOffsets& corners, hn::Vec<D> normalX,
                               hn::Vec<D> normalY) {
  const auto inFront = [&](std::size_t k) HWY_ATTR {
    return hn::Add(hn::Mul(hn::Set(d, corners.x[k]), normalX),
                   hn::Mul(hn::Set(d, corners.y[k]), normalY));
  };
  auto most = inFront(0);
  for (std::size_t k = 1; k < corners.count; ++k) most = hn::Max(most, inFront(k));
  return most;
}

std::size_t findSpanning(const CornerOffsets& corners, const BeamSides& beams, std::size_t count,
                         double margin, std::uint32_t* spanning) {
  std::size_t found = 0;
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto least = hn::Set(d, -margin);
    const auto ofBegin =
        foremost(d, corners, hn::LoadU(d, beams.beginX + k), hn::LoadU(d, beams.beginY + k));
    const auto ofEnd =
        foremost(d, corners, hn::LoadU(d, beams.endX + k), hn::LoadU(d, beams.endY + k));
    const auto areSpanning = hn::And(hn::Ge(ofBegin, least), hn::Ge(ofEnd, least));
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, areSpanning, bits);
    for (unsigned left = bits[0]; left != 0; left &= left - 1)
      spanning[found++] =
          static_cast<std::uint32_t>(k) + static_cast<std::uint32_t>(std::countr_zero(left));
  });
  return found;
}

std::uint32_t findParting(const CornerOffsets& corners, const BeamBounds& bounds,
                          std::uint32_t asked, double margin, double reach) {
  using Tag = hn::CappedTag<double, 8>;
  const Tag d;
  std::uint32_t parting = 0;
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const std::uint32_t bit = std::uint32_t{1} << std::min(i, kBoundBits - 1);
    if ((asked & bit) == 0) continue;
    const BeamBound bound = bounds[i];
    const double slack = bound.slack(margin, reach);
    bool isAnyNear = false;
    bool areAllInFront = true;
    for (std::size_t k = 0; k < corners.count; k += hn::Lanes(d)) {
      const Directions<Tag> directions = {hn::LoadU(d, corners.x + k), hn::LoadU(d, corners.y + k),
                                          hn::LoadU(d, corners.z + k)};
      const auto inFront = hn::Sub(dotOf(d, directions, bound.normal), hn::Set(d, bound.offset));
      isAnyNear |= !hn::AllFalse(d, hn::Ge(inFront, hn::Set(d, -slack)));
      areAllInFront &= hn::AllTrue(d, hn::Gt(inFront, hn::Set(d, slack)));
    }
    if (!isAnyNear) return kBehindBound;
    if (!areAllInFront) parting |= bit;
  }
  return parting;
}

void findSeen(const SampleArrays& samples, std::size_t count, Vec3 light,
              std::span<const PartingBounds> beams, const BoundingPlane* bounds, double* seen) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto directions = directionsTo(d, samples, k, light);
    auto areLit = hn::FirstN(d, 0);
    auto areUnknown = areLit;
    const BoundingPlane* next = bounds;
    for (const PartingBounds& beam : beams) {
      auto areInside = hn::FirstN(d, beam.isDoubtful ? 0 : hn::Lanes(d));
      auto areNear = hn::FirstN(d, hn::Lanes(d));
      for (const BoundingPlane& bound : std::span(next, beam.count)) {
        const auto inFront = hn::Sub(dotOf(d, directions, bound.normal), hn::Set(d, bound.offset));
        areInside = hn::And(areInside, hn::Gt(inFront, hn::Set(d, bound.slack)));
        areNear = hn::And(areNear, hn::Ge(inFront, hn::Set(d, -bound.slack)));
        if (hn::AllFalse(d, areNear)) break;
      }
      next += beam.count;
      areLit = hn::Or(areLit, areInside);
      areUnknown = hn::Or(areUnknown, areNear);
    }
    const auto unlit = hn::IfThenElseZero(areUnknown, hn::Set(d, kUnknownFraction));
    hn::StoreU(hn::IfThenElse(areLit, hn::Set(d, 1.0), unlit), d, seen + k);
  });
}

void findDistances(const SampleArrays& samples, std::size_t count, Vec3 light, double* distances) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto direction = directionsTo(d, samples, k, light);
    const auto square =
        hn::Add(hn::Add(hn::Mul(direction.x, direction.x), hn::Mul(direction.y, direction.y)),
                hn::Mul(direction.z, direction.z));
    hn::StoreU(hn::Sqrt(square), d, distances + k);
  });
}

void findLevels(const double* distances, std::size_t count, double intensity, double falloff,
                double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto distance = hn::LoadU(d, distances + k);
    const auto weakened = hn::Add(hn::Mul(distance, hn::Set(d, falloff)), hn::Set(d, 1.0));
    hn::StoreU(hn::Div(hn::Set(d, intensity), weakened), d, levels + k);
  });
}

void applyCosine(const SampleArrays& samples, const double* distances, std::size_t count,
                 Vec3 light, Vec3 normal, double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto inFront = hn::Neg(dotOf(d, directionsTo(d, samples, k, light), normal));
    const auto cosine = hn::Div(inFront, hn::LoadU(d, distances + k));
    // The centre of a ball can lie behind a plane that a part of it lights.
    const auto level = hn::Mul(hn::LoadU(d, levels + k), hn::Max(hn::Zero(d), cosine));
    hn::StoreU(level, d, levels + k);
  });
}

void applySeen(const double* seen, const double* distances, std::size_t count, double reach,
               double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto fraction = hn::LoadU(d, seen + k);
    const auto isNear = hn::Lt(hn::LoadU(d, distances + k), hn::Set(d, reach));
    const auto level = hn::Mul(fraction, hn::LoadU(d, levels + k));
    hn::StoreU(hn::IfThenElseZero(hn::And(isNear, hn::Gt(fraction, hn::Zero(d))), level), d,
               levels + k);
  });
}

void addToSums(const double* levels, std::size_t count, double fraction, double* sums) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto level = hn::Mul(hn::LoadU(d, levels + k), hn::Set(d, fraction));
    const auto most = hn::Min(level, hn::Set(d, LightSum::kMost));
    const auto units =
        hn::Floor(hn::Add(hn::Mul(most, hn::Set(d, LightSum::kUnit)), hn::Set(d, 0.5)));
    const auto sum = hn::Add(hn::LoadU(d, sums + k), units);
    hn::StoreU(hn::Min(sum, hn::Set(d, LightSum::kFull)), d, sums + k);
  });
}

const LightKernels& kernels() {
  static constexpr LightKernels kKernels{
      .findSpanning = findSpanning,
      .findParting = findParting,
      .findSeen = findSeen,
      .findDistances = findDistances,
      .findLevels = findLevels,
      .applyCosine = applyCosine,
      .applySeen = applySeen,
      .addToSums = addToSums,
  };
  return kKernels;
}

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(kernels);
}

const LightKernels& lightKernels() { return HWY_DYNAMIC_DISPATCH(kernels)(); }

}  // namespace hearth

#endif
