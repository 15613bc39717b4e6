// The light of rows: what shows of a texture's channels in that of a lightmap. Included once for
// each instruction set: see row_kernels.cpp, and Highway's guide on the guard.

#if defined(HEARTH_RENDER_ROW_LIGHT) == defined(HWY_TARGET_TOGGLE)
#ifdef HEARTH_RENDER_ROW_LIGHT
#undef HEARTH_RENDER_ROW_LIGHT
#else
#define HEARTH_RENDER_ROW_LIGHT
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstring>
#include <type_traits>

#include "light/lightmap.h"
#include "render/row_axes-inl.h"
#include "render/row_batch.h"

HWY_BEFORE_NAMESPACE();
namespace hearth::HWY_NAMESPACE {

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

/// `fraction` of the way from `a` to `b`.
HWY_INLINE Floats mixed(Floats a, Floats b, Floats fraction) {
  return hn::Add(a, hn::Mul(fraction, hn::Sub(b, a)));
}

HWY_INLINE Channels mixed(const Channels& a, const Channels& b, Floats fraction) {
  return {mixed(a.red, b.red, fraction), mixed(a.green, b.green, fraction),
          mixed(a.blue, b.blue, fraction)};
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
  return channelsOf(texels);
}

/// Two texels of a lightmap that lie side by side, for each row: the left one in the lowest bytes.
template <int kChannels>
class LightPairs {
 public:
  // The six bytes of a coloured pair are read as eight. Where there is a row of the lightmap below
  // the two more are behind the pair, and else before it, as there is one above.

  HWY_INLINE void readAboveOther(std::size_t k, const std::uint8_t* pair) { read<0>(k, pair); }
  HWY_INLINE void readBelowOther(std::size_t k, const std::uint8_t* pair) {
    read<kChannels == 1 ? 0 : 2>(k, pair);
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

  template <int kBefore>
  HWY_INLINE void read(std::size_t k, const std::uint8_t* pair) {
    Read bytes;
    std::memcpy(&bytes, pair - kBefore, sizeof bytes);
    texels_[k] = bytes >> 8 * kBefore;
  }

  RowBatch::Rows<std::uint64_t> texels_;
};

template <int kChannels>
std::size_t bytesPerRow(const Lightmap& lightmap) {
  return static_cast<std::size_t>(lightmap.rect.width) * kChannels;
}

/// The four texels of a lightmap around rows.
template <int kChannels>
class LightAround {
 public:
  LightAround(const RowBatch& batch, const Lightmap& lightmap) : batch_(batch) {
    const std::uint8_t* const texels = lightmap.levels.data();
    const std::size_t rowBytes = bytesPerRow<kChannels>(lightmap);
    batch.forEachWorked([&](std::size_t k) {
      const std::uint8_t* const upper = texels + batch.lightTexels[k];
      upper_.readAboveOther(k, upper);
      lower_.readBelowOther(k, upper + rowBytes);
    });
  }

  HWY_INLINE Channels mixture(std::size_t k) const {
    const Floats across = hn::Load(kFloat, &batch_.betweenLightTexels.across[k]);
    const Floats down = hn::Load(kFloat, &batch_.betweenLightTexels.down[k]);
    return mixed(upper_.mixedAcross(k, across), lower_.mixedAcross(k, across), down);
  }

 private:
  const RowBatch& batch_;
  LightPairs<kChannels> upper_;
  LightPairs<kChannels> lower_;
};

/// Those of white light fit into a word: the upper two in its lower bytes.
template <>
class LightAround<1> {
 public:
  LightAround(const RowBatch& batch, const Lightmap& lightmap) : batch_(batch) {
    const std::uint8_t* const texels = lightmap.levels.data();
    const std::size_t rowBytes = bytesPerRow<1>(lightmap);
    batch.forEachWorked([&](std::size_t k) {
      const std::uint8_t* const upper = texels + batch.lightTexels[k];
      texels_[k] = pairAt(upper) | pairAt(upper + rowBytes) << 16;
    });
  }

  HWY_INLINE Channels mixture(std::size_t k) const {
    const Floats across = hn::Load(kFloat, &batch_.betweenLightTexels.across[k]);
    const Floats down = hn::Load(kFloat, &batch_.betweenLightTexels.down[k]);
    const Words texels = hn::Load(kWord, &texels_[k]);
    const Floats level = mixed(mixed(channelOf<0>(texels), channelOf<8>(texels), across),
                               mixed(channelOf<16>(texels), channelOf<24>(texels), across), down);
    return {level, level, level};
  }

 private:
  static HWY_INLINE std::uint32_t pairAt(const std::uint8_t* texels) {
    std::uint16_t pair;
    std::memcpy(&pair, texels, sizeof pair);
    return pair;
  }

  const RowBatch& batch_;
  RowBatch::Rows<std::uint32_t> texels_;
};

/// What is shown in the light of rows, which `light.mixture(k)` is of those from k on.
template <typename Light>
void storeShownIn(const Light& light, double sectorLight, RowBatch& batch) {
  for (std::size_t k = 0; k < batch.count; k += hn::Lanes(kFloat))
    storeShown(light.mixture(k), sectorLight, batch, k);
}

template <int kChannels>
void findShownIn(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
  storeShownIn(LightAround<kChannels>(batch, lightmap), sectorLight, batch);
}

inline void findShown(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
  batch.isUniformlyLit = false;
  if (lightmap.channels == 1) return findShownIn<1>(batch, lightmap, sectorLight);
  findShownIn<3>(batch, lightmap, sectorLight);
}

#if HWY_TARGET != HWY_SCALAR

/// What lies between two columns of a lightmap, row by row: in as many rows as registers hold, from
/// the first one that a batch needs.
template <int kChannels, int kRegisters>
class LightColumn {
 public:
  LightColumn(const RowBatch& batch, const Lightmap& lightmap, int first, std::size_t rows)
      : batch_(batch), first_(hn::Set(kSigned, first)) {
    const std::size_t rowBytes = bytesPerRow<kChannels>(lightmap);
    const std::uint8_t* const upper =
        lightmap.levels.data() + batch.lightColumn + static_cast<std::size_t>(first) * rowBytes;
    LightPairs<kChannels> pairs;
    pairs.readAboveOther(0, upper);
    for (std::size_t k = 1; k < rows; ++k) pairs.readBelowOther(k, upper + k * rowBytes);
    const Floats across = hn::Set(kFloat, batch.acrossLightColumns);
    for (std::size_t i = 0; i < kRegisters; ++i)
      rows_[i] = pairs.mixedAcross(i * hn::Lanes(kFloat), across);
  }

  HWY_INLINE Channels mixture(std::size_t k) const {
    const Integers upper = hn::Sub(hn::Load(kSigned, &batch_.lightRows[k]), first_);
    const Integers lower = hn::Add(upper, hn::Set(kSigned, 1));
    return mixed(at(upper), at(lower), hn::Load(kFloat, &batch_.betweenLightTexels.down[k]));
  }

 private:
  HWY_INLINE Channels at(Integers rows) const {
    const Integers last = hn::Set(kSigned, static_cast<int>(hn::Lanes(kFloat)) - 1);
    const auto lane = hn::IndicesFromVec(kFloat, hn::And(rows, last));
    const auto isSecond = hn::RebindMask(kFloat, hn::Gt(rows, last));
    const auto picked = [&](auto channel) {
      const Floats first = hn::TableLookupLanes(rows_[0].*channel, lane);
      if constexpr (kRegisters == 1) return first;
      return hn::IfThenElse(isSecond, hn::TableLookupLanes(rows_[kRegisters - 1].*channel, lane),
                            first);
    };
    return {picked(&Channels::red), picked(&Channels::green), picked(&Channels::blue)};
  }

  const RowBatch& batch_;
  Integers first_;
  Channels rows_[kRegisters];
};

#endif

/// Gives each row the texels around it, as if they lay on a plane.
template <int kChannels>
void spreadLightColumn(RowBatch& batch, const Lightmap& lightmap) {
  for (std::size_t k = 0; k < batch.worked(); ++k)
    batch.lightTexels[k] = batch.lightColumn + static_cast<std::size_t>(batch.lightRows[k]) *
                                                   bytesPerRow<kChannels>(lightmap);
  batch.betweenLightTexels.across.fill(batch.acrossLightColumns);
}

template <int kChannels>
void findShownUprightIn(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
#if HWY_TARGET != HWY_SCALAR
  const auto ends = std::minmax(batch.lightRows[0], batch.lightRows[batch.count - 1]);
  const int first = ends.first;
  const auto rows = static_cast<std::size_t>(ends.second - first) + 2;
  const auto showColumn = [&]<int kRegisters>(std::integral_constant<int, kRegisters>) {
    storeShownIn(LightColumn<kChannels, kRegisters>(batch, lightmap, first, rows), sectorLight,
                 batch);
  };
  if (rows <= hn::Lanes(kFloat)) return showColumn(std::integral_constant<int, 1>());
  if (rows <= 2 * hn::Lanes(kFloat)) return showColumn(std::integral_constant<int, 2>());
#endif
  spreadLightColumn<kChannels>(batch, lightmap);
  findShownIn<kChannels>(batch, lightmap, sectorLight);
}

inline void findShownUpright(RowBatch& batch, const Lightmap& lightmap, double sectorLight) {
  batch.isUniformlyLit = false;
  if (lightmap.channels == 1) return findShownUprightIn<1>(batch, lightmap, sectorLight);
  findShownUprightIn<3>(batch, lightmap, sectorLight);
}

HWY_INLINE Channels allOf(Rgb color) {
  return {all<Floats>(static_cast<float>(color.r)), all<Floats>(static_cast<float>(color.g)),
          all<Floats>(static_cast<float>(color.b))};
}

/// The one texel of a lightmap.
HWY_INLINE Channels evenLight(const Lightmap& lightmap) {
  const auto channel = [&](int number) {
    return all<Floats>(static_cast<float>(lightmap.at(lightmap.rect.i0, lightmap.rect.j0, number)));
  };
  return {channel(0), channel(1), channel(2)};
}

inline void showEvenly(RowBatch& batch, const Lightmap* lightmap, double sectorLight) {
  batch.isUniformlyLit = true;
  storeShown(lightmap ? evenLight(*lightmap) : allOf(Rgb{}), sectorLight, batch, 0);
}

}  // namespace hearth::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
