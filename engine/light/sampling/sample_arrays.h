#pragma once

#include <cstddef>

namespace hearth {

/// Coordinates of samples in metres, each in an array of its own, as SIMD code reads them.
struct SampleArrays {
  /// The most that one register holds.
  static constexpr std::size_t kMaxLanes = 8;

  const double* x;
  const double* y;
  const double* z;

  SampleArrays from(std::size_t first) const { return {x + first, y + first, z + first}; }
};

}  // namespace hearth
