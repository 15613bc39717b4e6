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
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include "render/span_mapping.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<double> kDouble;
constexpr hn::ScalableTag<float> kFloat;
using Doubles = hn::Vec<decltype(kDouble)>;
using Floats = hn::Vec<decltype(kFloat)>;
constexpr hn::RebindToUnsigned<decltype(kDouble)> kLongWord;
using LongWords = hn::Vec<decltype(kLongWord)>;

constexpr hn::RebindToSigned<decltype(kFloat)> kSigned;
using Integers = hn::Vec<decltype(kSigned)>;
constexpr hn::RebindToUnsigned<decltype(kFloat)> kWord;
using Words = hn::Vec<decltype(kWord)>;

/// In all lanes of Reals: Doubles, in which places are found, or Floats, in which colours are made.
template <typename Reals>
HWY_INLINE Reals all(double value) {
  return hn::Set(hn::DFromV<Reals>(), static_cast<hn::TFromV<Reals>>(value));
}

HWY_INLINE Doubles at(const Affine& along, Doubles parameter) {
  return hn::Add(all<Doubles>(along.atZero), hn::Mul(parameter, all<Doubles>(along.per)));
}

HWY_INLINE Doubles at(const ImageAxis& along, Doubles parameter) {
  const Doubles fromOrigin = hn::Sub(at(along.place, parameter), all<Doubles>(along.origin));
  return hn::Sub(hn::Mul(fromOrigin, all<Doubles>(along.texelsPerPlace)),
                 all<Doubles>(along.offset));
}

/// In texels from the centre of the first one, not from its edge.
HWY_INLINE ImageAxis fromFirst(ImageAxis along) {
  along.offset += 0.5;
  return along;
}

HWY_INLINE Doubles clamped(Doubles x, double low, double high) {
  return hn::Max(hn::Min(x, all<Doubles>(high)), all<Doubles>(low));
}

/// Texel coordinates as whole numbers; past 2^50, where nothing is left behind the point, those of
/// 2^50.
HWY_INLINE Doubles wholeTexels(Doubles x) { return hn::Floor(clamped(x, -0x1p50, 0x1p50)); }

/// Two neighbouring texels, and how far a row is from the centre of the first to that of the next.
struct Between {
  Doubles first;
  Doubles next;
  Doubles fraction;
};

/// An axis of an image that repeats.
class Repeating {
 public:
  Repeating(const ImageAxis& along, int size)
      : along_(along), alongFromFirst_(fromFirst(along)), size_(size), perTexel_(1.0 / size) {}

  HWY_INLINE Doubles texel(Doubles parameter) const {
    return repeated(wholeTexels(at(along_, parameter)));
  }

  HWY_INLINE Between between(Doubles parameter) const {
    const Doubles x = at(alongFromFirst_, parameter);
    const Doubles whole = wholeTexels(x);
    const Doubles first = repeated(whole);
    const Doubles after = hn::Add(first, all<Doubles>(1));
    return {first, hn::IfThenElseZero(hn::Lt(after, all<Doubles>(size_)), after),
            hn::Sub(x, whole)};
  }

 private:
  /// The remainder of a division that rounds down. Of the middle of a texel, so that rounding
  /// cannot miss a multiple of the size: below 2^50 it moves the quotient by less than half a
  /// texel.
  HWY_INLINE Doubles repeated(Doubles whole) const {
    const Doubles middle = hn::Add(whole, all<Doubles>(0.5));
    const Doubles repeats = hn::Floor(hn::Mul(middle, all<Doubles>(perTexel_)));
    return hn::Sub(whole, hn::Mul(repeats, all<Doubles>(size_)));
  }

  ImageAxis along_;
  ImageAxis alongFromFirst_;
  double size_;
  double perTexel_;
};

/// `x`, taken back to the centres of the first and the last of so many texels. The texel before the
/// last is the last to have a next one.
HWY_INLINE Between betweenKept(Doubles x, double size) {
  const Doubles last = all<Doubles>(size - 1);
  const Doubles kept = hn::Max(hn::Min(x, last), all<Doubles>(0));
  const Doubles first = hn::Floor(hn::Min(kept, all<Doubles>(std::max(0.0, size - 2))));
  return {first, hn::Min(hn::Add(first, all<Doubles>(1)), last), hn::Sub(kept, first)};
}

/// An axis of an image that repeats, whose size is a power of two: then the lowest bits of a whole
/// number are its remainder.
class RepeatingByBits {
 public:
  RepeatingByBits(const ImageAxis& along, int size)
      : along_(along), last_(static_cast<std::uint32_t>(size - 1)) {}

  HWY_INLINE LongWords texel(Doubles parameter) const {
    // Of less than 2^51: added to it, they are the lowest bits of the sum, also those below zero.
    const Doubles sum = hn::Add(wholeTexels(at(along_, parameter)), all<Doubles>(0x1.8p52));
    return hn::And(hn::BitCast(kLongWord, sum), hn::Set(kLongWord, last_));
  }

 private:
  ImageAxis along_;
  std::uint32_t last_;
};

#if HWY_TARGET != HWY_SCALAR

/// An axis of an image that repeats, in fixed point: a row's place on it in 2^-32 of a repeat, so
/// that 32 bits forget the repeats before. Two operations find that, and all that follows handles
/// twice as many rows at once. Texels are those of the axes above, except where a row is so near to
/// a whole texel that rounding could matter; those rows are reported.
///
/// How near: of all that is added up to a coordinate nothing is larger than 2^20 texels (`holds`),
/// so that what rounding loses each time is at most 2^-33 of a texel, a dozen times in both
/// computations together; and the two operations round to places, which are `size` of 2^-32 of a
/// texel.
template <bool kIsPowerOfTwo>
class RepeatingInFixedPoint {
 public:
  RepeatingInFixedPoint(const ImageAxis& along, int size)
      : RepeatingInFixedPoint(along, size, kPlaces / size) {}

  /// Whether it can tell the texels at parameters of up to `maxParameter`.
  static bool holds(const ImageAxis& along, int size, double maxParameter) {
    const double places = std::abs(along.place.atZero) + std::abs(along.place.per) * maxParameter +
                          std::abs(along.origin);
    return 1 < size && size <= 0x10000 &&
           places * std::abs(along.texelsPerPlace) + std::abs(along.offset) <= 0x1p20;
  }

  /// The texels at as many parameters as there are words.
  HWY_INLINE Words texel(Doubles lower, Doubles upper) {
    const Words place = hn::ConcatEven(kWord, placeAt(upper), placeAt(lower));
    if constexpr (kIsPowerOfTwo) {
      note(hn::ShiftLeftSame(place, bits_));
      return hn::ShiftRightSame(place, 32 - bits_);
    }
    // The texel is the upper half of the product, and how far the row is past it the lower half.
    const auto even = hn::MulEven(place, hn::Set(kWord, size_));
    const auto odd = hn::MulEven(hn::DupOdd(place), hn::Set(kWord, size_));
    const Words evenHalves = hn::BitCast(kWord, even);
    const Words oddHalves = hn::BitCast(kWord, odd);
    note(hn::OddEven(hn::DupEven(oddHalves), evenHalves));
    return hn::OddEven(oddHalves, hn::DupOdd(evenHalves));
  }

  /// Whether no row was too near to a whole texel.
  bool isSure() const {
    return hn::AllTrue(kWord, hn::Gt(least_, hn::Set(kWord, 2 * unsure_ - 1)));
  }

 private:
  static constexpr double kPlaces = 0x1p32;

  RepeatingInFixedPoint(const ImageAxis& along, int size, double placesPerTexel)
      : per_(along.place.per * along.texelsPerPlace * placesPerTexel),
        // Added to whole numbers of less than 2^51, they are the lowest bits of the sum, also those
        // below zero.
        atZero_(((along.place.atZero - along.origin) * along.texelsPerPlace - along.offset) *
                    placesPerTexel +
                0x1.8p52),
        size_(static_cast<std::uint32_t>(size)),
        bits_(std::countr_zero(size_)),
        unsure_(2 * size_ + 16) {}

  HWY_INLINE Words placeAt(Doubles parameter) const {
    return hn::BitCast(kWord,
                       hn::Add(hn::Mul(parameter, all<Doubles>(per_)), all<Doubles>(atZero_)));
  }

  /// How far rows are past a texel, in 2^-32 of it.
  HWY_INLINE void note(Words past) {
    least_ = hn::Min(least_, hn::Add(past, hn::Set(kWord, unsure_)));
  }

  double per_;
  double atZero_;
  std::uint32_t size_;
  int bits_;
  std::uint32_t unsure_;  ///< rows less than that before or past a whole texel
  Words least_ = hn::Set(kWord, ~std::uint32_t{0});
};

#endif

/// The rows of a sky, which do not repeat: beyond the image its edge goes on.
class SkyRows {
 public:
  SkyRows(const ImageAxis& along, int size)
      : along_(along), alongFromFirst_(fromFirst(along)), size_(size) {}

  HWY_INLINE Doubles texel(Doubles parameter) const {
    return hn::Floor(clamped(at(along_, parameter), 0.5, size_ - 0.5));
  }

  HWY_INLINE Between between(Doubles parameter) const {
    return betweenKept(at(alongFromFirst_, parameter), size_);
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
      : alongFromFirst_{along.atZero - (first + 0.5), along.per}, size_(size) {}

  HWY_INLINE Between between(Doubles parameter) const {
    return betweenKept(at(alongFromFirst_, parameter), size_);
  }

 private:
  Affine alongFromFirst_;
  double size_;
};

/// An axis along which nothing changes from row to row.
template <typename Axis>
class SameTexel {
 public:
  explicit SameTexel(const Axis& axis) : texel_(axis.texel(all<Doubles>(0))) {}

  HWY_INLINE auto texel(Doubles) const { return texel_; }

 private:
  decltype(std::declval<Axis>().texel(std::declval<Doubles>())) texel_;
};

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
