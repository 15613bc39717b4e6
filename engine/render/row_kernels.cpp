// Compiled once for each instruction set: foreach_target.h includes this file again and again, with
// HWY_NAMESPACE as another name each time. No result depends on the set: every lane is a row of its
// own, and multiplications and additions are never fused.

#include "render/row_kernels.h"

#include <cstring>
#include <type_traits>

#include "math/planted_bug.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/row_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/row_axes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {
namespace {

// Places are found in double precision or, where that is asked for, in single: Reals are Doubles or
// Floats.

#if HWY_TARGET == HWY_SCALAR

HWY_INLINE Floats singlesFrom(const double* from) {
  return hn::DemoteTo(kFloat, hn::LoadU(kDouble, from));
}

template <typename Wide, typename Narrow, typename T>
HWY_INLINE void widen(Wide wide, Narrow narrow, T* to) {
  hn::Store(hn::PromoteTo(wide, narrow), wide, to);
}

#else

/// As many doubles as there are floats in a register.
HWY_INLINE Floats singlesFrom(const double* from) {
  const hn::Half<decltype(kFloat)> half;
  const auto lower = hn::DemoteTo(half, hn::LoadU(kDouble, from));
  const auto upper = hn::DemoteTo(half, hn::LoadU(kDouble, from + hn::Lanes(kDouble)));
  return hn::Combine(kFloat, upper, lower);
}

/// Stores as lanes of twice the size.
template <typename Wide, typename Narrow, typename T>
HWY_INLINE void widen(Wide wide, Narrow narrow, T* to) {
  const hn::Half<hn::DFromV<Narrow> > half;
  hn::Store(hn::PromoteTo(wide, hn::LowerHalf(half, narrow)), wide, to);
  hn::Store(hn::PromoteTo(wide, hn::UpperHalf(half, narrow)), wide, to + hn::Lanes(wide));
}

#endif

HWY_INLINE void load(const double* from, Doubles& reals) { reals = hn::LoadU(kDouble, from); }
HWY_INLINE void load(const double* from, Floats& reals) { reals = singlesFrom(from); }

/// Measures or climbs.
template <typename Reals>
HWY_INLINE Reals loaded(const double* from) {
  Reals reals;
  load(from, reals);
  return reals;
}

template <typename Reals>
constexpr std::size_t lanes() {
  return hn::Lanes(hn::DFromV<Reals>());
}

constexpr hn::RebindToSigned<decltype(kFloat)> kSigned;
using Integers = hn::Vec<decltype(kSigned)>;
constexpr hn::RebindToUnsigned<decltype(kFloat)> kWord;
using Words = hn::Vec<decltype(kWord)>;

/// The number of a texel of which `size` lie one behind the other.
HWY_INLINE Doubles numberOf(Doubles line, Doubles place, int size) {
  return hn::Add(hn::Mul(line, all<Doubles>(size)), place);
}

/// As integers, since floats have no room for the numbers of large images.
HWY_INLINE Integers numberOf(Floats line, Floats place, int size) {
  return hn::Add(hn::Mul(hn::ConvertTo(kSigned, line), hn::Set(kSigned, size)),
                 hn::ConvertTo(kSigned, place));
}

HWY_INLINE void store(Doubles number, std::int32_t* to) {
  const hn::Rebind<std::int32_t, decltype(kDouble)> tag;
  hn::Store(hn::DemoteTo(tag, number), tag, to);
}

HWY_INLINE void store(Integers number, std::int32_t* to) { hn::Store(number, kSigned, to); }

HWY_INLINE void store(Doubles share, float* to) {
  const hn::Rebind<float, decltype(kDouble)> tag;
  hn::Store(hn::DemoteTo(tag, share), tag, to);
}

HWY_INLINE void store(Floats share, float* to) { hn::Store(share, kFloat, to); }

HWY_INLINE void storeDepths(Doubles depths, double* to) { hn::Store(depths, kDouble, to); }
HWY_INLINE void storeDepths(Floats depths, double* to) { widen(kDouble, depths, to); }

/// The first bytes of texels, of which each has so many.
HWY_INLINE void storeBytes(Doubles number, int bytes, std::uint64_t* to) {
  // Whole numbers of less than 2^52: added to it, they are its lowest bits.
  const hn::RebindToUnsigned<decltype(kDouble)> tag;
  const Doubles byte = hn::Mul(number, all<Doubles>(bytes));
  const auto bits = hn::BitCast(tag, hn::Add(byte, all<Doubles>(0x1p52)));
  hn::Store(hn::Xor(bits, hn::BitCast(tag, all<Doubles>(0x1p52))), tag, to);
}

HWY_INLINE void storeBytes(Integers number, int bytes, std::uint64_t* to) {
  const Integers byte = hn::Mul(number, hn::Set(kSigned, bytes));
  widen(hn::RebindToUnsigned<decltype(kDouble)>(), hn::BitCast(kWord, byte), to);
}

template <typename Reals>
void findDepths(RowBatch& batch, const SpanMapping& mapping, const double* climbs) {
  const Reals farthest = all<Reals>(mapping.depth);
  for (std::size_t k = 0; k < batch.count; k += lanes<Reals>()) {
    const Reals climb = loaded<Reals>(climbs + k);
    const Reals found =
        hn::Div(all<Reals>(mapping.height), hn::Sub(climb, all<Reals>(mapping.rise)));
    const auto isInside = hn::And(hn::Ge(found, all<Reals>(0)), hn::Lt(found, farthest));
    storeDepths(hn::IfThenElse(isInside, found, farthest), &batch.depths[k]);
  }
  batch.measures = batch.depths.data();
}

template <typename Reals, typename Columns, typename Rows>
void findTexelsAlong(RowBatch& batch, int height, const Columns& columns, const Rows& rows) {
  for (std::size_t k = 0; k < batch.count; k += lanes<Reals>()) {
    const Reals measure = loaded<Reals>(batch.measures + k);
    store(numberOf(columns.texel(measure), rows.texel(measure), height),
          &batch.texels.upperLeft[k]);
  }
}

template <typename Reals>
void findTexels(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  const int height = image.height();
  const Repeating columns(mapping.u, image.width());
  const Repeating rows(mapping.v, height);
  if (mapping.isPlane) return findTexelsAlong<Reals>(batch, height, columns, rows);
  const SameTexel<Reals> column(columns);
  if (!mapping.isSky) return findTexelsAlong<Reals>(batch, height, column, rows);
  findTexelsAlong<Reals>(batch, height, column, SkyRows(mapping.v, height));
}

template <typename Reals, typename Rows>
void findTexelsAroundAlong(RowBatch& batch, int height, const Repeating& columns,
                           const Rows& rows) {
  for (std::size_t k = 0; k < batch.count; k += lanes<Reals>()) {
    const Reals measure = loaded<Reals>(batch.measures + k);
    const Between<Reals> across = columns.between(measure);
    const Between<Reals> down = rows.between(measure);
    store(numberOf(across.first, down.first, height), &batch.texels.upperLeft[k]);
    store(numberOf(across.next, down.first, height), &batch.texels.upperRight[k]);
    store(numberOf(across.first, down.next, height), &batch.texels.lowerLeft[k]);
    store(numberOf(across.next, down.next, height), &batch.texels.lowerRight[k]);
    store(across.share, &batch.betweenTexels.across[k]);
    store(down.share, &batch.betweenTexels.down[k]);
  }
}

template <typename Reals>
void findTexelsAround(RowBatch& batch, const SpanMapping& mapping, const Texture& image) {
  const int height = image.height();
  const Repeating columns(mapping.u, image.width());
  if (!mapping.isSky)
    return findTexelsAroundAlong<Reals>(batch, height, columns, Repeating(mapping.v, height));
  findTexelsAroundAlong<Reals>(batch, height, columns, SkyRows(mapping.v, height));
}

/// All of the nearer texel where nothing is to be mixed.
template <typename Reals>
HWY_INLINE Reals filtered(Reals share, LightFilter filter) {
  return filter == LightFilter::Nearest ? hn::Floor(hn::Add(share, all<Reals>(0.5))) : share;
}

template <typename Reals, typename Columns>
void findLightTexelsAlong(RowBatch& batch, const Lightmap& lightmap, LightFilter filter,
                          const Columns& columns, const LightAxis& rows) {
  for (std::size_t k = 0; k < batch.count; k += lanes<Reals>()) {
    const Reals measure = loaded<Reals>(batch.measures + k);
    const Between<Reals> across = columns.between(measure);
    const Between<Reals> down = rows.between(measure);
    storeBytes(numberOf(down.first, across.first, lightmap.rect.width), lightmap.channels,
               &batch.lightTexels[k]);
    store(filtered(across.share, filter), &batch.betweenLightTexels.across[k]);
    store(filtered(down.share, filter), &batch.betweenLightTexels.down[k]);
  }
}

template <typename Reals>
void findLightTexels(RowBatch& batch, const SpanMapping& mapping, const Lightmap& lightmap,
                     LightFilter filter) {
  const TexelRect& rect = lightmap.rect;
  const LightAxis columns(mapping.s, rect.i0, rect.width);
  const LightAxis rows(mapping.t, rect.j0, rect.height);
  if (!mapping.isPlane)
    return findLightTexelsAlong<Reals>(batch, lightmap, filter, SamePlace<Reals>(columns), rows);
  findLightTexelsAlong<Reals>(batch, lightmap, filter, columns, rows);
  if (planted(PlantedBug::FlatsUnfiltered)) {
    batch.betweenLightTexels.across.fill(0);
    batch.betweenLightTexels.down.fill(0);
  }
}

template <typename Reals>
constexpr PlaceKernels placeKernels() {
  return {.findDepths = findDepths<Reals>,
          .findTexels = findTexels<Reals>,
          .findTexelsAround = findTexelsAround<Reals>,
          .findLightTexels = findLightTexels<Reals>};
}

// Colours are made in single precision.

struct Channels {
  Floats red;
  Floats green;
  Floats blue;
};

/// The channel whose bits begin at kShift.
template <int kShift>
HWY_INLINE Floats channelOf(Words texels) {
  const Words channel = hn::And(hn::ShiftRight<kShift>(texels), hn::Set(kWord, 255));
  return hn::ConvertTo(kFloat, hn::BitCast(kSigned, channel));
}

HWY_INLINE Channels channelsOf(Words texels) {
  return {channelOf<0>(texels), channelOf<8>(texels), channelOf<16>(texels)};
}

/// `share` of the way from `a` to `b`.
HWY_INLINE Floats mixed(Floats a, Floats b, Floats share) {
  if (planted(PlantedBug::MultiplyAddFused)) return hn::MulAdd(share, hn::Sub(b, a), a);
  return hn::Add(a, hn::Mul(share, hn::Sub(b, a)));
}

HWY_INLINE Channels mixed(const Channels& a, const Channels& b, Floats share) {
  return {mixed(a.red, b.red, share), mixed(a.green, b.green, share), mixed(a.blue, b.blue, share)};
}

/// What is shown of a texture: min(1, lightmap/255 + sector light).
HWY_INLINE Floats shownIn(Floats levels, double sectorLight) {
  const Floats lightmap = hn::Mul(levels, all<Floats>(1 / 255.0F));
  return hn::Min(all<Floats>(1.0F), hn::Add(lightmap, all<Floats>(sectorLight)));
}

HWY_INLINE void storeShown(const Channels& levels, double sectorLight, RowBatch& batch,
                           std::size_t k) {
  hn::Store(shownIn(levels.red, sectorLight), kFloat, &batch.shown[0][k]);
  hn::Store(shownIn(levels.green, sectorLight), kFloat, &batch.shown[1][k]);
  hn::Store(shownIn(levels.blue, sectorLight), kFloat, &batch.shown[2][k]);
}

/// Texels of a lightmap with so many channels.
template <int kChannels>
HWY_INLINE Channels lightOf(Words texels);

/// Of white light, whose level is that of all channels.
template <>
HWY_INLINE Channels lightOf<1>(Words texels) {
  const Floats level = channelOf<0>(texels);
  return {level, level, level};
}

template <>
HWY_INLINE Channels lightOf<3>(Words texels) {
  const Channels levels = channelsOf(texels);
  if (planted(PlantedBug::ChannelLost)) return {levels.red, levels.green, levels.green};
  return levels;
}

/// Two texels of a lightmap that lie side by side, for each row: the left one in the lowest bytes.
template <int kChannels>
class LightPairs {
 public:
  /// At these bytes. The six of a coloured pair are read as eight: `kBefore` of them lie before it.
  template <int kBefore>
  static LightPairs at(const RowBatch& batch, const std::uint8_t* levels) {
    LightPairs pairs;
    for (std::size_t k = 0; k < batch.count; ++k) {
      Read read;
      std::memcpy(&read, levels + batch.lightTexels[k] - kBefore, sizeof read);
      pairs.texels_[k] = read >> 8 * kBefore;
    }
    return pairs;
  }

  /// Mixed `across` of the way from the left one to the right one.
  HWY_INLINE Channels mixedAcross(std::size_t k, Floats across) const {
    Words low;
    Words high;
    hn::LoadInterleaved2(kWord, reinterpret_cast<const std::uint32_t*>(&texels_[k]), low, high);
    const Words right =
        hn::Or(hn::ShiftRight<8 * kChannels>(low), hn::ShiftLeft<32 - 8 * kChannels>(high));
    return mixed(lightOf<kChannels>(low), lightOf<kChannels>(right), across);
  }

 private:
  using Read = std::conditional_t<kChannels == 1, std::uint16_t, std::uint64_t>;

  RowBatch::Rows<std::uint64_t> texels_;
};

/// The four texels of a lightmap around rows.
template <int kChannels>
class LightAround {
 public:
  LightAround(const RowBatch& batch, const std::uint8_t* texels, std::size_t bytesPerRow)
      : batch_(batch),
        upper_(LightPairs<kChannels>::template at<0>(batch, texels)),
        lower_(LightPairs<kChannels>::template at<kBeforeLower>(batch, texels + bytesPerRow)) {}

  HWY_INLINE Channels mixture(std::size_t k) const {
    const Floats across = hn::Load(kFloat, &batch_.betweenLightTexels.across[k]);
    const Floats down = hn::Load(kFloat, &batch_.betweenLightTexels.down[k]);
    return mixed(upper_.mixedAcross(k, across), lower_.mixedAcross(k, across), down);
  }

 private:
  // Two bytes behind the upper pair are those of the lower row, and those before the lower of the
  // upper.
  static constexpr int kBeforeLower = kChannels == 1 ? 0 : 2;

  const RowBatch& batch_;
  LightPairs<kChannels> upper_;
  LightPairs<kChannels> lower_;
};

/// `share` of b added to a.
HWY_INLINE Channels added(const Channels& a, const Channels& b, float share) {
  const auto sum = [&](Floats x, Floats y) { return hn::Add(x, hn::Mul(y, all<Floats>(share))); };
  return {sum(a.red, b.red), sum(a.green, b.green), sum(a.blue, b.blue)};
}

template <int kChannels>
void findShownIn(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
  const auto bytesPerRow = static_cast<std::size_t>(lightmap.rect.width) * kChannels;
  const LightAround<kChannels> levels(batch, lightmap.levels.data(), bytesPerRow);
  if (lightmap.fractions.empty()) {
    for (std::size_t k = 0; k < batch.count; k += hn::Lanes(kFloat))
      storeShown(levels.mixture(k), sectorLight, batch, k);
    return;
  }
  const LightAround<kChannels> fractions(batch, lightmap.fractions.data(), bytesPerRow);
  for (std::size_t k = 0; k < batch.count; k += hn::Lanes(kFloat))
    storeShown(added(levels.mixture(k), fractions.mixture(k), 1 / 256.0F), sectorLight, batch, k);
}

void findShown(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
  batch.isEvenlyLit = false;
  if (lightmap.channels == 1) return findShownIn<1>(batch, lightmap, sectorLight);
  findShownIn<3>(batch, lightmap, sectorLight);
}

HWY_INLINE Channels allOf(Rgb color) {
  return {all<Floats>(static_cast<float>(color.r)), all<Floats>(static_cast<float>(color.g)),
          all<Floats>(static_cast<float>(color.b))};
}

/// The one texel of a lightmap.
HWY_INLINE Channels evenLight(const Lightmap& lightmap) {
  const auto channel = [&](int number) {
    return all<Floats>(
        static_cast<float>(lightmap.levelAt(lightmap.rect.i0, lightmap.rect.j0, number)));
  };
  return {channel(0), channel(1), channel(2)};
}

void showEvenly(RowBatch& batch, const Lightmap* lightmap, double sectorLight) {
  batch.isEvenlyLit = true;
  storeShown(lightmap ? evenLight(*lightmap) : allOf(Rgb{}), sectorLight, batch, 0);
}

/// More than single precision can lose of a level where light is a number that an author wrote.
constexpr float kLostOfLevel = 0x1p-15F;

/// Each channel rounded half up, once. Halves are common, as authors write sector light in decimals
/// (15 * 0.3); none may be lost by a hair. Added to 2^23 a level is its lowest bits; what else is
/// set are the highest eight.
HWY_INLINE Words shaded(Floats color, Floats shown) {
  const float half = planted(PlantedBug::RoundingTruncates) ? 0 : 0.5F + kLostOfLevel;
  const Floats level = hn::Floor(hn::Add(hn::Mul(color, shown), all<Floats>(half)));
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
    const Words pixel = shaded(colors.at(k), batch, batch.isEvenlyLit ? 0 : k);
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
  TexelColors(const Texture& image, const RowBatch::Texels& texels, std::size_t count) {
    for (std::size_t k = 0; k < count; ++k) colors_[k] = image.texels()[texels[k]];
  }

  HWY_INLINE Channels at(std::size_t k) const { return channelsOf(hn::Load(kWord, &colors_[k])); }

 private:
  RowBatch::Rows<Pixel> colors_;
};

void shadeTexels(Pixel* pixels, const RowBatch& batch, const Texture& image) {
  shade(pixels, batch, TexelColors(image, batch.texels.upperLeft, batch.count));
}

class Mixtures {
 public:
  Mixtures(const Texture& image, const RowBatch& batch)
      : upperLeft_(image, batch.texels.upperLeft, batch.count),
        upperRight_(image, batch.texels.upperRight, batch.count),
        lowerLeft_(image, batch.texels.lowerLeft, batch.count),
        lowerRight_(image, batch.texels.lowerRight, batch.count),
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
      .inDoubles = placeKernels<Doubles>(),
      .inSingles = placeKernels<Floats>(),
      .findShown = findShown,
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
