// Arithmetic of colours, for as many pixels at once as a register holds. A word holds two channels,
// of 16 bits each: its fields. Included once for each instruction set: see pixel_kernels.cpp, and
// Highway's guide on the guard.

#if defined(HEARTH_RENDER_PIXEL_COLORS) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_PIXEL_COLORS
#undef HEARTH_RENDER_PIXEL_COLORS
#else
#define HEARTH_RENDER_PIXEL_COLORS
#endif

#include <hwy/highway.h>

#include <cstdint>

#include "math/vec.h"
#include "render/pixel_block.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::CappedTag<std::uint32_t, PixelBlock::kLanes> kWord;
using Words = hn::Vec<decltype(kWord)>;
constexpr hn::RebindToSigned<decltype(kWord)> kSigned;
using Integers = hn::Vec<decltype(kSigned)>;

HWY_INLINE Words allWords(std::uint32_t value) { return hn::Set(kWord, value); }

HWY_INLINE Words lowFields(Words x) { return hn::And(x, allWords(0xFFFF)); }
HWY_INLINE Words highFields(Words x) { return hn::ShiftRight<16>(x); }
HWY_INLINE Words fieldsOf(Words low, Words high) { return hn::Or(low, hn::ShiftLeft<16>(high)); }
HWY_INLINE Words withFieldsSwapped(Words x) { return hn::RotateRight<16>(x); }

#if HWY_TARGET == HWY_SCALAR

// One lane holds one word, and no two fields.

/// use(a, b) of the signed numbers in the lower fields and of those in the upper ones.
template <typename Use>
HWY_INLINE Words onFields(Words a, Words b, Use&& use) {
  const std::uint32_t x = hn::GetLane(a);
  const std::uint32_t y = hn::GetLane(b);
  const auto field = [](std::uint32_t word) {
    return std::int32_t{static_cast<std::int16_t>(word)};
  };
  const auto low = static_cast<std::uint16_t>(use(field(x), field(y)));
  const auto high = static_cast<std::uint16_t>(use(field(x >> 16), field(y >> 16)));
  return allWords(std::uint32_t{low} | std::uint32_t{high} << 16);
}

HWY_INLINE Words differenceOfFields(Words a, Words b) {
  return onFields(a, b, [](std::int32_t x, std::int32_t y) { return x - y; });
}
HWY_INLINE Words sumOfFields(Words a, Words b) {
  return onFields(a, b, [](std::int32_t x, std::int32_t y) { return x + y; });
}

/// Products of signed numbers, the second in 2^-15, rounded.
HWY_INLINE Words productOfFields(Words a, Words b) {
  return onFields(a, b, [](std::int32_t x, std::int32_t y) { return (x * y + 0x4000) >> 15; });
}

HWY_INLINE Words minOfUnsignedFields(Words a, Words b) {
  return fieldsOf(hn::Min(lowFields(a), lowFields(b)), hn::Min(highFields(a), highFields(b)));
}

/// The upper 16 bits of products of unsigned numbers.
HWY_INLINE Words highProductOfFields(Words a, Words b) {
  return fieldsOf(highFields(hn::Mul(lowFields(a), lowFields(b))),
                  highFields(hn::Mul(highFields(a), highFields(b))));
}

#else

constexpr hn::Repartition<std::int16_t, decltype(kWord)> kField;
constexpr hn::Repartition<std::uint16_t, decltype(kWord)> kUnsignedField;

HWY_INLINE Words differenceOfFields(Words a, Words b) {
  return hn::BitCast(kWord, hn::Sub(hn::BitCast(kField, a), hn::BitCast(kField, b)));
}
HWY_INLINE Words sumOfFields(Words a, Words b) {
  return hn::BitCast(kWord, hn::Add(hn::BitCast(kField, a), hn::BitCast(kField, b)));
}

/// Products of signed numbers, the second in 2^-15, rounded.
HWY_INLINE Words productOfFields(Words a, Words b) {
  return hn::BitCast(kWord, hn::MulFixedPoint15(hn::BitCast(kField, a), hn::BitCast(kField, b)));
}

HWY_INLINE Words minOfUnsignedFields(Words a, Words b) {
  return hn::BitCast(kWord,
                     hn::Min(hn::BitCast(kUnsignedField, a), hn::BitCast(kUnsignedField, b)));
}

/// The upper 16 bits of products of unsigned numbers.
HWY_INLINE Words highProductOfFields(Words a, Words b) {
  return hn::BitCast(kWord,
                     hn::MulHigh(hn::BitCast(kUnsignedField, a), hn::BitCast(kUnsignedField, b)));
}

#endif

/// Levels of light and colour, 0 to 255, are kept in 128ths: so they and their differences are
/// signed numbers of 16 bits.
constexpr int kLevelBits = 7;

/// The channels of a colour. The outer ones, the lowest byte and the third, share a word; the
/// middle one fills both fields of another.
struct Channels {
  Words outer;
  Words middle;
};

/// The same number in both fields of each word.
HWY_INLINE Words twice(Words number) { return hn::Or(number, hn::ShiftLeft<16>(number)); }

/// In 128ths, of colours whose highest byte means nothing.
HWY_INLINE Channels channelsOf(Words colors) {
  const Words outer = hn::And(colors, allWords(0x00FF00FF));
  const Words middle = hn::And(hn::ShiftRight<8>(colors), allWords(0xFF));
  return {hn::ShiftLeft<kLevelBits>(outer), hn::ShiftLeft<kLevelBits>(twice(middle))};
}

/// The nearest colours of 8 bits a channel.
HWY_INLINE Words colorsOf(const Channels& channels) {
  const Words half = allWords(0x00400040);
  const Words outer =
      hn::And(hn::ShiftRight<kLevelBits>(hn::Add(channels.outer, half)), allWords(0x00FF00FF));
  const Words middle = hn::ShiftLeft<1>(hn::Add(channels.middle, half));
  return hn::Or(outer, hn::And(middle, allWords(0xFF00)));
}

/// first - fraction * drop, where `drop` is first - next. `minusFraction` is -fraction in 2^-15,
/// because 1 would not fit in 16 bits, but -1 does: so both ends are exact.
HWY_INLINE Words mixed(Words first, Words drop, Words minusFraction) {
  return sumOfFields(first, productOfFields(drop, minusFraction));
}

/// How far a pixel is from the left to the right texels and from the upper to the lower ones, as
/// mixed() takes it.
struct Weights {
  Words across;
  Words down;
};

/// What lies between the columns of a neighbourhood, in its upper and in its lower row.
struct NeighbourRows {
  Words upper;
  Words drop;  ///< to the lower row

  HWY_INLINE Words at(Words down) const { return mixed(upper, drop, down); }
};

/// A 2x2 neighbourhood of texels, one or two channels of it.
struct Neighbourhood {
  Words upperLeft;
  Words upperDrop;  ///< to the right
  Words lowerLeft;
  Words lowerDrop;

  HWY_INLINE NeighbourRows rowsAt(Words across) const {
    const Words upper = mixed(upperLeft, upperDrop, across);
    const Words lower = mixed(lowerLeft, lowerDrop, across);
    return {upper, differenceOfFields(upper, lower)};
  }
  HWY_INLINE Words at(const Weights& weights) const {
    return rowsAt(weights.across).at(weights.down);
  }
};

HWY_INLINE Neighbourhood neighbourhoodOf(Words upperLeft, Words upperRight, Words lowerLeft,
                                         Words lowerRight) {
  return {upperLeft, differenceOfFields(upperLeft, upperRight), lowerLeft,
          differenceOfFields(lowerLeft, lowerRight)};
}

/// All channels of a 2x2 neighbourhood, or of its rows.
struct ColorRows {
  NeighbourRows outer;
  NeighbourRows middle;

  HWY_INLINE Channels at(Words down) const { return {outer.at(down), middle.at(down)}; }
};
struct ColorNeighbourhood {
  Neighbourhood outer;
  Neighbourhood middle;

  HWY_INLINE ColorRows rowsAt(Words across) const {
    return {outer.rowsAt(across), middle.rowsAt(across)};
  }
  HWY_INLINE Channels at(const Weights& weights) const {
    return {outer.at(weights), middle.at(weights)};
  }
};

HWY_INLINE ColorNeighbourhood neighbourhoodOf(const Channels& upperLeft, const Channels& upperRight,
                                              const Channels& lowerLeft,
                                              const Channels& lowerRight) {
  return {
      neighbourhoodOf(upperLeft.outer, upperRight.outer, lowerLeft.outer, lowerRight.outer),
      neighbourhoodOf(upperLeft.middle, upperRight.middle, lowerLeft.middle, lowerRight.middle)};
}

/// Colours in a light that shows so much of each channel: 256 * 255 is all of it.
HWY_INLINE Words shaded(Words colors, const Channels& shown) {
  const Words outer = hn::And(colors, allWords(0x00FF00FF));
  const Words middle = hn::And(hn::ShiftRight<8>(colors), allWords(0x00FF00FF));
  // A byte b twice is 257 b, and 257 * 256 * 255 / 2^16 is almost 256. Results are in 1/256 of a
  // level, and less than 2/256 too small. Adding 130, half a level and 2/256, rounds halves up.
  const auto product = [](Words bytes, Words levels) HWY_ATTR {
    const Words bytesTwice = hn::Or(bytes, hn::ShiftLeft<8>(bytes));
    return hn::Add(highProductOfFields(bytesTwice, levels), allWords(130 * 0x10001));
  };
  const Words outers = hn::ShiftRight<8>(product(outer, shown.outer));
  return hn::Or(hn::And(outers, allWords(0x00FF00FF)),
                hn::And(product(middle, shown.middle), allWords(0xFF00)));
}

/// What shows in the light of a lightmap and in even light: min(1, lightmap + even). In numbers of
/// which 256 * 255 is all.
class EvenLight {
 public:
  /// Fractions of red, green and blue, 0..1.
  explicit EvenLight(Vec3 light)
      : outer_(wordOf(light.x) << 16 | wordOf(light.z)),
        middle_(wordOf(light.y) * 0x10001),
        isGrey_(outer_ == middle_) {}

  /// `levels` are those of the lightmap, in 128ths: of three channels, or the same of all.
  HWY_INLINE Channels shownWith(const Channels& levels) const {
    return {with(levels.outer, outer_), with(levels.middle, middle_)};
  }
  HWY_INLINE Channels shownWith(Words level) const {
    const Words outer = with(level, outer_);
    return {outer, isGrey_ ? outer : with(level, middle_)};
  }

 private:
  static constexpr std::uint32_t kAll = 256 * 255;

  static std::uint32_t wordOf(double fraction) {
    return static_cast<std::uint32_t>(fraction * kAll + 0.5);
  }

  /// What is left for the lightmap is taken of it.
  static HWY_INLINE Words with(Words levels, std::uint32_t even) {
    return hn::Add(minOfUnsignedFields(hn::Add(levels, levels), allWords(kAll * 0x10001 - even)),
                   allWords(even));
  }

  std::uint32_t outer_;   ///< red and blue, as in Channels
  std::uint32_t middle_;  ///< green, in both fields
  bool isGrey_;           ///< the same in all channels
};

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
