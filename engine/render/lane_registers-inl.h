// A double for each lane of a strip, as many at once as a register holds. Included once for each
// instruction set: see pixel_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_LANE_REGISTERS) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_LANE_REGISTERS
#undef HEARTH_RENDER_LANE_REGISTERS
#else
#define HEARTH_RENDER_LANE_REGISTERS
#endif

#include <hwy/highway.h>

#include "render/strip.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<double, Strip::kColumns> kDouble;
using Doubles = hn::Vec<decltype(kDouble)>;
using DoubleMask = hn::Mask<decltype(kDouble)>;
constexpr hn::RebindToUnsigned<decltype(kDouble)> kLongWord;
using LongWords = hn::Vec<decltype(kLongWord)>;

HWY_INLINE Doubles all(double value) { return hn::Set(kDouble, value); }

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
