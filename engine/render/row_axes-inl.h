// The axes of images and lightmaps, for as many rows at once as a register holds. Included once for
// each instruction set: see row_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_ROW_AXES) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_ROW_AXES
#undef HEARTH_RENDER_ROW_AXES
#else
#define HEARTH_RENDER_ROW_AXES
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "math/planted_bug.h"
#include "render/span_mapping.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<double> kDouble;
constexpr hn::ScalableTag<float> kFloat;
using Doubles = hn::Vec<decltype(kDouble)>;
using Floats = hn::Vec<decltype(kFloat)>;

HWY_INLINE Doubles all(double value) { return hn::Set(kDouble, value); }
HWY_INLINE Floats all(float value) { return hn::Set(kFloat, value); }

HWY_INLINE Doubles at(const Affine& along, Doubles measure) {
  return hn::Add(all(along.atZero), hn::Mul(measure, all(along.per)));
}

HWY_INLINE Doubles at(const ImageAxis& along, Doubles measure) {
  const Doubles fromOrigin = hn::Sub(at(along.place, measure), all(along.origin));
  return hn::Sub(hn::Mul(fromOrigin, all(along.texelsPerPlace)), all(along.offset));
}

/// In texels from the centre of the first one, not from its edge.
HWY_INLINE ImageAxis fromFirst(ImageAxis along) {
  along.offset += 0.5;
  return along;
}

HWY_INLINE Doubles clamped(Doubles x, double low, double high) {
  return hn::Max(hn::Min(x, all(high)), all(low));
}

/// Texel coordinates as whole numbers; past 2^50, where doubles leave nothing behind the point,
/// those of 2^50.
HWY_INLINE Doubles wholeTexels(Doubles x) {
  const Doubles kept = clamped(x, -0x1p50, 0x1p50);
  return hn::Floor(planted(PlantedBug::TruncatingRepeat) ? hn::Abs(kept) : kept);
}

/// Two neighbouring texels, and how far a row is from the centre of the first to that of the next.
struct Between {
  Doubles first;
  Doubles next;
  Doubles share;
};

/// An axis of an image that repeats.
class Repeating {
 public:
  Repeating(const ImageAxis& along, int size)
      : along_(along), alongFromFirst_(fromFirst(along)), size_(size), perTexel_(1.0 / size) {}

  HWY_INLINE Doubles texel(Doubles measure) const {
    return repeated(wholeTexels(at(along_, measure)));
  }

  HWY_INLINE Between between(Doubles measure) const {
    const Doubles x = at(alongFromFirst_, measure);
    const Doubles whole = wholeTexels(x);
    const Doubles first = repeated(whole);
    const Doubles after = hn::Add(first, all(1.0));
    return {first, hn::IfThenElseZero(hn::Lt(after, all(size_)), after), hn::Sub(x, whole)};
  }

 private:
  /// The remainder of a division that rounds down. Of the middle of a texel, so that rounding
  /// cannot miss a multiple of the size: below 2^50 it moves the quotient by less than half a
  /// texel.
  HWY_INLINE Doubles repeated(Doubles whole) const {
    const Doubles repeats = hn::Floor(hn::Mul(hn::Add(whole, all(0.5)), all(perTexel_)));
    return hn::Sub(whole, hn::Mul(repeats, all(size_)));
  }

  ImageAxis along_;
  ImageAxis alongFromFirst_;
  double size_;
  double perTexel_;
};

/// `x`, taken back to the centres of the first and the last of so many texels. The texel before the
/// last is the last to have a next one.
HWY_INLINE Between betweenKept(Doubles x, double size) {
  const Doubles last = all(size - 1);
  const Doubles kept = hn::Max(hn::Min(x, last), all(0.0));
  const Doubles first = hn::Floor(hn::Min(kept, all(std::max(0.0, size - 2))));
  return {first, hn::Min(hn::Add(first, all(1.0)), last), hn::Sub(kept, first)};
}

/// The rows of a sky, which do not repeat: beyond the image its edge goes on.
class SkyRows {
 public:
  SkyRows(const ImageAxis& along, int size)
      : along_(along), alongFromFirst_(fromFirst(along)), size_(size) {}

  HWY_INLINE Doubles texel(Doubles measure) const {
    return hn::Floor(clamped(at(along_, measure), 0.5, size_ - 0.5));
  }

  HWY_INLINE Between between(Doubles measure) const {
    return betweenKept(at(alongFromFirst_, measure), size_);
  }

 private:
  ImageAxis along_;
  ImageAxis alongFromFirst_;
  double size_;
};

/// An axis of a lightmap.
class LightAxis {
 public:
  LightAxis(const Affine& along, int first, int size)
      : alongFromFirst_{along.atZero - (first + 0.5) +
                            (planted(PlantedBug::LightmapHalfTexelOff) ? 0.5 : 0),
                        along.per},
        size_(size) {}

  HWY_INLINE Between between(Doubles measure) const {
    return betweenKept(at(alongFromFirst_, measure), size_);
  }

 private:
  Affine alongFromFirst_;
  double size_;
};

/// An axis along which nothing changes from row to row.
class SameTexel {
 public:
  explicit SameTexel(const Repeating& axis) : texel_(axis.texel(all(0.0))) {}

  HWY_INLINE Doubles texel(Doubles) const { return texel_; }

 private:
  Doubles texel_;
};

class SamePlace {
 public:
  explicit SamePlace(const LightAxis& axis) : between_(axis.between(all(0.0))) {}

  HWY_INLINE Between between(Doubles) const { return between_; }

 private:
  Between between_;
};

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
