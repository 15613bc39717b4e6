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

  /// Along one axis of an image or lightmap.
  struct Places {
    Indices texel;  ///< counted from the edge
    /// Of mixtures: how far the row is from that texel's centre to the next one's, 0..1.
    std::array<float, kRows> share;
  };
  Places texelColumn;
  Places texelRow;
  Places lightColumn;
  Places lightRow;
};

/// The first of these to be called. `climbs` are those of the rows of the picture; between every so
/// many of them the depth of planes is interpolated.
void findMeasures(RowBatch& batch, const SpanMapping& mapping, std::span<const double> climbs,
                  int depthEvery);
/// The texels of the image that the rows fall into.
void findTexels(RowBatch& batch, const SpanMapping& mapping, const Image& image);
/// The first two of the four texels around the rows.
void findMixtures(RowBatch& batch, const SpanMapping& mapping, const Image& image);
/// Those of the lightmap.
void findLightPlaces(RowBatch& batch, const SpanMapping& mapping, const TexelRect& rect);

/// Index of the texel that texel coordinate `x` falls into, of an image that repeats every `size`.
std::int32_t repeated(double x, std::int32_t size);

}  // namespace hearth
