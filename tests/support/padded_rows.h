#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "image/pixel_rows.h"

namespace hearth::test {

inline constexpr std::uint32_t kUntouched = 0xAABBCCDD;

/// The rows of a picture, each with some pixels behind it that do not belong to it.
struct PaddedRows {
  static constexpr int kPadding = 5;

  PaddedRows(int width, int height)
      : pixels(perRow(width) * static_cast<std::size_t>(height), kUntouched),
        rows{pixels.data(), perRow(width), width, height} {}
  PaddedRows(const PaddedRows&) = delete;
  PaddedRows& operator=(const PaddedRows&) = delete;

  static std::size_t perRow(int width) { return static_cast<std::size_t>(width + kPadding); }

  std::vector<std::uint32_t> pixels;
  PixelRows rows;
};

}  // namespace hearth::test
