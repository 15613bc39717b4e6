#pragma once

#include <cstdint>

namespace hearth {

/// What a bake did for one light.
struct LightCost {
  std::int64_t samples = 0;      ///< of surfaces that it can shine on
  std::int64_t seenSamples = 0;  ///< that see any of it, within its reach
  std::int64_t rays = 0;

  LightCost& operator+=(const LightCost& other) {
    samples += other.samples;
    seenSamples += other.seenSamples;
    rays += other.rays;
    return *this;
  }

  friend bool operator==(const LightCost&, const LightCost&) = default;
};

}  // namespace hearth
