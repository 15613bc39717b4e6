// The axes of images and lightmaps, for as many pixels at once as a register holds. Included once
// for each instruction set: see pixel_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_PIXEL_AXES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_PIXEL_AXES
#undef HEARTH_RENDER_PIXEL_AXES
#else
#define HEARTH_RENDER_PIXEL_AXES
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "render/group_mapping.h"
#include "render/lane_registers-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

/// In the columns from `lane` on.
HWY_INLINE Doubles at(const LaneAffine& along, std::size_t lane, Doubles parameter) {
  return hn::Add(hn::Load(kDouble, &along.atZero[lane]),
                 hn::Mul(parameter, hn::Load(kDouble, &along.per[lane])));
}

HWY_INLINE Doubles at(const LaneImageAxis& along, std::size_t lane, Doubles parameter) {
  const Doubles fromOrigin =
      hn::Sub(at(along.place, lane, parameter), hn::Load(kDouble, &along.origin[lane]));
  return hn::Sub(hn::Mul(fromOrigin, all(along.texelsPerPlace)), all(along.offset));
}

HWY_INLINE Doubles clamped(Doubles x, double low, double high) {
  return hn::Max(hn::Min(x, all(high)), all(low));
}

/// Texel coordinates as whole numbers; past 2^50, where nothing is left behind the point, those of
/// 2^50.
HWY_INLINE Doubles wholeTexels(Doubles x) { return hn::Floor(clamped(x, -0x1p50, 0x1p50)); }

/// Two neighbouring texels, and how far a pixel is from the centre of the first to that of the
/// next.
struct TexelPair {
  Doubles first;
  Doubles next;
  Doubles fraction;
};

/// An axis of an image that repeats.
class Repeating {
 public:
  explicit Repeating(int size) : size_(size), perTexel_(1.0 / size) {}

  HWY_INLINE Doubles texel(Doubles x) const { return repeated(wholeTexels(x)); }

  HWY_INLINE TexelPair around(Doubles x) const {
    const Doubles fromCentre = hn::Sub(x, all(0.5));
    const Doubles whole = wholeTexels(fromCentre);
    const Doubles first = repeated(whole);
    const Doubles after = hn::Add(first, all(1));
    return {first, hn::IfThenElseZero(hn::Lt(after, all(size_)), after),
            hn::Sub(fromCentre, whole)};
  }

 private:
  /// The remainder of a division that rounds down. Of the middle of a texel, so that rounding
  /// cannot miss a multiple of the size: below 2^50 it moves the quotient by less than half a
  /// texel.
  HWY_INLINE Doubles repeated(Doubles whole) const {
    const Doubles middle = hn::Add(whole, all(0.5));
    const Doubles repeats = hn::Floor(hn::Mul(middle, all(perTexel_)));
    return hn::Sub(whole, hn::Mul(repeats, all(size_)));
  }

  double size_;
  double perTexel_;
};

/// `x`, from the centre of the first texel, taken back to the centres of the first and the last of
/// so many. The texel before the last is the last to have a next one.
HWY_INLINE TexelPair keptAround(Doubles x, double size) {
  const Doubles last = all(size - 1);
  const Doubles kept = hn::Max(hn::Min(x, last), all(0));
  const Doubles first = hn::Floor(hn::Min(kept, all(std::max(0.0, size - 2))));
  return {first, hn::Min(hn::Add(first, all(1)), last), hn::Sub(kept, first)};
}

/// The rows of a sky, which do not repeat: beyond the image its edge goes on.
class SkyRows {
 public:
  explicit SkyRows(int size) : size_(size) {}

  HWY_INLINE Doubles texel(Doubles x) const { return hn::Floor(clamped(x, 0.5, size_ - 0.5)); }
  HWY_INLINE TexelPair around(Doubles x) const { return keptAround(hn::Sub(x, all(0.5)), size_); }

 private:
  double size_;
};

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
