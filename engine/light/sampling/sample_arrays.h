#pragma once

#include <cstddef>

namespace hearth {

/// Coordinates of samples in metres, each in an array of its own, as SIMD code reads them.
struct SampleArrays {
  const double* x;
  const double* y;
  const double* z;

  SampleArrays from(std::size_t first) const { return {x + first, y + first, z + first}; }
};

}  // namespace hearth
