#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hearth {

/// Adds up light in any order: every contribution is rounded once to 2^-20 of a level, and sums of
/// such units are exact. So threads cannot change a byte. Sums stop at 2^33 levels, which no scene
/// reaches: up to there a double holds every whole number of units.
class LightSum {
 public:
  static constexpr double kUnit = 1 << 20;  ///< in a level
  static constexpr double kFull = 0x1p53;   ///< units
  static constexpr double kMax = kFull / kUnit;

  explicit LightSum(double units = 0) : units_(units) {}

  /// `level` >= 0.
  void add(double level) { add(LightSum(std::floor(std::min(level, kMax) * kUnit + 0.5))); }

  void add(LightSum other) { units_ = std::min(units_ + other.units_, kFull); }
  double units() const { return units_; }

  /// The mean of so many samples, clamped to 0..255 and rounded half up, once.
  std::uint8_t mean(int samples) const {
    const double one = samples * kUnit;
    // The quotient of two integers is never so close below an integer that it rounds up to it.
    return static_cast<std::uint8_t>(std::min(std::floor((units_ + one / 2) / one), 255.0));
  }

 private:
  double units_;
};

}  // namespace hearth
