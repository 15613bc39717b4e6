#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "settings/options.h"

namespace hearth {

/// Something that Hearth can do more accurately and slower, or less so. Each has a setting, which
/// is an option of the commands, with a range and a default.
struct Approximation {
  enum class Of { Bake, Frame, Movers };  ///< of movers: the bakes that their ways take

  Option setting;
  Of of;                   ///< what the setting makes slower or faster
  std::string_view tried;  ///< values that are measured, separated by `|`
  std::string_view bound;  ///< on the error
  std::string_view code;   ///< where it is made
};

/// All approximations.
std::span<const Approximation> approximations();

/// The values of one that are measured.
std::vector<std::string_view> triedOf(const Approximation& approximation);

}  // namespace hearth
