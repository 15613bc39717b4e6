// The colours of the pixels of a block in their light. Included once for each instruction set: see
// pixel_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_PIXEL_SHADING) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_PIXEL_SHADING
#undef HEARTH_RENDER_PIXEL_SHADING
#else
#define HEARTH_RENDER_PIXEL_SHADING
#endif

#include <hwy/highway.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "light/lightmap.h"
#include "render/pixel_colors-inl.h"
#include "render/pixel_kernels.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

HWY_INLINE Weights weightsAt(const PixelBlock::Mix& mix, std::size_t pixel) {
  return {hn::Load(kWord, &mix.across[pixel]), hn::Load(kWord, &mix.down[pixel])};
}

/// White.
struct NoTexels {
  HWY_INLINE Words colors(std::size_t) const { return allWords(0xFFFFFF); }
};

struct NearestTexels {
  const PixelBlock& block;

  HWY_INLINE Words colors(std::size_t pixel) const {
    return hn::Load(kWord, &block.colors[0][pixel]);
  }
};

/// Holes are those of the first texels.
template <bool kHasHoles>
struct MixedTexels {
  const PixelBlock& block;

  HWY_INLINE Words colors(std::size_t pixel) const {
    const auto at = [&](std::size_t i)
                        HWY_ATTR { return channelsOf(hn::Load(kWord, &block.colors[i][pixel])); };
    const Words colors = colorsOf(
        neighbourhoodOf(at(0), at(1), at(2), at(3)).at(weightsAt(block.betweenTexels, pixel)));
    if (!kHasHoles) return colors;
    return hn::Or(colors, hn::And(hn::Load(kWord, &block.colors[0][pixel]), allWords(kHoleBit)));
  }
};

/// The same light in all pixels.
class UniformLight {
 public:
  UniformLight(const Lightmap* lightmap, const EvenLight& even) {
    const auto level = [&](int channel) {
      if (!lightmap) return std::uint32_t{0};
      return std::uint32_t{lightmap->at(lightmap->rect.i0, lightmap->rect.j0, channel)};
    };
    shown_ = even.shownWith(channelsOf(allWords(level(0) << 16 | level(1) << 8 | level(2))));
  }

  HWY_INLINE Channels shown(std::size_t, std::size_t) const { return shown_; }

 private:
  Channels shown_;
};

/// The texels around the last pixels of each register of a row. Light is coarse: often the next row
/// has the same ones.
template <typename Neighbours>
class KeptTexels {
 public:
  HWY_INLINE KeptTexels() { texels_.fill(allWords(~std::uint32_t{0})); }

  /// `find()` finds those around the pixels from `lane` on, which are between these texels.
  template <typename Find>
  HWY_INLINE const Neighbours& around(Words texels, std::size_t lane, Find&& find) {
    const std::size_t i = lane / hn::MaxLanes(kWord);
    if (!hn::AllTrue(kWord, hn::Eq(texels, texels_[i]))) {
      texels_[i] = texels;
      neighbours_[i] = find();
    }
    return neighbours_[i];
  }

 private:
  static constexpr std::size_t kRegisters = kLanes / hn::MaxLanes(kWord);

  std::array<Words, kRegisters> texels_;
  std::array<Neighbours, kRegisters> neighbours_;
};

#if HWY_TARGET == HWY_SCALAR

/// word(k) of each pixel k of a register.
template <typename Word>
HWY_INLINE Words assembled(Word&& word) {
  return allWords(word(0));
}

#else

/// Numbers number(k) from the first on, put together in registers.
template <typename D, typename Number>
HWY_INLINE hn::Vec<D> assembled(D d, std::size_t first, Number&& number) {
  if constexpr (hn::MaxLanes(D()) == 1) {
    return hn::Set(d, number(first));
  } else {
    const hn::Half<D> half;
    return hn::Combine(d, assembled(half, first + hn::MaxLanes(half), number),
                       assembled(half, first, number));
  }
}

/// word(k) of each pixel k of a register. Written to memory word by word, they could not be read as
/// a register before they have arrived there.
template <typename Word>
HWY_INLINE Words assembled(Word&& word) {
  constexpr hn::Repartition<std::uint64_t, decltype(kWord)> kTwoWords;
  return hn::BitCast(kWord, assembled(kTwoWords, 0, [&](std::size_t k) HWY_ATTR {
                       return word(2 * k) | std::uint64_t{word(2 * k + 1)} << 32;
                     }));
}

#endif

/// Texels of a lightmap whose light is white.
class WhiteTexels {
 public:
  WhiteTexels(const PixelBlock& block, const Lightmap& lightmap)
      : block_(block), upper_(lightmap.levels.data()), lower_(upper_ + lightmap.rect.width) {}

  /// Those around as many pixels as a register holds.
  HWY_INLINE Neighbourhood around(std::size_t pixel) const {
    const Words four = assembled([&](std::size_t k) HWY_ATTR {
      const std::uint32_t texel = block_.lightTexels[pixel + k];
      std::uint16_t upper = 0;
      std::uint16_t lower = 0;
      std::memcpy(&upper, upper_ + texel, sizeof upper);
      std::memcpy(&lower, lower_ + texel, sizeof lower);
      return upper | std::uint32_t{lower} << 16;
    });
    const auto level = [](Words words) HWY_ATTR {
      return hn::ShiftLeft<kLevelBits>(twice(hn::And(words, allWords(0xFF))));
    };
    return neighbourhoodOf(level(four), level(hn::ShiftRight<8>(four)),
                           level(hn::ShiftRight<16>(four)), level(hn::ShiftRight<24>(four)));
  }

 private:
  const PixelBlock& block_;
  const std::uint8_t* upper_;
  const std::uint8_t* lower_;
};

/// Texels of a lightmap with three channels: red in the lowest byte.
class ColoredTexels {
 public:
  ColoredTexels(const PixelBlock& block, const Lightmap& lightmap)
      : block_(block),
        upper_(lightmap.levels.data()),
        lower_(upper_ + std::size_t{3} * static_cast<std::size_t>(lightmap.rect.width) - 2) {}

  /// Those around as many pixels as a register holds. The six bytes of a pair are read as eight.
  /// The two more are behind the upper pair, where the lower row of the lightmap follows, and
  /// before the lower pair.
  HWY_INLINE ColorNeighbourhood around(std::size_t pixel) const {
    Words low;
    Words high;
    load(upper_, pixel, low, high);
    const Channels upperLeft = inPictureOrder(low);
    const Channels upperRight =
        inPictureOrder(hn::Or(hn::ShiftRight<24>(low), hn::ShiftLeft<8>(high)));
    load(lower_, pixel, low, high);
    const Channels lowerLeft =
        inPictureOrder(hn::Or(hn::ShiftRight<16>(low), hn::ShiftLeft<16>(high)));
    const Channels lowerRight = inPictureOrder(hn::ShiftRight<8>(high));
    return neighbourhoodOf(upperLeft, upperRight, lowerLeft, lowerRight);
  }

 private:
  HWY_INLINE void load(const std::uint8_t* from, std::size_t pixel, Words& low, Words& high) const {
    alignas(64) std::array<std::uint32_t, 2 * kLanes> pairs;
    for (std::size_t k = 0; k < hn::Lanes(kWord); ++k)
      std::memcpy(&pairs[2 * k], from + block_.lightTexels[pixel + k], 2 * sizeof pairs[0]);
    hn::LoadInterleaved2(kWord, pairs.data(), low, high);
  }

  /// Pictures have blue in the lowest byte.
  static HWY_INLINE Channels inPictureOrder(Words colors) {
    const Channels channels = channelsOf(colors);
    return {withFieldsSwapped(channels.outer), channels.middle};
  }

  const PixelBlock& block_;
  const std::uint8_t* upper_;
  const std::uint8_t* lower_;
};

/// Light between the texels of a lightmap.
template <typename Texels>
class LightBetween {
 public:
  LightBetween(const PixelBlock& block, const Texels& texels, const EvenLight& even)
      : block_(block), texels_(texels), even_(even) {}

  HWY_INLINE Channels shown(std::size_t pixel, std::size_t lane) {
    const auto& near = kept_.around(hn::Load(kWord, &block_.lightTexels[pixel]), lane,
                                    [&]() HWY_ATTR { return texels_.around(pixel); });
    return even_.shownWith(near.at(weightsAt(block_.betweenLightTexels, pixel)));
  }

 private:
  const PixelBlock& block_;
  Texels texels_;
  EvenLight even_;
  KeptTexels<decltype(texels_.around(0))> kept_;
};

/// The same where all pixels of a column lie at the same fraction of the way between the same two
/// columns of texels.
template <typename Texels>
class ColumnLightBetween {
 public:
  ColumnLightBetween(const PixelBlock& block, const Texels& texels, const EvenLight& even)
      : block_(block), texels_(texels), even_(even) {}

  HWY_INLINE Channels shown(std::size_t pixel, std::size_t lane) {
    const PixelBlock::Mix& mix = block_.betweenLightTexels;
    const auto& rows =
        kept_.around(hn::Load(kWord, &block_.lightTexels[pixel]), lane, [&]() HWY_ATTR {
          return texels_.around(pixel).rowsAt(hn::Load(kWord, &mix.across[pixel]));
        });
    return even_.shownWith(rows.at(hn::Load(kWord, &mix.down[pixel])));
  }

 private:
  const PixelBlock& block_;
  Texels texels_;
  EvenLight even_;
  KeptTexels<decltype(texels_.around(0).rowsAt(Words()))> kept_;
};

/// Writes pixels of rows where their columns show the surface, except those of holes.
template <bool kHasHoles, typename Texels, typename Light>
inline void shadeIn(const PixelBlock& block, const Texels& texels, Light light,
                    std::uint32_t* rows) {
  for (int i = 0; i < block.rows; ++i) {
    const int row = block.firstRow + i;
    const bool isFull = row >= block.columns.fullBegin && row < block.columns.fullEnd;
    for (std::size_t lane = 0; lane < kLanes; lane += hn::Lanes(kWord)) {
      const std::size_t pixel = static_cast<std::size_t>(i) * kLanes + lane;
      const Words colors = texels.colors(pixel);
      const Words pixels = shaded(colors, light.shown(pixel, lane));
      if (isFull && !kHasHoles) {
        hn::StoreU(pixels, kWord, rows + pixel);
        continue;
      }
      auto isShown =
          hn::Gt(hn::BitCast(kSigned, kHasHoles ? colors : allWords(0)), hn::Set(kSigned, -1));
      if (!isFull)
        isShown =
            hn::And(isShown, hn::And(hn::Gt(hn::Set(kSigned, row + 1),
                                            hn::Load(kSigned, &block.columns.rows.begin[lane])),
                                     hn::Gt(hn::Load(kSigned, &block.columns.rows.end[lane]),
                                            hn::Set(kSigned, row))));
      const Words before = hn::LoadU(kWord, rows + pixel);
      hn::StoreU(hn::IfThenElse(hn::RebindMask(kWord, isShown), pixels, before), kWord,
                 rows + pixel);
    }
  }
}

template <typename Light>
inline void shadeTexels(const PixelBlock& block, const GroupTexels& texels, const Light& light,
                        std::uint32_t* rows) {
  if (texels.areWhite && !texels.haveHoles) return shadeIn<false>(block, NoTexels(), light, rows);
  if (texels.areMixed && texels.haveHoles)
    return shadeIn<true>(block, MixedTexels<true>{block}, light, rows);
  if (texels.areMixed) return shadeIn<false>(block, MixedTexels<false>{block}, light, rows);
  if (texels.haveHoles) return shadeIn<true>(block, NearestTexels{block}, light, rows);
  shadeIn<false>(block, NearestTexels{block}, light, rows);
}

template <typename LightTexels>
inline void shadeBetween(const PixelBlock& block, const GroupTexels& texels,
                         const LightTexels& lightTexels, bool keepsColumns, const EvenLight& even,
                         std::uint32_t* rows) {
  if (keepsColumns)
    shadeTexels(block, texels, ColumnLightBetween(block, lightTexels, even), rows);
  else
    shadeTexels(block, texels, LightBetween(block, lightTexels, even), rows);
}

inline void shade(const PixelBlock& block, const GroupTexels& texels, const GroupLight& light,
                  std::uint32_t* rows) {
  const EvenLight even(light.evenLight);
  if (!light.varies())
    shadeTexels(block, texels, UniformLight(light.lightmap, even), rows);
  else if (light.lightmap->channels == 1)
    shadeBetween(block, texels, WhiteTexels(block, *light.lightmap), light.keepsColumns, even,
                 rows);
  else
    shadeBetween(block, texels, ColoredTexels(block, *light.lightmap), light.keepsColumns, even,
                 rows);
}

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
