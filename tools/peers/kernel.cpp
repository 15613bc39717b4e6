// Compiled once for each instruction set: see Highway's guide on foreach_target.h.

#include "peers/kernel.h"

#include <algorithm>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "peers/kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

constexpr hn::ScalableTag<float> kFloat;
constexpr hn::RebindToSigned<decltype(kFloat)> kSigned;
constexpr hn::RebindToUnsigned<decltype(kFloat)> kWord;
using Floats = hn::Vec<decltype(kFloat)>;
using Integers = hn::Vec<decltype(kSigned)>;
using Words = hn::Vec<decltype(kWord)>;

constexpr std::size_t kMaxLanes = HWY_MAX_BYTES / sizeof(float);

struct Colors {
  Floats red;
  Floats green;
  Floats blue;
};

template <int kShift>
HWY_INLINE Floats channelOf(Words pixels) {
  const Words channel = hn::And(hn::ShiftRight<kShift>(pixels), hn::Set(kWord, 255));
  return hn::ConvertTo(kFloat, hn::BitCast(kSigned, channel));
}

HWY_INLINE Colors colorsOf(Words pixels) {
  return {channelOf<0>(pixels), channelOf<8>(pixels), channelOf<16>(pixels)};
}

HWY_INLINE Floats mixed(Floats a, Floats b, Floats fraction) {
  return hn::MulAdd(fraction, hn::Sub(b, a), a);
}

HWY_INLINE Colors mixed(const Colors& a, const Colors& b, Floats fraction) {
  return {mixed(a.red, b.red, fraction), mixed(a.green, b.green, fraction),
          mixed(a.blue, b.blue, fraction)};
}

HWY_INLINE Floats at(const KernelAxis& axis, Floats parameter) {
  return hn::MulAdd(parameter, hn::Set(kFloat, axis.step), hn::Set(kFloat, axis.start));
}

HWY_INLINE Words wordOf(Integers numbers) { return hn::BitCast(kWord, numbers); }

/// Texels one by one: gathering takes longer.
HWY_INLINE Words texelsAt(const Pixel* texels, Words numbers) {
  HWY_ALIGN Pixel at[kMaxLanes];
  hn::Store(numbers, kWord, at);
  for (std::size_t k = 0; k < hn::Lanes(kFloat); ++k) at[k] = texels[at[k]];
  return hn::Load(kWord, at);
}

HWY_INLINE Words imageAt(const KernelSpan& span, Floats parameter) {
  const Words u = wordOf(hn::ConvertTo(kSigned, at(span.u, parameter)));
  const Words v = wordOf(hn::ConvertTo(kSigned, at(span.v, parameter)));
  const Words column = hn::And(u, hn::Set(kWord, span.uMask));
  const Words row = hn::And(v, hn::Set(kWord, span.vMask));
  return texelsAt(span.texels, hn::Or(hn::ShiftLeftSame(column, span.vBits), row));
}

/// Two neighbouring texels of a lightmap each, `across` of the way from the left to the right one.
class Pairs {
 public:
  HWY_INLINE void read(std::size_t k, const Pixel* left) {
    std::memcpy(&pairs_[2 * k], left, 2 * sizeof *left);
  }

  HWY_INLINE Colors mixture(Floats across) const {
    Words left;
    Words right;
    hn::LoadInterleaved2(kWord, pairs_, left, right);
    return mixed(colorsOf(left), colorsOf(right), across);
  }

 private:
  HWY_ALIGN Pixel pairs_[2 * kMaxLanes];
};

struct EvenLight {
  explicit EvenLight(const KernelSpan& span)
      : shown{hn::Set(kFloat, span.shown[0]), hn::Set(kFloat, span.shown[1]),
              hn::Set(kFloat, span.shown[2])} {}

  HWY_INLINE Colors shownAt(Floats) const { return shown; }

  Colors shown;
};

/// What shows in light of a lightmap.
HWY_INLINE Colors shownIn(const Colors& levels, float sectorLight) {
  const auto shown = [&](Floats level) {
    return hn::Min(hn::Set(kFloat, 1),
                   hn::MulAdd(level, hn::Set(kFloat, 1 / 255.0F), hn::Set(kFloat, sectorLight)));
  };
  return {shown(levels.red), shown(levels.green), shown(levels.blue)};
}

class PlaneLight {
 public:
  explicit PlaneLight(const KernelSpan& span) : span_(span) {}

  HWY_INLINE Colors shownAt(Floats parameter) const {
    const Floats s = at(span_.s, parameter);
    const Floats t = at(span_.t, parameter);
    const Integers column = hn::ConvertTo(kSigned, s);
    const Integers row = hn::ConvertTo(kSigned, t);
    const Integers width = hn::Set(kSigned, static_cast<int>(span_.lightWidth));
    HWY_ALIGN std::int32_t numbers[kMaxLanes];
    hn::Store(hn::Add(hn::Mul(row, width), column), kSigned, numbers);
    Pairs upper;
    Pairs lower;
    for (std::size_t k = 0; k < hn::Lanes(kFloat); ++k) {
      const Pixel* const texel = span_.light + numbers[k];
      upper.read(k, texel);
      lower.read(k, texel + span_.lightWidth);
    }
    const Floats across = hn::Sub(s, hn::ConvertTo(kFloat, column));
    const Floats down = hn::Sub(t, hn::ConvertTo(kFloat, row));
    return shownIn(mixed(upper.mixture(across), lower.mixture(across), down), span_.sectorLight);
  }

 private:
  const KernelSpan& span_;
};

/// The mixtures of two columns stay in registers.
class UprightLight {
 public:
  explicit UprightLight(const KernelSpan& span) : span_(span) {
    Pairs rows;
    for (std::size_t k = 0; k < span.lightRows; ++k) rows.read(k, span.light + k * span.lightWidth);
    column_ = rows.mixture(hn::Set(kFloat, span.s.start));
  }

  HWY_INLINE Colors shownAt(Floats parameter) const {
    const Floats t = at(span_.t, parameter);
    const Integers row = hn::ConvertTo(kSigned, t);
    return shownIn(mixed(rowsAt(row), rowsAt(hn::Add(row, hn::Set(kSigned, 1))),
                         hn::Sub(t, hn::ConvertTo(kFloat, row))),
                   span_.sectorLight);
  }

 private:
  HWY_INLINE Colors rowsAt(Integers rows) const {
    const auto lanes = hn::IndicesFromVec(kFloat, rows);
    return {hn::TableLookupLanes(column_.red, lanes), hn::TableLookupLanes(column_.green, lanes),
            hn::TableLookupLanes(column_.blue, lanes)};
  }

  const KernelSpan& span_;
  Colors column_;
};

HWY_INLINE Words shaded(Floats color, Floats shown) {
  return wordOf(hn::ConvertTo(kSigned, hn::MulAdd(color, shown, hn::Set(kFloat, 0.5F))));
}

template <typename Light>
void draw(const KernelSpan& span, Pixel* to) {
  const Light light(span);
  const std::size_t count = span.rowEnd - span.rowBegin;
  const auto [least, most] = std::minmax(span.parameters[0], span.parameters[count - 1]);
  for (std::size_t k = 0; k < count; k += hn::Lanes(kFloat)) {
    // Behind the last row nothing is read that is not there.
    const Floats parameter = hn::Clamp(hn::LoadU(kFloat, span.parameters + k),
                                       hn::Set(kFloat, least), hn::Set(kFloat, most));
    const Colors colors = colorsOf(imageAt(span, parameter));
    const Colors shown = light.shownAt(parameter);
    const Words red = shaded(colors.red, shown.red);
    const Words green = hn::ShiftLeft<8>(shaded(colors.green, shown.green));
    const Words blue = hn::ShiftLeft<16>(shaded(colors.blue, shown.blue));
    hn::StoreU(hn::Or(red, hn::Or(green, blue)), kWord, to + k);
  }
}

void draw(const KernelSpan& span, Pixel* to) {
  switch (span.kind) {
    case KernelLight::Even:
      return draw<EvenLight>(span, to);
    case KernelLight::Upright:
      return draw<UprightLight>(span, to);
    case KernelLight::Plane:
      return draw<PlaneLight>(span, to);
  }
}

#if HWY_TARGET == HWY_SCALAR

void turn(const Pixel* column, std::size_t next, Pixel* to, std::size_t width) {
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t i = 0; i < 4; ++i) to[row * width + i] = column[i * next + row];
}

#else

/// Four columns, each `next` pixels behind the one before, to four rows of a picture.
HWY_INLINE void turn(const Pixel* column, std::size_t next, Pixel* to, std::size_t width) {
  constexpr hn::Full128<Pixel> kFour;
  constexpr hn::Repartition<std::uint64_t, decltype(kFour)> kTwo;
  const auto a = hn::LoadU(kFour, column);
  const auto b = hn::LoadU(kFour, column + next);
  const auto c = hn::LoadU(kFour, column + 2 * next);
  const auto d = hn::LoadU(kFour, column + 3 * next);
  const auto upperLeft = hn::BitCast(kTwo, hn::InterleaveLower(kFour, a, b));
  const auto upperRight = hn::BitCast(kTwo, hn::InterleaveLower(kFour, c, d));
  const auto lowerLeft = hn::BitCast(kTwo, hn::InterleaveUpper(kFour, a, b));
  const auto lowerRight = hn::BitCast(kTwo, hn::InterleaveUpper(kFour, c, d));
  const auto store = [&](auto row, std::size_t number) {
    hn::StoreU(hn::BitCast(kFour, row), kFour, to + number * width);
  };
  store(hn::InterleaveLower(kTwo, upperLeft, upperRight), 0);
  store(hn::InterleaveUpper(kTwo, upperLeft, upperRight), 1);
  store(hn::InterleaveLower(kTwo, lowerLeft, lowerRight), 2);
  store(hn::InterleaveUpper(kTwo, lowerLeft, lowerRight), 3);
}

#endif

/// Pixels of a column of a strip: behind its last row whole registers are written, and neighbouring
/// columns do not share a set of the cache.
std::size_t pixelsPerColumn(const KernelFrame& frame) { return frame.height + kMaxLanes; }

void drawFrame(const KernelFrame& frame, std::vector<Pixel>& strip, std::vector<Pixel>& picture) {
  constexpr std::size_t kColumns = KernelFrame::kColumns;
  const std::size_t perColumn = pixelsPerColumn(frame);
  strip.resize(kColumns * perColumn);
  picture.resize(frame.width * frame.height);
  for (std::size_t i = 0; i < frame.width / kColumns; ++i) {
    for (std::size_t k = frame.stripBegin[i]; k < frame.stripBegin[i + 1]; ++k) {
      const KernelSpan& span = frame.spans[k];
      draw(span, &strip[span.column % kColumns * perColumn + span.rowBegin]);
    }
    for (std::size_t row = 0; row < frame.height; row += 4)
      for (std::size_t column = 0; column < kColumns; column += 4)
        turn(&strip[column * perColumn + row], perColumn,
             &picture[row * frame.width + i * kColumns + column], frame.width);
  }
}

std::size_t lanes() { return hn::Lanes(kFloat); }

}  // namespace
}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace hearth {

namespace {
HWY_EXPORT(drawFrame);
HWY_EXPORT(lanes);
}  // namespace

std::size_t kernelLanes() { return HWY_DYNAMIC_DISPATCH(lanes)(); }

void drawKernelFrame(const KernelFrame& frame, std::vector<Pixel>& strip,
                     std::vector<Pixel>& picture) {
  HWY_DYNAMIC_DISPATCH(drawFrame)(frame, strip, picture);
}

}  // namespace hearth

#endif
