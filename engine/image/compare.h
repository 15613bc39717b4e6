#pragma once

#include <cstdint>

#include "image/image.h"

namespace hearth {

/// How two pictures of one size differ. The difference of two pixels is that of the channel that
/// differs most, in levels 0..255. Pooled scores (mean error, PSNR) are missing on purpose: they
/// rate one level of brightness everywhere worse than a hole.
struct PictureDifference {
  std::int64_t differing = 0;  ///< Pixels that differ at all.
  std::int64_t over2 = 0;      ///< Pixels that differ by more than 2 levels.
  std::int64_t over8 = 0;      ///< Pixels that differ by more than 8 levels.
  int largest = 0;             ///< The largest difference, in levels.
  /// The number of pixels in the largest connected patch of pixels that differ by more than
  /// `patchThreshold`. Pixels that share only a corner are not connected.
  std::int64_t largestPatch = 0;

  friend constexpr bool operator==(PictureDifference, PictureDifference) = default;
};

/// The pictures must have the same size. `patchThreshold` is in levels.
PictureDifference compare(const Image& expected, const Image& actual, int patchThreshold = 0);

/// The difference of every channel, made visible: no difference is 0, one level is 88, and each
/// further level adds 24, up to 255. The pictures must have the same size.
Image amplifiedDifference(const Image& expected, const Image& actual);

}  // namespace hearth
