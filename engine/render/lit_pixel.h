#pragma once

#include <emmintrin.h>

#include <cstdint>
#include <cstring>

#include "image/image.h"
#include "math/planted_bug.h"

namespace hearth {

// Pixels are made with SSE2, which every x86-64 processor has: red, green and blue side by side, as
// single-precision numbers.

/// Red, green and blue as numbers, and a fourth that means nothing.
using Channels = __m128;

inline Channels sameChannels(float value) { return _mm_set1_ps(value); }

/// Three bytes, without touching the one behind them.
inline std::int32_t threeBytes(const void* from) {
  const auto* bytes = static_cast<const std::uint8_t*>(from);
  std::uint16_t low;
  std::memcpy(&low, bytes, sizeof low);
  return low | bytes[2] << 16;
}

inline Channels channelsOf(std::int32_t bytes) {
  const __m128i zero = _mm_setzero_si128();
  const __m128i words = _mm_unpacklo_epi8(_mm_cvtsi32_si128(bytes), zero);
  return _mm_cvtepi32_ps(_mm_unpacklo_epi16(words, zero));
}

inline Channels channelsOf(Rgb color) { return channelsOf(threeBytes(&color)); }

/// A texel of a lightmap, in levels.
template <int kChannels>
Channels lightTexel(const std::uint8_t* texel);

/// Grey light: its level is that of all channels.
template <>
inline Channels lightTexel<1>(const std::uint8_t* texel) {
  return sameChannels(static_cast<float>(*texel));
}

template <>
inline Channels lightTexel<3>(const std::uint8_t* texel) {
  const Channels levels = channelsOf(threeBytes(texel));
  if (planted(PlantedBug::ChannelLost))
    return _mm_shuffle_ps(levels, levels, _MM_SHUFFLE(3, 1, 1, 0));
  return levels;
}

/// `share` of the way from `a` to `b`.
inline Channels mixed(Channels a, Channels b, Channels share) {
  return _mm_add_ps(a, _mm_mul_ps(share, _mm_sub_ps(b, a)));
}

/// The shares of a texture's red, green and blue that show: min(1, lightmap/255 + sector light).
inline Channels lightShares(Channels lightmapLevels, Channels sectorLight) {
  const Channels lightmap = _mm_mul_ps(lightmapLevels, sameChannels(1 / 255.0F));
  return _mm_min_ps(sameChannels(1), _mm_add_ps(lightmap, sectorLight));
}

/// More than single precision can lose of a level where light is a number that an author wrote.
inline constexpr float kLostOfLevel = 0x1p-15F;

/// Each channel rounded half up, once, and written. Halves are common, as authors write sector
/// light in decimals (15 * 0.3); none may be lost by a hair.
inline void putShaded(Rgb* pixel, Channels color, Channels shares) {
  const Channels half =
      sameChannels(planted(PlantedBug::RoundingTruncates) ? 0 : 0.5F + kLostOfLevel);
  const __m128i levels = _mm_cvttps_epi32(_mm_add_ps(_mm_mul_ps(color, shares), half));
  const __m128i words = _mm_packs_epi32(levels, levels);
  const std::int32_t bytes = _mm_cvtsi128_si32(_mm_packus_epi16(words, words));
  const auto redGreen = static_cast<std::uint16_t>(bytes);
  std::memcpy(static_cast<void*>(pixel), &redGreen, sizeof redGreen);
  pixel->b = static_cast<std::uint8_t>(bytes >> 16);
}

}  // namespace hearth
