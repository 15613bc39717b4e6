#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hearth {

/// Some rows of a span, and all that is found of them on the way to their pixels: arrays, so that
/// as many rows as a register holds are worked out at once, and short, so that the first cache
/// holds them. Rows are worked out by whole registers and read by whole eights: what is found of
/// those behind the last one means nothing, but they are like the others.
struct RowBatch {
  static constexpr std::size_t kRows = 128;     ///< a multiple of kMaxLanes
  static constexpr std::size_t kMaxLanes = 16;  ///< of single precision, in any register
  static constexpr std::size_t kEight = 8;

  template <typename T>
  struct alignas(64) Rows : std::array<T, kRows> {};

  /// Texels of an image, by their numbers.
  using Texels = Rows<std::int32_t>;
  /// The four around each row.
  struct Around {
    Texels upperLeft;
    Texels upperRight;
    Texels lowerLeft;
    Texels lowerRight;
  };
  /// How far a row is from the centre of one texel to that of the next, 0..1.
  struct Between {
    Rows<float> across;
    Rows<float> down;
  };

  /// The rows, and those behind the last of them, up to a whole eight.
  std::size_t worked() const { return (count + kEight - 1) / kEight * kEight; }

  /// Calls `read(k)` for these, eight after eight, as compilers unroll it.
  template <typename Read>
  void forEachWorked(Read&& read) const {
    for (std::size_t first = 0; first < count; first += kEight)
      for (std::size_t k = first; k < first + kEight; ++k) read(k);
  }

  std::size_t count;
  /// See SpanMapping. They rise or fall all along; kMaxLanes more than there are rows can be read.
  const double* parameters;
  Rows<double> depths;  ///< of planes: what `parameters` points at
  Around texels;        ///< the upper left ones are all where nothing is mixed
  Between betweenTexels;
  Rows<std::uint64_t> lightTexels;  ///< of planes: the first byte of the upper left one of four
  /// Of what is upright: between which two columns of its lightmap all rows lie, and each of them
  /// between which two of its rows.
  std::size_t lightColumn;       ///< the first byte of the left one's first texel
  float acrossLightColumns;      ///< how far from its middle to that of the right one
  Rows<std::int32_t> lightRows;  ///< the upper ones
  Between betweenLightTexels;    ///< of what is upright only those down
  /// The fractions of a texture's red, green and blue that show, 0..1.
  std::array<Rows<float>, 3> shown;
  bool isUniformlyLit;  ///< what is shown in the first kMaxLanes rows is shown in all
};

}  // namespace hearth
