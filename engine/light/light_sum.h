#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "math/planted_bug.h"

namespace hearth {

/// Adds up light without regard to order: every contribution is rounded once to 2^-20 of a level
/// and added as an integer. So threads cannot change a byte, and a light can be taken away again.
/// Sums past 2^41 levels, which no scene has, stay there rather than overflow.
class LightSum {
 public:
  /// `level` >= 0.
  void add(double level) {
    if (planted(PlantedBug::EightBitSums)) level = std::floor(level);
    constexpr double kMost = static_cast<double>(kFull / kUnit);
    const double units = std::floor(std::min(level, kMost) * static_cast<double>(kUnit) + 0.5);
    sum_ = std::min(sum_ + static_cast<std::int64_t>(units), kFull);
  }

  void add(LightSum other) { sum_ = std::min(sum_ + other.sum_, kFull); }
  bool isDark() const { return sum_ == 0; }

  /// The mean of so many samples, clamped to 0..255 and rounded half up, once.
  std::uint8_t mean(int samples) const {
    return static_cast<std::uint8_t>(rounded(std::int64_t{samples} * kUnit, 255));
  }
  /// The same in 256ths of a level.
  std::uint16_t fineMean(int samples) const {
    return static_cast<std::uint16_t>(rounded(std::int64_t{samples} * (kUnit / 256), 255 * 256));
  }

 private:
  std::int64_t rounded(std::int64_t one, std::int64_t most) const {
    return std::clamp((sum_ + one / 2) / one, std::int64_t{0}, most);
  }

  static constexpr std::int64_t kUnit = 1 << 20;
  static constexpr std::int64_t kFull = std::int64_t{1} << 61;

  std::int64_t sum_ = 0;
};

}  // namespace hearth
