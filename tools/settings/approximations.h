#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "settings/options.h"

namespace hearth {

/// Something in which Hearth can be more accurate, and slower, or less. There is a setting for
/// each, which is an option of the commands, with a range and a default.
struct Approximation {
  enum class Of { Bake, Frame };

  Option setting;
  Of of;                   ///< what the setting makes slower or faster
  std::string_view tried;  ///< values that are measured, separated by `|`
  std::string_view bound;  ///< on the error
  std::string_view code;   ///< where it is made
};

/// All that there are.
std::span<const Approximation> approximations();

/// The values that are measured of one.
std::vector<std::string_view> triedOf(const Approximation& approximation);

}  // namespace hearth
