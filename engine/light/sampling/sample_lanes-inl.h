// Samples in the lanes of a register. Included once for each instruction set: see Highway's guide
// on the guard.

#if defined(HEARTH_LIGHT_SAMPLE_LANES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_LIGHT_SAMPLE_LANES
#undef HEARTH_LIGHT_SAMPLE_LANES
#else
#define HEARTH_LIGHT_SAMPLE_LANES
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "light/sampling/sample_arrays.h"
#include "math/vec.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

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
struct Offsets {
  hn::Vec<D> x;
  hn::Vec<D> y;
  hn::Vec<D> z;
};

/// Vectors from a light to samples.
template <typename D>
HWY_INLINE Offsets<D> offsetsFrom(D d, Vec3 light, const SampleArrays& samples, std::size_t k) {
  return {hn::Sub(hn::LoadU(d, samples.x + k), hn::Set(d, light.x)),
          hn::Sub(hn::LoadU(d, samples.y + k), hn::Set(d, light.y)),
          hn::Sub(hn::LoadU(d, samples.z + k), hn::Set(d, light.z))};
}

/// The same sum as dot() in math/vec.h.
template <typename D>
HWY_INLINE hn::Vec<D> dotOf(D d, const Offsets<D>& offset, Vec3 v) {
  return hn::Add(hn::Add(hn::Mul(offset.x, hn::Set(d, v.x)), hn::Mul(offset.y, hn::Set(d, v.y))),
                 hn::Mul(offset.z, hn::Set(d, v.z)));
}

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
