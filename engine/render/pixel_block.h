#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "render/lanes.h"
#include "render/strip.h"

namespace hearth {

/// Some rows of a group, and all that is found of their pixels on the way to their colours: arrays
/// of rows of eight pixels, small enough for the first cache.
struct PixelBlock {
  static constexpr int kRows = 32;
  static constexpr int kLanes = Strip::kColumns;
  /// So many rows are read below a picture, because registers are filled.
  static constexpr int kSpareRows = kLanes;

  template <typename T>
  struct alignas(64) Pixels : std::array<T, std::size_t{kRows} * kLanes> {};

  /// Bilinear weights: how far a pixel is from the left of four texels to the right ones, and from
  /// the upper to the lower ones. Minus that fraction, in 2^-15, as a number of 16 bits in both
  /// halves of a word. Minus, because +2^15 would not fit.
  struct Mix {
    Pixels<std::uint32_t> across;
    Pixels<std::uint32_t> down;
  };

  std::size_t count() const { return static_cast<std::size_t>(rows) * kLanes; }

  int firstRow;  ///< in the picture
  int rows;
  const double* raySlopes;  ///< of the view rays of the rows, see Projection::raySlopeAt
  /// The rows of each column that show the surface.
  struct Columns {
    LaneRowRanges rows;
    int fullBegin;  ///< all columns show it in rows [fullBegin, fullEnd)
    int fullEnd;
  } columns;

  Pixels<double> parameters;  ///< see SpanMapping; found where places are not linear
  /// The numbers of the texels around a pixel: upper left, upper right, lower left, lower right.
  /// The upper left one alone where nothing is mixed.
  std::array<Pixels<std::uint32_t>, 4> texels;
  std::array<Pixels<std::uint32_t>, 4> colors;  ///< of these texels, or white
  Mix betweenTexels;
  Pixels<std::uint32_t> lightTexels;  ///< the first byte of the upper left one of four
  Mix betweenLightTexels;
};

}  // namespace hearth
