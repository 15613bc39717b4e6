// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: every lane is a sample
// of its own, and multiplications and additions are never fused.

#include "light/baking/brightness_kernels.h"

#include "light/baking/light_sum.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "light/baking/brightness_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "light/sampling/sample_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

void findDistances(const SampleArrays& samples, std::size_t count, Vec3 light, double* distances) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto offset = offsetsFrom(d, light, samples, k);
    const auto square = hn::Add(hn::Add(hn::Mul(offset.x, offset.x), hn::Mul(offset.y, offset.y)),
                                hn::Mul(offset.z, offset.z));
    hn::StoreU(hn::Sqrt(square), d, distances + k);
  });
}

void findLevels(const double* distances, std::size_t count, double intensity, double falloff,
                double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto distance = hn::LoadU(d, distances + k);
    const auto attenuation = hn::Add(hn::Mul(distance, hn::Set(d, falloff)), hn::Set(d, 1.0));
    hn::StoreU(hn::Div(hn::Set(d, intensity), attenuation), d, levels + k);
  });
}

void findLevelsOnCurve(const double* distances, std::size_t count,
                       std::span<const CurvePoint> curve, double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto distance = hn::LoadU(d, distances + k);
    auto level = hn::Set(d, curve.front().level);
    for (std::size_t i = 0; i < curve.size(); ++i) {
      const CurvePoint a = curve[i];
      const auto isBeyond = hn::Ge(distance, hn::Set(d, a.distance));
      if (hn::AllFalse(d, isBeyond)) break;
      auto here = hn::Set(d, a.level);
      if (i + 1 < curve.size()) {
        const CurvePoint b = curve[i + 1];
        const auto along = hn::Sub(distance, hn::Set(d, a.distance));
        const auto fraction = hn::Div(along, hn::Set(d, b.distance - a.distance));
        here = hn::Add(here, hn::Mul(fraction, hn::Set(d, b.level - a.level)));
      }
      level = hn::IfThenElse(isBeyond, here, level);
    }
    hn::StoreU(level, d, levels + k);
  });
}

void applyCosine(const SampleArrays& samples, const double* distances, std::size_t count,
                 Vec3 light, Vec3 normal, double* levels) {
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    // Of the light above the plane of the sample. No sample is at distance 0: lights in the plane
    // of a surface do not light it.
    const auto height = hn::Neg(dotOf(d, offsetsFrom(d, light, samples, k), normal));
    const auto cosine = hn::Div(height, hn::LoadU(d, distances + k));
    // The centre of a ball can lie behind a plane that a part of it lights.
    const auto level = hn::Mul(hn::LoadU(d, levels + k), hn::Max(hn::Zero(d), cosine));
    hn::StoreU(level, d, levels + k);
  });
}

void applySpot(const SampleArrays& samples, const double* distances, std::size_t count, Vec3 light,
               const Spot& spot, double* levels) {
  const double range = spot.cosInner() - spot.cosOuter();
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    // No sample is at distance 0, as above.
    const auto along = dotOf(d, offsetsFrom(d, light, samples, k), spot.direction());
    const auto cosine = hn::Div(along, hn::LoadU(d, distances + k));
    const auto one = hn::Set(d, 1.0);
    const auto t = hn::Div(hn::Sub(cosine, hn::Set(d, spot.cosOuter())), hn::Set(d, range));
    const auto smooth =
        hn::Mul(hn::Mul(t, t), hn::Sub(hn::Set(d, 3.0), hn::Mul(hn::Set(d, 2.0), t)));
    const auto isFull = hn::Ge(hn::Max(cosine, hn::Set(d, -1.0)), hn::Set(d, spot.cosInner()));
    const auto isLit = hn::Gt(cosine, hn::Set(d, spot.cosOuter()));
    const auto factor = hn::IfThenElse(isFull, one, hn::IfThenElseZero(isLit, smooth));
    hn::StoreU(hn::Mul(hn::LoadU(d, levels + k), factor), d, levels + k);
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
    const auto most = hn::Min(level, hn::Set(d, LightSum::kMax));
    const auto units =
        hn::Floor(hn::Add(hn::Mul(most, hn::Set(d, LightSum::kUnit)), hn::Set(d, 0.5)));
    const auto sum = hn::Add(hn::LoadU(d, sums + k), units);
    hn::StoreU(hn::Min(sum, hn::Set(d, LightSum::kFull)), d, sums + k);
  });
}

void findMeans(const double* sums, std::size_t count, int samples, double* means) {
  const double one = samples * LightSum::kUnit;
  forEachLanes(count, [&](auto d, std::size_t k) HWY_ATTR {
    const auto rounded = hn::Add(hn::LoadU(d, sums + k), hn::Set(d, one / 2));
    const auto mean = hn::Floor(hn::Div(rounded, hn::Set(d, one)));
    hn::StoreU(hn::Min(mean, hn::Set(d, 255.0)), d, means + k);
  });
}

const BrightnessKernels& targetBrightnessKernels() {
  static constexpr BrightnessKernels kKernels{
      .findDistances = findDistances,
      .findLevels = findLevels,
      .findLevelsOnCurve = findLevelsOnCurve,
      .applyCosine = applyCosine,
      .applySpot = applySpot,
      .applySeen = applySeen,
      .addToSums = addToSums,
      .findMeans = findMeans,
  };
  return kKernels;
}

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(targetBrightnessKernels);
}

const BrightnessKernels& brightnessKernels() {
  return HWY_DYNAMIC_DISPATCH(targetBrightnessKernels)();
}

}  // namespace hearth

#endif
