// Places on images and lightmaps in fixed point, as far as they are linear along the rows or the
// columns of a group: two additions for each pixel, all lanes of a register at once. Included once
// for each instruction set: see pixel_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_FIXED_POINT) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_FIXED_POINT
#undef HEARTH_RENDER_FIXED_POINT
#else
#define HEARTH_RENDER_FIXED_POINT
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "render/pixel_axes-inl.h"
#include "render/pixel_colors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Rounds numbers of less than 2^51 to whole ones, modulo 2^32.
HWY_INLINE void storeModulo(Doubles number, std::uint32_t* to) {
  // Added to it, they are the lowest bits of the sum, also those below zero.
  const LongWords bits = hn::BitCast(kLongWord, hn::Add(number, all(0x1.8p52)));
  const hn::Rebind<std::uint32_t, decltype(kLongWord)> tag;
  hn::Store(hn::TruncateTo(tag, bits), tag, to);
}

template <std::size_t kCount>
struct alignas(64) FixedNumbers : std::array<std::uint32_t, kCount> {};

/// Places on an axis that are linear down each column.
struct ColumnPlaces {
  FixedNumbers<PixelBlock::kLanes> start;  ///< in the first row of the block
  FixedNumbers<PixelBlock::kLanes> step;   ///< to the next row
};

/// Places on an axis that are linear across each row.
struct RowPlaces {
  FixedNumbers<PixelBlock::kRows> start;  ///< in the first column
  FixedNumbers<PixelBlock::kRows> step;   ///< to the next column

  HWY_INLINE Words at(std::size_t row, std::size_t lane) const {
    return hn::Add(allWords(start[row]),
                   hn::Mul(allWords(step[row]), hn::Iota(kWord, static_cast<std::uint32_t>(lane))));
  }
};

/// An axis of an image that repeats. A place on it is in 2^-32 of a repeat, so that 32 bits forget
/// the repeats before. Texels are those of `Repeating`, except where a pixel is so near to a whole
/// texel that rounding could matter; those pixels are noted.
///
/// How near: a place is the sum of a start and at most 31 steps, each of which is off by half of a
/// 2^-32 of a repeat. That is 16 of these units, or `size` times as many 2^-32 of a texel. Both
/// ends of a column or row, also before the image's edge is subtracted, are no larger than
/// kMaxRepeats. Only where the eye is farther than that from what it sees, larger terms add up to
/// them.
template <bool kIsPowerOfTwo>
class FixedAxis {
 public:
  explicit FixedAxis(int size)
      : size_(static_cast<std::uint32_t>(size)),
        bits_(std::countr_zero(size_)),
        unsure_(20 * size_ + 64) {}

  HWY_INLINE Words texel(Words place) {
    if constexpr (kIsPowerOfTwo) {
      note(hn::ShiftLeftSame(place, bits_));
      return hn::ShiftRightSame(place, 32 - bits_);
    } else {
      // The texel is the upper half of the product, and how far the pixel is past it the lower
      // half.
#if HWY_TARGET == HWY_SCALAR
      const std::uint64_t product = std::uint64_t{hn::GetLane(place)} * size_;
      note(allWords(static_cast<std::uint32_t>(product)));
      return allWords(static_cast<std::uint32_t>(product >> 32));
#else
      const auto even = hn::MulEven(place, hn::Set(kWord, size_));
      const auto odd = hn::MulEven(hn::DupOdd(place), hn::Set(kWord, size_));
      const Words evenHalves = hn::BitCast(kWord, even);
      const Words oddHalves = hn::BitCast(kWord, odd);
      note(hn::OddEven(hn::DupEven(oddHalves), evenHalves));
      return hn::OddEven(oddHalves, hn::DupOdd(evenHalves));
#endif
    }
  }

  /// Whether no pixel was too near to a whole texel.
  bool isSure() const {
    return hn::AllTrue(kWord, hn::Gt(least_, hn::Set(kWord, 2 * unsure_ - 1)));
  }

 private:
  /// How far pixels are past a texel, in 2^-32 of it.
  HWY_INLINE void note(Words past) {
    least_ = hn::Min(least_, hn::Add(past, hn::Set(kWord, unsure_)));
  }

  std::uint32_t size_;
  int bits_;
  std::uint32_t unsure_;  ///< pixels less than that before or past a whole texel
  Words least_ = hn::Set(kWord, ~std::uint32_t{0});
};

/// The rows of a sky, which do not repeat: beyond the image its edge goes on. A place is in 2^-20
/// of a texel; how near is too near is as it is for FixedAxis.
class FixedSkyRows {
 public:
  static constexpr int kBits = 20;
  static constexpr double kLargest = 2000;  ///< texels

  explicit FixedSkyRows(int size) : last_((size << kBits) - 1) {}

  HWY_INLINE Words texel(Words place) {
    const Words past = hn::ShiftLeft<32 - kBits>(place);
    least_ = hn::Min(least_, hn::Add(past, hn::Set(kWord, kUnsure << (32 - kBits))));
    const Integers kept =
        hn::Max(hn::Min(hn::BitCast(kSigned, place), hn::Set(kSigned, last_)), hn::Set(kSigned, 0));
    return hn::ShiftRight<kBits>(hn::BitCast(kWord, kept));
  }

  bool isSure() const {
    return hn::AllTrue(kWord, hn::Gt(least_, hn::Set(kWord, (2 * kUnsure << (32 - kBits)) - 1)));
  }

 private:
  static constexpr std::uint32_t kUnsure = 20;

  std::int32_t last_;
  Words least_ = hn::Set(kWord, ~std::uint32_t{0});
};

constexpr double kPlacesPerRepeat = 0x1p32;
/// Repeats of an image. Doubles have 2^-33 of a repeat to spare.
constexpr double kMaxRepeats = 0x1p18;

inline bool isFixedSize(int size) { return 1 < size && size <= 0x10000; }
inline bool isPowerOfTwo(int size) { return std::has_single_bit(static_cast<unsigned>(size)); }

/// Places on a lightmap are in 2^-16 of a texel.
constexpr double kPlacesPerLightTexel = 0x1p16;
constexpr int kMaxLightTexels = 0x7FFF;

/// Where pixels lie between two texels of a lightmap.
struct LightPlace {
  Integers first;
  Words minusFraction;  ///< see PixelBlock::Mix
};

/// An axis of a lightmap, from the centre of its first texel.
class FixedLightAxis {
 public:
  FixedLightAxis(int size, LightFilter filter)
      : last_((size - 1) << 16),
        lastFirst_(std::max(0, size - 2)),
        half_(filter == LightFilter::Nearest ? 0x8000 : 0),
        kept_(filter == LightFilter::Nearest ? 0x10000 : -1) {}

  /// See betweenKept().
  HWY_INLINE LightPlace at(Integers place) const {
    const Integers kept = hn::Max(hn::Min(place, hn::Set(kSigned, last_)), hn::Set(kSigned, 0));
    const Integers first = hn::Min(hn::ShiftRight<16>(kept), hn::Set(kSigned, lastFirst_));
    const Integers past =
        hn::And(hn::Sub(hn::Add(kept, hn::Set(kSigned, half_)), hn::ShiftLeft<16>(first)),
                hn::Set(kSigned, kept_));
    const Words minusFraction = hn::BitCast(kWord, hn::ShiftRight<1>(hn::Neg(past)));
    return {first, twice(lowFields(minusFraction))};
  }

 private:
  std::int32_t last_;
  std::int32_t lastFirst_;
  // All of the nearer texel, or as much as there is of each.
  std::int32_t half_;
  std::int32_t kept_;
};

HWY_INLINE Words wordsOf(Integers x) { return hn::BitCast(kWord, x); }

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
