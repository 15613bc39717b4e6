#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "image/image.h"
#include "light/lit_surface.h"
#include "render/span_mapping.h"

namespace hearth {

/// Some rows of a span, and of each the texel that it shows and its place in the lightmap: arrays,
/// so that several rows are worked out at once, and short, so that the first cache holds them.
struct RowBatch {
  static constexpr std::size_t kRows = 64;  ///< even
  using Indices = std::array<std::int32_t, kRows>;

  int firstRow;
  std::size_t count;
  alignas(16) std::array<double, kRows> measure;  ///< see SpanMapping

  Indices texelColumn;  ///< of the image
  Indices texelRow;

  /// Along one axis of the lightmap: the first of the two texels between whose centres the row
  /// lies, counted from the lightmap's edge, and how far it is towards the second, 0..1.
  struct LightPlaces {
    Indices texel;
    std::array<float, kRows> share;
  };
  LightPlaces lightColumn;
  LightPlaces lightRow;
};

/// The first of these to be called. `climbs` are those of the rows of the picture.
void findMeasures(RowBatch& batch, const SpanMapping& mapping, std::span<const double> climbs);
void findTexels(RowBatch& batch, const SpanMapping& mapping, const Image& image);
void findLightPlaces(RowBatch& batch, const SpanMapping& mapping, const TexelRect& rect);

/// Index of the texel that texel coordinate `x` falls into, of an image that repeats every `size`.
std::int32_t repeated(double x, std::int32_t size);

}  // namespace hearth
