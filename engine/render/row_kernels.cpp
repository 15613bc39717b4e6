// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: every lane is a row of its
// own, and multiplications and additions are never fused.

#include "render/row_kernels.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/row_axes-inl.h"
#include "render/row_light-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

/// The number of a texel of which `size` lie one behind the other.
HWY_INLINE Doubles numberOf(Doubles line, Doubles place, int size) {
  return hn::Add(hn::Mul(line, all<Doubles>(size)), place);
}

/// The same where `size` is a power of two.
template <typename Bits>
HWY_INLINE Bits numberOf(Bits line, Bits place, int size) {
  return hn::Or(hn::ShiftLeftSame(line, std::countr_zero(static_cast<unsigned>(size))), place);
}

HWY_INLINE void store(Words number, std::int32_t* to) {
  hn::Store(number, kWord, reinterpret_cast<std::uint32_t*>(to));
}

HWY_INLINE void store(LongWords number, std::int32_t* to) {
  const hn::Rebind<std::uint32_t, decltype(kLongWord)> tag;
  hn::Store(hn::TruncateTo(tag, number), tag, reinterpret_cast<std::uint32_t*>(to));
}

HWY_INLINE void store(Doubles number, std::int32_t* to) {
  const hn::Rebind<std::int32_t, decltype(kDouble)> tag;
  hn::Store(hn::DemoteTo(tag, number), tag, to);
}

HWY_INLINE void store(Doubles fraction, float* to) {
  const hn::Rebind<float, decltype(kDouble)> tag;
  hn::Store(hn::DemoteTo(tag, fraction), tag, to);
}

/// The first bytes of texels, of which each has so many.
HWY_INLINE void storeBytes(Doubles number, int bytes, std::uint64_t* to) {
  // Whole numbers of less than 2^52: added to it, they are its lowest bits.
  const Doubles byte = hn::Mul(number, all<Doubles>(bytes));
  const LongWords bits = hn::BitCast(kLongWord, hn::Add(byte, all<Doubles>(0x1p52)));
  hn::Store(hn::Xor(bits, hn::BitCast(kLongWord, all<Doubles>(0x1p52))), kLongWord, to);
}

void findDepths(RowBatch& batch, const SpanMapping& mapping, const double* raySlopes) {
  const Doubles farthest = all<Doubles>(mapping.depth);
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kDouble)) {
    const Doubles raySlope = hn::LoadU(kDouble, raySlopes + k);
    const Doubles found =
        hn::Div(all<Doubles>(mapping.height), hn::Sub(raySlope, all<Doubles>(mapping.rise)));
    const auto isInside = hn::And(hn::Ge(found, all<Doubles>(0)), hn::Lt(found, farthest));
    hn::Store(hn::IfThenElse(isInside, found, farthest), kDouble, &batch.depths[k]);
  }
  batch.parameters = batch.depths.data();
}

template <typename Columns, typename Rows>
void findTexelsAlong(RowBatch& batch, int height, const Columns& columns, const Rows& rows) {
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kDouble)) {
    const Doubles parameter = hn::LoadU(kDouble, batch.parameters + k);
    store(numberOf(columns.texel(parameter), rows.texel(parameter), height),
          &batch.texels.upperLeft[k]);
  }
}

template <typename Axis>
void findRepeatingTexels(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  const Axis columns(mapping.u, image.width());
  const Axis rows(mapping.v, image.height());
  if (mapping.isPlane) return findTexelsAlong(batch, image.height(), columns, rows);
  findTexelsAlong(batch, image.height(), SameTexel(columns), rows);
}

bool isPowerOfTwo(int size) { return std::has_single_bit(static_cast<unsigned>(size)); }

#if HWY_TARGET != HWY_SCALAR

/// `number(lower, upper)` for the parameters of each half of a register.
template <typename Number>
void storeTexels(RowBatch& batch, const Number& number) {
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kFloat)) {
    const Doubles lower = hn::LoadU(kDouble, batch.parameters + k);
    const Doubles upper = hn::LoadU(kDouble, batch.parameters + k + hn::Lanes(kDouble));
    store(number(lower, upper), &batch.texels.upperLeft[k]);
  }
}

/// Where all rows have one column.
template <bool kIsPowerOfTwo>
bool findTexelsInFixedPoint(RowBatch& batch, int height, std::uint32_t first,
                            const ImageAxis& along) {
  RepeatingInFixedPoint<kIsPowerOfTwo> rows(along, height);
  storeTexels(batch, [&](Doubles lower, Doubles upper) {
    return hn::Add(rows.texel(lower, upper), hn::Set(kWord, first));
  });
  return rows.isSure();
}

template <bool kIsPowerOfTwo>
bool findTexelsInFixedPoint(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  RepeatingInFixedPoint<kIsPowerOfTwo> columns(mapping.u, image.width());
  RepeatingInFixedPoint<kIsPowerOfTwo> rows(mapping.v, image.height());
  const int height = image.height();
  storeTexels(batch, [&](Doubles lower, Doubles upper) {
    const Words column = columns.texel(lower, upper);
    const Words row = rows.texel(lower, upper);
    if constexpr (kIsPowerOfTwo) return numberOf(column, row, height);
    return hn::Add(hn::Mul(column, hn::Set(kWord, static_cast<std::uint32_t>(height))), row);
  });
  return columns.isSure() && rows.isSure();
}

std::uint32_t columnOfAllRows(const ImageAxis& along, int width) {
  const auto columnBy = [](const auto& axis) {
    return static_cast<std::uint32_t>(hn::GetLane(axis.texel(all<Doubles>(0))));
  };
  if (isPowerOfTwo(width)) return columnBy(RepeatingByBits(along, width));
  return columnBy(Repeating(along, width));
}

/// False where that cannot tell the texels: then they are to be found in another way.
bool findTexelsInFixedPoint(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  using Axis = RepeatingInFixedPoint<false>;
  const double most =
      std::max(std::abs(batch.parameters[0]), std::abs(batch.parameters[batch.count - 1]));
  const int height = image.height();
  if (mapping.isSky || !Axis::holds(mapping.v, height, most)) return false;
  const bool byBits = isPowerOfTwo(height);
  if (!mapping.isPlane) {
    const std::uint32_t first =
        columnOfAllRows(mapping.u, image.width()) * static_cast<std::uint32_t>(height);
    return byBits ? findTexelsInFixedPoint<true>(batch, height, first, mapping.v)
                  : findTexelsInFixedPoint<false>(batch, height, first, mapping.v);
  }
  if (!Axis::holds(mapping.u, image.width(), most)) return false;
  return byBits && isPowerOfTwo(image.width())
             ? findTexelsInFixedPoint<true>(batch, mapping, image)
             : findTexelsInFixedPoint<false>(batch, mapping, image);
}

#endif

void findTexels(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
#if HWY_TARGET != HWY_SCALAR
  if (findTexelsInFixedPoint(batch, mapping, image)) return;
#endif
  if (!mapping.isSky && isPowerOfTwo(image.width()) && isPowerOfTwo(image.height()))
    return findRepeatingTexels<RepeatingByBits>(batch, mapping, image);
  if (!mapping.isSky) return findRepeatingTexels<Repeating>(batch, mapping, image);
  const SameTexel column(Repeating(mapping.u, image.width()));
  findTexelsAlong(batch, image.height(), column, SkyRows(mapping.v, image.height()));
}

template <typename Rows>
void findTexelsAroundAlong(RowBatch& batch, int height, const Repeating& columns,
                           const Rows& rows) {
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kDouble)) {
    const Doubles parameter = hn::LoadU(kDouble, batch.parameters + k);
    const Between across = columns.between(parameter);
    const Between down = rows.between(parameter);
    store(numberOf(across.first, down.first, height), &batch.texels.upperLeft[k]);
    store(numberOf(across.next, down.first, height), &batch.texels.upperRight[k]);
    store(numberOf(across.first, down.next, height), &batch.texels.lowerLeft[k]);
    store(numberOf(across.next, down.next, height), &batch.texels.lowerRight[k]);
    store(across.fraction, &batch.betweenTexels.across[k]);
    store(down.fraction, &batch.betweenTexels.down[k]);
  }
}

void findTexelsAround(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  const int height = image.height();
  const Repeating columns(mapping.u, image.width());
  if (!mapping.isSky)
    return findTexelsAroundAlong(batch, height, columns, Repeating(mapping.v, height));
  findTexelsAroundAlong(batch, height, columns, SkyRows(mapping.v, height));
}

/// All of the nearer texel where nothing is to be mixed.
HWY_INLINE Doubles filtered(Doubles fraction, LightFilter filter) {
  return filter == LightFilter::Nearest ? hn::Floor(hn::Add(fraction, all<Doubles>(0.5)))
                                        : fraction;
}

void findLightTexels(RowBatch& batch, const SpanMapping& mapping, const Lightmap& lightmap,
                     LightFilter filter) {
  const LightAxis columns(mapping.s, lightmap.rect.i0, lightmap.rect.width);
  const LightAxis rows(mapping.t, lightmap.rect.j0, lightmap.rect.height);
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kDouble)) {
    const Doubles parameter = hn::LoadU(kDouble, batch.parameters + k);
    const Between across = columns.between(parameter);
    const Between down = rows.between(parameter);
    storeBytes(numberOf(down.first, across.first, lightmap.rect.width), lightmap.channels,
               &batch.lightTexels[k]);
    store(filtered(across.fraction, filter), &batch.betweenLightTexels.across[k]);
    store(filtered(down.fraction, filter), &batch.betweenLightTexels.down[k]);
  }
}

void findLightRows(RowBatch& batch, const SpanMapping& mapping, const Lightmap& lightmap,
                   LightFilter filter) {
  const LightAxis columns(mapping.s, lightmap.rect.i0, lightmap.rect.width);
  const Between across = columns.between(all<Doubles>(0));
  batch.lightColumn = static_cast<std::size_t>(hn::GetLane(across.first)) *
                      static_cast<std::size_t>(lightmap.channels);
  batch.acrossLightColumns = static_cast<float>(hn::GetLane(filtered(across.fraction, filter)));
  const LightAxis rows(mapping.t, lightmap.rect.j0, lightmap.rect.height);
  for (std::size_t k = 0; k < batch.worked(); k += hn::Lanes(kDouble)) {
    const Between down = rows.between(hn::LoadU(kDouble, batch.parameters + k));
    store(down.first, &batch.lightRows[k]);
    store(filtered(down.fraction, filter), &batch.betweenLightTexels.down[k]);
  }
}

/// More than single precision can lose of a level where light is a number that an author wrote.
constexpr float kLostOfLevel = 0x1p-15F;

/// Each channel rounded half up, once. Halves are common, as authors write sector light in decimals
/// (15 * 0.3); none may be lost by a hair. Added to 2^23 a level is its lowest bits; what else is
/// set are the highest eight.
HWY_INLINE Words shaded(Floats color, Floats shown) {
  const Floats level = hn::Floor(hn::Add(hn::Mul(color, shown), all<Floats>(0.5F + kLostOfLevel)));
  return hn::BitCast(kWord, hn::Add(level, all<Floats>(0x1p23F)));
}

HWY_INLINE Words shaded(const Channels& color, const RowBatch& batch, std::size_t k) {
  const Words red = shaded(color.red, hn::Load(kFloat, &batch.shown[0][k]));
  const Words green = shaded(color.green, hn::Load(kFloat, &batch.shown[1][k]));
  const Words blue = shaded(color.blue, hn::Load(kFloat, &batch.shown[2][k]));
  return hn::Or(hn::Or(red, hn::ShiftLeft<8>(green)), hn::ShiftLeft<16>(blue));
}

/// `colors.at(k)` are those of the rows from k on.
template <typename Colors>
void shade(Pixel* pixels, const RowBatch& batch, const Colors& colors) {
  for (std::size_t k = 0; k < batch.count; k += hn::Lanes(kFloat)) {
    const Words pixel = shaded(colors.at(k), batch, batch.isUniformlyLit ? 0 : k);
    if (k + hn::Lanes(kFloat) <= batch.count)
      hn::StoreU(pixel, kWord, pixels + k);
    else
      hn::BlendedStore(pixel, hn::FirstN(kWord, batch.count - k), kWord, pixels + k);
  }
}

struct OneColor {
  Channels color;

  HWY_INLINE Channels at(std::size_t) const { return color; }
};

void shadeColor(Pixel* pixels, const RowBatch& batch, Rgb color) {
  shade(pixels, batch, OneColor{allOf(color)});
}

/// Texels read one by one, which takes no longer than gathering them.
class TexelColors {
 public:
  TexelColors(const Texture& image, const RowBatch& batch, const RowBatch::Texels& texels) {
    batch.forEachWorked([&](std::size_t k) { colors_[k] = image.texels()[texels[k]]; });
  }

  HWY_INLINE Channels at(std::size_t k) const { return channelsOf(hn::Load(kWord, &colors_[k])); }

 private:
  RowBatch::Rows<Pixel> colors_;
};

void shadeTexels(Pixel* pixels, const RowBatch& batch, const Texture& image) {
  shade(pixels, batch, TexelColors(image, batch, batch.texels.upperLeft));
}

class Mixtures {
 public:
  Mixtures(const Texture& image, const RowBatch& batch)
      : upperLeft_(image, batch, batch.texels.upperLeft),
        upperRight_(image, batch, batch.texels.upperRight),
        lowerLeft_(image, batch, batch.texels.lowerLeft),
        lowerRight_(image, batch, batch.texels.lowerRight),
        between_(batch.betweenTexels) {}

  HWY_INLINE Channels at(std::size_t k) const {
    const Floats across = hn::Load(kFloat, &between_.across[k]);
    return mixed(mixed(upperLeft_.at(k), upperRight_.at(k), across),
                 mixed(lowerLeft_.at(k), lowerRight_.at(k), across),
                 hn::Load(kFloat, &between_.down[k]));
  }

 private:
  TexelColors upperLeft_;
  TexelColors upperRight_;
  TexelColors lowerLeft_;
  TexelColors lowerRight_;
  const RowBatch::Between& between_;
};

void shadeMixtures(Pixel* pixels, const RowBatch& batch, const Texture& image) {
  shade(pixels, batch, Mixtures(image, batch));
}

const RowKernels& kernels() {
  static constexpr RowKernels kKernels{
      .findDepths = findDepths,
      .findTexels = findTexels,
      .findTexelsAround = findTexelsAround,
      .findLightTexels = findLightTexels,
      .findLightRows = findLightRows,
      .findShown = findShown,
      .findShownUpright = findShownUpright,
      .showEvenly = showEvenly,
      .shadeColor = shadeColor,
      .shadeTexels = shadeTexels,
      .shadeMixtures = shadeMixtures,
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

const RowKernels& rowKernels() { return HWY_DYNAMIC_DISPATCH(kernels)(); }

}  // namespace hearth

#endif
